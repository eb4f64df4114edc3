/// \file
/// A skeleton: branches in flat arrays, parents before children, so that a pass over the arrays is a
/// traversal. Lengths in metres, tree space (before the node's placement), Y up.
#pragma once

#include "core/base/index.h"
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace ramure {

/// Leaves and fruit stand on the bark; the others are marks of the bark itself.
enum class OrganKind : std::uint8_t {
    Leaf,
    Fruit,
    Scar,   ///< where a limb fell, `size` its radius: the bark's roll around the wound
    Hollow, ///< a scar that has rotted
    Burr,   ///< a swelling
};
constexpr bool isMark(OrganKind kind)
{
    return kind > OrganKind::Fruit;
}

/// A leaf, fruit or flower that a grammar puts in one place, or a mark of the bark, which looks to `heading`.
/// Its values refer to the branch as it was drawn, so a branch that is bent later takes its organs along.
struct Organ
{
    Index branch = noIndex;
    OrganKind kind = OrganKind::Leaf;
    double share = 1.0;     ///< place on the branch, from its start, in branch lengths
    glm::dvec3 offset{0.0}; ///< m, from there
    glm::dvec3 axis{0.0};   ///< unit, the branch's direction
    /// Unit: where it points, where its upper side looks. Without a heading it stands on the bark as those do
    /// that grow by themselves, on the side of `up`.
    glm::dvec3 heading{0.0}, up{0.0};
    double size =
        -1.0; ///< m, of a leaf its length, of a fruit its width; below 0: so many times the usual one
    double healed = 0.0; ///< of a scar: wood that has grown since, in its radii; at 1 it is closed
    bool operator==(const Organ&) const = default;
};

/// A limb that was cut and falls when the physics plays: a tree of its own, with a root in the air.
struct LooseLimb
{
    Index first = noIndex; ///< root of the limb
    Index stump = noIndex; ///< the branch that it came off, and hangs on until then; noIndex: none is left
    double seconds = 0.0;  ///< after the beginning: when it comes off
    bool operator==(const LooseLimb&) const = default;
};

/// An edit that the generator has already made during growth, so that no step makes it again.
struct LivedEdit
{
    enum class State : std::uint8_t {
        Made,   ///< the tree is as it left it, and has answered
        Waits,  ///< the tree is younger than at the edit
        Missed, ///< its target did not exist at that age
    };
    std::uint64_t edit = 0; ///< TreeEdit::id
    State state = State::Made;
    bool operator==(const LivedEdit&) const = default;
};

/// Invariants: all arrays have one length; parent[i] < i or noIndex (a root); a child starts at its parent's
/// p1.
struct Skeleton
{
    std::vector<Index> parent;
    std::vector<glm::dvec3> p0, p1; ///< ends
    std::vector<double> a0, a1;     ///< radii at p0 and p1
    std::vector<Index> level;       ///< depth of brackets around the branch: 0 = trunk
    std::vector<std::uint64_t>
        key; ///< a name that survives changes elsewhere: a hash of the way from the root
    std::vector<Index>
        source; ///< before simplification: noIndex-free 0..n-1; after: the first branch merged into it
    std::vector<Organ> organs; ///< organs as they were drawn
    /// First branches of axes with the axes' addresses, ascending, where edits were made: axes are no longer
    /// where levels say, and keep their addresses whatever happened beside them. Empty: by levels and ranks.
    std::vector<std::pair<Index, std::uint64_t>> axisStarts;
    std::vector<Index> bare;      ///< branches on which no leaf and no fruit grows by itself, ascending
    std::vector<Index> sawn;      ///< branches whose end was cut, ascending: it is flat
    std::vector<LooseLimb> loose; ///< ascending by their roots
    /// Extra turns of branches' frames about their curves in rad, ascending by branch; their children take
    /// them on.
    std::vector<std::pair<Index, double>> rolls;
    std::vector<LivedEdit> lived; ///< edits in the life of a tree grown by years

    [[nodiscard]] Index size() const { return static_cast<Index>(parent.size()); }
    [[nodiscard]] bool empty() const { return parent.empty(); }
    /// Returns the extra turn of each branch; empty where there is none.
    [[nodiscard]] std::vector<double> rollOfEach() const;
    [[nodiscard]] double length(Index i) const { return glm::length(p1[i] - p0[i]); }
    void reserve(std::size_t count);
    /// New branches are all zero: the caller fills every array.
    void resize(std::size_t count);
    void clear();
    /// Appends a branch; level, key and source may be given by callers that know better. Returns its index.
    /// \p parentIndex is noIndex or an existing branch.
    Index add(Index parentIndex, const glm::dvec3& from, const glm::dvec3& to, double radius0, double radius1,
              Index branchLevel = 0);
    bool operator==(const Skeleton&) const = default;
};

/// Children of every branch in compressed rows: children of i are list[first[i] .. first[i + 1]), in index
/// order.
struct ChildLists
{
    std::vector<Index> first;
    std::vector<Index> list;

    [[nodiscard]] std::span<const Index> of(Index i) const
    {
        return {list.data() + first[i], list.data() + first[i + 1]};
    }
    [[nodiscard]] Index count(Index i) const { return first[i + 1] - first[i]; }
};
ChildLists childLists(const Skeleton& skeleton);

/// Sums over a skeleton, for `ramure-cli info` and golden/skeletons.csv.
struct SkeletonStats
{
    Index branches = 0, terminals = 0, maxChildren = 0, roots = 0;
    double totalLength = 0.0, sumA1 = 0.0;
    glm::dvec3 min{0.0}, max{0.0}; ///< box of all end points
    glm::dvec3 sumTip{0.0};        ///< sum of all p1
};
SkeletonStats skeletonStats(const Skeleton& skeleton);

} // namespace ramure
