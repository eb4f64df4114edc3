/// \file
/// What of a scene becomes which prim of a USD layer: names, paths, materials, skeletons, and which nodes are
/// the same again. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_materials.h"
#include "core/io/formats/usd/usd_skin.h"

namespace ramure::usd {

/// The path of the prim that holds all others.
inline const std::string rootPath = "/Scene";

/// What meshes and copies wear.
struct Worn
{
    std::string material;              ///< path
    std::string young;                 ///< path of the material of young bark; empty: none
    std::vector<std::string> variants; ///< paths, per variant of its seasons
    bool textured = false;
    Colours colours;
};

struct PlannedMesh
{
    const ExportMesh* from = nullptr;
    std::string prim;
    Worn worn;
    bool hasSkin = false;
};
struct PlannedCopies
{
    const ExportCopies* from = nullptr;
    std::string prim, shape; ///< names of the instancer and of its prototype
    Worn worn;
    std::optional<glm::vec3> tint; ///< see writeCopies
};
struct PlannedCamera
{
    const ExportCamera* from = nullptr;
    std::string prim;
};

/// A node of the scene.
struct PlannedNode
{
    bool isNeeded = false;  ///< it or something below it is to be seen
    Index sameAs = noIndex; ///< a node before it that has the same meshes and copies; it is a leaf
    std::string prim, path;
    std::vector<Index> children; ///< that are needed
    std::vector<PlannedMesh> meshes;
    std::vector<PlannedCopies> copies;
    std::vector<PlannedCamera> cameras;
    std::optional<Rig> rig;
    std::vector<const Pose*> poses; ///< one a frame, of the rig
    bool hasLevels = false;
    std::vector<std::string> seasons; ///< names of variants, the usual one first
    std::vector<std::size_t> order;   ///< numbers of these variants

    /// The path of the prim that holds meshes with skins, else meshes and copies.
    [[nodiscard]] std::string holder() const { return rig ? path + "/Body" : path; }
};

struct Plan
{
    std::vector<PlannedNode> nodes; ///< as those of the scene
    std::vector<Index> tops;        ///< that are needed
    std::string lines;              ///< name of the prim of the skeleton's lines
    Materials materials;
    int lastLevel = 0;
    /// Of the frames: from 0 on, one frame a code where they are evenly spaced.
    std::vector<double> codes;
    double rate = 24.0;    ///< codes a second
    double lastCode = 0.0; ///< of the frames and of key shapes; 0: nothing moves
};

/// Errors: Invalid, a coordinate is not a finite number; those of Materials and rigOf; Cancelled.
Expected<Plan> planOf(const ExportScene& scene, const WriteOptions& options, const Progress& progress);

/// Where a node stands, as seen from the one above it.
glm::dmat4 placeOf(const ExportScene& scene, const ExportFrame& frame, Index node);
/// Where the geometry of a node stands, as seen from the node.
glm::dmat4 insideOf(const ExportFrame& frame, Index node);

} // namespace ramure::usd
