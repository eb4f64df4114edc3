#include "core/lod/level_twigs.h"

#include "core/math/box.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/skeleton/axes.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ramure {
namespace {

/// By how many doublings of its size a twig may stay longer than others, at most.
constexpr double chanceOfSize = 2.0;
/// Triangles of a twig with three sides and its fork, and of one more piece of it.
constexpr double trianglesOfTwig = 26.0, trianglesOfBend = 8.0;

/// A change of the taper, m per m, is as easily seen as a bend of so many times as many rad: a trunk's foot
/// is its outline.
constexpr double bendsOfTaper = 4.0;
/// OutlineLimits::aside as a share of the tree's height, for each rad that bends may have: slight bends of a
/// long trunk are its outline, too.
constexpr double asideOfBends = 0.02;

double hashUnit(std::uint64_t address)
{
    return static_cast<double>(mixBits(address ^ 0x4C6576656C73ull) >> 11) * 0x1.0p-53;
}

/// rad between a branch and its parent, with what their taper adds.
double turnOf(const Skeleton& tree, Index i)
{
    const Index parent = tree.parent[i];
    const glm::dvec3 before = tree.p1[parent] - tree.p0[parent], way = tree.p1[i] - tree.p0[i];
    return maths::atan2(glm::length(glm::cross(before, way)), glm::dot(before, way)) +
           bendsOfTaper * std::abs(taperOf(tree, i) - taperOf(tree, parent));
}

/// The branches that stay, as a skeleton of their own; noIndex in \p number for the others.
Skeleton subset(const Skeleton& tree, const std::vector<bool>& stays, std::vector<Index>& number)
{
    Skeleton out;
    number.assign(tree.size(), noIndex);
    for (Index i = 0; i < tree.size(); ++i) {
        const Index parent = tree.parent[i];
        if (!stays[i] || (parent != noIndex && number[parent] == noIndex))
            continue;
        number[i] = out.add(parent == noIndex ? noIndex : number[parent], tree.p0[i], tree.p1[i], tree.a0[i],
                            tree.a1[i], tree.level[i]);
        out.key[number[i]] = tree.key[i];
    }
    for (const Index i : tree.sawn)
        if (number[i] != noIndex)
            out.sawn.push_back(number[i]);
    for (const LooseLimb& limb : tree.loose)
        if (number[limb.first] != noIndex)
            out.loose.push_back(
                {number[limb.first], limb.stump == noIndex ? noIndex : number[limb.stump], limb.seconds});
    return out;
}

} // namespace

TwigOrder::TwigOrder(const Skeleton& grown, const SimplifiedSkeleton& tree)
    : m_tree(tree.skeleton)
    , m_axisOf(tree.skeleton.size(), noIndex)
{
    const TreeAxes axes = axesOf(grown);
    // The first branch that was merged into one says whose it is.
    for (Index i = 0; i < grown.size(); ++i)
        if (Index& axis = m_axisOf[tree.mergedInto[i]]; axis == noIndex)
            axis = axes.axisOf[i];
    std::vector<std::uint64_t> addresses;
    for (const Axis& axis : axes.axes) {
        m_parent.push_back(axis.parent);
        m_radius.push_back(axis.radius);
        addresses.push_back(axis.address);
    }
    std::vector<double> area(m_parent.size(), 0.0);
    findAreas(area);
    sort(addresses, area);
    Box box;
    for (const glm::dvec3& end : m_tree.p1)
        box.add(end);
    m_height = box.size().y;
}

/// Of each axis what is to be seen of it and of all that grows on it.
void TwigOrder::findAreas(std::vector<double>& area)
{
    m_turn.assign(m_parent.size(), 0.0);
    for (Index i = 0; i < m_tree.size(); ++i) {
        area[m_axisOf[i]] += m_tree.length(i) * (m_tree.a0[i] + m_tree.a1[i]);
        if (const Index parent = m_tree.parent[i]; parent != noIndex && m_axisOf[parent] == m_axisOf[i])
            m_turn[m_axisOf[i]] += turnOf(m_tree, i);
    }
    for (std::size_t i = area.size(); i-- > 0;)
        if (m_parent[i] != noIndex)
            area[m_parent[i]] += area[i];
}

void TwigOrder::sort(const std::vector<std::uint64_t>& addresses, const std::vector<double>& area)
{
    constexpr double least = 1e-300;
    std::vector<double> score(m_parent.size());
    for (std::size_t i = 0; i < score.size(); ++i)
        score[i] =
            maths::log(std::max(area[i], least)) / std::numbers::ln2 + chanceOfSize * hashUnit(addresses[i]);
    for (std::size_t i = score.size(); i-- > 0;) {
        if (m_parent[i] != noIndex)
            score[m_parent[i]] = std::max(score[m_parent[i]], score[i]);
        else
            score[i] = std::numeric_limits<double>::infinity();
    }
    m_roots = static_cast<Index>(std::ranges::count(m_parent, noIndex));
    m_order.resize(score.size());
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::ranges::stable_sort(m_order, [&](Index a, Index b) { return score[a] > score[b]; });
    m_rank.resize(m_order.size());
    for (Index i = 0; i < axes(); ++i)
        m_rank[m_order[i]] = i;
}

Index TwigOrder::axesFor(double triangles, double mergeRad) const
{
    double sum = 0.0;
    Index count = 0;
    for (; count < axes(); ++count) {
        const double bends = mergeRad > 0.0 ? std::floor(m_turn[m_order[count]] / mergeRad) : 0.0;
        sum += trianglesOfTwig + trianglesOfBend * bends;
        if (sum > triangles)
            break;
    }
    return std::max(count, m_roots);
}

double TwigOrder::thickestGone(Index count) const
{
    double thickest = 0.0;
    for (Index i = count; i < axes(); ++i)
        thickest = std::max(thickest, 2.0 * m_radius[m_order[i]]);
    return thickest;
}

PrunedTree TwigOrder::pruned(Index count, double mergeRad) const
{
    std::vector<bool> stays(m_tree.size());
    for (Index i = 0; i < m_tree.size(); ++i)
        stays[i] = m_rank[m_axisOf[i]] < count;
    std::vector<Index> number;
    Skeleton left = subset(m_tree, stays, number);
    SimplifiedSkeleton merged =
        *simplify(left, mergeRad, {}, {mergeRad / bendsOfTaper, asideOfBends * mergeRad * m_height});
    PrunedTree out;
    out.skeleton = std::move(merged.skeleton);
    out.branchOf.assign(m_tree.size(), noIndex);
    out.firstMember.assign(out.skeleton.size() + 1, 0);
    for (Index i = 0; i < m_tree.size(); ++i)
        if (number[i] != noIndex) {
            out.branchOf[i] = merged.mergedInto[number[i]];
            ++out.firstMember[out.branchOf[i] + 1];
        }
    std::partial_sum(out.firstMember.begin(), out.firstMember.end(), out.firstMember.begin());
    out.members.resize(out.firstMember.back());
    std::vector<Index> next(out.firstMember.begin(), out.firstMember.end() - 1);
    for (Index i = 0; i < m_tree.size(); ++i)
        if (out.branchOf[i] != noIndex)
            out.members[next[out.branchOf[i]]++] = i;
    return out;
}

} // namespace ramure
