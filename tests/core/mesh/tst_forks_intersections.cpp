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
};

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
    BranchMeshOptions options;
    options.radialDivisions = radial;
    const Expected<BranchMesh> built = buildBranchMesh(*skeleton, options);
    QVERIFY2(built, why(built));
    const SelfIntersections found =
        findSelfIntersections(built->mesh, repairedParents(*skeleton, built->repairs));
    qInfo("%s: %u triangles, same %u, siblings %u, parent-child %u, far %u", QTest::currentDataTag(),
          built->mesh.faceCount(), found.same, found.siblings, found.parentChild, found.far);
    QVERIFY2(found.aroundForks() <= bar, found.summary(built->mesh).c_str());
}

QTEST_GUILESS_MAIN(TestForksIntersections)
#include "tst_forks_intersections.moc"
