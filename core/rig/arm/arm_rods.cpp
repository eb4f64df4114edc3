#include "core/rig/arm/arm_rods.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/primitives/primitive_mesh.h"
#include <algorithm>

namespace ramure {
namespace {

constexpr int sides = 24, rings = 12;
constexpr double rodPart = 0.45; ///< radius of a rod, of that of a joint
constexpr double tipPart = 0.6;  ///< the tip is a little smaller: it is no joint

/// A surface of revolution about Z that is added to a mesh.
class Turned
{
public:
    Turned(TriangleMesh& mesh, Index segment)
        : m_mesh(mesh)
        , m_segment(segment)
    {
    }
    /// A ring at height \p z; from the second on it is joined to the one before.
    void ring(double z, double radius, const glm::dvec2& normal)
    {
        const Index first = m_mesh.vertexCount();
        for (int i = 0; i <= sides; ++i) {
            const auto [sine, cosine] = maths::sincos(2.0 * pi * i / sides);
            m_mesh.positions.emplace_back(radius * cosine, radius * sine, z);
            m_mesh.normals.emplace_back(normal.x * cosine, normal.x * sine, normal.y);
            m_mesh.branch.push_back(m_segment);
        }
        for (Index i = 0; m_rings > 0 && i < Index(sides); ++i) {
            const Index a = first - Index(sides) - 1 + i, b = first + i;
            m_mesh.triangles.emplace_back(a, a + 1, b + 1);
            m_mesh.triangles.emplace_back(a, b + 1, b);
        }
        ++m_rings;
    }

private:
    TriangleMesh& m_mesh;
    Index m_segment;
    int m_rings = 0;
};

void addSphere(TriangleMesh& mesh, Index segment, double z, double radius)
{
    Turned turned(mesh, segment);
    for (int i = 0; i <= rings; ++i) {
        const auto [sine, cosine] = maths::sincos(pi * (double(i) / rings - 0.5));
        turned.ring(z + radius * sine, radius * cosine, {cosine, sine});
    }
}

/// Adds a primitive at height \p z.
void addSolid(TriangleMesh& mesh, const PrimitiveParams& params, Index segment, double z)
{
    const TriangleMesh solid = primitiveSolid(params);
    const Index first = mesh.vertexCount();
    for (const glm::vec3& p : solid.positions) {
        mesh.positions.emplace_back(glm::dvec3(p) + glm::dvec3(0.0, 0.0, z));
        mesh.branch.push_back(segment);
    }
    for (const glm::uvec3& t : solid.triangles)
        mesh.triangles.push_back(t + glm::uvec3(first));
}

/// Calls for every part of the straight arm.
template <class Joint, class Rod>
void forParts(std::span<const ArmJoint> joints, double jointRadius, const Joint& joint, const Rod& rod)
{
    if (jointRadius <= 0.0 || joints.empty())
        return;
    double height = 0.0;
    for (Index j = 0; j < joints.size(); ++j) {
        joint(j, height, jointRadius);
        rod(j, height, joints[j].length);
        height += joints[j].length;
    }
    joint(static_cast<Index>(joints.size() - 1), height, tipPart * jointRadius);
}

} // namespace

TriangleMesh armRods(std::span<const ArmJoint> joints, double jointRadius)
{
    TriangleMesh mesh;
    const double radius = rodPart * jointRadius;
    const auto rod = [&](Index segment, double z, double length) {
        Turned turned(mesh, segment);
        turned.ring(z, radius, {1.0, 0.0});
        turned.ring(z + length, radius, {1.0, 0.0});
    };
    forParts(
        joints, jointRadius, [&](Index j, double z, double r) { addSphere(mesh, j, z, r); }, rod);
    return mesh;
}

TriangleMesh armRodSolids(std::span<const ArmJoint> joints, double jointRadius)
{
    TriangleMesh mesh;
    PrimitiveParams params;
    params.axis = PrimitiveAxis::Z;
    params.sides = sides;
    const auto ball = [&](Index segment, double z, double radius) {
        params.shape = PrimitiveShape::Sphere;
        params.radius = radius;
        addSolid(mesh, params, segment, z);
    };
    const auto rod = [&](Index segment, double z, double length) {
        // Ends inside the spheres: those of two rods would have the same vertices.
        const double inset = 0.25 * std::min(jointRadius, length);
        params.shape = PrimitiveShape::Cylinder;
        params.radius = rodPart * jointRadius;
        params.height = length - 2.0 * inset;
        addSolid(mesh, params, segment, z + inset);
    };
    forParts(joints, jointRadius, ball, rod);
    return mesh;
}

} // namespace ramure
