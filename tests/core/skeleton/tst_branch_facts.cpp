#include "core/math/random.h"
#include "core/skeleton/branch_facts.h"
#include "core/surface/foliage/branch_masses.h"
#include "tests/support/suite.h"
#include <charconv>
#include <clocale>
#include <cmath>
#include <numbers>
#include <sstream>

namespace tst_branch_facts {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

/// A trunk of \p v0 and a child of \p chord: the child's curve starts along v0 and ends along its chord.
Skeleton bend(const glm::dvec3& v0, const glm::dvec3& chord)
{
    Skeleton skeleton;
    skeleton.add(noIndex, glm::dvec3(0.0), v0, 0.1, 0.08);
    skeleton.add(0, v0, v0 + chord, 0.08, 0.06, 1);
    return skeleton;
}

BranchFacts factsOf(const Skeleton& skeleton, const SectionSet& sections, Index branch)
{
    return branchFacts(skeleton, childLists(skeleton), sections, branchMasses(skeleton, {}), branch);
}

/// The curvature of such a child in closed form: with v1 = chord, r' = (4t - 3t^2) chord + (1 - 4t + 3t^2) v0
/// and r' x r'' = (4 - 6t) v0 x chord.
double bendCurvature(const glm::dvec3& v0, const glm::dvec3& chord, double t)
{
    const double speed = glm::length((4.0 * t - 3.0 * t * t) * chord + (1.0 - 4.0 * t + 3.0 * t * t) * v0);
    return std::abs(4.0 - 6.0 * t) * glm::length(glm::cross(v0, chord)) / (speed * speed * speed);
}

glm::dvec3 drawVector(Random& random)
{
    return {random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0)};
}

bool allFinite(const SectionFacts& s)
{
    for (const double x : {s.t, s.arcLength, s.radius, s.curvature, s.twistRad, s.twistRadPerMetre})
        if (!std::isfinite(x))
            return false;
    for (const glm::dvec3& v : {s.centre, s.tangent, s.normal, s.binormal})
        if (!std::isfinite(v.x + v.y + v.z))
            return false;
    return true;
}

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

} // namespace

class TestBranchFacts : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void degenerateBranchesHaveFacts();
    void missingSectionsGiveNone();
    void massOfStrangeFoliage();

    void factsAreThoseOfTheSkeleton();
    void anglesOfARoot();
    void azimuthTurnsWithTheParentsFrame();
    void anglesWithoutSections();
    void massIsThatOfTheWholeSubtree();
    void massOfADeepSkeleton();

    void straightBranchIsStraight();
    void curvatureInClosedForm();
    void curvatureIsTheTurnOfTheTangent();
    void curvatureScalesAndMovesWithTheBranch();
    void arcLengthIsThatOfAFinePolyline();
    void transportedFramesDoNotTwist();
    void rollIsTheTwist();
    void handTwistedFramesAreMeasured();

    void csvHasOneLinePerSection();
    void csvReadsBackToTheSameDoubles();
    void csvIgnoresTheLocale();
};

void TestBranchFacts::degenerateBranchesHaveFacts()
{
    Skeleton skeleton;
    skeleton.add(noIndex, glm::dvec3(0.0), glm::dvec3(0.0), 0.1, 0.1); // 0: a root of no length
    skeleton.add(0, glm::dvec3(0.0), {0.0, 1.0, 0.0}, 0.1, 0.1);       // 1: after it
    skeleton.add(1, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, 0.1, 0.1);       // 2: straight back
    skeleton.add(2, glm::dvec3(0.0), glm::dvec3(0.0), 0.1, 0.0);       // 3: no length, no radius
    skeleton.add(3, glm::dvec3(0.0), {1e-12, 0.0, 0.0}, 0.0, 0.0);     // 4: tiny
    skeleton.add(4, {1e-12, 0.0, 0.0}, {1e9, 1e9, 0.0}, 0.0, 0.0);     // 5: huge after tiny
    for (const int divisions : {2, 3, 4, 9}) {
        const SectionSet sections = buildSections(skeleton, divisions);
        for (Index i = 0; i < skeleton.size(); ++i) {
            const BranchFacts facts = factsOf(skeleton, sections, i);
            QVERIFY(std::isfinite(facts.angleRad) && std::isfinite(facts.azimuthRad));
            QVERIFY(facts.angleRad >= 0.0 && facts.angleRad <= pi);
            const auto list = sectionFacts(skeleton, sections, i);
            QCOMPARE(list.size(), std::size_t(divisions));
            for (const SectionFacts& section : list)
                QVERIFY(allFinite(section));
        }
    }
    const SectionSet sections = buildSections(skeleton, 4);
    QCOMPARE(factsOf(skeleton, sections, 0).angleRad, 0.0);
    QCOMPARE(factsOf(skeleton, sections, 3).angleRad, 0.0);
    QVERIFY(near(factsOf(skeleton, sections, 2).angleRad, pi, 1e-12));
    QCOMPARE(factsOf(skeleton, sections, 2).azimuthRad, 0.0);
    for (const SectionFacts& section : sectionFacts(skeleton, sections, 2))
        QCOMPARE(section.curvature, 0.0);
}

void TestBranchFacts::missingSectionsGiveNone()
{
    const Skeleton skeleton = bend({0, 1, 0}, {1, 0, 0});
    QVERIFY(sectionFacts(skeleton, {}, 0).empty());
    QVERIFY(sectionFacts(skeleton, buildSections(skeleton, 4), 2).empty());
    SectionSet half = buildSections(skeleton, 4);
    half.sections.resize(6);
    QCOMPARE(sectionFacts(skeleton, half, 0).size(), std::size_t(4));
    QVERIFY(sectionFacts(skeleton, half, 1).empty());
    QVERIFY(branchMasses({}, {}).empty());
}

void TestBranchFacts::massOfStrangeFoliage()
{
    const Skeleton skeleton = bend({0, 1, 0}, {1, 0, 0});
    Foliage foliage;
    foliage.apples.resize(4);
    foliage.apples[0].branch = 1;
    foliage.apples[1].branch = 1; // a second one on the same branch is not "an apple more"
    foliage.apples[2].branch = 7;
    foliage.apples[3].branch = noIndex;
    foliage.leaves.resize(3);
    foliage.leaves[0].branch = 0;
    const auto masses = branchMasses(skeleton, foliage);
    QVERIFY(near(masses[1], 0.06 + 0.075, 1e-15));
    QVERIFY(near(masses[0], 0.08 + 0.06 + 0.075, 1e-15));
}

void TestBranchFacts::factsAreThoseOfTheSkeleton()
{
    Skeleton skeleton = bend({0, 2, 0}, {1, 0, 0});
    skeleton.add(0, {0, 2, 0}, {0, 3, 0}, 0.07, 0.05, 3);
    const SectionSet sections = buildSections(skeleton, 4);
    const BranchFacts trunk = factsOf(skeleton, sections, 0), side = factsOf(skeleton, sections, 1);
    QCOMPARE(trunk.parent, noIndex);
    QCOMPARE(trunk.children, (std::vector<Index>{1, 2}));
    QCOMPARE(trunk.length, 2.0);
    QCOMPARE(trunk.order, Index(0));
    QCOMPARE(side.parent, Index(0));
    QVERIFY(side.children.empty());
    QVERIFY(side.p0 == glm::dvec3(0, 2, 0) && side.p1 == glm::dvec3(1, 2, 0));
    QCOMPARE(side.a0, 0.08);
    QCOMPARE(side.a1, 0.06);
    QCOMPARE(side.length, 1.0);
    QCOMPARE(side.mass, 0.06);
    QVERIFY(near(side.angleRad, pi / 2, 1e-15));
    const BranchFacts straight = factsOf(skeleton, sections, 2);
    QCOMPARE(straight.order, Index(3));
    QCOMPARE(straight.angleRad, 0.0);
    QCOMPARE(straight.azimuthRad, 0.0);
}

void TestBranchFacts::anglesOfARoot()
{
    for (int i = -8; i <= 8; ++i) {
        const double azimuth = i * pi / 9, angle = 0.7;
        Skeleton skeleton;
        // From +X towards -Z about +Y.
        skeleton.add(noIndex, {3, 4, 5},
                     glm::dvec3(3, 4, 5) + 2.5 * glm::dvec3(std::sin(angle) * std::cos(azimuth),
                                                            std::cos(angle),
                                                            -std::sin(angle) * std::sin(azimuth)),
                     0.1, 0.1);
        const BranchFacts facts = factsOf(skeleton, buildSections(skeleton, 3), 0);
        QVERIFY(near(facts.angleRad, angle, 1e-12));
        QVERIFY(near(facts.azimuthRad, azimuth, 1e-12));
    }
}

void TestBranchFacts::azimuthTurnsWithTheParentsFrame()
{
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 200; ++i) {
        const Skeleton skeleton = bend(drawVector(random), drawVector(random));
        const double roll = random.range(-3.0, 3.0);
        const std::vector<double> rolls = {roll, 0.0};
        const SectionSet plain = buildSections(skeleton, 4), turned = buildSections(skeleton, 4, rolls);
        const BranchFacts before = factsOf(skeleton, plain, 1), after = factsOf(skeleton, turned, 1);
        QVERIFY(near(before.angleRad, after.angleRad, 1e-12));
        const double shift = before.azimuthRad - after.azimuthRad - roll;
        QVERIFY(near(std::remainder(shift, 2 * pi), 0.0, 1e-9));
        // The two angles and the parent's frame give the direction back.
        const Frame& frame = plain.of(0).back().frame;
        const glm::dvec3 direction =
            std::cos(before.angleRad) * frame.tangent +
            std::sin(before.angleRad) *
                (std::cos(before.azimuthRad) * frame.normal + std::sin(before.azimuthRad) * frame.binormal);
        const glm::dvec3 way = skeleton.p1[1] - skeleton.p0[1];
        QVERIFY(glm::length(direction - way / glm::length(way)) < 1e-9);
    }
}

void TestBranchFacts::anglesWithoutSections()
{
    const Skeleton skeleton = bend({0, 1, 0}, {1, 1, 0});
    const BranchFacts facts = factsOf(skeleton, {}, 1);
    QVERIFY(near(facts.angleRad, pi / 4, 1e-15));
    QVERIFY(near(facts.azimuthRad, 0.0, 1e-15));
    QCOMPARE(branchFacts(skeleton, childLists(skeleton), {}, {}, 1).mass, 0.0);
}

void TestBranchFacts::massIsThatOfTheWholeSubtree()
{
    Random random(2, RandomStream::Test);
    Skeleton skeleton;
    Foliage foliage;
    for (Index i = 0; i < 300; ++i) {
        const Index parent = i < 3 ? noIndex : random.below(i);
        const glm::dvec3 from = parent == noIndex ? glm::dvec3(0.0) : skeleton.p1[parent];
        skeleton.add(parent, from, from + drawVector(random), 0.1, random.range(0.0, 0.1));
        if (random.unit() < 0.1)
            foliage.apples.push_back({i, from, {}});
    }
    std::vector<double> sums(skeleton.size(), 0.0);
    for (Index i = 0; i < skeleton.size(); ++i) {
        const bool apple = std::any_of(foliage.apples.begin(), foliage.apples.end(),
                                       [i](const auto& a) { return a.branch == i; });
        for (Index above = i; above != noIndex; above = skeleton.parent[above])
            sums[above] += skeleton.a1[i] + (apple ? 0.075 : 0.0);
    }
    const auto masses = branchMasses(skeleton, foliage);
    for (Index i = 0; i < skeleton.size(); ++i)
        QVERIFY(near(masses[i], sums[i], 1e-12));
}

void TestBranchFacts::massOfADeepSkeleton()
{
    Skeleton skeleton;
    constexpr Index depth = 300'000;
    for (Index i = 0; i < depth; ++i)
        skeleton.add(i == 0 ? noIndex : i - 1, {0, i, 0}, {0, i + 1, 0}, 1.0, 0.5);
    QCOMPARE(branchMasses(skeleton, {})[0], 0.5 * depth);
}

void TestBranchFacts::straightBranchIsStraight()
{
    const Skeleton skeleton = bend({0, 1, 0}, {0, 2.5, 0});
    for (const Index branch : {Index(0), Index(1)}) {
        const auto list = sectionFacts(skeleton, buildSections(skeleton, 5), branch);
        QCOMPARE(list.size(), std::size_t(5));
        for (const SectionFacts& section : list) {
            QVERIFY(near(section.curvature, 0.0, 1e-14));
            QVERIFY(near(section.twistRad, 0.0, 1e-14));
            QVERIFY(near(section.twistRadPerMetre, 0.0, 1e-14));
            QVERIFY(near(section.arcLength, section.centre.y - skeleton.p0[branch].y, 1e-12));
        }
        QCOMPARE(list.front().section, Index(0));
        QCOMPARE(list.back().section, Index(4));
        QCOMPARE(list.back().t, 1.0);
        QCOMPARE(list.back().radius, skeleton.a1[branch]);
    }
}

void TestBranchFacts::curvatureInClosedForm()
{
    // By hand: a right angle of two unit vectors bends with 4 at its start, not at all at 2/3, with 2 at its
    // end.
    const auto rightAngle =
        sectionFacts(bend({0, 1, 0}, {1, 0, 0}), buildSections(bend({0, 1, 0}, {1, 0, 0}), 4), 1);
    QVERIFY(near(rightAngle[0].curvature, 4.0, 1e-14));
    QVERIFY(near(rightAngle[2].curvature, 0.0, 1e-14));
    QVERIFY(near(rightAngle[3].curvature, 2.0, 1e-14));

    Random random(3, RandomStream::Test);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 v0 = drawVector(random), chord = drawVector(random);
        const Skeleton skeleton = bend(v0, chord);
        for (const SectionFacts& section : sectionFacts(skeleton, buildSections(skeleton, 7), 1)) {
            const double expected = bendCurvature(v0, chord, section.t);
            QVERIFY(near(section.curvature, expected, 1e-9 * (1.0 + expected)));
        }
    }
}

void TestBranchFacts::curvatureIsTheTurnOfTheTangent()
{
    const Skeleton skeleton = bend({0.3, 1, 0}, {1, 0.8, 0.4});
    const auto list = sectionFacts(skeleton, buildSections(skeleton, 2001), 1);
    for (std::size_t k = 1; k + 1 < list.size(); ++k) {
        const double turn = glm::length(list[k + 1].tangent - list[k - 1].tangent);
        const double way = list[k + 1].arcLength - list[k - 1].arcLength;
        QVERIFY(near(list[k].curvature, turn / way, 1e-3));
    }
}

void TestBranchFacts::curvatureScalesAndMovesWithTheBranch()
{
    const glm::dvec3 v0(0.3, 1.0, 0.2), chord(1.0, 0.4, -0.7);
    const auto list = sectionFacts(bend(v0, chord), buildSections(bend(v0, chord), 6), 1);
    for (const double scale : {1e-6, 1e-3, 10.0, 1e6}) {
        const Skeleton scaled = bend(scale * v0, scale * chord);
        const auto other = sectionFacts(scaled, buildSections(scaled, 6), 1);
        for (std::size_t k = 0; k < list.size(); ++k) {
            QVERIFY(near(other[k].curvature * scale, list[k].curvature, 1e-10));
            QVERIFY(near(other[k].arcLength / scale, list[k].arcLength, 1e-10));
        }
    }
}

void TestBranchFacts::arcLengthIsThatOfAFinePolyline()
{
    const Skeleton skeleton = bend({0.2, 1.5, 0}, {1, 0.1, 0.6});
    const BranchCurve curve = branchCurve(skeleton, 1);
    const auto list = sectionFacts(skeleton, buildSections(skeleton, 4), 1);
    QCOMPARE(list.front().arcLength, 0.0);
    double length = 0.0;
    constexpr int steps = 100'000;
    glm::dvec3 before = curve.h0;
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 point = hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(i) / steps).point;
        length += glm::length(point - before);
        before = point;
    }
    QVERIFY(near(list.back().arcLength, length, 1e-8));
}

void TestBranchFacts::transportedFramesDoNotTwist()
{
    Random random(4, RandomStream::Test);
    for (int i = 0; i < 200; ++i) {
        Skeleton skeleton = bend(drawVector(random), drawVector(random));
        skeleton.add(1, skeleton.p1[1], skeleton.p1[1] + drawVector(random), 0.05, 0.04, 1);
        const SectionSet sections = buildSections(skeleton, 2 + i % 8);
        for (Index branch = 0; branch < skeleton.size(); ++branch)
            for (const SectionFacts& section : sectionFacts(skeleton, sections, branch))
                QVERIFY2(near(section.twistRad, 0.0, 1e-7), qPrintable(QString::number(section.twistRad)));
    }
}

void TestBranchFacts::rollIsTheTwist()
{
    Skeleton skeleton = bend({0.1, 1, 0}, {1, 0.3, 0.4});
    skeleton.add(1, skeleton.p1[1], skeleton.p1[1] + glm::dvec3(0.3, 1, 0), 0.05, 0.04, 1);
    const std::vector<double> rolls = {0.4, -1.2, 0.0};
    const SectionSet sections = buildSections(skeleton, 5, rolls);
    for (Index branch = 0; branch < skeleton.size(); ++branch)
        for (const SectionFacts& section : sectionFacts(skeleton, sections, branch)) {
            QVERIFY(near(section.twistRad, rolls[branch], 1e-9)); // the parent's roll is the parent's twist
            QVERIFY(near(section.twistRadPerMetre, 0.0, 1e-9));
        }
}

void TestBranchFacts::handTwistedFramesAreMeasured()
{
    const Skeleton skeleton = bend({0, 1, 0}, {0.5, 1, 0.2});
    SectionSet sections = buildSections(skeleton, 9);
    for (Index k = 0; k < 9; ++k) {
        CrossSection& section = sections.sections[9 + k];
        section.frame = rolled(section.frame, 0.9 * k); // more than a whole turn in all
    }
    const auto list = sectionFacts(skeleton, sections, 1);
    for (std::size_t k = 0; k < list.size(); ++k) {
        QVERIFY(near(list[k].twistRad, 0.9 * double(k), 1e-9));
        const double piece = k == 0 ? list[1].arcLength : list[k].arcLength - list[k - 1].arcLength;
        QVERIFY(near(list[k].twistRadPerMetre, 0.9 / piece, 1e-9));
    }
}

void TestBranchFacts::csvHasOneLinePerSection()
{
    QCOMPARE(split(sectionsCsv({}), '\n').size(), std::size_t(1));
    const Skeleton skeleton = bend({0, 1, 0}, {1, 0.5, 0});
    const auto list = sectionFacts(skeleton, buildSections(skeleton, 6), 1);
    const std::string text = sectionsCsv(list);
    QVERIFY(text.ends_with('\n'));
    const auto lines = split(text, '\n');
    QCOMPARE(lines.size(), std::size_t(7));
    for (const std::string& line : lines)
        QCOMPARE(split(line, ',').size(), split(lines[0], ',').size());
    QCOMPARE(split(lines[1], ',')[0], std::string("1"));
    QCOMPARE(split(lines[6], ',')[0], std::string("6"));
    QCOMPARE(split(lines[6], ',')[1], std::string("1"));
}

void TestBranchFacts::csvReadsBackToTheSameDoubles()
{
    const Skeleton skeleton = bend({0.1, 1, 0}, {1, 0.5, 0.3});
    const auto list = sectionFacts(skeleton, buildSections(skeleton, 6), 1);
    const auto lines = split(sectionsCsv(list), '\n');
    const auto names = split(lines[0], ',');
    const auto column = [&](std::size_t row, const std::string& name) {
        const auto at = std::find(names.begin(), names.end(), name) - names.begin();
        const std::string text = split(lines[row + 1], ',')[static_cast<std::size_t>(at)];
        double value = std::nan("");
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        return read.ptr == text.data() + text.size() ? value : std::nan("");
    };
    for (std::size_t k = 0; k < list.size(); ++k) {
        QCOMPARE(column(k, "t"), list[k].t);
        QCOMPARE(column(k, "arc_length_m"), list[k].arcLength);
        QCOMPARE(column(k, "centre_x_m"), list[k].centre.x);
        QCOMPARE(column(k, "tangent_y"), list[k].tangent.y);
        QCOMPARE(column(k, "normal_z"), list[k].normal.z);
        QCOMPARE(column(k, "binormal_x"), list[k].binormal.x);
        QCOMPARE(column(k, "radius_m"), list[k].radius);
        QCOMPARE(column(k, "curvature_per_m"), list[k].curvature);
        QCOMPARE(column(k, "twist_rad_per_m"), list[k].twistRadPerMetre);
        QCOMPARE(column(k, "twist_rad"), list[k].twistRad);
    }
}

void TestBranchFacts::csvIgnoresTheLocale()
{
    const Skeleton skeleton = bend({0, 1, 0}, {1, 0.5, 0});
    const auto list = sectionFacts(skeleton, buildSections(skeleton, 4), 1);
    const std::string plain = sectionsCsv(list);
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    for (const char* name : {"fr_FR.UTF-8", "de_DE.UTF-8", "C.UTF-8"})
        if (std::setlocale(LC_NUMERIC, name))
            QCOMPARE(sectionsCsv(list), plain);
    std::setlocale(LC_NUMERIC, before.c_str());
}

RAMURE_SUITE(TestBranchFacts)

} // namespace tst_branch_facts

#include "tst_branch_facts.moc"
