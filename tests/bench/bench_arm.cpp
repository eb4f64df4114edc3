// The arm. Inverse kinematics: one target of an arm with limits, from a pose near straight (the promise:
// under 50 microseconds with 10 joints). Targets by forward kinematics, so all can be reached.
#include "core/math/random.h"
#include "core/rig/arm/arm_skin.h"
#include "core/rig/arm/arm_solver.h"
#include "core/surface/mesh/mesh_rays.h"
#include "core/surface/primitives/terrain.h"
#include <benchmark/benchmark.h>
#include <cmath>
#include <numbers>

using namespace ramure;

namespace {

std::vector<ArmJoint> limitedArm(std::size_t count)
{
    constexpr double degree = std::numbers::pi / 180.0;
    std::vector<ArmJoint> joints(count);
    for (ArmJoint& joint : joints) {
        joint.phi = {0.0, true, -170.0 * degree, 170.0 * degree, 0.0};
        joint.theta = {0.1, true, -60.0 * degree, 60.0 * degree, 0.0};
    }
    return joints;
}

std::vector<glm::dvec3> targetsOf(std::span<const ArmJoint> joints)
{
    Random random(1, RandomStream::Test);
    std::vector<glm::dvec3> targets;
    for (int t = 0; t < 1000; ++t) {
        std::vector<ArmJoint> posed(joints.begin(), joints.end());
        for (ArmJoint& joint : posed) {
            joint.phi.angleRad = random.range(joint.phi.minRad, joint.phi.maxRad);
            joint.theta.angleRad = random.range(joint.theta.minRad, joint.theta.maxRad);
        }
        targets.push_back(ArmChain(posed).tip());
    }
    return targets;
}

void BM_armSolve(benchmark::State& state)
{
    const std::vector<ArmJoint> joints = limitedArm(static_cast<std::size_t>(state.range(0)));
    const std::vector<glm::dvec3> targets = targetsOf(joints);
    const std::vector<double> start = armAngles(joints);
    ArmSolverParams params;
    params.tolerance = 1e-4 * double(joints.size());
    ArmSolver solver(joints, params);
    std::size_t next = 0, reached = 0;
    for (auto _ : state) {
        solver.setAngles(start);
        solver.setTarget(targets[next++ % targets.size()]);
        reached += solver.solve() == ArmStatus::Reached;
    }
    state.counters["reached"] = double(reached) / double(state.iterations());
}
BENCHMARK(BM_armSolve)->Arg(2)->Arg(3)->Arg(5)->Arg(10)->Arg(20)->Arg(64)->Unit(benchmark::kMicrosecond);

/// A terrain of two million triangles at most; the promise: a click within 1 ms on one of a million.
void BM_terrainBuild(benchmark::State& state)
{
    TerrainParams params;
    params.divisions = state.range(0);
    for (auto _ : state)
        benchmark::DoNotOptimize(buildTerrain(params));
    state.SetItemsProcessed(state.iterations() * 2 * state.range(0) * state.range(0));
}
BENCHMARK(BM_terrainBuild)->Arg(128)->Arg(708)->Unit(benchmark::kMillisecond);

void BM_terrainClick(benchmark::State& state)
{
    TerrainParams params;
    params.divisions = state.range(0);
    const MeshRays rays(std::make_shared<const TriangleMesh>(buildTerrain(params).value_or(TriangleMesh{})));
    Random random(1, RandomStream::Test);
    std::int64_t hits = 0;
    for (auto _ : state) {
        const glm::dvec3 from(3.0, 2.0, 12.0);
        const glm::dvec3 aim(random.range(-6.0, 6.0), random.range(-1.0, 1.0), random.range(-6.0, 6.0));
        hits += rays.nearest({from, aim - from}).has_value();
    }
    state.counters["hits"] = double(hits) / double(state.iterations());
}
BENCHMARK(BM_terrainClick)->Arg(128)->Arg(708)->Unit(benchmark::kMicrosecond);

/// A click on an imported mesh: a scanned ball of a million triangles, over which hills go in all directions.
void BM_meshClick(benchmark::State& state)
{
    const auto side = static_cast<Index>(state.range(0));
    auto mesh = std::make_shared<TriangleMesh>();
    for (Index row = 0; row <= side; ++row)
        for (Index i = 0; i <= side; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / side, up = std::numbers::pi * row / side;
            const double radius = 4.0 + 0.3 * std::sin(9.0 * turn) * std::sin(7.0 * up);
            mesh->positions.emplace_back(radius * std::sin(up) * std::cos(turn), radius * std::cos(up),
                                         radius * std::sin(up) * std::sin(turn));
        }
    for (Index row = 0; row < side; ++row)
        for (Index i = 0; i < side; ++i) {
            const Index a = row * (side + 1) + i, b = a + side + 1;
            mesh->triangles.emplace_back(a, b, b + 1);
            mesh->triangles.emplace_back(a, b + 1, a + 1);
        }
    const MeshRays rays(mesh);
    Random random(1, RandomStream::Test);
    std::int64_t hits = 0;
    for (auto _ : state) {
        const glm::dvec3 from(9.0, 6.0, 9.0);
        const glm::dvec3 aim(random.range(-4.0, 4.0), random.range(-4.0, 4.0), random.range(-4.0, 4.0));
        hits += rays.nearest({from, aim - from}).has_value();
    }
    state.counters["hits"] = double(hits) / double(state.iterations());
}
BENCHMARK(BM_meshClick)->Arg(708)->Unit(benchmark::kMicrosecond);

void BM_armSkinDeform(benchmark::State& state)
{
    const std::vector<ArmJoint> joints = defaultArmJoints();
    const TriangleMesh mesh = armCylinder(joints, {}).value_or(TriangleMesh{});
    const Skin skin = bindArm(mesh, joints, true, 0.2);
    std::vector<RigidTransform> bones;
    ArmChain(joints).pose(bones);
    for (auto _ : state)
        benchmark::DoNotOptimize(deformed(mesh, skin, bones, SkinMethod::DualQuaternion));
}
BENCHMARK(BM_armSkinDeform)->Unit(benchmark::kMicrosecond);

} // namespace
