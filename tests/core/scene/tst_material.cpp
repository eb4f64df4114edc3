#include "core/scene/material.h"
#include "core/scene/scene.h"
#include "tests/support/suite.h"

namespace tst_material {

using namespace ramure;

class TestMaterial : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void materialsOfTreesAreThoseOfTheReference()
    {
        QCOMPARE(barkMaterial().colour, glm::u8vec3(0x8B, 0x5A, 0x2B));
        QVERIFY(!barkMaterial().phong && leavesMaterial().phong && applesMaterial().phong);
        QVERIFY(leavesMaterial().twoSided && !applesMaterial().twoSided);
    }
    void lightShinesThroughLeavesAlone()
    {
        QVERIFY(leavesMaterial().through > 0.0f && leavesMaterial().variety > 0.0f);
        for (const Material& material : {barkMaterial(), applesMaterial()})
            QVERIFY(material.through == 0.0f && material.variety == 0.0f);
        Node node;
        node.mesh = SharedValue<TriangleMesh>(TriangleMesh());
        node.params.primitive.shape = PrimitiveShape::Plane;
        for (const NodeKind kind : {NodeKind::Primitive, NodeKind::Mesh, NodeKind::Arm, NodeKind::Terrain}) {
            node.kind = kind;
            const Material material = nodeMaterial(node, node.params);
            QVERIFY(material.twoSided && material.through == 0.0f && material.variety == 0.0f);
        }
    }
    void leavesOfPlantsAreOneMaterialEach()
    {
        const Material birch = leavesMaterial(LeafShape::Birch), oak = leavesMaterial(LeafShape::Oak);
        QCOMPARE(birch.name, std::string("leaves_birch"));
        QVERIFY(birch.name != oak.name);
        QVERIFY(birch.tones && birch.twoSided && birch.through > 0.0f && !leavesMaterial().tones);
    }
    void aNodeHasItsColourAndIsOpenWhereItMayBe()
    {
        Node node;
        node.kind = NodeKind::Primitive;
        NodeParams params; // of the time, not the node's own
        params.surface.color = {1.0, 0.5, 0.0};
        QCOMPARE(nodeMaterial(node, params).colour, glm::u8vec3(255, 128, 0));
        QVERIFY(nodeMaterial(node, params).phong && !nodeMaterial(node, params).twoSided);
        node.kind = NodeKind::Arm;
        QVERIFY(!nodeMaterial(node, params).twoSided);
        node.kind = NodeKind::Terrain;
        QVERIFY(!nodeMaterial(node, params).phong);
    }
};

RAMURE_SUITE(TestMaterial)

} // namespace tst_material

#include "tst_material.moc"
