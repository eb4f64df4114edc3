#include "core/surface/texture/texture_tube.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {

namespace {

// In radii: where the middle of a tip is, and of the flat end of a root.
constexpr double leastTip = 0.1, tipRadius = 0.5, rootRadius = 0.05;
constexpr double cutRadius = 0.94;   ///< in radii: within it lies the ring of a cut
constexpr double sameSection = 1e-3; ///< of the tube: cross-sections closer than that are one
constexpr double leastOnRoot = 4.0, leastAround = 2.0; ///< tiles around a branch
constexpr double wallRoom = 1.05;                      ///< the wall between siblings has some tiles, too
constexpr double handingLength = 2.0;                  ///< diameters
constexpr int evenRounds = 12;
constexpr double enoughStretched = 0.06; ///< of a tube's triangles: it is left at that

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

void TubeTexture::unroll(const TubeAxis& axis, const TubeTextureEnd& parent,
                         std::span<const glm::uvec3> triangles)
{
    m_axis.build(axis, parent.normal, parent.bend);
    place();
    chooseSeam();
    chooseTiles(parent);
    measureAlong(parent.radius == 0.0);
    assign();
    even(triangles);
    const UnrollAxis::Node& end = m_axis.end();
    m_end = {end.frame.normal, end.bend.x * end.frame.normal + end.bend.y * end.frame.binormal, m_around,
             end.radius};
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
        vertex.radius = place.radius;
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
    double seam = pi;
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
    const double same = parent.around * foot.own / parent.radius, below = std::floor(same);
    const double fits = same * same > below * (below + 1.0) ? below + 1.0 : below;
    const double least = std::max(leastAround, std::ceil(wallRoom * parent.around * m_front / pi));
    m_around = std::clamp(fits, std::min(least, parent.around), parent.around);
    m_excess = parent.around - m_around;
    m_handing = std::max(std::min(m_axis.length(), handingLength * 2.0 * foot.radius), 1e-300);
}

/// Tiles keep their shape, as fast along the tube as they go around it; in the flare of a root, which is
/// short, not as much.
void TubeTexture::measureAlong(bool isRoot)
{
    const auto& nodes = m_axis.nodes();
    m_tilesAt[0] = 0.0;
    for (std::size_t i = 0; i < UnrollAxis::steps; ++i) {
        double radius = 0.5 * (nodes[i].radius + nodes[i + 1].radius);
        if (isRoot)
            radius = std::min(radius, 0.25 * radius + 0.75 * nodes[UnrollAxis::steps / 2].radius);
        radius *= m_chord;
        m_tilesAt[i + 1] = m_tilesAt[i] + (nodes[i + 1].along - nodes[i].along) * m_around / (turn * radius);
    }
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
