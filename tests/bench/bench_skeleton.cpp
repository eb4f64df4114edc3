// Grammar (per output symbol), turtle (per branch), simplification (per input branch).
#include "core/generators/colonisation/colonisation.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/parametric/module_turtle.h"
#include "core/generators/weber_penn/weber_penn.h"
#include "core/math/random.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_context.h"
#include "core/presets/presets.h"
#include "core/scene/growth_spaces.h"
#include "core/skeleton/edit_places.h"
#include "tests/bench/bench_trees.h"
#include "tests/support/book_trees.h"
#include <benchmark/benchmark.h>
#include <cmath>

using namespace ramure;

namespace {

const char* const presetNames[] = {"SmallTree", "FanTree", "Fern2D"};
const int presetIterations[] = {12, 11, 7};

bench::Growth growth(const benchmark::State& state)
{
    const auto which = static_cast<std::size_t>(state.range(0));
    return {presetNames[which], presetIterations[which]};
}

void label(benchmark::State& state, std::size_t items)
{
    const auto which = static_cast<std::size_t>(state.range(0));
    state.SetLabel(std::string(presetNames[which]) + " x " + std::to_string(presetIterations[which]));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * items));
}

void BM_grammar(benchmark::State& state)
{
    const bench::Growth tree = growth(state);
    std::size_t size = 0;
    for (auto _ : state) {
        const auto symbols = rewrite(tree.grammar, tree.options);
        size = symbols->size();
        benchmark::DoNotOptimize(symbols->data());
    }
    label(state, size);
}
BENCHMARK(BM_grammar)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

/// The aspen of the paper, about 1,500 stems.
void BM_weberPenn(benchmark::State& state)
{
    for (auto _ : state) {
        const auto skeleton = growWeberPenn({}, 1);
        benchmark::DoNotOptimize(skeleton->parent.data());
    }
}
BENCHMARK(BM_weberPenn)->Unit(benchmark::kMicrosecond);

/// 24,000 points.
void BM_colonisation(benchmark::State& state)
{
    ColonisationParams params;
    params.points = 24'000;
    params.kill = 0.15;
    params.step = 0.08;
    params.influence = 0.8;
    for (auto _ : state) {
        const auto skeleton = growColonisation(params, 1);
        benchmark::DoNotOptimize(skeleton->parent.data());
    }
}
BENCHMARK(BM_colonisation)->Unit(benchmark::kMillisecond);

/// Years; 1: with internodes so short and a crown so dense that a quarter of a million metamers are born.
void BM_growHistory(benchmark::State& state)
{
    GrowthParams params;
    params.age = double(state.range(0));
    if (state.range(1) == 1) {
        params.density = 10.0;
        params.internode = 0.15;
    }
    std::size_t born = 0;
    for (auto _ : state) {
        const auto history = growHistory(params, 1);
        born = history->size();
        benchmark::DoNotOptimize(history->parent.data());
    }
    state.counters["born"] = double(born);
}
BENCHMARK(BM_growHistory)->Args({30, 0})->Args({80, 0})->Args({28, 1})->Unit(benchmark::kMillisecond);

/// Between two years.
void BM_skeletonAtAge(benchmark::State& state)
{
    GrowthParams params;
    params.age = 40.0;
    const auto history = growHistory(params, 1);
    for (auto _ : state) {
        const Skeleton skeleton = skeletonAtAge(*history, 32.4);
        benchmark::DoNotOptimize(skeleton.parent.data());
        state.counters["axes"] = double(skeleton.axisStarts.size());
    }
}
BENCHMARK(BM_skeletonAtAge)->Unit(benchmark::kMillisecond);

void BM_grammarByChance(benchmark::State& state)
{
    bench::Growth tree = growth(state);
    tree.options.stochastic = true;
    std::size_t size = 0;
    for (auto _ : state) {
        const auto symbols = rewrite(tree.grammar, tree.options);
        size = symbols->size();
        benchmark::DoNotOptimize(symbols->data());
    }
    label(state, size);
}
BENCHMARK(BM_grammarByChance)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);

void BM_turtle(benchmark::State& state)
{
    const bench::Growth tree = growth(state);
    const std::string symbols = tree.symbols();
    std::size_t branches = 0;
    for (auto _ : state) {
        const auto skeleton = runTurtle(symbols, tree.params.turtle);
        branches = skeleton->size();
        benchmark::DoNotOptimize(skeleton->p1.data());
    }
    label(state, branches);
}
BENCHMARK(BM_turtle)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

void BM_simplify(benchmark::State& state)
{
    const Skeleton skeleton = growth(state).skeleton();
    for (auto _ : state) {
        const SimplifiedSkeleton simplified = simplify(skeleton, 1e-4);
        benchmark::DoNotOptimize(simplified.skeleton.p1.data());
    }
    label(state, skeleton.size());
}
BENCHMARK(BM_simplify)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

/// The tree of the book's figure 2.6, rewriting and turtle: what one module of the last round costs.
void BM_parametric(benchmark::State& state)
{
    const NodeParams params = test::bookTrees[0].params(static_cast<int>(state.range(0)));
    std::size_t modules = 0;
    for (auto _ : state) {
        const auto grammar = bench::need(parseParametric(params.grammar));
        const ModuleWord word = bench::need(derive(grammar, {static_cast<int>(state.range(0))}));
        const Skeleton skeleton = bench::need(runModuleTurtle(word, params.turtle, {{0.0, 0.0, 0.0}, 1}));
        modules = word.modules.size();
        benchmark::DoNotOptimize(skeleton.p1.data());
    }
    state.SetLabel(std::to_string(modules) + " modules");
    state.counters["ns/module"] =
        benchmark::Counter(1e-9 * static_cast<double>(modules),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_parametric)->DenseRange(10, 16, 3)->Unit(benchmark::kMicrosecond);

/// A thousand edits on ten thousand axes after a twig has come in front: none is where its address says.
void BM_editPlaces(benchmark::State& state)
{
    bench::Growth tree("SmallTree", 11);
    const Skeleton before = tree.skeleton();
    const TreeAxes axes = axesOf(before);
    const std::uint64_t mark = treeMark(axes);
    Random random(1, RandomStream::Test);
    std::vector<BranchPlace> places;
    for (int i = 0; i < 1000; ++i)
        places.push_back(placeOf(axes, random.below(before.size()), mark));
    std::vector<const BranchPlace*> asked;
    for (const BranchPlace& place : places)
        asked.push_back(&place);
    tree.grammar = bench::need(parseGrammar("BB[+B]" + tree.params.grammar.axiom, tree.params.grammar.rules));
    const Skeleton after = tree.skeleton();
    for (auto _ : state) {
        const auto found = findPlaces(axesOf(after), asked);
        benchmark::DoNotOptimize(found.data());
    }
    state.SetLabel(std::to_string(axes.axes.size()) + " axes");
}
BENCHMARK(BM_editPlaces)->Unit(benchmark::kMillisecond);

/// One edit of a limb in a tree of about 10,000 branches, as a drag makes it again and again: axes of the
/// tree as grown are kept from one time to the next.
void BM_editOfOneLimb(benchmark::State& state)
{
    const Skeleton grown = bench::Growth("SmallTree", 10).skeleton();
    const auto known = std::make_shared<const TreeAxes>(axesOf(grown));
    const TreeAxes& axes = *known;
    const EditContext context(grown, {});
    TreeEdit edit;
    edit.operation = static_cast<EditOperation>(state.range(0));
    edit.target.address = axes.axes[axes.axes.size() / 2].address;
    edit.other.address = axes.axes.back().address;
    edit.id = 1;
    edit.points = {{glm::dvec3(0.5, 1.0, 0.0), 0.01}, {glm::dvec3(1.0, 1.5, 0.5), 0.01}};
    edit.rotation = {0.1, 0.2, 0.0};
    edit.shape.numbers = {0.0, 2.0, 0.0, 1.0, 0.0, 0.0};
    edit = bench::need(context.prepared(edit, true));
    for (auto _ : state) {
        const Skeleton edited = EditContext(grown, {&edit, 1}, known).skeleton();
        benchmark::DoNotOptimize(edited.parent.data());
    }
    state.SetLabel(std::string(infoOf(edit.operation).key) + ", " + std::to_string(grown.size()) +
                   " branches");
}
BENCHMARK(BM_editOfOneLimb)
    ->Arg(int(EditOperation::Cut))
    ->Arg(int(EditOperation::Curl))
    ->Arg(int(EditOperation::Draw))
    ->Arg(int(EditOperation::Graft))
    ->Arg(int(EditOperation::Prune))
    ->Arg(int(EditOperation::Place))
    ->Unit(benchmark::kMicrosecond);

/// From the number that a hand changes to what the view draws while it drags, in a tree of about 10,000
/// branches.
void BM_draftOfAnEdit(benchmark::State& state)
{
    NodeParams params = *presetParams("SmallTree");
    params.grammar.iterations = 10;
    if (state.range(0) == 0)
        params.foliage.leavesCutoff = 0.0;
    TreePipeline pipeline;
    const TreeResult tree = bench::need(pipeline.evaluate(params, Stage::Skeleton));
    const TreeAxes axes = axesOf(*tree.skeleton);
    TreeEdit edit;
    edit.operation = EditOperation::Length;
    edit.target.address = axes.axes[axes.axes.size() / 2].address;
    edit.id = 1;
    params.edits = {bench::need(EditContext(*tree.grown, {}).prepared(edit, true))};
    for (auto _ : state) {
        params.edits.front().factor *= 1.0001;
        const TreeResult draft = bench::need(pipeline.evaluateDraft(params));
        benchmark::DoNotOptimize(draft.draftTubes.get());
    }
    state.SetLabel(std::to_string(tree.skeleton->size()) + " branches, " +
                   (state.range(0) == 0 ? "bare" : "in leaf"));
}
BENCHMARK(BM_draftOfAnEdit)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

/// From the press of the saw to the draft without what it cut, in a tree of about 10,000 axes with a thousand
/// edits: the tree at work is the kept result of the last step.
void BM_pressAfterThousandEdits(benchmark::State& state)
{
    NodeParams params = *presetParams("SmallTree");
    params.grammar.iterations = 11;
    params.foliage.leavesCutoff = 0.0;
    TreePipeline pipeline;
    const TreeResult grown = bench::need(pipeline.evaluate(params, Stage::Skeleton));
    const TreeAxes axes = axesOf(*grown.skeleton);
    const auto count = static_cast<std::uint32_t>(axes.axes.size());
    const EditContext plain = contextOf(grown, params);
    Random random(1, RandomStream::Test);
    TreeEdit edit;
    edit.operation = EditOperation::Length;
    while (params.edits.size() < 1000) {
        edit.target.address = axes.axes[random.below(count)].address;
        edit.factor = random.range(0.9, 1.1);
        params.edits.push_back(bench::need(plain.prepared(edit, true)));
        params.edits.back().id = params.edits.size();
    }
    const TreeResult before = bench::need(pipeline.evaluateDraft(params));
    edit.operation = EditOperation::Cut;
    edit.id = 5000;
    for (auto _ : state) {
        edit.target.address = axes.axes[random.below(count)].address;
        NodeParams after = params;
        after.edits.push_back(bench::need(contextOf(before, params).prepared(edit, true)));
        const TreeResult draft = bench::need(pipeline.evaluateDraft(after));
        benchmark::DoNotOptimize(draft.draftTubes.get());
    }
    state.SetLabel(std::to_string(count) + " axes");
}
BENCHMARK(BM_pressAfterThousandEdits)->Unit(benchmark::kMillisecond);

/// What a tool does when it is pressed.
void BM_editContext(benchmark::State& state)
{
    const Skeleton grown = bench::Growth("SmallTree", 10).skeleton();
    for (auto _ : state) {
        const EditContext context(grown, {});
        benchmark::DoNotOptimize(context.has(1));
    }
    state.SetLabel(std::to_string(grown.size()) + " branches");
}
BENCHMARK(BM_editContext)->Unit(benchmark::kMicrosecond);

/// What the interface's thread does when a rock is moved under a tree with roots, by triangles of the rock.
void BM_rockUnderATree(benchmark::State& state)
{
    const auto side = static_cast<std::uint32_t>(std::sqrt(double(state.range(0)) / 2.0));
    TriangleMesh rock;
    for (std::uint32_t z = 0; z <= side; ++z)
        for (std::uint32_t x = 0; x <= side; ++x)
            rock.positions.emplace_back(4.0f * float(x) / float(side) - 2.0f, 0.0f,
                                        4.0f * float(z) / float(side) - 2.0f);
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = z * (side + 1) + x, b = a + side + 1;
            rock.triangles.emplace_back(a, b, a + 1);
            rock.triangles.emplace_back(a + 1, b, b + 1);
        }
    Node tree, stone;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.params = bench::need(presetParams("EnglishOak"));
    stone.id = 2;
    stone.kind = NodeKind::Mesh;
    stone.mesh = SharedValue<TriangleMesh>(std::move(rock));
    stone.params.growthRole = GrowthRole::Obstacle;
    Scene scene = bench::need(Scene::fromNodes({tree, stone}));
    for (auto _ : state) {
        scene.find(2)->params.tree.translation.y += 1e-4;
        linkGrowthSpaces(scene);
    }
}
BENCHMARK(BM_rockUnderATree)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);

} // namespace
