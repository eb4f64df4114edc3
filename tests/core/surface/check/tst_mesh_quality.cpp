#include "core/surface/check/mesh_quality.h"
#include "core/surface/mesh/mesh_hash.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

namespace tst_mesh_quality {

using namespace ramure;
using namespace ramure::test;

/// Shapes of triangles and the name of a mesh.
class TestMeshQuality : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void badIndicesAreErrors();
    void cancelStops();
    void emptyMeshHasNoWorst();
    void knownTriangles();
    void nearVerticesAreCounted();
    void brokenTrianglesStandAside();
    void histogramsCountEveryFace();
    void theSameOnAnyNumberOfThreads();
    void hashTellsMeshesApart();
    void hashIsTheSameEverywhere();
};

namespace {

TriangleMesh one(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    TriangleMesh mesh;
    mesh.positions = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

MeshQuality need(const TriangleMesh& mesh, unsigned threads = 0)
{
    auto quality = measureQuality(mesh, threads);
    if (!quality)
        qFatal("%s", why(quality).constData());
    return *quality;
}

} // namespace

void TestMeshQuality::badIndicesAreErrors()
{
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.triangles.emplace_back(0, 1, 8);
    const auto quality = measureQuality(mesh);
    QVERIFY(!quality && quality.error().code == ErrorCode::Invalid);
}

void TestMeshQuality::cancelStops()
{
    std::stop_source stop;
    stop.request_stop();
    const auto quality = measureQuality(torus(20, 10), 1, Progress{stop.get_token(), {}});
    QVERIFY(!quality && quality.error().code == ErrorCode::Cancelled);
}

void TestMeshQuality::emptyMeshHasNoWorst()
{
    const MeshQuality quality = need({});
    QCOMPARE(quality, MeshQuality{});
    QCOMPARE(quality.smallestAngleFace, noIndex);
}

void TestMeshQuality::knownTriangles()
{
    const float high = std::sqrt(3.0f) / 2.0f;
    const MeshQuality best = need(one({0, 0, 0}, {1, 0, 0}, {0.5f, high, 0}));
    QVERIFY(std::abs(best.smallestAngleRad - std::numbers::pi / 3.0) < 1e-6);
    QVERIFY(std::abs(best.largestAspect - 1.0) < 1e-6);
    QCOMPARE(best.angles.back(), Index(1));
    QCOMPARE(best.aspects.front(), Index(1));
    const MeshQuality right = need(one({0, 0, 0}, {3, 0, 0}, {0, 4, 0}));
    QVERIFY(std::abs(right.smallestAngleRad - std::atan2(3.0, 4.0)) < 1e-9);
    QVERIFY(std::abs(right.largestAspect - 5.0 / (2.0 * std::numbers::sqrt3)) < 1e-9); // inradius 1
    QCOMPARE(right.angles[7], Index(1));                                               // 36.9 degrees
    const MeshQuality sliver = need(one({0, 0, 0}, {1, 0, 0}, {0.5f, 1e-12f, 0}));
    QVERIFY(std::abs(sliver.smallestAngleRad / 2e-12 - 1.0) < 1e-6);
    QCOMPARE(sliver.angles.front(), Index(1));
    QCOMPARE(sliver.aspects.back(), Index(1));
}

void TestMeshQuality::nearVerticesAreCounted()
{
    TriangleMesh mesh = one({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    QCOMPARE(need(mesh).nearPairs, Index(0));
    mesh.positions.insert(mesh.positions.end(), {{1, 9e-5f, 0}, {1, 1.1e-4f, 0}, {0, 1, 0}});
    QCOMPARE(need(mesh).nearPairs, Index(3));
    mesh.positions.assign(3000, {0, 0, 0}); // smaller than the distance: four million pairs
    QCOMPARE(need(mesh).nearPairs, Index(MeshQuality::mostNearPairs));
}

void TestMeshQuality::brokenTrianglesStandAside()
{
    TriangleMesh mesh = one({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    mesh.positions.emplace_back(NAN, 0, 0);
    mesh.positions.emplace_back(0, 1, 0);
    mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 3}, {0, 0, 1}, {0, 1, 4}});
    const MeshQuality quality = need(mesh);
    QCOMPARE(quality.withoutArea, Index(3));
    QCOMPARE(quality.smallestAngleFace, Index(3));
    QCOMPARE(quality.worst.size(), std::size_t(1));
}

void TestMeshQuality::histogramsCountEveryFace()
{
    const TriangleMesh mesh = torus(200, 60);
    const MeshQuality quality = need(mesh);
    QCOMPARE(std::accumulate(quality.angles.begin(), quality.angles.end(), Index(0)), mesh.faceCount());
    QCOMPARE(std::accumulate(quality.aspects.begin(), quality.aspects.end(), Index(0)), mesh.faceCount());
    QCOMPARE(quality.worst.size(), MeshQuality::worstListed);
    QCOMPARE(quality.worst.front().smallestAngleRad, quality.smallestAngleRad);
    QCOMPARE(quality.worst.front().face, quality.smallestAngleFace);
    std::set<Index> faces;
    for (const WorstFace& worst : quality.worst)
        faces.insert(worst.face);
    QCOMPARE(faces.size(), quality.worst.size());
    // Looking at every face alone gives the same worst ones.
    double smallest = 10.0, largest = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const MeshQuality alone = need(one(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]), 1);
        smallest = std::min(smallest, alone.smallestAngleRad);
        largest = std::max(largest, alone.largestAspect);
    }
    QCOMPARE(quality.smallestAngleRad, smallest);
    QCOMPARE(quality.largestAspect, largest);
}

void TestMeshQuality::theSameOnAnyNumberOfThreads()
{
    const TriangleMesh mesh = torus(500, 60);
    const MeshQuality first = need(mesh, 1);
    for (const unsigned threads : {2u, 5u})
        QVERIFY(need(mesh, threads) == first);
}

void TestMeshQuality::hashTellsMeshesApart()
{
    const TriangleMesh mesh = torus(24, 12);
    std::set<MeshHash> seen{meshHash(mesh)};
    const auto isNew = [&](const TriangleMesh& other) { return seen.insert(meshHash(other)).second; };
    QVERIFY(isNew({}));
    QVERIFY(isNew(torus(12, 24)));
    for (Index v = 0; v < mesh.vertexCount(); ++v)
        for (int axis = 0; axis < 3; ++axis) {
            TriangleMesh other = mesh;
            other.positions[v][axis] = std::nextafter(other.positions[v][axis], 9.0f);
            QVERIFY(isNew(other));
        }
    for (Index f = 1; f < mesh.faceCount(); ++f) {
        TriangleMesh other = mesh;
        std::swap(other.triangles[f], other.triangles[f - 1]);
        QVERIFY(isNew(other));
        other = mesh;
        std::swap(other.triangles[f].x, other.triangles[f].y);
        QVERIFY(isNew(other));
    }
    TriangleMesh more = mesh;
    more.positions.emplace_back(0.0f);
    QVERIFY(isNew(more));
    TriangleMesh same = mesh;
    same.branch.assign(same.positions.size(), 3);
    same.normals.assign(same.positions.size(), {0, 1, 0});
    QVERIFY(!isNew(same));
    for (glm::vec3& p : same.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] == 0.0f)
                p[axis] = -0.0f;
    QVERIFY(!isNew(same));
}

/// Golden: whoever changes the hash changes what reports say about meshes of yesterday.
void TestMeshQuality::hashIsTheSameEverywhere()
{
    QCOMPARE(meshHash(TriangleMesh()).text(), std::string("cb4b3b1d382127d1a97bab1341cb88bb"));
    QCOMPARE(meshHash(box({0, 0, 0}, {1, 2, 3})).text(), std::string("d2af74c9f936ed1f9ff52978c6307299"));
    QCOMPARE(meshHash(box({0, 0, 0}, {1, 2, 3})).shortText().size(), std::size_t(8));
}

RAMURE_SUITE(TestMeshQuality)

} // namespace tst_mesh_quality

#include "tst_mesh_quality.moc"
