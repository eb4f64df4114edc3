#include "core/surface/texture/texture_tube.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {

namespace {

constexpr double leastTurn = 0.02; ///< rad, between neighbours on a smoothed front
constexpr int thoroughSweeps = 60, choosySweeps = 8;
constexpr int unfoldingRounds = 6;
constexpr int hopelessRounds = 6; ///< of a tube that cannot lie flat
/// Of a tube's triangles may be stretched: it is left at that.
constexpr double enoughBad = 0.04, thoroughBad = 0.01;

/// How a tube may be laid out.
struct Way
{
    Index bad; ///< triangles after a trial; noIndex: folded
    std::size_t sections;
};

} // namespace

const TubeTexture::Effort TubeTexture::firstEffort{1, 4, 5, 0.1}, TubeTexture::trialEffort{2, 5, 15, 1.0};

template <class Relaxer> void TubeTexture::fill(Relaxer& relaxer) const
{
    relaxer.clear();
    const double fixed = m_endStays ? (1.0 - sameSection) * m_axis.length() : m_axis.length() + 1.0;
    for (const TubeTextureVertex& vertex : m_vertices)
        relaxer.addVertex({vertex.u, vertex.v}, !vertex.onParent && !vertex.isPole && vertex.along < fixed);
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

/// Moves vertices to where few triangles are stretched. \returns whether no more are than may be.
bool TubeTexture::settle(const Effort& effort)
{
    const Index enough = shareOf(m_care.ways > 0 ? thoroughBad : enoughBad);
    fill(m_conformal);
    m_conformal.relax(effort.relaxRounds, effort.sweeps);
    if (m_conformal.isFolded() || m_conformal.badTriangles() <= shareOf(effort.hopeless))
        m_conformal.fit(effort.rounds, enough);
    if (m_conformal.isFolded()) {
        fill(m_conformal);
        m_conformal.relax(unfoldingRounds, effort.sweeps);
    }
    read(m_conformal);
    return !m_conformal.isFolded() && m_conformal.badTriangles() <= enough;
}

Index TubeTexture::shareOf(double share) const
{
    return static_cast<Index>(share * double(m_triangles.size()));
}

/// Keeps the tube's shape as well as it can: with a seam that meets itself, or with one that is open at the
/// bend where that is not enough. \returns whether nothing is folded.
bool TubeTexture::even(const TubeTextureEnd& parent)
{
    const bool isThorough = m_care.ways > 0;
    const Effort whole{2, 5, m_care.rounds, 1.0};
    const Effort& first = !m_options.seamsAround ? whole : isThorough ? trialEffort : firstEffort;
    const bool good = settle(first);
    m_stretched = m_conformal.badTriangles();
    m_folds = m_conformal.isFolded();
    if (good || !m_options.seamsAround)
        return !m_folds;
    keep(m_whole);
    keep(m_best);
    std::array<Way, 4> ways{{{m_stretched, 0}}};
    std::size_t count = 1;
    for (const std::size_t sections : {std::size_t(2), std::size_t(1), std::size_t(3)}) {
        if (!layOut(sections, parent))
            continue;
        const bool enough = settle(isThorough ? trialEffort : whole);
        ways[count++] = {m_conformal.isFolded() ? noIndex : m_conformal.badTriangles(), sections};
        if (isBetter() && (enough || !isThorough))
            return true;
    }
    // Those that promise most get the rounds.
    std::stable_sort(ways.begin(), ways.begin() + count,
                     [](const Way& a, const Way& b) { return a.bad < b.bad; });
    for (std::size_t i = 0; i < std::min(count, std::size_t(m_care.ways)); ++i) {
        if (!layOut(ways[i].sections, parent))
            continue;
        const bool enough = settle(whole);
        if (isBetter() && enough)
            break;
    }
    take(m_best);
    return !m_folds;
}

/// The tube as it was before it was evened out. \param sections up to which the seam is open; 0: it is not.
bool TubeTexture::layOut(std::size_t sections, const TubeTextureEnd& parent)
{
    take(m_whole);
    assign(parent);
    return sections == 0 || openSeam(sections);
}

/// What was settled last is kept where it is the best so far.
bool TubeTexture::isBetter()
{
    if (m_conformal.isFolded() || (!m_folds && m_conformal.badTriangles() >= m_stretched))
        return false;
    m_folds = false;
    m_stretched = m_conformal.badTriangles();
    keep(m_best);
    return true;
}

void TubeTexture::keep(Layout& layout) const
{
    layout.vertices = m_vertices;
    layout.positions = m_positions;
    layout.triangles = m_triangles;
    layout.isOpen = m_isOpen;
}

void TubeTexture::take(const Layout& layout)
{
    m_vertices = layout.vertices;
    m_positions = layout.positions;
    m_triangles = layout.triangles;
    m_isOpen = layout.isOpen;
}

/// For a tube with triangles that lie the wrong way round: the axis may pass beside the front, or the tube
/// itself is folded.
void TubeTexture::unfold(const TubeTextureEnd& parent)
{
    smoothFront();
    chooseSeam();
    assign(parent);
    if (even(parent))
        return;
    assign(parent);
    fill(m_relaxer);
    m_relaxer.run(thoroughSweeps, choosySweeps);
    read(m_relaxer);
    fill(m_conformal);
    m_conformal.relax(0, 0);
    m_stretched = m_conformal.badTriangles();
}

/// For a tube that bends too sharply at its fork to lie flat anywhere: its last cross-section is laid out
/// evenly, as of a straight tube, so that its children can be.
void TubeTexture::keepEnd(const TubeTextureEnd& parent)
{
    if (m_options.seamsAround) // what even() has started from
        take(m_whole);
    assign(parent);
    m_endStays = true;
    const Care care = m_care;
    m_care.rounds = std::min(care.rounds, hopelessRounds);
    if (!even(parent))
        unfold(parent);
    m_care = care;
    m_endStays = false;
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

/// Up to which height the seam may be open: its end is shared with the children, who go on from there.
double TubeTexture::openHeight(std::size_t sections) const
{
    const double height = m_sections[std::min(sections, m_sections.size()) - 1];
    return std::min(height, m_axis.length()) - sameSection * m_axis.length();
}

/// From the front to the second whole cross-section the two sides of the seam part: vertices beyond it
/// become copies of their own. At the first one the tube leaves the direction of its parent, and its outer
/// side, where the seam is, cannot be laid flat in one piece.
bool TubeTexture::openSeam(std::size_t sections)
{
    const double height = openHeight(sections);
    const std::size_t before = m_vertices.size();
    std::vector<Index>& copies = m_next;
    copies.assign(before, noIndex);
    for (glm::uvec3& triangle : m_triangles) {
        if (isCap(triangle))
            continue;
        const std::array<bool, 3> beyond = beyondSeam(triangle);
        for (int c = 0; c < 3; ++c)
            if (beyond[static_cast<std::size_t>(c)] && m_vertices[triangle[c]].along < height)
                copyCorner(triangle[c], copies);
    }
    for (std::size_t i = 0; i < before; ++i)
        if (copies[i] != noIndex) {
            TubeTextureVertex& vertex = m_vertices[copies[i]];
            vertex.azimuth += turn;
            vertex.u += vertex.around;
        }
    m_isOpen = m_vertices.size() > before;
    return m_isOpen;
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
