#include "core/mesh/texture_tube.h"

#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr double leastTurn = 0.02;  ///< rad, between neighbours on a smoothed front
constexpr double mostGrowth = 0.35; ///< of its area, or shrinking, when a tube is cut
constexpr int thoroughSweeps = 60, choosySweeps = 8;
constexpr ConformalRelaxer::Effort wholeEffort{1, 2, 2, 2}, cutEffort{2, 5, 2, 2};
// Shares of a tube's triangles that are stretched:
constexpr double hopelessShare = 0.12; ///< after few rounds: it will be cut, or cut further
constexpr double bentShare = 0.14;     ///< a seam that goes half way around will not do
constexpr double mostBad = 0.08;       ///< more than that, and it is cut
constexpr std::size_t leastWelded = 2; ///< vertices of a cross-section where a seam goes around it

} // namespace

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

void TubeTexture::keep(Layout& layout) const
{
    layout.vertices = m_vertices;
    layout.positions = m_positions;
    layout.triangles = m_triangles;
    layout.isCut = m_isCut;
}

void TubeTexture::take(const Layout& layout)
{
    m_vertices = layout.vertices;
    m_positions = layout.positions;
    m_triangles = layout.triangles;
    m_isCut = layout.isCut;
}

/// Lets the seam go around where too much of the tube is stretched, if that helps: half way, or nearly all
/// the way where that is not enough. \returns whether nothing is folded.
bool TubeTexture::even()
{
    const bool mayCut = m_options.seamsAround && canBeCut();
    settle(wholeEffort, mayCut ? hopelessShare : 1.0);
    bool folded = m_conformal.isFolded();
    Index bad = m_conformal.badTriangles();
    if (!mayCut || !isStretched(mostBad))
        return !folded;
    const double area = textureArea();
    keep(m_whole);
    keep(m_best);
    for (const double welded : {0.5, 0.0}) {
        const bool isLast = welded == 0.0;
        if (!isLast && double(bad) > bentShare * double(m_whole.triangles.size()))
            continue;
        take(m_whole);
        if (!cut(welded))
            break;
        settle(cutEffort, isLast ? 1.0 : hopelessShare);
        const bool keepsSize = std::abs(textureArea() - area) < mostGrowth * area;
        if (!keepsSize || m_conformal.isFolded() || m_conformal.badTriangles() >= bad)
            continue;
        bad = m_conformal.badTriangles();
        folded = false;
        if (!isStretched(mostBad))
            return true;
        keep(m_best);
    }
    take(m_best);
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

/// Opens the seam below the first whole cross-section and lets it go around there: at this height the tube
/// leaves the direction of its parent, and what is below and what is above can be laid flat, together they
/// cannot. The two stay one piece: in front of the seam's other side a part of the cross-section is welded.
/// \param welded share of the cross-section. \returns false where there is nothing to cut.
bool TubeTexture::cut(double welded)
{
    const double apart = sameSection * m_axis.length(), height = m_sections.front();
    const std::size_t before = m_vertices.size();
    const auto isOn = [&](const TubeTextureVertex& vertex) {
        return !vertex.onParent && !vertex.onWall && std::abs(vertex.along - height) <= apart;
    };
    m_sorted.clear();
    bool opens = false;
    for (const TubeTextureVertex& vertex : m_vertices) {
        opens = opens || vertex.onParent;
        if (isOn(vertex))
            m_sorted.push_back(vertex.azimuth);
    }
    std::sort(m_sorted.begin(), m_sorted.end());
    // The edge next to the seam is torn where one of its two triangles reaches across.
    const bool isTorn = std::any_of(m_triangles.begin(), m_triangles.end(), [&](const glm::uvec3& triangle) {
        const std::array<bool, 3> isBeyond = beyondSeam(triangle);
        int torn = 0;
        for (int c = 0; c < 3; ++c)
            torn += isBeyond[static_cast<std::size_t>(c)] && isOn(m_vertices[triangle[c]]) ? 1 : 0;
        return torn == 2;
    });
    const auto whole = std::max(isTorn ? leastWelded + 1 : leastWelded,
                                static_cast<std::size_t>(welded * double(m_sorted.size())));
    if (!opens || m_sorted.size() <= whole)
        return false;
    const double weldedUpTo = m_sorted[whole - 1];
    std::vector<Index>&above = m_front, &beyond = m_next;
    above.assign(before, noIndex);
    beyond.assign(before, noIndex);
    for (glm::uvec3& triangle : m_triangles) {
        double highest = 0.0;
        for (int c = 0; c < 3; ++c)
            highest = std::max(highest, m_vertices[triangle[c]].along);
        const bool isAbove = highest > height + apart;
        const std::array<bool, 3> isBeyond = beyondSeam(triangle);
        for (int c = 0; c < 3; ++c) {
            const TubeTextureVertex& vertex = m_vertices[triangle[c]];
            if (isAbove ? isOn(vertex) && vertex.azimuth > weldedUpTo : isBeyond[static_cast<std::size_t>(c)])
                copyCorner(triangle[c], isAbove ? above : beyond);
        }
    }
    for (std::size_t i = 0; i < before; ++i)
        if (beyond[i] != noIndex) {
            TubeTextureVertex& vertex = m_vertices[beyond[i]];
            vertex.azimuth += turn;
            vertex.u += vertex.around;
        }
    m_isCut = m_vertices.size() > before;
    return m_isCut;
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
