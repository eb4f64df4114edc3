#include "widgets/view/tools/hand/limb_drag.h"

#include "core/evaluate/evaluator.h"
#include "core/skeleton/branch_steps.h"
#include "widgets/view/tools/motion_tools.h"
#include <algorithm>

namespace ramure {

std::unique_ptr<LimbDrag> LimbDrag::grab(Document& document, const PickHit& hit, std::size_t branches)
{
    const Node* node = document.scene().find(hit.node);
    const NodeResult* result = document.result(hit.node);
    if (!node || node->kind != NodeKind::Tree || document.scene().isLocked(hit.node) || !result ||
        !result->tree.simplified || !document.isCurrent(hit.node) || result->error)
        return nullptr;
    if (hit.branch >= result->tree.simplified->skeleton.size())
        return nullptr;
    auto edit = HandEdit::begin(document, hit.node);
    return edit ? std::unique_ptr<LimbDrag>(
                      new LimbDrag(document, hit, result->tree, branches, std::move(*edit)))
                : nullptr;
}

LimbDrag::LimbDrag(Document& document, const PickHit& hit, const TreeResult& tree, std::size_t branches,
                   std::unique_ptr<HandEdit> edit)
    : m_document(document)
    , m_node(hit.node)
    , m_branch(hit.branch)
    , m_wanted(std::clamp<std::size_t>(branches, 1, mostBranches))
    , m_edit(std::move(edit))
    , m_skeleton(tree.simplified)
    , m_axes(axesOf(*tree.skeleton))
    , m_limb(limb())
    , m_world(EvaluatedScene(document.scene()).transforms(hit.node).geometry)
    , m_inverse(glm::inverse(m_world))
    , m_grabbed(hit.point)
    , m_hand(hit.point)
{
}

Limb LimbDrag::limb() const
{
    const Skeleton& skeleton = m_skeleton->skeleton;
    const std::size_t most = m_whole || m_counted ? m_wanted : limbLength(skeleton, m_branch);
    return Limb(skeleton, {}, m_branch, {std::min(m_wanted, most)});
}

void LimbDrag::dragTo(const PickView& view, const glm::dvec2& pixel)
{
    m_hand = pulledTo(view, pixel, m_grabbed);
    pull();
}

void LimbDrag::setWhole(bool whole)
{
    if (std::exchange(m_whole, whole) != whole)
        takeLimb();
}

void LimbDrag::setBranches(std::size_t branches)
{
    m_wanted = std::clamp<std::size_t>(branches, 1, mostBranches);
    m_counted = true;
    takeLimb();
    m_wanted = std::max<std::size_t>(m_limb.branchCount(), 1); // the root is the last that can follow
}

void LimbDrag::takeLimb()
{
    m_limb = limb();
    pull();
}

void LimbDrag::pull()
{
    const glm::dvec3 by =
        glm::dvec3(m_inverse * glm::dvec4(m_hand, 1.0)) - glm::dvec3(m_inverse * glm::dvec4(m_grabbed, 1.0));
    m_shortBy = m_limb.pullTo(m_skeleton->skeleton.p1[m_branch] + by);
}

std::vector<glm::dvec3> LimbDrag::bendsAtGrab() const
{
    return std::vector<glm::dvec3>(m_skeleton->skeleton.size(), glm::dvec3(0.0));
}

std::vector<glm::dvec3> LimbDrag::bendsNow() const
{
    const Node* node = m_document.scene().find(m_node);
    const std::vector<TreeEdit>& mine = m_edit->edits();
    const bool has =
        node && !mine.empty() && std::ranges::count(node->params.edits, mine.front().id, &TreeEdit::id) > 0;
    return has ? m_applied : bendsAtGrab();
}

std::vector<glm::dvec3> LimbDrag::bends() const
{
    std::vector<glm::dvec3> all = bendsAtGrab();
    const Limb::Bends turned = m_limb.bends();
    const Skeleton& skeleton = m_skeleton->skeleton;
    Index b = m_branch;
    std::vector<Index> chain;
    for (std::size_t i = 0; i < m_limb.branchCount(); ++i, b = skeleton.parent[b]) {
        all[b] = turned.at(skeleton.key[b]);
        chain.push_back(b);
    }
    for (const BranchTwin& twin : m_twins)
        if (std::ranges::count(chain, twin.from) > 0 && std::ranges::count(chain, twin.to) == 0)
            all[twin.to] = twin.map.rotation(all[twin.from]);
    return all;
}

bool LimbDrag::apply()
{
    std::vector<glm::dvec3> wanted = bends();
    if (m_applied.empty() ? m_hand == m_grabbed : wanted == m_applied)
        return false; // nothing was dragged yet, or no further
    m_applied = std::move(wanted);
    return m_edit->replace(bendSteps(m_axes, *m_skeleton, m_applied))
        .and_then([this] { return m_edit->show(); })
        .has_value();
}

} // namespace ramure
