#include "widgets/view/tools/hand/turned_limb.h"

#include "core/skeleton/bend.h"

namespace ramure {

TurnedLimb::TurnedLimb(const Document& document, const LimbHit& limb)
    : m_seen(limb.seen)
    , m_grown(limb.seen)
{
    const Skeleton& seen = limb.simplified->skeleton;
    const auto& branches = document.scene().find(limb.node)->params.branches;
    std::vector<glm::dvec3> bends(seen.size(), glm::dvec3(0.0));
    bool any = false;
    for (Index b = 0; b < seen.size() && !branches.empty(); ++b)
        if (const auto found = branches.find(seen.name(b)); found != branches.end()) {
            bends[b] = found->second.bendRad;
            any = any || bends[b] != glm::dvec3(0.0);
        }
    if (!any)
        return;
    m_back = glm::conjugate(bendRotations(seen, bends)[limb.branch]);
    // Both begin at the same place of the limb.
    m_grown = limb.drawn->p0[seen.source[limb.branch]] + m_back * (limb.seen - seen.p0[limb.branch]);
}

} // namespace ramure
