#include "core/surface/check/mesh_quality.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/fork_judge.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace tst_forks_softness {

using namespace ramure;
using namespace ramure::test;

/// Forks look grown: creases are rounded as far as the parameters say, the ring where a fork begins shows no
/// kink, nothing is moved away from the fork, and at every limit of every parameter the mesh is one closed
/// manifold.
class TestForksSoftness : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void everyLimitIsAClosedManifold();
    void softnessAndReachOfZeroAreTheSame();
    void creasesAreRounded();
    void onlyTheForkIsMoved();
    void noKinkWhereAForkBegins_data();
    void noKinkWhereAForkBegins();
    void noMoreSlivers_data();
    void noMoreSlivers();
};

namespace {

constexpr std::uint64_t slowness = test::isSanitized ? 20 : 1;

constexpr double degrees = std::numbers::pi / 180.0;

/// A trunk of 2 m and two branches, half of \p angleRad to each side.
Skeleton wye(double angleRad)
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.1, 0.1);
    for (const double side : {-0.5, 0.5})
        s.add(0, {0, 2, 0}, {2.0 * std::sin(side * angleRad), 2.0 + 2.0 * std::cos(side * angleRad), 0}, 0.1,
              0.1);
    return s;
}

Expected<BranchMesh> build(const Skeleton& skeleton, double softness, double reach = 1.0, int radial = 24,
                           int length = 24)
{
    BranchMeshOptions options;
    options.radialDivisions = radial;
    options.lengthDivisions = length;
    options.forkSoftness = softness;
    options.forkReach = reach;
    return buildBranchMesh(skeleton, options);
}

glm::dvec3 faceNormal(const TriangleMesh& mesh, Index face)
{
    const glm::uvec3 t = mesh.triangles[face];
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    return glm::normalize(glm::cross(b - a, c - a));
}

/// The angles, in rad, between the faces at all edges whose two ends are among \p vertices.
std::vector<double> creases(const TriangleMesh& mesh, const std::set<Index>& vertices)
{
    std::map<std::pair<Index, Index>, std::vector<Index>> faces;
    for (Index f = 0; f < mesh.faceCount(); ++f)
        for (int i = 0; i < 3; ++i) {
            const auto ends = std::minmax(mesh.triangles[f][i], mesh.triangles[f][(i + 1) % 3]);
            if (vertices.contains(ends.first) && vertices.contains(ends.second))
                faces[ends].push_back(f);
        }
    std::vector<double> angles;
    for (const auto& [ends, pair] : faces)
        if (pair.size() == 2)
            angles.push_back(std::acos(
                std::clamp(glm::dot(faceNormal(mesh, pair[0]), faceNormal(mesh, pair[1])), -1.0, 1.0)));
    return angles;
}

std::set<Index> valley(const BranchMesh& built)
{
    std::set<Index> vertices;
    for (const ForkVertex& vertex : built.forkVertices)
        vertices.insert(vertex.vertex);
    return vertices;
}

} // namespace

void TestForksSoftness::everyLimitIsAClosedManifold()
{
    QByteArray text;
    const std::uint64_t count = fuzzCount(12 * zooFamilyCount / slowness);
    for (std::uint64_t number = 0; number < count; ++number) {
        const Specimen animal = specimen(number);
        BranchMeshOptions options = animal.meshOptions();
        options.forkSoftness = (number & 1) != 0 ? 1.0 : 0.0;
        options.forkReach = (number & 2) != 0 ? 4.0 : 1e-9;
        options.nearTwinRatio = (number & 4) != 0 ? 4.0 : 0.0;
        options.clampOvershoot = (number & 8) != 0;
        const std::string faults = branchMeshFaults(animal.skeleton, options);
        if (!faults.empty() && text.size() < 5000)
            text += "\n" + QByteArray::fromStdString(animal.name) + "\n" + QByteArray::fromStdString(faults);
    }
    QVERIFY2(text.isEmpty(), text);
}

void TestForksSoftness::softnessAndReachOfZeroAreTheSame()
{
    const Expected<Skeleton> tree = presetSkeleton({"TinyTree"});
    QVERIFY2(tree, why(tree));
    const Expected<BranchMesh> hard = build(*tree, 0.0), near = build(*tree, 1.0, 0.0),
                               soft = build(*tree, 1.0);
    QVERIFY(hard && near && soft);
    QVERIFY(hard->mesh == near->mesh);
    QVERIFY(hard->mesh.positions != soft->mesh.positions);
}

/// The softer, the fuller: the crease gets shallower and the fork encloses more.
void TestForksSoftness::creasesAreRounded()
{
    double crease = 10.0, volume = 0.0, first = 0.0;
    for (const double softness : {0.0, 0.4, 0.8, 1.0}) {
        const Expected<BranchMesh> built = build(wye(70.0 * degrees), softness);
        QVERIFY2(built, why(built));
        const std::vector<double> angles = creases(built->mesh, valley(*built));
        QVERIFY(!angles.empty());
        const double steepest = *std::max_element(angles.begin(), angles.end());
        const double holds = checkMesh(built->mesh).volume();
        qInfo("softness %.1f: crease %.1f degrees, %.6f m3", softness, steepest / degrees, holds);
        QVERIFY(steepest < crease && holds > volume);
        crease = steepest;
        volume = holds;
        first = std::max(first, crease);
    }
    QVERIFY(crease < 0.8 * first);
}

/// Swelling ends where the siblings are further apart than the reach, here 0.05 m, and the next fork's ring
/// stays where it was.
void TestForksSoftness::onlyTheForkIsMoved()
{
    const Expected<BranchMesh> soft = build(wye(70.0 * degrees), 1.0, 0.5),
                               hard = build(wye(70.0 * degrees), 0.0, 0.5);
    QVERIFY(soft && hard);
    const auto away = [](const BranchMesh& built) {
        std::set<std::array<float, 3>> places;
        for (const glm::vec3& p : built.mesh.positions)
            if (p.y > 3.0F || p.y < 2.0001F)
                places.insert({p.x, p.y, p.z});
        return places;
    };
    QVERIFY(away(*soft).size() > 300);
    QVERIFY(away(*soft) == away(*hard));
    QVERIFY(soft->mesh.positions != hard->mesh.positions);
}

void TestForksSoftness::noKinkWhereAForkBegins_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<int>("length");
    for (const double angle : {20.0, 50.0, 80.0})
        for (const int length : {12, 24, 48})
            QTest::addRow("%.0f degrees, %d sections", angle, length) << angle << length;
}

/// A child's curve begins in its parent's direction, so the surface is smooth across the ring they share:
/// faces below and above it may differ by what the curve bends from one cross-section to the next. Twice a
/// curve's mean bend is allowed, for the bend is strongest at its start, and 6 degrees for the foot of the
/// valley, where a wall vertex is drawn a little away from both tubes.
void TestForksSoftness::noKinkWhereAForkBegins()
{
    QFETCH(double, angle);
    QFETCH(int, length);
    for (const double softness : {0.0, 0.8, 1.0}) {
        const Expected<BranchMesh> built = build(wye(angle * degrees), softness, 1.0, 24, length);
        QVERIFY2(built, why(built));
        std::set<Index> ring;
        for (Index v = 0; v < built->mesh.vertexCount(); ++v)
            if (const glm::vec3& p = built->mesh.positions[v];
                std::abs(p.y - 2.0F) < 1e-5F && std::abs(std::hypot(p.x, p.z) - 0.1F) < 1e-5F)
                ring.insert(v);
        QVERIFY(ring.size() >= 24);
        const std::vector<double> angles = creases(built->mesh, ring);
        QCOMPARE(angles.size(), ring.size());
        const double steepest = *std::max_element(angles.begin(), angles.end()) / degrees;
        qInfo("softness %.1f: %.2f degrees", softness, steepest);
        QVERIFY2(steepest < 6.0 + 2.0 * angle / (length - 1), QByteArray::number(steepest));
    }
}

void TestForksSoftness::noMoreSlivers_data()
{
    QTest::addColumn<QString>("preset");
    for (const char* preset : {"SmallTree", "TinyTree", "FanTree", "Fern2D"})
        QTest::newRow(preset) << QString(preset);
}

/// Rounded forks have no more thin triangles than sharp ones, within a tenth, and none thinner by far.
void TestForksSoftness::noMoreSlivers()
{
    QFETCH(QString, preset);
    const std::string name = preset.toStdString();
    const Expected<Skeleton> tree = presetSkeleton({name});
    QVERIFY2(tree, why(tree));
    const auto measure = [&](double softness) -> MeshQuality {
        const Expected<BranchMesh> built = build(*tree, softness, 1.0, 8, 4);
        const Expected<MeshQuality> quality = built ? measureQuality(built->mesh) : fail(built.error());
        return quality ? *quality : MeshQuality{};
    };
    const MeshQuality hard = measure(0.0);
    for (const double softness : {0.8, 1.0}) {
        const MeshQuality soft = measure(softness);
        qInfo("softness %.1f: %u below 5 degrees, of the sharp ones %u; smallest %.3f, %.3f degrees",
              softness, soft.angles[0], hard.angles[0], soft.smallestAngleRad / degrees,
              hard.smallestAngleRad / degrees);
        QVERIFY(soft.angles[0] <= hard.angles[0] * 11 / 10 + 20);
        QCOMPARE(soft.withoutArea, Index(0));
    }
}

RAMURE_SUITE(TestForksSoftness)

} // namespace tst_forks_softness

#include "tst_forks_softness.moc"
