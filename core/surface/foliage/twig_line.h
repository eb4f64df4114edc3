/// \file
/// The centre line of a twig (SPEC A4) by its length, with frames that do not turn about it. Internal to the
/// placement of leaves and fruit.
#pragma once

#include "core/math/frame.h"
#include "core/math/hermite.h"
#include "core/skeleton/sections.h"
#include "core/skeleton/skeleton.h"
#include <array>

namespace ramure {

inline constexpr glm::dvec3 sky(0.0, 1.0, 0.0);

/// The share of \p v across the unit vector \p way, of length 1; \p otherwise where nothing is left.
glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& way, const glm::dvec3& otherwise);

class TwigLine
{
public:
    static constexpr std::size_t pieces = 12;

    TwigLine(const Skeleton& skeleton, Index twig);

    struct Place
    {
        glm::dvec3 centre;
        Frame frame;
        double radius;
    };
    [[nodiscard]] double length() const { return m_lengths[pieces]; }
    [[nodiscard]] Place at(double along) const;

private:
    BranchCurve m_curve;
    std::array<glm::dvec3, pieces + 1> m_points;
    std::array<Frame, pieces + 1> m_frames;
    std::array<double, pieces + 1> m_lengths{};
    double m_radius0, m_radius1;
};

/// TwigLine::length(), without its frames.
double twigLength(const Skeleton& skeleton, Index twig);
/// Where along a twig the first node may stand: past what the fork covers.
double firstNode(const Skeleton& skeleton, Index twig);

} // namespace ramure
