/// \file
/// The mesh of a skeleton's branches, the options it is built with, and what the mesher says about it.
/// build_branch_mesh.h makes it.
#pragma once

#include "core/math/reproducible.h"
#include "core/params/node_params.h"
#include "core/skeleton/sections.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace ramure {

/// The parameters of the sections and the mesh, and further options. If targetTriangles is set, the divisions
/// are ignored: each branch is divided by its thickness along it and its bend, so that all depart about
/// equally from a smooth surface. Up to 128 points around a branch are built, more than a parameter may ask
/// for.
struct BranchMeshOptions : SectionParams, MeshParams
{
    /// Without, mesh.normals stays empty.
    bool withNormals = true;
    /// An extra turn of each branch's frames about its tangent, radians, one per branch; empty = none.
    std::span<const double> rollRad{};
    /// Makes the roots of each tree its own.
    std::uint64_t seed = 0;
    /// Under which roots sink; nothing: level ground where a trunk begins.
    std::optional<GroundPlane> ground{};
};

/// A change of the mesher's copy of the skeleton without which no mesh exists. The skeleton itself stays as
/// it is.
enum class SkeletonRepair : std::uint8_t {
    /// The branch has no length, or lies in a thicker sibling: its children start at its parent's end.
    ZeroLengthContracted,
    RootStub,       ///< a root without length was replaced by a short stub
    RootsJoined,    ///< a root starts where another one does: they stand on one plate
    SiblingsMerged, ///< two siblings coincide: one tube serves both
    SiblingChained, ///< a branch leaves its sibling only at that one's end, or beyond: it starts there
    /// The radius was too small for the scene, or below the least radius. On a root: the tree turned itself
    /// inside out, being much thicker than long or its curves overshooting their branches; the curves were
    /// tamed and, if need be, all radii made smaller.
    RadiusClamped,
};
struct RepairNote
{
    SkeletonRepair kind;
    Index branch; ///< the branch that was changed
    Index other;  ///< the branch it now belongs to, or noIndex
};

/// How a mesh came out against BranchMeshOptions::targetTriangles.
enum class BudgetFit : std::uint8_t {
    NotAsked,
    Within,   ///< within budgetSlack of it
    Smallest, ///< every branch has 3 sides and 2 cross-sections, and still the mesh is larger
    Largest,  ///< every branch has 128 sides and 64 cross-sections, and still the mesh is smaller
    Nearest,  ///< no number of triangles nearer to it could be found
};
inline constexpr double budgetSlack = 0.05; ///< relative to the wanted triangles

/// The triangles of one branch's tube follow each other, from its start to its end; with a root or a tip, the
/// cap too. Every triangle belongs to one tube.
struct TubeRange
{
    Index branch;        ///< branch of the input skeleton whose curve the tube follows
    Index parent;        ///< the branch whose last cross-section it starts from, or noIndex
    Index firstTriangle; ///< its triangles end where the next tube's begin
    bool operator==(const TubeRange&) const = default;
};

/// The foot of a trunk with roots (trunk_foot.h): its tube begins with a pole, and the rings follow from the
/// lowest to the highest. The points of a root follow each other on each, the last in the valley after it.
struct FootSize
{
    Index rings = 0, points = 0, roots = 0; ///< points of each ring
    bool operator==(const FootSize&) const = default;
};

/// The axis of a tube, after all repairs: what its cross-sections stand on.
struct TubeAxis
{
    BranchCurve curve;
    double a0 = 0.0, a1 = 0.0; ///< own radii at its ends, linear in the curve's parameter
    /// It begins wider than a0, by this share of it (fork_spread.h). Towards its end the share falls by
    /// exp(-spreadDecay).
    double spread = 0.0, spreadDecay = 0.0;
    double spreadStart = 0.0; ///< share of the branch from which on it falls
    FootSize foot{};          ///< only for a trunk

    /// m; \p t: share of the branch.
    [[nodiscard]] double radiusAt(double t) const
    {
        const double own = a0 + (a1 - a0) * t;
        return spread > 0.0 ? own * (1.0 + spread * maths::exp(-spreadDecay * std::max(t - spreadStart, 0.0)))
                            : own;
    }
};

/// A vertex in the valley between the tubes of a fork: what else it follows but its own branch.
struct ForkVertex
{
    Index vertex;
    Index parent;                ///< the branch that forks
    std::array<Index, 3> branch; ///< the tubes it lies between; noIndex where there are but two
    /// Weights of those tubes; their sum is 1. If the first of two is a limb that leaves the second to its
    /// side, the second has all the weight.
    std::array<float, 3> weight;
    float along; ///< m, from the fork along their axes
    bool operator==(const ForkVertex&) const = default;
};

struct BranchMesh
{
    TriangleMesh mesh; ///< with normals, branch and level
    std::vector<TubeRange> tubes;
    std::vector<TubeAxis> axes;           ///< one per tube
    std::vector<ForkVertex> forkVertices; ///< by ascending vertex
    std::vector<RepairNote> repairs;
    Index roots = 0; ///< number of components the mesh has by construction
    /// m, how far its vertices keep from each other: 0.12 mm where the least radius is 0.25 mm, the tree not
    /// tiny, and no branch has more than 12 sides.
    double leastGap = 0.0;
    BudgetFit budget = BudgetFit::NotAsked;
};

} // namespace ramure
