#include "core/lod/leaf_clusters.h"

#include "core/math/principal_axes.h"
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <tuple>
#include <utility>

namespace ramure {
namespace {

/// The square of half a line over its spread.
constexpr double halfOfSpread = 3.0;
/// The spread along a cluster over that across it, from which on it is a twig with a direction.
constexpr double clearlyLong = 2.0;

double squaresOf(std::span<const FoliageItem> items, const LeafCluster& cluster)
{
    double squares = 0.0;
    for (const Index m : cluster.members)
        squares += double(items[m].size) * double(items[m].size);
    return squares;
}

/// Of the surface of all members. \param middle of a leaf of size 1.
glm::dvec3 middleOf(std::span<const FoliageItem> items, const LeafCluster& cluster, const glm::dvec3& middle)
{
    glm::dvec3 sum(0.0);
    for (const Index m : cluster.members) {
        const double size = double(items[m].size);
        sum += size * size * (items[m].position + items[m].orientation * (size * middle));
    }
    return sum / std::max(squaresOf(items, cluster), 1e-300);
}

/// Turned about its normal until it is longest along \p spread; its tip stays on the side where it is. Where
/// that is hardly longer than broad, leaves hang or rise as they did.
glm::dquat turnedAlong(const glm::dquat& was, const LeafShapeOfLevel& shape, const glm::dmat3& spread)
{
    const glm::dmat3 own = principalAxes(shape.spread), before = glm::mat3_cast(was) * own;
    const glm::dvec3 normal = before[2];
    const glm::dmat3 flat = glm::dmat3(1.0) - glm::outerProduct(normal, normal);
    glm::dvec3 along = flat * principalAxes(flat * spread * flat)[0];
    const double length = glm::length(along);
    if (!(length > 0.5)) // a spread that is nothing in the leaf's plane
        return was;
    along /= glm::dot(along, before[0]) < 0.0 ? -length : length;
    const glm::dvec3 across = glm::cross(normal, along);
    if (glm::dot(along, spread * along) < clearlyLong * glm::dot(across, spread * across))
        return was;
    const glm::dmat3 after(along, across, normal);
    return glm::normalize(glm::quat_cast(after * glm::transpose(own)));
}

/// Halves clusters by their number across the direction in which they are longest.
struct Joiner
{
    struct Point
    {
        glm::dvec3 place;
        Index leaf, cluster;
    };
    std::span<const FoliageItem> items;
    std::span<const Index> branchOf;
    const glm::dvec3& middle; ///< of a leaf of size 1
    const std::vector<LeafCluster>& clusters;
    std::vector<LeafCluster> out{};

    void join(std::span<const Point> points);
    void split(std::span<Point> points, std::size_t count);
};

void Joiner::join(std::span<const Point> points)
{
    LeafCluster joined;
    for (const Point& point : points) {
        const std::vector<Index>& members = clusters[point.cluster].members;
        joined.members.insert(joined.members.end(), members.begin(), members.end());
    }
    std::ranges::sort(joined.members); // the order of the sum, too
    const glm::dvec3 centre = middleOf(items, joined, middle);
    const auto turn = [&](const Point& p) {
        return std::tuple(branchOf[items[p.leaf].branch] == noIndex,
                          glm::dot(p.place - centre, p.place - centre), p.leaf);
    };
    joined.leaf = std::ranges::min(points, {}, turn).leaf;
    out.push_back(std::move(joined));
}

void Joiner::split(std::span<Point> points, std::size_t count)
{
    if (count == 1)
        return join(points);
    glm::dvec3 mean(0.0);
    for (const Point& point : points)
        mean += point.place / static_cast<double>(points.size());
    glm::dmat3 spread(0.0);
    for (const Point& point : points)
        spread += glm::outerProduct(point.place - mean, point.place - mean);
    const glm::dvec3 way = principalAxes(spread)[0];
    const std::size_t half = count / 2, middle = points.size() * half / count;
    const auto at = [&](const Point& p) { return std::pair(glm::dot(p.place, way), p.leaf); };
    std::ranges::nth_element(points, points.begin() + std::ptrdiff_t(middle), {}, at);
    split(points.first(middle), half);
    split(points.subspan(middle), count - half);
}

} // namespace

std::vector<LeafCluster> singleClusters(std::span<const Index> leaves)
{
    std::vector<LeafCluster> out;
    out.reserve(leaves.size());
    for (const Index leaf : leaves)
        out.push_back({leaf, {leaf}});
    return out;
}

std::vector<LeafCluster> joinedClusters(std::span<const FoliageItem> items, std::vector<LeafCluster> clusters,
                                        std::span<const Index> branchOf, const glm::dvec3& middle,
                                        std::size_t count)
{
    if (count >= clusters.size())
        return clusters;
    std::vector<Joiner::Point> points;
    points.reserve(clusters.size());
    for (const LeafCluster& cluster : clusters)
        points.push_back({middleOf(items, cluster, middle), cluster.leaf, static_cast<Index>(points.size())});
    Joiner joiner{items, branchOf, middle, clusters};
    joiner.split(points, std::max<std::size_t>(count, 1));
    std::ranges::sort(joiner.out, {}, &LeafCluster::leaf);
    return std::move(joiner.out);
}

LeafSpread spreadOf(std::span<const FoliageItem> items, const LeafCluster& cluster,
                    const LeafShapeOfLevel& whole)
{
    LeafSpread out{squaresOf(items, cluster), middleOf(items, cluster, whole.middle)};
    for (const Index m : cluster.members) {
        const double size = double(items[m].size);
        const glm::dmat3 turn = glm::mat3_cast(items[m].orientation);
        const glm::dvec3 way = items[m].position + turn * (size * whole.middle) - out.middle;
        const glm::dmat3 own = turn * whole.spread * glm::transpose(turn);
        out.spread += size * size * (glm::outerProduct(way, way) + size * size * own);
    }
    out.spread /= std::max(out.squares, 1e-300);
    return out;
}

double extentOf(std::span<const FoliageItem> items, std::span<const LeafCluster> clusters,
                const LeafShapeOfLevel& whole)
{
    double sum = 0.0, squares = 0.0;
    for (const LeafCluster& cluster : clusters) {
        const LeafSpread spread = spreadOf(items, cluster, whole);
        sum += spread.squares * (spread.spread[0][0] + spread.spread[1][1] + spread.spread[2][2]);
        squares += spread.squares;
    }
    return squares > 0.0 ? std::sqrt(4.0 * sum / squares) : 0.0; // of a cube of edge e the trace is e² / 4
}

FoliageItem leafOfCluster(std::span<const FoliageItem> items, const LeafCluster& cluster,
                          const LeafShapeOfLevel& whole, const LeafShapeOfLevel& shape,
                          const glm::dvec3& crown)
{
    FoliageItem out = items[cluster.leaf];
    const double size = std::sqrt(squaresOf(items, cluster) * whole.area / shape.area);
    out.size = static_cast<float>(size);
    if (cluster.members.size() < 2)
        return out;
    const LeafSpread all = spreadOf(items, cluster, whole);
    out.orientation = turnedAlong(out.orientation, shape, all.spread);
    const glm::dmat3 turn = glm::mat3_cast(out.orientation);
    const glm::dmat3 own = size * size * turn * shape.spread * glm::transpose(turn);
    const glm::dvec3 away = all.middle - crown, outwards = away / std::max(glm::length(away), 1e-300);
    const auto reach = [&](const glm::dmat3& of) {
        return std::sqrt(std::max(0.0, halfOfSpread * glm::dot(outwards, of * outwards)));
    };
    const double further = std::max(0.0, reach(own) - reach(all.spread));
    out.position = all.middle - further * outwards - turn * (size * shape.middle);
    return out;
}

} // namespace ramure
