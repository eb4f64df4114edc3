/// \file
/// The skeleton of a skin as an arm that wears the skin's mesh. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_mesh_reader.h"
#include "core/params/arm_params.h"
#include <span>

namespace ramure::glb {

/// A skeleton as a chain from its foot on.
struct Chain
{
    std::vector<Index> order;           ///< places in the skin's list of joints, from the foot on
    std::vector<glm::dmat4> binds;      ///< of those joints: where they stood when the mesh was bound
    std::vector<glm::dmat4> transforms; ///< where each stands now, in the space that the arm is to stand in
};

struct ChainArm
{
    std::vector<ArmJoint> joints; ///< in the pose that the chain has now
    /// The axes of each segment in the space of its joint; Z is its direction.
    std::vector<glm::dmat3> axes;
    double window = 0.0;     ///< m, how far from a joint vertices follow two segments
    glm::dmat3 upright{1.0}; ///< from the arm's own space, Z up, into that of the transforms
    glm::dmat4 place{1.0};   ///< of its node, in the space of the chain's transforms
};

/// Segments go from joint to joint, the last one as far as the vertices that follow it; turns of a segment
/// about itself are left out. \param mesh becomes what the straight arm wears: vertices stand where its
/// segments would have them, Z up, the foot at the origin. Errors: Invalid (joints at one place, over 64).
Expected<ChainArm> armOf(const Chain& chain, ReadGlbMesh& mesh, const std::string& place);

/// The angles for another pose of the same chain, whole turns added so that they are near those that \p
/// joints have.
void poseArm(const ChainArm& arm, const Chain& chain, std::span<const glm::dmat4> transforms,
             std::span<ArmJoint> joints);

/// The skin's joints in a row, each below the one before. Empty where they branch. \param parents of each
/// joint the nearest joint above it, noIndex where there is none.
std::vector<Index> chainOf(const std::vector<Index>& parents);

} // namespace ramure::glb
