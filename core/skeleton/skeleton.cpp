#include "core/skeleton/skeleton.h"

#include "core/math/random.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {

void Skeleton::reserve(std::size_t count)
{
    parent.reserve(count);
    p0.reserve(count);
    p1.reserve(count);
    a0.reserve(count);
    a1.reserve(count);
    level.reserve(count);
    key.reserve(count);
    source.reserve(count);
}

void Skeleton::resize(std::size_t count)
{
    parent.resize(count);
    p0.resize(count);
    p1.resize(count);
    a0.resize(count);
    a1.resize(count);
    level.resize(count);
    key.resize(count);
    source.resize(count);
}

void Skeleton::clear()
{
    *this = Skeleton();
}

std::vector<double> Skeleton::rollOfEach() const
{
    std::vector<double> all(rolls.empty() ? 0 : size(), 0.0);
    for (const auto& [branch, roll] : rolls)
        all[branch] = roll;
    return all;
}

Index Skeleton::add(Index parentIndex, const glm::dvec3& from, const glm::dvec3& to, double radius0,
                    double radius1, Index branchLevel)
{
    const Index index = size();
    parent.push_back(parentIndex);
    p0.push_back(from);
    p1.push_back(to);
    a0.push_back(radius0);
    a1.push_back(radius1);
    level.push_back(branchLevel);
    key.push_back(mixBits(index + 1));
    source.push_back(index);
    return index;
}

ChildLists childLists(const Skeleton& skeleton)
{
    const Index count = skeleton.size();
    ChildLists lists;
    lists.first.assign(count + 1, 0);
    for (const Index p : skeleton.parent)
        if (p != noIndex)
            ++lists.first[p + 1];
    for (Index i = 0; i < count; ++i)
        lists.first[i + 1] += lists.first[i];
    lists.list.resize(lists.first[count]);
    std::vector<Index> next(lists.first.begin(), lists.first.end() - 1);
    for (Index i = 0; i < count; ++i)
        if (skeleton.parent[i] != noIndex)
            lists.list[next[skeleton.parent[i]]++] = i;
    return lists;
}

SkeletonStats skeletonStats(const Skeleton& skeleton)
{
    SkeletonStats stats;
    stats.branches = skeleton.size();
    if (skeleton.empty())
        return stats;
    const ChildLists children = childLists(skeleton);
    stats.min = stats.max = skeleton.p0[0];
    for (Index i = 0; i < skeleton.size(); ++i) {
        stats.roots += skeleton.parent[i] == noIndex ? 1 : 0;
        stats.terminals += children.count(i) == 0 ? 1 : 0;
        stats.maxChildren = std::max(stats.maxChildren, children.count(i));
        stats.totalLength += skeleton.length(i);
        stats.sumA1 += skeleton.a1[i];
        stats.sumTip += skeleton.p1[i];
        stats.min = glm::min(stats.min, glm::min(skeleton.p0[i], skeleton.p1[i]));
        stats.max = glm::max(stats.max, glm::max(skeleton.p0[i], skeleton.p1[i]));
    }
    return stats;
}

} // namespace ramure
