/// \file
/// One leaf of a plant as a mesh of few triangles: its petiole from the bark, its blade or leaflets, folded
/// along their midribs, curled and cupped.
///
/// Foot of the petiole at the origin, petiole along +Y, upper side towards +Z; without its petiole the leaf
/// is 1 long. Triangles are counter-clockwise seen from above.
#pragma once

#include "core/params/leaf_params.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// What all leaves of a tree have in common.
struct LeafForm
{
    LeafShape shape = LeafShape::Faithful;
    double width = 1.0, petiole = 1.0; ///< of what the plant has
    double fold = 0.0, curl = 0.0;     ///< rad
    double cup = 0.0;                  ///< -1..1
    int detail = 2;                    ///< 1..3
    bool turns = false;                ///< it is not summer
    bool operator==(const LeafForm&) const = default;
};
LeafForm leafForm(const LeafParams& params);

/// With normals, colours (shades of the row's, white for the blade) and texture coordinates: every blade and
/// leaflet has the whole picture, its foot below. As the plant has it nothing in it crosses; bent or widened
/// to the limits, leaflets may. Empty where the width is 0.
/// \pre the shape is not Faithful.
TriangleMesh leafMesh(const LeafForm& form);
/// Two triangles as long and wide as the blade, where it is. \pre as above.
TriangleMesh leafCard(const LeafForm& form);

} // namespace ramure
