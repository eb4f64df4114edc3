/// \file
/// Counts the pairs of triangles of a mesh that run through each other, with exact predicates, by kind of
/// pair.
///
/// Sorting by kind tells a fault of the mesher (within one branch, between siblings, between parent and
/// child) from a property of the skeleton (branches far apart in the tree that collide).
///
/// Owner of a triangle: the branches of its three vertices (TriangleMesh::branch) that lie deepest in the
/// skeleton; one as a rule (the ring where a tube begins belongs to the parent, so the tube's first band has
/// two branches and is the child's), two or three where siblings meet. A pair is of the closest kind that any
/// two of its owners give.
///
/// What counts as a pair:
/// - no vertex in common: the closed triangles have a point in common;
/// - one vertex in common: they meet anywhere beyond it;
/// - an edge in common: they lie in one plane on the same side of it;
/// - three vertices in common: always.
/// Triangles whose corners lie on one line are left out (the topology suites refuse them).
///
/// A second opinion on core/surface/check: of the core it has the mesh alone. CGAL finds the pairs and judges
/// those that share nothing, exact vectors those that do, and kinds follow from lines of ancestors.
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"
#include "core/surface/mesher/branch_mesh.h"
#include <array>
#include <string>
#include <vector>

namespace ramure::test {

enum class PairKind : std::uint8_t { Same, Siblings, ParentChild, Far };

struct IntersectingPair
{
    PairKind kind;
    Index first, second; ///< faces
};

struct SelfIntersections
{
    Index same = 0, siblings = 0, parentChild = 0, far = 0;
    std::vector<IntersectingPair> pairs; ///< all of them, in order of the faces

    /// Those the mesher answers for.
    [[nodiscard]] Index aroundForks() const { return same + siblings + parentChild; }
    /// The counts and, of each kind, the branches and places of the first few.
    [[nodiscard]] std::string summary(const TriangleMesh& mesh) const;
};

/// \param parent per branch its parent, or noIndex; empty = everything is one branch.
SelfIntersections findSelfIntersections(const TriangleMesh& mesh, const std::vector<Index>& parent = {});

/// The parents as they are after the mesher's repairs: children of a merged or contracted branch belong to
/// the one that stands for it, a chained sibling to the one it continues.
std::vector<Index> repairedParents(const Skeleton& skeleton, const std::vector<RepairNote>& repairs);

} // namespace ramure::test
