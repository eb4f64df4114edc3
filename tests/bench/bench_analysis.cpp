// The analysis of a finished mesh, per triangle: pairs that run through each other (one thread and two),
// triangle quality, hash.
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

struct Sample
{
    Skeleton skeleton;
    BranchMesh branches;
    std::vector<Index> parents;

    explicit Sample(int iterations)
        : skeleton(bench::Growth("SmallTree", iterations).simplified())
        , branches(bench::need(buildBranchMesh(skeleton, {})))
        , parents(repairedParents(skeleton, branches.repairs))
    {
    }
    [[nodiscard]] std::int64_t faces() const { return branches.mesh.faceCount(); }
};

void BM_selfIntersections(benchmark::State& state)
{
    const Sample sample(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::need(findSelfIntersections(sample.branches.mesh, sample.parents,
                                                                   static_cast<unsigned>(state.range(1)))));
    state.SetItemsProcessed(state.iterations() * sample.faces());
}
BENCHMARK(BM_selfIntersections)
    ->Args({8, 1})
    ->Args({8, 2})
    ->Args({11, 1})
    ->Args({11, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void BM_triangleQuality(benchmark::State& state)
{
    const Sample sample(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::need(measureQuality(sample.branches.mesh, 1)));
    state.SetItemsProcessed(state.iterations() * sample.faces());
}
BENCHMARK(BM_triangleQuality)->Arg(8)->Arg(11)->Unit(benchmark::kMillisecond);

void BM_meshHash(benchmark::State& state)
{
    const Sample sample(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(meshHash(sample.branches.mesh));
    state.SetItemsProcessed(state.iterations() * sample.faces());
}
BENCHMARK(BM_meshHash)->Arg(8)->Arg(11)->Unit(benchmark::kMillisecond);

} // namespace
