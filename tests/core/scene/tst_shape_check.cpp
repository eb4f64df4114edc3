#include "core/scene/shape_check.h"

#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_shape_check {

using namespace ramure;
using namespace ramure::test;

class TestShapeCheck : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void badShapesAreErrors();
    void nodesWithoutAMeshHaveNoFaces();
    void cancellingIsAnError();
    void solidsAreClosed_data();
    void solidsAreClosed();
    void openSurfacesMayHaveABoundary();
    void holesOfImportedMeshesAreDefects();
    void crossingsAreFoundWhereAsked();
};

namespace {

Node nodeOf(NodeKind kind)
{
    Node node;
    node.id = 7;
    node.kind = kind;
    return node;
}

Node primitive(PrimitiveShape shape)
{
    Node node = nodeOf(NodeKind::Primitive);
    node.params.primitive.shape = shape;
    return node;
}

/// The box of a primitive, twice, one through the other.
TriangleMesh twoBoxes()
{
    const auto box = checkShape(primitive(PrimitiveShape::Box), {}, false);
    TriangleMesh both = *box->mesh;
    const Index count = both.vertexCount();
    for (const glm::vec3& at : box->mesh->positions)
        both.positions.push_back(at + glm::vec3(0.31F, 0.17F, 0.23F));
    for (const glm::uvec3& face : box->mesh->triangles)
        both.triangles.push_back(face + glm::uvec3(count));
    both.normals.clear();
    both.uv.clear();
    both.branch.clear();
    return both;
}

} // namespace

void TestShapeCheck::badShapesAreErrors()
{
    Node arm = nodeOf(NodeKind::Arm);
    arm.params.joints.clear();
    QVERIFY(!checkShape(arm, arm.params, true));
    Node terrain = nodeOf(NodeKind::Terrain);
    terrain.params.terrain.divisions = -3;
    QVERIFY(!checkShape(terrain, terrain.params, true));
    TriangleMesh broken;
    broken.positions.resize(3);
    broken.triangles.emplace_back(0, 1, 9);
    QVERIFY(!checkMesh(std::make_shared<const TriangleMesh>(broken), true));
}

void TestShapeCheck::nodesWithoutAMeshHaveNoFaces()
{
    for (const NodeKind kind : {NodeKind::Group, NodeKind::Mesh}) {
        const Node node = nodeOf(kind);
        const auto check = checkShape(node, node.params, true);
        QVERIFY(check && check->mesh && check->mesh->empty());
        QVERIFY(!check->report.valid && check->report.faces == 0);
    }
}

void TestShapeCheck::cancellingIsAnError()
{
    std::stop_source stop;
    stop.request_stop();
    const Node terrain = nodeOf(NodeKind::Terrain);
    const auto check = checkShape(terrain, terrain.params, true, Progress{stop.get_token(), {}});
    QVERIFY(!check);
    QCOMPARE(check.error().code, ErrorCode::Cancelled);
}

void TestShapeCheck::solidsAreClosed_data()
{
    QTest::addColumn<int>("shape"); // -1: the arm with its skin, -2: its rods
    QTest::newRow("box") << int(PrimitiveShape::Box);
    QTest::newRow("cylinder") << int(PrimitiveShape::Cylinder);
    QTest::newRow("sphere") << int(PrimitiveShape::Sphere);
    QTest::newRow("skin") << -1;
    QTest::newRow("rods") << -2;
}

void TestShapeCheck::solidsAreClosed()
{
    QFETCH(int, shape);
    Node node = shape < 0 ? armDemo().nodes()[0] : primitive(PrimitiveShape(shape));
    node.params.armSkin.shown = shape == -1;
    const auto check = checkShape(node, node.params, false);
    QVERIFY(check && !check->isOpen);
    QVERIFY(check->report.valid && check->report.openMeshAgrees);
    QCOMPARE(check->report.boundaryEdges, Index(0));
    QVERIFY(check->analysis.hash == meshHash(*check->mesh));
    QVERIFY(check->analysis.quality.smallestAngleFace != noIndex);
}

void TestShapeCheck::openSurfacesMayHaveABoundary()
{
    for (const Node& node : {nodeOf(NodeKind::Terrain), primitive(PrimitiveShape::Plane)}) {
        const auto check = checkShape(node, node.params, true);
        QVERIFY(check && check->isOpen);
        QVERIFY(check->report.boundaryEdges > 0 && check->report.valid);
        QCOMPARE(check->analysis.crossings.total(), std::uint64_t(0));
    }
}

void TestShapeCheck::holesOfImportedMeshesAreDefects()
{
    TriangleMesh open = twoBoxes();
    open.triangles.pop_back();
    Node node = nodeOf(NodeKind::Mesh);
    node.mesh = SharedValue<TriangleMesh>(open);
    const auto check = checkShape(node, node.params, false);
    QVERIFY(check && !check->isOpen && !check->report.valid);
    QCOMPARE(check->report.boundaryEdges, Index(3));
}

void TestShapeCheck::crossingsAreFoundWhereAsked()
{
    const auto mesh = std::make_shared<const TriangleMesh>(twoBoxes());
    const auto asked = checkMesh(mesh, true), unasked = checkMesh(mesh, false);
    QVERIFY(asked && unasked);
    QVERIFY(asked->report.valid && asked->report.components == 2);
    QVERIFY(asked->analysis.crossings.total() > 0 && !asked->analysis.crossings.kindsKnown);
    QCOMPARE(unasked->analysis.crossings.total(), std::uint64_t(0));
    QVERIFY(asked->analysis.hash == unasked->analysis.hash);
}

RAMURE_SUITE(TestShapeCheck)

} // namespace tst_shape_check

#include "tst_shape_check.moc"
