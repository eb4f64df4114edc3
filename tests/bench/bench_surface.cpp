// Sections (per ring vertex), rough model and branch mesh (per triangle), normals (per triangle), foliage
// (per leaf), bark (per family).
#include "core/base/parallel.h"
#include "core/skeleton/sections.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesher/rough_model.h"
#include "core/surface/season/crown_place.h"
#include "core/surface/season/foliage_on_day.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

/// \param state its argument is the number of iterations: the 8 of the preset fit the cache, 12 do not
Skeleton smallTree(const benchmark::State& state)
{
    return bench::Growth("SmallTree", static_cast<int>(state.range(0))).simplified();
}

void items(benchmark::State& state, std::size_t count)
{
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}

void BM_sections(benchmark::State& state)
{
    const Skeleton skeleton = smallTree(state);
    std::size_t count = 0;
    for (auto _ : state) {
        const SectionSet set = buildSections(skeleton, 4);
        count = set.sections.size();
        benchmark::DoNotOptimize(set.sections.data());
    }
    items(state, count);
}
BENCHMARK(BM_sections)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);

void BM_roughModel(benchmark::State& state)
{
    const Skeleton skeleton = smallTree(state);
    TriangleMesh mesh;
    std::size_t count = 0;
    for (auto _ : state) {
        mesh = buildRoughBranches(skeleton, 8, std::move(mesh)); // as the editor does
        count = mesh.triangles.size();
        benchmark::DoNotOptimize(mesh.positions.data());
    }
    items(state, count);
}
BENCHMARK(BM_roughModel)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);

void BM_foliage(benchmark::State& state)
{
    const Skeleton skeleton = smallTree(state);
    std::size_t count = 0;
    for (auto _ : state) {
        const Foliage foliage = bench::need(placeFoliage(skeleton, FoliageParams(), 0.2));
        const TriangleMesh leaves = buildLeaves(skeleton, foliage, 0.2, FoliageModel::Fine);
        const TriangleMesh apples = buildApples(skeleton, foliage, 0.2, FoliageModel::Fine);
        count = foliage.leaves.size();
        benchmark::DoNotOptimize(leaves.positions.data());
        benchmark::DoNotOptimize(apples.positions.data());
    }
    items(state, count);
}
BENCHMARK(BM_foliage)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);

/// Leaves on a day when they turn; the last argument is their number.
void BM_foliageOnDay(benchmark::State& state)
{
    const Skeleton skeleton = smallTree(state);
    LeafParams maple;
    maple.shape = LeafShape::Maple;
    Foliage placed = bench::need(placeFoliage(skeleton, FoliageParams(), maple, FruitParams(), 0.2));
    const std::size_t known = placed.leaves.size();
    const auto count = static_cast<std::size_t>(state.range(2));
    for (std::size_t i = known; i < count; ++i) { // no two with one address
        placed.leaves.push_back(placed.leaves[i - known]);
        placed.leaves.back().number += 1000;
    }
    placed.leaves.resize(count);
    placed.phases = std::make_shared<const std::vector<LeafPhase>>(phasesOf(placed, skeleton));
    const ThreadLimit limit(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(foliageOnDay(placed, skeleton, {double(state.range(1))}, 0.2).leaves.data());
    items(state, count);
}
BENCHMARK(BM_foliageOnDay)
    ->Args({12, 298, 1'000})
    ->Args({12, 298, 100'000})
    ->Args({12, 298, 1'000'000})
    ->Unit(benchmark::kMillisecond);

/// All five maps at 1024 pixels a side.
void BM_barkMaps(benchmark::State& state)
{
    BarkParams params;
    params.family = static_cast<BarkFamily>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::need(barkMaps(params, 1024)).height.data());
}
BENCHMARK(BM_barkMaps)->DenseRange(1, 13)->Unit(benchmark::kMillisecond);

} // namespace
