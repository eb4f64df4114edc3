#include "core/math/bvh.h"

#include <limits>

namespace ramure {
namespace {

constexpr int binCount = 16;
constexpr Index leafSize = 4;

struct Bounds
{
    glm::vec3 min{std::numeric_limits<float>::max()};
    glm::vec3 max{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& low, const glm::vec3& high)
    {
        min = glm::min(min, low);
        max = glm::max(max, high);
    }
    [[nodiscard]] float halfArea() const
    {
        const glm::vec3 d = glm::max(max - min, glm::vec3(0.0f));
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

glm::vec3 middle(const PrimitiveBounds& p)
{
    return 0.5f * (p.min + p.max);
}

/// Which bin of the range [low, low + 1 / scale * binCount) a middle falls in.
int binOf(float value, float low, float scale)
{
    return std::clamp(static_cast<int>((value - low) * scale), 0, binCount - 1);
}

struct Bin
{
    Bounds bounds;
    Index count = 0;
};

/// The last bin of the left part with the lowest cost, or -1 where every middle is in one bin.
int bestCut(const std::array<Bin, binCount>& bins, float& lowestCost)
{
    std::array<float, binCount> rightCost{};
    Bounds right;
    Index count = 0;
    for (int i = binCount - 1; i > 0; --i) {
        right.add(bins[std::size_t(i)].bounds.min, bins[std::size_t(i)].bounds.max);
        count += bins[std::size_t(i)].count;
        rightCost[std::size_t(i)] = count > 0 ? right.halfArea() * float(count) : -1.0f;
    }
    Bounds left;
    count = 0;
    int best = -1;
    for (int i = 0; i + 1 < binCount; ++i) {
        left.add(bins[std::size_t(i)].bounds.min, bins[std::size_t(i)].bounds.max);
        count += bins[std::size_t(i)].count;
        const float other = rightCost[std::size_t(i) + 1];
        if (count == 0 || other < 0.0f)
            continue;
        const float cost = left.halfArea() * float(count) + other;
        if (best < 0 || cost < lowestCost) {
            best = i;
            lowestCost = cost;
        }
    }
    return best;
}

/// Puts the left part first; returns its size. Where bins cannot tell the middles apart: one half.
std::size_t partition(std::span<PrimitiveBounds> primitives, bool halve)
{
    Bounds middles;
    for (const PrimitiveBounds& p : primitives)
        middles.add(middle(p), middle(p));
    const glm::vec3 extent = middles.max - middles.min;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const std::size_t half = primitives.size() / 2;
    const auto byMiddle = [axis](const PrimitiveBounds& a, const PrimitiveBounds& b) {
        const float atA = a.min[axis] + a.max[axis];
        const float atB = b.min[axis] + b.max[axis];
        return atA < atB || (atA == atB && a.primitive < b.primitive);
    };
    // Bins need a width that floats can divide by.
    if (!halve && extent[axis] > 1e-30f && std::isfinite(extent[axis])) {
        const float low = middles.min[axis];
        const float scale = float(binCount) * 0.9999f / extent[axis];
        std::array<Bin, binCount> bins;
        for (const PrimitiveBounds& p : primitives) {
            Bin& bin = bins[std::size_t(binOf(middle(p)[axis], low, scale))];
            bin.bounds.add(p.min, p.max);
            ++bin.count;
        }
        float cost = 0.0f;
        const int cut = bestCut(bins, cost);
        if (cut >= 0) {
            const auto edge =
                std::partition(primitives.begin(), primitives.end(), [&](const PrimitiveBounds& p) {
                    return binOf(middle(p)[axis], low, scale) <= cut;
                });
            return static_cast<std::size_t>(edge - primitives.begin());
        }
    }
    std::nth_element(primitives.begin(), primitives.begin() + std::ptrdiff_t(half), primitives.end(),
                     byMiddle);
    return half;
}

} // namespace

Bvh::Bvh(std::vector<PrimitiveBounds> primitives, const std::stop_token& stop)
{
    if (primitives.empty())
        return;
    m_nodes.reserve(primitives.size());
    split(primitives, stop);
    if (stop.stop_requested()) {
        m_nodes.clear();
        return;
    }
    m_order.reserve(primitives.size());
    for (const PrimitiveBounds& p : primitives)
        m_order.push_back(p.primitive);
}

void Bvh::split(std::vector<PrimitiveBounds>& primitives, const std::stop_token& stop)
{
    struct Task
    {
        Index node;
        Index depth;
    };
    const auto enclose = [&](Index first, Index count) {
        Bounds bounds;
        for (Index i = first; i < first + count; ++i)
            bounds.add(primitives[i].min, primitives[i].max);
        Node node;
        node.min = bounds.min;
        node.max = bounds.max;
        node.first = first;
        node.count = count;
        return node;
    };
    m_nodes.push_back(enclose(0, static_cast<Index>(primitives.size())));
    std::vector<Task> tasks{{0, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const Node node = m_nodes[task.node];
        if (node.count <= leafSize)
            continue;
        if (node.count > 10'000 && stop.stop_requested())
            return;
        // Halving from here on keeps the depth in its limit, whatever the primitives look like.
        const bool halve = task.depth > maxDepth / 2;
        const auto left = static_cast<Index>(partition({primitives.data() + node.first, node.count}, halve));
        const auto children = static_cast<Index>(m_nodes.size());
        m_nodes.push_back(enclose(node.first, left));
        m_nodes.push_back(enclose(node.first + left, node.count - left));
        m_nodes[task.node].first = children;
        m_nodes[task.node].count = 0;
        tasks.push_back({children, task.depth + 1});
        tasks.push_back({children + 1, task.depth + 1});
    }
}

} // namespace ramure
