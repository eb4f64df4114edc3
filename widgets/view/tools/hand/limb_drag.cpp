#include "widgets/view/tools/hand/limb_drag.h"
#include "core/evaluate/evaluator.h"

#include "widgets/view/tools/motion_tools.h"
#include <algorithm>

namespace ramure {
namespace {

Limb::Bends bendsOf(const Node& node)
{
    Limb::Bends bends;
    for (const auto& [key, branch] : node.params.branches)
        if (branch.bendRad != glm::dvec3(0.0))
            bends[key] = branch.bendRad;
    return bends;
}

std::vector<glm::dvec3> byBranch(const Skeleton& skeleton, const Limb::Bends& bends)
{
    std::vector<glm::dvec3> all(skeleton.size(), glm::dvec3(0.0));
    for (Index b = 0; b < skeleton.size() && !bends.empty(); ++b)
        if (const auto found = bends.find(skeleton.name(b)); found != bends.end())
            all[b] = found->second;
    return all;
}

} // namespace

std::unique_ptr<LimbDrag> LimbDrag::grab(Document& document, const PickHit& hit, std::size_t branches)
{
    const Node* node = document.scene().find(hit.node);
    const NodeResult* result = document.result(hit.node);
    if (!node || node->kind != NodeKind::Tree || document.scene().isLocked(hit.node) || !result ||
        !result->tree.simplified || !document.isCurrent(hit.node) || result->error)
        return nullptr;
    if (hit.branch >= result->tree.simplified->skeleton.size())
        return nullptr;
    return std::unique_ptr<LimbDrag>(new LimbDrag(document, hit, *node, result->tree.simplified, branches));
}

LimbDrag::LimbDrag(Document& document, const PickHit& hit, const Node& node,
                   std::shared_ptr<const SimplifiedSkeleton> skeleton, std::size_t branches)
    : m_document(document)
    , m_node(hit.node)
    , m_branch(hit.branch)
    , m_wanted(std::clamp<std::size_t>(branches, 1, mostBranches))
    , m_skeleton(std::move(skeleton))
    , m_atGrab(byBranch(m_skeleton->skeleton, bendsOf(node)))
    , m_bends(bendsOf(node))
    , m_limb(limb())
    , m_world(EvaluatedScene(document.scene()).transforms(hit.node).geometry)
    , m_inverse(glm::inverse(m_world))
    , m_grabbed(hit.point)
    , m_hand(hit.point)
{
}

LimbDrag::~LimbDrag()
{
    keep();
}

Limb LimbDrag::limb() const
{
    const Skeleton& skeleton = m_skeleton->skeleton;
    const std::size_t most = m_whole || m_counted ? m_wanted : limbLength(skeleton, m_branch);
    return Limb(skeleton, m_bends, m_branch, {std::min(m_wanted, most)});
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

std::vector<glm::dvec3> LimbDrag::bendsNow() const
{
    const Node* node = m_document.scene().find(m_node);
    return node ? byBranch(m_skeleton->skeleton, bendsOf(*node)) : m_atGrab;
}

std::vector<glm::dvec3> LimbDrag::bends() const
{
    std::vector<glm::dvec3> all = m_atGrab;
    const Limb::Bends turned = m_limb.bends();
    const Skeleton& skeleton = m_skeleton->skeleton;
    Index b = m_branch;
    std::vector<Index> chain;
    for (std::size_t i = 0; i < m_limb.branchCount(); ++i, b = skeleton.parent[b]) {
        all[b] = turned.at(skeleton.name(b));
        chain.push_back(b);
    }
    for (const BranchTwin& twin : m_twins)
        if (std::ranges::count(chain, twin.from) > 0 && std::ranges::count(chain, twin.to) == 0)
            all[twin.to] = m_atGrab[twin.to] + twin.map.rotation(all[twin.from] - m_atGrab[twin.from]);
    return all;
}

Limb::Bends LimbDrag::wanted() const
{
    Limb::Bends wanted = m_limb.bends();
    if (m_twins.empty())
        return wanted;
    const std::vector<glm::dvec3> all = bends();
    const Skeleton& skeleton = m_skeleton->skeleton;
    for (const BranchTwin& twin : m_twins)
        if (all[twin.to] != m_atGrab[twin.to])
            wanted[skeleton.name(twin.to)] = all[twin.to];
    return wanted;
}

bool LimbDrag::apply()
{
    const Limb::Bends wanted = this->wanted();
    if (m_gesture == 0 ? m_hand == m_grabbed : wanted == m_applied)
        return false; // nothing was dragged yet, or no further
    const auto sameBranches = [](const auto& a, const auto& b) { return a.first == b.first; };
    // Others turn than those before: these go back, as if they never had.
    if (m_gesture != 0 && !std::ranges::equal(wanted, m_applied, sameBranches)) {
        m_document.giveUpGesture(m_gesture);
        m_gesture = 0;
    }
    if (m_gesture == 0) {
        m_gesture = newGesture();
        m_document.holdGesture(m_gesture);
    }
    m_applied = wanted;
    return edit::turnBranches(m_document, m_node, wanted, m_gesture).has_value();
}

void LimbDrag::keep()
{
    m_document.keepGesture(m_gesture);
}

void LimbDrag::cancel()
{
    m_document.giveUpGesture(m_gesture);
    m_gesture = 0;
}

} // namespace ramure
