#include "core/math/random.h"
#include "core/rig/pose/pose.h"
#include "tests/support/suite.h"

namespace tst_pose {

using namespace ramure;

namespace {

RigidTransform randomTransform(Random& random)
{
    const auto number = [&] { return random.range(-2.0, 2.0); };
    return {glm::normalize(glm::dquat(number(), number(), number(), number() + 0.01)),
            {number(), number(), number()}};
}

double distance(const RigidTransform& a, const RigidTransform& b)
{
    const glm::dvec3 points[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double worst = 0.0;
    for (const glm::dvec3& x : points)
        worst = std::max(worst, glm::length(a.point(x) - b.point(x)));
    return worst;
}

} // namespace

class TestPose : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void restIsTheIdentity() { QVERIFY(RigidTransform().point({1, 2, 3}) == glm::dvec3(1, 2, 3)); }

    void productsInversesAndMatricesAgree()
    {
        Random random(1, RandomStream::Test);
        for (int i = 0; i < 200; ++i) {
            const RigidTransform a = randomTransform(random), b = randomTransform(random);
            const glm::dvec3 x(random.range(-3, 3), random.range(-3, 3), random.range(-3, 3));
            QVERIFY(glm::length((a * b).point(x) - a.point(b.point(x))) < 1e-14);
            QVERIFY(distance(a * a.inverse(), {}) < 1e-14);
            QVERIFY(distance(a.inverse() * a, {}) < 1e-14);
            QVERIFY(glm::length(glm::dvec3(a.matrix() * glm::dvec4(x, 1.0)) - a.point(x)) < 1e-14);
            QVERIFY(glm::length(glm::dvec3(a.matrix() * glm::dvec4(x, 0.0)) - a.direction(x)) < 1e-14);
            const RigidTransform about = turnAbout(x, a.rotation);
            QVERIFY(glm::length(about.point(x) - x) < 1e-14);
            QVERIFY(glm::length(about.direction(x) - a.rotation * x) < 1e-14);
        }
    }
};

RAMURE_SUITE(TestPose)

} // namespace tst_pose

#include "tst_pose.moc"
