// End to end: from parameters to the checked mesh with its leaves, nothing in the cache.
#include "core/pipeline/tree_pipeline.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

void BM_pipeline(benchmark::State& state)
{
    NodeParams params = bench::need(presetParams("SmallTree"));
    params.grammar.iterations = state.range(0);
    std::size_t count = 0;
    for (auto _ : state) {
        const TreeResult tree = bench::need(TreePipeline().evaluate(params));
        count = tree.branches->mesh.triangles.size();
    }
    state.SetLabel("SmallTree, items = triangles");
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}
BENCHMARK(BM_pipeline)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

} // namespace
