#include "core/math/hermite.h"
#include "core/skeleton/sections.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_forks_shape {

using namespace ramure;
using namespace ramure::test;

/// A closed manifold could still be the wrong shape: the mesh follows the skeleton's curves at the skeleton's
/// radii, reaches every tip, and encloses the volume that the union of the single tubes has.
class TestForksShape : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void tubesStayAtTheirCurves_data();
    void tubesStayAtTheirCurves();
    void everyTipIsReached_data();
    void everyTipIsReached();
    void volumeIsThatOfTheUnion_data();
    void volumeIsThatOfTheUnion();
    void oneBranchIsACappedCone();
};

namespace {

struct Built
{
    Skeleton skeleton;
    BranchMesh mesh;
};

Expected<Built> build(const QString& preset, const BranchMeshOptions& options = {})
{
    Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    if (!skeleton)
        return fail(skeleton.error());
    Expected<BranchMesh> mesh = buildBranchMesh(*skeleton, options);
    if (!mesh)
        return fail(mesh.error());
    return Built{std::move(*skeleton), std::move(*mesh)};
}

double distanceToCurve(const glm::dvec3& point, const BranchCurve& curve)
{
    double nearest = INFINITY;
    for (int i = 0; i <= 64; ++i)
        nearest = std::min(
            nearest, glm::distance(point, hermite(curve.h0, curve.h1, curve.v0, curve.v1, i / 64.0).point));
    return nearest;
}

} // namespace

void TestForksShape::tubesStayAtTheirCurves_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("TinyTree") << "TinyTree";
    QTest::newRow("SmallTree") << "SmallTree";
}

/// Walls between siblings stand a little off, where the tubes come apart, and further where softness fills
/// the valley between tubes that part at a small angle.
void TestForksShape::tubesStayAtTheirCurves()
{
    QFETCH(QString, preset);
    for (const auto& [softness, most] :
         {std::pair{0.0, 1.3}, std::pair{BranchMeshOptions().forkSoftness, 1.75}}) {
        BranchMeshOptions options;
        options.forkSoftness = softness;
        const Expected<Built> tree = build(preset, options);
        QVERIFY2(tree, why(tree));
        const TriangleMesh& mesh = tree->mesh.mesh;
        double farthest = 0.0;
        for (Index v = 0; v < mesh.vertexCount(); ++v) {
            const Index branch = mesh.branch[v];
            const double distance =
                distanceToCurve(glm::dvec3(mesh.positions[v]), branchCurve(tree->skeleton, branch));
            farthest = std::max(farthest, distance / tree->skeleton.a0[branch]);
        }
        QVERIFY2(farthest < most, QByteArray::number(farthest));
    }
}

void TestForksShape::everyTipIsReached_data()
{
    tubesStayAtTheirCurves_data();
    QTest::newRow("FanTree") << "FanTree";
}

void TestForksShape::everyTipIsReached()
{
    QFETCH(QString, preset);
    const Expected<Built> tree = build(preset);
    QVERIFY2(tree, why(tree));
    const Skeleton& skeleton = tree->skeleton;
    std::vector<double> nearest(skeleton.size(), INFINITY);
    const TriangleMesh& mesh = tree->mesh.mesh;
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const Index branch = mesh.branch[v];
        nearest[branch] =
            std::min(nearest[branch], glm::distance(glm::dvec3(mesh.positions[v]), skeleton.p1[branch]));
    }
    for (const RepairNote& note : tree->mesh.repairs)
        if (note.kind == SkeletonRepair::SiblingsMerged)
            nearest[note.branch] = 0.0; // another tube serves it
    const ChildLists children = childLists(skeleton);
    for (Index i = 0; i < skeleton.size(); ++i)
        if (children.count(i) == 0)
            QVERIFY2(nearest[i] < 1.1 * skeleton.a1[i], qPrintable(QString("branch %1").arg(i)));
}

void TestForksShape::volumeIsThatOfTheUnion_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<double>("cubicMetres");
    // A boolean union of closed tubes over the same curves, made once by another program.
    QTest::newRow("TinyTree") << "TinyTree" << 0.07344;
    QTest::newRow("SmallTree") << "SmallTree" << 0.3195;
}

void TestForksShape::volumeIsThatOfTheUnion()
{
    QFETCH(QString, preset);
    QFETCH(double, cubicMetres);
    const Expected<Built> tree = build(preset);
    QVERIFY2(tree, why(tree));
    const double volume = checkMesh(tree->mesh.mesh).volume();
    QVERIFY2(std::abs(volume / cubicMetres - 1.0) < 0.04, qPrintable(QString::number(volume)));
}

void TestForksShape::oneBranchIsACappedCone()
{
    Skeleton skeleton;
    skeleton.add(noIndex, {1, 2, 3}, {1, 4, 3}, 0.5, 0.25);
    BranchMeshOptions options;
    options.radialDivisions = 128;
    const Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
    QVERIFY2(built, why(built));
    const double cone = 3.14159265358979 / 3.0 * 2.0 * (0.25 + 0.125 + 0.0625);
    const double tip = 3.14159265358979 / 3.0 * 0.0625 * 0.35 * 0.25;
    const double volume = checkMesh(built->mesh).volume();
    QVERIFY2(std::abs(volume / (cone + tip) - 1.0) < 0.001, qPrintable(QString::number(volume)));
}

RAMURE_SUITE(TestForksShape)

} // namespace tst_forks_shape

#include "tst_forks_shape.moc"
