/// \file
/// Texture coordinates of the presets' branch meshes. Items are triangles.

#include "core/surface/check/texture_report.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

void BM_TextureCoordinates(benchmark::State& state, const char* preset, int iterations)
{
    BranchMeshOptions options;
    options.lengthDivisions = static_cast<int>(state.range(0));
    const BranchMesh mesh =
        bench::need(buildBranchMesh(bench::Growth(preset, iterations).simplified(), options));
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::need(textureCoordinates(mesh, {})).uv.data());
    const double triangles = static_cast<double>(mesh.mesh.faceCount());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.mesh.faceCount()));
    state.counters["triangles"] = triangles;
    state.counters["s/triangle"] = benchmark::Counter(
        triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(BM_TextureCoordinates, SmallTree, "SmallTree", 8)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_TextureCoordinates, FanTree, "FanTree", 8)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_TextureCoordinates, TinyTree, "TinyTree", 0) // done again with more care
    ->Arg(4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_TextureCoordinates, Fern2D, "Fern2D", 5)->Arg(4)->Unit(benchmark::kMillisecond);

} // namespace
