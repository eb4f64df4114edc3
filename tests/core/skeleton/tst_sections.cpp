#include "core/math/random.h"
#include "core/skeleton/sections.h"
#include "tests/support/suite.h"

#include <cmath>
#include <numbers>

namespace tst_sections {

using namespace ramure;

namespace {

Skeleton randomTree(std::uint64_t seed, bool planar)
{
    Random random(seed, RandomStream::Test);
    Skeleton skeleton;
    for (Index i = 0; i < 60; ++i) {
        const Index parent = i == 0 || random.unit() < 0.03 ? noIndex : random.below(i);
        const glm::dvec3 from = parent == noIndex ? glm::dvec3(0.0) : skeleton.p1[parent];
        glm::dvec3 step{random.range(-1, 1), random.range(0.1, 1), planar ? 0.0 : random.range(-1, 1)};
        if (random.unit() < 0.05)
            step = glm::dvec3(0.0);
        if (random.unit() < 0.05)
            step = -step;
        const double a0 = parent == noIndex ? 0.2 : skeleton.a1[parent];
        skeleton.add(parent, from, from + step, a0, a0 * random.range(0.5, 1.0));
    }
    return skeleton;
}

bool isFrame(const Frame& f)
{
    const double error = std::abs(glm::length(f.tangent) - 1) + std::abs(glm::length(f.normal) - 1) +
                         std::abs(glm::dot(f.tangent, f.normal)) +
                         glm::length(glm::cross(f.tangent, f.normal) - f.binormal);
    return error < 1e-6;
}

/// Angle by which a frame is turned about its tangent against the other one, carried there.
double twist(const Frame& from, const Frame& to)
{
    const Frame carried = transported(from, to.tangent);
    return std::atan2(glm::dot(to.normal, carried.binormal), glm::dot(to.normal, carried.normal));
}

} // namespace

class TestSections : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void emptySkeleton();
    void fewerThanTwoBecomeTwo();
    void parametersRunFromEndToEnd();
    void framesAreOrthonormal();
    void pointsStandAtTheirRadius();
    void framesGoOnFromParentToChild();
    void planarCurvesDoNotTwist();
    void noTwistBetweenNeighboursInSpace();
    void rollIsHandedOn();
};

void TestSections::emptySkeleton()
{
    const SectionSet set = buildSections(Skeleton(), 4);
    QVERIFY(set.sections.empty());
}

void TestSections::fewerThanTwoBecomeTwo()
{
    for (const int divisions : {-5, 0, 1, 2})
        QCOMPARE(buildSections(randomTree(1, false), divisions).perBranch, Index(2));
}

void TestSections::parametersRunFromEndToEnd()
{
    for (const int divisions : {2, 3, 4, 16, 64}) {
        const Skeleton tree = randomTree(2, false);
        const SectionSet set = buildSections(tree, divisions);
        QCOMPARE(set.sections.size(), std::size_t(tree.size()) * std::size_t(divisions));
        for (Index i = 0; i < tree.size(); ++i) {
            const auto sections = set.of(i);
            QVERIFY(sections.front().centre == tree.p0[i] && sections.back().centre == tree.p1[i]);
            QVERIFY(sections.front().t == 0.0 && sections.back().t == 1.0);
            QVERIFY(sections.front().radius == tree.a0[i] && sections.back().radius == tree.a1[i]);
            for (std::size_t k = 0; k < sections.size(); ++k) {
                QVERIFY(std::abs(sections[k].t - double(k) / (divisions - 1)) < 1e-15);
                const double radius = tree.a0[i] + sections[k].t * (tree.a1[i] - tree.a0[i]);
                QVERIFY(std::abs(sections[k].radius - radius) < 1e-15);
            }
        }
    }
}

void TestSections::framesAreOrthonormal()
{
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (const CrossSection& section : buildSections(randomTree(seed, seed % 2 == 0), 5).sections)
            QVERIFY(isFrame(section.frame));
}

void TestSections::pointsStandAtTheirRadius()
{
    const SectionSet set = buildSections(randomTree(3, false), 4);
    for (const int n : {3, 5, 8, 64}) {
        for (const CrossSection& section : set.sections) {
            for (int k = 0; k < n; ++k) {
                const glm::dvec3 out = sectionPoint(section, k, n) - section.centre;
                QVERIFY(std::abs(glm::length(out) - section.radius) < 1e-6);
                QVERIFY(std::abs(glm::dot(out, section.frame.tangent)) < 1e-6);
                // Counter-clockwise against the tangent, evenly spread, the first along the normal.
                const double angle = 2 * std::numbers::pi * k / n;
                QVERIFY(std::abs(glm::dot(out, section.frame.normal) - section.radius * std::cos(angle)) <
                        1e-6);
                QVERIFY(std::abs(glm::dot(out, section.frame.binormal) - section.radius * std::sin(angle)) <
                        1e-6);
            }
        }
    }
}

void TestSections::framesGoOnFromParentToChild()
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Skeleton tree = randomTree(seed, false);
        const SectionSet set = buildSections(tree, 4);
        for (Index i = 0; i < tree.size(); ++i) {
            const Index parent = tree.parent[i];
            if (parent == noIndex || tree.length(parent) == 0.0)
                continue;
            const Frame& end = set.of(parent).back().frame;
            const Frame& start = set.of(i).front().frame;
            QVERIFY(glm::length(end.normal - start.normal) < 1e-6);
            QVERIFY(glm::length(end.tangent - start.tangent) < 1e-6);
        }
    }
}

void TestSections::planarCurvesDoNotTwist()
{
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Skeleton tree = randomTree(seed, true);
        const SectionSet set = buildSections(tree, 6);
        for (Index i = 0; i < tree.size(); ++i)
            for (std::size_t k = 1; k < 6; ++k) {
                const Frame &a = set.of(i)[k - 1].frame, &b = set.of(i)[k].frame;
                if (glm::dot(a.tangent, b.tangent) < -0.999)
                    continue; // a half turn has no single smallest rotation
                QVERIFY(std::abs(twist(a, b)) < 1e-6);
                // The normal of the plane moves with the curve: it keeps its place in the frame.
                const glm::dvec3 up(0, 0, 1);
                QVERIFY(std::abs(glm::dot(a.normal, up) - glm::dot(b.normal, up)) < 1e-6);
                QVERIFY(std::abs(glm::dot(a.binormal, up) - glm::dot(b.binormal, up)) < 1e-6);
            }
    }
}

void TestSections::noTwistBetweenNeighboursInSpace()
{
    const SectionSet set = buildSections(randomTree(8, false), 16);
    for (std::size_t s = 1; s < set.sections.size(); ++s)
        if (s % 16 != 0 &&
            glm::dot(set.sections[s - 1].frame.tangent, set.sections[s].frame.tangent) > -0.999)
            QVERIFY(std::abs(twist(set.sections[s - 1].frame, set.sections[s].frame)) < 1e-6);
}

void TestSections::rollIsHandedOn()
{
    Skeleton tree;
    tree.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    tree.add(0, {0, 1, 0}, {0.5, 2, 0.2}, 0.1, 0.1);
    tree.add(1, {0.5, 2, 0.2}, {0.5, 3, 0.7}, 0.1, 0.1);
    tree.add(0, {0, 1, 0}, {-0.5, 2, 0.2}, 0.1, 0.1);
    const SectionSet plain = buildSections(tree, 4);
    const std::vector<double> roll{0.0, 0.7, -0.2, 0.0};
    const SectionSet set = buildSections(tree, 4, roll);
    const std::vector<double> expected{0.0, 0.7, 0.5, 0.0};
    for (Index i = 0; i < tree.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(set.of(i)[k].centre == plain.of(i)[k].centre);
            QVERIFY(std::abs(twist(plain.of(i)[k].frame, set.of(i)[k].frame) - expected[i]) < 1e-12);
        }
    const SectionSet shortList = buildSections(tree, 4, std::span(roll).first(2));
    QVERIFY(std::abs(twist(plain.of(2)[0].frame, shortList.of(2)[0].frame) - 0.7) < 1e-12);
}

RAMURE_SUITE(TestSections)

} // namespace tst_sections

#include "tst_sections.moc"
