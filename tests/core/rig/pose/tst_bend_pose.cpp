#include "core/math/random.h"
#include "core/rig/pose/bend_pose.h"
#include "core/skeleton/bend.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"

namespace tst_bend_pose {

using namespace ramure;

/// A pose in the place of a mesh that is still to be made: it shows the same tree.
class TestBendPose : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void branchesComeWhereTheirBendsPutThem();
    void whatIsNotTurnedStaysToTheBit();
};

void TestBendPose::branchesComeWhereTheirBendsPutThem()
{
    const Skeleton rest = test::presetSkeleton({"SmallTree"}).value_or(Skeleton{});
    QVERIFY(rest.size() > 100);
    Random random(7, RandomStream::Test);
    std::vector<glm::dvec3> from(rest.size(), glm::dvec3(0.0)), to = from;
    for (Index b = 0; b < rest.size(); b += 3) {
        from[b] = {random.range(-0.5, 0.5), random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
        to[b / 2] = {random.range(-0.5, 0.5), random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
    }
    Skeleton before = rest, after = rest;
    bendBranches(before, from);
    bendBranches(after, to);
    const std::vector<RigidTransform> bones = bendPose(before, from, to);
    QCOMPARE(bones.size(), std::size_t(rest.size()));
    for (Index b = 0; b < rest.size(); ++b) {
        QVERIFY(glm::distance(bones[b].point(before.p0[b]), after.p0[b]) < 1e-9);
        QVERIFY(glm::distance(bones[b].point(before.p1[b]), after.p1[b]) < 1e-9);
    }
}

void TestBendPose::whatIsNotTurnedStaysToTheBit()
{
    const Skeleton tree = test::presetSkeleton({"TinyTree"}).value_or(Skeleton{});
    const std::vector<glm::dvec3> none(tree.size(), glm::dvec3(0.0));
    std::vector<glm::dvec3> last = none;
    last.back() = {0.3, 0.0, 0.1};
    const std::vector<RigidTransform> bones = bendPose(tree, none, last);
    for (Index b = 0; b + 1 < tree.size(); ++b)
        QVERIFY(bones[b] == RigidTransform());
    QVERIFY(bones.back() != RigidTransform());
}

RAMURE_SUITE(TestBendPose)

} // namespace tst_bend_pose

#include "tst_bend_pose.moc"
