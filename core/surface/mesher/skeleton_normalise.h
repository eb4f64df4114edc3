/// \file
/// The mesher's own copy of a skeleton, brought into a state from which a mesh can be built: no branch
/// without length, no two siblings in one place, no radius too small for the scene. Every change is noted.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesher/branch_mesh.h"
#include <vector>

namespace ramure {

/// A branch as the mesher sees it, in coordinates relative to NormalSkeleton::origin.
struct MeshBranch
{
    glm::dvec3 p0{0.0}, p1{0.0}; ///< p0 is the parent's p1, but for limbs: those may start higher
    double a0 = 0.0, a1 = 0.0, spread = 0.0, spreadDecay = 0.0, spreadStart = 0.0; ///< as TubeAxis has them
    double rollRad = 0.0;   ///< extra turn of this branch's frames
    Index parent = noIndex; ///< in NormalSkeleton::branches
    Index source = noIndex; ///< branch of the skeleton it was made from
    bool isSawn = false;    ///< its end is flat
    std::uint64_t torn = 0; ///< dead wood: its end is broken, as this number has it; 0: it is not
    bool isLimb = false;    ///< it leaves a sibling to its side, and is straight until its end
    bool isPlate = false;   ///< no branch of the skeleton: what stems stand on that start together
    bool isPiece = false;   ///< the upper part of its parent's source: see partForks
    Index foot = noIndex;   ///< of a trunk with roots: the branch of the skeleton that stands on the ground
    Index firstChild = 0;   ///< its children are children[firstChild .. firstChild + childCount)
    Index childCount = 0;

    [[nodiscard]] TubeAxis tubeAxis(const BranchCurve& curve) const
    {
        return {curve, a0, a1, spread, spreadDecay, spreadStart};
    }
    /// m; \p t: share of the branch.
    [[nodiscard]] double radiusAt(double t) const { return tubeAxis({}).radiusAt(t); }
};

/// Branches in depth-first order, parents before children.
struct NormalSkeleton
{
    std::vector<MeshBranch> branches;
    std::vector<Index> children;
    std::vector<RepairNote> repairs;
    glm::dvec3 origin{
        0.0}; ///< what was subtracted from all positions; zero unless the tree is far from the origin
    double scene = 0.0;    ///< diagonal of the box of all ends, with the largest radius
    double leastGap = 0.0; ///< m, between two vertices of the mesh
    Index roots = 0;

    [[nodiscard]] std::span<const Index> childrenOf(Index branch) const
    {
        return {children.data() + branches[branch].firstChild, branches[branch].childCount};
    }
};

/// Fills the lists of children, which follow from the branches' parents.
void linkChildren(NormalSkeleton& skeleton);

/// In this order, parents first and per branch until nothing changes:
/// - a branch shorter than 1e-6 of the scene, 1e-3 of its own radius or the least gap is contracted, its
///   children move to its parent;
/// - limbs thin beside a sibling, the stem (stem_limbs.h): one that ends inside the stem is contracted, one
///   that comes out near the stem's end starts there, and a stem that ends before it is clear of a limb is
///   contracted where all limbs find room around the next;
/// - where options.forkLength is set, a sibling thin beside two others that ends in the wood of the fork is
///   contracted;
/// - other siblings within 1e-3 rad of each other, or closer at the shorter one's end than
///   options.nearTwinRatio times their added radii, become one branch (about equal lengths) or a chain (the
///   longer goes on from the shorter one's end);
/// - a root without length becomes a stub of half its radius behind its first child;
/// - roots that start within a radius of each other become the children of one root plate: a stub at the
///   first one's start, turned away from all of them;
/// - limbs start where limbStart() says;
/// - where options.forkLength is set, forks of thick and thin branches are parted (partForks);
/// - where options.roots asks for them, the first branches of a trunk on the ground become one as long as its
///   foot needs, as thick as the last of them is: a flare gives way to roots.
/// Radii are at least 1e-4 of the scene and options.leastRadius, which is taken as 5e-4 of the scene where it
/// is more: the promise of a least gap holds for trees from half a metre on, and smaller ones keep their
/// shape. Errors: Invalid (empty, non-finite or negative numbers, nothing with a length or a radius, beyond
/// what floats hold), Cancelled.
Expected<NormalSkeleton> normaliseSkeleton(const Skeleton& skeleton, const BranchMeshOptions& options,
                                           const Progress& progress);

} // namespace ramure
