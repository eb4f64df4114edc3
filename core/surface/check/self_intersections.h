/// \file
/// Counts the pairs of triangles of a mesh that run through each other, with exact predicates, by kind of
/// pair.
///
/// The kind tells a fault of the mesher (within one branch, between siblings, between parent and child) from
/// a property of the skeleton (branches far apart in the tree that collide).
///
/// Owner of a triangle: the branches of its three vertices (TriangleMesh::branch) that lie deepest in the
/// skeleton; one as a rule (the ring where a tube begins belongs to the parent, so the tube's first band has
/// two branches and is the child's), two or three where siblings meet. A pair is of the closest kind that any
/// two of its owners give.
///
/// What counts as a pair:
/// - no vertex in common: the closed triangles have a point in common;
/// - one vertex in common: they meet anywhere beside it;
/// - an edge in common: they lie in one plane on the same side of it;
/// - three vertices in common: always.
/// Triangles without an area, or with a corner that is not finite, are left out: validateMesh reports them.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"
#include "core/surface/mesher/branch_mesh.h"
#include <array>
#include <cstdint>
#include <vector>

namespace ramure {

enum class PairKind : std::uint8_t {
    Same,        ///< within one branch
    Siblings,    ///< two branches of one parent
    ParentChild, ///< a branch and one that grows on it
    Far,         ///< any others: branches that collide
};
inline constexpr int pairKindCount = 4;

struct FacePair
{
    PairKind kind = PairKind::Same;
    Index first = 0, second = 0; ///< faces, the lower one first
    bool operator==(const FacePair&) const = default;
};

/// Two branches, far from each other in the tree, whose triangles run through each other.
struct CrossingBranches
{
    Index first = 0, second = 0; ///< branches of the skeleton, the lower one first
    std::uint64_t facePairs = 0;
    glm::dvec3 place{0.0}; ///< mean of the middles of the pairs' common boxes; tree space, m
    bool operator==(const CrossingBranches&) const = default;
};

struct SelfIntersections
{
    std::array<std::uint64_t, pairKindCount> counts{}; ///< complete
    std::vector<FacePair> pairs;                       ///< by kind, then by faces; at most 10,000 of a kind
    std::vector<CrossingBranches> branches;            ///< pairs of branches of the Far crossings
    bool kindsKnown = false; ///< without branches in the mesh everything is PairKind::Same
    bool operator==(const SelfIntersections&) const = default;

    [[nodiscard]] std::uint64_t count(PairKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] std::uint64_t total() const { return counts[0] + counts[1] + counts[2] + counts[3]; }
    /// Crossings that the mesher is responsible for.
    [[nodiscard]] std::uint64_t aroundForks() const { return counts[0] + counts[1] + counts[2]; }
};

/// \param parent per branch its parent, or noIndex, without circles; empty = everything is one branch.
/// \param threads 0 = as many as the machine has; the result is the same for any number.
/// Errors: Invalid (an index out of range), Cancelled. Memory that runs out is thrown.
Expected<SelfIntersections> findSelfIntersections(const TriangleMesh& mesh, const std::vector<Index>& parent,
                                                  unsigned threads = 0, const Progress& progress = {});

/// The parents as they are after the mesher's repairs: children of a merged or contracted branch belong to
/// the one that stands for it, a chained sibling to the one it continues.
std::vector<Index> repairedParents(const Skeleton& skeleton, const std::vector<RepairNote>& repairs);

} // namespace ramure
