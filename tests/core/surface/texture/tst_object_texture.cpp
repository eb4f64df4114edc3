#include "core/surface/primitives/primitive_mesh.h"
#include "core/surface/texture/object_texture.h"
#include "tests/support/suite.h"

namespace tst_object_texture {

using namespace ramure;

class TestObjectTexture : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingAndFlatTrianglesAreBorne()
    {
        TriangleMesh none;
        addBoxTexture(none);
        QVERIFY(none.uv.empty());
        QVERIFY(splitByTexture(none).empty());
        TriangleMesh point;
        point.positions.assign(3, glm::vec3(1.0f));
        point.triangles.emplace_back(0, 1, 2);
        for (const glm::vec2& uv : splitByTexture(point).uv)
            QVERIFY(std::isfinite(uv.x) && std::isfinite(uv.y));
    }
    void aBoxShowsOnePictureOnEachSide()
    {
        PrimitiveParams params;
        params.shape = PrimitiveShape::Box;
        params.size = {2.0, 2.0, 2.0};
        TriangleMesh box = primitiveMesh(params);
        addBoxTexture(box);
        QCOMPARE(box.uvTriangles.size(), box.triangles.size());
        for (const glm::uvec3& t : box.uvTriangles) {
            const glm::vec2 a = box.uv[t.y] - box.uv[t.x], b = box.uv[t.z] - box.uv[t.x];
            QCOMPARE(0.5f * (a.x * b.y - a.y * b.x), 0.5f); // half a picture, not mirrored
        }
    }
    void splittingKeepsEveryCorner()
    {
        PrimitiveParams params;
        params.shape = PrimitiveShape::Sphere;
        TriangleMesh sphere = primitiveMesh(params);
        addBoxTexture(sphere);
        const TriangleMesh split = splitByTexture(sphere);
        QVERIFY(split.uvTriangles.empty());
        QCOMPARE(split.uv.size(), split.positions.size());
        QCOMPARE(split.triangles.size(), sphere.triangles.size());
        for (std::size_t t = 0; t < split.triangles.size(); ++t)
            for (int corner = 0; corner < 3; ++corner) {
                QCOMPARE(split.positions[split.triangles[t][corner]],
                         sphere.positions[sphere.triangles[t][corner]]);
                QCOMPARE(split.uv[split.triangles[t][corner]], sphere.uv[sphere.uvTriangles[t][corner]]);
            }
        QVERIFY(split.vertexCount() < 3 * split.faceCount()); // shared where it can be
        QCOMPARE(splitByTexture(split), split);
    }
};

RAMURE_SUITE(TestObjectTexture)

} // namespace tst_object_texture

#include "tst_object_texture.moc"
