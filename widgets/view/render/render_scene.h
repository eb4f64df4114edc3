/// \file
/// The contents of a picture: immutable data on the CPU, in shared blocks. The identity of a block is its
/// key: the renderer uploads a block it has not seen, frees one that is gone, and can be thrown away and
/// rebuilt at any time. Knows no document and no OpenGL. Blocks are in the space of their node; metres, Y up.
#pragma once

#include "core/base/index.h"
#include "core/math/box.h"
#include "core/rig/pose/skin.h"
#include "core/scene/material.h"
#include "core/scene/scene.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/leaf_maps.h"
#include "core/surface/mesh/deferred_mesh.h"
#include "widgets/view/render/crowd/crowd.h"
#include "widgets/view/render/crowd/mesh_copies.h"
#include "widgets/view/render/item_wind.h"
#include "widgets/view/render/light/crown_light.h"
#include "widgets/view/render/surface_images.h"
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// A line with a width at each end: an end of width 0 makes it an arrow's head.
struct LineSegment
{
    glm::vec3 a, b;
    float widthA = 1.5f, widthB = 1.5f; ///< logical pixels
    glm::u8vec4 colour{255};            ///< sRGB, alpha
    Index branch = noIndex; ///< index in the simplified skeleton, for the highlight; noIndex = none
};
struct LineSet
{
    std::vector<LineSegment> segments;
    Box box;
};

/// A round mark of a fixed size on the screen.
struct PointMark
{
    glm::vec3 position;
    float size = 5.0f; ///< diameter in logical pixels
    glm::u8vec4 colour{255};
    Index branch = noIndex;
};
struct PointSet
{
    std::vector<PointMark> points;
    Box box;
};

/// The places of the bones, and the way a mesh follows them. Without bones everything is at rest.
struct ItemMotion
{
    std::shared_ptr<const Skin> skin; ///< for meshes: as many vertices as they have
    std::shared_ptr<const std::vector<RigidTransform>> bones;
    SkinMethod method = SkinMethod::Rigid;
    std::shared_ptr<const ItemWind> wind{}; ///< wind of a game, in place of bones; null: none
    [[nodiscard]] bool moves() const { return bones && !bones->empty(); }
    [[nodiscard]] bool isStill() const { return !moves() && !wind; }
    bool operator==(const ItemMotion&) const = default;
};

/// The source of a surface's colour.
enum class Paint : std::uint8_t {
    Material,
    Checker, ///< squares of texture tiles, larger ones where they would be too small to see
    Stretch, ///< from blue (a square stays a square) over yellow to red
    Weights, ///< the first texture coordinate is a bone; between two whole numbers two bones share the place
};

/// Summary of the texture modes over everything shown.
struct TextureSummary
{
    double tileSize = 0.0; ///< m, on the thickest wood; of several trees the smallest
    std::size_t triangles = 0, stretched = 0, mirrored = 0;
};

/// A mesh whose vertices are copies of another's: several where texture coordinates split them.
struct SplitMesh
{
    std::shared_ptr<const TriangleMesh> from;         ///< null: split from none
    std::shared_ptr<const std::vector<Index>> vertex; ///< per vertex the one it copies
};

/// The faces of one mesh that an outline goes around.
struct OutlinedFaces
{
    std::vector<std::pair<Index, Index>> runs; ///< first face and count; none: all faces of a whole mesh
    bool ofBranches = false;
    Box box; ///< at rest, in the mesh's space
};

/// A mesh standing somewhere. The mesh needs normals; branch ids are optional. For a paint but the material
/// it needs one texture coordinate per vertex.
struct MeshItem
{
    DeferredMesh mesh;                        ///< at rest
    std::shared_ptr<const MeshCopies> copies; ///< drawn in its place: the same, in pieces; null: it is drawn
    /// Of a crowd: where the shape of copies, which has none itself, stands in this picture. Null: no crowd.
    std::shared_ptr<const std::vector<MeshCopy>> places;
    Box box;           ///< bounds of the mesh as it is now, in its own space
    SplitMesh split;   ///< the mesh whose skin it follows if it has none of its own
    ItemMotion motion; ///< drawn so; the mesh itself stays as it is
    Material material;
    Paint paint = Paint::Material;
    std::shared_ptr<const CrownLight> crown; ///< light inside the tree that it is part of; null: in the open
    std::shared_ptr<const BarkMaps> bark;    ///< in place of the material's colour; null: none
    std::shared_ptr<const LeafMaps> leaf;    ///< tints of a leaf's colours; null: none
    std::shared_ptr<const SurfaceImages> images; ///< in place of both; null: none
    glm::vec3 mean{1.0f};                        ///< of a crowd: as CrowdPart has both
    float flat = 0.0f;
    float opacity = 1.0f;                          ///< under 1: its nearest surface only, over all the rest
    std::shared_ptr<const OutlinedFaces> outlined; ///< null: nothing of it
    glm::dmat4 world{1.0};
    glm::dmat4 inNode{1.0}; ///< part of world: how it stands in its node's own geometry
    double margin = 0.0;    ///< m, of arms: how far it stands away from the bones
    NodeId node = noNode;
    bool isMark = false;   ///< something shown at a place of the node, no part of it
    bool isGround = false; ///< shown where the level ground is
    bool closed = false;   ///< its back faces are never seen
    bool castsShadow = true;
    bool pickable = true; ///< false for the nodes that are locked
    bool framed = true;   ///< false: framing the whole scene leaves it out

    /// Does the mesh say which branches it belongs to? One that is made later, of leaves, does.
    [[nodiscard]] bool hasBranches() const { return !mesh.isMade() || !mesh->branch.empty(); }
};

/// A crowd standing somewhere.
struct CrowdItem
{
    std::shared_ptr<const Crowd> crowd;
    /// By prototype what is drawn of it near the eye, in the space that places act upon; null: nothing.
    std::vector<std::shared_ptr<const std::vector<MeshItem>>> whole;
    glm::dmat4 world{1.0};
    NodeId node = noNode;
    bool pickable = true;
    bool operator==(const CrowdItem&) const = default;
};
enum class OutlinedLines : std::uint8_t { None, Selected, All };
struct LineItem
{
    std::shared_ptr<const LineSet> lines;
    glm::dmat4 world{1.0};
    NodeId node = noNode;
    bool throughSurfaces = false; ///< parts behind a surface shine through it
    bool pickable = false;        ///< its segments with a branch can be picked
    ItemMotion motion{};          ///< segments with a branch follow its bone
    float hidden = 0.42f;         ///< opacity of the parts behind a surface
    OutlinedLines outlined = OutlinedLines::None;
    bool pointed = false; ///< marks the object under the mouse and comes and goes with the highlights
    bool framed = true;   ///< the camera frames it like a mesh
};
struct PointItem
{
    std::shared_ptr<const PointSet> points;
    glm::dmat4 world{1.0};
    NodeId node = noNode;
    bool throughSurfaces = false;
    ItemMotion motion{}; ///< marks with a branch follow its bone
    float hidden = 0.42f;
};

/// A translucent copy of a mesh: no shadow, never picked, framed or exported.
struct GhostItem
{
    std::shared_ptr<const TriangleMesh> mesh;
    glm::dmat4 world{1.0};
    glm::u8vec4 colour{255}; ///< sRGB, alpha
};

/// State of one branch in a highlight.
enum class BranchState : std::uint8_t { Plain, Selected, Active, Hovered, HoveredSelected, Goes };
using BranchStates = std::vector<BranchState>;

/// One state per branch of the simplified skeleton of a node. Changing it uploads one byte per branch, no
/// mesh.
struct Highlight
{
    NodeId node = noNode;
    std::shared_ptr<const BranchStates> states;
    bool whole = false; ///< for meshes without branches, too: they use the first state
};

/// A trunk that stands on roots.
struct Foot
{
    glm::dvec3 place{0.0}; ///< world
    double reach = 0.0;    ///< m, of its roots
};

struct RenderScene
{
    std::vector<MeshItem> meshes;
    std::vector<CrowdItem> crowds;                 ///< the renderer draws forms of them (crowd_pictures.h)
    std::vector<MeshItem> farCasters, nearCasters; ///< throw shadows into one of the maps, and are not seen
    std::vector<LineItem> lines;
    std::vector<PointItem> points;
    std::vector<Highlight> highlights;
    std::vector<GhostItem> ghosts; ///< drawn in this order
    Box box;                       ///< world: all items; what frameAll shows
    Box casters;                   ///< world: what throws shadows
    TextureSummary texture;
    std::vector<Foot> feet; ///< litter lies around them
    double ground = 0.0;    ///< m: where the plane of the ground lies
    Box trailBox;           ///< world: bounds of paths and ghosts; not framed

    /// Recomputes the two boxes from the items.
    void updateBoxes();
    /// Points of the scene (world) for Camera::frame, which then comes closer than the box allows: of every
    /// block the farthest in each direction, up to some thousands.
    [[nodiscard]] std::vector<glm::dvec3> framePoints() const;
};

/// The box of a mesh's positions.
Box meshBox(const TriangleMesh& mesh);

} // namespace ramure
