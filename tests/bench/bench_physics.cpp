// Tree physics: per branch and step; poses and figures; seeks in a cached run.
#include "core/math/random.h"
#include "core/rig/physics/leaf_swing.h"
#include "core/rig/physics/physics_cache.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

/// SmallTree with 8 iterations has 1,791 branches; with 13, simplified, 57,343.
std::shared_ptr<const TreeBody> bodyOf(int iterations)
{
    const bench::Growth tree("SmallTree", iterations);
    const Skeleton skeleton = tree.simplified();
    const Foliage foliage =
        bench::need(placeFoliage(skeleton, tree.params.foliage, tree.params.turtle.alpha));
    return makeTreeBody(skeleton, &foliage, tree.params.turtle.alpha);
}

PhysicsParams paramsOf(const benchmark::State& state)
{
    PhysicsParams params;
    params.mode = static_cast<PhysicsMode>(state.range(1));
    return params;
}

void label(benchmark::State& state, const TreeBody& body)
{
    state.SetLabel(std::to_string(body.size()) +
                   (state.range(1) == 0 ? " branches, faithful" : " branches, robust"));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * body.size());
}

void BM_physicsStep(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    TreePhysics physics(body, paramsOf(state));
    PhysicsState now = physics.restState();
    for (int k = 0; k < 100; ++k)
        physics.step(now);
    for (auto _ : state)
        physics.step(now);
    label(state, *body);
}
BENCHMARK(BM_physicsStep)->ArgsProduct({{8, 12, 13}, {0, 1}})->Unit(benchmark::kMicrosecond);

void BM_physicsPose(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    TreePhysics physics(body, paramsOf(state));
    PhysicsState now = physics.restState();
    physics.step(now);
    Pose pose;
    for (auto _ : state)
        physics.pose(now, pose);
    label(state, *body);
}
BENCHMARK(BM_physicsPose)->ArgsProduct({{8, 13}, {1}})->Unit(benchmark::kMicrosecond);

void BM_physicsFigures(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    TreePhysics physics(body, paramsOf(state));
    PhysicsState now = physics.restState();
    physics.step(now);
    for (auto _ : state)
        benchmark::DoNotOptimize(physics.figures(now));
    label(state, *body);
}
BENCHMARK(BM_physicsFigures)->ArgsProduct({{8, 13}, {1}})->Unit(benchmark::kMicrosecond);

/// Per leaf and frame: how it swings, and the bone that comes of it.
void BM_leafSwing(benchmark::State& state)
{
    const bench::Growth tree("SmallTree", static_cast<int>(state.range(0)));
    const Skeleton skeleton = tree.simplified();
    LeafParams leaf;
    leaf.shape = LeafShape::Oak;
    const double alpha = tree.params.turtle.alpha;
    const Foliage foliage =
        bench::need(placeFoliage(skeleton, tree.params.foliage, leaf, tree.params.fruit, alpha));
    const BranchMesh mesh = bench::need(buildBranchMesh(skeleton, {}));
    LeafSwing swing(skeleton, foliage, alpha,
                    bench::need(bindAnchors(foliage.leaves, mesh, skeleton,
                                            bench::need(bindBranches(mesh, skeleton, true)))));
    const auto body = makeTreeBody(skeleton, nullptr, alpha);
    TreePhysics physics(body, {});
    PhysicsState now = physics.restState();
    for (int k = 0; k < 100; ++k)
        physics.step(now);
    Pose pose;
    physics.pose(now, pose);
    LeafBends bends;
    std::vector<RigidTransform> bones(swing.size());
    for (auto _ : state) {
        swing.swing(*body, now, physics.params(), leaf, bends);
        if (state.range(1) == 1)
            swing.pose(pose.bones, SkinMethod::DualQuaternion, bends, bones);
    }
    state.SetLabel(std::to_string(swing.size()) + " leaves");
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * swing.size()));
}
BENCHMARK(BM_leafSwing)->ArgsProduct({{8, 12}, {0, 1}})->Unit(benchmark::kMicrosecond);

/// What a change of a value costs while playing: with the next step.
void BM_physicsLiveChange(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    PhysicsParams params = paramsOf(state);
    TreePhysics physics(body, params);
    PhysicsState now = physics.restState();
    for (auto _ : state) {
        params.windStrength = params.windStrength == 1.0 ? 1.1 : 1.0;
        physics.setParams(params);
        physics.step(now);
    }
    label(state, *body);
}
BENCHMARK(BM_physicsLiveChange)->ArgsProduct({{8, 13}, {1}})->Unit(benchmark::kMicrosecond);

/// Straight play with keeping: a step, its copy into the ring.
void BM_cachePlay(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    PhysicsCache cache(body, paramsOf(state));
    for (auto _ : state)
        (void)cache.seek(cache.step() + 1);
    label(state, *body);
}
BENCHMARK(BM_cachePlay)->ArgsProduct({{8, 13}, {0, 1}})->Unit(benchmark::kMicrosecond)->Iterations(1000);

void BM_cacheRandomSeek(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    PhysicsCache cache(body, paramsOf(state));
    (void)cache.seek(1000);
    Random random(1, RandomStream::Test);
    for (auto _ : state)
        (void)cache.seek(random.below(1001));
    label(state, *body);
}
BENCHMARK(BM_cacheRandomSeek)->ArgsProduct({{8, 13}, {0, 1}})->Unit(benchmark::kMicrosecond)->Iterations(200);

void BM_cacheStepBack(benchmark::State& state)
{
    const auto body = bodyOf(static_cast<int>(state.range(0)));
    PhysicsCache cache(body, paramsOf(state));
    (void)cache.seek(1000);
    for (auto _ : state) {
        if (cache.step() == 0)
            (void)cache.seek(1000);
        (void)cache.seek(cache.step() - 1);
    }
    label(state, *body);
}
BENCHMARK(BM_cacheStepBack)->ArgsProduct({{8, 13}, {0, 1}})->Unit(benchmark::kMicrosecond)->Iterations(900);

} // namespace
