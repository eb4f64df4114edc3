#include "core/surface/texture/object_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace ramure {

void addBoxTexture(TriangleMesh& mesh)
{
    glm::vec3 low(0.0f), high(0.0f);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        low = v == 0 ? mesh.positions[v] : glm::min(low, mesh.positions[v]);
        high = v == 0 ? mesh.positions[v] : glm::max(high, mesh.positions[v]);
    }
    const glm::vec3 extent = high - low;
    const float side = std::max({extent.x, extent.y, extent.z, 1e-20f});
    mesh.uv.clear();
    mesh.uvTriangles.clear();
    mesh.uv.reserve(3 * mesh.triangles.size());
    mesh.uvTriangles.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 normal =
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        const glm::vec3 facing = glm::abs(normal);
        const auto first = static_cast<Index>(mesh.uv.size());
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = (mesh.positions[t[corner]] - low) / side;
            if (facing.y > facing.x && facing.y > facing.z)
                mesh.uv.emplace_back(p.x, normal.y < 0.0f ? p.z : -p.z);
            else if (facing.x > facing.z)
                mesh.uv.emplace_back(normal.x < 0.0f ? p.z : -p.z, p.y);
            else
                mesh.uv.emplace_back(normal.z < 0.0f ? -p.x : p.x, p.y);
        }
        mesh.uvTriangles.emplace_back(first, first + 1, first + 2);
    }
}

TriangleMesh splitByTexture(const TriangleMesh& mesh)
{
    TriangleMesh out = mesh;
    if (out.uv.empty())
        addBoxTexture(out);
    if (out.uvTriangles.empty())
        return out;
    const std::vector<glm::uvec3> coordinates = std::move(out.uvTriangles);
    const std::vector<glm::vec2> uv = std::move(out.uv);
    out.uvTriangles.clear();
    std::vector<Index> from; // per new vertex the one it copies
    out.uv.clear();
    std::map<std::pair<Index, std::pair<float, float>>, Index> places;
    for (std::size_t t = 0; t < out.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec2 at = uv[coordinates[t][corner]];
            Index& vertex = out.triangles[t][corner];
            const auto [place, isNew] =
                places.try_emplace({vertex, {at.x, at.y}}, static_cast<Index>(from.size()));
            if (isNew) {
                from.push_back(vertex);
                out.uv.push_back(at);
            }
            vertex = place->second;
        }
    const auto copied = [&from](const auto& values) {
        std::decay_t<decltype(values)> all;
        all.reserve(values.empty() ? 0 : from.size());
        for (std::size_t v = 0; v < from.size() && !values.empty(); ++v)
            all.push_back(values[from[v]]);
        return all;
    };
    out.positions = copied(mesh.positions);
    out.normals = copied(mesh.normals);
    out.branch = copied(mesh.branch);
    out.level = copied(mesh.level);
    return out;
}

} // namespace ramure
