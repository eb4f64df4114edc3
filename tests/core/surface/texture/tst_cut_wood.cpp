#include "core/evaluate/tree_run.h"
#include "core/surface/texture/cut_wood.h"
#include "tests/support/shaped_tree.h"
#include <cmath>

namespace tst_cut_wood {

using namespace ramure;
using namespace ramure::test;

/// The wood that a cut lays open.
class TestCutWood : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }

    void whereNothingWasCutThereIsNone()
    {
        const Shaped shaped;
        const TreeResult tree = shaped.tree(Stage::Mesh);
        QVERIFY(!tree.cuts);
        QVERIFY(cutWood(*tree.branches, tree.simplified->skeleton).empty());
        QVERIFY(cutWood(BranchMesh(), Skeleton()).empty());
    }

    /// One on a stump, and one more at the foot of what falls.
    void liesOnTheFlatEnds_data()
    {
        QTest::addColumn<bool>("falls");
        QTest::newRow("what is cut goes") << false;
        QTest::newRow("what is cut falls") << true;
    }
    void liesOnTheFlatEnds()
    {
        QFETCH(bool, falls);
        Shaped shaped;
        TreeEdit edit = editOf(EditOperation::Thickness, shaped.address[0]);
        edit.factor = 0.1;
        edit.below = true;
        QVERIFY(shaped.make(edit));
        edit = editOf(EditOperation::Cut, shaped.address[3]);
        edit.at = 0.5;
        edit.falls = falls;
        QVERIFY(shaped.make(edit));
        const TreeResult tree = shaped.tree(Stage::Foliage);
        QVERIFY(tree.cuts);
        const Skeleton& skeleton = tree.simplified->skeleton;
        const Index stump = skeleton.sawn.front();
        const glm::dvec3 way = glm::normalize(skeleton.p1[stump] - skeleton.p0[stump]);
        const double radius = skeleton.a1[stump];
        for (std::size_t v = 0; v < tree.cuts->positions.size(); ++v) {
            const bool isStump = tree.cuts->branch[v] == stump;
            QVERIFY(isStump || tree.cuts->branch[v] == skeleton.loose.front().first);
            const glm::dvec3 end = isStump ? skeleton.p1[stump] : skeleton.p0[skeleton.loose.front().first];
            const glm::dvec3 from = glm::dvec3(tree.cuts->positions[v]) - end;
            QVERIFY(glm::length(from) < 0.95 * radius); // bark stands around it
            QVERIFY(std::abs(glm::dot(from, way)) < 0.1 * radius);
            QVERIFY(glm::dot(glm::dvec3(tree.cuts->normals[v]), isStump ? way : -way) > 0.95);
        }
        // Seen from outside, and more than a dot.
        double area = 0.0;
        for (const glm::uvec3& t : tree.cuts->triangles) {
            const glm::dvec3 a(tree.cuts->positions[t.x]), b(tree.cuts->positions[t.y]),
                c(tree.cuts->positions[t.z]);
            const glm::dvec3 normal(tree.cuts->normals[t.x]);
            const double own = 0.5 * glm::dot(glm::cross(b - a, c - a), normal);
            QVERIFY(own > 0.0);
            area += own;
        }
        const double ends = falls ? 2.0 : 1.0;
        QVERIFY(area > 0.5 * ends * 3.14 * radius * radius && area < ends * 3.15 * radius * radius);
        QCOMPARE(tree.cuts->colours.size(), tree.cuts->triangles.size());
        // It goes with its branch.
        TreeRun run;
        QVERIFY(run.setTree(tree, shaped.params));
        run.setPhysics(shaped.params.physics, {}, 0.0);
        const auto motion = run.motionAt(0.3, {}, {});
        QVERIFY2(motion, why(motion).constData());
        const auto moved = movedTree(tree, *motion, {});
        QVERIFY2(moved, why(moved).constData());
        for (std::size_t v = 0; v < tree.cuts->positions.size(); ++v) {
            const RigidTransform& bone = (*motion->bones)[tree.cuts->branch[v]];
            const glm::dvec3 there = bone.point(glm::dvec3(tree.cuts->positions[v]));
            QVERIFY(glm::distance(there, glm::dvec3(moved->cuts->positions[v])) < 1e-5);
        }
    }
};

RAMURE_SUITE(TestCutWood)

} // namespace tst_cut_wood

#include "tst_cut_wood.moc"
