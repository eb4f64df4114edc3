/// \file
/// A scene as formats get it to write: nested nodes with their meshes, materials and skins, and a clip of
/// their motion. A format without nodes asks for it flattened.
#pragma once

#include "core/game_wind/wind_profile.h"
#include "core/io/file_space.h"
#include "core/io/mesh_file.h"
#include "core/params/camera_params.h"
#include "core/rig/pose/skin.h"
#include "core/scene/world_transforms.h"
#include <memory>
#include <optional>

namespace ramure {

/// A bone of a node whose meshes have skins. Some formats write fewer bones than the skin has.
struct ExportBone
{
    Index parent = noIndex;         ///< stands before it
    double size = 0.0;              ///< m, how thick: of fewer the thickest stay
    glm::dvec3 foot{0.0}, tip{0.0}; ///< at rest, in the space of the meshes
};

struct ExportNode
{
    std::string name;
    Index parent = noIndex; ///< stands before it; noIndex: the world
    SkinMethod method = SkinMethod::DualQuaternion;
    bool isArm = false; ///< its meshes and bones have Z up; armUpright() stands between them and the node
    std::vector<ExportBone> bones{}; ///< none: nothing is known of them but where they go
};

/// What a mesh looks like at another time of the year.
struct ExportVariant
{
    const char* name = "";
    Index material = 0;
};

/// How pieces of a mesh go through the year.
struct ExportSeasons
{
    std::vector<ExportVariant> variants{}; ///< empty: it always looks the same
    std::vector<float> phases{};           ///< per piece when it turns, 0 first .. 1 last; empty: unknown
};

/// A form of a mesh: other places of the same vertices.
struct ExportShape
{
    std::string name;
    std::vector<glm::vec3> positions, normals; ///< as many as the mesh has; no normals: those of the mesh
};

/// Forms that a mesh has at other times. In between, vertices move in straight lines.
struct ExportShapes
{
    std::vector<ExportShape> shapes;
    std::vector<float> seconds; ///< rising from 0
    std::vector<Index> at;      ///< by time the number of its shape; noIndex: the mesh as it is
};

struct ExportMesh
{
    std::string name; ///< "branches", "leaves", "apples"; of several trees "branches_1", "branches_2" ...;
                      ///< of another node its name, where that is taken with a number: "Box_2"
    Index node = 0;
    std::shared_ptr<const TriangleMesh> mesh; ///< never empty; as it rests, in the node's own space
    Index material = 0;
    std::shared_ptr<const Skin> skin{}; ///< to the node's bones; null: it follows the node alone
    bool isLevel = false;               ///< it is one of several levels of detail
    int level = 0;                      ///< 0 the finest
    Index finest = noIndex; ///< number of the mesh in whose place it can be shown; noIndex: it is one
    double coverage = 0.0;  ///< share of the screen down to which this level suffices and is needed
    /// Of a level but the first, where it takes over: the share of the picture's height that the tree has,
    /// and the distance in m. 0: unknown.
    double share = 0.0, distance = 0.0;
    Index pieces = 0;                               ///< leaves or fruit that it holds
    std::shared_ptr<const WindColumns> wind{};      ///< data for wind in games; null: none
    std::shared_ptr<const ExportSeasons> seasons{}; ///< null: nothing is known of them
    std::shared_ptr<const ExportShapes> shapes{};   ///< null: it keeps its form
};

/// One leaf, fruit or flower.
struct ExportCopy
{
    glm::dmat4 place{1.0}; ///< transform of the shape in the space of its node at the first frame
    glm::vec3 tint{1.0F};  ///< times the shape's colours
    Index branch = noIndex;
    std::uint64_t key = 0;    ///< key of the branch
    std::uint32_t number = 0; ///< its number among the leaves of its branch
    bool operator==(const ExportCopy&) const = default;
};

/// Many of one shape, in the place of a mesh that holds them all.
struct ExportCopies
{
    std::string name; ///< name of the column in the mesh
    std::string kind; ///< "birch", "acorn"
    Index node = 0;
    std::shared_ptr<const TriangleMesh> shape;
    Index material = 0;
    std::vector<ExportCopy> copies;
    std::shared_ptr<const ExportSeasons> seasons{};
    /// Per copy the bones of the node with which it goes; its place is then that at rest. Empty: it stays.
    std::vector<SkinInfluence> follows{};
};

struct ExportCamera
{
    Index node = 0;
    CameraParams lens;
};

/// Textures that a game looks up beside the meshes of one tree.
struct ExportPivots
{
    std::string suffix; ///< "", of several trees "_1", "_2" ...
    PivotTextures textures;
};

/// The places of all nodes at one time.
struct ExportFrame
{
    double seconds = 0.0;
    std::vector<NodeTransforms> transforms;                                ///< per node
    std::vector<std::shared_ptr<const std::vector<RigidTransform>>> bones; ///< per node; null: it rests
};

struct ExportScene
{
    std::vector<ExportNode> nodes;    ///< all of the scene, in its order
    std::vector<ExportMesh> meshes;   ///< branches, leaves, apples of the first tree, then the next, then all
                                      ///< other nodes that have a shape
    std::vector<ExportCopies> copies; ///< no format holds them: core/io/copy_list.h
    std::vector<ExportCamera> cameras;
    std::vector<ExportPivots> pivots; ///< files beside the meshes': core/io/pivot_files.h
    std::vector<Material> materials;
    std::vector<ExportFrame> frames; ///< at least one; more are a clip
    FileSpace space;                 ///< the space into which formats with a single space turn the world
    std::optional<LinePart> lines;   ///< instead of meshes: a skeleton, in the space of the file
};

/// Meshes that belong to no scene, as they are, each a node.
ExportScene sceneOfMeshes(std::vector<ReadObject> objects, const Material& material);
/// The number of a material, which is added where there is no such one yet; of different ones with one name
/// the second is "bark_oak_2".
Index materialIn(ExportScene& scene, const Material& material);

/// The coarsest level of its meshes.
int lastLevel(const ExportScene& scene);
/// Returns the scene with the meshes of one level, and with those that have no levels.
ExportScene levelOf(const ExportScene& scene, int level);

/// Named meshes in the space of the file.
struct FlatScene
{
    struct Entry
    {
        std::string name;
        std::shared_ptr<const TriangleMesh> mesh; ///< shared with the scene where nothing moves it
        Material material;
    };
    std::vector<Entry> meshes;

    [[nodiscard]] std::vector<MeshPart> parts() const; ///< valid as long as this
};
/// The meshes in their pose and in their place at one of the frames, and in one of their shapes.
FlatScene flattened(const ExportScene& scene, std::size_t frame = 0);

} // namespace ramure
