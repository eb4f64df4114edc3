#include "core/mesh/rough_model.h"

#include "core/geometry/frame.h"
#include "core/geometry/ring.h"
#include <algorithm>

namespace ramure {
namespace {

class ConeWriter
{
public:
    ConeWriter(const Skeleton& skeleton, int sides, TriangleMesh& mesh)
        : m_skeleton(skeleton)
        , m_mesh(mesh)
        , m_sides(static_cast<Index>(sides))
    {
        for (const glm::dvec2& on : unitCircle(sides))
            m_circle.emplace_back(on);
    }

    void add(Index branch)
    {
        const glm::dvec3 axis = m_skeleton.p1[branch] - m_skeleton.p0[branch];
        const double length = glm::length(axis);
        const Frame frame = frameFromTangent(axis / length);
        const double a0 = m_skeleton.a0[branch], a1 = m_skeleton.a1[branch];
        // The surface leans by the slope of the radius; its normal leans the other way.
        const double slope = (a0 - a1) / length;
        const double across = 1.0 / glm::length(glm::dvec2(1.0, slope));
        const Index first = m_vertex;
        addRing(m_skeleton.p0[branch], a0, frame, across, slope * across);
        addRing(m_skeleton.p1[branch], a1, frame, across, slope * across);
        for (Index i = first; i < m_vertex; ++i) {
            m_mesh.branch[i] = branch;
            m_mesh.level[i] = m_skeleton.level[branch];
        }
        for (Index k = 0; k < m_sides; ++k) {
            const Index next = k + 1 == m_sides ? 0 : k + 1;
            const Index low = first, high = first + m_sides;
            m_mesh.triangles[m_face++] = {low + k, low + next, high + next};
            m_mesh.triangles[m_face++] = {low + k, high + next, high + k};
        }
    }

private:
    void addRing(const glm::dvec3& centre, double radius, const Frame& frame, double across, double along)
    {
        const glm::vec3 middle(centre), lean(along * frame.tangent);
        const glm::vec3 normal(frame.normal), binormal(frame.binormal);
        const auto size = static_cast<float>(radius);
        const auto part = static_cast<float>(across);
        for (const glm::vec2& on : m_circle) {
            const glm::vec3 outward = on.x * normal + on.y * binormal;
            m_mesh.positions[m_vertex] = middle + size * outward;
            m_mesh.normals[m_vertex++] = part * outward + lean;
        }
    }

    const Skeleton& m_skeleton;
    TriangleMesh& m_mesh;
    Index m_sides;
    Index m_vertex = 0, m_face = 0;
    std::vector<glm::vec2> m_circle;
};

} // namespace

TriangleMesh buildRoughBranches(const Skeleton& skeleton, int radialDivisions)
{
    const int sides = std::max(radialDivisions, 3);
    const auto hasLength = [&](Index branch) { return skeleton.length(branch) > 0.0; };
    std::size_t count = 0;
    for (Index i = 0; i < skeleton.size(); ++i)
        count += hasLength(i) ? 1 : 0;
    TriangleMesh mesh;
    const std::size_t vertices = count * 2 * static_cast<std::size_t>(sides);
    mesh.positions.resize(vertices);
    mesh.normals.resize(vertices);
    mesh.branch.resize(vertices);
    mesh.level.resize(vertices);
    mesh.triangles.resize(vertices);
    ConeWriter writer(skeleton, sides, mesh);
    for (Index i = 0; i < skeleton.size(); ++i)
        if (hasLength(i))
            writer.add(i);
    return mesh;
}

} // namespace ramure
