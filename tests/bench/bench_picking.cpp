// Picking: building the hierarchy (per triangle) and one ray through it, on the surface of a tree of 114,687
// branches (the promise: within 5 ms on 100,000).
#include "core/math/bvh.h"
#include "core/math/random.h"
#include "core/surface/mesher/rough_model.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

std::vector<PrimitiveBounds> boundsOf(const TriangleMesh& mesh)
{
    std::vector<PrimitiveBounds> bounds;
    bounds.reserve(mesh.triangles.size());
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::vec3& a = mesh.positions[t.x];
        const glm::vec3& b = mesh.positions[t.y];
        const glm::vec3& c = mesh.positions[t.z];
        bounds.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
    }
    return bounds;
}

TriangleMesh largeTree(int iterations)
{
    return buildRoughBranches(bench::Growth("SmallTree", iterations).simplified(), 8);
}

void BM_hierarchyBuild(benchmark::State& state)
{
    const TriangleMesh mesh = largeTree(static_cast<int>(state.range(0)));
    const std::vector<PrimitiveBounds> bounds = boundsOf(mesh);
    for (auto _ : state) {
        const Bvh bvh(bounds);
        benchmark::DoNotOptimize(bvh.nodeCount());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bounds.size()));
}
BENCHMARK(BM_hierarchyBuild)->Arg(8)->Arg(14)->Unit(benchmark::kMillisecond);

void BM_pickRay(benchmark::State& state)
{
    const TriangleMesh mesh = largeTree(static_cast<int>(state.range(0)));
    const Bvh bvh(boundsOf(mesh));
    Random random(1, RandomStream::Test);
    std::int64_t hits = 0;
    for (auto _ : state) {
        const glm::dvec3 aim(random.range(-2.0, 2.0), random.range(0.5, 3.5), random.range(-2.0, 2.0));
        const Ray ray{glm::dvec3(3.0, 2.0, 12.0), glm::normalize(aim - glm::dvec3(3.0, 2.0, 12.0))};
        double nearest = 1e9;
        bvh.alongRay(ray, nearest, [&](Index i, double& tMax) {
            const glm::uvec3& t = mesh.triangles[i];
            const auto hit = intersect(ray, glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                                       glm::dvec3(mesh.positions[t.z]));
            if (hit && hit->t < nearest)
                nearest = tMax = hit->t;
        });
        hits += nearest < 1e9 ? 1 : 0;
    }
    state.counters["hits"] =
        benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
}
BENCHMARK(BM_pickRay)->Arg(8)->Arg(14)->Unit(benchmark::kMicrosecond);

} // namespace
