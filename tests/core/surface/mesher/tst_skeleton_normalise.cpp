#include "core/surface/mesher/skeleton_normalise.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_skeleton_normalise {

using namespace ramure;
using namespace ramure::test;

/// The mesher's own copy of a skeleton: nothing without length, no two siblings in one place.
class TestSkeletonNormalise : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void goodSkeletonsStayAsTheyAre();
    void chainOfTinyBranchesGathersLength();
    void coincidentSiblingsBecomeOne();
    void mergedSiblingsKeepAllChildren();
    void sameDirectionBecomesAChain_data();
    void sameDirectionBecomesAChain();
    void rollsOfContractedBranchesGoOn();
    void childrenFollowAMergedParent();
    void limbsShowWhereTheyLeaveTheirStem();
    void rootsAreCounted();
    void stemsFromOnePlaceStandOnAPlate();
    void farSkeletonsAreBroughtNear();
    void fernHasItsTwins();
    void invariantsOfTheZoo();
};

namespace {

Skeleton stem()
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    return s;
}

NormalSkeleton normal(const Skeleton& s, const BranchMeshOptions& options = {})
{
    Expected<NormalSkeleton> result = normaliseSkeleton(s, options, {});
    return result ? std::move(*result) : NormalSkeleton();
}

std::size_t count(const NormalSkeleton& n, SkeletonRepair kind)
{
    return static_cast<std::size_t>(std::count_if(n.repairs.begin(), n.repairs.end(),
                                                  [&](const RepairNote& note) { return note.kind == kind; }));
}

/// At the parent's end, or as a limb in the wood of a thicker sibling.
bool startsInItsFork(const NormalSkeleton& n, const MeshBranch& branch)
{
    const glm::dvec3& fork = n.branches[branch.parent].p1;
    const auto holds = [&](Index other) {
        const glm::dvec3 way = n.branches[other].p1 - fork, away = branch.p0 - fork;
        return branch.isLimb && n.branches[other].a0 >= 2.0 * branch.a0 &&
               glm::length(away) <= 2.001 * n.branches[other].a0 &&
               glm::length(glm::cross(away, way)) <= 1e-9 * n.scene * glm::length(way);
    };
    return branch.p0 == fork || std::ranges::any_of(n.childrenOf(branch.parent), holds);
}

} // namespace

void TestSkeletonNormalise::goodSkeletonsStayAsTheyAre()
{
    const Expected<Skeleton> tree = presetSkeleton({"SmallTree"});
    QVERIFY2(tree, why(tree));
    const NormalSkeleton n = normal(*tree);
    QCOMPARE(n.branches.size(), std::size_t(tree->size()));
    QVERIFY(n.repairs.empty());
    QCOMPARE(n.origin, glm::dvec3(0.0));
    for (const MeshBranch& branch : n.branches) {
        QCOMPARE(branch.p1, tree->p1[branch.source]);
        QCOMPARE(branch.a0, tree->a0[branch.source]);
        const Index parent = tree->parent[branch.source];
        QCOMPARE(branch.parent == noIndex ? noIndex : n.branches[branch.parent].source, parent);
    }
}

void TestSkeletonNormalise::chainOfTinyBranchesGathersLength()
{
    Skeleton s = stem();
    for (Index i = 0; i < 50000; ++i) // each far below a millionth of the scene
        s.add(i, s.p1[i], s.p1[i] + glm::dvec3(3e-8, 0, 0), 1e-4, 1e-4);
    const NormalSkeleton n = normal(s);
    QVERIFY(count(n, SkeletonRepair::ZeroLengthContracted) > 45000);
    QVERIFY(n.branches.size() > 10 && n.branches.size() < 5000);
    for (const MeshBranch& branch : n.branches)
        QVERIFY(glm::length(branch.p1 - branch.p0) > 1e-6);
}

void TestSkeletonNormalise::coincidentSiblingsBecomeOne()
{
    Skeleton s = stem();
    for (int i = 0; i < 5; ++i)
        s.add(0, {0, 1, 0}, {0.5, 2, 0}, 0.1 + 0.01 * i, 0.05);
    BranchMeshOptions options;
    options.nearTwinRatio = 0.0; // exact ones are joined all the same
    const NormalSkeleton n = normal(s, options);
    QCOMPARE(n.branches.size(), std::size_t(2));
    QCOMPARE(count(n, SkeletonRepair::SiblingsMerged), std::size_t(4));
    QCOMPARE(n.branches[1].source, Index(1));
    QCOMPARE(n.branches[1].a0, 0.14); // the thickest
}

void TestSkeletonNormalise::mergedSiblingsKeepAllChildren()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0, 2, 0}, 0.1, 0.1);
    s.add(0, {0, 1, 0}, {0, 2, 0}, 0.1, 0.1);
    s.add(1, {0, 2, 0}, {1, 3, 0}, 0.1, 0.1);
    s.add(2, {0, 2, 0}, {-1, 3, 0}, 0.1, 0.1);
    s.add(2, {0, 2, 0}, {0, 3, 1}, 0.1, 0.1);
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.branches.size(), std::size_t(5));
    QCOMPARE(n.branches[1].childCount, Index(3));
}

void TestSkeletonNormalise::sameDirectionBecomesAChain_data()
{
    QTest::addColumn<std::vector<int>>("lengths");
    QTest::newRow("short first") << std::vector<int>{1, 2, 3};
    QTest::newRow("long first") << std::vector<int>{3, 2, 1};
    QTest::newRow("mixed") << std::vector<int>{2, 5, 1, 4, 3};
}

void TestSkeletonNormalise::sameDirectionBecomesAChain()
{
    QFETCH(std::vector<int>, lengths);
    Skeleton s = stem();
    for (const int length : lengths)
        s.add(0, {0, 1, 0}, {0, 1.0 + length, 0}, 0.1, 0.05);
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.branches.size(), std::size_t(s.size()));
    QVERIFY(count(n, SkeletonRepair::SiblingChained) >= lengths.size() - 1); // some move on more than once
    for (std::size_t i = 1; i < n.branches.size(); ++i) {
        QCOMPARE(n.branches[i].parent, static_cast<Index>(i - 1));
        QCOMPARE(n.branches[i].p0, n.branches[i - 1].p1);
        QCOMPARE(n.branches[i].p1.y, 1.0 + static_cast<double>(i));
    }
}

void TestSkeletonNormalise::rollsOfContractedBranchesGoOn()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0, 1, 0}, 0.1, 0.1);
    s.add(1, {0, 1, 0}, {0, 2, 0}, 0.1, 0.1);
    const std::vector<double> rolls{0.5, 0.25, 0.125};
    BranchMeshOptions options;
    options.rollRad = rolls;
    const NormalSkeleton n = normal(s, options);
    QCOMPARE(n.branches.size(), std::size_t(2));
    QCOMPARE(n.branches[0].rollRad, 0.5);
    QCOMPARE(n.branches[1].rollRad, 0.375);
}

void TestSkeletonNormalise::childrenFollowAMergedParent()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0.00, 2, 0}, 0.1, 0.1);
    s.add(0, {0, 1, 0}, {0.01, 2, 0}, 0.1, 0.1);
    s.add(2, {0.01, 2, 0}, {1, 3, 0}, 0.1, 0.1);
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.branches.size(), std::size_t(3));
    QCOMPARE(n.branches[2].p0, n.branches[1].p1); // of the survivor
}

/// A thin limb whose first branches lie in the trunk's wood, one that leaves it further up, and a trunk that
/// forks again at once: all that shows are limbs of their own on one trunk, none of which starts outside of
/// it.
void TestSkeletonNormalise::limbsShowWhereTheyLeaveTheirStem()
{
    Skeleton s = stem();
    const Index inside = s.add(0, {0, 1, 0}, {0.05, 1, 0}, 0.01, 0.01);
    const Index outside = s.add(inside, {0.05, 1, 0}, {0.6, 1, 0}, 0.01, 0.01);
    const Index shortStem = s.add(0, {0, 1, 0}, {0, 1.005, 0}, 0.1, 0.1);
    const Index next = s.add(shortStem, {0, 1.005, 0}, {0, 2, 0}, 0.1, 0.1);
    const Index along = s.add(shortStem, {0, 1.005, 0}, {-0.2, 3, 0}, 0.01, 0.01);
    const Index top = s.add(next, {0, 2, 0}, {0, 3, 0}, 0.1, 0.05);
    const NormalSkeleton n = normal(s);
    const auto at = [&](Index source) { return std::ranges::find(n.branches, source, &MeshBranch::source); };
    QCOMPARE(n.branches.size(), std::size_t(5));
    QVERIFY(at(inside) == n.branches.end() && at(shortStem) == n.branches.end());
    QCOMPARE(n.branches[at(outside)->parent].source, Index(0));
    QCOMPARE(n.branches[at(next)->parent].source, Index(0));
    QCOMPARE(n.branches[at(along)->parent].source, next);
    QCOMPARE(n.branches[at(top)->parent].source, next);
    for (const MeshBranch& branch : n.branches)
        QVERIFY(glm::length(glm::dvec2(branch.p0.x, branch.p0.z)) < 0.1);
    QVERIFY(at(outside)->isLimb && at(along)->isLimb && !at(next)->isLimb && !at(top)->isLimb);
    QCOMPARE(count(n, SkeletonRepair::ZeroLengthContracted), std::size_t(2));
    QCOMPARE(count(n, SkeletonRepair::SiblingChained), std::size_t(1));
}

void TestSkeletonNormalise::rootsAreCounted()
{
    Skeleton s = stem();
    s.add(noIndex, {3, 0, 0}, {3, 1, 0}, 0.1, 0.1);
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1); // where the first one is: as a twin of it
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.roots, Index(2));
    QCOMPARE(n.branches.size(), std::size_t(2));
}

void TestSkeletonNormalise::stemsFromOnePlaceStandOnAPlate()
{
    Skeleton s = stem();
    s.add(noIndex, {0.15, 0, 0}, {1, 1, 0}, 0.1, 0.1);    // farther away than a radius
    s.add(noIndex, {0.08, 0, 0}, {0.6, -1, 0}, 0.1, 0.1); // near both
    s.add(2, {0.6, -1, 0}, {2, 1, 0}, 0.1, 0.1);
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.roots, Index(1));
    QCOMPARE(n.branches.size(), std::size_t(5));
    const MeshBranch& plate = n.branches[0];
    QVERIFY(plate.isPlate && plate.source == 0 && plate.childCount == 3);
    QCOMPARE(plate.p1, s.p0[0]);
    QVERIFY(std::abs(glm::length(plate.p1 - plate.p0) - 0.05) < 1e-12);
    for (Index i = 0; i < n.branches.size(); ++i)
        QCOMPARE(n.branches[i].isPlate, i == 0);
    QCOMPARE(n.repairs.size(), std::size_t(2));
    QCOMPARE(n.repairs[0].kind, SkeletonRepair::RootsJoined);
}

void TestSkeletonNormalise::farSkeletonsAreBroughtNear()
{
    Skeleton s;
    s.add(noIndex, {1e6, 0, 0}, {1e6, 10, 0}, 0.1, 0.1);
    const NormalSkeleton n = normal(s);
    QCOMPARE(n.origin, glm::dvec3(1e6, 5, 0));
    QCOMPARE(n.branches[0].p0, glm::dvec3(0, -5, 0));
    // a float's step is 1/16 there: rings need radii of several
    QVERIFY(n.branches[0].a0 > 0.5);
    QCOMPARE(count(n, SkeletonRepair::RadiusClamped), std::size_t(1));
}

void TestSkeletonNormalise::fernHasItsTwins()
{
    const Expected<Skeleton> fern = presetSkeleton({"Fern2D"});
    QVERIFY2(fern, why(fern));
    const NormalSkeleton n = normal(*fern);
    QCOMPARE(n.branches.size(), std::size_t(1253)); // 453 of 1706 branches lie in another one
    QCOMPARE(count(n, SkeletonRepair::SiblingsMerged), std::size_t(453));
    const Expected<Skeleton> fan = presetSkeleton({"FanTree"});
    QVERIFY2(fan, why(fan));
    QCOMPARE(count(normal(*fan), SkeletonRepair::SiblingsMerged), std::size_t(512));
}

void TestSkeletonNormalise::invariantsOfTheZoo()
{
    for (std::uint64_t number = 0; number < 40 * zooFamilyCount; ++number) {
        const Specimen animal = specimen(number);
        const Expected<NormalSkeleton> n = normaliseSkeleton(animal.skeleton, animal.options, {});
        QVERIFY2(n, animal.name.c_str());
        Index roots = 0, children = 0;
        for (Index i = 0; i < n->branches.size(); ++i) {
            const MeshBranch& branch = n->branches[i];
            children += branch.childCount;
            roots += branch.parent == noIndex ? 1 : 0;
            QVERIFY2(branch.parent == noIndex || branch.parent < i, animal.name.c_str());
            QVERIFY2(branch.parent == noIndex || startsInItsFork(*n, branch), animal.name.c_str());
            QVERIFY2(glm::length(branch.p1 - branch.p0) > 1e-6 * n->scene, animal.name.c_str());
            QVERIFY2(branch.a0 >= 1e-4 * n->scene && branch.a1 >= 1e-4 * n->scene, animal.name.c_str());
            for (const Index child : n->childrenOf(i))
                QVERIFY2(n->branches[child].parent == i, animal.name.c_str());
        }
        QCOMPARE(roots, n->roots);
        QCOMPARE(children + roots, static_cast<Index>(n->branches.size()));
    }
}

RAMURE_SUITE(TestSkeletonNormalise)

} // namespace tst_skeleton_normalise

#include "tst_skeleton_normalise.moc"
