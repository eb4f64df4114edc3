#include "core/math/box.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"
#include "widgets/view/render/crowd/far_shape.h"
#include <algorithm>

namespace tst_far_shape {

using namespace ramure;

namespace {

/// Seen along \p way: half of what all its faces cover, front and back.
double shadow(const TriangleMesh& mesh, const glm::dvec3& way)
{
    double area = 0.0;
    for (const glm::uvec3& face : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[face[0]]), b(mesh.positions[face[1]]), c(mesh.positions[face[2]]);
        area += 0.5 * std::abs(glm::dot(glm::cross(b - a, c - a), way));
    }
    return area;
}

Box boxOf(const TriangleMesh& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions)
        box.add(glm::dvec3(position));
    return box;
}

} // namespace

class TestFarShape : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingIsLeftOfNothing()
    {
        QVERIFY(farShape({}).empty());
        TriangleMesh line;
        line.positions.assign(3, glm::vec3(1.0f));
        line.triangles = {{0, 1, 2}};
        QVERIFY(farShape(line).empty());
    }
    void aLeafBecomesTwoTrianglesOfItsArea()
    {
        for (int shape = int(LeafShape::Faithful) + 1; shape < leafShapeCount; ++shape) {
            LeafForm form;
            form.shape = LeafShape(shape);
            form.detail = 1;
            const TriangleMesh leaf = oneLeaf(form, 0.3, FoliageModel::Fine), far = farShape(leaf);
            QVERIFY(far.faceCount() == 2 || far.faceCount() == 8);
            QCOMPARE(far.normals.size(), far.positions.size());
            Box room = boxOf(leaf).grown(0.7 * boxOf(leaf).radius()), both = room;
            both.add(boxOf(far));
            QVERIFY2(both.size() == room.size(), qPrintable(QString::number(shape)));
            if (far.faceCount() != 2)
                continue;
            double area = 0.0;
            for (const glm::uvec3& face : leaf.triangles)
                area += 0.5 * glm::length(glm::cross(leaf.positions[face[1]] - leaf.positions[face[0]],
                                                     leaf.positions[face[2]] - leaf.positions[face[0]]));
            const double flat = shadow(far, glm::dvec3(far.normals[0]));
            QVERIFY(std::abs(flat - area) < 1e-4 * area);
            const glm::dvec3 up(far.normals[0]);
            const glm::vec3 facing =
                glm::cross(far.positions[1] - far.positions[0], far.positions[2] - far.positions[0]);
            QVERIFY(glm::dot(glm::dvec3(facing), up) > 0.0);
        }
    }
    void aSimplerLeafGetsTheAreaOfTheWhole()
    {
        LeafForm form;
        form.shape = LeafShape::Linden;
        const TriangleMesh whole = oneLeaf(form, 0.3, FoliageModel::Fine);
        form.detail = 1;
        const TriangleMesh few = oneLeaf(form, 0.3, FoliageModel::Fine), wide = widened(few, whole);
        QVERIFY(few.faceCount() < whole.faceCount());
        QCOMPARE(wide.faceCount(), few.faceCount());
        const glm::dvec3 up(farShape(whole).normals[0]);
        const double wanted = shadow(whole, up);
        QVERIFY(shadow(few, up) < 0.95 * wanted);
        QVERIFY(std::abs(shadow(wide, up) - wanted) < 0.15 * wanted);
        QVERIFY(widened({}, whole).empty());
        QVERIFY(widened(whole, few).positions == whole.positions); // never narrower
    }
    void aFruitStaysAsWideAsItIs()
    {
        const TriangleMesh fruit = oneApple({}, 0.3, FoliageModel::Fine), far = farShape(fruit);
        QCOMPARE(far.faceCount(), 8u);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 way(0.0);
            way[axis] = 1.0;
            const double was = shadow(fruit, way), is = shadow(far, way);
            QVERIFY2(is > 0.7 * was && is < 1.4 * was, qPrintable(QString::number(is / was)));
        }
        const glm::dvec3 centre = boxOf(far).centre();
        for (const glm::uvec3& face : far.triangles) {
            const glm::dvec3 a(far.positions[face[0]]), b(far.positions[face[1]]), c(far.positions[face[2]]);
            QVERIFY(glm::dot(glm::cross(b - a, c - a), a - centre) > 0.0); // outwards
        }
    }
};

RAMURE_SUITE(TestFarShape)

} // namespace tst_far_shape

#include "tst_far_shape.moc"
