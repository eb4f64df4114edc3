#include "core/math/frame.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tst_frame {

using namespace ramure;

namespace {

glm::dvec3 randomUnit(Random& random)
{
    glm::dvec3 v;
    do
        v = {random.range(-1, 1), random.range(-1, 1), random.range(-1, 1)};
    while (glm::length(v) < 0.1);
    return glm::normalize(v);
}

bool isFrame(const Frame& f)
{
    const double error = std::abs(glm::length(f.tangent) - 1) + std::abs(glm::length(f.normal) - 1) +
                         std::abs(glm::dot(f.tangent, f.normal)) +
                         glm::length(glm::cross(f.tangent, f.normal) - f.binormal);
    return error < 1e-12;
}

double distance(const Frame& a, const Frame& b)
{
    return glm::length(a.tangent - b.tangent) + glm::length(a.normal - b.normal) +
           glm::length(a.binormal - b.binormal);
}

/// Rodrigues' rotation, the plain way.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * glm::dot(axis, v) * (1 - std::cos(angle));
}

} // namespace

class TestFrame : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void antiparallelIsHalfATurnAboutTheNormal();
    void almostAntiparallel();
    void upGivesTheDefaults();
    void anyTangentGivesAFrame();
    void transportIsTheSmallestRotation();
    void transportThereAndBack();
    void rollTurnsAboutTheTangent();
};

void TestFrame::antiparallelIsHalfATurnAboutTheNormal()
{
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 1000; ++i) {
        const Frame frame = rolled(frameFromTangent(randomUnit(random)), random.range(-4, 4));
        const Frame back = transported(frame, -frame.tangent);
        QVERIFY(isFrame(back));
        QVERIFY(glm::length(back.normal - frame.normal) < 1e-12);
        QVERIFY(glm::length(back.binormal + frame.binormal) < 1e-12);
    }
    QVERIFY(isFrame(frameFromTangent({0, -1, 0})));
}

void TestFrame::almostAntiparallel()
{
    Random random(2, RandomStream::Test);
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18}) {
        for (int i = 0; i < 200; ++i) {
            const Frame frame = frameFromTangent(randomUnit(random));
            const glm::dvec3 tangent = glm::normalize(-frame.tangent + off * randomUnit(random));
            const Frame back = transported(frame, tangent);
            QVERIFY(isFrame(back));
            QVERIFY(glm::length(back.tangent - tangent) < 1e-15);
        }
    }
}

void TestFrame::upGivesTheDefaults()
{
    QCOMPARE(distance(frameFromTangent({0, 1, 0}), Frame()), 0.0);
    QVERIFY(isFrame(Frame()));
}

void TestFrame::anyTangentGivesAFrame()
{
    Random random(3, RandomStream::Test);
    for (int i = 0; i < 10'000; ++i) {
        const glm::dvec3 tangent = randomUnit(random);
        const Frame frame = frameFromTangent(tangent);
        QVERIFY(isFrame(frame));
        QVERIFY(frame.tangent == tangent);
        QCOMPARE(distance(frame, frameFromTangent(tangent)), 0.0);
    }
}

void TestFrame::transportIsTheSmallestRotation()
{
    Random random(4, RandomStream::Test);
    for (int i = 0; i < 10'000; ++i) {
        const Frame frame = rolled(frameFromTangent(randomUnit(random)), random.range(-4, 4));
        const glm::dvec3 axis = glm::normalize(glm::cross(frame.tangent, randomUnit(random)));
        const double angle = random.range(-3.1, 3.1);
        const Frame moved = transported(frame, turned(frame.tangent, axis, angle));
        QVERIFY(isFrame(moved));
        QVERIFY(glm::length(moved.normal - turned(frame.normal, axis, angle)) < 1e-11);
    }
}

void TestFrame::transportThereAndBack()
{
    Random random(5, RandomStream::Test);
    for (int i = 0; i < 1000; ++i) {
        const Frame frame = rolled(frameFromTangent(randomUnit(random)), random.range(-4, 4));
        QCOMPARE(distance(transported(frame, frame.tangent), frame) < 1e-15, true);
        const glm::dvec3 there = randomUnit(random);
        if (glm::dot(there, frame.tangent) > -0.99)
            QVERIFY(distance(transported(transported(frame, there), frame.tangent), frame) < 1e-11);
    }
}

void TestFrame::rollTurnsAboutTheTangent()
{
    const Frame quarter = rolled(Frame(), std::numbers::pi / 2);
    QVERIFY(glm::length(quarter.normal - Frame().binormal) < 1e-15);
    QVERIFY(glm::length(quarter.binormal + Frame().normal) < 1e-15);
    Random random(6, RandomStream::Test);
    for (int i = 0; i < 1000; ++i) {
        const Frame frame = frameFromTangent(randomUnit(random));
        const double angle = random.range(-10, 10);
        const Frame by = rolled(frame, angle);
        QVERIFY(isFrame(by));
        QVERIFY(by.tangent == frame.tangent);
        QVERIFY(glm::length(by.normal - turned(frame.normal, frame.tangent, angle)) < 1e-12);
        QVERIFY(distance(rolled(by, -angle), frame) < 1e-12);
    }
}

RAMURE_SUITE(TestFrame)

} // namespace tst_frame

#include "tst_frame.moc"
