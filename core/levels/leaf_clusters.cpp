#include "core/levels/leaf_clusters.h"

#include "core/math/box.h"
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace ramure {
namespace {

/// Halves clusters by their number along the longest side of their box.
struct Joiner
{
    std::span<const FoliageItem> items;
    std::span<const Index> branchOf;
    std::vector<LeafCluster>& clusters;
    std::vector<LeafCluster> out{};

    [[nodiscard]] const glm::dvec3& place(const LeafCluster& cluster) const
    {
        return items[cluster.leaf].position;
    }
    void join(std::size_t begin, std::size_t end);
    void split(std::size_t begin, std::size_t end, std::size_t count);
};

void Joiner::join(std::size_t begin, std::size_t end)
{
    LeafCluster joined;
    glm::dvec3 middle(0.0);
    double weight = 0.0;
    for (std::size_t i = begin; i < end; ++i)
        for (const Index member : clusters[i].members) {
            const double square = double(items[member].size) * double(items[member].size);
            middle += square * items[member].position;
            weight += square;
            joined.members.push_back(member);
        }
    middle /= std::max(weight, 1e-300);
    const auto turn = [&](Index leaf) {
        return std::tuple(branchOf[items[leaf].branch] == noIndex,
                          glm::dot(items[leaf].position - middle, items[leaf].position - middle), leaf);
    };
    joined.leaf = clusters[begin].leaf;
    for (std::size_t i = begin + 1; i < end; ++i)
        if (turn(clusters[i].leaf) < turn(joined.leaf))
            joined.leaf = clusters[i].leaf;
    std::ranges::sort(joined.members);
    out.push_back(std::move(joined));
}

void Joiner::split(std::size_t begin, std::size_t end, std::size_t count)
{
    if (count == 1)
        return join(begin, end);
    Box box;
    for (std::size_t i = begin; i < end; ++i)
        box.add(place(clusters[i]));
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = count / 2, middle = begin + (end - begin) * half / count;
    const auto at = [&](const LeafCluster& c) { return std::pair(place(c)[axis], c.leaf); };
    const auto from = clusters.begin();
    std::nth_element(from + std::ptrdiff_t(begin), from + std::ptrdiff_t(middle), from + std::ptrdiff_t(end),
                     [&](const LeafCluster& a, const LeafCluster& b) { return at(a) < at(b); });
    split(begin, middle, half);
    split(middle, end, count - half);
}

/// Where a leaf's surface is, in the frame of an item of size 1.
glm::dvec3 middleOf(const TriangleMesh& shape)
{
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const glm::uvec3& t : shape.triangles) {
        const glm::dvec3 a(shape.positions[t.x]), b(shape.positions[t.y]), c(shape.positions[t.z]);
        const double twice = glm::length(glm::cross(b - a, c - a));
        sum += twice * (a + b + c) / 3.0;
        area += twice;
    }
    return area > 0.0 ? sum / area : sum;
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
                                        std::span<const Index> branchOf, std::size_t count)
{
    if (count >= clusters.size())
        return clusters;
    Joiner joiner{items, branchOf, clusters};
    joiner.split(0, clusters.size(), std::max<std::size_t>(count, 1));
    std::ranges::sort(joiner.out, {}, &LeafCluster::leaf);
    return std::move(joiner.out);
}

FoliageItem leafOfCluster(std::span<const FoliageItem> items, const LeafCluster& cluster,
                          const LeafShapeOfLevel& whole, const LeafShapeOfLevel& shape)
{
    FoliageItem out = items[cluster.leaf];
    const glm::dvec3 within = middleOf(whole.mesh), own = middleOf(shape.mesh);
    glm::dvec3 middle(0.0);
    double squares = 0.0;
    for (const Index m : cluster.members) {
        const double size = double(items[m].size);
        middle += size * size * (items[m].position + items[m].orientation * (size * within));
        squares += size * size;
    }
    middle /= std::max(squares, 1e-300);
    const double size = std::sqrt(squares * whole.area / shape.area);
    out.size = static_cast<float>(size);
    if (cluster.members.size() > 1)
        out.position = middle - out.orientation * (size * own);
    return out;
}

} // namespace ramure
