#include "core/recipe/edit_context.h"

#include "core/params/tree_edit_table.h"
#include "core/recipe/apply_edits.h"
#include "core/recipe/edit_operations.h"
#include "core/skeleton/edit_places.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

tl::unexpected<Error> noLimb(const char* path)
{
    auto error = fail(ErrorCode::Unknown, RAMURE_NOOP("the tree has no such limb"));
    error.value().path = path;
    return error;
}

/// Points that are places in tree space become steps in a frame.
void putInto(const Frame& frame, const glm::dvec3& origin, std::vector<StrokePoint>& points)
{
    for (StrokePoint& point : points)
        point.position = into(frame, point.position - origin);
}

Expected<void> actOn(EditTree& tree, const TreeAxes& grown, const TreeEdit& edit)
{
    const EditReport report = applyEdits(tree, grown, {&edit, 1});
    const EditOutcome& outcome = report.front();
    if (outcome.state == EditState::Unplaced || outcome.state == EditState::Idle)
        return fail(outcome.why);
    return {};
}

} // namespace

EditContext::EditContext(const Skeleton& grown, std::span<const TreeEdit> edits,
                         std::shared_ptr<const TreeAxes> axes, std::uint64_t seed, const Progress& progress)
    : m_grown(axes ? std::move(axes) : std::make_shared<const TreeAxes>(axesOf(grown)))
    , m_edits(edits.begin(), edits.end())
    , m_mark(treeMark(*m_grown))
    , m_tree(std::make_unique<EditTree>(grown, *m_grown, seed))
{
    m_report = applyEdits(*m_tree, *m_grown, edits, progress);
}

EditContext::~EditContext() = default;
EditContext::EditContext(const EditContext& other)
    : m_grown(other.m_grown)
    , m_edits(other.m_edits)
    , m_report(other.m_report)
    , m_mark(other.m_mark)
    , m_tree(std::make_unique<EditTree>(*other.m_tree))
{
}
EditContext::EditContext(EditContext&&) noexcept = default;
EditContext& EditContext::operator=(EditContext&&) noexcept = default;

std::optional<EditContext> EditContext::upTo(std::span<const TreeEdit> edits, const Progress& progress) const
{
    if (edits.size() < m_edits.size() || !std::ranges::equal(edits.first(m_edits.size()), m_edits))
        return std::nullopt;
    const std::span<const TreeEdit> rest = edits.subspan(m_edits.size());
    if (stepsFrozen(rest) > 0) // what has grown is another tree then
        return std::nullopt;
    EditContext copy = *this;
    const EditReport made = applyEdits(*copy.m_tree, *m_grown, rest, progress);
    copy.m_report.insert(copy.m_report.end(), made.begin(), made.end());
    copy.m_edits.insert(copy.m_edits.end(), rest.begin(), rest.end());
    return copy;
}

std::size_t EditContext::bytes() const
{
    return m_tree->bytes() + m_edits.size() * sizeof(TreeEdit) + m_report.size() * sizeof(EditOutcome);
}

bool EditContext::has(std::uint64_t address) const
{
    const Index axis = m_tree->axisAt(address);
    return axis != noIndex && !m_tree->isGone(axis);
}

Expected<EditTarget> EditContext::named(std::uint64_t address, const char* key) const
{
    if (address == 0)
        return EditTarget{};
    const Index axis = m_tree->axisAt(address);
    if (axis == noIndex || m_tree->isGone(axis))
        return noLimb(key);
    const EditAxis& found = m_tree->axis(axis);
    EditTarget target{address, found.maker};
    if (const Index original = axis < m_tree->grownAxes() ? axis : found.original;
        original < m_tree->grownAxes())
        target.place = placeOf(*m_grown, m_grown->nodesOf(original).front(), m_mark);
    return target;
}

Expected<EditTarget> EditContext::target(std::uint64_t address) const
{
    return address == 0 ? noLimb("") : named(address, "");
}

double EditContext::lengthOf(std::uint64_t address) const
{
    return has(address) ? m_tree->axisLength(m_tree->axisAt(address)) : 0.0;
}

std::optional<StrokePoint> EditContext::pointOn(std::uint64_t address, double share) const
{
    if (!has(address))
        return std::nullopt;
    const Index axis = m_tree->axisAt(address);
    const Index first = m_tree->axis(axis).first;
    if (share <= 0.0)
        return StrokePoint{m_tree->piece(first).p0, m_tree->piece(first).a0};
    const AxisSpot spot = m_tree->spotOn(axis, share);
    return StrokePoint{m_tree->pointAt(spot), m_tree->radiusAt(spot)};
}

std::optional<Frame> EditContext::frameOn(std::uint64_t address, double share) const
{
    if (!has(address))
        return std::nullopt;
    return m_tree->frameAfter(m_tree->spotOn(m_tree->axisAt(address), share).piece);
}

std::optional<Frame> EditContext::frameBelow(std::uint64_t address) const
{
    if (!has(address))
        return std::nullopt;
    return m_tree->frameBelow(m_tree->axisAt(address));
}

Expected<TreeEdit> EditContext::prepared(TreeEdit edit, bool inTreeSpace) const
{
    RAMURE_TRY(checkTreeEdit(edit));
    const EditOperationInfo& info = infoOf(edit.operation);
    auto target = named(edit.target.address, info.targetKey);
    auto other = named(edit.other.address, info.otherKey);
    RAMURE_TRY(target);
    RAMURE_TRY(other);
    edit.target = std::move(*target);
    edit.other = std::move(*other);
    if (!inTreeSpace || (info.fields & editTreeSpace))
        return edit;
    const Index axis = edit.target.address == 0 ? noIndex : m_tree->axisAt(edit.target.address);
    if (info.fields & editRotation)
        edit.rotation = into(m_tree->frameBelow(axis), edit.rotation);
    if (axis == noIndex)
        putInto(Frame(), glm::dvec3(0.0), edit.points);
    else if (edit.operation == EditOperation::Redraw)
        putInto(m_tree->frameBelow(axis), m_tree->piece(m_tree->axis(axis).first).p0, edit.points);
    else if (info.fields & editPoints) {
        const AxisSpot spot = edit.operation == EditOperation::Draw ? edits::forkSpot(*m_tree, axis, edit.at)
                                                                    : AxisSpot{m_tree->tipOf(axis)};
        putInto(m_tree->frameAfter(spot.piece), m_tree->pointAt(spot), edit.points);
    }
    if (auto ok = checkTreeEdit(edit); !ok) // a stroke that ends where it starts
        return fail(std::move(ok.error()));
    return edit;
}

Expected<void> EditContext::tried(const TreeEdit& edit) const
{
    EditTree copy = *m_tree;
    return actOn(copy, *m_grown, edit);
}

Expected<EditLoss> EditContext::lossOf(const TreeEdit& edit) const
{
    EditTree after = *m_tree;
    if (auto done = actOn(after, *m_grown, edit); !done)
        return tl::unexpected(done.error());
    EditLoss loss;
    for (Index i = m_tree->firstPiece(); i != noIndex; i = m_tree->piece(i).after) {
        const double was = m_tree->length(i), is = after.piece(i).gone ? 0.0 : after.length(i);
        if (is >= was && !after.piece(i).gone)
            continue;
        loss.pieces.emplace_back(m_tree->piece(i).key, was > 0.0 ? 1.0 - is / was : 1.0);
        loss.metres += was - is;
    }
    return loss;
}

Expected<void> EditContext::apply(const TreeEdit& edit)
{
    return actOn(*m_tree, *m_grown, edit);
}

std::vector<LimbPiece> EditContext::limb(std::uint64_t address) const
{
    return has(address) ? edits::limbOf(*m_tree, m_tree->axisAt(address)) : std::vector<LimbPiece>();
}

Skeleton EditContext::skeleton() const
{
    return m_tree->skeleton();
}

} // namespace ramure
