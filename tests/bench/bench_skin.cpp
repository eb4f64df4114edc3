// Binding (per vertex, once per tree) and deforming (per vertex, every frame): positions alone, and with
// normals.
#include "core/rig/pose/skin.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>
#include <cmath>

using namespace ramure;

namespace {

struct Moving
{
    Skeleton skeleton;
    BranchMesh mesh;
    std::vector<RigidTransform> pose;

    explicit Moving(const benchmark::State& state)
        : skeleton(bench::Growth("SmallTree", static_cast<int>(state.range(0))).simplified())
        , mesh(bench::need(buildBranchMesh(skeleton, {})))
        , pose(skeleton.size())
    {
        for (Index b = 0; b < skeleton.size(); ++b) {
            const double angle = 0.1 * std::sin(b);
            pose[b] = turnAbout(skeleton.p0[b], glm::angleAxis(angle, glm::dvec3(1.0, 0.0, 0.0)));
        }
    }
};

void items(benchmark::State& state, const Moving& tree)
{
    state.SetItemsProcessed(state.iterations() * std::int64_t(tree.mesh.mesh.vertexCount()));
}

void BM_skinBind(benchmark::State& state)
{
    const Moving tree(state);
    for (auto _ : state) {
        const Skin skin = bench::need(bindBranches(tree.mesh, tree.skeleton, true));
        benchmark::DoNotOptimize(skin.runs.data());
    }
    items(state, tree);
}
BENCHMARK(BM_skinBind)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);

void moved(benchmark::State& state, SkinMethod method, bool withNormals)
{
    const Moving tree(state);
    const Skin skin = bench::need(bindBranches(tree.mesh, tree.skeleton, method != SkinMethod::Rigid));
    Deformer deformer;
    std::vector<glm::vec3> positions(tree.mesh.mesh.positions.size());
    std::vector<glm::vec3> normals(withNormals ? positions.size() : 0);
    for (auto _ : state) {
        deformer.setPose(tree.pose, method);
        deformer.deform(tree.mesh.mesh.positions, tree.mesh.mesh.normals, skin, positions, normals);
        benchmark::DoNotOptimize(positions.data());
    }
    items(state, tree);
}
void BM_skinRigid(benchmark::State& state)
{
    moved(state, SkinMethod::Rigid, false);
}
void BM_skinRigidNormals(benchmark::State& state)
{
    moved(state, SkinMethod::Rigid, true);
}
void BM_skinLinear(benchmark::State& state)
{
    moved(state, SkinMethod::Linear, false);
}
void BM_skinLinearNormals(benchmark::State& state)
{
    moved(state, SkinMethod::Linear, true);
}
void BM_skinDualQuaternion(benchmark::State& state)
{
    moved(state, SkinMethod::DualQuaternion, false);
}
void BM_skinDualQuaternionNormals(benchmark::State& state)
{
    moved(state, SkinMethod::DualQuaternion, true);
}
BENCHMARK(BM_skinRigid)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_skinRigidNormals)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_skinLinear)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_skinLinearNormals)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_skinDualQuaternion)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_skinDualQuaternionNormals)->Arg(8)->Arg(12)->Unit(benchmark::kMicrosecond);

} // namespace
