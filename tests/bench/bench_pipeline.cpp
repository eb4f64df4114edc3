// End to end: from parameters to the checked mesh, nothing in the cache, on one thread and on two.
#include "core/base/parallel.h"
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

} // namespace
