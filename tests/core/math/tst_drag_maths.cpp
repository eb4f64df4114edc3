#include "core/math/drag_maths.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace tst_drag_maths {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

struct Dice
{
    Random random{2026, RandomStream::Test};
    double number(double low, double high) { return low + (high - low) * random.unit(); }
    glm::dvec3 point() { return {number(-5, 5), number(-5, 5), number(-5, 5)}; }
    glm::dvec3 direction()
    {
        for (;;)
            if (const glm::dvec3 v = point(); glm::length(v) > 0.5)
                return glm::normalize(v);
    }
};

double worst(const glm::dmat3& a, const glm::dmat3& b)
{
    double most = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            most = std::max(most, std::abs(a[c][r] - b[c][r]));
    return most;
}

/// The least of a function, by ever finer steps: knows nothing of lines.
template <class Distance> double searched(Distance distance, double low, double high)
{
    for (int round = 0; round < 12; ++round) {
        double best = low;
        const double step = (high - low) / 200.0;
        for (int i = 0; i <= 200; ++i)
            if (distance(low + i * step) < distance(best))
                best = low + i * step;
        low = best - 2.0 * step;
        high = best + 2.0 * step;
    }
    return 0.5 * (low + high);
}

} // namespace

class TestDragMaths : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatThePictureCannotSayIsNothing()
    {
        const Ray down{{1.0, 5.0, 2.0}, {0.0, -1.0, 0.0}};
        QVERIFY(!alongAxis(down, {0, 0, 0}, {0, 1, 0}));
        QVERIFY(!alongAxis(down, {0, 0, 0}, {0, -1, 0}));
        QVERIFY(!onPlane(down, {0, 0, 0}, {1, 0, 0}));
        QVERIFY(!onPlane(down, {0, 9, 0}, {0, 1, 0})); // behind the eye
        QVERIFY(!aroundRing(down, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
        QVERIFY(alongAxis(down, {0, 0, 0}, {1, 0, 0}));
    }
    void axesAgainstSearching()
    {
        Dice dice;
        for (int i = 0; i < 200; ++i) {
            const Ray ray{dice.point(), dice.number(0.1, 4.0) * dice.direction()};
            const glm::dvec3 origin = dice.point(), axis = dice.direction();
            const glm::dvec3 way = glm::normalize(ray.direction);
            if (glm::length(glm::cross(axis, way)) < 0.2)
                continue;
            const auto distance = [&](double s) {
                const glm::dvec3 away = origin + s * axis - ray.origin;
                return glm::length(away - glm::dot(away, way) * way);
            };
            const auto s = alongAxis(ray, origin, axis);
            QVERIFY(s);
            QVERIFY(std::abs(*s - searched(distance, -200.0, 200.0)) < 1e-5);
        }
    }
    void planesAgainstSearching()
    {
        Dice dice;
        int met = 0;
        for (int i = 0; i < 200; ++i) {
            const Ray ray{dice.point(), dice.direction()};
            const glm::dvec3 origin = dice.point(), normal = dice.direction();
            const auto point = onPlane(ray, origin, normal);
            if (!point || std::abs(glm::dot(ray.direction, normal)) < 0.1)
                continue;
            ++met;
            const double t = searched(
                [&](double at) { return std::abs(glm::dot(ray.at(at) - origin, normal)); }, 0.0, 500.0);
            QVERIFY(glm::distance(*point, ray.at(t)) < 1e-5);
        }
        QVERIFY(met > 50);
    }
    void ringsSayTheAngle()
    {
        Dice dice;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 centre = dice.point(), axis = dice.direction();
            const glm::dvec3 zero = anyPerpendicular(axis);
            const double angle = dice.number(-pi + 0.01, pi - 0.01);
            const glm::dvec3 on = centre + dice.number(0.2, 3.0) * (turnAbout(axis, angle) * zero);
            const glm::dvec3 eye = centre + 20.0 * axis + dice.point();
            const auto found = aroundRing({eye, on - eye}, centre, axis, zero);
            QVERIFY(found);
            QVERIFY(std::abs(*found - angle) < 1e-9);
        }
    }
    void stepsAreDecimal()
    {
        QCOMPARE(snapped(0.27, 0.1), 0.3); // not 0.30000000000000004
        QCOMPARE(snapped(-1.26, 0.5), -1.5);
        QCOMPARE(snapped(7.4, 5.0), 5.0);
        QCOMPARE(snapped(7.4, 0.0), 7.4);
        QCOMPARE(snapped(7.4, -1.0), 7.4);
        Dice dice;
        for (int i = 0; i < 1000; ++i) {
            const double value = dice.number(-100, 100), step = dice.number(0.01, 3.0);
            const double at = snapped(value, step);
            QVERIFY(std::abs(at - value) <= 0.5 * step + 1e-9);
            QVERIFY(std::abs(at / step - std::nearbyint(at / step)) < 1e-6);
        }
    }
    void framesAreSquare()
    {
        Dice dice;
        for (int i = 0; i < 500; ++i) {
            const glm::dmat3 any{dice.point(), dice.point(), dice.point()};
            const glm::dmat3 frame = squareFrame(any);
            QVERIFY(worst(glm::transpose(frame) * frame, glm::dmat3(1.0)) < 1e-12);
            QVERIFY(glm::dot(frame[0], any[0]) > 0.0);
            QVERIFY(glm::dot(frame[2], any[2]) >= 0.0);
        }
        const glm::dvec3 none(0.0), x(2.0, 0.0, 0.0);
        for (const glm::dmat3& flat :
             {glm::dmat3(none, none, none), glm::dmat3(x, none, none), glm::dmat3(none, x, none),
              glm::dmat3(none, none, x), glm::dmat3(x, x, x)})
            QVERIFY(worst(glm::transpose(squareFrame(flat)) * squareFrame(flat), glm::dmat3(1.0)) < 1e-12);
    }
    void theNearestRotationOfARotationIsItself()
    {
        Dice dice;
        for (int i = 0; i < 300; ++i) {
            const glm::dmat3 turned = turnAbout(dice.direction(), dice.number(-pi, pi));
            QVERIFY(worst(nearestRotation(dice.number(0.01, 50.0) * turned), turned) < 1e-13);
            const glm::dmat3 mirrored = turned * glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
            QVERIFY(worst(nearestRotation(mirrored), mirrored) < 1e-13);
            const glm::dmat3 any{dice.point(), dice.point(), dice.point()};
            if (std::abs(glm::determinant(any)) < 0.1)
                continue;
            const glm::dmat3 near = nearestRotation(any);
            QVERIFY(worst(glm::transpose(near) * near, glm::dmat3(1.0)) < 1e-12);
        }
    }
    void quarterTurnsAreExact()
    {
        const glm::dmat3 quarter = turnAbout({0, 1, 0}, 0.5 * pi);
        QCOMPARE(quarter * glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1));
        QCOMPARE(turnAbout({0, 0, 1}, pi) * glm::dvec3(1, 2, 3), glm::dvec3(-1, -2, 3));
        QCOMPARE(turnAbout({1, 0, 0}, -2.0 * pi), glm::dmat3(1.0));
    }
};

RAMURE_SUITE(TestDragMaths)

} // namespace tst_drag_maths

#include "tst_drag_maths.moc"
