/// \file
/// A small hand-made tree for the tests of the renderer: no grammar, no mesher, only cones and triangles.
#pragma once

#include "core/math/random.h"
#include "core/skeleton/skeleton.h"
#include "widgets/view/render/render_scene.h"
#include <QString>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace ramure::test {

/// \p levels of forks with three children each; the trunk is one metre long. p1 of branch 0 is (0, 1, 0).
inline Skeleton sampleSkeleton(int levels)
{
    Skeleton skeleton;
    skeleton.add(noIndex, glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0), 0.07, 0.05);
    Index first = 0;
    for (int level = 1; level <= levels; ++level) {
        const Index end = skeleton.size();
        for (Index parent = first; parent < end; ++parent) {
            const glm::dvec3 axis = glm::normalize(skeleton.p1[parent] - skeleton.p0[parent]);
            const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.31, 0.2, 0.93)));
            for (int child = 0; child < 3; ++child) {
                const double turn = 2.0 * std::numbers::pi * (child / 3.0 + 0.13 * level);
                const glm::dvec3 out = std::cos(turn) * side + std::sin(turn) * glm::cross(axis, side);
                const glm::dvec3 way = glm::normalize(axis + 0.75 * out + glm::dvec3(0.0, 0.15, 0.0));
                const double radius = skeleton.a1[parent];
                const glm::dvec3 from = skeleton.p1[parent];
                skeleton.add(parent, from, from + way * std::pow(0.72, level), radius, 0.66 * radius,
                             Index(level));
            }
        }
        first = end;
    }
    return skeleton;
}

/// An open cone per branch, smooth normals, branch ids.
inline TriangleMesh sampleBranches(const Skeleton& skeleton, Index sides = 10)
{
    TriangleMesh mesh;
    for (Index i = 0; i < skeleton.size(); ++i) {
        const glm::dvec3 axis = glm::normalize(skeleton.p1[i] - skeleton.p0[i]);
        const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0.31, 0.2, 0.93)));
        const glm::dvec3 y = glm::cross(axis, x);
        const Index base = mesh.vertexCount();
        for (Index k = 0; k < 2 * sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * double(k % sides) / double(sides);
            const glm::dvec3 out = std::cos(angle) * x + std::sin(angle) * y;
            const bool top = k >= sides;
            mesh.positions.emplace_back((top ? skeleton.p1[i] : skeleton.p0[i]) +
                                        (top ? skeleton.a1[i] : skeleton.a0[i]) * out);
            mesh.normals.emplace_back(out);
            mesh.branch.push_back(i);
            mesh.level.push_back(skeleton.level[i]);
        }
        for (Index k = 0; k < sides; ++k) {
            const Index a = base + k;
            const Index b = base + (k + 1) % sides;
            mesh.triangles.emplace_back(a, b, b + sides);
            mesh.triangles.emplace_back(a, b + sides, a + sides);
        }
    }
    return mesh;
}

/// \p perBranch small triangles around every branch of the last level.
inline TriangleMesh sampleLeaves(const Skeleton& skeleton, int perBranch, double side = 0.09)
{
    TriangleMesh mesh;
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (skeleton.level[i] != skeleton.level.back())
            continue;
        Random random(7, RandomStream::Test, i);
        for (int leaf = 0; leaf < perBranch; ++leaf) {
            // One statement a number: compilers may choose the order of arguments.
            const auto unit = [&random] {
                const double z = random.range(-1.0, 1.0);
                const double y = random.range(-1.0, 1.0);
                const double x = random.range(-1.0, 1.0);
                return glm::dvec3(x, y, z);
            };
            const glm::dvec3 aside = 0.6 * side * unit();
            const glm::dvec3 at = glm::mix(skeleton.p0[i], skeleton.p1[i], random.range(0.0, 1.2)) + aside;
            const glm::dvec3 u = glm::normalize(unit() + glm::dvec3(1e-3));
            const glm::dvec3 v = glm::normalize(glm::cross(u, unit() + glm::dvec3(0.0, 2e-3, 1e-3)));
            const Index base = mesh.vertexCount();
            mesh.positions.emplace_back(at);
            mesh.positions.emplace_back(at + side * u);
            mesh.positions.emplace_back(at + side * (0.5 * u + 0.866 * v));
            mesh.normals.insert(mesh.normals.end(), 3, glm::vec3(glm::cross(u, v)));
            mesh.branch.insert(mesh.branch.end(), 3, i);
            mesh.level.insert(mesh.level.end(), 3, skeleton.level[i]);
            mesh.triangles.emplace_back(base, base + 1, base + 2);
        }
    }
    return mesh;
}

inline Material sampleMaterial(const char* name)
{
    if (QLatin1String(name) == QLatin1String("leaves"))
        return leavesMaterial();
    return {name, {0x8B, 0x5A, 0x2B}, false, true};
}

inline MeshItem sampleItem(TriangleMesh mesh, const char* material, NodeId node = 1)
{
    MeshItem item;
    item.box = meshBox(mesh);
    item.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    item.material = sampleMaterial(material);
    item.node = node;
    return item;
}

/// Branches and leaves, standing on the ground.
inline RenderScene sampleScene(int levels = 4, int leaves = 8)
{
    const Skeleton skeleton = sampleSkeleton(levels);
    RenderScene scene;
    scene.meshes.push_back(sampleItem(sampleBranches(skeleton), "branches"));
    if (leaves > 0)
        scene.meshes.push_back(sampleItem(sampleLeaves(skeleton, leaves), "leaves"));
    scene.updateBoxes();
    return scene;
}

} // namespace ramure::test
