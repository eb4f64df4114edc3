#include "core/skeleton/sections.h"

#include "core/math/ring.h"
#include <algorithm>

namespace ramure {

BranchCurve branchCurve(const Skeleton& skeleton, Index branch)
{
    const glm::dvec3 own = skeleton.p1[branch] - skeleton.p0[branch];
    const Index parent = skeleton.parent[branch];
    const glm::dvec3 before = parent == noIndex ? own : skeleton.p1[parent] - skeleton.p0[parent];
    return {skeleton.p0[branch], skeleton.p1[branch], before, own};
}

SectionSet buildSections(const Skeleton& skeleton, int lengthDivisions, std::span<const double> rollRad)
{
    const Index perBranch = static_cast<Index>(std::max(lengthDivisions, 2));
    SectionSet set;
    set.perBranch = perBranch;
    set.sections.reserve(std::size_t(skeleton.size()) * perBranch);
    for (Index branch = 0; branch < skeleton.size(); ++branch) {
        const Index parent = skeleton.parent[branch];
        const BranchCurve curve = branchCurve(skeleton, branch);
        Frame frame = parent == noIndex ? Frame() : set.of(parent).back().frame;
        for (Index k = 0; k < perBranch; ++k) {
            const double t = static_cast<double>(k) / (perBranch - 1);
            const CurvePoint at = hermite(curve.h0, curve.h1, curve.v0, curve.v1, t);
            frame = transported(frame, at.tangent);
            if (k == 0 && branch < rollRad.size() && rollRad[branch] != 0.0)
                frame = rolled(frame, rollRad[branch]);
            const double radius = (1.0 - t) * skeleton.a0[branch] + t * skeleton.a1[branch];
            set.sections.push_back({at.point, frame, t, radius});
        }
    }
    return set;
}

glm::dvec3 sectionPoint(const CrossSection& section, int k, int radialDivisions)
{
    const glm::dvec2 on = ringDirection(k, radialDivisions);
    return section.centre + section.radius * (on.x * section.frame.normal + on.y * section.frame.binormal);
}

} // namespace ramure
