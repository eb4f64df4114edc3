#include "core/surface/foliage/foliage_shapes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr glm::vec3 facing(0.0f, 0.0f, 1.0f);

/// Splits each triangle in four; the new vertices go to the unit sphere.
void split(TriangleMesh& sphere)
{
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), sphere.vertexCount());
        if (isNew)
            sphere.positions.push_back(glm::normalize(sphere.positions[a] + sphere.positions[b]));
        return entry->second;
    };
    const std::vector<glm::uvec3> coarse = std::exchange(sphere.triangles, {});
    for (const glm::uvec3& t : coarse) {
        const Index a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
        for (const glm::uvec3& part :
             {glm::uvec3(t.x, a, c), glm::uvec3(t.y, b, a), glm::uvec3(t.z, c, b), glm::uvec3(a, b, c)})
            sphere.triangles.push_back(part);
    }
}

} // namespace

TriangleMesh unitSquare()
{
    TriangleMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0.0f}, {0.5f, -0.5f, 0.0f}, {0.5f, 0.5f, 0.0f}, {-0.5f, 0.5f, 0.0f}};
    mesh.normals.assign(4, facing);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TriangleMesh unitTriangle()
{
    const float low = -std::numbers::inv_sqrt3_v<float> / 2.0f;
    TriangleMesh mesh;
    mesh.positions = {{-0.5f, low, 0.0f}, {0.5f, low, 0.0f}, {0.0f, -2.0f * low, 0.0f}};
    mesh.normals.assign(3, facing);
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

TriangleMesh unitCube()
{
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-0.5f, 0.5f}) {
            const Index first = mesh.vertexCount();
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = 2.0f * side;
            u[(axis + 1) % 3] = 0.5f;
            // Seen from outside the corners go round counter-clockwise: u, v and the normal are right-handed.
            v[(axis + 2) % 3] = side;
            for (const glm::vec3& corner : {-u - v, u - v, u + v, v - u}) {
                mesh.positions.push_back(0.5f * normal + corner);
                mesh.normals.push_back(normal);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        }
    }
    return mesh;
}

TriangleMesh unitSphere()
{
    const float g = std::numbers::phi_v<float>;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::vec3& position : mesh.positions)
        position = glm::normalize(position);
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    split(mesh);
    split(mesh);
    mesh.normals = mesh.positions;
    return mesh;
}

} // namespace ramure
