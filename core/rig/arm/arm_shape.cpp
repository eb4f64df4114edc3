#include "core/rig/arm/arm_shape.h"

#include "core/math/finite.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_rods.h"
#include "core/rig/arm/arm_skin.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/primitives/primitive_mesh.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {
namespace {

constexpr Index mostVertices = 10'000'000;

tl::unexpected<Error> wrongMesh(const char* text)
{
    tl::unexpected<Error> error = fail(ErrorCode::Invalid, text);
    error.value().path = "mesh";
    return error;
}

Skin skinOf(const TriangleMesh& mesh, const NodeParams& params)
{
    return bindArm(mesh, params.joints, params.skin.method != SkinMethod::Rigid, params.armSkin.window);
}

/// Every vertex follows the segment that it is of, alone.
ArmShape rigidShape(TriangleMesh mesh, const NodeParams& params)
{
    ArmShape made{std::move(mesh), {}};
    made.skin.vertices = made.mesh.vertexCount();
    made.skin.bones = static_cast<Index>(params.joints.size());
    for (Index v = 0; v < made.skin.vertices; ++v) {
        const Index bone = made.mesh.branch[v];
        if (v == 0 || bone != made.mesh.branch[v - 1])
            made.skin.runs.push_back({v, {{bone, bone, bone}, {1.0F, 0.0F, 0.0F}}});
    }
    made.mesh.branch.clear(); // segments are nothing that can be selected
    return made;
}

Expected<ArmShape> made(const NodeParams& params, const TriangleMesh* bound, ArmPart part, bool solid)
{
    RAMURE_TRY(checkArm(params.joints));
    if (part == ArmPart::Rods) {
        const double radius = params.arm.jointRadius;
        return rigidShape(solid ? armRodSolids(params.joints, radius) : armRods(params.joints, radius),
                          params);
    }
    if (bound) {
        RAMURE_TRY(checkArmMesh(*bound));
        ArmShape shape{*bound, skinOf(*bound, params)};
        if (!solid && shape.mesh.normals.size() != shape.mesh.positions.size())
            computeNormals(shape.mesh);
        return shape;
    }
    auto cylinder = armCylinder(params.joints, params.armSkin);
    RAMURE_TRY(cylinder);
    ArmShape shape{solid ? welded(*cylinder) : std::move(*cylinder), {}};
    shape.mesh.branch.clear();
    shape.skin = skinOf(shape.mesh, params);
    return shape;
}

} // namespace

Expected<void> checkArmMesh(const TriangleMesh& mesh)
{
    if (mesh.triangles.empty())
        return wrongMesh(RAMURE_NOOP("the mesh has no triangles: an arm cannot wear it"));
    if (mesh.vertexCount() > mostVertices)
        return wrongMesh(RAMURE_NOOP("an arm wears a mesh of at most ten million vertices"));
    const Index count = mesh.vertexCount();
    if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                    [count](const glm::uvec3& t) { return t.x >= count || t.y >= count || t.z >= count; }))
        return wrongMesh(RAMURE_NOOP("a triangle of the mesh has a vertex that there is not"));
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), &isFinite<3, float>))
        return wrongMesh(RAMURE_NOOP("the mesh has positions that are not finite"));
    return {};
}

TriangleMesh fittedToArm(TriangleMesh mesh, std::span<const ArmJoint> joints, MeshAxis axis)
{
    if (mesh.positions.empty())
        return mesh;
    glm::vec3 low = mesh.positions.front(), high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
    // One that is as long along Z stands already.
    const int longest = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    const int along =
        axis == MeshAxis::Longest ? longest : static_cast<int>(axis) - static_cast<int>(MeshAxis::X);
    const auto turned = [along](const glm::dvec3& v) {
        return along == 2 ? v : along == 1 ? glm::dvec3(v.z, v.x, v.y) : glm::dvec3(v.y, v.z, v.x);
    };
    double height = 0.0;
    for (const ArmJoint& joint : joints)
        height += joint.length;
    const double scale = size[along] > 0.0 ? height / size[along] : 1.0;
    glm::dvec3 foot = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    foot[along] = double(low[along]);
    for (glm::vec3& p : mesh.positions)
        p = glm::vec3(turned(glm::dvec3(p) - foot) * scale);
    for (glm::vec3& n : mesh.normals)
        n = glm::vec3(turned(glm::dvec3(n)));
    return mesh;
}

Expected<ArmShape> armShape(const NodeParams& params, const TriangleMesh* bound, ArmPart part)
{
    return made(params, bound, part, false);
}

Expected<ArmShape> armSolid(const NodeParams& params, const TriangleMesh* bound, ArmPart part)
{
    return made(params, bound, part, true);
}

TriangleMesh upright(TriangleMesh mesh)
{
    for (std::vector<glm::vec3>* list : {&mesh.positions, &mesh.normals})
        for (glm::vec3& v : *list)
            v = glm::vec3(v.x, v.z, -v.y);
    return mesh;
}

TriangleMesh posedArm(const ArmShape& shape, const NodeParams& params)
{
    if (shape.mesh.positions.empty())
        return {};
    std::vector<RigidTransform> bones;
    ArmChain(params.joints).pose(bones);
    return upright(deformed(shape.mesh, shape.skin, bones, params.skin.method));
}

} // namespace ramure
