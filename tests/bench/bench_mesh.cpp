/// \file
/// The branch mesh and its check on the SmallTree (iterations of its grammar). Items are triangles.

#include "core/base/parallel.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "tests/support/preset_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

struct Tree
{
    const char* preset = "SmallTree";
    int iterations = 8;
};

Expected<BranchMesh> meshOf(const Skeleton& skeleton)
{
    return buildBranchMesh(skeleton, {});
}

/// The skeleton to measure on, or an empty one after the state has been told why.
Skeleton skeletonOf(benchmark::State& state, const Tree& tree)
{
    test::PresetTree wanted{tree.preset};
    wanted.iterations = tree.iterations;
    Expected<Skeleton> skeleton = test::presetSkeleton(wanted);
    if (!skeleton) {
        state.SkipWithError(skeleton.error().message().c_str());
        return {};
    }
    return std::move(*skeleton);
}

/// Counts triangles as items, and says nanoseconds for one: the unit of the bars.
void perTriangle(benchmark::State& state, const TriangleMesh& mesh)
{
    const double triangles = static_cast<double>(mesh.faceCount());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.faceCount()));
    state.counters["triangles"] = triangles;
    state.counters["s/triangle"] = benchmark::Counter(
        triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Arguments: iterations of the grammar, threads (0 = all).
void BM_BranchMesh(benchmark::State& state, const char* preset)
{
    const Skeleton skeleton = skeletonOf(state, {preset, static_cast<int>(state.range(0))});
    const ThreadLimit limit(static_cast<unsigned>(state.range(1)));
    TriangleMesh mesh;
    BranchMeshOptions options;
    options.withNormals = false; // a stage of their own
    for (auto _ : state) {
        Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
        if (!built)
            return state.SkipWithError(built.error().message().c_str());
        benchmark::DoNotOptimize(mesh = std::move(built->mesh));
    }
    perTriangle(state, mesh);
}

/// Arguments: triangles wanted, threads.
void BM_MeshBudget(benchmark::State& state, const char* preset)
{
    const Skeleton skeleton = skeletonOf(state, {preset, static_cast<int>(state.range(0))});
    const ThreadLimit limit(static_cast<unsigned>(state.range(2)));
    BranchMeshOptions options;
    options.targetTriangles = static_cast<Index>(state.range(1));
    TriangleMesh mesh;
    for (auto _ : state) {
        Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
        if (!built)
            return state.SkipWithError(built.error().message().c_str());
        benchmark::DoNotOptimize(mesh = std::move(built->mesh));
    }
    perTriangle(state, mesh);
}

template <class Work> void onMesh(benchmark::State& state, const Work& work)
{
    const Skeleton skeleton = skeletonOf(state, {"SmallTree", static_cast<int>(state.range(0))});
    Expected<BranchMesh> built = meshOf(skeleton);
    if (!built)
        return state.SkipWithError(built.error().message().c_str());
    for (int i = 0; i < 4; ++i) // until no round takes fresh memory any more
        work(built->mesh);
    for (auto _ : state)
        work(built->mesh);
    perTriangle(state, built->mesh);
}

void BM_ValidateMesh(benchmark::State& state)
{
    onMesh(state, [](const TriangleMesh& mesh) { benchmark::DoNotOptimize(validateMesh(mesh)); });
}

void BM_ConfirmWithOpenMesh(benchmark::State& state)
{
    onMesh(state, [](const TriangleMesh& mesh) {
        MeshReport report;
        benchmark::DoNotOptimize(confirmWithOpenMesh(mesh, report));
    });
}

void BM_Normals(benchmark::State& state)
{
    onMesh(state, [](TriangleMesh& mesh) {
        computeNormals(mesh);
        benchmark::DoNotOptimize(mesh.normals.data());
    });
}

// Time of all threads together; the clock beside it says what they save.
void onThreads(benchmark::internal::Benchmark* bench, std::initializer_list<int> iterations)
{
    for (const int i : iterations)
        for (const int threads : {1, 2})
            bench->Args({i, threads});
    bench->ArgNames({"iterations", "threads"})->Unit(benchmark::kMillisecond);
    bench->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK_CAPTURE(BM_BranchMesh, SmallTree, "SmallTree")->Apply([](auto* b) {
    onThreads(b, {8, 10, 12, 14});
});
BENCHMARK_CAPTURE(BM_BranchMesh, FanTree, "FanTree")->Apply([](auto* b) { onThreads(b, {8}); });
BENCHMARK_CAPTURE(BM_BranchMesh, Fern2D, "Fern2D")->Apply([](auto* b) { onThreads(b, {5}); });
BENCHMARK_CAPTURE(BM_MeshBudget, SmallTree, "SmallTree")
    ->ArgNames({"iterations", "budget", "threads"})
    ->Args({8, 100'000, 1})
    ->Args({8, 1'000'000, 1})
    ->Args({8, 1'000'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(BM_ValidateMesh)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ConfirmWithOpenMesh)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Normals)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

} // namespace
