#include "core/math/random.h"
#include "core/rig/physics/apple_fall.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_apple_fall {

using namespace ramure;

namespace {

LooseApple appleAt(double y, const glm::dvec3& velocity = glm::dvec3(0.0))
{
    LooseApple apple;
    apple.position = {0.0, y, 0.0};
    apple.velocity = velocity;
    return apple;
}

double energy(const LooseApple& apple, double gravity)
{
    return 0.5 * glm::dot(apple.velocity, apple.velocity) + gravity * apple.position.y;
}

} // namespace

class TestAppleFall : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void belowTheGroundItIsLifted()
    {
        LooseApple apple = appleAt(-3.0);
        stepLooseApple(apple, {}, 0.1, 0.01);
        QCOMPARE(apple.position.y, 0.1);
    }

    void fallsAsGalileoSays()
    {
        LooseApple apple = appleAt(10.0, {1.0, 2.0, 0.0});
        for (int k = 0; k < 100; ++k)
            stepLooseApple(apple, {}, 0.1, 0.01);
        QVERIFY(std::abs(apple.position.y - (10.0 + 2.0 - 0.5 * earthGravity)) < 1e-12);
        QVERIFY(std::abs(apple.position.x - 1.0) < 1e-12);
        QVERIFY(std::abs(apple.velocity.y - (2.0 - earthGravity)) < 1e-12);
    }

    void bouncesTheHeightsOfItsBounce()
    {
        PhysicsParams params;
        params.appleBounce = 0.5;
        LooseApple apple = appleAt(2.1);
        double top = 0.0, last = apple.position.y;
        bool wasDown = false;
        for (int k = 0; k < 100; ++k) {
            stepLooseApple(apple, params, 0.1, 0.01);
            if (apple.position.y > last && !wasDown)
                wasDown = true;
            if (wasDown)
                top = std::max(top, apple.position.y);
            last = apple.position.y;
        }
        QVERIFY2(std::abs(top - 0.1 - 2.0 * 0.25) < 1e-3, QByteArray::number(top));
    }

    void stepsOfAnyLengthMeetTheGroundAtOneTime()
    {
        const auto after = [](double seconds) {
            LooseApple apple = appleAt(3.0, {0.5, 0.0, 0.0});
            PhysicsParams params;
            params.appleBounce = 0.9;
            for (int k = 0; k < std::lround(1.5 / seconds); ++k)
                stepLooseApple(apple, params, 0.1, seconds);
            return apple.position;
        };
        QVERIFY(glm::length(after(0.05) - after(0.001)) < 1e-9);
    }

    void comesToRestAndStays()
    {
        LooseApple apple = appleAt(3.0, {2.0, 0.0, -1.0});
        for (int k = 0; k < 3000; ++k)
            stepLooseApple(apple, {}, 0.1, 0.01);
        QVERIFY(apple.resting);
        QVERIFY(apple.velocity == glm::dvec3(0.0) && apple.spin == glm::dvec3(0.0));
        const LooseApple before = apple;
        stepLooseApple(apple, {}, 0.1, 0.01);
        QVERIFY(apple == before);
        PhysicsParams weightless;
        weightless.gravity = 0.0;
        stepLooseApple(apple, weightless, 0.1, 0.01);
        QVERIFY(!apple.resting); // nothing holds it down
    }

    void rollingAppleTurnsWithItsWay()
    {
        PhysicsParams params;
        params.appleFriction = 0.0;
        LooseApple apple = appleAt(0.1, {1.0, 0.0, 0.0});
        for (int k = 0; k < 100; ++k)
            stepLooseApple(apple, params, 0.1, 0.01);
        QVERIFY(std::abs(apple.position.x - 1.0) < 1e-9); // without friction it never stops
        QVERIFY(glm::length(apple.spin - glm::dvec3(0.0, 0.0, -10.0)) < 1e-9);
    }

    void energyNeverGrows()
    {
        Random random(7, RandomStream::Test);
        for (int run = 0; run < 500; ++run) {
            PhysicsParams params;
            params.gravity = run % 5 == 0 ? 0.0 : std::pow(10.0, random.range(-2.0, 2.0));
            params.appleBounce = random.range(0.0, 0.95);
            params.appleFriction = random.range(0.0, 10.0);
            const double seconds = std::pow(10.0, random.range(-4.0, -1.0));
            LooseApple apple = appleAt(random.range(0.1, 20.0),
                                       {random.range(-9, 9), random.range(-9, 9), random.range(-9, 9)});
            const double gravity = earthGravity * params.gravity;
            double before = energy(apple, gravity);
            for (int k = 0; k < 600; ++k) {
                stepLooseApple(apple, params, 0.1, seconds);
                const double now = energy(apple, gravity);
                QVERIFY2(now <= before * (1.0 + 1e-12) + 1e-12, QByteArray::number(now - before));
                QVERIFY(apple.position.y >= 0.1 - 1e-12);
                QVERIFY(std::abs(glm::length(apple.orientation) - 1.0) < 1e-12);
                before = now;
            }
        }
    }
};

RAMURE_SUITE(TestAppleFall)

} // namespace tst_apple_fall

#include "tst_apple_fall.moc"
