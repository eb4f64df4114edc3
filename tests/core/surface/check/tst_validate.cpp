#include "core/base/parallel.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace tst_validate {

using namespace ramure;

namespace {

TriangleMesh tetrahedron(const glm::vec3& at = {}, float size = 1.0f)
{
    TriangleMesh mesh;
    mesh.positions = {at, at + glm::vec3(size, 0, 0), at + glm::vec3(0, size, 0), at + glm::vec3(0, 0, size)};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const Index base = mesh.vertexCount();
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const glm::uvec3& t : other.triangles)
        mesh.triangles.push_back(t + base);
}

/// A closed tube with n sides and two hubs: the hubs have n faces around them.
TriangleMesh spindle(Index n)
{
    TriangleMesh mesh;
    mesh.positions = {{0, -1, 0}, {0, 1, 0}};
    for (Index i = 0; i < n; ++i) {
        const double a = 2.0 * 3.14159265358979 * i / n;
        mesh.positions.emplace_back(std::cos(a), 0.0, -std::sin(a));
    }
    for (Index i = 0; i < n; ++i) {
        const Index p = 2 + i;
        const Index q = 2 + (i + 1) % n;
        mesh.triangles.emplace_back(0u, q, p);
        mesh.triangles.emplace_back(1u, p, q);
    }
    return mesh;
}

/// A grid on a torus, Euler characteristic 0.
TriangleMesh torus(Index n, Index m)
{
    TriangleMesh mesh;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < m; ++j) {
            const double a = 2.0 * 3.14159265358979 * i / n;
            const double b = 2.0 * 3.14159265358979 * j / m;
            const double r = 2.0 + 0.5 * std::cos(b);
            mesh.positions.emplace_back(r * std::cos(a), 0.5 * std::sin(b), -r * std::sin(a));
        }
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < m; ++j) {
            const Index a = i * m + j;
            const Index b = (i + 1) % n * m + j;
            const Index c = (i + 1) % n * m + (j + 1) % m;
            const Index d = i * m + (j + 1) % m;
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(a, c, d);
        }
    return mesh;
}

MeshReport check(const TriangleMesh& mesh)
{
    auto report = validateMesh(mesh);
    if (!report)
        qFatal("%s", test::why(report).constData());
    // Every listed defect is counted, and nothing is listed beyond what is counted.
    for (int kind = 0; kind < defectKindCount; ++kind) {
        const auto listed = std::count_if(report->defects.begin(), report->defects.end(),
                                          [&](const Defect& d) { return int(d.kind) == kind; });
        if (listed != std::min<std::int64_t>(report->count(DefectKind(kind)), 10'000))
            qFatal("defects of kind %d: %d listed", kind, int(listed));
    }
    if (!confirmWithOpenMesh(mesh, *report))
        qFatal("OpenMesh was not asked");
    return *report;
}

Index defectSum(const MeshReport& r)
{
    Index sum = 0;
    for (int kind = 0; kind < defectKindCount; ++kind)
        sum += r.count(DefectKind(kind));
    return sum;
}

} // namespace

class TestValidate : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void indexOutOfRangeIsAnError()
    {
        TriangleMesh mesh = tetrahedron();
        mesh.triangles[2].y = 4;
        const auto report = validateMesh(mesh);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Invalid);
        QCOMPARE(report.error().message(),
                 std::string("face 2 refers to a vertex that does not exist (4 vertices)"));
        MeshReport other;
        QVERIFY(!confirmWithOpenMesh(mesh, other));
        QVERIFY(!other.openMeshChecked);
        mesh.triangles[2].y = noIndex;
        QVERIFY(!validateMesh(mesh));
    }
    void indexOutOfRangeIsAnErrorWhereverItStands()
    {
        const TriangleMesh good = spindle(20'000); // large enough for two threads
        const Index faces = good.faceCount(), vertices = good.vertexCount();
        for (const unsigned threads : {1u, 2u})
            for (const Index face : {0u, faces / 2, faces - 2, faces - 1})
                for (const Index missing : {vertices, noIndex}) {
                    const ThreadLimit limit(threads);
                    TriangleMesh mesh = good;
                    mesh.triangles[face].z = missing;
                    const auto report = validateMesh(mesh);
                    QVERIFY(!report && report.error().code == ErrorCode::Invalid);
                    QCOMPARE(report.error().message(), "face " + std::to_string(face) +
                                                           " refers to a vertex that does not exist (" +
                                                           std::to_string(vertices) + " vertices)");
                }
    }
    void theLastVertexMayBeInAnyFace()
    {
        // Of the last vertex no four floats can be read: those faces take another way.
        TriangleMesh mesh = spindle(5'000);
        const MeshReport before = check(mesh);
        const auto swapped = [last = mesh.vertexCount() - 1](Index v) {
            return v == 7 ? last : v == last ? 7 : v;
        };
        std::swap(mesh.positions[7], mesh.positions.back());
        for (glm::uvec3& t : mesh.triangles)
            t = {swapped(t.x), swapped(t.y), swapped(t.z)};
        const MeshReport after = check(mesh);
        QVERIFY(before.valid && after.valid);
        QCOMPARE(after.volume, before.volume);
        mesh.positions.back().x = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(check(mesh).degenerateFaces > 0);
    }
    void cancelStops()
    {
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        const auto report = validateMesh(tetrahedron(), progress);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Cancelled);
        MeshReport other;
        QVERIFY(!confirmWithOpenMesh(tetrahedron(), other, progress));
    }
    void nothingIsNotValid()
    {
        const MeshReport report = check({});
        QVERIFY(!report.valid);
        QVERIFY(!report.openMeshAgrees);
        QCOMPARE(report.components, 0u);
        QCOMPARE(report.eulerCharacteristic, 0);
    }
    void nonFinitePositionsAreDegenerate()
    {
        for (const float bad :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -HUGE_VALF}) {
            TriangleMesh mesh = tetrahedron();
            append(mesh, tetrahedron({5, 5, 5}));
            mesh.positions[1].y = bad;
            const MeshReport report = check(mesh);
            QVERIFY(!report.valid);
            QCOMPARE(report.degenerateFaces, 3u); // those at the vertex; the other tetrahedron is not harmed
        }
    }
    void cleanMeshesAreValid()
    {
        const MeshReport one = check(tetrahedron({1, 2, 3}, 2.0f));
        QVERIFY(one.valid);
        QVERIFY(one.openMeshAgrees);
        QCOMPARE(one.vertices, 4u);
        QCOMPARE(one.faces, 4u);
        QCOMPARE(one.components, 1u);
        QCOMPARE(one.eulerCharacteristic, 2);
        QVERIFY(std::abs(one.volume - 8.0 / 6.0) < 1e-12);

        TriangleMesh two = tetrahedron();
        append(two, tetrahedron({3, 0, 0}));
        const MeshReport pair = check(two);
        QVERIFY(pair.valid);
        QCOMPARE(pair.components, 2u);
        QCOMPARE(pair.eulerCharacteristic, 4);
        QVERIFY(std::abs(pair.volume - 2.0 / 6.0) < 1e-12);

        const MeshReport ring = check(torus(12, 7));
        QVERIFY(ring.valid);
        QCOMPARE(ring.eulerCharacteristic, 0);
        QCOMPARE(ring.components, 1u);
    }
    void anyNumberOfFacesAroundAVertex()
    {
        for (Index n = 3; n < 80; ++n) {
            const MeshReport report = check(spindle(n));
            QVERIFY2(report.valid && report.openMeshAgrees, QByteArray::number(n));
            QCOMPARE(report.eulerCharacteristic, 2);
        }
        TriangleMesh large = spindle(100'000);
        auto report = validateMesh(large);
        QVERIFY(report && report->valid);
        QVERIFY(confirmWithOpenMesh(large, *report)); // not asked: it would take minutes
        QVERIFY(!report->openMeshChecked);
    }
    void smallMeshFarAwayKeepsItsVolume()
    {
        const MeshReport report = check(tetrahedron({1024, -2048, 512}, 0.25f));
        QVERIFY(report.valid);
        QVERIFY(std::abs(report.volume - 0.25 * 0.25 * 0.25 / 6.0) < 1e-15);
    }
    void insideOutIsNotValid()
    {
        TriangleMesh mesh = tetrahedron();
        for (glm::uvec3& t : mesh.triangles)
            std::swap(t.y, t.z);
        const MeshReport report = check(mesh);
        QCOMPARE(defectSum(report), 0u);
        QVERIFY(report.volume < 0.0);
        QVERIFY(!report.valid);
        // One piece outward and larger, one inside out: the sum alone would not tell.
        TriangleMesh both = tetrahedron({}, 4.0f);
        append(both, mesh);
        for (Index v = 4; v < 8; ++v)
            both.positions[v] += glm::vec3(10, 0, 0);
        const MeshReport mixed = check(both);
        QVERIFY(mixed.volume > 0.0);
        QVERIFY(!mixed.valid);
    }
    void boundary()
    {
        TriangleMesh mesh = tetrahedron();
        mesh.triangles.pop_back(); // {1, 2, 3}
        const MeshReport report = check(mesh);
        QCOMPARE(report.boundaryEdges, 3u);
        QCOMPARE(defectSum(report), 3u);
        QCOMPARE(report.eulerCharacteristic, 1);
        QVERIFY(!report.openMeshAgrees);
        QCOMPARE(report.defects.size(), std::size_t(3));
        QCOMPARE(report.defects[0].a, 1u);
        QCOMPARE(report.defects[0].b, 2u);
        QCOMPARE(report.defects[2].a, 2u);
        QCOMPARE(report.defects[2].b, 3u);
    }
    void nonManifoldEdge()
    {
        // Two tetrahedra that share the edge 0-1: four faces along it, one group of faces at each end.
        TriangleMesh mesh = tetrahedron();
        mesh.positions.emplace_back(0.0f, -1.0f, 0.0f);
        mesh.positions.emplace_back(0.0f, 0.0f, -1.0f);
        for (const glm::uvec3 t : {glm::uvec3{0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}})
            mesh.triangles.push_back(t);
        const MeshReport report = check(mesh);
        QCOMPARE(report.nonManifoldEdges, 1u);
        QCOMPARE(defectSum(report), 1u);
        QCOMPARE(report.defects[0].a, 0u);
        QCOMPARE(report.defects[0].b, 1u);
        QVERIFY(!report.openMeshAgrees);
        QVERIFY(!report.valid);
    }
    void nonManifoldVertex()
    {
        TriangleMesh mesh = tetrahedron();
        TriangleMesh mirrored = tetrahedron({}, -1.0f);
        for (glm::uvec3& t : mirrored.triangles)
            std::swap(t.y, t.z);
        append(mesh, mirrored);
        for (glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                t[k] = t[k] == 4 ? 0 : t[k]; // both tips are vertex 0
        mesh.positions[4] = {9, 9, 9};       // now unused
        const MeshReport report = check(mesh);
        QCOMPARE(report.nonManifoldVertices, 1u);
        QCOMPARE(report.isolatedVertices, 1u);
        QCOMPARE(defectSum(report), 2u);
        QCOMPARE(report.components, 1u);
        QCOMPARE(report.eulerCharacteristic, 3); // 7 - 12 + 8
        QVERIFY(!report.openMeshAgrees);
    }
    /// A closed fan, known from other vertices, does not hide what else is at the vertex.
    void faceBesideAClosedFan()
    {
        for (Index n = 3; n < 12; ++n) {
            TriangleMesh mesh = spindle(n);
            for (int i = 0; i < 3; ++i)
                append(mesh, spindle(n));
            const Index hub = mesh.vertexCount();
            append(mesh, spindle(n));
            mesh.positions.emplace_back(5, 6, 7);
            mesh.positions.emplace_back(5, 7, 7);
            mesh.triangles.emplace_back(hub, hub + n + 2, hub + n + 3);
            for (Index i = 0; i < mesh.vertexCount(); ++i)
                mesh.positions[i] += glm::vec3(10.0f * static_cast<float>(i / (n + 2)), 0, 0);
            const MeshReport report = check(mesh);
            QCOMPARE(report.boundaryEdges, Index(3));
            QCOMPARE(report.nonManifoldVertices, Index(1));
            QCOMPARE(report.components, Index(5));
        }
    }
    void inconsistentEdges()
    {
        TriangleMesh mesh = tetrahedron();
        std::swap(mesh.triangles[3].y, mesh.triangles[3].z);
        const MeshReport report = check(mesh);
        QCOMPARE(report.inconsistentEdges, 3u);
        QCOMPARE(defectSum(report), 3u);
        QVERIFY(!report.openMeshAgrees);
    }
    void duplicateVertices()
    {
        TriangleMesh mesh = tetrahedron();
        append(mesh, tetrahedron({-1, 0, 0})); // its vertex 5 lies on vertex 0
        mesh.positions[5] = {-0.0f, 0.0f, -0.0f};
        const MeshReport report = check(mesh);
        QCOMPARE(report.duplicateVertices, 1u);
        QCOMPARE(defectSum(report), 1u);
        QCOMPARE(report.defects[0].a, 5u);
        QCOMPARE(report.defects[0].b, 0u);
        QVERIFY(report.openMeshAgrees); // the structure alone does not see positions
        QVERIFY(!report.valid);
    }
    void duplicateFaces()
    {
        TriangleMesh pillow;
        pillow.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
        const MeshReport report = check(pillow);
        QCOMPARE(report.duplicateFaces, 1u);
        QCOMPARE(defectSum(report), 1u);
        QCOMPARE(report.defects[0].a, 1u);
        QCOMPARE(report.defects[0].b, 0u);

        TriangleMesh mesh = tetrahedron();
        mesh.triangles.push_back({2, 3, 1}); // the last face once more, from another corner
        const MeshReport twice = check(mesh);
        QCOMPARE(twice.duplicateFaces, 1u);
        QCOMPARE(twice.nonManifoldEdges, 3u);
        QCOMPARE(defectSum(twice), 4u);
    }
    void degenerateFaces()
    {
        // A sliver without area sits in the edge 1-2.
        TriangleMesh mesh = tetrahedron();
        mesh.positions.emplace_back(0.5f, 0.5f, 0.0f);
        mesh.triangles[3] = {1, 4, 3};
        mesh.triangles.push_back({4, 2, 3});
        mesh.triangles.push_back({1, 2, 4});
        const MeshReport sliver = check(mesh);
        QCOMPARE(sliver.degenerateFaces, 1u);
        QCOMPARE(defectSum(sliver), 1u);
        QCOMPARE(sliver.defects[0].a, 5u);

        TriangleMesh repeated = tetrahedron();
        repeated.triangles.push_back({2, 2, 3});
        repeated.triangles.push_back({3, 3, 3});
        const MeshReport report = check(repeated);
        QCOMPARE(report.degenerateFaces, 2u);
        QCOMPARE(defectSum(report), 2u); // left out of everything else
        QCOMPARE(report.eulerCharacteristic, 2);
        QVERIFY(!report.openMeshAgrees);
    }
    void vertexOnlyInARepeatedFaceIsNotIsolated()
    {
        TriangleMesh mesh = tetrahedron();
        mesh.positions.emplace_back(5.0f, 5.0f, 5.0f);
        mesh.positions.emplace_back(6.0f, 6.0f, 6.0f);
        mesh.triangles.push_back({4, 4, 0});
        const MeshReport report = check(mesh);
        QCOMPARE(report.isolatedVertices, 1u);
        QCOMPARE(report.degenerateFaces, 1u);
        QCOMPARE(defectSum(report), 2u);
    }
    void countsAreCompleteAndListsAreCut()
    {
        TriangleMesh mesh;
        for (Index i = 0; i < 12'000; ++i) {
            const float x = float(i) * 2.0f;
            mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
            mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        mesh.positions.resize(mesh.positions.size() + 11'000, glm::vec3(-1.0f));
        const MeshReport report = check(mesh);
        QCOMPARE(report.boundaryEdges, 36'000u);
        QCOMPARE(report.isolatedVertices, 11'000u);
        QCOMPARE(report.duplicateVertices, 10'999u);
        QCOMPARE(report.components, 12'000u);
        QCOMPARE(report.defects.size(), std::size_t(30'000));
    }
    /// The order of vertices and faces changes nothing but names; each single change of a valid mesh is
    /// found.
    void randomOrdersAndRandomDamage()
    {
        std::mt19937 generator(7);
        const auto below = [&](Index n) { return static_cast<Index>(generator()) % n; };
        for (int round = 0; round < 300; ++round) {
            TriangleMesh mesh = torus(3 + below(9), 3 + below(9));
            append(mesh, spindle(3 + below(20)));
            const Index n = mesh.vertexCount();
            for (Index v = 0; v < n; ++v) { // a random renaming
                const Index w = v + below(n - v);
                std::swap(mesh.positions[v], mesh.positions[w]);
                for (glm::uvec3& t : mesh.triangles)
                    for (int k = 0; k < 3; ++k)
                        t[k] = t[k] == v ? w : t[k] == w ? v : t[k];
            }
            for (Index f = 0; f < mesh.faceCount(); ++f)
                std::swap(mesh.triangles[f], mesh.triangles[f + below(mesh.faceCount() - f)]);
            const MeshReport report = check(mesh);
            QVERIFY(report.valid && report.openMeshAgrees);
            QCOMPARE(report.components, 2u);
            QCOMPARE(report.eulerCharacteristic, 2);

            TriangleMesh damaged = mesh;
            const Index face = below(mesh.faceCount());
            switch (round % 4) {
            case 0:
                damaged.triangles.erase(damaged.triangles.begin() + face);
                break;
            case 1:
                std::swap(damaged.triangles[face].x, damaged.triangles[face].y);
                break;
            case 2:
                damaged.triangles.push_back(mesh.triangles[face]);
                break;
            default:
                damaged.positions[mesh.triangles[face].x] = mesh.positions[mesh.triangles[face].y];
                break;
            }
            QVERIFY(!check(damaged).valid);
        }
    }
};

RAMURE_SUITE(TestValidate)

} // namespace tst_validate

#include "tst_validate.moc"
