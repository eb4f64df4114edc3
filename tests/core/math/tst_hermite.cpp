#include "core/math/hermite.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace tst_hermite {

using namespace ramure;

namespace {

glm::dvec3 randomVector(Random& random, double size)
{
    return {random.range(-size, size), random.range(-size, size), random.range(-size, size)};
}

/// The polynomial of the definition.
glm::dvec3 polynomial(const glm::dvec3& h0, const glm::dvec3& h1, const glm::dvec3& v0, const glm::dvec3& v1,
                      double t)
{
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * h0 + (t3 - 2 * t2 + t) * v0 + (3 * t2 - 2 * t3) * h1 + (t3 - t2) * v1;
}

bool isUnit(const glm::dvec3& v)
{
    return std::abs(glm::length(v) - 1.0) < 1e-12;
}

const glm::dvec3 zero(0.0);
const glm::dvec3 xAxis(1, 0, 0), yAxis(0, 1, 0);

} // namespace

class TestHermite : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void curveOfOnePoint();
    void vanishingDerivatives();
    void cuspInside();
    void endsAreExact();
    void pointsLieOnThePolynomial();
    void tangentIsTheDerivative();
    void straightCurve();
    void farFromTheOrigin();
};

void TestHermite::curveOfOnePoint()
{
    for (const double t : {0.0, 0.3, 1.0}) {
        const CurvePoint at = hermite(xAxis, xAxis, zero, zero, t);
        QVERIFY(glm::length(at.point - xAxis) < 1e-15);
        QVERIFY(at.tangent == yAxis);
    }
}

void TestHermite::vanishingDerivatives()
{
    // Without end derivatives the curve is straight; its tangent is that everywhere.
    for (const double t : {0.0, 1e-9, 0.5, 1 - 1e-9, 1.0})
        QVERIFY(glm::length(hermite(zero, xAxis, zero, zero, t).tangent - xAxis) < 1e-12);
    // Only one end stands still: the tangent there is the limit.
    const glm::dvec3 v(0.2, 0.9, -0.4);
    const glm::dvec3 atStart = hermite(zero, xAxis, zero, v, 0.0).tangent;
    QVERIFY(glm::length(atStart - hermite(zero, xAxis, zero, v, 1e-8).tangent) < 1e-7);
    const glm::dvec3 atEnd = hermite(zero, xAxis, v, zero, 1.0).tangent;
    QVERIFY(glm::length(atEnd - hermite(zero, xAxis, v, zero, 1 - 1e-8).tangent) < 1e-7);
    // Both the first and the second derivative vanish at the start: v0 = 0 and v1 = 3 (h1 - h0).
    QVERIFY(glm::length(hermite(zero, xAxis, zero, 3.0 * xAxis, 0.0).tangent - xAxis) < 1e-12);
}

void TestHermite::cuspInside()
{
    // There and back along x, with a turning point at one half.
    const CurvePoint at = hermite(zero, zero, xAxis, -xAxis, 0.5);
    QVERIFY(isUnit(at.tangent));
    QVERIFY(glm::length(at.tangent + xAxis) < 1e-12);
}

void TestHermite::endsAreExact()
{
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 10'000; ++i) {
        const double size = std::pow(10.0, random.range(-3, 3));
        const glm::dvec3 h0 = randomVector(random, size), h1 = randomVector(random, size);
        const glm::dvec3 v0 = randomVector(random, size), v1 = randomVector(random, size);
        const CurvePoint start = hermite(h0, h1, v0, v1, 0.0), end = hermite(h0, h1, v0, v1, 1.0);
        QVERIFY(start.point == h0 && end.point == h1);
        QVERIFY(glm::length(start.tangent - glm::normalize(v0)) < 1e-12);
        QVERIFY(glm::length(end.tangent - glm::normalize(v1)) < 1e-12);
    }
}

void TestHermite::pointsLieOnThePolynomial()
{
    Random random(2, RandomStream::Test);
    for (int i = 0; i < 10'000; ++i) {
        const glm::dvec3 h0 = randomVector(random, 1), h1 = randomVector(random, 1);
        const glm::dvec3 v0 = randomVector(random, 3), v1 = randomVector(random, 3);
        const double t = random.unit();
        QVERIFY(glm::length(hermite(h0, h1, v0, v1, t).point - polynomial(h0, h1, v0, v1, t)) < 1e-12);
    }
}

void TestHermite::tangentIsTheDerivative()
{
    Random random(3, RandomStream::Test);
    for (int i = 0; i < 2'000; ++i) {
        const glm::dvec3 h0 = randomVector(random, 1), h1 = randomVector(random, 1);
        const glm::dvec3 v0 = randomVector(random, 1), v1 = randomVector(random, 1);
        const double t = random.range(0.01, 0.99), d = 1e-5;
        const glm::dvec3 slope = polynomial(h0, h1, v0, v1, t + d) - polynomial(h0, h1, v0, v1, t - d);
        if (glm::length(slope) < 1e-6)
            continue;
        QVERIFY(glm::length(hermite(h0, h1, v0, v1, t).tangent - glm::normalize(slope)) < 1e-6);
    }
}

void TestHermite::straightCurve()
{
    for (int k = 0; k <= 10; ++k) {
        const CurvePoint at = hermite(zero, 2.0 * yAxis, 2.0 * yAxis, 2.0 * yAxis, k / 10.0);
        QVERIFY(glm::length(at.point - 0.2 * k * yAxis) < 1e-15);
        QVERIFY(glm::length(at.tangent - yAxis) < 1e-15);
    }
}

void TestHermite::farFromTheOrigin()
{
    const glm::dvec3 far(1e6, -1e6, 1e6), v0(1e-3, 0, 0), v1(0, 1e-3, 0);
    const CurvePoint start = hermite(far, far + v0 + v1, v0, v1, 0.0);
    QVERIFY(start.point == far);
    QVERIFY(glm::length(start.tangent - xAxis) < 1e-12);
}

RAMURE_SUITE(TestHermite)

} // namespace tst_hermite

#include "tst_hermite.moc"
