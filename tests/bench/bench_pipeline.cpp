// End to end: from parameters to the checked mesh, nothing in the cache, on one thread and on two.
#include "core/base/parallel.h"
#include "core/evaluate/evaluator.h"
#include "core/pipeline/tree_pipeline.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

/// Arguments: iterations, threads, and whether leaves and apples are made too. Two trees take turns that
/// differ by one piece of trunk: nothing is found in the cache, but memory is used again, as when a slider is
/// moved.
void BM_pipeline(benchmark::State& state)
{
    NodeParams params = bench::need(presetParams("SmallTree"));
    params.grammar.iterations = state.range(0);
    const ThreadLimit limit(static_cast<unsigned>(state.range(1)));
    const Stage last = state.range(2) != 0 ? Stage::Foliage : Stage::Mesh;
    TreePipeline pipeline;
    pipeline.setCacheSize(1);
    std::size_t count = 0;
    const auto rebuild = [&] {
        params.grammar.axiom = params.grammar.axiom == "BBBBBA" ? "BBBBBBA" : "BBBBBA";
        const TreeResult tree = bench::need(pipeline.evaluate(params, last));
        count = tree.branches->mesh.triangles.size();
    };
    for (int i = 0; i < 8; ++i) // until no rebuild takes fresh memory any more
        rebuild();
    for (auto _ : state)
        rebuild();
    state.counters["triangles"] = static_cast<double>(count);
    state.SetLabel("SmallTree, items = triangles");
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}
BENCHMARK(BM_pipeline)
    ->ArgNames({"iterations", "threads", "leaves"})
    ->Args({8, 1, 1})
    ->Args({12, 1, 0})
    ->Args({12, 2, 0})
    ->Args({12, 1, 1})
    ->Args({12, 2, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Days of one tree of a year, nothing of which is in the cache; argument: a second of its motion too.
void BM_dayOfYear(benchmark::State& state)
{
    Scene scene;
    Node tree;
    tree.id = 1;
    tree.params = bench::need(presetParams("EnglishOak"));
    const ThreadLimit limit(2);
    TreePipeline pipeline;
    pipeline.setCacheSize(1);
    Evaluator evaluator(pipelineSource(pipeline));
    double day = 100.0;
    std::size_t count = 0;
    const auto next = [&] {
        day = day >= 320.0 ? 100.0 : day + 1.0;
        tree.params.season.day = day;
        if (state.range(0) == 0)
            count = bench::need(pipeline.evaluate(tree.params)).placed->leaves.size();
        else
            benchmark::DoNotOptimize(bench::need(evaluator.posedTree(tree, Stage::Foliage, 0.04, true)));
    };
    next();
    for (auto _ : state)
        next();
    state.counters["leaves"] = static_cast<double>(count);
}
BENCHMARK(BM_dayOfYear)
    ->ArgName("moves")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(60)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
