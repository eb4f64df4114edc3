#include "core/levels/leaf_clusters.h"

#include "core/math/box.h"
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace ramure {
namespace {

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

/// Halves clusters by their number along the longest side of their box.
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
    Box box;
    for (const Point& point : points)
        box.add(point.place);
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = count / 2, middle = points.size() * half / count;
    const auto at = [&](const Point& p) { return std::pair(p.place[axis], p.leaf); };
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

FoliageItem leafOfCluster(std::span<const FoliageItem> items, const LeafCluster& cluster,
                          const LeafShapeOfLevel& whole, const LeafShapeOfLevel& shape)
{
    FoliageItem out = items[cluster.leaf];
    const double size = std::sqrt(squaresOf(items, cluster) * whole.area / shape.area);
    out.size = static_cast<float>(size);
    if (cluster.members.size() > 1)
        out.position = middleOf(items, cluster, whole.middle) - out.orientation * (size * shape.middle);
    return out;
}

} // namespace ramure
