#include "core/surface/mesher/trunk_foot.h"

#include "core/surface/check/self_intersections.h"
#include "core/surface/check/texture_report.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "core/surface/texture/texture_coordinates.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_trunk_foot {

using namespace ramure;
using namespace ramure::test;

namespace {

/// A trunk with two limbs at its end.
Skeleton tree(const glm::dvec3& top = {0, 4, 0}, const glm::dvec3& foot = glm::dvec3(0.0),
              double radius = 0.2)
{
    Skeleton out;
    const Index trunk = out.add(noIndex, foot, foot + top, radius, 0.9 * radius);
    for (const double side : {-1.0, 1.0})
        out.add(trunk, foot + top, foot + top + glm::dvec3(side, 2, 0), 0.7 * radius, 0.3 * radius);
    return out;
}

BranchMeshOptions rooted(int roots, int sides = 12)
{
    BranchMeshOptions options;
    options.roots = roots;
    options.radialDivisions = sides;
    return options;
}

TrunkFoot footOf(const Skeleton& skeleton, const BranchMeshOptions& options, std::uint64_t seed = 1)
{
    MeshBranch trunk;
    trunk.p0 = skeleton.p0[0];
    trunk.p1 = skeleton.p1[0];
    trunk.a0 = skeleton.a0[0];
    trunk.a1 = skeleton.a1[0];
    trunk.foot = 0;
    return {trunk, options, static_cast<Index>(options.radialDivisions), seed};
}

bool hasRoots(const Skeleton& skeleton, const BranchMeshOptions& options)
{
    const auto mesh = buildBranchMesh(skeleton, options);
    return mesh && mesh->axes.front().foot.rings > 0;
}

/// m, how far from the trunk the mesh reaches between two heights.
double reach(const TriangleMesh& mesh, double from, double to)
{
    double most = 0.0;
    for (const glm::vec3& p : mesh.positions)
        if (double(p.y) >= from && double(p.y) <= to)
            most = std::max(most, std::hypot(double(p.x), double(p.z)));
    return most;
}

/// m², of the cross-section of the mesh at a height.
double areaAt(const TriangleMesh& mesh, double height)
{
    double area = 0.0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        glm::dvec2 from(0.0), to(0.0);
        for (int c = 0; c < 3; ++c) {
            const glm::dvec3 a(mesh.positions[triangle[c]]), b(mesh.positions[triangle[(c + 1) % 3]]);
            if ((a.y < height) == (b.y < height))
                continue;
            const glm::dvec3 at = a + (height - a.y) / (b.y - a.y) * (b - a);
            (a.y < height ? from : to) = {at.x, at.z};
        }
        area += 0.5 * (from.x * to.y - from.y * to.x);
    }
    return std::abs(area);
}

} // namespace

class TestTrunkFoot : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }

    void whatIsNoTrunkHasNoRoots()
    {
        QVERIFY(hasRoots(tree(), rooted(5)));
        QVERIFY(!hasRoots(tree(), rooted(0)));
        QVERIFY(!hasRoots(tree({4, 1, 0}), rooted(5)));            // it lies
        QVERIFY(!hasRoots(tree({0, -4, 0}), rooted(5)));           // it hangs
        QVERIFY(!hasRoots(tree({0, 4, 0}, {0, 1, 0}), rooted(5))); // a limb that falls
        Skeleton stems = tree();
        stems.add(noIndex, {0.05, 0, 0}, {1, 4, 0}, 0.2, 0.1);
        QVERIFY(!hasRoots(stems, rooted(5))); // they stand on a plate of their own
    }

    /// Closed and manifold whatever the roots are like, without a crossing in the usual ranges.
    void feetAreClosed_data()
    {
        QTest::addColumn<int>("roots");
        for (int roots = 1; roots <= 16; ++roots)
            QTest::addRow("%d roots", roots) << roots;
    }
    void feetAreClosed()
    {
        QFETCH(int, roots);
        for (const int sides : {6, 12, 40})
            for (const double length : {0.1, 0.5, 1.0, 3.0, 10.0})
                for (const double height : {0.1, 0.3, 1.0, 3.0, 10.0})
                    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                        BranchMeshOptions options = rooted(roots, sides);
                        options.rootLength = length;
                        options.rootHeight = height;
                        options.seed = seed;
                        const Skeleton skeleton = tree({0.5, 4, 0.2});
                        const auto built = buildCheckedBranchMesh(skeleton, options);
                        QVERIFY2(built, why(built));
                        const QByteArray place = QStringLiteral("%1 sides, %2 x %3, seed %4")
                                                     .arg(sides)
                                                     .arg(length)
                                                     .arg(height)
                                                     .arg(seed)
                                                     .toUtf8();
                        QVERIFY2(built->report.valid && built->report.eulerCharacteristic == 2, place);
                        const bool isUsual =
                            roots <= 9 && length >= 0.5 && length <= 3.0 && height >= 0.3 && height <= 3.0;
                        if (!isUsual) // crests so thin that straight edges cut through them
                            continue;
                        const auto crossings = findSelfIntersections(built->mesh.mesh, skeleton.parent);
                        QVERIFY2(crossings, why(crossings));
                        QVERIFY2(crossings->count(PairKind::Same) == 0, place);
                    }
    }

    /// They leave the trunk where they are told to, run out as far as they are told to, and end in the
    /// ground.
    void rootsRunOutAndSink()
    {
        BranchMeshOptions options = rooted(5, 24);
        const auto mesh = buildBranchMesh(tree(), options);
        QVERIFY2(mesh, why(mesh));
        const double radius = 0.2;
        QVERIFY(reach(mesh->mesh, 1.05 * 2.0 * radius, 1.0) < 1.001 * radius);
        QVERIFY(reach(mesh->mesh, 0.5 * radius, radius) > 1.2 * radius);
        const double atGround = reach(mesh->mesh, -0.001, 0.2 * radius);
        QVERIFY2(atGround > 3.0 * radius && atGround < 9.0 * radius, qPrintable(QString::number(atGround)));
        options.rootLength = 4.0;
        const auto longer = buildBranchMesh(tree(), options);
        QVERIFY(longer && reach(longer->mesh, -0.001, 0.2 * radius) > 1.5 * atGround);
        options.rootHeight = 3.0;
        const auto higher = buildBranchMesh(tree(), options);
        QVERIFY(higher && reach(higher->mesh, 2.0 * radius, 6.0 * radius) > 1.3 * radius);
        float lowest = 0.0F;
        for (const glm::vec3& p : mesh->mesh.positions)
            lowest = std::min(lowest, p.y);
        QVERIFY(lowest < -0.3F * float(radius));
    }

    /// A foot is neither a post nor a trumpet nor a star: on the ground it is one and a third to two times as
    /// wide as the trunk at breast height, and half a diameter higher the lobes are still there.
    void feetFlareIntoRoots()
    {
        for (const int roots : {4, 5, 7, 9})
            for (const int sides : {12, 20, 32}) {
                BranchMeshOptions options = rooted(roots, sides);
                options.rootLength = 0.55;
                double atGround = 0.0, above = 0.0;
                for (options.seed = 1; options.seed <= 6; ++options.seed) {
                    const auto mesh = buildBranchMesh(tree(), options);
                    QVERIFY2(mesh, why(mesh));
                    const double trunk = areaAt(mesh->mesh, 1.3);
                    atGround += std::sqrt(areaAt(mesh->mesh, 0.02) / trunk) / 6.0;
                    above += std::sqrt(areaAt(mesh->mesh, 0.2) / trunk) / 6.0;
                }
                QVERIFY2(atGround >= 1.3 && atGround <= 2.0, qPrintable(QString::number(atGround)));
                QVERIFY2(above >= 1.1 && above <= 0.8 * atGround, qPrintable(QString::number(above)));
            }
    }

    /// A slope shears a foot: closed as ever, its highest ring the trunk's own circle, and all that lies
    /// under level ground lies under the slope.
    void rootsFollowASlope_data()
    {
        QTest::addColumn<double>("grade");
        for (const double grade : {0.1, 0.4, 1.0, 1.7, 5.0, 1e9})
            QTest::addRow("%g", grade) << grade;
    }
    void rootsFollowASlope()
    {
        QFETCH(double, grade);
        for (const int sides : {8, 16, 32})
            for (const double height : {0.3, 0.6, 1.0, 2.0})
                for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                    BranchMeshOptions options = rooted(3 + int(seed), sides);
                    options.rootHeight = height;
                    options.rootLength = 0.4 * double(seed);
                    options.seed = seed;
                    const double turn = 1.3 * double(seed);
                    const glm::dvec2 uphill(std::cos(turn), std::sin(turn));
                    options.ground = GroundPlane{0.0, grade * uphill};
                    const Skeleton skeleton = tree({0.1 * double(seed), 4, 0.1});
                    const auto built = buildCheckedBranchMesh(skeleton, options);
                    QVERIFY2(built, why(built));
                    const QByteArray place = QStringLiteral("%1 sides, height %2, seed %3")
                                                 .arg(sides)
                                                 .arg(height)
                                                 .arg(seed)
                                                 .toUtf8();
                    QVERIFY2(built->report.valid && built->report.eulerCharacteristic == 2, place);
                    const auto crossings = findSelfIntersections(built->mesh.mesh, skeleton.parent);
                    QVERIFY2(crossings && crossings->count(PairKind::Same) == 0, place);
                    const GroundPlane ground{0.0, std::min(grade, 2.0) * uphill};
                    const FootSize foot = built->mesh.axes.front().foot;
                    QVERIFY2(foot.rings > 0, place);
                    for (Index i = 0; i < 1 + 2 * foot.points; ++i) // the pole and the two lowest rings
                        QVERIFY2(ground.above(glm::dvec3(built->mesh.mesh.positions[i])) < 0.0, place);
                }
    }

    /// Uphill roots enter the ground higher, downhill they reach lower, and both are as long along the ground
    /// as on a level one.
    void slopesAreMetOnBothSides()
    {
        BranchMeshOptions options = rooted(6, 24);
        const auto reachOn = [&](const GroundPlane& ground, double side) {
            options.ground = ground;
            double most = 0.0;
            for (options.seed = 1; options.seed <= 6; ++options.seed) {
                const auto mesh = buildBranchMesh(tree(), options);
                if (!mesh)
                    return 0.0;
                double own = 0.0;
                for (const glm::vec3& p : mesh->mesh.positions) {
                    const glm::dvec3 at(p);
                    if (const double above = ground.above(at);
                        side * at.x > 0.0 && above > -0.001 && above < 0.04)
                        own = std::max(own, side * at.x * std::sqrt(1.0 + ground.grade.x * ground.grade.x));
                }
                most += own / 6.0;
            }
            return most;
        };
        const GroundPlane level, slope{0.0, {0.6, 0.0}};
        for (const double side : {-1.0, 1.0}) {
            const double ratio = reachOn(slope, side) / reachOn(level, side);
            QVERIFY2(ratio > 0.85 && ratio < 1.25, qPrintable(QString::number(ratio)));
        }
    }

    /// Ground that lies a little higher or lower than where the trunk begins is met where it is.
    void groundIsMetWhereItIs()
    {
        for (const double height : {-0.3, -0.1, 0.1, 0.3}) {
            BranchMeshOptions options = rooted(5, 20);
            options.ground = GroundPlane{height, {0.2, -0.1}};
            const auto built = buildCheckedBranchMesh(tree(), options);
            QVERIFY2(built, why(built));
            QVERIFY(built->report.valid && built->report.eulerCharacteristic == 2);
            const FootSize foot = built->mesh.axes.front().foot;
            double deepest = 0.0;
            for (Index i = 1; i < 1 + 2 * foot.points; ++i) {
                const double above = options.ground->above(glm::dvec3(built->mesh.mesh.positions[i]));
                QVERIFY2(above < 0.0, qPrintable(QString::number(above)));
                deepest = std::min(deepest, above);
            }
            QVERIFY(deepest > -0.3);
        }
        const auto level = buildBranchMesh(tree(), rooted(5));
        BranchMeshOptions options = rooted(5);
        options.ground = GroundPlane();
        const auto known = buildBranchMesh(tree(), options);
        QVERIFY(level && known);
        QCOMPARE(known->mesh.positions, level->mesh.positions);
    }

    /// Half of the roots fork where the trunk has sides enough for it.
    void rootsFork()
    {
        QCOMPARE(footSize(rooted(6), 8).roots, Index(6));
        QCOMPARE(footSize(rooted(6), 24).roots, Index(9));
    }

    void eachSeedHasItsOwnRoots()
    {
        BranchMeshOptions options = rooted(5);
        options.seed = 1;
        const auto one = buildBranchMesh(tree(), options), again = buildBranchMesh(tree(), options);
        options.seed = 2;
        const auto other = buildBranchMesh(tree(), options);
        QVERIFY(one && again && other);
        QCOMPARE(one->mesh.positions, again->mesh.positions);
        QVERIFY(one->mesh.positions != other->mesh.positions);
        QCOMPARE(one->mesh.positions.size(), other->mesh.positions.size());
    }

    /// The highest ring is the trunk's own circle; columns are in order, and each ring is as long as they
    /// are.
    void theHighestRingIsACircle()
    {
        const Skeleton skeleton = tree();
        const TrunkFoot foot = footOf(skeleton, rooted(7, 16));
        QVERIFY(foot.isThere());
        const auto columns = foot.columns();
        QCOMPARE(columns.size(), std::size_t(foot.size().points));
        const double height = 2.0 * 0.2; // of the trunk's radius, about
        for (Index column = 0; column < foot.size().points; ++column) {
            const glm::dvec3 at = foot.at(foot.size().rings - 1, column, Frame());
            QVERIFY(std::abs(std::hypot(at.x, at.z) - 0.2) < 0.01 && std::abs(at.y - height) < 0.05);
            QVERIFY(column == 0 || columns[column].azimuth > columns[column - 1].azimuth);
        }
        QVERIFY(columns.back().azimuth - columns.front().azimuth < 6.2832);
        std::vector<AxisSection> sections(3);
        sections[1].t = 0.5;
        sections[2].t = 1.0;
        foot.cutOff(sections);
        QCOMPARE(sections.size(), std::size_t(3));
        QVERIFY(sections[0].t > 0.05 && sections[0].t < 0.2 && sections[1].t == 0.5);
    }

    /// Bark follows the roots: next to nothing lies the wrong way round, and it keeps its scale along the
    /// crests.
    void barkFollowsTheRoots()
    {
        const auto mesh = buildBranchMesh(tree(), rooted(5, 20));
        QVERIFY2(mesh, why(mesh));
        const auto coordinates = textureCoordinates(*mesh, {});
        QVERIFY2(coordinates, why(coordinates));
        QVERIFY2(coordinates->apart <= 4, qPrintable(QString::number(coordinates->apart)));
        float lowest = 0.0F;
        for (const glm::vec2& uv : coordinates->uv)
            lowest = std::min(lowest, uv.y);
        QVERIFY2(lowest < -1.0F,
                 qPrintable(QString::number(double(lowest)))); // more than the trunk is around
    }

    /// On a slope about as well as on level ground, as long as it is one that people walk up.
    void barkFollowsRootsOnASlope()
    {
        const auto stretched = [](const std::optional<GroundPlane>& ground) {
            BranchMeshOptions options = rooted(5, 20);
            options.ground = ground;
            const auto mesh = buildBranchMesh(tree(), options);
            const auto coordinates = mesh ? textureCoordinates(*mesh, {}) : Expected<TextureCoordinates>();
            if (!coordinates)
                return 1.0;
            const TextureReport report = textureReport(*mesh, *coordinates);
            return report.mirrored > 0 ? 1.0 : 1.0 - report.goodShare();
        };
        const double level = stretched(std::nullopt);
        for (const auto& [grade, more] : {std::pair(0.3, 0.04), std::pair(0.6, 0.05), std::pair(1.0, 0.11)}) {
            const double share = stretched(GroundPlane{0.0, {0.8 * grade, 0.6 * grade}});
            QVERIFY2(share < level + more, qPrintable(QStringLiteral("%1, level %2").arg(share).arg(level)));
        }
    }

    /// A budget counts the foot in.
    void budgetsAreKept()
    {
        BranchMeshOptions options = rooted(7);
        for (const int budget : {1000, 4000, 16'000}) {
            options.targetTriangles = budget;
            const auto mesh = buildBranchMesh(tree(), options);
            QVERIFY2(mesh, why(mesh));
            const auto triangles = static_cast<double>(mesh->mesh.triangles.size());
            QVERIFY2(std::abs(triangles - budget) <= budgetSlack * budget,
                     qPrintable(QStringLiteral("%1 of %2").arg(triangles).arg(budget)));
        }
    }
};

RAMURE_SUITE(TestTrunkFoot)

} // namespace tst_trunk_foot

#include "tst_trunk_foot.moc"
