#include "widgets/viewport/limb_tool.h"
#include "core/scene/places.h"

#include "widgets/viewport/motion_tools.h"
#include <algorithm>

namespace ramure {

static Limb::Bends bendsOf(const Node& node)
{
    Limb::Bends bends;
    for (const auto& [key, branch] : node.params.branches)
        if (branch.bendRad != glm::dvec3(0.0))
            bends[key] = branch.bendRad;
    return bends;
}

std::unique_ptr<LimbTool> LimbTool::grab(Document& document, const PickHit& hit, std::size_t branches)
{
    const Node* node = document.scene().find(hit.node);
    const NodeResult* result = document.result(hit.node);
    if (!node || node->kind != NodeKind::Tree || document.scene().isLocked(hit.node) || !result ||
        !result->tree.simplified || !document.isCurrent(hit.node) || result->error)
        return nullptr;
    const Skeleton& skeleton = result->tree.simplified->skeleton;
    if (hit.branch >= skeleton.size())
        return nullptr;
    return std::unique_ptr<LimbTool>(new LimbTool(document, hit, *node, skeleton, branches));
}

LimbTool::LimbTool(Document& document, const PickHit& hit, const Node& node, const Skeleton& skeleton,
                   std::size_t branches)
    : m_document(document)
    , m_node(hit.node)
    , m_branch(hit.branch)
    , m_skeleton(skeleton)
    , m_bends(bendsOf(node))
    , m_limb(m_skeleton, m_bends, m_branch, {std::clamp<std::size_t>(branches, 1, mostBranches)})
    , m_world(placeAt(document.scene(), hit.node, 0.0).geometry)
    , m_inverse(glm::inverse(m_world))
    , m_grabbed(hit.point)
    , m_hand(hit.point)
{
}

void LimbTool::dragTo(const PickView& view, const glm::dvec2& pixel)
{
    m_hand = pulledTo(view, pixel, m_grabbed);
    pull();
}

void LimbTool::setBranches(std::size_t branches)
{
    const std::size_t next = std::clamp<std::size_t>(branches, 1, mostBranches);
    const Limb::Bends before = m_limb.bends();
    Limb limb(m_skeleton, m_bends, m_branch, {next});
    if (limb.branchCount() == m_limb.branchCount())
        return;
    m_limb = std::move(limb);
    // Branches that no longer follow go back to where they were; a new gesture, as others turn now.
    Limb::Bends back;
    for (const auto& [key, bend] : before)
        back[key] = m_bends.contains(key) ? m_bends[key] : glm::dvec3(0.0);
    edit::turnBranches(m_document, m_node, back, m_gesture);
    m_gesture = newGesture();
    pull();
}

void LimbTool::pull()
{
    const glm::dvec3 by =
        glm::dvec3(m_inverse * glm::dvec4(m_hand, 1.0)) - glm::dvec3(m_inverse * glm::dvec4(m_grabbed, 1.0));
    m_shortBy = m_limb.pullTo(m_skeleton.p1[m_branch] + by);
    edit::turnBranches(m_document, m_node, m_limb.bends(), m_gesture);
}

} // namespace ramure
