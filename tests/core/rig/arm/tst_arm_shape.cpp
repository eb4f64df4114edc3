#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/surface/proof/validate.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <glm/geometric.hpp>
#include <limits>

namespace tst_arm_shape {

using namespace ramure;

namespace {

NodeParams bentArm()
{
    NodeParams params;
    params.joints[1].theta.angleRad = 1.2;
    return params;
}

/// A post of square cross-section around the straight arm, cut into many rings; with texture coordinates.
TriangleMesh post(double height, int rings)
{
    TriangleMesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (const glm::vec2& corner :
             {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
            mesh.positions.emplace_back(0.3F * corner.x, 0.3F * corner.y, float(height * ring / rings));
            mesh.uv.emplace_back(corner.x, float(ring));
        }
    for (Index ring = 0; ring < Index(rings); ++ring)
        for (Index i = 0; i < 4; ++i) {
            const Index a = 4 * ring + i, b = 4 * ring + (i + 1) % 4;
            mesh.triangles.emplace_back(a, b, b + 4);
            mesh.triangles.emplace_back(a, b + 4, a + 4);
        }
    return mesh;
}

std::vector<RigidTransform> poseOf(const NodeParams& params)
{
    std::vector<RigidTransform> bones;
    ArmChain(params.joints).pose(bones);
    return bones;
}

} // namespace

/// What arms wear.
class TestArmShape : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badMeshesAreRefused()
    {
        const auto refused = [](const TriangleMesh& mesh) {
            const auto checked = checkArmMesh(mesh);
            const auto shape = armShape({}, &mesh, ArmPart::Skin);
            return !checked && checked.error().path == "mesh" && !shape && shape.error().path == "mesh" &&
                   !armSolid({}, &mesh, ArmPart::Skin);
        };
        QVERIFY(refused({}));
        TriangleMesh mesh = post(4.4, 2);
        mesh.triangles.clear();
        QVERIFY(refused(mesh));
        mesh = post(4.4, 2);
        mesh.triangles.back().z = mesh.vertexCount();
        QVERIFY(refused(mesh));
        mesh = post(4.4, 2);
        mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(refused(mesh));
        NodeParams params;
        params.joints.clear();
        mesh = post(4.4, 2);
        QVERIFY(!armShape(params, &mesh, ArmPart::Skin));
        QVERIFY(!armShape(params, nullptr, ArmPart::Rods));
    }

    void aWornMeshKeepsWhatItIsMadeOf()
    {
        const TriangleMesh mesh = post(4.4, 44);
        const auto shape = armSolid(bentArm(), &mesh, ArmPart::Skin);
        QVERIFY(shape);
        QCOMPARE(shape->mesh, mesh); // as it was read, texture coordinates too
        const TriangleMesh posed = posedArm(*shape, bentArm());
        QCOMPARE(posed.uv, mesh.uv);
        QCOMPARE(posed.triangles, mesh.triangles);
        // To look at it has normals.
        QCOMPARE(armShape(bentArm(), &mesh, ArmPart::Skin)->mesh.normals.size(), mesh.positions.size());
    }

    void eachVertexFollowsTheNearestSegment()
    {
        NodeParams params = bentArm();
        params.skin.method = SkinMethod::Rigid;
        const TriangleMesh mesh = post(4.4, 44);
        const auto shape = armSolid(params, &mesh, ArmPart::Skin);
        const auto bones = poseOf(params);
        const TriangleMesh posed = posedArm(*shape, params);
        for (Index v = 0; v < mesh.vertexCount(); ++v) {
            const double z = double(mesh.positions[v].z);
            const std::size_t segment = z < 1.7 ? 0 : z < 3.2 ? 1 : 2;
            if (std::abs(z - 1.7) < 1e-3 || std::abs(z - 3.2) < 1e-3)
                continue; // a joint is of both
            const glm::dvec3 own = bones[segment].point(glm::dvec3(mesh.positions[v]));
            QVERIFY(glm::distance(glm::dvec3(posed.positions[v]), {own.x, own.z, -own.y}) < 2e-6);
        }
    }

    void theWindowIsShared()
    {
        NodeParams params = bentArm();
        params.skin.method = SkinMethod::Linear;
        const TriangleMesh mesh = post(4.4, 440);
        const auto shape = armSolid(params, &mesh, ArmPart::Skin);
        const auto bones = poseOf(params);
        const TriangleMesh posed = posedArm(*shape, params);
        for (Index v = 0; v < mesh.vertexCount(); ++v) {
            // A plain computation (SPEC C3): linear within 0.2 m of a joint.
            const glm::dvec3 rest(mesh.positions[v]);
            const double first = std::clamp((rest.z - 1.5) / 0.4, 0.0, 1.0);
            const double second = std::clamp((rest.z - 3.0) / 0.4, 0.0, 1.0);
            const glm::dvec3 own = (1.0 - first) * bones[0].point(rest) +
                                   (first - second) * bones[1].point(rest) + second * bones[2].point(rest);
            QVERIFY(glm::distance(glm::dvec3(posed.positions[v]), {own.x, own.z, -own.y}) < 1e-5);
        }
    }

    void fittedMeshesStandOnTheFoot()
    {
        const std::vector<ArmJoint> joints = defaultArmJoints();
        for (const glm::vec3& size : {glm::vec3(1, 2, 8), glm::vec3(1, 8, 2), glm::vec3(8, 1, 2)}) {
            const TriangleMesh box = test::moved(test::box(glm::vec3(0.0F), size), {3, -4, 5});
            const TriangleMesh fitted = fittedToArm(box, joints);
            glm::vec3 low(1e9F), high(-1e9F);
            for (const glm::vec3& p : fitted.positions) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            QVERIFY(std::abs(low.z) < 1e-6F && std::abs(high.z - 4.4F) < 1e-5F);
            QVERIFY(std::abs(low.x + high.x) < 1e-5F && std::abs(low.y + high.y) < 1e-5F);
            // Turned, not mirrored, and the same scale all around.
            const auto before = validateMesh(box), after = validateMesh(fitted);
            QVERIFY(before && after);
            QVERIFY(std::abs(after->volume - before->volume * std::pow(4.4 / 8.0, 3)) < 1e-4);
        }
        QVERIFY(fittedToArm({}, joints).positions.empty());
        TriangleMesh point;
        point.positions = {{2, 2, 2}};
        QCOMPARE(fittedToArm(point, joints).positions.front(), glm::vec3(0.0F));
    }

    void solidsAreClosed()
    {
        for (const ArmPart part : {ArmPart::Skin, ArmPart::Rods}) {
            const auto shape = armSolid(bentArm(), nullptr, part);
            QVERIFY(shape);
            const auto report = validateMesh(posedArm(*shape, bentArm()));
            QVERIFY(report && report->valid);
        }
    }
};

RAMURE_SUITE(TestArmShape)

} // namespace tst_arm_shape

#include "tst_arm_shape.moc"
