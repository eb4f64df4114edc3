#include "core/math/random.h"
#include "core/surface/mesh/mesh_rays.h"
#include "core/surface/primitives/terrain.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_terrain {

using namespace ramure;
using namespace ramure::test;

class TestTerrain : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void wrongParametersAreErrors();
    void isAGridWithItsMiddleAtTheGround();
    void theSeedDecides();
    void roughnessMakesItRougher();
    void finerGridsAreTheSameTerrain();
    void blocksAreClosed();
    void heightsAreThoseOfTheGrid();
    void raysThatMissMeetNothing();
    void raysMeetTheNearestTriangle();
};

namespace {

std::shared_ptr<const TriangleMesh> terrain(const TerrainParams& params)
{
    return std::make_shared<const TriangleMesh>(buildTerrain(params).value_or(TriangleMesh{}));
}

/// Mean absolute change of slope between neighbours.
double unrest(const TriangleMesh& mesh, std::size_t columns)
{
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < columns; ++i)
        sum +=
            std::abs(double(mesh.positions[i - 1].y - 2.0F * mesh.positions[i].y + mesh.positions[i + 1].y));
    return sum;
}

std::optional<double> byForce(const TriangleMesh& mesh, const Ray& ray)
{
    std::optional<double> best;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto hit = intersect(ray, glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                                   glm::dvec3(mesh.positions[t.z]));
        if (hit && (!best || hit->t < *best))
            best = hit->t;
    }
    return best;
}

} // namespace

void TestTerrain::wrongParametersAreErrors()
{
    const auto refused = [](const char* path, auto change) {
        TerrainParams params;
        change(params);
        const auto made = buildTerrain(params);
        return !made && made.error().code == ErrorCode::Invalid && made.error().path == path;
    };
    QVERIFY(refused("terrain.size", [](TerrainParams& p) { p.size = 0.0; }));
    QVERIFY(refused("terrain.height", [](TerrainParams& p) { p.height = std::nan(""); }));
    QVERIFY(refused("terrain.roughness", [](TerrainParams& p) { p.roughness = 1.5; }));
    QVERIFY(refused("terrain.divisions", [](TerrainParams& p) { p.divisions = 0; }));
    QVERIFY(refused("terrain.divisions", [](TerrainParams& p) { p.divisions = 1025; }));
}

void TestTerrain::isAGridWithItsMiddleAtTheGround()
{
    TerrainParams params;
    params.divisions = 10;
    params.size = 4.0;
    const auto mesh = terrain(params);
    QCOMPARE(mesh->vertexCount(), Index(121));
    QCOMPARE(mesh->faceCount(), Index(200));
    QCOMPARE(mesh->positions[60], glm::vec3(0.0F));
    QCOMPARE(mesh->positions[0].x, -2.0F);
    QCOMPARE(mesh->positions[120].z, 2.0F);
    for (const glm::vec3& normal : mesh->normals)
        QVERIFY(normal.y > 0.0F);
}

void TestTerrain::theSeedDecides()
{
    TerrainParams params, other;
    other.seed = 2;
    QVERIFY(*terrain(params) == *terrain(params));
    QVERIFY(terrain(params)->positions != terrain(other)->positions);
    params.height = 0.0;
    const auto flat = terrain(params);
    for (const glm::vec3& at : flat->positions)
        QCOMPARE(at.y, 0.0F);
}

void TestTerrain::roughnessMakesItRougher()
{
    TerrainParams params;
    double last = -1.0;
    for (const double roughness : {0.0, 0.3, 0.6, 1.0}) {
        params.roughness = roughness;
        const auto mesh = terrain(params);
        const double now = unrest(*mesh, 129);
        QVERIFY(now > last);
        last = now;
        for (const glm::vec3& at : mesh->positions)
            QVERIFY(std::isfinite(at.y) && std::abs(at.y) < 20.0F);
    }
}

void TestTerrain::finerGridsAreTheSameTerrain()
{
    TerrainParams coarse, fine;
    coarse.divisions = 20;
    fine.divisions = 40;
    const auto a = terrain(coarse), b = terrain(fine);
    for (std::size_t row = 0; row <= 20; ++row)
        for (std::size_t column = 0; column <= 20; ++column)
            QCOMPARE(a->positions[row * 21 + column], b->positions[2 * row * 41 + 2 * column]);
}

/// A block has the ground of the sheet, a level bottom so far below its lowest place, and upright sides; what
/// is looked at has the same shape with sharp edges.
void TestTerrain::blocksAreClosed()
{
    for (const std::int64_t divisions : {1, 2, 13, 128})
        for (const double depth : {1e-3, 0.6, 40.0}) {
            TerrainParams params;
            params.divisions = divisions;
            const auto ground = terrain(params);
            params.depth = depth;
            const auto solid = terrainSolid(params);
            QVERIFY2(solid, why(solid));
            const auto report = validateMesh(*solid);
            QVERIFY2(report, why(report));
            QVERIFY(report->valid && report->eulerCharacteristic == 2 && report->boundaryEdges == 0);
            QVERIFY(report->volume > 0.0 && report->duplicateVertices == 0);
            QCOMPARE(solid->colours.size(), solid->triangles.size());
            QVERIFY(std::equal(ground->positions.begin(), ground->positions.end(), solid->positions.begin()));
            float lowest = 1e9F, bottom = 1e9F;
            for (const glm::vec3& at : ground->positions)
                lowest = std::min(lowest, at.y);
            for (const glm::vec3& at : solid->positions)
                bottom = std::min(bottom, at.y);
            QVERIFY(std::abs(double(lowest - bottom) - depth) < 1e-5 * (1.0 + depth));

            const auto look = terrain(params);
            QCOMPARE(look->triangles.size(), solid->triangles.size());
            QCOMPARE(look->normals.size(), look->positions.size());
            QCOMPARE(look->uv.size(), look->positions.size());
            QCOMPARE(look->colours, solid->colours);
            for (std::size_t t = 0; t < look->triangles.size(); ++t)
                for (int c = 0; c < 3; ++c)
                    QCOMPARE(look->positions[look->triangles[t][c]],
                             solid->positions[solid->triangles[t][c]]);
            for (std::size_t t = ground->triangles.size(); t < look->triangles.size(); ++t)
                for (int c = 0; c < 3; ++c) {
                    const glm::vec3 normal = look->normals[look->triangles[t][c]];
                    QVERIFY(std::abs(normal.y) < 1e-4F || normal.y < -0.999F);
                }
        }
}

void TestTerrain::heightsAreThoseOfTheGrid()
{
    TerrainParams params;
    params.size = -1.0;
    QVERIFY(!TerrainHeights::of(params));
    params.size = 7.0;
    const auto heights = TerrainHeights::of(params);
    QVERIFY2(heights, why(heights));
    QVERIFY(heights->isOn(3.5, -3.5) && !heights->isOn(3.51, 0.0));
    QCOMPARE(heights->at(0.0, 0.0), 0.0);
    const auto mesh = terrain(params);
    for (const glm::vec3& at : mesh->positions)
        QVERIFY(std::abs(heights->at(double(at.x), double(at.z)) - double(at.y)) < 1e-5);
}

void TestTerrain::raysThatMissMeetNothing()
{
    QVERIFY(!MeshRays().nearest({}));
    QVERIFY(!MeshRays(nullptr).nearest({}));
    const MeshRays rays(terrain({}));
    QVERIFY(!rays.nearest({{0.0, 50.0, 0.0}, {0.0, 1.0, 0.0}}));
    QVERIFY(!rays.nearest({{100.0, 50.0, 0.0}, {0.0, -1.0, 0.0}}));
    QVERIFY(rays.nearest({{0.01, 50.0, 0.02}, {0.0, -1.0, 0.0}}));
}

void TestTerrain::raysMeetTheNearestTriangle()
{
    TerrainParams params;
    params.height = 4.0;
    params.divisions = 64;
    const auto mesh = terrain(params);
    const MeshRays rays(mesh);
    Random random(1, RandomStream::Test);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 from(random.range(-9.0, 9.0), random.range(-3.0, 6.0), random.range(-9.0, 9.0));
        const glm::dvec3 to(random.range(-6.0, 6.0), random.range(-2.0, 2.0), random.range(-6.0, 6.0));
        const Ray ray{from, glm::normalize(to - from)};
        const auto hit = rays.nearest(ray);
        const auto expected = byForce(*mesh, ray);
        QCOMPARE(hit.has_value(), expected.has_value());
        if (!hit)
            continue;
        ++hits;
        QVERIFY(std::abs(hit->t - *expected) <= 1e-5);
        QVERIFY(glm::distance(hit->point, ray.at(*expected)) <= 1e-5);
    }
    QVERIFY(hits > 500);
}

RAMURE_SUITE(TestTerrain)

} // namespace tst_terrain

#include "tst_terrain.moc"
