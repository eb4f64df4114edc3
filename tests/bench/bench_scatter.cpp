// Copies of a scatter: where they stand, and stands that grow.
#include "core/math/random.h"
#include "core/scatter/scatter.h"
#include "core/scatter/stand.h"
#include <benchmark/benchmark.h>
#include <cmath>

namespace ramure {
namespace {

/// One tree on a terrain, as many times as wanted, an area of 16 m² each.
Scene sceneOf(std::int64_t count, bool onTerrain)
{
    std::vector<Node> nodes(onTerrain ? 3 : 2);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].id = NodeId(i + 1);
        nodes[i].name = "node";
    }
    const double side = 4.0 * std::sqrt(double(count));
    nodes[0].kind = NodeKind::Scatter;
    nodes[0].params.scatter.count = count;
    nodes[0].params.scatter.spacing = 2.0;
    nodes[0].params.scatter.width = nodes[0].params.scatter.depth = side;
    nodes[1].kind = NodeKind::Tree;
    nodes[1].parent = 1;
    if (onTerrain) {
        nodes[2].kind = NodeKind::Terrain;
        nodes[2].params.terrain.size = side;
        nodes[2].params.terrain.height = 0.05 * side;
    }
    return *Scene::fromNodes(std::move(nodes));
}

void BM_scatter(benchmark::State& state)
{
    const Scene scene = sceneOf(state.range(0), false);
    for (auto _ : state)
        benchmark::DoNotOptimize(scatterPlaces(scene, *scene.find(1)));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_scatter)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void BM_scatterOnTerrain(benchmark::State& state)
{
    const Scene scene = sceneOf(state.range(0), true);
    for (auto _ : state)
        benchmark::DoNotOptimize(scatterPlaces(scene, *scene.find(1)));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_scatterOnTerrain)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// 80 years of beeches, sown 4,000 a hectare; a quarter of a hectare is 1,000.
void BM_stand(benchmark::State& state)
{
    const double half = 0.5 * std::sqrt(2.5 * double(state.range(0)));
    Random random(1, RandomStream::Test);
    std::vector<Seedling> seedlings;
    for (std::int64_t i = 0; i < state.range(0); ++i) {
        const double x = random.range(-half, half), z = random.range(-half, half);
        seedlings.push_back({{x, z}, findStandSpecies("EuropeanBeech")});
    }
    for (auto _ : state)
        benchmark::DoNotOptimize(grownStand(seedlings, 80, 1));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_stand)->Arg(100)->Arg(1'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace ramure
