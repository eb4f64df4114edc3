#include "core/math/frame.h"
#include "core/math/reproducible.h"
#include "core/print/notch_fill.h"
#include "core/print/print_report.h"
#include "core/print/united_surface.h"
#include "core/surface/mesh/normals.h"
#include "tests/core/io/io_support.h"
#include <numbers>

namespace tst_notch_fill {

using namespace ramure;

namespace {

/// A closed cylinder.
void addRod(TriangleMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double radius)
{
    constexpr Index sides = 48;
    const Frame frame = frameFromTangent(glm::normalize(to - from));
    const Index first = mesh.vertexCount();
    for (const glm::dvec3& end : {from, to})
        for (Index k = 0; k < sides; ++k) {
            const auto at = maths::sincos(2.0 * std::numbers::pi * k / sides);
            mesh.positions.emplace_back(end + radius * (at.cos * frame.normal + at.sin * frame.binormal));
        }
    mesh.positions.emplace_back(from);
    mesh.positions.emplace_back(to);
    const Index bottom = first + 2 * sides, top = bottom + 1;
    for (Index k = 0; k < sides; ++k) {
        const Index a = first + k, b = first + (k + 1) % sides;
        mesh.triangles.emplace_back(b, a, bottom);
        mesh.triangles.emplace_back(a + sides, b + sides, top);
        mesh.triangles.emplace_back(a, b, b + sides);
        mesh.triangles.emplace_back(a, b + sides, a + sides);
    }
}

/// A trunk that goes on, and a branch that leaves it.
Skeleton fork(double angleDeg, double thin)
{
    const auto way = maths::sincos(angleDeg * std::numbers::pi / 180.0);
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 6, 0}, {0, 10, 0}, 1.0, 1.0);
    out.add(trunk, {0, 10, 0}, {0, 14, 0}, 1.0, 1.0);
    out.add(trunk, {0, 10, 0}, glm::dvec3(0, 10, 0) + 5.0 * glm::dvec3(way.sin, way.cos, 0), thin, thin, 1);
    return out;
}

TriangleMesh rodsOf(const Skeleton& skeleton)
{
    TriangleMesh mesh;
    for (Index i = 0; i < skeleton.size(); ++i)
        addRod(mesh, skeleton.p0[i], skeleton.p1[i], skeleton.a0[i]);
    return mesh;
}

/// A ball that touches a surface near a fork from outside, at every vertex there: how much of its radius is
/// left between its middle and the nearest of the surface, ascending. 1: it has room.
std::vector<double> roomFor(double radius, TriangleMesh mesh, const NotchBall& ball)
{
    computeNormals(mesh);
    std::vector<double> room;
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const glm::dvec3 p = mesh.positions[v];
        if (glm::distance(p, ball.centre) > 0.9 * ball.inner)
            continue;
        const glm::dvec3 middle = p + radius * glm::dvec3(mesh.normals[v]);
        double least = radius;
        for (const glm::vec3& other : mesh.positions)
            least = std::min(least, glm::distance(middle, glm::dvec3(other)));
        room.push_back(least / radius);
    }
    std::sort(room.begin(), room.end());
    return room;
}

} // namespace

class TestNotchFill : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatDoesNotForkHasNoNotch()
    {
        QVERIFY(notchBalls({}).empty());
        Skeleton rod;
        const Index first = rod.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
        QVERIFY(notchBalls(rod).empty());
        rod.add(first, {0, 1, 0}, {0, 2, 0}, 0.1, 0.1);
        QVERIFY(notchBalls(rod).empty());
        rod.add(first, {0, 1, 0}, {0, 1, 0}, 0.1, 0.1); // of no length
        QVERIFY(notchBalls(rod).empty());
        QCOMPARE(notchBalls(fork(60.0, 0.5)).size(), std::size_t(1));
    }
    void aFlatPlaceStays()
    {
        DistanceBox box;
        box.size = {24, 24, 24};
        for (int z = 0; z < 24; ++z)
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x)
                    box.values.push_back(std::clamp(float(y) - 11.6F, -box.band, box.band));
        for (const double radius : {1.0, 1.8, 3.0}) {
            const auto filled = withFilledNotch(box, {{12, 12, 12}, radius, 5.0, 7.0});
            for (std::size_t i = 0; i < filled.size(); ++i)
                QVERIFY2(filled[i] <= box.values[i] && filled[i] > box.values[i] - 0.05F,
                         qPrintable(QStringLiteral("%1: %2, not %3")
                                        .arg(radius)
                                        .arg(double(filled[i]))
                                        .arg(double(box.values[i]))));
        }
    }
    void notchesAreRound_data()
    {
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("thin");
        for (const double angle : {40.0, 60.0, 90.0})
            for (const double thin : {0.5, 0.9})
                QTest::addRow("%g deg, %g", angle, thin) << angle << thin;
    }
    void notchesAreRound()
    {
        QFETCH(const double, angle);
        QFETCH(const double, thin);
        const Skeleton skeleton = fork(angle, thin);
        const double voxel = 0.1 * thin;
        UnionOptions options{voxel, false};
        const NotchBall ball = notchBalls(skeleton).front();
        const auto sharp = unitedSurface(rodsOf(skeleton), options);
        options.notches = {ball};
        const auto round = unitedSurface(rodsOf(skeleton), options);
        QVERIFY2(sharp, test::why(sharp));
        QVERIFY2(round, test::why(round));
        const double wanted = leastFillet * thin;
        const auto before = roomFor(wanted, sharp->mesh, ball), after = roomFor(wanted, round->mesh, ball);
        // Normals of a grid's vertices are not exact: the middle of the ball is a little off at a few.
        QVERIFY2(before.front() < 0.5 && after.front() > 0.75 && after[after.size() / 100] > 0.9,
                 qPrintable(QStringLiteral("%1 -> %2, %3")
                                .arg(before.front())
                                .arg(after.front())
                                .arg(after[after.size() / 100])));
        const auto report = printReport(std::make_shared<const TriangleMesh>(round->mesh), thin);
        QVERIFY(report && report->isClosed && report->pieces == 1 && report->crossings == 0);
        const auto other = printReport(std::make_shared<const TriangleMesh>(sharp->mesh), thin);
        QVERIFY(other && other->high == report->high && other->low == report->low); // elsewhere it stays
    }
};

RAMURE_SUITE(TestNotchFill)

} // namespace tst_notch_fill

#include "tst_notch_fill.moc"
