#include "core/recipe/apply_edits.h"

#include "core/base/stopwatch.h"
#include "core/generators/growth/palm.h"
#include "core/math/stage_hash.h"
#include "core/params/tree_edit_table.h"
#include "core/recipe/axis_filter.h"
#include "core/recipe/edit_operations.h"
#include "core/skeleton/edit_places.h"
#include <algorithm>

namespace ramure {
namespace edits {

/// All of a stroke of a brush; where one place is out of reach the others still count.
static Expected<void> actAlong(EditTree& tree, const TreeEdit& edit, Index target, Index other, Act* act)
{
    Expected<void> done = act(tree, edit, target, other);
    TreeEdit touch = edit;
    touch.points.clear();
    for (const StrokePoint& point : edit.points) {
        touch.direction = point.position - touch.centre;
        touch.centre = point.position;
        touch.radius = point.radius > 0.0 ? point.radius : edit.radius;
        const bool goesOn = edit.operation != EditOperation::Comb || touch.direction != glm::dvec3(0.0);
        if (goesOn && act(tree, touch, target, other))
            done = {};
    }
    return done;
}

Expected<void> unknown(EditTree& /*tree*/, const TreeEdit& /*edit*/, Index /*target*/, Index /*other*/)
{
    return fail(ErrorCode::Unknown, RAMURE_NOOP("a newer version of the program has made this step"));
}

Expected<void> frozen(EditTree& /*tree*/, const TreeEdit& /*edit*/, Index /*target*/, Index /*other*/)
{
    return {};
}

Expected<std::vector<bool>> axesMeant(EditTree& tree, const TreeEdit& edit, Index target)
{
    const auto filter = AxisFilter::parse(edit.values->step.where);
    RAMURE_TRY(filter);
    std::vector<bool> axes = filter->axesOf(tree);
    for (Index a = 0; target != noIndex && a < axes.size(); ++a)
        axes[a] = axes[a] && tree.isOn(tree.axis(a).first, tree.axis(target).first);
    if (std::ranges::count(axes, true) > 0) {
        if (target != noIndex || !edit.values->step.where.empty())
            tree.setMeant(axes);
        return axes;
    }
    auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("no axis meets the condition"));
    error.value().path = "step.where";
    return error;
}

Random chanceOf(const EditTree& tree, const TreeEdit& edit, Index axis)
{
    const std::uint64_t step = StageHash(tree.seed()).add(edit.id).add(edit.values->step.seed).value();
    return {step, RandomStream::Steps, tree.axis(axis).address};
}

Expected<void> act(EditTree& tree, const TreeEdit& edit, Index target, Index other)
{
    tree.setMaker(edit.id);
    const auto own = std::ranges::find(acts, edit.operation, &OperationAct::operation);
    Act* const act = own != std::end(acts) ? own->act : source;
    return infoOf(edit.operation).fields & editPath ? actAlong(tree, edit, target, other, act)
                                                    : act(tree, edit, target, other);
}

} // namespace edits

namespace {

/// Where a target is, before any edit has been made.
struct GrownPlace
{
    Index axis = noIndex; ///< of the tree as grown; noIndex: it was not there
    bool byAddress = false;
};

class Applier
{
public:
    Applier(EditTree& tree, const TreeAxes& axes, std::span<const TreeEdit> edits)
        : m_tree(tree)
        , m_edits(edits)
        , m_targets(edits.size())
        , m_others(edits.size())
    {
        std::vector<const BranchPlace*> places;
        std::vector<GrownPlace*> wanted;
        const auto want = [&](const EditTarget& target, GrownPlace& into) {
            if (target.place.way.empty())
                return;
            places.push_back(&target.place);
            wanted.push_back(&into);
        };
        for (std::size_t i = 0; i < edits.size(); ++i)
            if (edits[i].enabled && !tree.livedWith(edits[i].id)) {
                want(edits[i].target, m_targets[i]);
                want(edits[i].other, m_others[i]);
            }
        const std::vector<FoundPlace> found = findPlaces(axes, places);
        for (std::size_t i = 0; i < found.size(); ++i)
            if (found[i].branch != noIndex)
                *wanted[i] = {axes.axisOf[found[i].branch], found[i].byAddress};
    }

    EditReport run(const Progress& progress)
    {
        EditReport report;
        report.reserve(m_edits.size());
        const std::size_t frozen = stepsFrozen(m_edits);
        for (std::size_t i = 0; i < m_edits.size(); ++i) {
            progress.report(static_cast<double>(i) / static_cast<double>(m_edits.size()));
            if (!m_edits[i].enabled || m_tree.cancelled())
                report.push_back({m_edits[i].id});
            else if (i < frozen)
                report.push_back({m_edits[i].id, i + 1 < frozen ? EditState::Frozen : EditState::ByAddress});
            else
                report.push_back(timed(i));
        }
        return report;
    }

private:
    EditOutcome timed(std::size_t i)
    {
        const Stopwatch watch;
        EditOutcome outcome = done(i);
        outcome.seconds = 1e-3 * watch.elapsed().wallMs;
        return outcome;
    }
    EditOutcome done(std::size_t i)
    {
        const TreeEdit& edit = m_edits[i];
        // What is younger than the cut, as this year's shoots are, is cut as it has grown.
        if (const LivedEdit* lived = m_tree.livedWith(edit.id);
            lived && (lived->state != LivedEdit::State::Missed || !stands(edit.target.address)))
            return outcomeOf(edit, lived->state);
        EditOutcome outcome{edit.id, EditState::ByAddress};
        const Index target = axisOf(edit.target, m_targets[i], outcome);
        const Index other = axisOf(edit.other, m_others[i], outcome);
        if (target != noIndex)
            outcome.address = m_tree.axis(target).address;
        if (outcome.state == EditState::Unplaced || outcome.state == EditState::Idle)
            return outcome;
        m_tree.setMeant({});
        if (auto acted = edits::act(m_tree, edit, target, other); !acted) {
            outcome.state = EditState::Idle;
            outcome.why = std::move(acted.error());
        }
        for (Index a = 0; a < m_tree.meant().size(); ++a)
            if (m_tree.meant()[a])
                outcome.axes.push_back(m_tree.axis(a).address);
        return outcome;
    }

    [[nodiscard]] bool stands(std::uint64_t address) const
    {
        const Index axis = address == 0 ? noIndex : m_tree.axisAt(address);
        return axis != noIndex && !m_tree.isGone(axis);
    }
    [[nodiscard]] static EditOutcome outcomeOf(const TreeEdit& edit, LivedEdit::State state)
    {
        if (state == LivedEdit::State::Waits)
            return {edit.id, EditState::Waits, {}, edit.target.address};
        if (state == LivedEdit::State::Made) {
            EditOutcome made{edit.id, EditState::ByAddress, {}, edit.target.address};
            if (edit.target.address == palmStemAddress)
                made.why =
                    fail(ErrorCode::Unknown, RAMURE_NOOP("the palm has died of it: its only bud is gone"))
                        .value();
            return made;
        }
        return {edit.id, EditState::Unplaced,
                fail(ErrorCode::Unknown,
                     edit.operation == EditOperation::Prune
                         ? RAMURE_NOOP("nothing stands out of the shape")
                         : RAMURE_NOOP("the limb did not stand when the tree was of that age"))
                    .value()};
    }
    /// Of a tree whose axes are called by where they stand on others.
    Index placed(const EditTarget& target, const GrownPlace& grown, EditOutcome& outcome) const
    {
        if (target.maker != 0 || target.place.way.empty()) {
            Index axis = m_tree.madeAxisAt(target.address);
            if (axis == noIndex && grown.axis != noIndex)
                axis =
                    m_tree.madeAxisAt(edits::graftedAddress(target.maker, m_tree.axis(grown.axis).address));
            // Whoever knows an address alone may mean what has grown.
            return axis == noIndex && target.maker == 0 ? m_tree.axisAt(target.address) : axis;
        }
        if (grown.axis != noIndex && !grown.byAddress)
            outcome.state = EditState::ByLikeness;
        return grown.axis;
    }

    /// noIndex with a state that is still good: the edit has none.
    Index axisOf(const EditTarget& target, const GrownPlace& grown, EditOutcome& outcome) const
    {
        if (target.address == 0)
            return noIndex;
        Index axis = m_tree.hasOwnAddresses() ? m_tree.axisAt(target.address) : noIndex;
        if (axis == noIndex)
            axis = placed(target, grown, outcome);
        if (axis != noIndex && !m_tree.isGone(axis))
            return axis;
        outcome.state = axis == noIndex ? EditState::Unplaced : EditState::Idle;
        outcome.why = fail(ErrorCode::Unknown,
                           axis == noIndex ? RAMURE_NOOP("no limb of the tree resembles the edited one")
                                           : RAMURE_NOOP("an edit before has taken the limb away"))
                          .value();
        return noIndex;
    }

    EditTree& m_tree;
    std::span<const TreeEdit> m_edits;
    std::vector<GrownPlace> m_targets, m_others;
};

} // namespace

EditReport applyEdits(EditTree& tree, const TreeAxes& axes, std::span<const TreeEdit> edits,
                      const Progress& progress)
{
    tree.setProgress(&progress);
    EditReport report = Applier(tree, axes, edits).run(progress);
    tree.setProgress(nullptr);
    return report;
}

LayerCount countLayer(const EditReport& report)
{
    LayerCount count;
    for (const EditOutcome& outcome : report) {
        count.placed += outcome.state == EditState::ByAddress ? 1 : 0;
        count.matched += outcome.state == EditState::ByLikeness ? 1 : 0;
        count.unplaced += outcome.state == EditState::Unplaced || outcome.state == EditState::Idle ? 1 : 0;
    }
    return count;
}

} // namespace ramure
