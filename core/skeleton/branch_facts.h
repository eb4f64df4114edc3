/// \file
/// The inspector's facts about one branch and its cross-sections. Tree space, metres, radians. Nothing here
/// fails: a branch without length and a curve of one point have facts too, and every "none" is stated.
#pragma once

#include "core/skeleton/sections.h"
#include "core/skeleton/skeleton.h"
#include <span>
#include <string>
#include <vector>

namespace ramure {

struct BranchFacts
{
    Index branch = noIndex;
    Index parent = noIndex;      ///< noIndex: a root
    std::vector<Index> children; ///< ascending
    glm::dvec3 p0{0.0}, p1{0.0};
    double a0 = 0.0, a1 = 0.0;
    double length = 0.0;
    /// Between the branch's direction and the tangent at its parent's end; of a root, and +Y. In [0, pi]; 0
    /// for a branch without length.
    double angleRad = 0.0;
    /// In the frame at the parent's end (its last cross-section, hand-made roll included): from its normal
    /// towards its binormal, atan2(d . binormal, d . normal) of the branch's direction d. A root is measured
    /// in the frame of +Y: from +X towards -Z. In (-pi, pi]; 0 where the branch goes straight on or straight
    /// back.
    double azimuthRad = 0.0;
    Index order = 0;
    double mass = 0.0; ///< SPEC A7, no unit
};

/// \param children of \p skeleton.
/// \param sections of the same skeleton; an empty set gives the azimuth in frameFromTangent of the parent's
/// direction. \param masses by branch; an empty span gives 0. \param branch an index of the skeleton.
BranchFacts branchFacts(const Skeleton& skeleton, const ChildLists& children, const SectionSet& sections,
                        std::span<const double> masses, Index branch);

struct SectionFacts
{
    Index section = 0; ///< counted from 0 at the branch's start
    double t = 0.0;    ///< curve parameter in [0, 1]
    double arcLength = 0.0;
    glm::dvec3 centre{0.0}, tangent{0.0}, normal{0.0}, binormal{0.0};
    double radius = 0.0;
    /// 1/m, |r' x r''| / |r'|^3 of the branch's curve. 0 where r' vanishes: the curve is straight there,
    /// since both r' and r'' are made of the branch's and its parent's direction.
    double curvature = 0.0;
    /// How far the frame is turned about the tangent, counter-clockwise seen against it, away from the frame
    /// that parallel transport along the true curve brings here from the parent's end. Section 0 has the
    /// branch's own roll; every other one adds what its frame turns more than the curve. A branch's curve is
    /// plane, so that is 0 for frames carried from tangent to tangent, except between opposite tangents.
    double twistRad = 0.0;
    double twistRadPerMetre =
        0.0; ///< over the piece before the section (the first: after it); 0 if it has no length
};

/// The cross-sections of one branch in their order; empty where \p sections has none for it.
std::vector<SectionFacts> sectionFacts(const Skeleton& skeleton, const SectionSet& sections, Index branch);

/// Comma-separated values for a spreadsheet or a script: a line of names with units, then one line per
/// section, each ended by \n. Sections count from 1, as the interface shows them. Numbers in the C locale,
/// the shortest that read back to the same double; a cusp's curvature is written inf.
std::string sectionsCsv(std::span<const SectionFacts> facts);

} // namespace ramure
