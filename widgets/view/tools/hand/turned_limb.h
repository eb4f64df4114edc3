/// \file
/// Branches that were bent (BranchParams::bendRad) are seen elsewhere than where they grew; edits act on the
/// tree before the bends.
#pragma once

#include "widgets/view/tools/limb_finder.h"
#include <glm/gtc/quaternion.hpp>

namespace ramure {

class TurnedLimb
{
public:
    TurnedLimb() = default;
    /// In the tree that \p limb was found in.
    TurnedLimb(const Document& document, const LimbHit& limb);

    /// Where what is seen at that place, carried by the branch, would be without bends. m, tree space
    [[nodiscard]] glm::dvec3 grown(const glm::dvec3& seen) const
    {
        return m_grown + m_back * (seen - m_seen);
    }
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& seen) const { return m_back * seen; }

private:
    glm::dquat m_back{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 m_seen{0.0}, m_grown{0.0};
};

} // namespace ramure
