#include "widgets/view/render/line_art.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ramure {
namespace {

using Colour = glm::u8vec4;

constexpr Colour nodeColour{58, 40, 26, 255};
constexpr Colour removedColour{226, 38, 38, 255};
constexpr Colour circleColour{24, 78, 119, 230};
constexpr Colour seamColour{214, 64, 52, 120};
constexpr Colour curveColour{74, 46, 22, 255};
constexpr Colour tangentColour{36, 92, 232, 255};
constexpr Colour normalColour{224, 44, 40, 255};
constexpr Colour binormalColour{34, 158, 58, 255};
constexpr Colour inspectColour{255, 138, 20, 255}, pointedColour{255, 237, 199, 255},
    goesColour{255, 58, 42, 255};

/// From the dark trunk to the light twigs.
Colour levelColour(Index level)
{
    constexpr glm::vec3 trunk{82.0f, 50.0f, 24.0f};
    constexpr glm::vec3 twig{196.0f, 146.0f, 62.0f};
    const float t = 1.0f - std::exp(-0.32f * float(level));
    return {glm::u8vec3(glm::mix(trunk, twig, t) + 0.5f), 255};
}

void addLine(LineSet& set, const glm::dvec3& a, const glm::dvec3& b, float width, Colour colour, Index branch)
{
    set.segments.push_back({glm::vec3(a), glm::vec3(b), width, width, colour, branch});
    set.box.add(a);
    set.box.add(b);
}

/// A shaft and a head that narrows to its point.
void addArrow(LineSet& set, const glm::dvec3& from, const glm::dvec3& way, float width, Colour colour)
{
    const glm::dvec3 neck = from + 0.74 * way;
    addLine(set, from, neck, width, colour, noIndex);
    addLine(set, neck, from + way, width, colour, noIndex);
    set.segments.back().widthA = 4.0f * width;
    set.segments.back().widthB = 0.0f;
}

/// Long enough to be seen on a hair-thin twig, short enough not to hide a thick trunk's neighbours.
double arrowLength(double radius, double branchLength)
{
    return std::max(std::min(1.8 * radius, 0.5 * branchLength), 0.12 * branchLength);
}

void addFrame(LineSet& set, const CrossSection& section, double length, float width)
{
    addArrow(set, section.centre, length * section.frame.tangent, width, tangentColour);
    addArrow(set, section.centre, length * section.frame.normal, width, normalColour);
    addArrow(set, section.centre, length * section.frame.binormal, width, binormalColour);
}

void addCircle(LineSet& set, const CrossSection& section, int points, float width, Colour colour,
               Index branch)
{
    glm::dvec3 last = sectionPoint(section, points - 1, points);
    for (int k = 0; k < points; ++k) {
        const glm::dvec3 next = sectionPoint(section, k, points);
        addLine(set, last, next, width, colour, branch);
        last = next;
    }
}

Index idOf(std::span<const Index> ids, Index branch)
{
    return branch < ids.size() ? ids[branch] : branch;
}

constexpr int curveSteps = 8;

void addCurve(LineSet& set, const Skeleton& skeleton, Index branch, float width, Colour colour, Index id)
{
    const BranchCurve curve = branchCurve(skeleton, branch);
    glm::dvec3 last = curve.h0;
    for (int k = 1; k <= curveSteps; ++k) {
        const glm::dvec3 next = hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(k) / curveSteps).point;
        addLine(set, last, next, width, colour, id);
        last = next;
    }
}

/// The sections must be those of this skeleton; results of two stages may differ for a moment.
bool fits(const Skeleton& skeleton, const SectionSet& sections)
{
    return sections.perBranch > 0 &&
           sections.sections.size() == std::size_t(skeleton.size()) * sections.perBranch;
}

} // namespace

LineSet skeletonLines(const Skeleton& skeleton, std::span<const Index> ids)
{
    LineSet set;
    set.segments.reserve(skeleton.size());
    const double thickest = std::accumulate(skeleton.a0.begin(), skeleton.a0.end(), 1e-12,
                                            [](double a, double b) { return std::max(a, b); });
    const auto width = [thickest](double radius) {
        return float(1.4 + 3.6 * std::clamp(radius / thickest, 0.0, 1.0));
    };
    for (Index i = 0; i < skeleton.size(); ++i) {
        addLine(set, skeleton.p0[i], skeleton.p1[i], width(skeleton.a0[i]), levelColour(skeleton.level[i]),
                idOf(ids, i));
        set.segments.back().widthB = width(skeleton.a1[i]);
    }
    return set;
}

PointSet nodeMarks(const Skeleton& skeleton, std::span<const Index> ids)
{
    PointSet set;
    set.points.reserve(skeleton.size());
    const auto add = [&set, &ids](const glm::dvec3& at, Index branch) {
        set.points.push_back({glm::vec3(at), 4.5f, nodeColour, idOf(ids, branch)});
        set.box.add(at);
    };
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (skeleton.parent[i] == noIndex)
            add(skeleton.p0[i], i);
        add(skeleton.p1[i], i);
    }
    return set;
}

PointSet removedMarks(const Skeleton& before, const SimplifiedSkeleton& after)
{
    PointSet set;
    if (after.mergedInto.size() != before.size())
        return set;
    for (Index i = 0; i < before.size(); ++i) {
        const Index parent = before.parent[i];
        if (parent == noIndex || after.mergedInto[parent] != after.mergedInto[i])
            continue;
        set.points.push_back({glm::vec3(before.p0[i]), 7.0f, removedColour, noIndex});
        set.box.add(before.p0[i]);
    }
    return set;
}

LineSet sectionLines(const Skeleton& skeleton, const SectionSet& sections, int radialDivisions)
{
    LineSet set;
    if (!fits(skeleton, sections))
        return set;
    const int points = std::max(3, radialDivisions);
    set.segments.reserve(skeleton.size() *
                         (curveSteps + std::size_t(sections.perBranch) * std::size_t(points + 1)));
    for (Index i = 0; i < skeleton.size(); ++i) {
        addCurve(set, skeleton, i, 1.6f, curveColour, i);
        const auto ofBranch = sections.of(i);
        for (std::size_t k = 0; k < ofBranch.size(); ++k) {
            addCircle(set, ofBranch[k], points, 1.3f, circleColour, i);
            if (k > 0)
                addLine(set, sectionPoint(ofBranch[k - 1], 0, points), sectionPoint(ofBranch[k], 0, points),
                        1.2f, seamColour, i);
        }
    }
    return set;
}

LineSet frameArrows(const Skeleton& skeleton, const SectionSet& sections, std::span<const Index> branches)
{
    LineSet set;
    if (!fits(skeleton, sections))
        return set;
    for (const Index branch : branches) {
        if (branch >= skeleton.size())
            continue;
        for (const CrossSection& section : sections.of(branch))
            addFrame(set, section, arrowLength(section.radius, skeleton.length(branch)), 1.6f);
    }
    return set;
}

LineSet inspectedLines(const Skeleton& skeleton, const SectionSet& sections, Index branch, Index section,
                       int radialDivisions)
{
    LineSet set;
    if (!fits(skeleton, sections) || branch >= skeleton.size() || section >= sections.perBranch)
        return set;
    const CrossSection& at = sections.of(branch)[section];
    const double length = arrowLength(at.radius, skeleton.length(branch));
    const double half = std::max(1.5 * at.radius, 0.8 * length);
    addCircle(set, at, std::max(3, radialDivisions), 3.0f, inspectColour, noIndex);
    constexpr int cells = 4;
    for (int i = 0; i <= cells; ++i) {
        const double step = half * (2.0 * i / cells - 1.0);
        const bool rim = i == 0 || i == cells;
        const Colour colour{inspectColour.r, inspectColour.g, inspectColour.b, rim ? 255 : 110};
        const glm::dvec3& u = at.frame.normal;
        const glm::dvec3& v = at.frame.binormal;
        addLine(set, at.centre + step * u - half * v, at.centre + step * u + half * v, rim ? 2.0f : 1.0f,
                colour, noIndex);
        addLine(set, at.centre + step * v - half * u, at.centre + step * v + half * u, rim ? 2.0f : 1.0f,
                colour, noIndex);
    }
    addFrame(set, at, 1.35 * std::max(length, half), 2.6f);
    return set;
}

LineSet branchCurves(const Skeleton& skeleton, std::span<const Index> branches, CurveColour kind)
{
    constexpr float width = 2.0f;
    const Colour colour = kind == CurveColour::Goes      ? goesColour
                          : kind == CurveColour::Pointed ? pointedColour
                                                         : inspectColour;
    LineSet set;
    for (const Index branch : branches) {
        if (branch >= skeleton.size())
            continue;
        if (branches.size() > mostCurves)
            addLine(set, skeleton.p0[branch], skeleton.p1[branch], width, colour, noIndex);
        else
            addCurve(set, skeleton, branch, width, colour, noIndex);
    }
    return set;
}

} // namespace ramure
