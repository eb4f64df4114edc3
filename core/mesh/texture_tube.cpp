#include "core/mesh/texture_tube.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace ramure {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2.0 * pi;
/// How far radii may differ (as a logarithm) before another number of tiles goes around.
constexpr double tolerated = 0.45;
/// How much of that v makes good: in between, neither the stretch nor the density is far off.
constexpr double followed = 0.5;
// In radii: where the middle of a tip is, and of the flat end of a root.
constexpr double leastTip = 0.1, tipRadius = 0.5, rootRadius = 0.05;
constexpr double sameSection = 1e-3; ///< of the tube: cross-sections closer than that are one
constexpr double leastTurn = 0.02;   ///< rad, between neighbours on a smoothed front
constexpr double manyTiles = 24.0;
constexpr double mostGrowth = 0.35; ///< of its area, or shrinking, when a tube is cut
constexpr int thoroughSweeps = 60, choosySweeps = 8;
constexpr ConformalRelaxer::Effort wholeEffort{1, 2, 2, 2}, cutEffort{2, 5, 2, 2};
constexpr double hopelessShare = 0.18; ///< of triangles stretched after few rounds: it will be cut
constexpr double mostBad = 0.08;       ///< of a tube's triangles may be stretched by 1.25 before it is cut

double shortWay(double angle)
{
    return angle - turn * std::round(angle / turn);
}

} // namespace

void TubeTexture::begin()
{
    m_vertices.clear();
    m_positions.clear();
    m_given.clear();
    m_triangles.clear();
    m_copies.clear();
}

Index TubeTexture::addVertex(Index vertex, const glm::vec3& position, bool onParent, bool onWall,
                             const glm::vec2& uv)
{
    TubeTextureVertex added;
    added.vertex = vertex;
    added.onParent = onParent;
    added.onWall = onWall;
    m_vertices.push_back(added);
    m_positions.push_back(position);
    m_given.push_back(uv);
    return static_cast<Index>(m_vertices.size() - 1);
}

void TubeTexture::unroll(const TubeAxis& axis, const TubeTextureEnd& parent)
{
    m_axis.build(axis, parent.normal);
    place();
    chooseSeam();
    chooseTiles(parent.around);
    measureAlong();
    assign(parent);
    if (!even())
        unfold(parent);
    m_end.normal = m_axis.end().frame.normal;
    m_end.around = m_knots.back().around;
    m_end.along = parent.along + m_tilesAt.back();
}

void TubeTexture::place()
{
    m_highestWall = 0.0;
    int points = 0;
    const double length = m_axis.length();
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        const UnrollAxis::Place place = m_axis.place(glm::dvec3(m_positions[i]));
        const bool own = !vertex.onParent && !vertex.onWall;
        vertex.along = vertex.onParent ? 0.0 : place.along;
        vertex.azimuth = place.azimuth;
        const bool onTip = place.along >= length && place.beyond > leastTip && place.radial < tipRadius;
        vertex.isPole = own && (onTip || (place.along <= 0.0 && place.radial < rootRadius));
        if (own && !vertex.isPole && place.along > (1.0 - sameSection) * length)
            ++points;
        if (vertex.onWall)
            m_highestWall = std::max(m_highestWall, place.along);
    }
    const double half = pi / std::max(points, 3);
    m_chord = std::sin(half) / half;
}

/// The seam starts in the middle of the widest gap of the front: in a valley.
void TubeTexture::chooseSeam()
{
    m_sorted.clear();
    for (const TubeTextureVertex& vertex : m_vertices)
        if (vertex.onParent)
            m_sorted.push_back(shortWay(vertex.azimuth));
    double seam = pi;
    if (!m_sorted.empty()) {
        std::sort(m_sorted.begin(), m_sorted.end());
        double widest = m_sorted.front() + turn - m_sorted.back();
        seam = m_sorted.back() + 0.5 * widest;
        for (std::size_t i = 0; i + 1 < m_sorted.size(); ++i)
            if (const double gap = m_sorted[i + 1] - m_sorted[i]; gap > widest + 1e-6) {
                widest = gap;
                seam = m_sorted[i] + 0.5 * gap;
            }
    }
    for (TubeTextureVertex& vertex : m_vertices) {
        const double behind = vertex.azimuth - seam;
        vertex.azimuth = behind - turn * std::floor(behind / turn) - pi;
    }
}

/// Above two dozen a number that can be halved until it is below: a pattern of two, four ... tiles fits as
/// well.
double TubeTexture::fitting(double radius) const
{
    const double wanted = turn * m_chord * radius / m_tile;
    double step = 1.0;
    while (wanted > manyTiles * step)
        step *= 2.0;
    return std::max(1.0, std::round(wanted / step) * step);
}

double TubeTexture::radiusAt(double along) const
{
    const auto& nodes = m_axis.nodes();
    std::size_t i = 0;
    while (i + 2 < nodes.size() && nodes[i + 1].along < along)
        ++i;
    const double span = nodes[i + 1].along - nodes[i].along;
    const double part = span > 0.0 ? std::clamp((along - nodes[i].along) / span, 0.0, 1.0) : 0.0;
    return nodes[i].radius + (nodes[i + 1].radius - nodes[i].radius) * part;
}

/// Heights of the whole cross-sections of the tube, above its front.
void TubeTexture::findSections()
{
    m_sections.clear();
    for (const TubeTextureVertex& vertex : m_vertices)
        if (!vertex.onParent && !vertex.onWall && !vertex.isPole && vertex.along > m_highestWall)
            m_sections.push_back(vertex.along);
    std::sort(m_sections.begin(), m_sections.end());
    const double apart = sameSection * m_axis.length();
    const auto same = [apart](double a, double b) { return b - a < apart; };
    m_sections.erase(std::unique(m_sections.begin(), m_sections.end(), same), m_sections.end());
    if (m_sections.empty())
        m_sections.push_back(m_axis.length());
}

/// The parent's number on the front; from the first whole cross-section on one that fits as long as the
/// radius does not change much.
void TubeTexture::chooseTiles(double before)
{
    findSections();
    m_knots.clear();
    if (before > 0.0)
        m_knots.push_back({0.0, before});
    std::size_t i = 0;
    if (before > 0.0 && m_highestWall == 0.0) { // the parent's whole last cross-section is the front
        const double off = before / fitting(radiusAt(m_sections.back()));
        if (off < std::exp(tolerated) && off > std::exp(-tolerated)) {
            for (const double along : m_sections)
                m_knots.push_back({along, before});
            i = m_sections.size();
        }
    }
    while (i < m_sections.size()) {
        // A root's first cross-section, at its foot, has the number of the next.
        const double first = radiusAt(m_knots.empty() ? 0.5 * m_sections[i] : m_sections[i]);
        double last = first;
        std::size_t end = i + 1;
        for (; end < m_sections.size(); ++end) {
            const double radius = radiusAt(m_sections[end]);
            if (std::abs(std::log(radius / first)) > tolerated)
                break;
            last = radius;
        }
        const double around = fitting(0.5 * (first + last));
        for (; i < end; ++i)
            m_knots.push_back({m_sections[i], around});
    }
}

double TubeTexture::aroundAt(double along) const
{
    if (along <= m_knots.front().along)
        return m_knots.front().around;
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Knot &a = m_knots[i], &b = m_knots[i + 1];
        if (along <= b.along)
            return a.around == b.around
                       ? a.around
                       : a.around + (b.around - a.around) * (along - a.along) / (b.along - a.along);
    }
    return m_knots.back().around;
}

/// v goes on a little faster where more tiles than fit stand around, and slower where fewer do.
void TubeTexture::measureAlong()
{
    const auto& nodes = m_axis.nodes();
    m_tilesAt[0] = 0.0;
    for (std::size_t i = 0; i < UnrollAxis::steps; ++i) {
        const double middle = 0.5 * (nodes[i].along + nodes[i + 1].along);
        const double radius = 0.5 * (nodes[i].radius + nodes[i + 1].radius) * m_chord;
        const double excess = std::clamp(aroundAt(middle) * m_tile / (turn * radius), 0.25, 4.0);
        static_assert(followed == 0.5);
        m_tilesAt[i + 1] = m_tilesAt[i] + (nodes[i + 1].along - nodes[i].along) / m_tile * std::sqrt(excess);
    }
}

double TubeTexture::tilesAlong(double along) const
{
    const auto& nodes = m_axis.nodes();
    std::size_t i = 0;
    while (i + 2 < nodes.size() && nodes[i + 1].along < along)
        ++i;
    const double span = nodes[i + 1].along - nodes[i].along;
    const double part = span > 0.0 ? (along - nodes[i].along) / span : 0.0;
    return m_tilesAt[i] + (m_tilesAt[i + 1] - m_tilesAt[i]) * part;
}

void TubeTexture::assign(const TubeTextureEnd& parent)
{
    double u = 0.0, nearest = turn;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        const TubeTextureVertex& vertex = m_vertices[i];
        if (!vertex.onParent || std::abs(vertex.azimuth) >= nearest)
            continue;
        nearest = std::abs(vertex.azimuth);
        u = double(m_given[i].x) - parent.around * vertex.azimuth / turn;
    }
    double lastAlong = -1.0, around = 0.0, v = 0.0;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        if (vertex.along != lastAlong) {
            lastAlong = vertex.along;
            around = aroundAt(vertex.along);
            v = parent.along + tilesAlong(vertex.along);
        }
        vertex.around = around;
        vertex.u = u + around * vertex.azimuth / turn;
        vertex.v = v;
        if (vertex.onParent) {
            vertex.u = double(m_given[i].x) + std::round(vertex.u - double(m_given[i].x));
            vertex.v = double(m_given[i].y);
        }
    }
}

std::array<glm::dvec2, 3> TubeTexture::apart(const glm::uvec3& triangle) const
{
    const glm::dvec3 origin = position(triangle.x), first = (position(triangle.y) - origin) / m_tile,
                     second = (position(triangle.z) - origin) / m_tile;
    const double length = glm::length(first);
    // Near the origin, where floats are fine; where in the pattern does not matter.
    const glm::dvec2 whole(m_vertices[triangle.x].u, m_vertices[triangle.x].v),
        at = whole - glm::floor(whole);
    if (!(length > 0.0))
        return {at, at, at};
    return {at, at + glm::dvec2(length, 0.0),
            at + glm::dvec2(glm::dot(first, second), glm::length(glm::cross(first, second))) / length};
}

glm::dvec2 TubeTexture::onDisc(const TubeTextureVertex& vertex, const glm::vec3& position) const
{
    const bool start = vertex.along < 0.5 * m_axis.length();
    const UnrollAxis::Node& node = start ? m_axis.nodes().front() : m_axis.end();
    const glm::dvec3 away = (glm::dvec3(position) - node.point) / m_tile;
    const double x = glm::dot(away, node.frame.normal), y = glm::dot(away, node.frame.binormal);
    // The flat end of a root is seen against the axis. Half a tile aside: no line of the pattern at the pole.
    return {0.5 + (start ? -x : x), 0.5 + y};
}

template <class Relaxer> void TubeTexture::fill(Relaxer& relaxer) const
{
    relaxer.clear();
    for (const TubeTextureVertex& vertex : m_vertices)
        relaxer.addVertex({vertex.u, vertex.v}, !vertex.onParent && !vertex.isPole);
    for (const glm::uvec3& triangle : m_triangles) {
        if (isCap(triangle))
            continue;
        const std::array<bool, 3> beyond = beyondSeam(triangle);
        std::array<double, 3> shift{};
        std::array<glm::dvec3, 3> places;
        for (int c = 0; c < 3; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            shift[corner] = beyond[corner] ? m_vertices[triangle[c]].around : 0.0;
            places[corner] = position(triangle[c]) / m_tile;
        }
        relaxer.addTriangle({triangle.x, triangle.y, triangle.z}, places, shift);
    }
}

template <class Relaxer> void TubeTexture::read(const Relaxer& relaxer)
{
    for (Index i = 0; i < m_vertices.size(); ++i) {
        const glm::dvec2 uv = relaxer.uv(i);
        m_vertices[i].u = uv.x;
        m_vertices[i].v = uv.y;
    }
}

/// Area in the texture of what is not mapped as a disc.
double TubeTexture::textureArea() const
{
    double doubled = 0.0;
    for (const glm::uvec3& triangle : m_triangles) {
        if (isCap(triangle))
            continue;
        const std::array<bool, 3> beyond = beyondSeam(triangle);
        std::array<glm::dvec2, 3> uv;
        for (int c = 0; c < 3; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            const TubeTextureVertex& vertex = m_vertices[triangle[c]];
            uv[corner] = {vertex.u + (beyond[corner] ? vertex.around : 0.0), vertex.v};
        }
        const glm::dvec2 ab = uv[1] - uv[0], ac = uv[2] - uv[0];
        doubled += ab.x * ac.y - ab.y * ac.x;
    }
    return 0.5 * doubled;
}

bool TubeTexture::isStretched(double share) const
{
    return double(m_conformal.badTriangles()) > share * double(m_triangles.size());
}

/// Has it a whole cross-section but its end, which its children share?
bool TubeTexture::canBeCut() const
{
    const double apart = sameSection * m_axis.length(), height = m_sections.front();
    return height >= apart && height <= m_axis.length() - apart;
}

/// Moves vertices to where fewest triangles are stretched.
/// \param hopeless share of stretched triangles at which it gives up after the first rounds.
void TubeTexture::settle(const ConformalRelaxer::Effort& effort, double hopeless)
{
    fill(m_conformal);
    m_conformal.run(effort);
    if (!isStretched(hopeless))
        m_conformal.run({0, 0, effort.choosyRounds, effort.choosySweeps});
    if (isStretched(mostBad) && !isStretched(hopeless))
        m_conformal.run({0, 0, 3 * effort.choosyRounds, effort.choosySweeps});
    if (m_conformal.isFolded()) {
        fill(m_conformal);
        m_conformal.run({effort.evenRounds + effort.choosyRounds, effort.evenSweeps, 0, 0});
    }
    read(m_conformal);
}

/// Cuts the tube where too much of it is stretched, if that helps. \returns whether nothing is folded.
bool TubeTexture::even()
{
    settle(wholeEffort, canBeCut() ? hopelessShare : 1.0);
    const Index bad = m_conformal.badTriangles();
    const bool folded = m_conformal.isFolded();
    if (!isStretched(mostBad))
        return !folded;
    const double area = textureArea();
    m_wholeVertices = m_vertices;
    m_wholeTriangles = m_triangles;
    if (cut()) {
        settle(cutEffort, 1.0);
        const bool keepsSize = std::abs(textureArea() - area) < mostGrowth * area;
        if (keepsSize && m_conformal.badTriangles() < bad && !m_conformal.isFolded()) {
            moveTogether();
            return true;
        }
    }
    m_positions.resize(m_wholeVertices.size());
    m_vertices.swap(m_wholeVertices);
    m_triangles.swap(m_wholeTriangles);
    m_copies.clear();
    return !folded;
}

/// For a tube with triangles that lie the wrong way round: the axis may pass beside the front, or the tube
/// itself is folded.
void TubeTexture::unfold(const TubeTextureEnd& parent)
{
    smoothFront();
    chooseSeam();
    assign(parent);
    if (even())
        return;
    assign(parent);
    fill(m_relaxer);
    m_relaxer.run(thoroughSweeps, choosySweeps);
    read(m_relaxer);
}

/// A triangle's corner becomes a copy of its vertex, the same one for all triangles.
void TubeTexture::copyCorner(Index& corner, std::vector<Index>& copies)
{
    Index& copy = copies[corner];
    if (copy == noIndex) {
        copy = static_cast<Index>(m_vertices.size());
        m_vertices.push_back(TubeTextureVertex(m_vertices[corner]));
        m_positions.push_back(glm::vec3(m_positions[corner]));
    }
    corner = copy;
}

/// Cuts the tube around its first whole cross-section, and opens the seam below: there the tube leaves the
/// direction of its parent, and what is below and what is above can be laid flat, together they cannot.
/// False where there is no such cross-section but the tube's end, which its children share.
bool TubeTexture::cut()
{
    if (!canBeCut())
        return false;
    const double apart = sameSection * m_axis.length(), height = m_sections.front();
    const std::size_t before = m_vertices.size();
    std::vector<Index>&above = m_front, &beyond = m_next;
    above.assign(before, noIndex);
    beyond.assign(before, noIndex);
    const bool opens = std::any_of(m_vertices.begin(), m_vertices.end(),
                                   [](const TubeTextureVertex& vertex) { return vertex.onParent; });
    for (glm::uvec3& triangle : m_triangles) {
        double highest = 0.0;
        for (int c = 0; c < 3; ++c)
            highest = std::max(highest, m_vertices[triangle[c]].along);
        const std::array<bool, 3> isBeyond = beyondSeam(triangle);
        for (int c = 0; c < 3; ++c) {
            const TubeTextureVertex& vertex = m_vertices[triangle[c]];
            if (highest > height + apart) {
                if (!vertex.onParent && !vertex.onWall && std::abs(vertex.along - height) <= apart)
                    copyCorner(triangle[c], above);
            } else if (opens && isBeyond[static_cast<std::size_t>(c)]) {
                copyCorner(triangle[c], beyond);
            }
        }
    }
    for (std::size_t i = 0; i < before; ++i) {
        if (above[i] != noIndex)
            m_copies.push_back({static_cast<Index>(i), above[i]});
        if (beyond[i] != noIndex) {
            TubeTextureVertex& vertex = m_vertices[beyond[i]];
            vertex.azimuth += turn;
            vertex.u += vertex.around;
        }
    }
    return !m_copies.empty();
}

/// Moves what is above the cut, as a whole, to where the copies are beside their originals on the average.
void TubeTexture::moveTogether()
{
    glm::dvec2 away(0.0);
    for (const auto& [below, above] : m_copies)
        away +=
            glm::dvec2(m_vertices[below].u - m_vertices[above].u, m_vertices[below].v - m_vertices[above].v);
    away = away / double(m_copies.size());
    const auto move = [away](TubeTextureVertex& vertex) {
        vertex.u += away.x;
        vertex.v += away.y;
    };
    for (const auto& [below, above] : m_copies)
        move(m_vertices[above]);
    const double height = m_sections.front() + sameSection * m_axis.length();
    for (TubeTextureVertex& vertex : m_vertices)
        if (vertex.along > height)
            move(vertex);
}

/// Azimuths along the front made to increase by one turn in all; those on the parent stay.
void TubeTexture::smoothFront()
{
    // The front's edges have no triangle on their other side.
    m_next.assign(m_vertices.size(), noIndex);
    const auto isFront = [this](Index i) { return m_vertices[i].onParent || m_vertices[i].onWall; };
    const auto hasEdge = [this](Index a, Index b) {
        return std::any_of(m_triangles.begin(), m_triangles.end(), [a, b](const glm::uvec3& t) {
            return (t.x == a && t.y == b) || (t.y == a && t.z == b) || (t.z == a && t.x == b);
        });
    };
    Index start = noIndex;
    for (const glm::uvec3& t : m_triangles)
        for (int c = 0; c < 3; ++c) {
            const Index a = t[c], b = t[(c + 1) % 3];
            if (!isFront(a) || !isFront(b) || hasEdge(b, a))
                continue;
            m_next[a] = b;
            if (start == noIndex || (m_vertices[a].onParent && !m_vertices[start].onParent))
                start = a;
        }
    if (start == noIndex)
        return;
    m_front.clear();
    for (Index at = start; at != noIndex && m_front.size() <= m_vertices.size(); at = m_next[at]) {
        m_front.push_back(at);
        if (m_next[at] == start)
            break;
    }
    if (m_front.size() < 3 || m_next[m_front.back()] != start)
        return;
    m_front.push_back(start);
    const bool anchored = m_vertices[start].onParent;
    for (std::size_t i = 0; i + 1 < m_front.size();) {
        std::size_t end = i + 1;
        while (end + 1 < m_front.size() && !(anchored && m_vertices[m_front[end]].onParent))
            ++end;
        const double from = m_vertices[m_front[i]].azimuth;
        double total = turn;
        if (end + 1 < m_front.size() || i > 0) {
            total = m_vertices[m_front[end]].azimuth - from;
            total -= turn * std::floor(total / turn);
        }
        double sum = 0.0;
        const double least = std::min(leastTurn, 0.5 * total / double(end - i));
        m_sorted.clear();
        for (std::size_t k = i; k < end; ++k) {
            const double step = std::max(
                least, shortWay(m_vertices[m_front[k + 1]].azimuth - m_vertices[m_front[k]].azimuth));
            m_sorted.push_back(step);
            sum += step;
        }
        double at = from;
        for (std::size_t k = i; k + 1 < end; ++k)
            m_vertices[m_front[k + 1]].azimuth = at += m_sorted[k - i] * total / sum;
        i = end;
    }
}

} // namespace ramure
