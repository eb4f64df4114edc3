// The two yardsticks of PERFORMANCE: bars hold as ratios to what they give on the machine at hand.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <benchmark/benchmark.h>
#include <cstring>
#include <memory>

namespace {

void BM_copy256MB(benchmark::State& state)
{
    constexpr std::size_t size = std::size_t(256) << 20;
    const auto from = std::make_unique<char[]>(size), to = std::make_unique<char[]>(size);
    std::memset(from.get(), 1, size);
    for (auto _ : state) {
        std::memcpy(to.get(), from.get(), size);
        benchmark::DoNotOptimize(to.get());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * size));
}
BENCHMARK(BM_copy256MB)->Unit(benchmark::kMillisecond);

/// A sphere of 708 x 708 quads less the poles' halves: 1,001,112 triangles.
struct Sphere
{
    static constexpr int around = 708, rings = 707; ///< rings of vertices between the poles
    std::vector<OpenMesh::Vec3f> points;
    std::vector<std::array<int, 3>> faces;

    Sphere()
    {
        points.emplace_back(0.0f, 1.0f, 0.0f);
        for (int r = 1; r <= rings; ++r)
            for (int k = 0; k < around; ++k) {
                const double polar = M_PI * r / (rings + 1), azimuth = 2 * M_PI * k / around;
                points.emplace_back(float(std::sin(polar) * std::cos(azimuth)), float(std::cos(polar)),
                                    float(-std::sin(polar) * std::sin(azimuth)));
            }
        points.emplace_back(0.0f, -1.0f, 0.0f);
        const int south = int(points.size()) - 1;
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around, last = 1 + (rings - 1) * around;
            faces.push_back({0, 1 + k, 1 + next});
            for (int r = 0; r + 1 < rings; ++r) {
                const int upper = 1 + r * around, lower = upper + around;
                faces.push_back({upper + k, lower + k, lower + next});
                faces.push_back({upper + k, lower + next, upper + next});
            }
            faces.push_back({last + k, south, last + next});
        }
    }
};

void BM_openMeshSphere(benchmark::State& state)
{
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    const Sphere sphere;
    for (auto _ : state) {
        Mesh mesh;
        std::vector<Mesh::VertexHandle> handles;
        handles.reserve(sphere.points.size());
        for (const OpenMesh::Vec3f& point : sphere.points)
            handles.push_back(mesh.add_vertex(point));
        for (const auto& [a, b, c] : sphere.faces)
            mesh.add_face(handles[std::size_t(a)], handles[std::size_t(b)], handles[std::size_t(c)]);
        benchmark::DoNotOptimize(mesh.n_faces());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * sphere.faces.size()));
    state.counters["triangles"] = static_cast<double>(sphere.faces.size());
}
BENCHMARK(BM_openMeshSphere)->Unit(benchmark::kMillisecond);

} // namespace
