/// \file
/// Cross-sections of every branch with rotation-minimising frames (SPEC A5), in tree space.
#pragma once

#include "core/math/frame.h"
#include "core/math/hermite.h"
#include "core/skeleton/skeleton.h"
#include <span>
#include <vector>

namespace ramure {

struct CrossSection
{
    glm::dvec3 centre{0.0};
    Frame frame;
    double t = 0.0;      ///< curve parameter in [0, 1]
    double radius = 0.0; ///< m
};

/// perBranch sections for each branch, those of branch i at [i * perBranch, (i + 1) * perBranch), t = k /
/// (perBranch - 1).
struct SectionSet
{
    Index perBranch = 0;
    std::vector<CrossSection> sections;

    [[nodiscard]] std::span<const CrossSection> of(Index branch) const
    {
        return {sections.data() + std::size_t(branch) * perBranch, perBranch};
    }
};

/// The curve of a branch: h0 = p0, h1 = p1, v0 = the parent's p1 - p0 (its own for a root), v1 = p1 - p0.
struct BranchCurve
{
    glm::dvec3 h0, h1, v0, v1;
};
BranchCurve branchCurve(const Skeleton& skeleton, Index branch);

/// \param lengthDivisions sections per branch, both ends included, >= 2.
/// The frame is carried along each curve and from a parent's last section to its children's first.
/// \param rollRad an extra turn about the tangent per branch, empty = none; it goes on to the children.
SectionSet buildSections(const Skeleton& skeleton, int lengthDivisions, std::span<const double> rollRad = {});

/// Point k of n on a section's circle: centre + radius * (cos(2 pi k / n) normal + sin(2 pi k / n) binormal).
glm::dvec3 sectionPoint(const CrossSection& section, int k, int radialDivisions);

} // namespace ramure
