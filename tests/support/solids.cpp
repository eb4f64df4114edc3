#include "tests/support/solids.h"

#include <cmath>
#include <numbers>

namespace ramure::test {

TriangleMesh box(const glm::vec3& low, const glm::vec3& high)
{
    TriangleMesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.emplace_back((i & 1u) ? high.x : low.x, (i & 2u) ? high.y : low.y,
                                    (i & 4u) ? high.z : low.z);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

TriangleMesh torus(int around, int across)
{
    TriangleMesh mesh;
    const auto angle = [](int k, int n) { return 2.0 * std::numbers::pi * k / n; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = angle(i, around), v = angle(j, across), r = 2.0 + 0.5 * std::cos(v);
            mesh.positions.emplace_back(r * std::cos(u), 0.5 * std::sin(v), r * std::sin(u));
        }
    const auto at = [&](int i, int j) { return static_cast<Index>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
        }
    return mesh;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b)
{
    TriangleMesh mesh;
    const auto append = [](auto& to, const auto& first, const auto& second, bool wanted) {
        if (!wanted)
            return;
        to = first;
        to.insert(to.end(), second.begin(), second.end());
    };
    append(mesh.positions, a.positions, b.positions, true);
    append(mesh.normals, a.normals, b.normals, a.normals.empty() == b.normals.empty());
    append(mesh.branch, a.branch, b.branch, a.branch.empty() == b.branch.empty());
    append(mesh.level, a.level, b.level, a.level.empty() == b.level.empty());
    append(mesh.triangles, a.triangles, b.triangles, true);
    for (std::size_t f = a.triangles.size(); f < mesh.triangles.size(); ++f)
        mesh.triangles[f] += glm::uvec3(a.vertexCount());
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const glm::vec3& offset)
{
    for (glm::vec3& p : mesh.positions)
        p += offset;
    return mesh;
}

} // namespace ramure::test
