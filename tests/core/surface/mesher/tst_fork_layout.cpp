#include "core/math/random.h"
#include "core/surface/mesher/fork_layout.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tst_fork_layout {

using namespace ramure;
using namespace ramure::test;

/// How a fork divides its ring: one split point per hull edge, in order, never two in one place.
class TestForkLayout : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void twoChildrenSplitAcross();
    void regularPointsStay();
    void antiparallelChildHasAPlace();
    void limbsLeaveTheStemToItsSide();
    void noStemBetweenEqualsOrWithoutRoom();
    void randomChildren();
    void randomLimbs();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

ForkLayout plan(const std::vector<glm::dvec3>& directions, int radial)
{
    const Frame frame;
    ForkPlanner planner;
    planner.begin();
    for (const glm::dvec3& direction : directions)
        planner.addChild(frame, glm::normalize(direction));
    ForkLayout layout;
    planner.plan(regularRing(radial), layout);
    return layout;
}

struct Limb
{
    glm::dvec3 direction;
    double radius; ///< of the parent's end
};

ForkLayout plan(const std::vector<Limb>& limbs, int radial)
{
    const Frame frame;
    ForkPlanner planner;
    planner.begin();
    for (const Limb& limb : limbs) {
        const glm::dvec3 direction = glm::normalize(limb.direction);
        planner.addChild(frame, direction, direction, limb.radius);
    }
    ForkLayout layout;
    planner.plan(regularRing(radial), layout);
    return layout;
}

QByteArray faults(const ForkLayout& layout, int radial)
{
    if (layout.ring.size() < 3)
        return "fewer than three points";
    if (layout.splitPoint.size() != layout.triangulation.hull().size() || layout.splitPoint.front() != 0)
        return "split points";
    const double least =
        (layout.stem == noIndex ? 0.2 : 0.03) *
        std::min(std::numbers::pi / radial, 0.8 * turn / static_cast<double>(layout.splitPoint.size()));
    for (std::size_t i = 0; i < layout.ring.size(); ++i) {
        const bool last = i + 1 == layout.ring.size();
        const double next = last ? layout.ring[0].azimuth + turn : layout.ring[i + 1].azimuth;
        if (next - layout.ring[i].azimuth < least)
            return "points too close";
        const glm::dvec2 direction(std::cos(layout.ring[i].azimuth), std::sin(layout.ring[i].azimuth));
        if (glm::length(direction - layout.ring[i].direction) > 1e-9)
            return "a direction is not its azimuth's";
    }
    for (std::size_t e = 0; e + 1 < layout.splitPoint.size(); ++e)
        if (layout.splitPoint[e] >= layout.splitPoint[e + 1])
            return "split points out of order";
    return {};
}

} // namespace

void TestForkLayout::twoChildrenSplitAcross()
{
    // In the frame of +Y the normal is +X and the binormal -Z: children to both sides along X split the ring
    // on Z.
    const ForkLayout layout = plan({{0.5, 1, 0}, {-0.5, 1, 0}}, 8);
    QCOMPARE(faults(layout, 8), QByteArray());
    QCOMPARE(layout.splitPoint.size(), std::size_t(2));
    for (const Index point : layout.splitPoint)
        QVERIFY(std::abs(layout.ring[point].direction.x) < 1e-4);
    QCOMPARE(layout.ring.size(), std::size_t(8)); // the split points replace two regular ones
}

void TestForkLayout::regularPointsStay()
{
    const ForkLayout layout = plan({{1, 1, 0.2}, {-0.7, 1, 0.5}, {0.1, 1, -1}}, 32);
    QCOMPARE(faults(layout, 32), QByteArray());
    int regular = 0;
    for (const RingPoint& point : layout.ring) {
        const double steps = point.azimuth / (turn / 32);
        regular += std::abs(steps - std::round(steps)) < 1e-9 ? 1 : 0;
    }
    QVERIFY(regular >= 32 - 2 * 3);
    QVERIFY(layout.ring.size() <= 35);
}

void TestForkLayout::antiparallelChildHasAPlace()
{
    for (const int radial : {3, 8, 128}) {
        QCOMPARE(faults(plan({{0, -1, 0}, {0, 1, 0}}, radial), radial), QByteArray());
        QCOMPARE(faults(plan({{0, -1, 0}, {0, -1, 0}}, radial), radial), QByteArray());
        QCOMPARE(faults(plan({{0, -1, 0}, {1e-9, -1, 0}, {1, 0, 0}, {0, 1, 0}}, radial), radial),
                 QByteArray());
    }
}

/// A limb has a piece of the ring as wide as itself, where it points; the stem has the rest.
void TestForkLayout::limbsLeaveTheStemToItsSide()
{
    const Limb stem{{0.1, 1, 0}, 0.95}, one{{1, 0.1, 0}, 0.2}, other{{-0.5, 0.2, 0.8}, 0.1};
    const ForkLayout layout = plan(std::vector{one, stem, other}, 64);
    QCOMPARE(faults(layout, 64), QByteArray());
    QCOMPARE(layout.stem, Index(1));
    QVERIFY(layout.triangulation.triangles().empty());
    const auto& hull = layout.triangulation.hull();
    QCOMPARE(hull.size(), std::size_t(4));
    for (Index e = 0; e < hull.size(); ++e) {
        QCOMPARE(hull[hull[e].partner].partner, e);
        if (hull[e].from != layout.stem)
            continue;
        const Limb& limb = hull[e].to == 0 ? one : other;
        const double from = layout.ring[layout.splitPoint[e]].azimuth,
                     to = layout.ring[layout.splitPoint[hull[e].partner]].azimuth;
        const double middle = 0.5 * (from + to), width = 2.0 * std::sin(0.5 * (to - from));
        const glm::dvec2 way = glm::normalize(glm::dvec2(limb.direction.x, -limb.direction.z));
        QVERIFY(std::abs(std::cos(middle) - way.x) < 1e-6 && std::abs(std::sin(middle) - way.y) < 1e-6);
        QVERIFY(width >= 2.0 * limb.radius && width < 2.4 * limb.radius);
    }
}

void TestForkLayout::noStemBetweenEqualsOrWithoutRoom()
{
    const Limb stem{{0, 1, 0}, 1.0}, thick{{1, 0.2, 0}, 0.9}, limb{{1, 0.1, 0}, 0.4},
        beside{{1, 0.1, 0.2}, 0.4}, along{{0.1, 1, 0}, 0.3}, bent{{1, 1, 0}, 1.0};
    for (const auto& fork :
         {std::vector{stem, thick}, std::vector{stem, limb, beside}, std::vector{stem, along},
          std::vector{bent, Limb{{-1, 0.1, 0}, 0.2}}, std::vector{along, limb}}) {
        const ForkLayout layout = plan(fork, 16);
        QCOMPARE(faults(layout, 16), QByteArray());
        QCOMPARE(layout.stem, noIndex);
    }
}

/// Any number of limbs: either there is room for all, or it is a fork like any other.
void TestForkLayout::randomLimbs()
{
    int stars = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Random random(seed, RandomStream::Test);
        std::vector<Limb> fork{
            {{random.range(-0.3, 0.3), 1, random.range(-0.3, 0.3)}, random.range(0.7, 1.0)}};
        for (std::uint32_t limbs = 1 + random.below(6); limbs > 0; --limbs)
            fork.push_back({{random.range(-1, 1), random.range(-0.5, 0.8), random.range(-1, 1)},
                            random.range(0.001, 0.5)});
        const int radial = 3 + static_cast<int>(random.below(30));
        const ForkLayout layout = plan(fork, radial);
        const QByteArray wrong = faults(layout, radial);
        QVERIFY2(wrong.isEmpty(), wrong + " with seed " + QByteArray::number(qulonglong(seed)));
        stars += layout.stem == 0 ? 1 : 0;
    }
    QVERIFY(stars > 300 && stars < 1900);
}

void TestForkLayout::randomChildren()
{
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Random random(seed, RandomStream::Test);
        const std::uint32_t count = 2 + random.below(seed % 10 == 0 ? 62 : 6);
        const bool flat = seed % 3 == 0;
        std::vector<glm::dvec3> directions;
        while (directions.size() < count) {
            const glm::dvec3 d(random.range(-1, 1), random.range(-1, 1), flat ? 0.0 : random.range(-1, 1));
            if (glm::length(d) > 0.1)
                directions.push_back(d);
        }
        const int radial = 3 + static_cast<int>(random.below(30));
        const QByteArray wrong = faults(plan(directions, radial), radial);
        QVERIFY2(wrong.isEmpty(), wrong + " with seed " + QByteArray::number(qulonglong(seed)));
    }
}

RAMURE_SUITE(TestForkLayout)

} // namespace tst_fork_layout

#include "tst_fork_layout.moc"
