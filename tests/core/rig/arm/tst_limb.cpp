#include "core/math/random.h"
#include "core/rig/arm/limb.h"
#include "core/skeleton/bend.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <limits>

namespace tst_limb {

using namespace ramure;
using namespace ramure::test;

class TestLimb : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void targetsThatAreNoNumbersChangeNothing();
    void theTreeFollowsTheHand();
    void bendsThatAreThereStay();
    void thinBranchesGiveWayFirst();
    void onlyTheChainTurns();
    void outOfReachItStretches();
    void theWayThereDoesNotCount();
    void noBranchTurnsBeyondItsStop();
    void theRootAndWhatIsThickAreNoLimb();
};

namespace {

/// The simplified SmallTree without bends.
const Skeleton& smallTree()
{
    static const Skeleton tree = presetSkeleton({"SmallTree"}).value_or(Skeleton{});
    return tree;
}

/// A branch without children far from the root.
Index twig(const Skeleton& skeleton)
{
    Index found = 0;
    std::size_t deepest = 0;
    for (Index b = 0; b < skeleton.size(); ++b) {
        std::size_t depth = 0;
        for (Index at = b; at != noIndex; at = skeleton.parent[at])
            ++depth;
        if (depth > deepest) {
            deepest = depth;
            found = b;
        }
    }
    return found;
}

Skeleton bent(const Skeleton& rest, const Limb::Bends& bends)
{
    std::vector<glm::dvec3> all(rest.size(), glm::dvec3(0.0));
    for (Index b = 0; b < rest.size(); ++b)
        if (const auto found = bends.find(rest.key[b]); found != bends.end())
            all[b] = found->second;
    Skeleton skeleton = rest;
    bendBranches(skeleton, all);
    return skeleton;
}

} // namespace

void TestLimb::targetsThatAreNoNumbersChangeNothing()
{
    const Skeleton& tree = smallTree();
    QVERIFY(tree.size() > 10);
    Limb limb(tree, {}, twig(tree), {});
    const glm::dvec3 before = limb.tip();
    QCOMPARE(limb.pullTo({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}), 0.0);
    QCOMPARE(limb.tip(), before);
    Limb none(tree, {}, 0, {0, 2.0});
    QCOMPARE(none.branchCount(), std::size_t(0));
    QCOMPARE(none.tip(), tree.p1[0]);
    QCOMPARE(none.pullTo(tree.p1[0] + glm::dvec3(0.0, 2.0, 0.0)), 2.0);
    QVERIFY(none.bends().empty());
    QCOMPARE(Limb(tree, {}, 0, {1000, 2.0}).branchCount(), std::size_t(1));
}

void TestLimb::theTreeFollowsTheHand()
{
    const Skeleton& tree = smallTree();
    const Index branch = twig(tree);
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 50; ++i) {
        Limb limb(tree, {}, branch, {6, 2.0});
        const glm::dvec3 by(random.range(-0.2, 0.2), random.range(-0.2, 0.2), random.range(-0.2, 0.2));
        const glm::dvec3 target = tree.p1[branch] + by;
        QVERIFY(limb.pullTo(target) < 1e-5);
        const Skeleton now = bent(tree, limb.bends());
        QVERIFY(glm::distance(now.p1[branch], limb.tip()) < 1e-9);
        for (Index b = 0; b < tree.size(); ++b)
            QVERIFY(std::abs(now.length(b) - tree.length(b)) < 1e-9);
    }
}

void TestLimb::bendsThatAreThereStay()
{
    const Skeleton& rest = smallTree();
    const Index branch = twig(rest);
    Limb::Bends before;
    Random random(2, RandomStream::Test);
    for (Index b = branch; b != noIndex; b = rest.parent[b])
        before[rest.key[b]] = {random.range(-0.3, 0.3), random.range(-0.3, 0.3), random.range(-0.3, 0.3)};
    const Skeleton tree = bent(rest, before);
    Limb limb(tree, before, branch, {4, 2.0});
    QVERIFY(glm::distance(limb.tip(), tree.p1[branch]) < 1e-9);
    for (const auto& [key, bend] : limb.bends())
        QVERIFY(glm::distance(bend, before[key]) < 1e-9);
    const glm::dvec3 target = tree.p1[branch] + glm::dvec3(0.05, -0.1, 0.08);
    QVERIFY(limb.pullTo(target) < 1e-5);
    Limb::Bends after = before;
    for (const auto& [key, bend] : limb.bends())
        after[key] = bend;
    QVERIFY(glm::distance(bent(rest, after).p1[branch], target) < 1e-5);
}

void TestLimb::thinBranchesGiveWayFirst()
{
    Skeleton tree;
    Index last = noIndex;
    for (int i = 0; i < 6; ++i)
        last = tree.add(last, {0.0, i, 0.0}, {0.0, i + 1, 0.0}, 0.5 - 0.08 * i, 0.5 - 0.08 * (i + 1));
    for (Index b = 0; b < tree.size(); ++b)
        tree.key[b] = b + 1;
    Limb limb(tree, {}, last, {6, 3.0});
    QVERIFY(limb.pullTo({1.0, 5.5, 0.0}) < 1e-5);
    const Limb::Bends bends = limb.bends();
    QVERIFY(glm::length(bends.at(6)) > 2.0 * glm::length(bends.at(1)));
    QVERIFY(glm::length(bends.at(4)) > glm::length(bends.at(2)));
}

void TestLimb::onlyTheChainTurns()
{
    const Skeleton& tree = smallTree();
    const Index branch = twig(tree);
    Limb limb(tree, {}, branch, {3, 2.0});
    QCOMPARE(limb.branchCount(), std::size_t(3));
    limb.pullTo(tree.p1[branch] + glm::dvec3(0.1, 0.0, 0.0));
    const Limb::Bends bends = limb.bends();
    QCOMPARE(bends.size(), std::size_t(3));
    Index at = branch;
    for (int i = 0; i < 3; ++i, at = tree.parent[at])
        QVERIFY(bends.contains(tree.key[at]));
}

void TestLimb::outOfReachItStretches()
{
    const Skeleton& tree = smallTree();
    const Index branch = twig(tree);
    Limb limb(tree, {}, branch, {5, 2.0});
    for (const double far : {10.0, 1e3, 1e9}) {
        const glm::dvec3 target(far, 2.0, -far);
        const double missing = limb.pullTo(target);
        QVERIFY(std::isfinite(missing) && missing > 0.9 * far);
        for (const auto& [key, bend] : limb.bends())
            QVERIFY(glm::length(bend) < 3.2);
    }
}

void TestLimb::theWayThereDoesNotCount()
{
    const Skeleton& tree = smallTree();
    const Index branch = twig(tree);
    const glm::dvec3 target = tree.p1[branch] + glm::dvec3(0.1, 0.1, 0.0);
    Limb direct(tree, {}, branch, {}), round(tree, {}, branch, {});
    for (int i = 0; i < 30; ++i)
        round.pullTo(target + glm::dvec3(0.3 * std::cos(i), 0.0, 0.3 * std::sin(i)));
    direct.pullTo(target);
    round.pullTo(target);
    QVERIFY(direct.bends() == round.bends());
}

void TestLimb::noBranchTurnsBeyondItsStop()
{
    const Skeleton& rest = smallTree();
    const Index branch = twig(rest);
    Limb::Bends before;
    for (Index b = branch; b != noIndex; b = rest.parent[b])
        before[rest.key[b]] = {0.2, -0.1, 0.3};
    const Skeleton tree = bent(rest, before);
    const double most = LimbOptions().mostTurnRad;
    Random random(3, RandomStream::Test);
    for (int i = 0; i < 40; ++i) {
        Limb limb(tree, before, branch, {5, 2.0});
        const double reach = random.range(0.0, 3.0);
        limb.pullTo(tree.p1[branch] + reach * glm::dvec3(random.range(-1.0, 1.0), random.range(-1.0, 1.0),
                                                         random.range(-1.0, 1.0)));
        for (const auto& [key, bend] : limb.bends()) {
            const glm::dquat turn = bendRotation(bend) * glm::conjugate(bendRotation(before.at(key)));
            QVERIFY(glm::length(bendVector(turn)) < most + 1e-6);
        }
    }
    // At their stops the others go on: a fold that needs more than two links.
    Skeleton rod;
    Index last = noIndex;
    for (int i = 0; i < 6; ++i)
        last = rod.add(last, {0.0, i, 0.0}, {0.0, i + 1, 0.0}, 0.1, 0.1);
    for (Index b = 0; b < rod.size(); ++b)
        rod.key[b] = b + 1;
    Limb limb(rod, {}, last, {6, 2.0});
    const double missing = limb.pullTo({2.0, 0.5, 0.0});
    QVERIFY2(missing < 1e-4, qPrintable(QString::number(missing)));
}

void TestLimb::theRootAndWhatIsThickAreNoLimb()
{
    Skeleton tree;
    Index last = noIndex;
    for (const double radius : {0.5, 0.5, 0.19, 0.15, 0.1})
        last = tree.add(last, {0.0, tree.size(), 0.0}, {0.0, tree.size() + 1, 0.0}, radius, radius);
    QCOMPARE(limbLength(tree, 4), std::size_t(3)); // up to the thick trunk
    QCOMPARE(limbLength(tree, 2), std::size_t(1));
    QCOMPARE(limbLength(tree, 1), std::size_t(1)); // of the trunk itself all but the root
    QCOMPARE(limbLength(tree, 0), std::size_t(0));
}

RAMURE_SUITE(TestLimb)

} // namespace tst_limb

#include "tst_limb.moc"
