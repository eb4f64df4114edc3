// Sections (per ring vertex), rough model and branch mesh (per triangle), normals (per triangle), foliage
// (per leaf).
#include "core/geometry/sections.h"
#include "core/mesh/branch_mesh.h"
#include "core/mesh/foliage.h"
#include "core/mesh/normals.h"
#include "core/mesh/rough_model.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

const Skeleton& smallTree()
{
    static const Skeleton skeleton = bench::Growth("SmallTree", 12).simplified();
    return skeleton;
}

void items(benchmark::State& state, std::size_t count)
{
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}

void BM_sections(benchmark::State& state)
{
    std::size_t count = 0;
    for (auto _ : state) {
        const SectionSet set = buildSections(smallTree(), 4);
        const std::vector<glm::vec3> rings = sectionRings(set, 8);
        count = rings.size();
        benchmark::DoNotOptimize(rings.data());
    }
    items(state, count);
}
BENCHMARK(BM_sections)->Unit(benchmark::kMillisecond);

void BM_roughModel(benchmark::State& state)
{
    std::size_t count = 0;
    for (auto _ : state) {
        const TriangleMesh mesh = buildRoughBranches(smallTree(), 8);
        count = mesh.triangles.size();
        benchmark::DoNotOptimize(mesh.positions.data());
    }
    items(state, count);
}
BENCHMARK(BM_roughModel)->Unit(benchmark::kMillisecond);

void BM_branchMesh(benchmark::State& state)
{
    std::size_t count = 0;
    for (auto _ : state) {
        const BranchMesh mesh = bench::need(buildBranchMesh(smallTree(), {}));
        count = mesh.mesh.triangles.size();
        benchmark::DoNotOptimize(mesh.mesh.positions.data());
    }
    items(state, count);
}
BENCHMARK(BM_branchMesh)->Unit(benchmark::kMillisecond);

void BM_normals(benchmark::State& state)
{
    TriangleMesh mesh = bench::need(buildBranchMesh(smallTree(), {})).mesh;
    for (auto _ : state) {
        computeNormals(mesh);
        benchmark::DoNotOptimize(mesh.normals.data());
    }
    items(state, mesh.triangles.size());
}
BENCHMARK(BM_normals)->Unit(benchmark::kMillisecond);

void BM_foliage(benchmark::State& state)
{
    std::size_t count = 0;
    for (auto _ : state) {
        const Foliage foliage = bench::need(placeFoliage(smallTree(), FoliageParams(), 0.2));
        const TriangleMesh leaves = buildLeaves(smallTree(), foliage, 0.2, FoliageModel::Fine);
        const TriangleMesh apples = buildApples(smallTree(), foliage, 0.2, FoliageModel::Fine);
        count = foliage.leaves.size();
        benchmark::DoNotOptimize(leaves.positions.data());
        benchmark::DoNotOptimize(apples.positions.data());
    }
    items(state, count);
}
BENCHMARK(BM_foliage)->Unit(benchmark::kMillisecond);

} // namespace
