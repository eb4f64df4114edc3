#include "tests/support/preset_trees.h"
#include "tests/support/self_intersections.h"
#include "tests/support/suite.h"

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
    void randomSmallTrees();
};

namespace {

struct Counted
{
    Expected<BranchMesh> built;
    SelfIntersections found;
};

Counted count(const Skeleton& skeleton, int radial)
{
    BranchMeshOptions options;
    options.radialDivisions = radial;
    Counted counted{buildBranchMesh(skeleton, options), {}};
    if (counted.built)
        counted.found =
            findSelfIntersections(counted.built->mesh, repairedParents(skeleton, counted.built->repairs));
    return counted;
}

} // namespace

void TestForksIntersections::aroundForks_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<Index>("bar");
    for (const int radial : {5, 8}) {
        QTest::addRow("SmallTree %d radial", radial) << "SmallTree" << radial << 0u;
        QTest::addRow("TinyTree %d radial", radial) << "TinyTree" << radial << 0u;
        QTest::addRow("Fern2D %d radial", radial) << "Fern2D" << radial << 0u;
        // 14 children on one branch, some of which never separate within their length.
        QTest::addRow("FanTree %d radial", radial) << "FanTree" << radial << 3000u;
    }
}

void TestForksIntersections::aroundForks()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(Index, bar);
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    QVERIFY2(skeleton, why(skeleton));
    const Counted counted = count(*skeleton, radial);
    QVERIFY2(counted.built, why(counted.built));
    const SelfIntersections& found = counted.found;
    qInfo("%s: %u triangles, same %u, siblings %u, parent-child %u, far %u", QTest::currentDataTag(),
          counted.built->mesh.faceCount(), found.same, found.siblings, found.parentChild, found.far);
    QVERIFY2(found.aroundForks() <= bar, found.summary(counted.built->mesh).c_str());
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
            const Counted counted = count(*skeleton, radial);
            QVERIFY2(counted.built, why(counted.built));
            QVERIFY2(
                counted.found.aroundForks() == 0,
                ("seed " + std::to_string(seed) + ": " + counted.found.summary(counted.built->mesh)).c_str());
        }
}

QTEST_GUILESS_MAIN(TestForksIntersections)
#include "tst_forks_intersections.moc"
