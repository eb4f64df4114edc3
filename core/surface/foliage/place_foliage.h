/// \file
/// Places the leaves and fruit of a tree (SPEC A3, A6) and builds their meshes. The radii decide which
/// branches carry foliage. The branch's key and the foliage seed decide where it stands on the branch, so a
/// change elsewhere in the tree moves no leaf.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// The rule of SPEC A3: a branch with a0 < alpha * leavesCutoff carries leavesDensity leaves, at random
/// positions within alpha / 2 around it (evenly along it and over the disc across it), at random
/// orientations; on a terminal branch they stand up to alpha past its end. With the probability
/// applesProbability the branch also carries one apple, placed likewise. Lengths are those of the branch.
///
/// The leaves of branch b are drawn one after the other from Random(seed, RandomStream::Leaves, key of b).
/// RandomStream::Apples decides first whether there is an apple, then where. Errors: Limit (more than
/// maxLeaves or maxApples; path = the parameter to lower), Cancelled.
Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, double alpha,
                               const Progress& progress = {});
/// Places foliage on the same branches. If \p leaf names a plant, its leaves are placed by leaf_placement.h.
/// If \p fruit names a fruit or flower, it is placed by fruit_placement.h in place of apples.
Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, const LeafParams& leaf,
                               const FruitParams& fruit, double alpha, const Progress& progress = {});

/// Return the mesh that every leaf or fruit copies, in the frame of an item with size and tone 1.
TriangleMesh oneLeaf(const LeafForm& form, double alpha, FoliageModel model);
TriangleMesh oneApple(const FruitForm& form, double alpha, FoliageModel model);

/// Builds all leaves as one mesh; it should be drawn on both sides. A faithful leaf is one flat face around
/// its position with the normal +Z of its frame. A plant's leaf is its leafMesh, or a card in the place of
/// its blade in the rough model. If cancelled, it returns at once with a mesh of no use.
TriangleMesh buildLeaves(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model,
                         const Progress& progress = {});
/// Builds all fruit as one mesh. Fine fruit are closed manifolds. The rough cubes have flat faces, so each
/// corner is stored three times. If cancelled, it returns at once with a mesh of no use.
TriangleMesh buildApples(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model,
                         const Progress& progress = {});

} // namespace ramure
