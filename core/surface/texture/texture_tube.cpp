#include "core/surface/texture/texture_tube.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <glm/common.hpp>
#include <utility>

namespace ramure {

namespace {

// In radii: where the middle of a tip is, and of the flat end of a root.
constexpr double leastTip = 0.1, tipRadius = 0.5, rootRadius = 0.05;
constexpr double cutRadius = 0.94;   ///< in radii: within it lies the ring of a cut
constexpr double sameSection = 1e-3; ///< of the tube: cross-sections closer than that are one
constexpr double leastOnRoot = 4.0, leastAround = 2.0; ///< tiles around a branch
constexpr double wallRoom = 1.05;                      ///< the wall between siblings has some tiles, too
constexpr double handingLength = 2.0;                  ///< diameters
constexpr double mostWide = 1.25; ///< of a start over its own radius: what is wider counts for its tiles
constexpr int evenRounds = 10, stiffRounds = 80, plainRounds = 10;
constexpr double stiffConvergence = 0.995; ///< of a plain round: what is left of the slowest error
constexpr double enoughStretched = 0.06;   ///< of a tube's triangles: it is left at that
constexpr double agingLength = 2.0;        ///< diameters, after which a limb's bark is its own
constexpr double farthestEven = 2.0; ///< tiles: shapes alone would let what hangs by a corner go anywhere

/// Adds the places of a triangle's corners where it has its true shape and lies as near as can be to where it
/// is. \param own its shape around its middle; \param shift of the corners' u against \p uv.
void layShape(const glm::uvec3& corner, const std::array<glm::dvec2, 3>& own,
              const std::array<double, 3>& shift, std::span<const glm::dvec2> uv, std::span<glm::dvec2> sums)
{
    glm::dvec2 middle(0.0), turned(0.0); // turned: the sum of the places times the conjugates of their own
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec2 now = uv[corner[int(c)]] + glm::dvec2(shift[c], 0.0), a = own[c];
        middle += now / 3.0;
        turned += glm::dvec2(a.x * now.x + a.y * now.y, a.x * now.y - a.y * now.x);
    }
    const double size = glm::length(turned);
    turned = size > 0.0 ? turned / size : glm::dvec2(1.0, 0.0);
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec2 a = own[c];
        sums[corner[int(c)]] +=
            middle + glm::dvec2(turned.x * a.x - turned.y * a.y - shift[c], turned.x * a.y + turned.y * a.x);
    }
}

} // namespace

void TubeTexture::begin()
{
    m_vertices.clear();
    m_positions.clear();
    m_given.clear();
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

Index TubeTexture::addFootVertex(Index vertex, const glm::vec3& position, Index place, const FootSize& foot)
{
    const Index slot = addVertex(vertex, position, false, false, glm::vec2(0.0F));
    const Index across = foot.points / foot.roots + 1, ring = place / (foot.roots * across);
    m_vertices[slot].foot = place;
    m_vertices[slot].isSole = ring == 0;
    m_vertices[slot].isLastValley = ring + 1 < foot.rings && (place + 1) % (foot.roots * across) == 0;
    return slot;
}

void TubeTexture::unroll(const TubeAxis& axis, const TubeTextureEnd& parent,
                         std::span<const glm::uvec3> triangles)
{
    m_axis.build(axis, parent.normal, parent.bend);
    place();
    const double aged = age(parent.aged);
    m_foot = axis.foot;
    m_seam = pi;
    if (m_foot.rings > 0)
        placeFoot();
    chooseSeam();
    chooseTiles(parent);
    m_flareShare = parent.radius > 0.0 ? 1.0 : m_foot.rings > 0 ? 0.0 : 0.25;
    measureAlong();
    assign();
    if (m_foot.rings > 0)
        layFoot();
    if (m_foot.rings > 0)
        stiffenFoot(triangles);
    even(triangles);
    const UnrollAxis::Node& end = m_axis.end();
    m_end = {end.frame.normal, end.bend.x * end.frame.normal + end.bend.y * end.frame.binormal, m_around,
             end.radius, aged};
}

void TubeTexture::place()
{
    const double length = m_axis.length();
    bool isCut = false;
    std::size_t points = 0;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        const UnrollAxis::Place place = m_axis.place(glm::dvec3(m_positions[i]));
        const bool own = !vertex.onParent && !vertex.onWall;
        vertex.along = vertex.onParent ? 0.0 : place.along;
        vertex.azimuth = place.azimuth;
        vertex.crowding = place.crowding;
        // What is wider than the tube, such as the start of a twig on the end of thick wood, is as old as it
        // is wide.
        vertex.radius = std::max(1.0, place.radial) * place.radius;
        const bool onTip = place.along >= length && place.beyond > leastTip && place.radial < tipRadius;
        vertex.isPole = own && (onTip || (place.along <= 0.0 && place.radial < rootRadius));
        const bool atEnd = own && !vertex.isPole && place.along > (1.0 - sameSection) * length;
        isCut = isCut || (atEnd && place.radial < rootRadius);
        points += atEnd ? 1 : 0;
    }
    if (isCut)
        markCut();
    const double half = pi / static_cast<double>(std::max<std::size_t>(points, 3));
    m_chord = maths::sin(half) / half;
}

/// A limb begins in the bark of the wood that carries it, as far as its fork reaches, and comes to its own in
/// the pieces that follow.
double TubeTexture::age(double parentRadius)
{
    const double own = m_axis.nodes().front().own, beyond = parentRadius - own, end = m_axis.end().radius;
    if (!(beyond > 0.0) || !(own > 0.0))
        return end;
    double start = 0.0;
    for (const TubeTextureVertex& vertex : m_vertices)
        if (vertex.onWall)
            start = std::max(start, vertex.along);
    start = std::min(start, parentRadius);
    const auto older = [&](double radius, double along) {
        const double outside = std::max(along - start, 0.0);
        const double aged = radius + beyond * maths::exp(-outside / (agingLength * 2.0 * own));
        return std::max(radius, std::min(aged, parentRadius));
    };
    for (TubeTextureVertex& vertex : m_vertices)
        vertex.radius = older(vertex.radius, vertex.along);
    return older(end, m_axis.length());
}

/// The columns of a foot are as far around as where they leave the trunk. The seam lies in the valley before
/// the first root.
void TubeTexture::placeFoot()
{
    const Index across = m_foot.points / m_foot.roots + 1, top = m_foot.rings - 1;
    m_footPlaces.assign(std::size_t(m_foot.rings) * m_foot.roots * across, noIndex);
    for (Index i = 0; i < m_vertices.size(); ++i)
        if (m_vertices[i].foot != noIndex)
            m_footPlaces[m_vertices[i].foot] = i;
    const auto place = [&](Index ring, Index root, Index column) -> Index& {
        return m_footPlaces[(ring * m_foot.roots + root) * across + column];
    };
    for (Index root = 0; root < m_foot.roots;
         ++root) // one vertex stands for both sides of the highest valleys
        place(top, root, 0) = place(top, (root + m_foot.roots - 1) % m_foot.roots, across - 1);
    for (Index ring = 0; ring < top; ++ring)
        for (Index root = 0; root < m_foot.roots; ++root)
            for (Index column = 0; column < across; ++column) {
                TubeTextureVertex& vertex = m_vertices[place(ring, root, column)];
                const TubeTextureVertex& above = m_vertices[place(top, root, column)];
                vertex.along = above.along;
                vertex.azimuth = above.azimuth;
                vertex.crowding = above.crowding;
                vertex.radius = above.radius;
                vertex.isPole = false;
            }
    m_seam = m_vertices[place(top, 0, 0)].azimuth;
}

/// To begin with, the columns of a foot hang straight down from where they leave the trunk, as long as they
/// are.
void TubeTexture::layFoot()
{
    const Index row = m_foot.roots * (m_foot.points / m_foot.roots + 1);
    const double tiles = m_around / (turn * radiusBetween(0));
    for (Index i = (m_foot.rings - 1) * row; i-- > 0;) {
        const Index above = m_footPlaces[i + row];
        TubeTextureVertex& vertex = m_vertices[m_footPlaces[i]];
        vertex.u = m_vertices[above].u;
        vertex.v = m_vertices[above].v - tiles * glm::length(position(m_footPlaces[i]) - position(above));
    }
}

/// Lets the triangles of a foot come as near to their true shapes as those around them allow: again and again
/// each is laid where it stands, and vertices go to the mean of where their triangles have them (Sorkine and
/// Alexa, "As-rigid-as-possible surface modeling", 2007), further by Chebyshev's weights (Wang, "A Chebyshev
/// semi-iterative approach for accelerating projective and position-based dynamics", 2015). The highest ring
/// stays.
void TubeTexture::stiffenFoot(std::span<const glm::uvec3> triangles)
{
    struct Shape
    {
        glm::uvec3 corner;
        std::array<glm::dvec2, 3> own; ///< tiles, from its middle
        std::array<double, 3> shift;   ///< of the corners' u beyond the seam
    };
    const double tiles = m_around / (turn * radiusBetween(0));
    const Index highest = (m_foot.rings - 1) * m_foot.roots * (m_foot.points / m_foot.roots + 1);
    const auto moves = [&](Index i) { return m_vertices[i].foot < highest; };
    std::vector<Shape> shapes;
    std::vector<double> uses(m_vertices.size(), 0.0);
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 first = position(t.y) - position(t.x), second = position(t.z) - position(t.x);
        const double length = glm::length(first);
        if (isCap(t) || !(moves(t.x) || moves(t.y) || moves(t.z)) || !(length > 0.0))
            continue;
        const glm::dvec2 b(tiles * length, 0.0),
            c = tiles / length * glm::dvec2(glm::dot(first, second), glm::length(glm::cross(first, second)));
        const glm::dvec2 middle = (b + c) / 3.0;
        const std::array<bool, 3> beyond = beyondSeam(t);
        shapes.push_back(
            {t,
             {-middle, b - middle, c - middle},
             {beyond[0] ? m_around : 0.0, beyond[1] ? m_around : 0.0, beyond[2] ? m_around : 0.0}});
        for (int k = 0; k < 3; ++k)
            uses[t[k]] += 1.0;
    }
    std::vector<glm::dvec2> uv(m_vertices.size()), sums(m_vertices.size());
    for (Index i = 0; i < uv.size(); ++i)
        uv[i] = {m_vertices[i].u, m_vertices[i].v};
    std::vector<glm::dvec2> before = uv;
    double weight = 1.0;
    for (int round = 0; round < stiffRounds; ++round) {
        std::ranges::fill(sums, glm::dvec2(0.0));
        for (const Shape& shape : shapes)
            layShape(shape.corner, shape.own, shape.shift, uv, sums);
        if (round >= plainRounds)
            weight = 4.0 / (4.0 - stiffConvergence * stiffConvergence * (round > plainRounds ? weight : 2.0));
        for (Index i = 0; i < uv.size(); ++i) {
            if (!moves(i) || uses[i] == 0.0)
                continue;
            const glm::dvec2 next = before[i] + weight * (sums[i] / uses[i] - before[i]);
            before[i] = std::exchange(uv[i], next);
        }
    }
    for (Index i = 0; i < uv.size(); ++i) {
        m_vertices[i].u = uv[i].x;
        m_vertices[i].v = uv[i].y;
    }
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
    bool hasWall = false;
    for (const TubeTextureVertex& vertex : m_vertices) {
        hasWall = hasWall || vertex.onWall;
        if (vertex.onParent)
            m_sorted.push_back(shortWay(vertex.azimuth));
    }
    double seam = m_seam;
    m_front = pi;
    if (!m_sorted.empty()) {
        std::sort(m_sorted.begin(), m_sorted.end());
        double widest = m_sorted.front() + turn - m_sorted.back();
        seam = m_sorted.back() + 0.5 * widest;
        for (std::size_t i = 0; i + 1 < m_sorted.size(); ++i)
            if (const double gap = m_sorted[i + 1] - m_sorted[i]; gap > widest + 1e-6) {
                widest = gap;
                seam = m_sorted[i] + 0.5 * gap;
            }
        if (hasWall)
            m_front = pi - 0.5 * widest;
    }
    for (TubeTextureVertex& vertex : m_vertices) {
        const double behind = vertex.azimuth - seam;
        vertex.azimuth = behind - turn * std::floor(behind / turn) - pi;
        if (vertex.isLastValley)
            vertex.azimuth = pi;
    }
}

/// Where there is no wall the parent's number goes on, whatever the radius: bark stretches as wood thickens.
/// At a fork one that keeps the density, as far as whole numbers do, and leaves some tiles to the wall.
void TubeTexture::chooseTiles(const TubeTextureEnd& parent)
{
    const UnrollAxis::Node& foot = m_axis.nodes().front();
    m_excess = 0.0;
    m_handing = 1.0;
    if (parent.around == 0.0) {
        const double middle = m_axis.nodes()[UnrollAxis::steps / 2].radius; // above a root's flare
        const double least = parent.radius > 0.0 ? leastAround : leastOnRoot;
        m_around = std::max(least, std::round(m_scale.around(middle)));
        return;
    }
    m_around = parent.around;
    if (m_front >= pi || !(parent.radius > 0.0))
        return;
    const double radius = std::max(foot.own, foot.radius / mostWide);
    const double same = parent.around * radius / parent.radius, below = std::floor(same);
    const double fits = same * same > below * (below + 1.0) ? below + 1.0 : below;
    const double least = std::max(leastAround, std::ceil(wallRoom * parent.around * m_front / pi));
    m_around = std::clamp(fits, std::min(least, parent.around), parent.around);
    m_excess = parent.around - m_around;
    m_handing = std::max(std::min(m_axis.length(), handingLength * 2.0 * foot.radius), 1e-300);
}

/// m, as it counts for the tiles between a node and the next: not as much in the flare of a root, which is
/// short.
double TubeTexture::radiusBetween(std::size_t node) const
{
    const auto& nodes = m_axis.nodes();
    const double radius = 0.5 * (nodes[node].radius + nodes[node + 1].radius);
    const double above = nodes[UnrollAxis::steps / 2].radius;
    return m_chord *
           (m_flareShare < 1.0 ? std::min(radius, above + m_flareShare * (radius - above)) : radius);
}

/// Tiles keep their shape, as fast along the tube as they go around it.
void TubeTexture::measureAlong()
{
    const auto& nodes = m_axis.nodes();
    m_tilesAt[0] = 0.0;
    for (std::size_t i = 0; i < UnrollAxis::steps; ++i)
        m_tilesAt[i + 1] =
            m_tilesAt[i] + (nodes[i + 1].along - nodes[i].along) * m_around / (turn * radiusBetween(i));
}

double TubeTexture::tilesAlong(double along) const
{
    const auto [i, part] = m_axis.find(along);
    return m_tilesAt[i] + (m_tilesAt[i + 1] - m_tilesAt[i]) * part;
}

/// m, the side of a tile there.
double TubeTexture::tileAt(double along) const
{
    const auto [i, part] = m_axis.find(along);
    const auto& nodes = m_axis.nodes();
    return turn * (nodes[i].radius + (nodes[i + 1].radius - nodes[i].radius) * part) / m_around;
}

/// Tiles from the middle of the front. What the parent's cross-section has more of them than the child has
/// room for is given back along the tube, and on the front itself between the ends of the shared arc.
double TubeTexture::turnOf(const TubeTextureVertex& vertex) const
{
    double excess = 0.0;
    if (m_excess != 0.0 && vertex.along < m_handing) {
        const double away = std::abs(vertex.azimuth);
        const double share = away <= m_front ? away : m_front * (pi - away) / (pi - m_front);
        excess = std::copysign(m_excess * share, vertex.azimuth) * (1.0 - vertex.along / m_handing);
    }
    return (m_around * (vertex.azimuth + vertex.crowding) + excess) / turn;
}

/// Where the tube starts in the texture: where its parent really ends, which may have been moved.
glm::dvec2 TubeTexture::startOf() const
{
    glm::dvec2 nearest(0.0), sum(0.0);
    double azimuth = turn, count = 0.0;
    const auto startAt = [&](std::size_t i) {
        return glm::dvec2(double(m_given[i].x) - turnOf(m_vertices[i]), m_given[i].y);
    };
    for (std::size_t i = 0; i < m_given.size(); ++i)
        if (m_vertices[i].onParent && std::abs(m_vertices[i].azimuth) < azimuth) {
            azimuth = std::abs(m_vertices[i].azimuth);
            nearest = startAt(i);
        }
    for (std::size_t i = 0; i < m_given.size(); ++i)
        if (m_vertices[i].onParent) {
            const glm::dvec2 away = startAt(i) - nearest;
            sum += glm::dvec2(away.x - std::round(away.x), away.y);
            count += 1.0;
        }
    return nearest + sum / std::max(count, 1.0);
}

void TubeTexture::assign()
{
    const glm::dvec2 start = startOf();
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        TubeTextureVertex& vertex = m_vertices[i];
        vertex.u = start.x + turnOf(vertex);
        vertex.v = start.y + tilesAlong(vertex.along);
        if (vertex.onParent) {
            vertex.u = double(m_given[i].x) + std::round(vertex.u - double(m_given[i].x));
            vertex.v = double(m_given[i].y);
        }
    }
}

/// What bends within a few cross-sections cannot be laid out by a formula.
void TubeTexture::even(std::span<const glm::uvec3> triangles)
{
    m_relaxer.clear();
    for (const TubeTextureVertex& vertex : m_vertices)
        m_relaxer.addVertex({vertex.u, vertex.v}, !vertex.onParent && !vertex.isPole);
    for (const glm::uvec3& triangle : triangles) {
        if (isCap(triangle))
            continue;
        const std::array<bool, 3> beyond = beyondSeam(triangle);
        std::array<double, 3> shift{};
        std::array<glm::dvec3, 3> places;
        for (int c = 0; c < 3; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            shift[corner] = beyond[corner] ? m_around : 0.0;
            places[corner] = position(triangle[c]);
        }
        m_relaxer.addTriangle({triangle.x, triangle.y, triangle.z}, places, shift);
    }
    if (!m_relaxer.run(evenRounds, enoughStretched))
        return;
    for (Index i = 0; i < m_vertices.size(); ++i)
        if (!(glm::distance(m_relaxer.uv(i), {m_vertices[i].u, m_vertices[i].v}) <= farthestEven))
            return;
    for (Index i = 0; i < m_vertices.size(); ++i) {
        const glm::dvec2 uv = m_relaxer.uv(i);
        m_vertices[i].u = uv.x;
        m_vertices[i].v = uv.y;
    }
}

std::array<glm::dvec2, 3> TubeTexture::apart(const glm::uvec3& triangle) const
{
    const double tile = tileAt(m_vertices[triangle.x].along);
    const glm::dvec3 origin = position(triangle.x), first = (position(triangle.y) - origin) / tile,
                     second = (position(triangle.z) - origin) / tile;
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
    const glm::dvec3 away = (glm::dvec3(position) - node.point) * (m_around / (turn * node.radius));
    const double x = glm::dot(away, node.frame.normal), y = glm::dot(away, node.frame.binormal);
    // The flat end of a root is seen against the axis. Half a tile aside: no line of the pattern at the pole.
    return {0.5 + (start ? -x : x), 0.5 + y};
}

} // namespace ramure
