#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_skin.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tst_arm_skin {

using namespace ramure;
using namespace ramure::test;

class TestArmSkin : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void wrongParametersAreErrors();
    void theCylinderIsARegularGrid();
    void restPoseChangesNothing();
    void weightsGoLinearlyAcrossAJoint();
    void windowsNeverOverlap();
    void rigidIsTheSegmentsMatrix();
    void linearMatchesAPlainComputation();
    void dualQuaternionsKeepTheRadius();
    void normalsAreThoseOfTheSurface_data();
    void normalsAreThoseOfTheSurface();
};

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Frame matrices written out anew: T_j * inverse B_j.
std::vector<glm::dmat4> plainMatrices(std::span<const ArmJoint> joints)
{
    std::vector<glm::dmat4> matrices;
    glm::dmat4 at(1.0);
    double height = 0.0;
    for (const ArmJoint& joint : joints) {
        at = glm::rotate(at, joint.phi.angleRad, glm::dvec3(0, 0, 1));
        at = glm::rotate(at, joint.theta.angleRad, glm::dvec3(0, 1, 0));
        matrices.push_back(glm::translate(at, glm::dvec3(0, 0, -height)));
        at = glm::translate(at, glm::dvec3(0, 0, joint.length));
        height += joint.length;
    }
    return matrices;
}

std::vector<RigidTransform> poseOf(std::span<const ArmJoint> joints)
{
    std::vector<RigidTransform> bones;
    ArmChain(joints).pose(bones);
    return bones;
}

/// Two segments of 1.5 m, the second bent.
std::vector<ArmJoint> bent(double thetaRad)
{
    std::vector<ArmJoint> joints(2);
    joints[0].length = joints[1].length = 1.5;
    joints[0].phi.angleRad = 0.4;
    joints[0].theta.angleRad = 0.3;
    joints[1].theta.angleRad = thetaRad;
    return joints;
}

glm::dvec3 at(const glm::dmat4& m, const glm::dvec3& v)
{
    return glm::dvec3(m * glm::dvec4(v, 1.0));
}

/// Where a place of the rest arm goes, weights and blending as C3 and the dual quaternion paper write them.
glm::dvec3 place(std::span<const ArmJoint> joints, std::span<const RigidTransform> bones, double window,
                 const glm::dvec3& v, SkinMethod method)
{
    double s = 0.0;
    for (std::size_t j = 1; j < joints.size(); ++j) {
        s += joints[j - 1].length;
        const double half = std::min({window, joints[j - 1].length / 2, joints[j].length / 2});
        const double t = (v.z - s + half) / (2.0 * half);
        if (t <= 0.0)
            return bones[j - 1].point(v);
        if (t >= 1.0)
            continue;
        if (method == SkinMethod::Linear)
            return (1.0 - t) * bones[j - 1].point(v) + t * bones[j].point(v);
        glm::dquat q0 = bones[j - 1].rotation, q1 = bones[j].rotation;
        if (glm::dot(q0, q1) < 0.0)
            q1 = -q1;
        const glm::dquat d0 = glm::dquat(0.0, bones[j - 1].translation) * q0 * 0.5;
        const glm::dquat d1 = glm::dquat(0.0, bones[j].translation) * q1 * 0.5;
        glm::dquat q = q0 * (1.0 - t) + q1 * t, d = d0 * (1.0 - t) + d1 * t;
        const double length = glm::length(q);
        q = q / length;
        d = d / length;
        const glm::dquat shift = d * glm::conjugate(q) * 2.0;
        return q * v + glm::dvec3(shift.x, shift.y, shift.z);
    }
    return bones.back().point(v);
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

void TestArmSkin::wrongParametersAreErrors()
{
    const auto refused = [](const char* path, auto change) {
        ArmSkinParams params;
        change(params);
        const auto made = armCylinder(defaultArmJoints(), params);
        return !made && made.error().code == ErrorCode::Invalid && made.error().path == path;
    };
    QVERIFY(refused("armSkin.radius", [](ArmSkinParams& p) { p.radius = 0.0; }));
    QVERIFY(refused("armSkin.lengthDivisions", [](ArmSkinParams& p) { p.lengthDivisions = 0; }));
    QVERIFY(refused("armSkin.radialDivisions", [](ArmSkinParams& p) { p.radialDivisions = 2; }));
    QVERIFY(refused("armSkin.radialDivisions", [](ArmSkinParams& p) { p.radialDivisions = 9'000'000; }));
    QVERIFY(!armCylinder({}, {}));
}

void TestArmSkin::theCylinderIsARegularGrid()
{
    ArmSkinParams params;
    params.lengthDivisions = 44;
    params.radialDivisions = 12;
    const TriangleMesh mesh = armCylinder(defaultArmJoints(), params).value();
    QCOMPARE(mesh.vertexCount(), Index(45 * 12 + 2 * 13));
    QCOMPARE(mesh.faceCount(), Index(44 * 12 * 2 + 2 * 12));
    for (Index v = 0; v < 45 * 12; ++v) {
        const glm::vec3& p = mesh.positions[v];
        QVERIFY(std::abs(std::hypot(p.x, p.y) - 0.5F) < 1e-6F);
        QVERIFY(std::abs(p.z - 0.1F * float(v / 12)) < 1e-5F);
        QCOMPARE(mesh.branch[v], v / 12 < 17 ? Index(0) : v / 12 < 32 ? Index(1) : Index(2));
    }
    // Triangles look outwards.
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 face =
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        for (int corner = 0; corner < 3; ++corner)
            QVERIFY(glm::dot(face, mesh.normals[t[corner]]) > 0.0F);
    }
}

void TestArmSkin::restPoseChangesNothing()
{
    std::vector<ArmJoint> straight = defaultArmJoints();
    for (ArmJoint& joint : straight)
        joint.phi.angleRad = joint.theta.angleRad = 0.0;
    const TriangleMesh mesh = armCylinder(straight, {}).value();
    for (const SkinMethod method : {SkinMethod::Rigid, SkinMethod::Linear, SkinMethod::DualQuaternion}) {
        const Skin skin = bindArm(mesh, straight, method != SkinMethod::Rigid, 0.2);
        const TriangleMesh now = deformed(mesh, skin, poseOf(straight), method);
        for (Index v = 0; v < mesh.vertexCount(); ++v) {
            QVERIFY(glm::distance(mesh.positions[v], now.positions[v]) < 1e-6F);
            QVERIFY(glm::distance(mesh.normals[v], now.normals[v]) < 1e-5F);
        }
    }
}

void TestArmSkin::weightsGoLinearlyAcrossAJoint()
{
    TriangleMesh points;
    for (int i = 0; i <= 440; ++i)
        points.positions.emplace_back(0.1F, 0.0F, 0.01F * float(i));
    const Skin skin = bindArm(points, defaultArmJoints(), true, 0.2);
    QCOMPARE(skin.bones, Index(3));
    for (Index v = 0; v < 441; ++v) {
        const SkinInfluence& own = skin.of(v);
        QVERIFY(own.weight[0] >= own.weight[1]);
        QVERIFY(std::abs(own.weight[0] + own.weight[1] - 1.0F) < 1e-6F);
        double second = 0.0;
        for (int i = 0; i < 2; ++i)
            second += own.bone[std::size_t(i)] == 1 ? double(own.weight[std::size_t(i)]) : 0.0;
        const double z = double(points.positions[v].z);
        const double up = std::clamp((z - 1.5) / 0.4, 0.0, 1.0), down = std::clamp((3.4 - z) / 0.4, 0.0, 1.0);
        QVERIFY2(std::abs(second - std::min(up, down)) < 1e-5, qPrintable(QString::number(z)));
    }
}

void TestArmSkin::windowsNeverOverlap()
{
    std::vector<ArmJoint> joints(4);
    for (std::size_t j = 0; j < 4; ++j)
        joints[j].length = j % 2 == 0 ? 0.1 : 1.0;
    TriangleMesh points;
    for (int i = -20; i <= 300; ++i)
        points.positions.emplace_back(0.1F, 0.0F, 0.01F * float(i));
    for (const double window : {0.0, 0.01, 0.2, 5.0}) {
        const Skin skin = bindArm(points, joints, true, window);
        for (const SkinRun& run : skin.runs)
            for (int i = 0; i < 2; ++i) {
                QVERIFY(run.influence.bone[std::size_t(i)] < 4);
                QVERIFY(run.influence.weight[std::size_t(i)] >= 0.0F);
            }
        // The middle of a segment is its own.
        QCOMPARE(skin.of(20 + 60).bone[0], Index(1));
        QCOMPARE(skin.of(20 + 60).weight[0], 1.0F);
        QCOMPARE(skin.of(0).bone[0], Index(0));
        QCOMPARE(skin.of(320).bone[0], Index(3));
    }
}

void TestArmSkin::rigidIsTheSegmentsMatrix()
{
    const std::vector<ArmJoint> joints = defaultArmJoints();
    const TriangleMesh mesh = armCylinder(joints, {}).value();
    const Skin skin = bindArm(mesh, joints, false, 0.2);
    const std::vector<glm::dmat4> plain = plainMatrices(joints);
    const std::vector<RigidTransform> bones = poseOf(joints);
    const TriangleMesh now = deformed(mesh, skin, bones, SkinMethod::Rigid);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const SkinInfluence& own = skin.of(v);
        QCOMPARE(own.bone[0], mesh.branch[v]);
        QCOMPARE(own.weight[0], 1.0F);
        const glm::dvec3 rest(mesh.positions[v]), expected = at(plain[mesh.branch[v]], rest);
        QVERIFY(glm::distance(at(skinMatrix(own, bones, SkinMethod::Rigid), rest), expected) < 1e-14);
        QVERIFY(glm::distance(glm::dvec3(now.positions[v]), expected) < 1e-6);
        const glm::dvec3 normal = glm::dmat3(plain[mesh.branch[v]]) * glm::dvec3(mesh.normals[v]);
        QVERIFY(glm::distance(glm::dvec3(now.normals[v]), normal) < 1e-6);
    }
}

void TestArmSkin::linearMatchesAPlainComputation()
{
    const std::vector<ArmJoint> joints = defaultArmJoints();
    const TriangleMesh mesh = armCylinder(joints, {}).value();
    const std::vector<glm::dmat4> plain = plainMatrices(joints);
    const Skin skin = bindArm(mesh, joints, true, 0.2);
    const TriangleMesh now = deformed(mesh, skin, poseOf(joints), SkinMethod::Linear);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const glm::dvec3 rest(mesh.positions[v]);
        const double up = std::clamp((rest.z - 1.5) / 0.4, 0.0, 1.0);
        const double end = std::clamp((rest.z - 3.0) / 0.4, 0.0, 1.0);
        const glm::dvec3 expected =
            (1.0 - up) * at(plain[0], rest) + (up - end) * at(plain[1], rest) + end * at(plain[2], rest);
        QVERIFY(glm::distance(glm::dvec3(now.positions[v]), expected) < 1e-6);
    }
}

/// In the middle of a joint bent, or twisted, by 120 degrees.
void TestArmSkin::dualQuaternionsKeepTheRadius()
{
    TriangleMesh ring;
    for (int i = 0; i < 64; ++i) {
        const double turn = 2.0 * pi * i / 64.0;
        ring.positions.emplace_back(0.5 * std::cos(turn), 0.5 * std::sin(turn), 1.5);
        ring.normals.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    }
    for (const bool twisted : {false, true}) {
        std::vector<ArmJoint> joints = bent(twisted ? 0.0 : 120.0 * degree);
        joints[1].phi.angleRad = twisted ? 120.0 * degree : 0.0;
        const std::vector<RigidTransform> bones = poseOf(joints);
        const Skin skin = bindArm(ring, joints, true, 0.2);
        const glm::dvec3 centre = ArmChain(joints).points()[1];
        double least[2] = {9.0, 9.0}, most[2] = {0.0, 0.0};
        for (const int method : {0, 1}) {
            const TriangleMesh now =
                deformed(ring, skin, bones, method == 0 ? SkinMethod::Linear : SkinMethod::DualQuaternion);
            for (const glm::vec3& p : now.positions) {
                least[method] = std::min(least[method], glm::distance(glm::dvec3(p), centre));
                most[method] = std::max(most[method], glm::distance(glm::dvec3(p), centre));
            }
        }
        QVERIFY(std::abs(least[0] - 0.25) < 1e-6);
        QVERIFY(least[1] > 0.5 * 0.999 && most[1] < 0.5 * 1.001);
    }
}

void TestArmSkin::normalsAreThoseOfTheSurface_data()
{
    QTest::addColumn<bool>("dual");
    QTest::addColumn<double>("bendRad");
    QTest::addColumn<double>("twistRad");
    for (const double bend : {0.0, 30.0, 90.0, 120.0})
        for (const double twist : {0.0, 60.0})
            for (const bool dual : {false, true})
                QTest::addRow("%s, bend %g, twist %g", dual ? "dual" : "linear", bend, twist)
                    << dual << bend * degree << twist * degree;
}

/// Against finite differences of the places, everywhere but on the very edges of the windows, where the
/// surface has a crease, and where it folds up so that it has no normal.
void TestArmSkin::normalsAreThoseOfTheSurface()
{
    QFETCH(bool, dual);
    QFETCH(double, bendRad);
    QFETCH(double, twistRad);
    const SkinMethod method = dual ? SkinMethod::DualQuaternion : SkinMethod::Linear;
    std::vector<ArmJoint> joints = bent(bendRad);
    joints[1].phi.angleRad = twistRad;
    ArmSkinParams params;
    params.lengthDivisions = 97;
    const TriangleMesh mesh = armCylinder(joints, params).value();
    const Skin skin = bindArm(mesh, joints, true, 0.2);
    const std::vector<RigidTransform> bones = poseOf(joints);
    const TriangleMesh now = deformed(mesh, skin, bones, method);
    constexpr double h = 1e-5;
    int checked = 0;
    for (Index v = 0; v < 98 * 32; ++v) {
        const double turn = 2.0 * pi * double(v % 32) / 32.0, z = double(mesh.positions[v].z);
        const auto surface = [&](double angle, double height) {
            return place(joints, bones, 0.2, {0.5 * std::cos(angle), 0.5 * std::sin(angle), height}, method);
        };
        const glm::dvec3 around = (surface(turn + h, z) - surface(turn - h, z)) / (2.0 * h);
        const glm::dvec3 along = (surface(turn, z + h) - surface(turn, z - h)) / (2.0 * h);
        const glm::dvec3 normal = glm::cross(around, along);
        if (glm::length(normal) < 0.02)
            continue;
        ++checked;
        const double wrong = angleBetween(normal, glm::dvec3(now.normals[v])) / degree;
        QVERIFY2(wrong < 0.5, qPrintable(QStringLiteral("%1 at %2, %3").arg(wrong).arg(z).arg(turn)));
    }
    QVERIFY(checked > 3000);
}

RAMURE_SUITE(TestArmSkin)

} // namespace tst_arm_skin

#include "tst_arm_skin.moc"
