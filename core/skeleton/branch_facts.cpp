#include "core/skeleton/branch_facts.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Of a sine: below it a direction has no side to lean to.
constexpr double straightSine = 1e-12;
/// Steps of parallel transport and of the arc length between two sections. The error of the transport falls
/// with the fourth power of the step: with 32 it is far below what the table shows.
constexpr int stepsPerPiece = 32;

/// Unit vector, or zero where there is no direction.
glm::dvec3 unitOrZero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// The frame a branch is measured in: that of its parent's end, or of +Y.
Frame frameBefore(const Skeleton& skeleton, const SectionSet& sections, Index branch)
{
    const Index parent = skeleton.parent[branch];
    if (parent == noIndex)
        return {};
    const auto parentSections = sections.of(parent);
    if (!parentSections.empty())
        return parentSections.back().frame;
    const glm::dvec3 direction = unitOrZero(skeleton.p1[parent] - skeleton.p0[parent]);
    return direction == glm::dvec3(0.0) ? Frame() : frameFromTangent(direction);
}

/// Derivatives of the cubic at one parameter.
struct Derivatives
{
    glm::dvec3 first, second;
};

Derivatives derivatives(const BranchCurve& curve, double t)
{
    const glm::dvec3 chord = curve.h1 - curve.h0;
    const double u = 1.0 - t;
    return {6.0 * t * u * chord + u * (1.0 - 3.0 * t) * curve.v0 + t * (3.0 * t - 2.0) * curve.v1,
            (6.0 - 12.0 * t) * chord + (6.0 * t - 4.0) * curve.v0 + (6.0 * t - 2.0) * curve.v1};
}

double curvatureAt(const BranchCurve& curve, double t)
{
    // Scaled to one, so that twigs of a micrometre and trunks of a kilometre meet the same threshold.
    const double scale =
        std::max({glm::length(curve.h1 - curve.h0), glm::length(curve.v0), glm::length(curve.v1)});
    if (!(scale > 0.0))
        return 0.0;
    const Derivatives d = derivatives(curve, t);
    const glm::dvec3 first = d.first / scale, second = d.second / scale;
    const double speed = glm::length(first);
    if (speed <= straightSine)
        return 0.0;
    return glm::length(glm::cross(first, second)) / (speed * speed * speed) / scale;
}

/// Length of the curve from \p from to \p to: Gauss's three points.
double lengthBetween(const BranchCurve& curve, double from, double to)
{
    static const double offset = std::sqrt(0.6);
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const double sum = 5.0 * glm::length(derivatives(curve, middle - offset * half).first) +
                       8.0 * glm::length(derivatives(curve, middle).first) +
                       5.0 * glm::length(derivatives(curve, middle + offset * half).first);
    return half * sum / 9.0;
}

/// One step of parallel transport by double reflection: Wang, Juettler, Zheng, Liu, "Computation of Rotation
/// Minimizing Frames", ACM Transactions on Graphics 27 (2008). Only the normal is carried.
glm::dvec3 reflectedTwice(const glm::dvec3& normal, const CurvePoint& from, const CurvePoint& to)
{
    const glm::dvec3 way = to.point - from.point;
    const double way2 = glm::dot(way, way);
    glm::dvec3 mirrored = normal, tangent = from.tangent;
    if (way2 > 0.0) {
        mirrored -= 2.0 / way2 * glm::dot(way, normal) * way;
        tangent -= 2.0 / way2 * glm::dot(way, from.tangent) * way;
    }
    const glm::dvec3 second = to.tangent - tangent;
    const double second2 = glm::dot(second, second);
    if (second2 > 0.0)
        mirrored -= 2.0 / second2 * glm::dot(second, mirrored) * second;
    return mirrored;
}

/// Angle from \p from to \p to about \p axis, both about perpendicular to it; in (-pi, pi].
double angleAbout(const glm::dvec3& axis, const glm::dvec3& from, const glm::dvec3& to)
{
    return maths::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
}

/// What lies between two neighbouring sections.
struct Piece
{
    double length = 0.0;
    double twistRad = 0.0;
};

Piece pieceBetween(const BranchCurve& curve, const CrossSection& from, const CrossSection& to)
{
    Piece piece;
    glm::dvec3 normal = from.frame.normal;
    CurvePoint at{from.centre, from.frame.tangent};
    double t = from.t;
    for (int i = 1; i <= stepsPerPiece; ++i) {
        const double next = i == stepsPerPiece ? to.t : from.t + (to.t - from.t) * i / stepsPerPiece;
        const CurvePoint there = hermite(curve.h0, curve.h1, curve.v0, curve.v1, next);
        normal = reflectedTwice(normal, at, there);
        piece.length += lengthBetween(curve, t, next);
        at = there;
        t = next;
    }
    piece.twistRad = angleAbout(to.frame.tangent, normal, to.frame.normal);
    return piece;
}

/// The roll of a branch's first frame against the frame it continues.
double rollAtStart(const Skeleton& skeleton, const SectionSet& sections, Index branch)
{
    const Frame& first = sections.of(branch).front().frame;
    const Frame before = transported(frameBefore(skeleton, sections, branch), first.tangent);
    return angleAbout(first.tangent, before.normal, first.normal);
}

void appendNumber(std::string& text, double value)
{
    if (!text.empty() && text.back() != '\n')
        text += ',';
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text.append(buffer.data(), end);
}

void appendVector(std::string& text, const glm::dvec3& v)
{
    appendNumber(text, v.x);
    appendNumber(text, v.y);
    appendNumber(text, v.z);
}

} // namespace

BranchFacts branchFacts(const Skeleton& skeleton, const ChildLists& children, const SectionSet& sections,
                        std::span<const double> masses, Index branch)
{
    BranchFacts facts;
    facts.branch = branch;
    facts.parent = skeleton.parent[branch];
    const auto below = children.of(branch);
    facts.children.assign(below.begin(), below.end());
    facts.p0 = skeleton.p0[branch];
    facts.p1 = skeleton.p1[branch];
    facts.a0 = skeleton.a0[branch];
    facts.a1 = skeleton.a1[branch];
    facts.length = skeleton.length(branch);
    facts.order = skeleton.level[branch];
    facts.mass = branch < masses.size() ? masses[branch] : 0.0;

    const glm::dvec3 direction = unitOrZero(facts.p1 - facts.p0);
    if (direction == glm::dvec3(0.0))
        return facts;
    const Frame frame = frameBefore(skeleton, sections, branch);
    const double sine = glm::length(glm::cross(frame.tangent, direction));
    facts.angleRad = maths::atan2(sine, glm::dot(frame.tangent, direction));
    if (sine > straightSine)
        facts.azimuthRad =
            maths::atan2(glm::dot(direction, frame.binormal), glm::dot(direction, frame.normal));
    return facts;
}

std::vector<SectionFacts> sectionFacts(const Skeleton& skeleton, const SectionSet& sections, Index branch)
{
    std::vector<SectionFacts> result;
    const std::size_t end = (std::size_t(branch) + 1) * sections.perBranch;
    if (branch >= skeleton.size() || sections.perBranch == 0 || end > sections.sections.size())
        return result;
    const auto all = sections.of(branch);
    const BranchCurve curve = branchCurve(skeleton, branch);
    result.reserve(all.size());
    double twist = rollAtStart(skeleton, sections, branch), arcLength = 0.0;
    for (Index k = 0; k < all.size(); ++k) {
        const CrossSection& section = all[k];
        double perMetre = 0.0;
        if (k > 0) {
            const Piece piece = pieceBetween(curve, all[k - 1], section);
            twist += piece.twistRad;
            arcLength += piece.length;
            perMetre = piece.length > 0.0 ? piece.twistRad / piece.length : 0.0;
            if (k == 1)
                result.front().twistRadPerMetre = perMetre;
        }
        result.push_back({k, section.t, arcLength, section.centre, section.frame.tangent,
                          section.frame.normal, section.frame.binormal, section.radius,
                          curvatureAt(curve, section.t), twist, perMetre});
    }
    return result;
}

std::string sectionsCsv(std::span<const SectionFacts> facts)
{
    std::string text =
        "section,t,arc_length_m,centre_x_m,centre_y_m,centre_z_m,tangent_x,tangent_y,tangent_z,"
        "normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z,radius_m,curvature_per_m,"
        "twist_rad_per_m,twist_rad\n";
    for (const SectionFacts& section : facts) {
        appendNumber(text, section.section + 1.0);
        appendNumber(text, section.t);
        appendNumber(text, section.arcLength);
        appendVector(text, section.centre);
        appendVector(text, section.tangent);
        appendVector(text, section.normal);
        appendVector(text, section.binormal);
        appendNumber(text, section.radius);
        appendNumber(text, section.curvature);
        appendNumber(text, section.twistRadPerMetre);
        appendNumber(text, section.twistRad);
        text += '\n';
    }
    return text;
}

} // namespace ramure
