#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/scene/demo_scenes.h"
#include "core/surface/mesher/rough_model.h"
#include "tests/support/suite.h"
#include "widgets/view/render/outline.h"
#include "widgets/view/render/scene_builder.h"
#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace tst_scene_builder {

using namespace ramure;

namespace {

/// A scene of trees with their results.
struct Trees
{
    Scene scene;
    std::map<NodeId, TreeResult> results;
    TreePipeline pipeline;

    NodeId add(const char* preset = "TinyTree")
    {
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Tree;
        node.params = *presetParams(preset);
        (void)scene.insert({node}, noNode, 99);
        results[node.id] = *pipeline.evaluate(node.params);
        return node.id;
    }
    [[nodiscard]] SceneBuilder::ResultOf of() const
    {
        return [this](NodeId id) {
            const auto at = results.find(id);
            return at == results.end() ? nullptr : &at->second;
        };
    }
    [[nodiscard]] RenderScene build(const SceneView& view) const
    {
        SceneBuilder builder;
        return builder.build(scene, of(), view);
    }
};

std::vector<std::string> materials(const RenderScene& scene)
{
    std::vector<std::string> names;
    for (const MeshItem& item : scene.meshes)
        names.push_back(item.material.name);
    return names;
}

std::size_t segmentCount(const RenderScene& scene)
{
    std::size_t count = 0;
    for (const LineItem& item : scene.lines)
        count += item.lines->segments.size();
    return count;
}

SceneView in(DisplayMode mode)
{
    SceneView view;
    view.mode = mode;
    return view;
}

/// A unit cube around the place.
Node cubeAt(Scene& scene, double y)
{
    Node node;
    node.id = scene.newId();
    node.kind = NodeKind::Primitive;
    node.params.primitive.shape = PrimitiveShape::Box;
    node.params.primitive.size = glm::dvec3(1.0);
    node.params.tree.translation = {0.0, y, 0.0};
    return node;
}

} // namespace

class TestSceneBuilder : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void lightShinesThroughNothingButLeaves()
    {
        for (const DemoScene& demo : demoScenes()) {
            const Scene scene = *demoScene(demo.name);
            const RenderScene built = SceneBuilder().build(
                scene, [](NodeId) { return nullptr; }, in(DisplayMode::Mesh));
            for (const MeshItem& item : built.meshes)
                QVERIFY2(item.material.through == 0.0f, demo.name);
        }
    }
    void nothingForNothing()
    {
        Trees trees;
        const RenderScene built = trees.build(SceneView());
        QVERIFY(built.meshes.empty() && built.lines.empty() && built.points.empty() &&
                built.highlights.empty());
        QVERIFY(built.box.empty() && built.casters.empty());
        QVERIFY(built.framePoints().empty());
    }
    void theGroundLiesUnderAllThatObjectsEverReach()
    {
        Trees trees;
        trees.add();
        QCOMPARE(trees.build(SceneView()).ground, 0.0); // roots below y = 0 do not matter
        SceneBuilder builder;
        const auto ground = [&](double seconds) {
            SceneView view;
            view.timeSeconds = seconds;
            return builder.build(trees.scene, trees.of(), view).ground;
        };
        const Node above = cubeAt(trees.scene, 3.0), below = cubeAt(trees.scene, -2.0);
        QVERIFY(trees.scene.insert({above}, noNode, 99));
        QCOMPARE(ground(0.0), 0.0);
        QVERIFY(trees.scene.insert({below}, noNode, 99));
        QVERIFY(std::abs(ground(0.0) + 2.5) < 1e-6);
        trees.scene.find(below.id)->visible = false;
        QCOMPARE(ground(0.0), 0.0);

        // Keys lower the other one by 10 m until the last frame; turned by 45 degrees a corner hangs lower.
        Track falls = *Track::fromKeys({Key(), [] {
                                            Key key;
                                            key.time = 4 * ticksPerSecond;
                                            key.value = -10.0;
                                            return key;
                                        }()});
        Node* node = trees.scene.find(above.id);
        node->animation.set({ChannelPart::GlobalTranslation, 1, 0}, AnyTrack(std::move(falls)));
        node->params.local.rotation = {0.0, 0.0, 0.785398163397448};
        TimelineSettings timeline;
        timeline.firstFrame = 0;
        timeline.lastFrame = 96;
        trees.scene.setTimeline(timeline);
        const double lowest = 3.0 - 10.0 - std::sqrt(0.5);
        for (const double seconds : {0.0, 4.0, 1.0})
            QVERIFY2(std::abs(ground(seconds) - lowest) < 1e-6, "it does not move as the scene plays");
        node->animation = {};
        QCOMPARE(ground(0.0), 0.0);
    }
    void missingStagesAreLeftOut()
    {
        Trees trees;
        const NodeId id = trees.add();
        for (const Stage last :
             {Stage::Symbols, Stage::Skeleton, Stage::Simplified, Stage::Sections, Stage::Mesh}) {
            trees.results[id] = *trees.pipeline.evaluate(trees.scene.find(id)->params, last);
            for (int mode = 0; mode < 7; ++mode) {
                SceneView view = in(DisplayMode(mode));
                view.frames = FrameDisplay::All;
                view.branchNode = id;
                view.branches = {0, 1, 9999};
                view.inspected = {id, 9999, 0};
                (void)trees.build(view);
            }
        }
        trees.results.clear();
        QVERIFY(trees.build(SceneView()).box.empty());
    }
    /// Trees on roots stand in litter; those of the coursework stand in grass.
    void rootsHaveAFoot()
    {
        Trees trees;
        trees.add();
        QVERIFY(trees.build(SceneView()).feet.empty());
        const NodeId id = trees.add("SilverBirch1995");
        trees.scene.find(id)->params.tree.scale = glm::dvec3(2.0);
        const std::vector<Foot> feet = trees.build(SceneView()).feet;
        QCOMPARE(feet.size(), std::size_t(1));
        QVERIFY(feet[0].reach > 2.0 * trees.results[id].skeleton->a0[0]);
    }
    void isolatedBranchesAreShownAlone()
    {
        Trees trees;
        const NodeId one = trees.add();
        const NodeId other = trees.add();
        SceneView view;
        const RenderScene whole = trees.build(view);
        view.isolatedNode = one;
        QCOMPARE(trees.build(view).meshes.size(), whole.meshes.size()); // no branch: nothing is isolated
        view.isolatedBranches = {2, 7, 999'999};
        const RenderScene part = trees.build(view);
        for (const MeshItem& item : part.meshes) {
            if (item.node == other)
                continue;
            const TriangleMesh& mesh = *item.mesh;
            QVERIFY(!mesh.empty());
            for (const glm::uvec3& t : mesh.triangles) {
                const auto isMeant = [&](Index v) { return mesh.branch[v] == 2 || mesh.branch[v] == 7; };
                QVERIFY(isMeant(t.x) || isMeant(t.y) || isMeant(t.z));
            }
            QCOMPARE(mesh.normals.size(), mesh.positions.size());
            QVERIFY(meshBox(mesh) == item.box);
        }
        // Nothing of them is lost, and the other tree is whole.
        const auto facesOf = [](const RenderScene& scene, NodeId node, auto isMeant) {
            std::size_t count = 0;
            for (const MeshItem& item : scene.meshes)
                for (const glm::uvec3& t : item.mesh->triangles)
                    count += item.node == node &&
                             (isMeant(item.mesh->branch[t.x]) || isMeant(item.mesh->branch[t.y]) ||
                              isMeant(item.mesh->branch[t.z]));
            return count;
        };
        const auto meant = [](Index branch) { return branch == 2 || branch == 7; };
        const auto any = [](Index) { return true; };
        QCOMPARE(facesOf(part, one, any), facesOf(whole, one, meant));
        QCOMPARE(facesOf(part, other, any), facesOf(whole, other, any));
        for (int mode = 0; mode < 5; ++mode) {
            view.mode = DisplayMode(mode);
            view.frames = FrameDisplay::All;
            for (const LineItem& item : trees.build(view).lines)
                for (const LineSegment& segment : item.lines->segments)
                    QVERIFY(item.node != one || segment.branch == noIndex || meant(segment.branch));
        }
        view = {};
        QVERIFY(trees.build(view).box == whole.box);
    }
    void meshModeHasThreeMaterials()
    {
        Trees trees;
        const NodeParams params = trees.scene.find(trees.add())->params;
        const std::string bark = barkMaterial(params.bark).name;
        SceneView view;
        QCOMPARE(materials(trees.build(view)),
                 (std::vector<std::string>{bark, leavesMaterial(params.leaf.shape).name,
                                           applesMaterial(params.fruit.kind).name}));
        view.leaves = false;
        view.apples = false;
        const RenderScene bare = trees.build(view);
        QCOMPARE(materials(bare), std::vector<std::string>{bark});
        QVERIFY(bare.box == bare.casters);
        QVERIFY(bare.meshes[0].pickable);
    }
    void textureModesPaintTheBranches()
    {
        Trees trees;
        const NodeId id = trees.add();
        for (const auto& [mode, paint] : {std::pair(DisplayMode::Checker, Paint::Checker),
                                          std::pair(DisplayMode::Stretch, Paint::Stretch)}) {
            const RenderScene built = trees.build(in(mode));
            QCOMPARE(built.meshes.size(), std::size_t(1)); // no leaves in front
            const MeshItem& item = built.meshes[0];
            QVERIFY(item.paint == paint);
            QCOMPARE(item.mesh->uv.size(), item.mesh->positions.size());
            QCOMPARE(item.mesh->triangles.size(), trees.results[id].branches->mesh.triangles.size());
            QCOMPARE(built.texture.triangles, item.mesh->triangles.size());
            QCOMPARE(built.texture.mirrored, std::size_t(0));
            QVERIFY(built.texture.tileSize > 0.0);
        }
        QCOMPARE(trees.build(in(DisplayMode::Mesh)).texture.triangles, std::size_t(0));
        trees.scene.find(id)->params.texture.tileSize = 1e-12; // refused: the plain mesh is shown
        const RenderScene plain = trees.build(in(DisplayMode::Checker));
        QVERIFY(plain.meshes[0].paint == Paint::Material);
    }
    /// A tree in a pose: the texture does not swim.
    void textureIsThatOfTheTreeAtRest()
    {
        Trees trees;
        TreeResult& tree = trees.results[trees.add()];
        const RenderScene rest = trees.build(in(DisplayMode::Checker));
        auto bent = std::make_shared<BranchMesh>(*tree.branches);
        for (glm::vec3& place : bent->mesh.positions)
            place.x += 0.3F * place.y * place.y;
        tree.branches = bent;
        const RenderScene moved = trees.build(in(DisplayMode::Checker));
        QVERIFY(moved.meshes[0].mesh->uv == rest.meshes[0].mesh->uv);
        QVERIFY(moved.meshes[0].mesh->positions != rest.meshes[0].mesh->positions);
        QVERIFY(moved.texture.stretched != rest.texture.stretched);
    }
    void roughModeHasItsOwnMeshes()
    {
        Trees trees;
        const NodeId id = trees.add();
        const RenderScene built = trees.build(in(DisplayMode::Rough));
        QCOMPARE(built.meshes.size(), std::size_t(3));
        QVERIFY(built.meshes[0].mesh.get() != &trees.results[id].branches->mesh);
        QVERIFY2(built.meshes[0].material.twoSided, "the cones are open");
    }
    void roughModelsUseTheMemoryOfThoseNoLongerShown()
    {
        Trees trees;
        const NodeId id = trees.add("SmallTree");
        auto builder = std::make_unique<SceneBuilder>();
        std::vector<RenderScene> shown; // the last two, as while a picture is on its way
        bool anyAgain = false;
        for (const int sides : {8, 5, 12, 7, 11, 9, 10}) {
            trees.scene.find(id)->params.sections.radialDivisions = sides;
            shown.push_back(builder->build(trees.scene, trees.of(), in(DisplayMode::Rough)));
            if (shown.size() > 2)
                shown.erase(shown.begin());
            const Skeleton& skeleton = trees.results[id].simplified->skeleton;
            const TriangleMesh& mesh = *shown.back().meshes[0].mesh;
            QVERIFY(mesh == buildRoughBranches(skeleton, sides));
            anyAgain = mesh.triangles.capacity() > mesh.triangles.size() || anyAgain; // of a larger one
        }
        QVERIFY(anyAgain);
        const RenderScene last = std::exchange(shown, {}).back();
        builder.reset(); // what is shown outlives it
        QVERIFY(*last.meshes[0].mesh == buildRoughBranches(trees.results[id].simplified->skeleton, 10));
    }
    void removedNodesAreRed()
    {
        Trees trees;
        const NodeId id = trees.add("SmallTree");
        const TreeResult& tree = trees.results[id];
        const RenderScene built = trees.build(in(DisplayMode::Simplified));
        std::size_t red = 0;
        for (const PointItem& item : built.points) {
            for (const PointMark& mark : item.points->points)
                red += mark.colour.r > 200 && mark.colour.g < 80 ? 1u : 0u;
        }
        QCOMPARE(red, std::size_t(tree.skeleton->size() - tree.simplified->skeleton.size()));
        QCOMPARE(built.lines[0].lines->segments.size(), std::size_t(tree.simplified->skeleton.size()));
    }
    void skeletonModeNamesSimplifiedBranches()
    {
        Trees trees;
        const NodeId id = trees.add("SmallTree");
        const RenderScene built = trees.build(in(DisplayMode::Skeleton));
        const auto& segments = built.lines[0].lines->segments;
        const TreeResult& tree = trees.results[id];
        QCOMPARE(segments.size(), std::size_t(tree.skeleton->size()));
        for (std::size_t i = 0; i < segments.size(); ++i)
            QCOMPARE(segments[i].branch, tree.simplified->mergedInto[i]);
    }
    void selectedBranchesAreSeenThroughTheLeaves()
    {
        Trees trees;
        SceneView view;
        view.branchNode = trees.add();
        view.branches = {2, 5, 9999};
        const RenderScene built = trees.build(view);
        QCOMPARE(built.lines.size(), std::size_t(1));
        QVERIFY(built.lines[0].throughSurfaces && !built.lines[0].pickable);
        view.mode = DisplayMode::Skeleton;
        QCOMPARE(trees.build(view).lines.size(), std::size_t(1)); // the skeleton's own
    }
    void framesOfSelectionAndOfAll()
    {
        Trees trees;
        const NodeId id = trees.add();
        const auto arrows = [&](FrameDisplay frames, std::vector<Index> branches) {
            SceneView view;
            view.frames = frames;
            view.branchNode = id;
            view.branches = std::move(branches);
            const std::size_t with = segmentCount(trees.build(view));
            view.frames = FrameDisplay::None;
            return (with - segmentCount(trees.build(view))) / 6;
        };
        const std::size_t perBranch = trees.results[id].sections->perBranch;
        QCOMPARE(arrows(FrameDisplay::None, {0}), std::size_t(0));
        QCOMPARE(arrows(FrameDisplay::Selection, {}), std::size_t(0));
        QCOMPARE(arrows(FrameDisplay::Selection, {0, 2}), 2 * perBranch);
        QCOMPARE(arrows(FrameDisplay::All, {}), trees.results[id].simplified->skeleton.size() * perBranch);
    }
    void frameColours()
    {
        Trees trees;
        const NodeId id = trees.add();
        SceneView view;
        view.frames = FrameDisplay::Selection;
        view.branchNode = id;
        view.branches = {0};
        const RenderScene built = trees.build(view);
        const auto& segments = built.lines.back().lines->segments;
        const Frame& frame = trees.results[id].sections->of(0)[0].frame;
        const auto along = [&](std::size_t i) {
            return glm::normalize(glm::dvec3(segments[i].b) - glm::dvec3(segments[i].a));
        };
        QVERIFY(glm::length(along(0) - frame.tangent) < 1e-5 && segments[0].colour.b > 200);
        QVERIFY(glm::length(along(2) - frame.normal) < 1e-5 && segments[2].colour.r > 200);
        QVERIFY(glm::length(along(4) - frame.binormal) < 1e-5 && segments[4].colour.g > 140);
    }
    void inspectedSectionIsDrawn()
    {
        Trees trees;
        const NodeId id = trees.add();
        SceneView view;
        view.inspected = {id, 3, 1};
        const RenderScene built = trees.build(view);
        QCOMPARE(built.lines.size(), std::size_t(1));
        QVERIFY(built.lines[0].throughSurfaces && !built.lines[0].pickable);
        view.inspected = {id, 3, 99};
        QVERIFY(trees.build(view).lines.empty());
    }
    void blocksSurviveUnrelatedChanges()
    {
        Trees trees;
        const NodeId id = trees.add("SmallTree");
        SceneBuilder builder;
        for (const DisplayMode mode : {DisplayMode::Mesh, DisplayMode::Rough, DisplayMode::Simplified,
                                       DisplayMode::Sections, DisplayMode::Skeleton}) {
            const RenderScene first = builder.build(trees.scene, trees.of(), in(mode));
            trees.scene.find(id)->params.tree.translation.x += 1.0;
            SceneView view = in(mode);
            view.branchNode = id;
            view.branches = {4};
            const RenderScene second = builder.build(trees.scene, trees.of(), view);
            for (std::size_t i = 0; i < first.meshes.size(); ++i)
                QCOMPARE(first.meshes[i].mesh.get(), second.meshes[i].mesh.get());
            for (std::size_t i = 0; i < first.lines.size(); ++i)
                QCOMPARE(first.lines[i].lines.get(), second.lines[i].lines.get());
            for (std::size_t i = 0; i < first.points.size(); ++i)
                QCOMPARE(first.points[i].points.get(), second.points[i].points.get());
            QVERIFY(std::abs(second.box.min.x - first.box.min.x - 1.0) < 1e-6);
        }
    }
    void hiddenAndLocked()
    {
        Trees trees;
        const NodeId id = trees.add();
        trees.scene.find(id)->locked = true;
        QVERIFY(!trees.build(SceneView()).meshes[0].pickable);
        QVERIFY(!trees.build(in(DisplayMode::Skeleton)).lines[0].pickable);
        trees.scene.find(id)->visible = false;
        QVERIFY(trees.build(SceneView()).meshes.empty());
    }
    void highlights()
    {
        Trees trees;
        const NodeId first = trees.add();
        const NodeId second = trees.add();
        SceneView view;
        QVERIFY(trees.build(view).highlights.empty());
        view.branchNode = first;
        view.branches = {1, 2, 9999};
        view.activeBranch = 2;
        view.hoverNode = first;
        view.hoverBranches = {1};
        RenderScene built = trees.build(view);
        QCOMPARE(built.highlights.size(), std::size_t(1));
        const BranchStates& states = *built.highlights[0].states;
        QCOMPARE(states.size(), std::size_t(trees.results[first].simplified->skeleton.size()));
        QVERIFY(states[0] == BranchState::Plain && states[1] == BranchState::HoveredSelected);
        QVERIFY(states[2] == BranchState::Active);
        view.hoverNode = second;
        view.hoverBranches = {5};
        updateHighlights(built, trees.of(), view);
        QCOMPARE(built.highlights.size(), std::size_t(2));
        QVERIFY((*built.highlights[0].states)[5] == BranchState::Hovered ||
                built.highlights[0].node == first);
        view.hoverBranches.clear();
        view.hoverNodes = {second};
        updateHighlights(built, trees.of(), view);
        for (const Highlight& of : built.highlights)
            QVERIFY(of.node == first ||
                    std::ranges::all_of(*of.states, [](BranchState s) { return s == BranchState::Hovered; }));
        // A line through the leaves that goes with the highlight.
        const std::size_t lines = built.lines.size();
        view.hoverThrough = true;
        view.hoverBranches = {1};
        for (int i = 0; i < 2; ++i) {
            updateHighlights(built, trees.of(), view);
            QCOMPARE(built.lines.size(), lines + 1);
            QVERIFY(built.lines.back().throughSurfaces && !built.lines.back().pickable);
        }
        view.hoverThrough = false;
        view.hoverBranches.clear();
        updateHighlights(built, trees.of(), view);
        QCOMPARE(built.lines.size(), lines);
        view.hoverNodes = {first, 77}; // what is selected stays so, and an object has no branches
        updateHighlights(built, trees.of(), view);
        QVERIFY(built.highlights[0].node == 77 && built.highlights[0].whole);
        QVERIFY(built.highlights[1].node == first && !built.highlights[1].whole);
        QVERIFY((*built.highlights[1].states)[2] == BranchState::HoveredSelected);
        view.hoverNodes.clear();
        view.hoverBranches = {9999};
        view.branches.clear();
        updateHighlights(built, trees.of(), view);
        for (const Highlight& of : built.highlights)
            QVERIFY(std::ranges::all_of(*of.states, [](BranchState s) { return s == BranchState::Plain; }));
    }
    void selectedNodesAreOutlinedWithAllBelow()
    {
        Trees trees;
        Node group;
        group.id = trees.scene.newId();
        QVERIFY(trees.scene.insert({group}, noNode, 0));
        const NodeId tree = trees.add();
        QVERIFY(trees.scene.move(tree, group.id, 0));
        const NodeId other = trees.add();
        for (const NodeId selected : {group.id, tree}) {
            SceneView view;
            view.selectedNodes = {selected};
            for (const MeshItem& item : trees.build(view).meshes) {
                QCOMPARE(item.outlined != nullptr, item.node == tree);
                QVERIFY(item.node == other || (!item.outlined->ofBranches && !item.outlined->box.empty()));
            }
            view.mode = DisplayMode::Skeleton;
            for (const LineItem& item : trees.build(view).lines)
                QVERIFY(item.outlined == (item.node == tree ? OutlinedLines::All : OutlinedLines::None));
        }
    }
    /// Twigs do not melt into a blob, and nothing is left out that would leave a gap.
    void whatHasNoCrownIsOutlinedAsItIs()
    {
        Trees trees;
        SceneView view;
        view.selectedNodes = {trees.add()};
        view.leaves = view.apples = false;
        RenderScene built = trees.build(view);
        std::erase_if(built.meshes, [](const MeshItem& item) { return item.node == noNode; });
        QVERIFY(!built.meshes.empty());
        for (const MeshItem& item : built.meshes)
            QVERIFY(item.outlined && item.outlined->runs.empty());
        Camera camera;
        camera.frame(built.box, 1.0);
        const auto bare = outlineExtent(built, camera, {400.0f, 400.0f});
        QVERIFY(bare && bare->coarse && !bare->dense);
        view.leaves = view.apples = true;
        const auto leafy = outlineExtent(trees.build(view), camera, {400.0f, 400.0f});
        QVERIFY(leafy && leafy->coarse && leafy->dense);
    }
    void selectedBranchesAreOutlined()
    {
        Trees trees;
        SceneView view;
        view.branchNode = trees.add();
        view.selectedNodes = {view.branchNode};
        view.branches = {2, 5, 9999};
        const RenderScene built = trees.build(view);
        for (const MeshItem& item : built.meshes) {
            QCOMPARE(item.outlined != nullptr, item.material.name == "bark");
            if (!item.outlined)
                continue;
            QVERIFY(item.outlined->ofBranches);
            std::vector<bool> inside(item.mesh->faceCount(), false);
            for (const auto& [first, count] : item.outlined->runs)
                std::fill_n(inside.begin() + first, count, true);
            for (Index f = 0; f < item.mesh->faceCount(); ++f) {
                bool wanted = false;
                for (int corner = 0; corner < 3; ++corner) {
                    const Index branch = item.mesh->branch[item.mesh->triangles[f][corner]];
                    wanted = wanted || branch == 2 || branch == 5;
                }
                QCOMPARE(bool(inside[f]), wanted);
            }
        }
        QVERIFY(built.lines[0].outlined == OutlinedLines::All); // their curves
        view.mode = DisplayMode::Skeleton;
        QVERIFY(trees.build(view).lines[0].outlined == OutlinedLines::Selected);
    }
    /// The large faces, wherever they stand, and some of all the others.
    void outlinesOfLargeMeshesAreSampled()
    {
        constexpr Index count = 200'000, large = 77'000;
        TriangleMesh mesh;
        for (Index f = 0; f < count; ++f) {
            const auto first = static_cast<Index>(mesh.positions.size());
            const float size = f >= large && f < large + 1000 ? 1.0f : 0.01f;
            for (const glm::vec3& corner : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
                mesh.positions.push_back(size * corner);
            mesh.triangles.emplace_back(first, first + 1, first + 2);
        }
        const DeferredMesh::Pointer whole(DeferredMesh::Pointer(), &mesh);
        QVERIFY(outlinedWhole(whole, Box(), 0).runs.empty());
        QVERIFY(outlinedWhole(whole, Box(), count).runs.empty());
        std::vector<bool> kept(count, false);
        for (const auto& [first, run] : outlinedWhole(whole, Box(), 40'000).runs)
            std::fill_n(kept.begin() + first, run, true);
        const auto faces = std::ranges::count(kept, true);
        QVERIFY(faces > 30'000 && faces <= 41'000);
        QVERIFY(std::all_of(kept.begin() + large, kept.begin() + large + 1000, [](bool is) { return is; }));
        for (Index from = 0; from < count; from += 2000)
            QVERIFY(std::count(kept.begin() + from, kept.begin() + from + 2000, true) > 0);
    }
    void foreignMeshGetsNormals()
    {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}};
        const RenderScene scene = sceneOfMesh(mesh);
        QCOMPARE(scene.meshes[0].mesh->normals.size(), std::size_t(3));
        QCOMPARE(scene.box.max, glm::dvec3(1, 1, 0));
        QVERIFY(sceneOfMesh({}).box.empty());
    }
};

RAMURE_SUITE(TestSceneBuilder)

} // namespace tst_scene_builder

#include "tst_scene_builder.moc"
