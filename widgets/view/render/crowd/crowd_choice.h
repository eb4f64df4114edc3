/// \file
/// Which places of a crowd are seen in a picture, and in which form: the nearest whole, the others by how
/// many pixels high they are, in as many triangles as the picture may have. Plain mathematics, without
/// OpenGL.
#pragma once

#include "widgets/view/render/crowd/crowd.h"

namespace ramure {

/// Where a crowd is seen from, in its own space.
struct CrowdSight
{
    glm::dvec3 eye{0.0};
    double pixels = 1.0; ///< the height of 1 m at 1 m from the eye; at any distance if all rays are parallel
    bool isParallel = false;
    std::vector<CutPlane> planes; ///< what is on the inner side of all is seen
};

/// What a picture may cost.
struct CrowdBudget
{
    std::int64_t triangles = 1'000'000; ///< of all forms
    std::int64_t whole = 1'000'000;     ///< of what is drawn whole, beside them
    double wholePixels = 300.0;         ///< the height from which that may be
    double coarser = 1.0;               ///< forms are shown as if there were so many times less pixels
    bool operator==(const CrowdBudget&) const = default;
};

struct CrowdChoice
{
    /// The places that have one form, the nearest first. Where one form passes into the next a place has
    /// both, and the two share its pixels: an opacity under 128 is the share of 127 that the first form
    /// shows, one from 128 to 254 says which of them it leaves to the other. 255: all.
    struct OfForm
    {
        std::size_t prototype = 0, form = 0;
        std::shared_ptr<const std::vector<MeshCopy>> places;
    };
    std::vector<OfForm> forms;
    std::vector<Index> whole;   ///< places that are drawn whole
    std::size_t instances = 0;  ///< that are seen
    std::int64_t triangles = 0; ///< of both
};

CrowdChoice chooseForms(const Crowd& crowd, const CrowdSight& sight, const CrowdBudget& budget);

} // namespace ramure
