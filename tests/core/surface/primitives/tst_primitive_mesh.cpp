#include "core/surface/primitives/primitive_mesh.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"

#include <glm/geometric.hpp>
#include <numbers>

namespace tst_primitive_mesh {

using namespace ramure;

class TestPrimitiveMesh : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void solidsAreClosed_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("volume"); ///< of a round one with very many sides
        QTest::addColumn<int>("pieces");
        const double pi = std::numbers::pi;
        QTest::newRow("cylinder") << int(PrimitiveShape::Cylinder) << pi * 0.25 * 2.0 << 1;
        QTest::newRow("sphere") << int(PrimitiveShape::Sphere) << 4.0 / 3.0 * pi * 0.125 << 1;
        QTest::newRow("box") << int(PrimitiveShape::Box) << 6.0 << 1;
        QTest::newRow("cone") << int(PrimitiveShape::Cone) << pi * 0.25 * 2.0 / 3.0 << 1;
        QTest::newRow("frame cross") << int(PrimitiveShape::FrameCross) << 0.0 << 3;
    }
    void solidsAreClosed()
    {
        QFETCH(int, shape);
        QFETCH(double, volume);
        QFETCH(int, pieces);
        for (const PrimitiveAxis axis : {PrimitiveAxis::X, PrimitiveAxis::Y, PrimitiveAxis::Z})
            for (const std::int64_t sides : {3, 4, 20, 400}) {
                const PrimitiveParams params{
                    static_cast<PrimitiveShape>(shape), 0.5, 2.0, {1.0, 2.0, 3.0}, sides, axis};
                const auto report = validateMesh(primitiveSolid(params));
                QVERIFY2(report, test::why(report));
                QVERIFY(report->valid);
                QCOMPARE(report->components, Index(pieces));
                QCOMPARE(report->eulerCharacteristic, std::int64_t(2 * pieces));
                if (sides == 400 && volume > 0.0)
                    QVERIFY2(std::abs(report->volume / volume - 1.0) < 1e-3,
                             qPrintable(QString::number(report->volume)));
            }
    }
    void normalsPointOut_data()
    {
        QTest::addColumn<int>("shape");
        for (int shape = 0; shape <= int(PrimitiveShape::FrameCross); ++shape)
            QTest::addRow("%d", shape) << shape;
    }
    void normalsPointOut()
    {
        QFETCH(int, shape);
        for (const PrimitiveAxis axis : {PrimitiveAxis::X, PrimitiveAxis::Y, PrimitiveAxis::Z}) {
            const TriangleMesh mesh =
                primitiveMesh({static_cast<PrimitiveShape>(shape), 0.5, 2.0, {1.0, 2.0, 3.0}, 20, axis});
            QCOMPARE(mesh.normals.size(), mesh.positions.size());
            for (const glm::vec3& n : mesh.normals)
                QVERIFY(std::abs(glm::length(n) - 1.0f) < 1e-5f);
            for (const glm::uvec3& t : mesh.triangles) {
                const glm::vec3 face = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                                  mesh.positions[t.z] - mesh.positions[t.x]);
                for (int corner = 0; corner < 3; ++corner)
                    QVERIFY(glm::dot(face, mesh.normals[t[corner]]) > 0.0f);
            }
        }
    }
    void planeIsOpen()
    {
        const auto report = validateMesh(primitiveSolid({PrimitiveShape::Plane}));
        QVERIFY(report && !report->valid);
        QCOMPARE(report->boundaryEdges, Index(4));
    }
};

RAMURE_SUITE(TestPrimitiveMesh)

} // namespace tst_primitive_mesh

#include "tst_primitive_mesh.moc"
