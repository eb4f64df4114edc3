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
    bool onDay = false;                ///< colours are those of a day: tints are whole colours
    double length = 0.0;               ///< m, see LeafParams; a form of any length has a mesh of length 1
    int perShoot = 1;                  ///< more than 1: the mesh is that of a shoot, see leaf_shoot.h
    LeafArrangement arrangement = LeafArrangement::Natural; ///< on the shoot; Natural of a single leaf
    int whorl = 4;
    double angle = 0.0; ///< rad, between leaf and shoot; 0 of a single leaf
    bool operator==(const LeafForm&) const = default;
};
LeafForm leafForm(const LeafParams& params);

/// Returns the length in m of a leaf of size 1. \param alpha radius of the trunk, m.
double leafLength(const LeafForm& form, double alpha);

/// With normals, colours (shades of the row's, white for the blade) and texture coordinates: every blade and
/// leaflet has the whole picture, its foot below. As the plant has it nothing in it crosses; bent or widened
/// to the limits, leaflets may. Empty where the width is 0.
/// \pre the shape is not Faithful.
TriangleMesh leafMesh(const LeafForm& form);
enum class CardOutline : std::uint8_t {
    Square, ///< as long and wide as the blade
    Rhomb,  ///< its corners lie in the middles of the square's sides
};
/// Two triangles in the place of each blade. \pre as above.
TriangleMesh leafCard(const LeafForm& form, CardOutline outline = CardOutline::Square);
/// The triangles of a square between the middles of its sides.
TriangleMesh rhombIn(TriangleMesh square);

} // namespace ramure
