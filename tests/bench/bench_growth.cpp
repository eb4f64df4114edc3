// Every stage, and all of them in a row, from a thousand to ten million triangles: what one triangle costs
// must not grow with their number. And ten million vertices written, read and compared.
#include "core/base/parallel.h"
#include "core/io/formats/file_format.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/skeleton/sections.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/mesher/rough_model.h"
#include "core/surface/proof/validate.h"
#include "core/surface/texture/texture_coordinates.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstring>
#include <filesystem>

using namespace ramure;

namespace {

/// The SmallTree with so many iterations: twice as many triangles with each, 98,654 with 8.
struct Tree
{
    std::int64_t iterations = -1;
    Skeleton skeleton;
    TriangleMesh mesh;
};

/// Kept until another number is asked for.
const Tree& treeOf(const benchmark::State& state)
{
    static Tree tree;
    if (tree.iterations == state.range(0))
        return tree;
    tree = {};
    tree.iterations = state.range(0);
    tree.skeleton = bench::Growth("SmallTree", static_cast<int>(state.range(0))).simplified();
    const ThreadLimit all(0);
    tree.mesh = bench::need(buildBranchMesh(tree.skeleton, {})).mesh;
    computeNormals(tree.mesh);
    return tree;
}

std::string file(const char* name)
{
    const std::filesystem::path memory = "/dev/shm";
    return ((std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) / name)
        .string();
}

/// Warm: memory that a first round took is used again, as in the editor.
template <class Work> void perTriangle(benchmark::State& state, std::size_t triangles, Work&& work)
{
    for (int i = 0; i < 2; ++i)
        work();
    for (auto _ : state)
        work();
    state.counters["triangles"] = static_cast<double>(triangles);
    state.counters["ns/triangle"] =
        benchmark::Counter(static_cast<double>(triangles) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_growthMesh(benchmark::State& state)
{
    const Tree& tree = treeOf(state);
    BranchMeshOptions options;
    options.withNormals = false; // a stage of their own
    TriangleMesh mesh;
    perTriangle(state, tree.mesh.faceCount(),
                [&] { mesh = bench::need(buildBranchMesh(tree.skeleton, options)).mesh; });
}
void BM_growthCheck(benchmark::State& state)
{
    const Tree& tree = treeOf(state);
    perTriangle(state, tree.mesh.faceCount(), [&] {
        if (!bench::need(validateMesh(tree.mesh)).valid)
            state.SkipWithError("not valid");
    });
}
void BM_growthNormals(benchmark::State& state)
{
    TriangleMesh mesh = treeOf(state).mesh;
    perTriangle(state, mesh.faceCount(), [&] { computeNormals(mesh); });
}
void BM_growthRough(benchmark::State& state)
{
    const Tree& tree = treeOf(state);
    TriangleMesh mesh = buildRoughBranches(tree.skeleton, 8);
    perTriangle(state, mesh.faceCount(), [&] {
        mesh = buildRoughBranches(tree.skeleton, 8, std::move(mesh));
        benchmark::DoNotOptimize(mesh.triangles.data());
    });
}

void BM_growthTexture(benchmark::State& state)
{
    const BranchMesh branches = bench::need(buildBranchMesh(treeOf(state).skeleton, {}));
    perTriangle(state, branches.mesh.faceCount(),
                [&] { benchmark::DoNotOptimize(bench::need(textureCoordinates(branches, {})).uv.data()); });
}
/// For one triangle of the leaves.
void BM_growthFoliage(benchmark::State& state)
{
    const Tree& tree = treeOf(state);
    const auto leaves = [&tree] {
        const Foliage foliage = bench::need(placeFoliage(tree.skeleton, FoliageParams(), 0.2));
        return buildLeaves(tree.skeleton, foliage, 0.2, FoliageModel::Fine);
    };
    perTriangle(state, leaves().faceCount(), [&] { benchmark::DoNotOptimize(leaves().positions.data()); });
}
void BM_growthCrossings(benchmark::State& state)
{
    const Tree& tree = treeOf(state);
    const BranchMesh branches = bench::need(buildBranchMesh(tree.skeleton, {}));
    const std::vector<Index> parents = repairedParents(tree.skeleton, branches.repairs);
    perTriangle(state, branches.mesh.faceCount(), [&] {
        benchmark::DoNotOptimize(bench::need(findSelfIntersections(branches.mesh, parents, 1)));
    });
}
void BM_growthGlb(benchmark::State& state)
{
    const TriangleMesh& mesh = treeOf(state).mesh;
    const ExportScene scene = sceneOfMeshes({{"branches", mesh, {}}}, barkMaterial());
    const std::string path = file("ramure-growth.glb");
    const FileFormat& glb = *bench::need(findFormat(path, FormatUse::Write));
    perTriangle(state, mesh.faceCount(), [&] {
        if (!glb.write(path, scene, {}, {}))
            state.SkipWithError("not written");
    });
    std::filesystem::remove(path);
}

Expected<void> write(const char* name, const TriangleMesh& mesh)
{
    const MeshPart part{"branches", &mesh, barkMaterial()};
    return std::strstr(name, ".obj") ? writeObj(file(name), {&part, 1})
                                     : writePly(file(name), {&part, 1}, {});
}
void clean()
{
    for (const char* name : {"ramure-growth.obj", "ramure-growth.mtl", "ramure-growth.ply"})
        std::filesystem::remove(file(name));
}
void BM_growthWrite(benchmark::State& state, const char* name)
{
    const Tree& tree = treeOf(state);
    perTriangle(state, tree.mesh.faceCount(), [&] {
        if (!write(name, tree.mesh))
            state.SkipWithError("not written");
    });
    clean();
}
void BM_growthRead(benchmark::State& state, const char* name)
{
    const Tree& tree = treeOf(state);
    if (!write(name, tree.mesh))
        return state.SkipWithError("not written");
    perTriangle(state, tree.mesh.faceCount(), [&] {
        if (!readMeshFile(file(name)))
            state.SkipWithError("not read");
    });
    clean();
}

/// From the parameters to the checked mesh with normals, as the editor makes it.
void BM_growthAll(benchmark::State& state)
{
    NodeParams params = bench::need(presetParams("SmallTree"));
    params.grammar.iterations = state.range(0);
    TreePipeline pipeline;
    pipeline.setCacheSize(1);
    const std::size_t triangles =
        bench::need(pipeline.evaluate(params, Stage::Mesh)).branches->mesh.faceCount();
    perTriangle(state, triangles, [&] {
        params.grammar.axiom = params.grammar.axiom == "BBBBBA" ? "BBBBBBA" : "BBBBBA"; // not from the cache
        benchmark::DoNotOptimize(bench::need(pipeline.evaluate(params, Stage::Mesh)).branches.get());
    });
}

/// 2 for thousand, 5 for ten thousand, 8, 11 or 12, and 15 for ten million.
void sizes(benchmark::internal::Benchmark* bench)
{
    for (const int iterations : {2, 5, 8, 12, 15})
        bench->Arg(iterations);
    bench->Unit(benchmark::kMillisecond);
}
/// Small, usual and huge.
void threeSizes(benchmark::internal::Benchmark* bench)
{
    for (const int iterations : {5, 8, 12})
        bench->Arg(iterations);
    bench->Unit(benchmark::kMillisecond);
}
BENCHMARK(BM_growthMesh)->Apply(sizes);
BENCHMARK(BM_growthCheck)->Apply(sizes);
BENCHMARK(BM_growthNormals)->Apply(sizes);
BENCHMARK(BM_growthRough)->Apply(sizes);
BENCHMARK(BM_growthTexture)->Apply(threeSizes);
BENCHMARK(BM_growthFoliage)->Apply(threeSizes);
BENCHMARK(BM_growthCrossings)->Apply(threeSizes);
BENCHMARK(BM_growthGlb)->Apply(threeSizes);
BENCHMARK_CAPTURE(BM_growthWrite, obj, "ramure-growth.obj")->Apply(sizes);
BENCHMARK_CAPTURE(BM_growthRead, obj, "ramure-growth.obj")->Apply(sizes);
BENCHMARK_CAPTURE(BM_growthWrite, ply, "ramure-growth.ply")->Apply(sizes);
BENCHMARK_CAPTURE(BM_growthRead, ply, "ramure-growth.ply")->Apply(sizes);
BENCHMARK(BM_growthAll)->Apply(sizes);

/// A torus of 4,000 x 2,500 vertices with everything that a file can hold.
TriangleMesh tenMillionVertices()
{
    constexpr Index around = 4000, along = 2500;
    TriangleMesh mesh;
    for (Index i = 0; i < along; ++i)
        for (Index k = 0; k < around; ++k) {
            const double a = 2 * M_PI * i / along, b = 2 * M_PI * k / around;
            const glm::dvec3 normal(std::cos(a) * std::cos(b), std::sin(b), -std::sin(a) * std::cos(b));
            mesh.positions.emplace_back(glm::dvec3(3 * std::cos(a), 0.0, -3 * std::sin(a)) + normal);
            mesh.normals.emplace_back(normal);
        }
    for (Index i = 0; i < along; ++i)
        for (Index k = 0; k < around; ++k) {
            const Index p = i * around + k, q = i * around + (k + 1) % around;
            const Index r = (p + around) % (along * around), s = (q + around) % (along * around);
            mesh.triangles.emplace_back(p, r, s);
            mesh.triangles.emplace_back(p, s, q);
        }
    return mesh;
}

bool sameBits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

void BM_tenMillionVertices(benchmark::State& state, const char* name)
{
    const TriangleMesh mesh = tenMillionVertices();
    const auto round = [&] {
        if (!write(name, mesh))
            return state.SkipWithError("not written");
        const ReadMesh back = bench::need(readMeshFile(file(name)));
        const TriangleMesh& read = back.objects.front().mesh;
        if (back.objects.size() != 1 || !sameBits(read.positions, mesh.positions) ||
            !sameBits(read.normals, mesh.normals) || read.triangles != mesh.triangles)
            state.SkipWithError("not the same mesh");
    };
    for (auto _ : state) // once: this is a proof more than a measure
        round();
    state.counters["triangles"] = static_cast<double>(mesh.faceCount());
    state.SetLabel("written, read back and compared: equal");
    clean();
}
BENCHMARK_CAPTURE(BM_tenMillionVertices, obj, "ramure-growth.obj")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(BM_tenMillionVertices, ply, "ramure-growth.ply")->Unit(benchmark::kSecond)->Iterations(1);

} // namespace
