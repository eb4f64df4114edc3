#include "widgets/view/tools/pending_pick.h"

#include "widgets/view/tools/selection_edits.h"
#include "widgets/view/tools/tool_context.h"
#include <utility>

namespace ramure {

void PendingPick::click(QPointF at, bool extend)
{
    begin({at, at, false, extend, false});
}

void PendingPick::box(QPointF from, QPointF to, bool extend)
{
    begin({from, to, true, extend, false});
}

void PendingPick::menu(QPointF at)
{
    if (m_context.isPlaying()) { // nothing is made to pick in
        emit menuWanted(at, noNode, noIndex);
        return;
    }
    begin({at, at, false, false, true});
}

void PendingPick::begin(const Pending& pick)
{
    forget();
    m_pending = pick;
    tryAgain();
}

void PendingPick::forget()
{
    m_pending.reset();
    m_boxRuns = false;
}

void PendingPick::tryAgain()
{
    if (!m_pending || m_boxRuns || (m_pending->isBox && m_context.host.isStale()))
        return; // what is in a box must belong to the document of now
    const auto scene = m_context.host.pickScene(pickPatience);
    if (!scene || !m_pending)
        return;
    if (m_pending->isBox)
        return tryBox();
    const Pending pick = *std::exchange(m_pending, std::nullopt);
    const Selection& selection = m_context.document.selection();
    auto hit = scene->pick(m_context.host.view(), {pick.to.x(), pick.to.y()});
    const Scene& now = m_context.document.scene(); // which may be newer than the picture
    if (hit && (!now.find(hit->node) || !now.isShown(hit->node) || now.isLocked(hit->node)))
        hit.reset();
    if (!hit && !pick.asksMenu)
        emit missed();
    const std::vector<Index> limb = hit ? takeIntoDocument(*hit) : std::vector<Index>();
    if (!pick.asksMenu || (hit && !isSelected(selection, *hit)))
        m_context.document.setSelection(afterClick(selection, hit, limb, pick.extend));
    const PickHit at = hit.value_or(PickHit());
    if (pick.asksMenu)
        emit menuWanted(pick.to, at.node, at.branch);
}

/// What was hit in the picture, in the document's own tree. \return the branches of its limb there
std::vector<Index> PendingPick::takeIntoDocument(PickHit& hit)
{
    if (hit.branch == noIndex)
        return {};
    LimbFinder& limbs = m_context.limbs;
    const auto own = [&](std::vector<Index> branches) {
        return limbs.inDocument(m_context.document, hit.node, std::move(branches));
    };
    auto limb = own(limbs.limbOf(m_context.document, hit.node, hit.branch));
    const std::vector<Index> branch = own({hit.branch});
    hit.branch = branch.empty() ? noIndex : branch.front(); // it may be gone by now
    return limb;
}

void PendingPick::tryBox()
{
    const auto done = [this](const std::vector<PickedBranches>& picked) {
        if (!std::exchange(m_boxRuns, false) || !m_pending || m_context.host.isStale())
            return; // given up; or what is shown becomes ready again
        const Pending box = *std::exchange(m_pending, std::nullopt);
        m_context.document.setSelection(afterBox(m_context.document.selection(), picked, box.extend));
    };
    m_boxRuns = true; // before: it may be done at once
    if (!m_context.host.pickBox(m_pending->from, m_pending->to, done))
        m_boxRuns = false;
}

} // namespace ramure
