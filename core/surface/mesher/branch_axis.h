/// \file
/// The axis of one branch as the mesher uses it: its cross-sections with frames, and, at forks, a table of
/// the curve by arc length.
#pragma once

#include "core/skeleton/sections.h"
#include "core/surface/mesher/skeleton_normalise.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace ramure {

/// A cross-section and its distance from the start of the branch, measured along the curve.
struct AxisSection : CrossSection
{
    double along = 0.0; ///< m
};

/// The curve of a branch of the mesher's skeleton (SPEC A4); \p clampOvershoot limits v0 to 1.5 times the
/// branch.
BranchCurve meshCurve(const NormalSkeleton& skeleton, Index branch, bool clampOvershoot);

/// The curve at even distances: point, tangent and radius of any arc length in a few operations.
class AxisTable
{
public:
    static constexpr int steps = 16;

    struct Place
    {
        glm::dvec3 point;
        double radius;
        glm::dvec3 tangent;
    };

    /// \p along is clamped to the branch.
    [[nodiscard]] Place at(double along) const
    {
        const auto [cell, part] = cellOf(along);
        const Place &a = m_places[cell], &b = m_places[cell + 1];
        return {a.point + (b.point - a.point) * part, a.radius + (b.radius - a.radius) * part,
                a.tangent + (b.tangent - a.tangent) * part};
    }
    [[nodiscard]] glm::dvec3 pointAt(double along) const
    {
        const auto [cell, part] = cellOf(along);
        const glm::dvec3 &a = m_places[cell].point, &b = m_places[cell + 1].point;
        return a + (b - a) * part;
    }
    [[nodiscard]] double length() const { return m_length; }
    /// Distance of a point from the tube's surface (negative inside); \p guess: an arc length near the
    /// point's foot.
    [[nodiscard]] double clearance(const glm::dvec3& point, double guess) const
    {
        return clearanceFrom(at(guess), point, guess);
    }
    /// The same where the place at \p guess is known already.
    [[nodiscard]] double clearanceFrom(Place place, const glm::dvec3& point, double guess) const;
    /// May a point be nearer to the tube than \p near (m)? Quick; seldom yes where it is not, never no where
    /// it is unless the axis bends back within a few radii.
    [[nodiscard]] bool mayBeNear(const glm::dvec3& point, double guess, double near) const
    {
        const Place place = at(guess);
        const glm::dvec3 away = point - place.point;
        const double ahead = glm::dot(away, place.tangent), reach = 1.3 * (near + place.radius);
        return glm::dot(away, away) - ahead * ahead < reach * reach;
    }
    /// How a point lies to the tube around this axis.
    struct Away
    {
        glm::dvec3 out;     ///< unit, away from the axis
        glm::dvec3 tangent; ///< of the axis beside the point
        double clearance;   ///< m, see clearance()
        double radius;      ///< m, of the tube beside the point
    };
    [[nodiscard]] Away awayFrom(const glm::dvec3& point, double guess) const;
    /// Arc length of the point of the axis nearest to \p point, found from \p guess.
    [[nodiscard]] double footOf(const glm::dvec3& point, double guess) const;

    /// \param points samples of the curve, \param distances their arc lengths, first 0, not decreasing.
    void build(const std::vector<glm::dvec3>& points, const std::vector<double>& distances,
               const MeshBranch& branch);

private:
    struct Cell
    {
        std::size_t index;
        double part;
    };
    [[nodiscard]] Cell cellOf(double along) const
    {
        const double scaled = std::clamp(along * m_stepsPerMetre, 0.0, double(steps));
        const auto cell = std::min(static_cast<std::size_t>(scaled), std::size_t(steps - 1));
        return {cell, scaled - static_cast<double>(cell)};
    }

    static constexpr double nearFoot = 0.03; ///< of the radius: from there the foot is one step away

    std::array<Place, steps + 1> m_places;
    double m_length = 0.0, m_stepsPerMetre = 0.0;
};

// Here, to be inlined: the mesher asks them several times for each vertex of a fork.

inline double AxisTable::footOf(const glm::dvec3& point, double guess) const
{
    double along = std::clamp(guess, 0.0, m_length);
    for (int round = 0; round < 4; ++round) {
        const Place place = at(along);
        const double better = std::clamp(along + glm::dot(point - place.point, place.tangent), 0.0, m_length);
        if (std::abs(better - along) < nearFoot * place.radius)
            return better;
        along = better;
    }
    return along;
}

inline double AxisTable::clearanceFrom(Place place, const glm::dvec3& point, double guess) const
{
    double along = std::clamp(guess, 0.0, m_length);
    glm::dvec3 away = point - place.point;
    double ahead = glm::dot(away, place.tangent);
    if (std::abs(ahead) > 0.25 * place.radius) {
        along = std::clamp(along + ahead, 0.0, m_length);
        place = at(along);
        away = point - place.point;
        ahead = glm::dot(away, place.tangent);
    }
    // Beyond its tip a tube ends; before its start the parent's tube takes its place.
    const double square = glm::dot(away, away);
    const bool beyond = along >= m_length && ahead > 0.0;
    return std::sqrt(std::max(beyond ? square : square - ahead * ahead, 0.0)) - place.radius;
}

inline AxisTable::Away AxisTable::awayFrom(const glm::dvec3& point, double guess) const
{
    double along = std::clamp(guess, 0.0, m_length);
    Place place = at(along);
    glm::dvec3 away = point - place.point;
    double ahead = glm::dot(away, place.tangent);
    for (int round = 0; round < 4 && std::abs(ahead) > nearFoot * place.radius; ++round) {
        const double better = std::clamp(along + ahead, 0.0, m_length);
        if (better == along)
            break;
        along = better;
        place = at(along);
        away = point - place.point;
        ahead = glm::dot(away, place.tangent);
    }
    if (!(along >= m_length && ahead > 0.0))
        away -= ahead * place.tangent;
    const double distance = std::sqrt(glm::dot(away, away));
    return {distance > 0.0 ? away * (1.0 / distance) : glm::dvec3(0.0), place.tangent,
            distance - place.radius, place.radius};
}

/// Makes sections and tables; keeps its buffers between branches.
class AxisBuilder
{
public:
    /// Sections of a branch: \p start is its parent's end frame (of a root: any frame along its tangent),
    /// turned by the branch's own roll. \p table may be null; where it is given, AxisSection::along is
    /// measured on a finer curve.
    void build(const BranchCurve& curve, const MeshBranch& branch, const Frame& start, int lengthDivisions,
               std::vector<AxisSection>& sections, AxisTable* table);

private:
    std::vector<glm::dvec3> m_points;
    std::vector<double> m_distances;
};

} // namespace ramure
