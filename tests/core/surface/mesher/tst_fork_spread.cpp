#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/mesher/fork_spread.h"

#include "core/surface/proof/validate.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_fork_spread {

using namespace ramure;
using namespace ramure::test;

namespace {

NormalSkeleton normalised(const Skeleton& skeleton, BranchMeshOptions options)
{
    return normaliseSkeleton(skeleton, options, {}).value_or(NormalSkeleton());
}

/// A trunk of 20 cm that forks into two of \p radius, each \p lean beside the vertical.
Skeleton twins(double radius, double lean, double length = 3.0)
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.2, 0.2);
    for (const double side : {-1.0, 1.0})
        out.add(trunk, {0, 2, 0}, {side * length * std::sin(lean), 2.0 + length * std::cos(lean), 0}, radius,
                radius);
    return out;
}

/// m², of the section at a height.
double sectionArea(const TriangleMesh& mesh, double height)
{
    double doubled = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        glm::dvec2 from(0.0), to(0.0);
        int ends = 0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 a(mesh.positions[t[k]]), b(mesh.positions[t[(k + 1) % 3]]);
            if ((a.y < height) == (b.y < height))
                continue;
            const double share = (height - a.y) / (b.y - a.y);
            const glm::dvec2 at(a.x + (b.x - a.x) * share, a.z + (b.z - a.z) * share);
            (a.y < height ? from : to) = at;
            ++ends;
        }
        if (ends == 2)
            doubled += from.x * to.y - to.x * from.y;
    }
    return std::abs(0.5 * doubled);
}

} // namespace

class TestForkSpread : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }

    void nothingIsSpreadWithoutALength()
    {
        BranchMeshOptions options;
        options.forkLength = 0.0;
        for (const MeshBranch& branch : normalised(twins(0.1, 0.3), options).branches)
            QCOMPARE(branch.spread, 0.0);
    }

    /// As wide as what carries it where it begins, thinner and thinner above, never below its own radius.
    void branchesNarrowFromTheForkOn()
    {
        for (std::uint64_t number = 0; number < fuzzCount(4 * zooFamilyCount); ++number) {
            const Specimen animal = specimen(number);
            const auto skeleton = normaliseSkeleton(animal.skeleton, animal.meshOptions(), {});
            if (!skeleton)
                continue;
            for (const MeshBranch& branch : skeleton->branches) {
                QVERIFY(branch.spread >= 0.0 && branch.spread <= mostSpread && branch.spreadDecay >= 0.0);
                for (const double t : {0.0, 0.1, 0.5, 1.0}) {
                    const double own = branch.a0 + (branch.a1 - branch.a0) * t;
                    QVERIFY(branch.radiusAt(t) >= own && branch.radiusAt(t) <= own * (1.0 + branch.spread));
                }
                QVERIFY(branch.spread == 0.0 || branch.parent != noIndex);
                QVERIFY(branch.isLimb || branch.spreadStart == 0.0);
                if (branch.spread == 0.0 || branch.spread == mostSpread || branch.isLimb)
                    continue;
                double widest = 0.0;
                for (const Index child : skeleton->childrenOf(branch.parent))
                    widest = std::max(widest, skeleton->branches[child].radiusAt(0.0));
                const double end = skeleton->branches[branch.parent].radiusAt(1.0);
                QVERIFY2(std::abs(widest - end) <= 1e-9 * end, animal.name.c_str());
            }
        }
    }

    /// A limb swells where it leaves the stem, and has its own radius two diameters on.
    void limbsHaveCollars_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("downAngle");
        for (const double radius : {0.02, 0.05, 0.08})
            for (const double downAngle : {0.7, 1.1, 1.5})
                QTest::addRow("%g m, %g rad", radius, downAngle) << radius << downAngle;
    }
    void limbsHaveCollars()
    {
        QFETCH(double, radius);
        QFETCH(double, downAngle);
        Skeleton skeleton;
        const Index trunk = skeleton.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.2, 0.2);
        skeleton.add(trunk, {0, 2, 0}, {0, 5, 0}, 0.2, 0.2);
        const glm::dvec3 way(std::sin(downAngle), std::cos(downAngle), 0.0);
        skeleton.add(trunk, {0, 2, 0}, glm::dvec3(0, 2, 0) + 1.5 * way, radius, radius);
        BranchMeshOptions options;
        options.radialDivisions = 24;
        options.lengthDivisions = 12;
        options.collar = 0.5;
        const NormalSkeleton normal = normalised(skeleton, options);
        const auto limb = std::ranges::find_if(normal.branches, &MeshBranch::isLimb);
        QVERIFY(limb != normal.branches.end());
        const double length = glm::length(limb->p1 - limb->p0);
        const auto at = [&](double diameters) {
            return limb->radiusAt(limb->spreadStart + diameters * 2.0 * radius / length);
        };
        const double swelling = at(0.5) / at(2.0);
        QVERIFY2(swelling >= 1.15 && swelling <= 1.5, qPrintable(QString::number(swelling)));
        QVERIFY(at(4.0) < 1.02 * radius);
        const auto built = buildCheckedBranchMesh(skeleton, options);
        QVERIFY2(built, why(built));
        QVERIFY(built->report.valid);
        // The mesh has it too: its rings stand where the collar narrows.
        double widest = 0.0;
        const glm::dvec3 axis = glm::normalize(limb->p1 - limb->p0);
        for (std::size_t i = 0; i < built->mesh.mesh.positions.size(); ++i) {
            const glm::dvec3 away = glm::dvec3(built->mesh.mesh.positions[i]) - limb->p0;
            const double along = glm::dot(away, axis);
            if (built->mesh.mesh.branch[i] == limb->source &&
                along > limb->spreadStart * length + 0.5 * 2.0 * radius)
                widest = std::max(widest, glm::length(away - along * axis));
        }
        QVERIFY2(widest > 1.1 * radius && widest < 1.5 * radius,
                 qPrintable(QString::number(widest / radius)));
    }

    /// A short piece hands on what it has not lost.
    void shortBranchesHandItOn()
    {
        Skeleton skeleton;
        const Index trunk = skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.2, 0.2);
        const Index piece = skeleton.add(trunk, {0, 1, 0}, {0, 1.05, 0}, 0.1, 0.1);
        skeleton.add(piece, {0, 1.05, 0}, {0, 3, 0}, 0.1, 0.1);
        const NormalSkeleton normal = normalised(skeleton, {});
        QCOMPARE(normal.branches.size(), std::size_t(3));
        QCOMPARE(normal.branches[1].spread, 1.0);
        QVERIFY(normal.branches[2].spread > 0.5);
        QVERIFY(std::abs(normal.branches[2].radiusAt(0.0) - normal.branches[1].radiusAt(1.0)) < 1e-12);
        QVERIFY(normal.branches[2].radiusAt(1.0) < 0.101);
    }

    /// Around the end of the trunk there is no ledge: no quarter of a diameter loses more than a quarter of
    /// the wood's section.
    void noLedgeIsLeft_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("lean");
        QTest::newRow("pipe model, 20 degrees apart") << 0.2 / std::sqrt(2.0) << 0.175;
        QTest::newRow("pipe model, 40 degrees apart") << 0.2 / std::sqrt(2.0) << 0.35;
        QTest::newRow("pipe model, 60 degrees apart") << 0.2 / std::sqrt(2.0) << 0.52;
        QTest::newRow("half as thick, 40 degrees apart") << 0.1 << 0.35;
    }
    void noLedgeIsLeft()
    {
        QFETCH(double, radius);
        QFETCH(double, lean);
        BranchMeshOptions options;
        options.radialDivisions = 16;
        options.lengthDivisions = 24;
        const auto built = buildBranchMesh(twins(radius, lean), options);
        QVERIFY2(built, why(built));
        QVERIFY(validateMesh(built->mesh)->valid);
        for (double height = 1.0; height < 3.5; height += 0.02) {
            const double below = sectionArea(built->mesh, height);
            const double above = sectionArea(built->mesh, height + 0.1);
            QVERIFY2(above >= 0.75 * below,
                     qPrintable(QStringLiteral("at %1 m: %2 of %3 m²").arg(height).arg(above).arg(below)));
        }
        options.forkLength = 0.0;
        const auto ledge = buildBranchMesh(twins(radius, lean), options);
        QVERIFY(ledge);
        QVERIFY(sectionArea(ledge->mesh, 2.1) < sectionArea(built->mesh, 2.1));
    }
};

RAMURE_SUITE(TestForkSpread)

} // namespace tst_fork_spread

#include "tst_fork_spread.moc"
