#include "tests/support/skeleton_zoo.h"

#include "tests/support/skeleton_grower.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

namespace ramure::test {
namespace {

constexpr double pi = std::numbers::pi;

void randomTree(Grower& g, int perBranch, int most)
{
    g.root(glm::dvec3(0.0), g.direction() * g.range(0.3, 1.5), g.radius(), g.radius());
    g.growTo(static_cast<Index>(g.between(1, most)), static_cast<Index>(perBranch));
}

void manyChildren(Grower& g)
{
    Index parent = g.root();
    for (int fork = g.between(1, 3); fork > 0; --fork) {
        const int children = g.between(6, 20);
        for (int i = 0; i < children; ++i)
            g.child(parent, g.tilted(g.axis(parent), g.range(0.0, 2.6)) * g.range(0.2, 1.2));
        parent = g.skeleton().size() - 1 - g.random().below(static_cast<std::uint32_t>(children));
    }
}

void bush(Grower& g)
{
    const Index parent = g.root();
    const int children = g.between(21, 64);
    const double open = g.range(0.3, pi);
    for (int i = 0; i < children; ++i)
        g.child(parent, g.tilted(g.axis(parent), g.range(0.0, open)) * g.range(0.2, 1.2));
    g.growTo(g.skeleton().size() + static_cast<Index>(g.between(0, 10)), 64);
}

void roots(Grower& g)
{
    const int count = g.between(2, 6);
    for (int i = 0; i < count; ++i) {
        const bool again = i > 0 && g.chance(0.4);
        const Index twin = g.random().below(std::max<Index>(1, g.skeleton().size()));
        if (again) { // the ends of any branch there is, of a former root more often than not
            const Skeleton& s = g.skeleton();
            const Index of = g.chance(0.7) ? 0 : twin;
            const glm::dvec3 from = s.p0[of], offset = s.p1[of] - s.p0[of];
            const double a0 = s.a0[of], a1 = s.a1[of];
            g.root(from, offset, a0, a1);
        } else {
            const glm::dvec3 from = g.chance(0.5) ? glm::dvec3(0.0) : g.direction() * g.range(0.0, 3.0);
            g.root(from, g.direction() * g.range(0.3, 1.5), g.radius(), g.radius());
        }
        g.growTo(g.skeleton().size() + static_cast<Index>(g.between(0, 6)), 5);
    }
}

void coincidentSiblings(Grower& g)
{
    g.root();
    const int forks = g.between(1, 6);
    for (int f = 0; f < forks; ++f) {
        const Index parent = g.random().below(g.skeleton().size());
        const glm::dvec3 offset = g.tilted(g.axis(parent), g.range(0.0, 2.5)) * g.range(0.2, 1.0);
        const int copies = g.between(2, 6);
        for (int i = 0; i < copies; ++i)
            if (g.chance(0.5))
                g.child(parent, offset, g.skeleton().a1[parent], 0.8 * g.skeleton().a1[parent]);
            else
                g.child(parent, offset, g.radius(), g.radius());
        g.growTo(g.skeleton().size() + static_cast<Index>(g.between(0, 4)), 20);
    }
}

void nearTwins(Grower& g)
{
    g.root();
    const int forks = g.between(1, 6);
    for (int f = 0; f < forks; ++f) {
        const Index parent = g.random().below(g.skeleton().size());
        const glm::dvec3 along = g.tilted(g.axis(parent), g.range(0.0, 2.0));
        const double length = g.range(0.3, 1.0);
        const int twins = g.between(2, 7);
        for (int i = 0; i < twins; ++i) {
            const double factor = g.chance(0.5)   ? 1.0
                                  : g.chance(0.5) ? g.range(0.95, 1.05)
                                                  : g.range(0.2, 3.0);
            g.child(parent, g.tilted(along, g.logRange(1e-5, 0.2)) * length * factor);
        }
        g.growTo(g.skeleton().size() + static_cast<Index>(g.between(0, 3)), 20);
    }
}

void zeroLength(Grower& g)
{
    g.root();
    const int more = g.between(1, 30);
    for (int i = 0; i < more; ++i) {
        const Index parent = g.random().below(g.skeleton().size());
        if (g.chance(0.45))
            g.child(parent, glm::dvec3(0.0), g.radius(), g.radius());
        else
            g.randomChild(parent);
    }
}

void zeroRoots(Grower& g)
{
    const int count = g.between(1, 3);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 from = g.chance(0.5) ? glm::dvec3(0.0) : g.direction();
        Index last = g.root(from, glm::dvec3(0.0), g.radius(), g.radius());
        for (int chain = g.between(0, 3); chain > 0; --chain)
            last = g.child(last, glm::dvec3(0.0), g.radius(), g.radius());
        for (int children = g.between(0, 5); children > 0; --children)
            g.child(last, g.direction() * (g.chance(0.15) ? 0.0 : g.range(0.2, 1.0)));
    }
}

void zeroRadii(Grower& g)
{
    const bool all = g.chance(0.25);
    g.root(glm::dvec3(0.0), g.direction() * g.range(0.3, 1.5), g.radius(), g.radius());
    g.growTo(static_cast<Index>(g.between(1, 25)), 6);
    for (Index i = 0; i < g.skeleton().size(); ++i) {
        if (all || g.chance(0.4))
            g.skeleton().a0[i] = 0.0;
        if (all || g.chance(0.4))
            g.skeleton().a1[i] = 0.0;
    }
}

void antiparallel(Grower& g)
{
    g.root();
    const int more = g.between(1, 12);
    for (int i = 0; i < more; ++i) {
        const Index parent = g.random().below(g.skeleton().size());
        const glm::dvec3 back = g.skeleton().p0[parent] - g.skeleton().p1[parent];
        g.child(parent, back * (g.chance(0.4) ? 1.0 : g.range(0.2, 2.5)));
        for (int siblings = g.between(0, 4); siblings > 0; --siblings)
            g.randomChild(parent);
    }
}

void sameDirection(Grower& g)
{
    g.root();
    const int forks = g.between(1, 5);
    for (int f = 0; f < forks; ++f) {
        const Index parent = g.random().below(g.skeleton().size());
        const glm::dvec3 ahead = g.chance(0.6) ? g.axis(parent) : g.direction();
        const double length = g.range(0.2, 1.0);
        const int children = g.between(2, 6);
        for (int i = 0; i < children; ++i)
            g.child(parent, ahead * length * (g.chance(0.5) ? double(g.between(1, 4)) : g.range(0.3, 3.0)));
        for (int siblings = g.between(0, 2); siblings > 0; --siblings)
            g.randomChild(parent);
    }
}

void planarFan(Grower& g)
{
    const Index root = g.root(glm::dvec3(0.0), {0.0, 1.0, 0.0}, 0.1, g.radius());
    Index parent = root;
    for (int fork = g.between(1, 4); fork > 0; --fork) {
        const glm::dvec3 ahead = g.axis(parent);
        const glm::dvec3 side(ahead.y, -ahead.x, 0.0); // the fans all lie in one plane
        const int children = g.between(2, 12);
        const double step = g.chance(0.3)   ? pi / 2.0
                            : g.chance(0.3) ? pi / 4.0
                                            : g.range(0.02, 2.0 * pi / children);
        const double from = g.chance(0.5)   ? -step * (children - 1) / 2.0
                            : g.chance(0.5) ? 0.0
                                            : g.range(-pi, pi);
        Index last = parent;
        for (int i = 0; i < children; ++i) {
            const double angle = from + step * i;
            last = g.child(parent, (std::cos(angle) * ahead + std::sin(angle) * side) * g.range(0.4, 0.8));
        }
        parent = g.chance(0.5) ? last : last - static_cast<Index>(g.between(0, children - 1));
    }
}

void symmetric(Grower& g)
{
    Index parent = g.root(glm::dvec3(0.0), {0.0, 1.0, 0.0}, 0.1, 0.1);
    const double length = g.chance(0.5) ? 1.0 : g.range(0.3, 1.0);
    for (int fork = g.between(1, 3); fork > 0; --fork) {
        const Index before = g.skeleton().size();
        if (g.chance(0.5)) {
            static constexpr std::array<std::array<int, 3>, 6> axes{
                {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}}};
            for (const auto& a : axes)
                if (g.chance(0.75))
                    g.child(parent, glm::dvec3(a[0], a[1], a[2]) * length);
        } else {
            const int cones = g.between(1, 3), around = g.between(2, 12);
            for (int cone = 1; cone <= cones; ++cone)
                for (int i = 0; i < around; ++i) {
                    const double open = 0.45 * cone, azimuth = 2.0 * pi * i / around;
                    g.child(parent, length * glm::dvec3(std::sin(open) * std::cos(azimuth), std::cos(open),
                                                        std::sin(open) * std::sin(azimuth)));
                }
        }
        const Index made = g.skeleton().size() - before;
        if (made > 0)
            parent = before + g.random().below(made);
    }
}

void shortChildren(Grower& g)
{
    g.root();
    const int more = g.between(3, 25);
    for (int i = 0; i < more; ++i) {
        const Index parent = g.random().below(g.skeleton().size());
        const double length = std::max(1e-4, g.skeleton().length(parent)) * (g.chance(0.7) ? 0.05 : 1.0);
        g.child(parent, g.tilted(g.axis(parent), g.range(0.0, 2.8)) * length);
    }
}

void thick(Grower& g)
{
    g.root(glm::dvec3(0.0), g.direction() * g.range(0.05, 1.0), g.logRange(0.1, 5.0), g.logRange(0.1, 5.0));
    const int more = g.between(0, 20);
    for (int i = 0; i < more; ++i) {
        const Index parent = g.random().below(g.skeleton().size());
        const double length = g.logRange(0.05, 1.0), a = length * g.logRange(0.5, 20.0);
        g.child(parent, g.direction() * length, a, a * g.range(0.3, 1.0));
    }
}

void radiusJumps(Grower& g)
{
    randomTree(g, 5, 25);
    for (Index i = 0; i < g.skeleton().size(); ++i) {
        g.skeleton().a0[i] = g.logRange(1e-4, 1.0);
        g.skeleton().a1[i] = g.logRange(1e-4, 1.0);
    }
}

void almostZero(Grower& g)
{
    g.root(glm::dvec3(0.0), g.direction() * (g.chance(0.3) ? g.logRange(1e-9, 1e-2) : 1.0), g.radius(),
           g.radius());
    const int more = g.between(1, 25);
    for (int i = 0; i < more; ++i) {
        const Index parent = g.random().below(g.skeleton().size());
        g.child(parent, g.direction() * (g.chance(0.5) ? g.logRange(1e-9, 1e-2) : g.range(0.2, 1.0)));
    }
}

void thereAndBack(Grower& g)
{
    Index last = g.root(glm::dvec3(0.0), {0.0, 1.0, 0.0}, 0.1, 0.1);
    const int more = g.between(2, 16);
    for (int i = 0; i < more; ++i) {
        const Index target = g.random().below(g.skeleton().size());
        const glm::dvec3 to = g.chance(0.7) ? g.skeleton().p0[target] : g.skeleton().p1[target];
        last = g.child(last, to - g.skeleton().p1[last], 0.1, 0.1);
        if (g.chance(0.3))
            last = g.child(last, g.direction(), 0.1, 0.1);
        if (g.chance(0.2))
            last = g.random().below(g.skeleton().size());
    }
}

void deepChain(Grower& g)
{
    Index last = g.root();
    const int count = g.chance(0.15) ? g.between(1000, 3000) : g.between(20, 300);
    const double bend = g.logRange(1e-6, 1.0), step = g.range(0.05, 0.5);
    for (int i = 0; i < count; ++i) {
        last = g.child(last, g.tilted(g.axis(last), bend) * step, 0.05, 0.05);
        if (g.chance(0.02))
            g.randomChild(last);
    }
}

void scaled(Grower& g, double factor, const glm::dvec3& offset)
{
    randomTree(g, 5, 25);
    Skeleton& s = g.skeleton();
    for (Index i = 0; i < s.size(); ++i) {
        s.p0[i] = s.p0[i] * factor + offset;
        s.p1[i] = s.p1[i] * factor + offset;
        s.a0[i] *= factor;
        s.a1[i] *= factor;
    }
}

void farOff(Grower& g)
{
    const glm::dvec3 away = g.direction() * g.logRange(1.0, 200.0);
    scaled(g, 1.0, away);
}

void mixedChild(Grower& g, Index parent)
{
    Skeleton& s = g.skeleton();
    const glm::dvec3 along = s.p1[parent] - s.p0[parent];
    const Index sibling = s.size() - 1;
    switch (g.random().below(11)) {
    case 0:
        g.child(parent, glm::dvec3(0.0));
        break;
    case 1:
        g.child(parent, -along);
        break;
    case 2:
        g.child(parent, along);
        break;
    case 3:
        g.child(parent, along * 0.05);
        break;
    case 4:
        g.child(parent, g.direction() * g.logRange(1e-9, 1e-2));
        break;
    case 5:
        g.child(parent, g.direction(), g.logRange(1e-4, 1.0), 0.0);
        break;
    case 6:
        g.child(parent, g.direction() * 0.3, 1.0, 1.0);
        break;
    case 7:
        g.child(parent, s.p1[sibling] - s.p0[sibling]);
        break;
    case 8:
        g.child(parent, g.tilted(g.axis(sibling), 0.01) * s.length(sibling));
        break;
    case 9:
        for (int i = 0; i < 8; ++i)
            g.child(parent, g.direction() * 0.5);
        break;
    default:
        g.randomChild(parent);
    }
}

void mixture(Grower& g)
{
    g.root();
    const int more = g.between(2, 50);
    for (int i = 0; i < more; ++i) {
        if (g.chance(0.03))
            g.root(g.direction(), g.direction() * g.range(0.0, 1.0), g.radius(), g.radius());
        mixedChild(g, g.random().below(g.skeleton().size()));
    }
}

struct Row
{
    ZooFamily family;
    const char* name;
    void (*grow)(Grower&);
};

constexpr std::array<Row, zooFamilyCount> rows{{
    {ZooFamily::FewChildren, "FewChildren", [](Grower& g) { randomTree(g, 5, 60); }},
    {ZooFamily::ManyChildren, "ManyChildren", manyChildren},
    {ZooFamily::Bush, "Bush", bush},
    {ZooFamily::Roots, "Roots", roots},
    {ZooFamily::CoincidentSiblings, "CoincidentSiblings", coincidentSiblings},
    {ZooFamily::NearTwins, "NearTwins", nearTwins},
    {ZooFamily::ZeroLength, "ZeroLength", zeroLength},
    {ZooFamily::ZeroRoots, "ZeroRoots", zeroRoots},
    {ZooFamily::ZeroRadii, "ZeroRadii", zeroRadii},
    {ZooFamily::Antiparallel, "Antiparallel", antiparallel},
    {ZooFamily::SameDirection, "SameDirection", sameDirection},
    {ZooFamily::PlanarFan, "PlanarFan", planarFan},
    {ZooFamily::Symmetric, "Symmetric", symmetric},
    {ZooFamily::ShortChildren, "ShortChildren", shortChildren},
    {ZooFamily::Thick, "Thick", thick},
    {ZooFamily::RadiusJumps, "RadiusJumps", radiusJumps},
    {ZooFamily::AlmostZero, "AlmostZero", almostZero},
    {ZooFamily::ThereAndBack, "ThereAndBack", thereAndBack},
    {ZooFamily::DeepChain, "DeepChain", deepChain},
    {ZooFamily::TinyScale, "TinyScale", [](Grower& g) { scaled(g, 1e-6, glm::dvec3(0.0)); }},
    {ZooFamily::HugeScale, "HugeScale", [](Grower& g) { scaled(g, 1e6, glm::dvec3(0.0)); }},
    {ZooFamily::FarOff, "FarOff", farOff},
    {ZooFamily::Grammar, "Grammar", growGrammar},
    {ZooFamily::Mixture, "Mixture", mixture},
}};

} // namespace

const char* zooName(ZooFamily family)
{
    return rows[static_cast<std::size_t>(family)].name;
}

Skeleton zooSkeleton(ZooFamily family, std::uint64_t seed)
{
    Grower g(static_cast<std::uint64_t>(family), seed);
    rows[static_cast<std::size_t>(family)].grow(g);
    return std::move(g.skeleton());
}

Specimen specimen(std::uint64_t number)
{
    Specimen s;
    const auto family = static_cast<ZooFamily>(number % zooFamilyCount);
    const std::uint64_t seed = number / zooFamilyCount;
    s.skeleton = zooSkeleton(family, seed);
    Random random(number, RandomStream::Test, zooFamilyCount);
    static constexpr std::array<int, 8> radial{3, 4, 5, 6, 8, 8, 11, 16};
    static constexpr std::array<int, 6> length{2, 3, 4, 4, 5, 9};
    s.options.radialDivisions = radial[random.below(radial.size())];
    s.options.lengthDivisions = length[random.below(length.size())];
    s.options.nearTwinRatio = random.below(3) == 0 ? 0.0 : 0.25;
    s.options.clampOvershoot = random.below(3) == 0;
    if (random.below(4) == 0)
        for (Index i = 0; i < s.skeleton.size(); ++i)
            s.rollRad.push_back(random.below(2) == 0 ? 0.0 : random.range(-2.0 * pi, 2.0 * pi));
    static constexpr std::array<double, 5> softness{0.0, 0.3, 0.8, 0.8, 1.0};
    static constexpr std::array<double, 5> reach{0.2, 1.0, 1.0, 2.0, 4.0};
    s.options.forkSoftness = softness[random.below(softness.size())];
    s.options.forkReach = reach[random.below(reach.size())];
    static constexpr std::array<double, 4> leastRadius{0.0, 0.0, 0.25e-3, 0.05};
    s.options.leastRadius = leastRadius[random.below(leastRadius.size())];
    static constexpr std::array<double, 4> forkLength{0.0, 1.0, 1.0, 5.0};
    s.options.forkLength = forkLength[random.below(forkLength.size())];
    static constexpr std::array<double, 4> collar{0.0, 0.0, 0.5, 2.0};
    s.options.collar = collar[random.below(collar.size())];
    static constexpr std::array<int, 5> roots{0, 0, 3, 7, 16};
    s.options.roots = roots[random.below(roots.size())];
    s.options.rootLength = random.range(0.1, 4.0);
    s.options.rootHeight = random.range(0.1, 4.0);
    s.options.fairing = random.below(2) == 0 ? 0.0 : random.range(0.0, 1.0);
    s.options.ridge = random.below(2) == 0 ? 0.0 : random.range(0.0, 0.2);
    std::ostringstream name;
    name << "specimen " << number << ": " << zooName(family) << " seed " << seed << ", " << s.skeleton.size()
         << " branches, " << s.options.radialDivisions << " radial x " << s.options.lengthDivisions
         << " length, softness " << s.options.forkSoftness << " over " << s.options.forkReach << ", twins "
         << s.options.nearTwinRatio << ", least radius " << s.options.leastRadius << ", fork length "
         << s.options.forkLength << ", collar " << s.options.collar << ", " << s.options.roots << " roots "
         << s.options.rootLength << " x " << s.options.rootHeight << ", fairing " << s.options.fairing
         << ", ridge " << s.options.ridge << (s.options.clampOvershoot ? ", clamped" : "")
         << (s.rollRad.empty() ? "" : ", rolled");
    s.name = name.str();
    return s;
}

std::uint64_t fuzzCount(std::uint64_t usual)
{
    const char* text = std::getenv("RAMURE_FUZZ_COUNT");
    const std::uint64_t wanted = text ? std::strtoull(text, nullptr, 10) : 0;
    return wanted > 0 ? wanted : usual;
}

} // namespace ramure::test
