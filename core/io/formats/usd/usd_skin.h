/// \file
/// Skeletons of a USD layer, their motion, and the skins of meshes. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_motion.h"
#include "core/io/formats/usd/usd_mesh.h"

namespace ramure::usd {

using Pose = std::vector<RigidTransform>;

/// The skeleton of a node whose meshes have skins.
struct Rig
{
    std::string path; ///< of the Skeleton's prim
    glb::Joints joints;
    std::vector<Index> parents;      ///< of joints, noIndex at the top; they stand before their children
    std::vector<glm::dvec3> feet;    ///< of joints, at rest
    std::vector<std::string> tokens; ///< of joints: "j0/j4"
};

/// \param bones of a pose \param limit joints at most; 0: all. Error: Limit, over 65535 joints.
Expected<Rig> rigOf(const ExportNode& node, std::size_t bones, std::size_t limit, std::string path);

/// Skeleton and SkelAnimation. \param poses one a frame \param codes the time codes of the frames
void writeSkeleton(Text& text, const Rig& rig, std::span<const Pose* const> poses,
                   std::span<const double> codes);
/// The attributes of a mesh that bind it to the skeleton.
void writeSkin(Text& text, const Rig& rig, const Skin& skin, SkinMethod method);
/// The joint that something small goes with.
const std::string& jointOf(const Rig& rig, const SkinInfluence& influence);
/// Adds to \p box where a mesh can be in these poses.
void takePoses(Box& box, const Rig& rig, const TriangleMesh& mesh, const Skin& skin,
               std::span<const Pose* const> poses);

} // namespace ramure::usd
