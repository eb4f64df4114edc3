#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/self_intersections.h"
#include "tests/support/suite.h"

namespace tst_forks_intersections {

using namespace ramure;
using namespace ramure::test;

/// Around forks no triangle runs through another, counted with exact predicates. Pairs of branches far from
/// each other in the tree that collide are a property of the skeleton and no fault of the mesh.
class TestForksIntersections : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void aroundForks_data();
    void aroundForks();
    void softForks_data();
    void softForks();
    void randomSmallTrees();
};

namespace {

struct Counted
{
    Expected<BranchMesh> built;
    test::SelfIntersections found;
};

Counted count(const Skeleton& skeleton, int radial, int length, BranchMeshOptions options = {})
{
    options.radialDivisions = radial;
    options.lengthDivisions = length;
    Counted counted{buildBranchMesh(skeleton, options), {}};
    if (counted.built)
        counted.found = test::findSelfIntersections(counted.built->mesh,
                                                    test::repairedParents(skeleton, counted.built->repairs));
    return counted;
}

} // namespace

void TestForksIntersections::aroundForks_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<int>("length");
    const auto row = [](const char* preset, int radial, int length) {
        QTest::addRow("%s %d radial x %d length", preset, radial, length) << preset << radial << length;
    };
    for (const char* preset : {"SmallTree", "TinyTree", "Fern2D", "FanTree"}) {
        row(preset, 5, 4);
        row(preset, 8, 4);
        row(preset, 16, 4);
        row(preset, 8, 2);
        row(preset, 5, 8);
        row(preset, 8, 8);
        row(preset, 16, 8);
    }
    // Its forks of nine and ten children, which come apart late, folded where rings are fine.
    row("FanTree", 12, 3);
    row("FanTree", 24, 4);
}

void TestForksIntersections::aroundForks()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(int, length);
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    QVERIFY2(skeleton, why(skeleton));
    const Counted counted = count(*skeleton, radial, length);
    QVERIFY2(counted.built, why(counted.built));
    const test::SelfIntersections& found = counted.found;
    qInfo("%s: %u triangles, same %u, siblings %u, parent-child %u, far %u", QTest::currentDataTag(),
          counted.built->mesh.faceCount(), found.same, found.siblings, found.parentChild, found.far);
    QVERIFY2(found.aroundForks() == 0, found.summary(counted.built->mesh).c_str());
}

void TestForksIntersections::softForks_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<int>("length");
    QTest::addColumn<double>("softness");
    QTest::addColumn<double>("reach");
    const auto row = [](const char* preset, int radial, int length, double softness, double reach) {
        QTest::addRow("%s %d radial x %d length, softness %.1f, reach %.1f", preset, radial, length, softness,
                      reach)
            << preset << radial << length << softness << reach;
    };
    row("SmallTree", 8, 4, 1.0, 2.0);
    row("FanTree", 8, 4, 1.0, 2.0);
    row("Fern2D", 8, 4, 1.0, 2.0);
    row("TinyTree", 24, 16, 1.0, 2.0);
    row("TinyTree", 16, 8, 0.7, 4.0);
}

/// However soft a fork is wanted: it is softened as far as its tubes do not swell into each other.
void TestForksIntersections::softForks()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(int, length);
    QFETCH(double, softness);
    QFETCH(double, reach);
    BranchMeshOptions options;
    options.forkSoftness = softness;
    options.forkReach = reach;
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    QVERIFY2(skeleton, why(skeleton));
    const Counted counted = count(*skeleton, radial, length, options);
    QVERIFY2(counted.built, why(counted.built));
    QVERIFY2(counted.found.aroundForks() == 0, counted.found.summary(counted.built->mesh).c_str());
}

/// The preset is one tree of its grammar among many: others fork at other angles.
void TestForksIntersections::randomSmallTrees()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const int radial : {5, 8}) {
            PresetTree tree{"SmallTree"};
            tree.stochastic = seed;
            tree.iterations = 6;
            const Expected<Skeleton> skeleton = presetSkeleton(tree);
            QVERIFY2(skeleton, why(skeleton));
            const Counted counted = count(*skeleton, radial, 4);
            QVERIFY2(counted.built, why(counted.built));
            QVERIFY2(
                counted.found.aroundForks() == 0,
                ("seed " + std::to_string(seed) + ": " + counted.found.summary(counted.built->mesh)).c_str());
        }
}

RAMURE_SUITE(TestForksIntersections)

} // namespace tst_forks_intersections

#include "tst_forks_intersections.moc"
