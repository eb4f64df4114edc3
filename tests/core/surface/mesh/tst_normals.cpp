#include "core/math/random.h"
#include "core/surface/foliage/foliage_shapes.h"
#include "core/surface/mesh/normals.h"
#include "tests/support/suite.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tst_normals {

using namespace ramure;

namespace {

/// The definition in doubles, with inverse functions.
std::vector<glm::dvec3> plainNormals(const TriangleMesh& mesh)
{
    std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 p(mesh.positions[t[corner]]);
            const glm::dvec3 a = glm::dvec3(mesh.positions[t[(corner + 1) % 3]]) - p;
            const glm::dvec3 b = glm::dvec3(mesh.positions[t[(corner + 2) % 3]]) - p;
            const glm::dvec3 n = glm::cross(a, b);
            if (glm::length(n) > 0.0)
                normals[t[corner]] += glm::normalize(n) * std::atan2(glm::length(n), glm::dot(a, b));
        }
    for (glm::dvec3& n : normals)
        n = glm::length(n) > 0.0 ? glm::normalize(n) : glm::dvec3(0, 1, 0);
    return normals;
}

/// A bumpy closed surface of \p size metres.
TriangleMesh potato(std::uint64_t seed, float size)
{
    Random random(seed, RandomStream::Test);
    TriangleMesh mesh = unitSphere();
    for (glm::vec3& p : mesh.positions)
        p *= size * float(random.range(0.8, 1.2));
    return mesh;
}

double worstError(const TriangleMesh& mesh)
{
    const std::vector<glm::dvec3> expected = plainNormals(mesh);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        worst = std::max(worst, glm::length(expected[i] - glm::dvec3(mesh.normals[i])));
    return worst;
}

} // namespace

class TestNormals : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void emptyMesh();
    void verticesWithoutUsableFaces();
    void notANumberStaysWhereItIs();
    void oldNormalsAreReplaced();
    void definition();
    void anySize();
    void slivers();
    void facesThatFold();
    void weightsAreAngles();
    void sameBytesEveryTime();
};

void TestNormals::emptyMesh()
{
    TriangleMesh mesh;
    computeNormals(mesh);
    QVERIFY(mesh.normals.empty());
}

void TestNormals::verticesWithoutUsableFaces()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {4, 4, 4}, {0, 0, 1}};
    computeNormals(mesh);
    for (const glm::vec3& normal : mesh.normals)
        QVERIFY(normal == glm::vec3(0, 1, 0));
}

void TestNormals::notANumberStaysWhereItIs()
{
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {bad, 1, 0}};
        mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
        computeNormals(mesh);
        for (const std::size_t i : {0u, 1u, 2u})
            QVERIFY(glm::length(mesh.normals[i] - glm::vec3(0, 0, 1)) < 1e-6f);
        QVERIFY(mesh.normals[3] == glm::vec3(0, 1, 0));
    }
}

void TestNormals::oldNormalsAreReplaced()
{
    TriangleMesh mesh = unitSquare();
    mesh.normals = {{7, 7, 7}};
    computeNormals(mesh);
    QVERIFY(mesh.normals == std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
}

void TestNormals::definition()
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        TriangleMesh mesh = potato(seed, 1.0f);
        computeNormals(mesh);
        QVERIFY(worstError(mesh) < 2e-5);
        for (const glm::vec3& normal : mesh.normals)
            QVERIFY(std::abs(glm::length(normal) - 1.0f) < 1e-6f);
    }
}

void TestNormals::anySize()
{
    for (const float size : {1e-30f, 1e-18f, 1e-9f, 1e-4f, 1e4f, 1e9f, 1e18f, 1e30f}) {
        TriangleMesh mesh = potato(3, size);
        computeNormals(mesh);
        QVERIFY2(worstError(mesh) < 2e-5, QByteArray::number(double(size)));
    }
}

void TestNormals::slivers()
{
    // The tip of a cone a thousand times as long as wide.
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.positions.emplace_back(1e-3 * std::cos(k * 0.7853981634), 0.0,
                                    -1e-3 * std::sin(k * 0.7853981634));
    mesh.positions.emplace_back(0, 1, 0);
    for (Index k = 0; k < 8; ++k)
        mesh.triangles.emplace_back(k, (k + 1) % 8, 8);
    computeNormals(mesh);
    QVERIFY(worstError(mesh) < 1e-3);
    QVERIFY(mesh.normals[8].y > 0.9f);
}

void TestNormals::facesThatFold()
{
    TriangleMesh mesh = unitTriangle();
    mesh.triangles.emplace_back(0, 2, 1);
    computeNormals(mesh);
    for (const glm::vec3& normal : mesh.normals)
        QVERIFY(std::abs(glm::length(normal) - 1.0f) < 1e-6f);
}

void TestNormals::weightsAreAngles()
{
    // A face of the corner is split unevenly: the mean must not care.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.9f, 0.1f, 0}, {0.5f, 0.5f, 0}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 5}, {0, 5, 2}, {0, 2, 3}, {0, 3, 1}};
    computeNormals(mesh);
    const float third = 1.0f / std::sqrt(3.0f);
    QVERIFY(glm::length(mesh.normals[0] - glm::vec3(third)) < 2e-5f);
}

void TestNormals::sameBytesEveryTime()
{
    TriangleMesh a = potato(9, 1.0f), b = a;
    computeNormals(a);
    computeNormals(b);
    QVERIFY(a == b);
}

RAMURE_SUITE(TestNormals)

} // namespace tst_normals

#include "tst_normals.moc"
