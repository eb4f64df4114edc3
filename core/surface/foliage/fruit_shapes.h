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
    double size = 1.0, stalk = 1.0; ///< of the diameter, and of what the plant has
    double diameter = 0.0;          ///< m; 0: in proportion to the trunk
    int cluster = 1;                ///< how many hang from one place
    int head = 1;                   ///< flowers in one piece, each on a stalk from its foot
    double ripe = 1.0;              ///< 0 green .. 1 in the colour of the row
    bool ripens = false;            ///< not all are ripe: colours are the brightest of both, for tints
    bool operator==(const FruitForm&) const = default;
};

FruitForm fruitForm(const FruitParams& params);

/// m: radius at its widest. \param alpha the grammar's length, half of which the faithful one has (SPEC A6)
double fruitRadius(const FruitForm& form, double alpha);
/// From the middle to the foot of the stalk, in radii. 0 for the faithful one, which has no stalk.
double fruitReach(const FruitForm& form);
/// A cube of edge 2 in the body's colour: the rough model's.
TriangleMesh fruitCube(const FruitForm& form);
/// What the colours of a form that ripens are multiplied by. \param ripe 0 green .. 1 ripe
glm::vec3 ripenedTint(FruitKind kind, double ripe);
/// How many hang from one place.
int fruitCluster(FruitKind kind);
/// Flowers look at the light, fruit hang.
bool hangs(FruitKind kind);

/// Widest radius 1 about the origin, stalk along +Y with its foot at fruitReach. Closed and manifold, with
/// normals and, but for the faithful sphere, with colours of its own. A head of flowers has simple ones, each
/// of which is closed, about the same foot.
TriangleMesh fruitMesh(const FruitForm& form);

} // namespace ramure
