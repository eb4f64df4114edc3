#include "core/surface/check/texture_report.h"
#include "core/surface/foliage/foliage_shapes.h"
#include "core/surface/foliage/foliage_texture.h"
#include "tests/support/suite.h"

namespace tst_foliage_texture {

using namespace ramure;
using namespace ramure::test;

class TestFoliageTexture : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void nothingForNothing();
    void leavesHaveThePictureUpright();
    void applesAreGlobes();
};

namespace {

TriangleMesh twice(const TriangleMesh& shape)
{
    TriangleMesh mesh = shape;
    const Index first = shape.vertexCount();
    for (const glm::vec3& place : shape.positions)
        mesh.positions.push_back(place + glm::vec3(5.0f));
    for (const glm::uvec3& triangle : shape.triangles)
        mesh.triangles.push_back(triangle + first);
    return mesh;
}

std::array<glm::vec3, 3> placesOf(const TriangleMesh& mesh, const glm::uvec3& t)
{
    return {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
}

std::array<glm::vec2, 3> textureOf(const TriangleMesh& mesh, const glm::uvec3& t)
{
    return {mesh.uv[t.x], mesh.uv[t.y], mesh.uv[t.z]};
}

} // namespace

void TestFoliageTexture::nothingForNothing()
{
    TriangleMesh none;
    addLeafTexture(none);
    QVERIFY(none.uv.empty());
    addAppleTexture(none);
    QVERIFY(none.uvTriangles.empty());
}

void TestFoliageTexture::leavesHaveThePictureUpright()
{
    TriangleMesh leaves = twice(unitTriangle());
    addLeafTexture(leaves);
    QCOMPARE(leaves.uv.size(), leaves.positions.size());
    QVERIFY(leaves.uvTriangles.empty());
    for (const glm::uvec3& triangle : leaves.triangles)
        QVERIFY(std::abs(textureStretch(placesOf(leaves, triangle), textureOf(leaves, triangle)) - 1.0) <
                1e-5);
    QCOMPARE(leaves.uv[0], glm::vec2(0.0f, 0.0f));
    QCOMPARE(leaves.uv[4], glm::vec2(1.0f, 0.0f));
    for (const glm::vec2& uv : leaves.uv)
        QVERIFY(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f);
}

void TestFoliageTexture::applesAreGlobes()
{
    TriangleMesh apples = twice(unitSphere());
    addAppleTexture(apples);
    QCOMPARE(apples.uvTriangles.size(), apples.triangles.size());
    double area = 0.0;
    for (std::size_t t = 0; t < apples.triangles.size(); ++t) {
        const std::array<glm::vec2, 3> uv = textureOf(apples, apples.uvTriangles[t]);
        QVERIFY(textureStretch(placesOf(apples, apples.triangles[t]), uv) > 0.0); // none is mirrored
        const glm::vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
        area += 0.5 * double(a.x * b.y - a.y * b.x);
    }
    // Each apple fills the picture, but for the saw teeth at its poles.
    QVERIFY(area > 1.7 && area < 2.0);
}

RAMURE_SUITE(TestFoliageTexture)

} // namespace tst_foliage_texture

#include "tst_foliage_texture.moc"
