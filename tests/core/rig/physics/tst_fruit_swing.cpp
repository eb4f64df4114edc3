#include "core/rig/physics/fruit_swing.h"

#include "core/math/random.h"
#include "tests/support/suite.h"
#include <numbers>

namespace tst_fruit_swing {

using namespace ramure;

namespace {

constexpr glm::dvec3 down{0.0, -1.0, 0.0};

RigidTransform turnedBy(double angle, const glm::dvec3& axis)
{
    return {glm::angleAxis(angle, glm::normalize(axis)), {0.3, -0.2, 0.1}};
}

} // namespace

class TestFruitSwing : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void faithfulFruitAndFlowersStayAsTheyAre()
    {
        Foliage foliage;
        foliage.apples.resize(3);
        for (const FruitKind kind : {FruitKind::Faithful, FruitKind::Blossom}) {
            foliage.fruit.kind = kind;
            const FruitSwing swing(foliage, 0.2);
            QCOMPARE(swing.reach(), 0.0);
            std::vector<RigidTransform> bones(3, turnedBy(1.0, {1, 2, 3}));
            const std::vector<RigidTransform> before = bones;
            swing.pose({}, bones);
            QVERIFY(bones == before);
        }
    }
    void atRestNothingTurns()
    {
        const RigidTransform rest;
        QVERIFY(hungFruit(rest, {1.0, 2.0, 3.0}, glm::dvec3(0.0)) == rest);
    }
    void theFootStaysAndTheFruitHangs()
    {
        Random random(3, RandomStream::Test);
        for (int i = 0; i < 500; ++i) {
            const double angle = random.range(-2.0, 2.0);
            const RigidTransform branch =
                turnedBy(angle, {random.range(-1, 1), random.range(-1, 1), random.range(-1, 1) + 2.0});
            const glm::dvec3 foot(random.range(-3, 3), random.range(0, 9), random.range(-3, 3));
            const RigidTransform hung = hungFruit(branch, foot, glm::dvec3(0.0));
            QVERIFY(glm::length(hung.point(foot) - branch.point(foot)) < 1e-12);
            QVERIFY(std::abs(glm::length(hung.rotation) - 1.0) < 1e-12);
            const double before = glm::dot(branch.direction(down), down);
            const double after = glm::dot(hung.direction(down), down);
            QVERIFY(after >= before - 1e-12);
            if (before > 0.0)
                QVERIFY(after > 0.97);
        }
    }
    void itStaysBehindWhenItsTwigMoves()
    {
        double last = 0.0;
        for (const double speed : {0.5, 2.0, 8.0, 1e6}) {
            const RigidTransform hung = hungFruit({}, {0, 1, 0}, {speed, 0.0, 0.0});
            const double behind = -hung.direction(down).x;
            QVERIFY(behind > last);
            QVERIFY(behind < 0.75);
            last = behind;
        }
    }
    void headOverItHasNoWay()
    {
        const RigidTransform over = turnedBy(std::numbers::pi, {1, 0, 0});
        QVERIFY(hungFruit(over, {0, 1, 0}, glm::dvec3(0.0)) == over);
    }
    void itIsCarriedAsFastAsItsBranch()
    {
        Foliage foliage;
        foliage.fruit.kind = FruitKind::Apple;
        foliage.apples.resize(2);
        foliage.apples[1].size = 2.0F;
        foliage.apples[1].position = {1, 0, 0};
        const FruitSwing swing(foliage, 0.2);
        QVERIFY(swing.reach() > 0.0);
        std::vector<RigidTransform> bones(2);
        swing.pose(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}}, bones);
        QVERIFY(bones[0] == RigidTransform());
        const glm::dvec3 foot = glm::dvec3(1.0, swing.reach(), 0.0); // the larger one's
        QVERIFY(glm::length(bones[1].point(foot) - foot) < 1e-12);
        QVERIFY(bones[1].point({1, 0, 0}).x < 1.0);
    }
};

RAMURE_SUITE(TestFruitSwing)

} // namespace tst_fruit_swing

#include "tst_fruit_swing.moc"
