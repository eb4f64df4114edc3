/// \file
/// One fruit or flower as a closed mesh: a body of revolution, its stalk drawn out of its upper end.
#pragma once

#include "core/params/fruit_params.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// What all fruit of a tree have in common.
struct FruitForm
{
    FruitKind kind = FruitKind::Faithful;
    double size = 1.0, stalk = 1.0; ///< of what the plant has
    double ripe = 1.0;              ///< 0 green .. 1 in the colour of the row
    bool operator==(const FruitForm&) const = default;
};

FruitForm fruitForm(const FruitParams& params);

/// Radius at its widest, as a share of the grammar's length: half of it for the faithful one (SPEC A6).
double fruitRadius(const FruitForm& form);
/// From the middle to the foot of the stalk, in radii. 0 for the faithful one, which has no stalk.
double fruitReach(const FruitForm& form);
/// A cube of edge 2 in the body's colour: the rough model's.
TriangleMesh fruitCube(FruitKind kind);
/// How many hang from one place.
int fruitCluster(FruitKind kind);
/// Flowers look at the light, fruit hang.
bool hangs(FruitKind kind);

/// Widest radius 1 about the origin, stalk along +Y with its foot at fruitReach. Closed and manifold, with
/// normals and, but for the faithful sphere, with colours of its own.
TriangleMesh fruitMesh(const FruitForm& form);

} // namespace ramure
