#include "tests/support/mesh_checker.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_mesh_checker {

using namespace ramure;
using namespace ramure::test;

/// The judge is judged first: every kind of defect, made by hand, must be found and nothing else.
class TestMeshChecker : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void emptyMeshIsNotPerfect();
    void boxIsPerfect();
    void twoBoxesAreTwoComponents();
    void findsBoundary();
    void findsCrowdedEdge();
    void findsMisorientedFace();
    void findsPinchedVertex();
    void findsDuplicateVertex();
    void findsDuplicateFace();
    void findsDegenerateFaces();
    void findsIsolatedVertex();
    void findsBadIndexAndNonFinite();
    void findsInsideOut();
    void findsHandle();
    void findsBadNormals();
    void farFromTheOriginVolumeHolds();
};

void TestMeshChecker::emptyMeshIsNotPerfect()
{
    QVERIFY(!checkMesh({}).perfect(0));
    QVERIFY(!checkMesh({}).perfect(1));
}

void TestMeshChecker::boxIsPerfect()
{
    const CheckedMesh c = checkMesh(box({0, 0, 0}, {1, 2, 3}));
    QVERIFY2(c.perfect(1), c.summary().c_str());
    QVERIFY(!c.perfect(2));
    QCOMPARE(c.components[0].euler, 2);
    QCOMPARE(c.components[0].vertices, 8u);
    QCOMPARE(c.components[0].faces, 12u);
    QCOMPARE(c.volume(), 6.0);
}

void TestMeshChecker::twoBoxesAreTwoComponents()
{
    const CheckedMesh c = checkMesh(joined(box({0, 0, 0}, {1, 1, 1}), box({2, 0, 0}, {3, 1, 1})));
    QVERIFY2(c.perfect(2), c.summary().c_str());
    QVERIFY(!c.perfect(1));
}

void TestMeshChecker::findsBoundary()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    m.triangles.pop_back();
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.boundaryEdges, 3u);
    QVERIFY(!c.closedManifold() && !c.perfect(1));
    QCOMPARE(c.components[0].euler, 1);
}

void TestMeshChecker::findsCrowdedEdge()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    m.positions.push_back({-1, -1, -1});
    m.triangles.push_back({m.triangles[0].x, m.triangles[0].y, 8});
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.crowdedEdges, 1u);
    QCOMPARE(c.boundaryEdges, 2u);
    QVERIFY(!c.closedManifold());
}

void TestMeshChecker::findsMisorientedFace()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    std::swap(m.triangles[5].y, m.triangles[5].z);
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.misorientedEdges, 3u);
    QVERIFY(!c.closedManifold());
}

void TestMeshChecker::findsPinchedVertex()
{
    // Two boxes that share one corner: all edges are fine, the corner has two fans.
    TriangleMesh m = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}));
    Index shared = noIndex;
    for (Index v = 0; v < 8; ++v)
        if (m.positions[v] == glm::vec3(1, 1, 1))
            shared = v;
    Index twin = noIndex;
    for (Index v = 8; v < 16; ++v)
        if (m.positions[v] == glm::vec3(1, 1, 1))
            twin = v;
    QCOMPARE(checkMesh(m).duplicateVertices, 1u);
    for (glm::uvec3& t : m.triangles)
        for (int k = 0; k < 3; ++k)
            if (t[k] == twin)
                t[k] = shared;
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.pinchedVertices, 1u);
    QCOMPARE(c.isolatedVertices, 1u);
    QCOMPARE(c.boundaryEdges + c.crowdedEdges + c.misorientedEdges, 0u);
    QVERIFY(!c.closedManifold());
}

void TestMeshChecker::findsDuplicateVertex()
{
    TriangleMesh m = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.duplicateVertices, 4u);
    QVERIFY(!c.closedManifold());
    m.positions.assign(3, glm::vec3(-0.0f, 0.0f, 0.0f));
    m.positions[1].x = 0.0f;
    m.triangles.clear();
    QCOMPARE(checkMesh(m).duplicateVertices, 2u); // minus zero is zero
}

void TestMeshChecker::findsDuplicateFace()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    const glm::uvec3 t = m.triangles[3];
    m.triangles.push_back({t.y, t.x, t.z});
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.duplicateFaces, 1u);
    QCOMPARE(c.crowdedEdges, 3u);
    QVERIFY(!c.closedManifold());
}

void TestMeshChecker::findsDegenerateFaces()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    m.triangles.push_back({0, 0, 1});
    QCOMPARE(checkMesh(m).degenerateFaces, 1u);
    // A collinear triple, and one whose area lies just under and just over the floor of 1e-14 x squared
    // diagonal.
    for (const auto& [height, expected] : {std::pair{0.0, 1u}, {1e-14, 1u}, {9.9e-14, 0u}}) {
        TriangleMesh line;
        line.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, float(height), 0}, {0, 1, 0}};
        line.triangles = {{0, 1, 2}};
        QCOMPARE(checkMesh(line).degenerateFaces, expected);
    }
}

void TestMeshChecker::findsIsolatedVertex()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    m.positions.push_back({5, 5, 5});
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.isolatedVertices, 1u);
    QVERIFY(!c.perfect(1));
    QCOMPARE(c.components.size(), std::size_t(1));
}

void TestMeshChecker::findsBadIndexAndNonFinite()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    m.triangles.push_back({0, 1, 77});
    QCOMPARE(checkMesh(m).badIndices, 1u);
    QVERIFY(!checkMesh(m).perfect(1));
    m = box({0, 0, 0}, {1, 1, 1});
    m.positions[2].y = NAN;
    QCOMPARE(checkMesh(m).nonFinite, 1u);
    QVERIFY(!checkMesh(m).perfect(1));
}

void TestMeshChecker::findsInsideOut()
{
    TriangleMesh m = box({0, 0, 0}, {1, 1, 1});
    for (glm::uvec3& t : m.triangles)
        std::swap(t.y, t.z);
    const CheckedMesh c = checkMesh(m);
    QVERIFY(c.closedManifold());
    QCOMPARE(c.volume(), -1.0);
    QVERIFY(!c.perfect(1));
}

void TestMeshChecker::findsHandle()
{
    const CheckedMesh c = checkMesh(torus(12, 6));
    QVERIFY2(c.closedManifold(), c.summary().c_str());
    QCOMPARE(c.components[0].euler, 0);
    QVERIFY(!c.perfect(1));
}

void TestMeshChecker::findsBadNormals()
{
    TriangleMesh m = box({-1, -1, -1}, {1, 1, 1});
    for (const glm::vec3& p : m.positions)
        m.normals.push_back(glm::normalize(p));
    QVERIFY(checkMesh(m).perfect(1));
    m.normals[3] *= 1.01f;
    m.normals[4] *= -1.0f;
    const CheckedMesh c = checkMesh(m);
    QCOMPARE(c.badNormals, 1u);
    QCOMPARE(c.inwardNormals, 1u);
    QVERIFY(c.closedManifold() && !c.perfect(1));
    m.normals.pop_back();
    QVERIFY(!checkMesh(m).perfect(1));
}

void TestMeshChecker::farFromTheOriginVolumeHolds()
{
    const CheckedMesh c = checkMesh(box({1e6f, 1e6f, -1e6f}, {1e6f + 1, 1e6f + 1, -1e6f + 1}));
    QVERIFY2(c.perfect(1), c.summary().c_str());
    QCOMPARE(c.volume(), 1.0);
}

RAMURE_SUITE(TestMeshChecker)

} // namespace tst_mesh_checker

#include "tst_mesh_checker.moc"
