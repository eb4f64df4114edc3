/// \file
/// Builds a RenderScene from a scene and the results of its trees. It keeps its parts under the identity of
/// their inputs, so that building again after a small change makes only the new parts.
#pragma once

#include "core/evaluate/evaluator.h"
#include "widgets/view/render/crowd_forms.h"
#include "widgets/view/render/display_mode.h"
#include "widgets/view/render/render_scene.h"
#include <functional>
#include <map>
#include <memory>

namespace ramure {

class ScenePartCache;

/// One section shown with its plane, circle and frame.
struct InspectedSection
{
    NodeId node = noNode; ///< noNode = none
    Index branch = 0;     ///< index in the simplified skeleton
    Index section = 0;
    bool operator==(const InspectedSection&) const = default;
};

/// Selects the parts of the scene that are shown.
struct SceneView
{
    DisplayMode mode = DisplayMode::Mesh;
    bool leaves = true;
    bool apples = true;
    FrameDisplay frames = FrameDisplay::None;
    std::vector<NodeId> selectedNodes; ///< shown with an outline, with all below them
    bool crowns = false;               ///< shows the space that selected trees grow to fill
    bool figure = false;               ///< a person of 1.8 m beside the first tree
    bool meadow = true;                ///< grass and fallen leaves around the feet of trees, of meshes alone
    bool cameras = false;              ///< cameras as things that stand there; pictures have none
    NodeId seenThrough = noNode;       ///< the camera that is not shown, as the picture is its own
    NodeId branchNode = noNode;        ///< the tree whose branches are selected
    std::vector<Index> branches;       ///< indices in its simplified skeleton
    Index activeBranch = noIndex;
    NodeId hoverNode = noNode;
    std::vector<Index> hoverBranches;
    bool hoverGoes = false;         ///< a tool would take hoverBranches away
    bool hoverThrough = false;      ///< a line shows them through leaves
    std::vector<NodeId> hoverNodes; ///< nodes under the mouse as a whole
    InspectedSection inspected;
    double timeSeconds = 0.0;     ///< time at which tracks are read for nodes and parameters of objects
    NodeId isolatedNode = noNode; ///< the tree of which only some branches are shown
    std::vector<Index> isolatedBranches; ///< indices in its simplified skeleton; empty = all
    /// False: bark has one colour until its texture coordinates exist, which takes seconds for a large tree.
    bool waitsForBark = true;
    WindProfile wind = WindProfile::None; ///< wind of a game: trees are prepared to move in it
    /// Forms of prototypes. One that is missing is made while the scene is built if that waits for bark; else
    /// an egg stands for the tree.
    std::map<NodeId, std::shared_ptr<const CrowdForms>> crowdForms{};

    /// As prototypes of crowds are seen: meshes, nothing selected.
    [[nodiscard]] SceneView ofPrototypes() const;
};

/// Whether a tree's bark can be shown with its picture without waiting.
bool isBarkReady(const TextureStage& texture, const NodeParams& params);

class GroundHeight;
class ScatterMemory;

class SceneBuilder
{
public:
    /// Null where there is no result.
    using ResultOf = std::function<const TreeResult*(NodeId)>;

    SceneBuilder();
    ~SceneBuilder();
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;

    /// Never fails: missing and impossible parts are left out.
    RenderScene build(EvaluatedScene& scene, const ResultOf& resultOf, const SceneView& view);
    /// Builds the scene as tracks alone have it at the view's time.
    RenderScene build(const Scene& scene, const ResultOf& resultOf, const SceneView& view);

private:
    std::unique_ptr<ScenePartCache> m_cache;
    std::unique_ptr<GroundHeight> m_ground;
    std::unique_ptr<ScatterMemory> m_scatters;
};

/// Only the highlights of \p view, into a scene built before from the same results: for hovering.
void updateHighlights(RenderScene& built, const SceneBuilder::ResultOf& resultOf, const SceneView& view);

/// One foreign mesh (a file that was read) as a scene: bark without branches. Missing normals are computed.
RenderScene sceneOfMesh(TriangleMesh mesh);

} // namespace ramure
