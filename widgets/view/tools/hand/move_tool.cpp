// A fork slides along its parent, turns about it, or goes to another branch, with all that grows there.
#include "core/math/angle.h"
#include "core/math/frame.h"
#include "widgets/view/tools/hand/number_tool.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace ramure {
namespace {

constexpr double anglePerNotch = 5.0 * oneDegree;

class MoveTool : public NumberTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::MoveTool)
public:
    using NumberTool::NumberTool;

    void drag(const ToolPoint& point) override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return isByKeys() ? tr("Digits: place in % · wheel: around · Enter or click: done · Esc: back")
                          : tr("Release: done · Shift or wheel: around · Ctrl: onto another branch · digits: "
                               "place in % · Esc: back");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!isChosen() || offers.held() != Qt::NoModifier)
            return;
        offers.add(ToolOffers::Drag, tr("Drag a branch: its fork slides along its parent"));
        offers.add(ToolOffers::Click, tr("Click: type its place"));
    }
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    std::vector<Index> affected(const LimbHit& limb) override;
    [[nodiscard]] bool isChanged() const override { return m_changed; }
    void turnWheel(double notches) override
    {
        m_turned += anglePerNotch * notches;
        m_changed = true;
    }
    void show() override;

private:
    /// A limb as it stood before.
    struct Fork
    {
        std::uint64_t address = 0;
        double at = 0.0, azimuth = 0.0;
        double way = 1.0; ///< -1: it turns the other way round
    };
    /// A piece of the parent in the picture.
    struct Piece
    {
        glm::dvec2 start, end; ///< logical pixels
        double from, to;       ///< share of the parent
    };
    Expected<void> findForks(HandEdit& gesture, const LimbHit& limb);
    void lookAtParent(const LimbHit& limb, const PickView& view);
    [[nodiscard]] std::optional<double> shareNear(const glm::dvec2& pixel) const;
    void aimAtOther(const ToolPoint& point);
    [[nodiscard]] TreeEdit editOf(const Fork& fork) const;

    NodeId m_node = noNode;
    LimbHit m_limb;
    std::vector<Fork> m_forks; ///< the one under the hand first
    std::vector<Piece> m_parent;
    glm::dvec2 m_aside{0.0}; ///< logical pixels from the hand to the fork
    std::shared_ptr<const PickScene> m_scene;
    std::shared_ptr<const SimplifiedSkeleton> m_tree; ///< that m_scene shows
    std::vector<LimbSpan> m_spans;
    double m_slid = 0.0, m_turned = 0.0;
    std::optional<Fork> m_other; ///< the place on another branch
    bool m_changed = false;
};

std::vector<Index> MoveTool::affected(const LimbHit& limb)
{
    std::vector<Index> all;
    Symmetry symmetry = symmetryOf(limb.node);
    for (const LimbHit& each : withTwins(meantBy(limb), symmetry)) {
        const auto own = m_context.limbs.above(m_context.document, each, true);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

bool MoveTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    if (!limb)
        return false;
    auto gesture = HandEdit::begin(m_context.document, limb->node);
    if (!gesture)
        return refuse(gesture.error());
    m_node = limb->node;
    m_limb = *limb;
    m_slid = m_turned = 0.0;
    m_other.reset();
    m_changed = false;
    if (!report(findForks(**gesture, *limb)))
        return true; // pressed on a branch, and nothing comes of it
    lookAtParent(*limb, point.view);
    m_scene = m_context.host.pickScene({});
    m_tree = limb->simplified;
    m_spans = m_context.limbs.spans(m_context.document, m_node);
    const auto branches = m_context.limbs.limb(m_context.document, m_node, limb->address);
    const glm::dvec3 foot = m_tree->skeleton.p0[branches.front()];
    const auto seen = point.view.pixel(glm::dvec3(worldOf(m_node) * glm::dvec4(foot, 1.0)));
    m_aside = seen ? *seen - point.pixel() : glm::dvec2(0.0);
    start(std::move(*gesture), point);
    return true;
}

/// Of all limbs that are meant; those that cannot be moved are left out. An edit of a moment ago is gone on
/// with.
Expected<void> MoveTool::findForks(HandEdit& gesture, const LimbHit& limb)
{
    m_forks.clear();
    std::vector<LimbHit> limbs = meantBy(limb);
    std::stable_partition(limbs.begin(), limbs.end(),
                          [&](const LimbHit& each) { return each.address == limb.address; });
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, limb.node);
    Symmetry symmetry = symmetryOf(limb.node);
    if (limbs.size() == 1 && !symmetry.isOn())
        gesture.resume(EditOperation::Move, limb.address);
    Expected<void> done;
    std::set<std::uint64_t> seen;
    std::vector<LimbTwin> all;
    for (const LimbHit& each : limbs)
        all.push_back({each.axis, each.address, {}});
    for (const LimbHit& each : limbs)
        std::ranges::move(symmetry.twins(each.axis), std::back_inserter(all));
    for (const LimbTwin& each : all) {
        const Axis& axis = axes->axes[each.axis];
        const Fork fork{each.address, axis.share, axis.azimuth, each.map.angle(1.0)};
        if (!seen.insert(each.address).second)
            continue;
        done = gesture.context().prepared(editOf(fork), true).and_then([&](const TreeEdit& edit) {
            return gesture.context().tried(edit);
        });
        if (done)
            m_forks.push_back(fork);
        else if (m_forks.empty())
            return done; // not even the one under the hand
    }
    reportMissing(symmetry);
    return {};
}

void MoveTool::lookAtParent(const LimbHit& limb, const PickView& view)
{
    m_parent.clear();
    const TreeAxes& axes = *m_context.limbs.axes(m_context.document, limb.node);
    const Axis& parent = axes.axes[axes.axes[limb.axis].parent];
    const std::vector<LimbSpan> spans = m_context.limbs.spans(m_context.document, limb.node);
    const Skeleton& skeleton = limb.simplified->skeleton;
    const glm::dmat4 world = worldOf(limb.node);
    for (const Index b : m_context.limbs.limb(m_context.document, limb.node, parent.address)) {
        const auto start = view.pixel(glm::dvec3(world * glm::dvec4(skeleton.p0[b], 1.0)));
        const auto end = view.pixel(glm::dvec3(world * glm::dvec4(skeleton.p1[b], 1.0)));
        if (start && end && parent.length > 0.0)
            m_parent.push_back({*start, *end, spans[b].from / parent.length, spans[b].to / parent.length});
    }
}

std::optional<double> MoveTool::shareNear(const glm::dvec2& pixel) const
{
    std::optional<double> share;
    double nearest = 0.0;
    for (const Piece& piece : m_parent) {
        const glm::dvec2 way = piece.end - piece.start;
        const double squared = glm::dot(way, way);
        const double t =
            squared > 0.0 ? std::clamp(glm::dot(pixel - piece.start, way) / squared, 0.0, 1.0) : 0.0;
        const double away = glm::length(pixel - piece.start - t * way);
        if (!share || away < nearest) {
            nearest = away;
            share = glm::mix(piece.from, piece.to, t);
        }
    }
    return share;
}

void MoveTool::drag(const ToolPoint& point)
{
    if (!edit() || isByKeys() || (!point.isDrag() && !m_changed))
        return setAt(point.at);
    const QPointF way = point.at - at();
    setAt(point.at);
    m_changed = true;
    m_other.reset();
    if (point.held.testFlag(Qt::ControlModifier) && m_forks.size() == 1)
        aimAtOther(point);
    else if (point.held.testFlag(Qt::ShiftModifier))
        m_turned += anglePerPixel * way.x();
    else if (const auto share = shareNear(point.pixel() + m_aside))
        m_slid = *share - m_forks.front().at;
    show();
}

/// The branch under the cursor, on the side that is seen.
void MoveTool::aimAtOther(const ToolPoint& point)
{
    const auto hit = m_scene ? m_scene->pick(point.view, point.pixel()) : std::nullopt;
    if (!hit || hit->node != m_node || hit->branch >= m_spans.size())
        return;
    const Skeleton& skeleton = m_tree->skeleton;
    const LimbSpan& span = m_spans[hit->branch];
    const double length = edit()->context().lengthOf(span.address);
    const glm::dvec3 from = skeleton.p0[hit->branch], way = skeleton.p1[hit->branch] - from;
    const glm::dvec3 place(glm::inverse(worldOf(m_node)) * glm::dvec4(hit->point, 1.0));
    const double t = std::clamp(glm::dot(place - from, way) / std::max(glm::dot(way, way), 1e-18), 0.0, 1.0);
    const double share = length > 0.0 ? std::clamp(glm::mix(span.from, span.to, t) / length, 0.0, 1.0) : 0.0;
    const auto frame = edit()->context().frameOn(span.address, share);
    if (!frame)
        return;
    const glm::dvec3 aside = place - from - t * way;
    m_other = Fork{span.address, share,
                   std::atan2(glm::dot(aside, frame->binormal), glm::dot(aside, frame->normal))};
}

TreeEdit MoveTool::editOf(const Fork& fork) const
{
    TreeEdit edit;
    edit.operation = EditOperation::Move;
    edit.target.address = fork.address;
    const Fork& place = m_other ? *m_other : fork;
    if (m_other)
        edit.other.address = m_other->address;
    const auto percent = typed().value();
    edit.at = std::clamp(percent ? *percent / 100.0 : place.at + (m_other ? 0.0 : m_slid), 0.0, 1.0);
    edit.azimuthRad = place.azimuth + fork.way * m_turned;
    return edit;
}

/// As far as it goes: onto itself a limb cannot be put, and stays where it was last.
void MoveTool::show()
{
    std::vector<TreeEdit> edits;
    for (const Fork& fork : m_forks)
        edits.push_back(editOf(fork));
    if (edit()->replace(edits))
        report(edit()->show());
    m_context.host.repaint();
}

void MoveTool::paint(QPainter& painter, const PickView& view)
{
    const LimbHit* limb = edit() ? &m_limb : aim() ? &*aim() : nullptr;
    if (limb && !edit())
        paintRing(painter, view, worldOf(limb->node), *limb, handGreen);
    if (!edit())
        return;
    painter.setPen(QPen(handGreen, 1.6, Qt::DashLine));
    for (const Piece& piece : m_parent)
        painter.drawLine(QPointF(piece.start.x, piece.start.y), QPointF(piece.end.x, piece.end.y));
    const TreeEdit now = editOf(m_forks.front());
    const double angle = std::remainder(now.azimuthRad / oneDegree, 360.0);
    QString text = typed().isEmpty() ? tr("at %1 % · %2°")
                                           .arg(QLocale().toString(100.0 * now.at, 'f', 0),
                                                QLocale().toString(angle, 'f', 0))
                                     : tr("at %1 %").arg(typed().text());
    if (isByKeys() && typed().isEmpty() && !m_changed)
        text += tr(" · type a number");
    paintReadout(painter, at(), sizeOf(view), text);
}

} // namespace

std::unique_ptr<Tool> makeMoveTool(ToolContext& context)
{
    return std::make_unique<MoveTool>(context, HandTool::Move);
}

} // namespace ramure
