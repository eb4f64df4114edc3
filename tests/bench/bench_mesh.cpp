/// \file
/// The branch mesh and its check on the SmallTree (argument: iterations of its grammar). Items are triangles.

#include "core/mesh/branch_mesh.h"
#include "core/mesh/normals.h"
#include "core/mesh/validate.h"
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

void BM_BranchMesh(benchmark::State& state, const char* preset)
{
    const Skeleton skeleton = skeletonOf(state, {preset, static_cast<int>(state.range(0))});
    TriangleMesh mesh;
    for (auto _ : state) {
        Expected<BranchMesh> built = meshOf(skeleton);
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

BENCHMARK_CAPTURE(BM_BranchMesh, SmallTree, "SmallTree")->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_BranchMesh, FanTree, "FanTree")->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_BranchMesh, Fern2D, "Fern2D")->Arg(5)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ValidateMesh)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ConfirmWithOpenMesh)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Normals)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

} // namespace
