// The wind of trees: arrows whose heads are dragged.
#include "core/rig/physics/wind.h"
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr double headReach = 12.0;  ///< logical pixels around the arrow's head
constexpr double headLength = 13.0; ///< logical pixels
constexpr std::size_t mostArrows = 64;

void paintArrow(QPainter& painter, QPointF foot, QPointF head, bool held)
{
    const QColor colour = held ? QColor(255, 200, 80) : QColor(120, 205, 255);
    QPointF way = head - foot;
    const double length = std::hypot(way.x(), way.y());
    way = length > 1e-6 ? way / length : QPointF(1.0, 0.0);
    const QPointF across(-way.y(), way.x());
    for (const auto& [width, ink] : {std::pair{6.0, QColor(20, 40, 60, 150)}, std::pair{3.0, colour}}) {
        painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(foot, head);
        painter.drawLine(head, head - headLength * way + 0.5 * headLength * across);
        painter.drawLine(head, head - headLength * way - 0.5 * headLength * across);
    }
    painter.setPen(QPen(QColor(20, 40, 60, 190), 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(foot, 4.0, 4.0);
    painter.drawEllipse(head, 5.0, 5.0);
}

/// The box of a tree at rest, its own space: what stands on a tree that sways must not sway with it.
Box treeBox(const RenderScene& scene, NodeId node)
{
    Box box;
    for (const MeshItem& item : scene.meshes)
        if (item.node == node)
            box.add(item.box);
    for (const LineItem& item : scene.lines)
        if (item.node == node)
            box.add(item.lines->box);
    return box;
}

class WindTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::WindTool)
public:
    using Tool::Tool;

    bool press(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint&) override { m_context.document.keepGesture(m_gesture); }
    void cancel() override { m_context.document.giveUpGesture(m_gesture); }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        const Node* tree = m_context.document.scene().find(m_taken.node);
        const double strength = tree ? tree->params.physics.windStrength : 0.0;
        return tr("Length: strength of the wind, %1 × (about %2 m/s) · release: done")
            .arg(QLocale().toString(strength, 'f', 2),
                 QLocale().toString(strength * robustWindSpeed, 'f', 1));
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        for (const WindArrow& arrow : arrows(view)) {
            const auto foot = gizmoPixel(view, arrow.foot), head = gizmoPixel(view, arrow.head);
            if (foot && head)
                paintArrow(painter, *foot, *head, isBusy());
        }
    }

private:
    [[nodiscard]] std::vector<WindArrow> arrows(const PickView& view) const;

    WindArrow m_taken;
    GestureId m_gesture = 0;
};

std::vector<WindArrow> WindTool::arrows(const PickView& view) const
{
    if (!m_context.host.isWindVisible())
        return {};
    const EvaluatedScene now(m_context.document.scene(), m_context.seconds());
    if (isBusy()) { // it grows and turns under the hand, but stays where it was taken
        const auto held = windArrow(now, m_taken.node, m_taken.foot, m_taken.reach);
        return held ? std::vector{*held} : std::vector<WindArrow>();
    }
    const NodeId active = m_context.document.selection().activeNode();
    const auto trees = windyTrees(now.scene(), active, mostArrows);
    const auto* shown = std::get_if<std::vector<NodeId>>(&trees);
    if (!shown)
        return {};
    std::vector<WindArrow> arrows;
    for (const NodeId tree : *shown) {
        const bool stays = tree == active || shown->size() == 1;
        const Box box = treeBox(m_context.host.sceneAtRest(), tree);
        if (const auto arrow = windArrowOver(now, tree, box, view, stays))
            arrows.push_back(*arrow);
    }
    return arrows;
}

bool WindTool::press(const ToolPoint& point)
{
    if (point.button != Qt::LeftButton || point.held != Qt::NoModifier)
        return false;
    for (const WindArrow& arrow : arrows(point.view)) {
        const auto head = gizmoPixel(point.view, arrow.head);
        if (!head || std::hypot(head->x() - point.at.x(), head->y() - point.at.y()) > headReach ||
            m_context.document.scene().isLocked(arrow.node))
            continue;
        m_taken = arrow;
        m_gesture = newGesture();
        m_context.document.holdGesture(m_gesture);
        return true;
    }
    return false;
}

void WindTool::drag(const ToolPoint& point)
{
    const auto values = windAt(point.view, point.pixel(), m_taken,
                               EvaluatedScene(m_context.document.scene(), m_context.seconds()));
    if (values)
        edit::setParams(m_context.document, {m_taken.node},
                        {{findParam("physics.windStrength"), values->strength},
                         {findParam("physics.windDirection"), values->directionRad}},
                        tr("Change the wind"), m_gesture);
    m_context.host.repaint();
}

} // namespace

std::unique_ptr<Tool> makeWindTool(ToolContext& context)
{
    return std::make_unique<WindTool>(context);
}

} // namespace ramure
