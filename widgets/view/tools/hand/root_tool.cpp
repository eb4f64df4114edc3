// The foot of a trunk goes over the ground, and flares.
#include "widgets/view/tools/hand/number_tool.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double leastFlare = 0.1, mostFlare = 20.0;

class RootTool : public NumberTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::RootTool)
public:
    using NumberTool::NumberTool;

    void drag(const ToolPoint& point) override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return isByKeys() ? tr("Digits: flare · wheel: more or less · Enter or click: done · Esc: back")
                          : tr("Release: done · Ctrl, wheel or digits: flare of the foot · Esc: back");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!isChosen() || offers.held() != Qt::NoModifier)
            return;
        offers.add(ToolOffers::Drag, tr("Drag the tree: its foot goes over the ground"));
        offers.add(ToolOffers::Click, tr("Click: type how wide its foot is"));
    }
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    std::vector<Index> affected(const LimbHit& limb) override;
    [[nodiscard]] bool isChanged() const override { return m_changed; }
    void turnWheel(double notches) override
    {
        m_flare *= std::pow(factorPerNotch, notches);
        m_changed = true;
    }
    void show() override;

private:
    LimbHit rootOf(const LimbHit& limb);
    [[nodiscard]] double flare() const;

    NodeId m_node = noNode;
    glm::dmat4 m_world{1.0};
    LimbHit m_foot;          ///< before the gesture
    TreeEdit m_before;       ///< of the gesture that is gone on with
    glm::dvec2 m_aside{0.0}; ///< logical pixels from the hand to the foot
    glm::dvec3 m_moved{0.0}; ///< m, tree space
    double m_flare = 1.0;
    bool m_changed = false;
};

/// The trunk that carries a limb.
LimbHit RootTool::rootOf(const LimbHit& limb)
{
    const TreeAxes& axes = *m_context.limbs.axes(m_context.document, limb.node);
    LimbHit root = limb;
    while (axes.axes[root.axis].parent != noIndex)
        root.axis = axes.axes[root.axis].parent;
    root.address = axes.axes[root.axis].address;
    const auto branches = m_context.limbs.limb(m_context.document, limb.node, root.address);
    const Skeleton& skeleton = m_context.limbs.tree(m_context.document, limb.node)->simplified->skeleton;
    root.share = 0.0;
    root.along = {0.0, 1.0, 0.0};
    root.seen = skeleton.p0[branches.front()];
    root.radius = skeleton.a0[branches.front()];
    return root;
}

std::vector<Index> RootTool::affected(const LimbHit& limb)
{
    return m_context.limbs.above(m_context.document, rootOf(limb), true);
}

bool RootTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    if (!limb)
        return false;
    auto gesture = HandEdit::begin(m_context.document, limb->node);
    if (!gesture)
        return refuse(gesture.error());
    m_node = limb->node;
    m_world = worldOf(m_node);
    m_foot = rootOf(*limb);
    m_moved = glm::dvec3(0.0);
    m_flare = 1.0;
    m_changed = false;
    if (!(*gesture)->resume(EditOperation::Root, m_foot.address)) {
        TreeEdit root;
        root.operation = EditOperation::Root;
        root.target.address = m_foot.address;
        if (!report((*gesture)->add(root)))
            return true; // pressed on a tree, and nothing comes of it
    }
    m_before = (*gesture)->edits().front();
    const auto seen = point.view.pixel(glm::dvec3(m_world * glm::dvec4(m_foot.seen, 1.0)));
    m_aside = seen ? *seen - point.pixel() : glm::dvec2(0.0);
    start(std::move(*gesture), point);
    return true;
}

/// In the level plane of the foot; above the horizon there is none.
void RootTool::drag(const ToolPoint& point)
{
    const double way = point.at.x() - at().x();
    setAt(point.at);
    if (!edit() || isByKeys() || (!point.isDrag() && !m_changed))
        return;
    if (point.held.testFlag(Qt::ControlModifier)) {
        m_flare *= std::exp2(way / pixelsPerDouble);
    } else {
        const glm::dmat4 inverse = glm::inverse(m_world);
        const ViewRay ray =
            point.view.camera.ray(point.view.ndc(point.pixel() + m_aside), point.view.aspect());
        const glm::dvec3 eye(inverse * glm::dvec4(ray.origin, 1.0)),
            sight(inverse * glm::dvec4(ray.direction, 0.0));
        const double share = (m_foot.seen.y - eye.y) / sight.y;
        if (share > 0.0 && std::isfinite(share))
            m_moved = eye + share * sight - m_foot.seen;
        m_moved.y = 0.0;
    }
    m_changed = true;
    show();
}

double RootTool::flare() const
{
    return std::clamp(typed().value().value_or(m_before.factor * m_flare), leastFlare, mostFlare);
}

void RootTool::show()
{
    TreeEdit& root = edit()->edits().front();
    root.offset = m_before.offset + m_moved;
    root.factor = flare();
    report(edit()->show());
    m_context.host.repaint();
}

void RootTool::paint(QPainter& painter, const PickView& view)
{
    if (!edit()) {
        if (aim())
            paintRing(painter, view, worldOf(aim()->node), rootOf(*aim()), handGreen);
        return;
    }
    LimbHit foot = m_foot;
    foot.seen += m_moved;
    foot.radius *= flare() / m_before.factor;
    paintRing(painter, view, m_world, foot, handGreen);
    const auto metres = [](double value) { return QLocale().toString(value, 'f', 2); };
    QString text = typed().isEmpty()
                       ? tr("%1 m · foot × %2").arg(metres(glm::length(m_moved)), metres(flare()))
                       : tr("foot × %1").arg(typed().text());
    if (isByKeys() && typed().isEmpty() && !m_changed)
        text += tr(" · type a number");
    paintReadout(painter, at(), sizeOf(view), text);
}

} // namespace

std::unique_ptr<Tool> makeRootTool(ToolContext& context)
{
    return std::make_unique<RootTool>(context, HandTool::Root);
}

} // namespace ramure
