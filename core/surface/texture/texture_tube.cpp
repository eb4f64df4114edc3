#include "core/surface/texture/texture_tube.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace ramure {

namespace {

/// How far radii may differ (as a logarithm) before another number of tiles goes around.
constexpr double tolerated = 0.45, toleratedOnShort = 0.9;
/// How much of that v makes good: in between, neither the stretch nor the density is far off.
constexpr double followed = 0.5;
// In radii: where the middle of a tip is, and of the flat end of a root.
constexpr double leastTip = 0.1, tipRadius = 0.5, rootRadius = 0.05;
constexpr double cutRadius = 0.94; ///< in radii: within it lies the ring of a cut
constexpr double narrowGap =
    2.4; ///< rad: what limbs leave of their parent's last cross-section goes on all around
constexpr double manyTiles = 24.0;
constexpr double lost = 0.2; ///< of the triangles are stretched: that shall not go on into the children

} // namespace

void TubeTexture::begin()
{
    m_vertices.clear();
    m_positions.clear();
    m_given.clear();
    m_triangles.clear();
    m_isOpen = false;
    m_stretched = 0;
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
    if (!even(parent))
        unfold(parent);
    if (m_stretched > shareOf(lost))
        keepEnd(parent);
    m_end.normal = m_axis.end().frame.normal;
    m_end.around = m_knots.back().around;
}

void TubeTexture::place()
{
    m_highestWall = 0.0;
    const double length = m_axis.length();
    bool isCut = false;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        const UnrollAxis::Place place = m_axis.place(glm::dvec3(m_positions[i]));
        const bool own = !vertex.onParent && !vertex.onWall;
        vertex.along = vertex.onParent ? 0.0 : place.along;
        vertex.azimuth = place.azimuth;
        const bool onTip = place.along >= length && place.beyond > leastTip && place.radial < tipRadius;
        vertex.isPole = own && (onTip || (place.along <= 0.0 && place.radial < rootRadius));
        isCut = isCut || (own && place.along > (1.0 - sameSection) * length && place.radial < rootRadius &&
                          !vertex.isPole);
        if (vertex.onWall)
            m_highestWall = std::max(m_highestWall, place.along);
    }
    if (isCut)
        markCut();
    const auto points = std::ranges::count_if(m_vertices, [&](const TubeTextureVertex& vertex) {
        return !vertex.onParent && !vertex.onWall && !vertex.isPole &&
               vertex.along > (1.0 - sameSection) * length;
    });
    const double half = pi / static_cast<double>(std::max<std::ptrdiff_t>(points, 3));
    m_chord = maths::sin(half) / half;
}

/// What lies within the edge of a flat end.
void TubeTexture::markCut()
{
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        if (!vertex.onParent && !vertex.onWall && vertex.along > (1.0 - sameSection) * m_axis.length() &&
            m_axis.place(glm::dvec3(m_positions[i])).radial < cutRadius)
            vertex.isPole = true;
    }
}

/// The seam starts in the middle of the widest gap of the front: in a valley.
void TubeTexture::chooseSeam()
{
    m_sorted.clear();
    for (const TubeTextureVertex& vertex : m_vertices)
        if (vertex.onParent)
            m_sorted.push_back(shortWay(vertex.azimuth));
    double seam = pi;
    m_goesOn = false;
    if (!m_sorted.empty()) {
        std::sort(m_sorted.begin(), m_sorted.end());
        double widest = m_sorted.front() + turn - m_sorted.back();
        seam = m_sorted.back() + 0.5 * widest;
        for (std::size_t i = 0; i + 1 < m_sorted.size(); ++i)
            if (const double gap = m_sorted[i + 1] - m_sorted[i]; gap > widest + 1e-6) {
                widest = gap;
                seam = m_sorted[i] + 0.5 * gap;
            }
        m_goesOn = widest < narrowGap;
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
    if (before > 0.0 && (m_highestWall == 0.0 || m_goesOn)) {
        const double fits = fitting(radiusAt(m_sections.back()));
        // Another number winds around the tube by half the difference: a short tube leaves that to the next.
        const bool isShort = m_axis.length() < 0.5 * std::abs(before - fits) * m_tile;
        const bool goesOn = std::abs(maths::log(before / fits)) < (isShort ? toleratedOnShort : tolerated);
        m_knots.push_back({m_sections.back(), goesOn ? before : fits});
        return;
    }
    std::size_t i = 0;
    while (i < m_sections.size()) {
        // A root's first cross-section, at its foot, has the number of the next.
        const double first = radiusAt(m_knots.empty() ? 0.5 * m_sections[i] : m_sections[i]);
        double last = first;
        std::size_t end = i + 1;
        for (; end < m_sections.size(); ++end) {
            const double radius = radiusAt(m_sections[end]);
            if (std::abs(maths::log(radius / first)) > tolerated)
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

/// v goes on a little faster where more tiles than fit stand around, and slower where fewer do; where not
/// even one fits, as fast as that one is squeezed.
void TubeTexture::measureAlong()
{
    const auto& nodes = m_axis.nodes();
    m_tilesAt[0] = 0.0;
    for (std::size_t i = 0; i < UnrollAxis::steps; ++i) {
        const double middle = 0.5 * (nodes[i].along + nodes[i + 1].along);
        const double radius = 0.5 * (nodes[i].radius + nodes[i + 1].radius) * m_chord;
        const double one = m_tile / (turn * radius), squeezed = std::max(1.0, one);
        const double excess = std::clamp(aroundAt(middle) * one / squeezed, 0.25, 4.0);
        static_assert(followed == 0.5);
        m_tilesAt[i + 1] =
            m_tilesAt[i] + (nodes[i + 1].along - nodes[i].along) / m_tile * squeezed * std::sqrt(excess);
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

/// Where the tube starts in the texture: where its parent really ends, which may have been moved.
glm::dvec2 TubeTexture::startOf(const TubeTextureEnd& parent) const
{
    glm::dvec2 nearest(0.0), sum(0.0);
    double azimuth = turn;
    const auto startAt = [&](std::size_t i) {
        return glm::dvec2(double(m_given[i].x) - parent.around * m_vertices[i].azimuth / turn, m_given[i].y);
    };
    for (std::size_t i = 0; i < m_given.size(); ++i)
        if (m_vertices[i].onParent && std::abs(m_vertices[i].azimuth) < azimuth) {
            azimuth = std::abs(m_vertices[i].azimuth);
            nearest = startAt(i);
        }
    double count = 0.0;
    for (std::size_t i = 0; i < m_given.size(); ++i)
        if (m_vertices[i].onParent) {
            const glm::dvec2 away = startAt(i) - nearest;
            sum += glm::dvec2(away.x - std::round(away.x), away.y);
            count += 1.0;
        }
    return nearest + sum / std::max(count, 1.0);
}

void TubeTexture::assign(const TubeTextureEnd& parent)
{
    const glm::dvec2 start = startOf(parent);
    double lastAlong = -1.0, around = 0.0, v = 0.0;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        if (vertex.along != lastAlong) {
            lastAlong = vertex.along;
            around = aroundAt(vertex.along);
            v = start.y + tilesAlong(vertex.along);
        }
        vertex.around = around;
        vertex.u = start.x + around * vertex.azimuth / turn;
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

} // namespace ramure
