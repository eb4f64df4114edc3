// A limb follows the hand: seen at once as a pose, made anew when the hand rests or lets go.
#include "core/evaluate/evaluator.h"
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include "widgets/view/tools/hand/limb_drag.h"
#include "widgets/view/tools/pending_pick.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <map>
#include <utility>

namespace ramure {
namespace {

/// How long the hand rests before the mesh of its bends is made.
constexpr int bendRestMs = 100;

class LimbTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::LimbTool)
public:
    explicit LimbTool(ToolContext& context);

    bool press(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override { finish(false); }
    bool wheel(const ToolPoint& point, double turn) override;
    [[nodiscard]] bool takesKeys() const override { return true; }
    void key(const QKeyEvent& event, bool pressed) override;
    void documentChanged(const Change& change) override;
    void playingStopped() override;

    [[nodiscard]] QString hint(Qt::KeyboardModifiers held) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

private:
    void show();
    void apply();
    void findTwins(const PickHit& hit, const PickView& view);
    void finish(bool keep);

    std::unique_ptr<LimbDrag> m_drag; ///< while it goes on
    bool m_moves = false;             ///< the pointer has left the place of the press
    std::size_t m_branches = LimbDrag::usualBranches;
    QTimer m_rest;
};

LimbTool::LimbTool(ToolContext& context)
    : Tool(context)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(bendRestMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { apply(); });
}

bool LimbTool::press(const ToolPoint& point)
{
    if (point.button != Qt::LeftButton || !point.held.testFlag(Qt::ControlModifier))
        return false;
    const auto scene = m_context.host.pickScene(shapePatience);
    auto hit = scene ? scene->pick(point.view, point.pixel()) : std::nullopt;
    const Node* node = hit ? m_context.document.scene().find(hit->node) : nullptr;
    if (!node || node->kind != NodeKind::Tree)
        return false;
    const auto branch = m_context.limbs.inDocument(m_context.document, hit->node, {hit->branch});
    hit->branch = branch.empty() ? noIndex : branch.front();
    m_drag = LimbDrag::grab(m_context.document, *hit, m_branches);
    if (!m_drag)
        return false;
    findTwins(*hit, point.view);
    m_moves = false;
    m_context.limbPose =
        std::make_unique<LimbPose>(m_drag->node(), m_drag->skeleton(), m_drag->bendsAtGrab());
    m_context.limbPose->setHeld(true);
    m_drag->setWhole(point.held.testFlag(Qt::ShiftModifier));
    return true;
}

/// Branch by branch down the limb: those at the same share of a limb that is like it around the trunk.
void LimbTool::findTwins(const PickHit& hit, const PickView& view)
{
    LimbFinder& limbs = m_context.limbs;
    const Document& document = m_context.document;
    const TreeAxes* axes = limbs.axes(document, hit.node);
    if (!axes || axes->axes.empty())
        return;
    const TreeResult& tree = *limbs.tree(document, hit.node);
    const glm::dmat4 world = EvaluatedScene(document.scene()).transforms(hit.node).geometry;
    const glm::dvec3 eye(glm::inverse(world) * glm::dvec4(view.camera.eye(), 1.0));
    Symmetry symmetry(*axes, *tree.skeleton, m_context.hand.options(), tree.skeleton->p0[0] - eye);
    if (!symmetry.isOn() || m_context.hand.tool() != HandTool::Bend)
        return;
    const Skeleton& seen = m_drag->skeleton()->skeleton;
    const std::vector<LimbSpan> spans = limbs.spans(document, hit.node);
    if (spans.size() != seen.size())
        return; // another tree is shown
    std::map<Index, std::vector<LimbTwin>> byAxis;
    std::vector<BranchTwin> twins;
    for (Index b = hit.branch; b != noIndex; b = seen.parent[b]) {
        const auto limb = limbs.startOf(document, hit.node, b);
        if (!limb || axes->axes[limb->axis].parent == noIndex)
            continue; // a trunk has no other
        auto [own, isNew] = byAxis.try_emplace(limb->axis);
        if (isNew)
            own->second = symmetry.twins(limb->axis);
        for (const LimbTwin& twin : own->second) {
            const double middle = 0.5 * (spans[b].from + spans[b].to) / axes->axes[limb->axis].length *
                                  axes->axes[twin.axis].length;
            Index there = noIndex;
            for (const Index other : limbs.limb(document, hit.node, twin.address))
                if (spans[other].from <= middle || there == noIndex)
                    there = other;
            if (there != noIndex && std::ranges::count(twins, there, &BranchTwin::to) == 0)
                twins.push_back({b, there, twin.map});
        }
    }
    m_drag->setTwins(std::move(twins));
    if (symmetry.missing() > 0)
        m_context.host.raiseMessage(tr("At some places around the trunk no limb is like it: nothing happens "
                                       "there."));
}

void LimbTool::drag(const ToolPoint& point)
{
    m_drag->setWhole(point.held.testFlag(Qt::ShiftModifier));
    m_moves = m_moves || point.isDrag();
    if (!m_moves)
        return;
    m_drag->dragTo(point.view, point.pixel());
    show();
}

/// A branch that was clicked, not dragged, is selected.
void LimbTool::release(const ToolPoint& point)
{
    finish(true);
    if (!m_moves)
        m_context.picks->click(point.at, point.held.testFlag(Qt::ShiftModifier));
}

bool LimbTool::wheel(const ToolPoint&, double turn)
{
    if (!isBusy())
        return false;
    const auto next = static_cast<std::int64_t>(m_drag->branches()) + (turn > 0.0 ? 1 : -1);
    m_drag->setBranches(static_cast<std::size_t>(std::max<std::int64_t>(next, 1)));
    m_branches = m_drag->branches();
    show();
    return true;
}

void LimbTool::key(const QKeyEvent& event, bool pressed)
{
    if (event.key() != Qt::Key_Shift)
        return;
    m_drag->setWhole(pressed);
    show();
}

void LimbTool::show()
{
    m_context.limbPose->setBends(m_drag->bends());
    m_rest.start();
    m_context.host.repaint();
}

void LimbTool::apply()
{
    if (m_drag && m_drag->apply())
        m_context.limbPose->noteEdit(m_context.document.revision(), m_drag->bends());
}

/// \param keep else everything is as it was, or as the document has kept it
void LimbTool::finish(bool keep)
{
    m_rest.stop();
    LimbPose& pose = *m_context.limbPose;
    if (keep) {
        apply();
    } else {
        m_drag->cancel();
        pose.noteEdit(m_context.document.revision(), m_drag->bendsNow());
    }
    m_drag.reset();
    pose.setBends(pose.latest());
    pose.setHeld(false);
    m_context.forgetLimbAtRest();
    m_context.host.repaint();
}

void LimbTool::documentChanged(const Change& change)
{
    if (!change.has(changeReset))
        return;
    if (isBusy()) {
        end();
        finish(false);
    }
    m_context.limbPose.reset();
}

void LimbTool::playingStopped()
{
    if (!isBusy())
        return;
    end();
    finish(true);
}

QString LimbTool::hint(Qt::KeyboardModifiers held) const
{
    return held.testFlag(Qt::ShiftModifier)
               ? tr("The limb and its thick branches follow · wheel: how many branches · Esc: back")
               : tr("The limb follows · wheel: how many branches · Shift: trunk and root, too · Esc: back");
}

void LimbTool::offer(ToolOffers& offers) const
{
    if (m_context.isPlaying() || !m_context.isOverBranch())
        return;
    if (offers.held() == Qt::NoModifier)
        offers.add(ToolOffers::Drag, tr("Ctrl + drag: bend the limb"));
    else if (offers.held() == Qt::ControlModifier)
        offers.add(ToolOffers::Drag, tr("Ctrl: drag bends the limb (with Shift: trunk and root, too)"));
}

void LimbTool::paint(QPainter& painter, const PickView& view)
{
    const auto hand = m_drag ? gizmoPixel(view, m_drag->hand()) : std::nullopt;
    if (!hand)
        return;
    painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
    painter.setBrush(QColor(90, 200, 90));
    painter.drawEllipse(*hand, 5.0, 5.0);
    const int branches = static_cast<int>(m_drag->branches());
    QString text = branches > 0 ? tr("%n branch(es) follow", nullptr, branches)
                                : tr("The root stays; with Shift it follows");
    if (m_drag->shortBy() > 1e-3)
        text += QLatin1Char('\n') +
                tr("out of reach: %1 m short").arg(QLocale().toString(m_drag->shortBy(), 'f', 3));
    const QRectF place(*hand + QPointF(14.0, -10.0), QSizeF(420.0, 60.0));
    painter.setPen(QColor(0, 0, 0, 160));
    painter.drawText(place.translated(1.0, 1.0), text);
    painter.setPen(Qt::white);
    painter.drawText(place, text);
}

} // namespace

std::unique_ptr<Tool> makeLimbTool(ToolContext& context)
{
    return std::make_unique<LimbTool>(context);
}

} // namespace ramure
