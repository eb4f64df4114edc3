// Mesh files: written to and read from memory-backed storage where there is one, as users' page caches are.
#include "core/io/float_text.h"
#include "core/io/mesh_file.h"
#include "core/pipeline/tree_pipeline.h"
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>
#include <filesystem>
#include <random>

using namespace ramure;

namespace {

/// The branches of the SmallTree with 12 iterations, with normals and all that the program knows of a vertex.
const TriangleMesh& allOfBranches()
{
    static const TriangleMesh mesh = [] {
        NodeParams params = bench::need(presetParams("SmallTree"));
        params.grammar.iterations = 12;
        TreePipeline pipeline;
        return bench::need(pipeline.evaluate(params, Stage::Mesh)).branches->mesh;
    }();
    return mesh;
}

/// Positions and triangles alone: what the bars are about. (For OBJ they name 16 ns as what a machine allows
/// that takes files at 2.5 GB/s. These are 40 bytes for a triangle and half a vertex; with normals there
/// are 75.)
const TriangleMesh& plainBranches()
{
    static const TriangleMesh mesh = [] {
        TriangleMesh plain;
        plain.positions = allOfBranches().positions;
        plain.triangles = allOfBranches().triangles;
        return plain;
    }();
    return mesh;
}

/// A benchmark's argument.
enum Content { Plain, Everything };
MeshPart partOf(Content content)
{
    return {"branches", content == Plain ? &plainBranches() : &allOfBranches(), barkMaterial()};
}

std::string file(const char* name)
{
    const std::filesystem::path memory = "/dev/shm";
    return ((std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) / name)
        .string();
}

void perTriangle(benchmark::State& state)
{
    const auto triangles = static_cast<double>(plainBranches().faceCount());
    state.counters["ns/triangle"] = benchmark::Counter(
        triangles * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_writeObj(benchmark::State& state, Content content)
{
    const MeshPart part = partOf(content);
    for (auto _ : state)
        if (!writeObj(file("ramure-bench.obj"), {&part, 1}))
            state.SkipWithError("not written");
    perTriangle(state);
}
void BM_writePly(benchmark::State& state, Content content)
{
    const MeshPart part = partOf(content);
    for (auto _ : state)
        if (!writePly(file("ramure-bench.ply"), {&part, 1}, {}))
            state.SkipWithError("not written");
    perTriangle(state);
}
void read(benchmark::State& state, const char* name)
{
    for (auto _ : state) {
        const auto mesh = readMeshFile(file(name));
        if (!mesh)
            state.SkipWithError("not read");
        benchmark::DoNotOptimize(mesh->objects.data());
    }
    perTriangle(state);
    std::filesystem::remove(file(name));
}
void BM_readObj(benchmark::State& state, Content content)
{
    const MeshPart part = partOf(content);
    if (writeObj(file("ramure-bench.obj"), {&part, 1}))
        read(state, "ramure-bench.obj");
    std::filesystem::remove(file("ramure-bench.mtl"));
}
void BM_readPly(benchmark::State& state, Content content)
{
    const MeshPart part = partOf(content);
    if (writePly(file("ramure-bench.ply"), {&part, 1}, {}))
        read(state, "ramure-bench.ply");
}
BENCHMARK_CAPTURE(BM_writeObj, plain, Plain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_writeObj, everything, Everything)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_readObj, plain, Plain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_readObj, everything, Everything)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_writePly, plain, Plain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_writePly, everything, Everything)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_readPly, plain, Plain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_readPly, everything, Everything)->Unit(benchmark::kMillisecond);

void BM_appendFloat(benchmark::State& state)
{
    std::mt19937 random(1);
    std::vector<float> numbers(1 << 14);
    for (float& number : numbers)
        number = static_cast<float>(static_cast<double>(random()) / 4294967296.0 * 6.0 - 3.0);
    std::vector<char> text(numbers.size() * maxFloatText);
    for (auto _ : state) {
        char* to = text.data();
        for (const float number : numbers)
            to = appendFloat(to, number);
        benchmark::DoNotOptimize(to);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * numbers.size()));
}
BENCHMARK(BM_appendFloat)->Unit(benchmark::kMicrosecond);

} // namespace
