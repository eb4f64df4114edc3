#include "widgets/view/tools/hand/hand_edit.h"

#include "core/generators/tree_life.h"
#include "core/pipeline/tree_context.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <unordered_map>
#include <utility>

namespace ramure {

Expected<std::unique_ptr<HandEdit>> HandEdit::begin(Document& document, NodeId tree)
{
    const Node* node = document.scene().find(tree);
    if (!node)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(tree)});
    if (node->kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {node->name});
    if (document.scene().isLocked(tree))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is locked"), {node->name});
    const NodeResult* result = document.result(tree);
    if (!result || result->error || !result->tree.grown)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has not grown yet"), {node->name});
    return std::unique_ptr<HandEdit>(new HandEdit(document, tree, result->tree, node->params.edits));
}

HandEdit::HandEdit(Document& document, NodeId tree, const TreeResult& result, std::vector<TreeEdit> before)
    : m_document(document)
    , m_node(tree)
    , m_grown(result.grown)
    , m_before(std::move(before))
    , m_seed(treeSeed(document.scene().find(tree)->params))
    , m_context(contextOf(result, document.scene().find(tree)->params))
{
}

HandEdit::~HandEdit()
{
    keep();
}

Expected<void> HandEdit::add(const TreeEdit& edit, bool inTreeSpace)
{
    auto ready = m_context.prepared(edit, inTreeSpace);
    if (!ready)
        return tl::unexpected(ready.error());
    RAMURE_TRY(m_context.apply(*ready));
    m_edits.push_back(std::move(*ready));
    return {};
}

Expected<void> HandEdit::replace(const std::vector<TreeEdit>& edits, bool inTreeSpace)
{
    std::vector<TreeEdit> made;
    for (const TreeEdit& edit : edits) {
        auto ready = m_context.prepared(edit, inTreeSpace);
        if (!ready)
            return tl::unexpected(ready.error());
        RAMURE_TRY(m_context.tried(*ready));
        made.push_back(std::move(*ready));
    }
    m_edits = std::move(made);
    return {};
}

Expected<HandLoss> HandEdit::loss(const TreeEdit& edit, bool inTreeSpace) const
{
    constexpr double most = 0.5; // of a branch
    const auto lost = m_context.prepared(edit, inTreeSpace).and_then([this](const TreeEdit& ready) {
        return m_context.lossOf(ready);
    });
    if (!lost)
        return tl::unexpected(lost.error());
    HandLoss loss;
    loss.metres = lost->metres;
    const NodeResult* result = m_document.result(m_node);
    if (!result || !result->tree.skeleton || !result->tree.simplified)
        return loss;
    const Skeleton& drawn = *result->tree.skeleton;
    const SimplifiedSkeleton& seen = *result->tree.simplified;
    const std::unordered_map<std::uint64_t, double> shares(lost->pieces.begin(), lost->pieces.end());
    std::vector<double> gone(seen.skeleton.size(), 0.0), whole(seen.skeleton.size(), 0.0);
    for (Index piece = 0; piece < drawn.size(); ++piece) {
        const Index branch = seen.mergedInto[piece];
        const auto share = shares.find(drawn.key[piece]);
        gone[branch] += share == shares.end() ? 0.0 : share->second * drawn.length(piece);
        whole[branch] += drawn.length(piece);
    }
    for (Index branch = 0; branch < gone.size(); ++branch)
        if (gone[branch] > most * whole[branch])
            loss.branches.push_back(branch);
    return loss;
}

bool HandEdit::resume(EditOperation operation, std::uint64_t address)
{
    if (m_before.empty() || m_before.back().operation != operation || !m_before.back().enabled ||
        m_before.back().target.address != address)
        return false;
    m_edits = {m_before.back()};
    m_shown = {m_before.back().id};
    m_before.pop_back();
    m_context = EditContext(*m_grown, m_before, nullptr, m_seed);
    return true;
}

Expected<void> HandEdit::show()
{
    if (m_gesture != 0 && m_shown.size() > m_edits.size()) { // some are wanted no more
        m_document.giveUpGesture(m_gesture);
        m_gesture = 0;
        m_shown.clear();
    }
    if (m_edits.empty())
        return {};
    if (m_gesture == 0) {
        m_gesture = newGesture();
        m_document.holdGesture(m_gesture);
    }
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        m_edits[i].id = m_shown[i];
    auto ids = edit::putTreeEdits(m_document, m_node, m_edits, m_gesture);
    if (!ids)
        return tl::unexpected(ids.error());
    m_shown = std::move(*ids);
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        m_edits[i].id = m_shown[i];
    return {};
}

/// While the hand moves the tree does not grow anew. \return whether there was anything to answer
bool HandEdit::liveOn()
{
    const Node* node = m_document.scene().find(m_node);
    const double age = node ? growthYears(node->params) : 0.0;
    bool any = false;
    for (TreeEdit& edit : m_edits)
        if (canLiveOn(edit) && age > 0.0) {
            edit.year = age;
            any = true;
        }
    return any;
}

void HandEdit::keep()
{
    if (m_gesture != 0 && liveOn())
        show(); // what can be shown once can be shown again
    m_document.keepGesture(m_gesture);
    m_gesture = 0;
}

void HandEdit::cancel()
{
    m_document.giveUpGesture(m_gesture);
    m_gesture = 0;
}

namespace {

/// One step of undo, or none where nothing can be done.
/// \param add those of a limb
template <class Add> Expected<void> atOnce(Document& document, NodeId tree, Add&& add)
{
    auto gesture = HandEdit::begin(document, tree);
    if (!gesture)
        return tl::unexpected(gesture.error());
    RAMURE_TRY(add(**gesture));
    Expected<void> shown = (*gesture)->show();
    shown ? (*gesture)->keep() : (*gesture)->cancel();
    return shown;
}

TreeEdit editOf(EditOperation operation, const LimbHit& limb)
{
    TreeEdit edit;
    edit.operation = operation;
    edit.target.address = limb.address;
    edit.at = limb.share;
    return edit;
}

} // namespace

Expected<void> putAround(Document& document, const LimbHit& limb, TreeEdit edit, int copies)
{
    auto gesture = HandEdit::begin(document, limb.node);
    if (!gesture)
        return tl::unexpected(gesture.error());
    const auto frame = (*gesture)->context().frameOn(limb.address, limb.share);
    const double azimuth =
        frame ? std::atan2(glm::dot(limb.side, frame->binormal), glm::dot(limb.side, frame->normal)) : 0.0;
    edit.target.address = limb.address;
    edit.at = limb.share;
    std::vector<TreeEdit> edits;
    for (int copy = 0; copy < copies; ++copy) {
        edit.azimuthRad = azimuth + 2.0 * std::numbers::pi * copy / copies;
        edits.push_back(edit);
    }
    auto done = (*gesture)->replace(edits).and_then([&] { return (*gesture)->show(); });
    done ? (*gesture)->keep() : (*gesture)->cancel();
    return done;
}

Expected<void> removeLimbs(Document& document, const std::vector<LimbHit>& limbs, bool whole,
                           std::optional<double> fallsAfter)
{
    constexpr double foot = 1e-9; // of a length
    if (limbs.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("no branch is meant"));
    return atOnce(document, limbs.front().node, [&](HandEdit& gesture) -> Expected<void> {
        std::set<std::uint64_t> done;
        for (const LimbHit& limb : limbs) {
            if (!gesture.context().has(limb.address) || !done.insert(limb.address).second)
                continue; // gone with another
            const bool all = whole || limb.share < foot;
            TreeEdit edit = editOf(all && !fallsAfter ? EditOperation::Remove : EditOperation::Cut, limb);
            edit.falls = fallsAfter.has_value();
            edit.seconds = fallsAfter.value_or(0.0);
            RAMURE_TRY(gesture.add(edit));
        }
        if (done.empty())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("the tree has no such limb"));
        return {};
    });
}

Expected<std::vector<std::uint64_t>> putStepOn(Document& document, const LimbHit& limb, TreeEdit step)
{
    const auto gesture = HandEdit::begin(document, limb.node);
    RAMURE_TRY(gesture);
    auto target = (*gesture)->context().target(limb.address);
    RAMURE_TRY(target);
    step.target = std::move(*target);
    NodeParams values = *step.values;
    values.step.where.clear(); // the limb says it
    step.values = StepValues(std::move(values));
    return edit::putTreeEdits(document, limb.node, {std::move(step)});
}

Expected<void> keepLimb(Document& document, const LimbHit& limb)
{
    return atOnce(document, limb.node,
                  [&](HandEdit& gesture) { return gesture.add(editOf(EditOperation::Keep, limb)); });
}

Expected<void> toggleLeaves(Document& document, const std::vector<LimbHit>& limbs)
{
    if (limbs.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("no branch is meant"));
    const auto isLeavesOf = [](const TreeEdit& edit, std::uint64_t address) {
        return edit.operation == EditOperation::Leaves && edit.enabled && edit.target.address == address;
    };
    const NodeId tree = limbs.front().node;
    const Node* node = document.scene().find(tree);
    const std::vector<TreeEdit> now = node ? node->params.edits : std::vector<TreeEdit>();
    const auto last = std::find_if(now.rbegin(), now.rend(), [&](const TreeEdit& edit) {
        return isLeavesOf(edit, limbs.front().address);
    });
    const bool shown = last != now.rend() && !last->shown;
    return atOnce(document, tree, [&](HandEdit& gesture) -> Expected<void> {
        std::set<std::uint64_t> done;
        for (const LimbHit& limb : limbs) {
            if (!done.insert(limb.address).second)
                continue;
            TreeEdit edit = editOf(EditOperation::Leaves, limb);
            edit.shown = shown;
            RAMURE_TRY(gesture.add(edit));
        }
        return {};
    });
}

} // namespace ramure
