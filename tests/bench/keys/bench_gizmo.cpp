// One move of the mouse while nodes are dragged by the gizmo, with all of the window following: what the
// interface's thread does for it, the picture's drawing apart.
#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/demo_scenes.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/scene_builder.h"
#include "widgets/view/tools/gizmo/gizmo_drag.h"
#include "widgets/window/main_window.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

struct Editor
{
    explicit Editor(Scene scene)
    {
        window.resize(1600, 900);
        window.show();
        (void)QTest::qWaitForWindowExposed(&window);
        document.reset(std::move(scene), {});
        settle();
    }
    void settle()
    {
        (void)recompute.waitForFull(60'000);
        QCoreApplication::processEvents();
    }
    void select(bool all)
    {
        std::vector<NodeId> nodes;
        for (const Node& node : document.scene().nodes())
            if (all || nodes.empty())
                nodes.push_back(node.id);
        document.setSelection({std::move(nodes), noNode, {}, noIndex});
        QCoreApplication::processEvents();
    }

    test::OwnSettings settings;
    Preferences preferences;
    Document document;
    Recompute recompute{&document};
    test::FakeChooser chooser;
    MainWindow window{&document, &recompute, &preferences, &chooser};
};

Scene smallTree()
{
    Scene scene;
    Node node;
    node.id = scene.newId();
    node.kind = NodeKind::Tree;
    node.name = "SmallTree";
    node.params = *presetParams("SmallTree");
    [[maybe_unused]] const auto done = scene.insert({node}, noNode, 0);
    return scene;
}

void drag(benchmark::State& state, Scene scene, bool all, bool keys)
{
    Editor editor(std::move(scene));
    editor.select(all);
    GizmoSettings how;
    PickView view;
    view.size = {1200.0, 800.0};
    glm::dvec2 hand(600.0, 400.0);
    const auto tool = static_cast<TransformTool>(state.range(0));
    auto gesture = GizmoDrag::begin(editor.document, how, tool, std::nullopt, 0.5, keys, view, hand);
    double way = 0.0;
    for (auto _ : state) {
        way = way > 200.0 ? 1.0 : way + 3.0;
        gesture->moveTo(view, hand + glm::dvec2(way, 0.5 * way), {});
        QCoreApplication::processEvents();
    }
    state.counters["nodes"] = double(editor.document.selection().nodes.size());
    gesture->cancel();
    gesture.reset();
    editor.settle();
}

void dragSmallTree(benchmark::State& state)
{
    drag(state, smallTree(), false, false);
}
BENCHMARK(dragSmallTree)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

/// The group above all cylinders.
void dragMovingTreeRoot(benchmark::State& state)
{
    drag(state, *demoScene("MovingTree"), false, false);
}
BENCHMARK(dragMovingTreeRoot)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

/// All selected: those below others go along with them.
void dragMovingTreeAll(benchmark::State& state)
{
    drag(state, *demoScene("MovingTree"), true, false);
}
BENCHMARK(dragMovingTreeAll)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

/// With keys at the playhead.
void dragMovingTreeWithKeys(benchmark::State& state)
{
    drag(state, *demoScene("MovingTree"), true, true);
}
BENCHMARK(dragMovingTreeWithKeys)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

/// 1,365 cylinders side by side: nothing goes along with anything.
Scene cylinders()
{
    Scene scene;
    std::vector<Node> nodes;
    for (int i = 0; i < 1365; ++i) {
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Primitive;
        node.name = std::string("Cylinder ").append(std::to_string(i));
        node.params.tree.translation = {0.3 * (i % 40), 0.0, 0.3 * (i / 40)};
        nodes.push_back(node);
    }
    for (const Node& node : nodes)
        [[maybe_unused]] const auto done = scene.insert({node}, noNode, 1 << 20);
    return scene;
}

void dragManyCylinders(benchmark::State& state)
{
    drag(state, cylinders(), true, false);
}
BENCHMARK(dragManyCylinders)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

/// What the picture is made of then, on the background's thread.
void buildMovingTree(benchmark::State& state)
{
    const Scene scene = *demoScene("MovingTree");
    SceneBuilder builder;
    SceneView view;
    for (auto _ : state) {
        view.timeSeconds = view.timeSeconds > 4.0 ? 0.0 : view.timeSeconds + 0.04;
        benchmark::DoNotOptimize(builder.build(
            scene, [](NodeId) { return nullptr; }, view));
    }
}
BENCHMARK(buildMovingTree)->Unit(benchmark::kMillisecond);

} // namespace
