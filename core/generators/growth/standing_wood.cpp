#include "core/generators/growth/standing_wood.h"

#include "core/generators/growth/growing_tree.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {

namespace growth {
namespace {

constexpr Index deepest = 14; ///< order, of YearFactors::sideLongest
constexpr int fresh = 6;      // nodes from the end of an axis that carries others, which still have buds

/// Square on a direction, the same for all of an axis that is straight.
glm::dvec3 sideOf(const glm::dvec3& direction)
{
    const glm::dvec3 other =
        std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    return glm::normalize(glm::cross(direction, other));
}

} // namespace

void GrowingTree::stand(const Skeleton& tree, const TreeAxes& axes)
{
    const ChildLists children = childLists(tree);
    std::vector<Index> endOf(tree.size(), noIndex); // node at the end of a piece
    std::vector<bool> sawn(tree.size(), false), bare(tree.size(), false), lives(tree.size(), true);
    for (const Index i : tree.sawn)
        sawn[i] = true;
    for (const Index i : tree.bare)
        lives[i] = !(bare[i] = true);
    for (Index i = tree.size(); i-- > 0;)
        if (lives[i] && tree.parent[i] != noIndex)
            lives[tree.parent[i]] = true;
    for (const Axis& axis : axes.axes) {
        m_history.axisAddress.push_back(axis.address);
        m_history.axisOrder.push_back(std::uint8_t(std::min<Index>(axis.order, deepest)));
    }
    m_axes.resize(axes.axes.size());
    for (Index i = 0; i < tree.size(); ++i) {
        const Index below = tree.parent[i];
        const Index axis = axes.axisOf[i];
        const Index first = living();
        endOf[i] = standPiece(tree, i, axis, below == noIndex ? noIndex : endOf[below]);
        const bool isLast = i == axes.nodesOf(axis).back();
        for (Index k = first; k < living(); ++k) {
            m_nodes[k].dead = !lives[i];
            m_history.bareWood.push_back(bare[i]);
            const bool isEnd = k + 1 == living();
            m_history.flatWood.push_back(isEnd && isLast ? sawn[i] : !lives[i]); // dead wood breaks
        }
        AxisState& state = m_axes[axis];
        if (isLast && endOf[i] != noIndex) {
            state.tip = m_nodes[endOf[i]].metamer;
            state.tipLives = m_nodes[endOf[i]].tip = lives[i] && !sawn[i];
        }
    }
    m_salt = mixBits(m_seed);
    m_history.standing = Index(m_history.parent.size());
    giveBuds();
    settle();
}

/// The nodes of a piece, an internode apart. Returns the last one.
Index GrowingTree::standPiece(const Skeleton& tree, Index piece, Index axis, Index below)
{
    const glm::dvec3 way = tree.p1[piece] - tree.p0[piece];
    const double length = glm::length(way);
    if (!(length > 1e-6))
        return below;
    constexpr double longest = 1.25, most = 256.0; // internodes; nodes
    const int nodes = int(std::clamp(std::ceil(length / (longest * m_params.internode)), 1.0, most));
    const glm::dvec3 direction = way / length;
    if (below == noIndex)
        m_history.feet.emplace_back(Index(m_history.parent.size()), tree.p0[piece]);
    ShootStart start{below, axis, tree.p0[piece], direction, sideOf(direction)};
    for (int k = 0; k < nodes; ++k) {
        AxisState& state = m_axes[axis];
        const double radius = glm::mix(tree.a0[piece], tree.a1[piece], double(k) / double(nodes));
        start.from = addMetamer(start, direction, length / double(nodes), 0);
        start.at = m_poses[start.from].at;
        Node& node = m_nodes[start.from];
        node.address = mixBits(mixBits(m_history.axisAddress[axis] ^ m_seed) + state.nodes);
        const auto [sine, cosine] =
            maths::sincos(std::fmod(double(state.nodes) * 2.399963229728653, 6.283185307179586));
        node.side = glm::vec3(cosine * start.side + sine * glm::cross(direction, start.side));
        const double pipes = maths::pow(std::max(radius / m_params.tipRadius, 1.0), m_params.pipeExponent);
        node.pipes = float(std::min(pipes, 4e9));
        node.rank = std::uint8_t(std::min<int>(state.nodes, 254));
        if (state.base == noIndex)
            state.base = node.metamer;
        state.nodes = std::uint16_t(std::min(65535, state.nodes + 1));
    }
    return start.from;
}

/// At the ends of axes; of one that carries nothing all along, of a trunk above where its crown begins.
void GrowingTree::giveBuds()
{
    std::vector<bool> carries(m_axes.size(), false);
    for (const Node& node : m_nodes)
        if (node.parent != noIndex && m_nodes[node.parent].axis != node.axis)
            carries[m_nodes[node.parent].axis] = true;
    for (Node& node : m_nodes) {
        if (node.dead)
            continue;
        const AxisState& state = m_axes[node.axis];
        const int all = state.nodes, at = node.rank;
        const double base = node.order == 0 ? m_params.crownBase * double(all) : 0.0;
        const bool isFresh = carries[node.axis] ? at + fresh >= all : double(at) >= base;
        const std::uint8_t buds = budsOf(node.order, at + 1 < all ? 0 : 1, 2, node.address);
        (isFresh ? node.buds : node.dormant) = std::max<std::uint8_t>(buds, 1);
        node.of = std::uint8_t(std::clamp(all, 1, 255));
    }
}

/// The wood holds what it holds: only what comes later thickens and bends it.
void GrowingTree::settle()
{
    constexpr float own = 1.0f;
    std::vector<float> carried(m_nodes.size(), 0.0f);
    for (Index i = living(); i-- > 0;) {
        m_nodes[i].lost = m_nodes[i].pipes - carried[i] - own;
        if (m_nodes[i].parent != noIndex)
            carried[m_nodes[i].parent] += m_nodes[i].pipes;
    }
    YearFactors factors;
    thicken(factors); // notes the load
    for (Node& node : m_nodes)
        node.bend = 0.0f;
    place();
    record();
}

} // namespace growth

Expected<Skeleton> growOn(const Skeleton& tree, const TreeAxes& axes, GrowthParams params, double years,
                          std::uint64_t seed, const Progress& progress)
{
    if (tree.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing that could grow on"));
    if (tree.bare.size() == tree.size())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a tree that is bare to all its ends is dead"));
    const SkeletonStats stats = skeletonStats(tree);
    const double top = stats.max.y - tree.p0[0].y;
    constexpr double grown = 1.1, oldest = 0.86; // of the height
    params.height = std::clamp(std::max(params.height, grown * top), 0.05, 150.0);
    params.age = 1.0;
    const double old =
        -0.5 * params.maturity * maths::log(1.0 - std::clamp(top / params.height, 0.0, oldest));
    auto run = GrowthRun::goOn(tree, axes, int(old), params, seed);
    RAMURE_TRY(run);
    if (auto lived = run->growTo(1.0 + years, progress); !lived)
        return fail(std::move(lived.error()));
    Skeleton later = skeletonAtAge(run->history(), 1.0 + years);
    if (later.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the tree has died for want of light"));
    return later;
}

} // namespace ramure
