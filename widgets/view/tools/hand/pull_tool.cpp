// While trees move: the hand pulls a branch, and shakes apples off.
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QPainter>

namespace ramure {
namespace {

constexpr double pullStrength = 8.0; ///< of the hand, see Pull

class PullTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::PullTool)
public:
    using Tool::Tool;

    /// With Ctrl, too: as limbs are bent at rest.
    bool press(const ToolPoint& point) override
    {
        const bool free = point.held == Qt::NoModifier || point.held.testFlag(Qt::ControlModifier);
        if (!m_context.isPlaying() || point.button != Qt::LeftButton || !free)
            return false;
        const auto grabbed =
            branchUnder(point.view, point.pixel(), m_context.document, *m_context.player->motion());
        if (!grabbed)
            return false;
        m_grabbed = *grabbed;
        pull(point);
        return true;
    }
    void drag(const ToolPoint& point) override { pull(point); }
    void release(const ToolPoint&) override { letGo(); }
    void cancel() override { letGo(); }
    bool doubleClick(const ToolPoint& point) override
    {
        if (!m_context.isPlaying() || point.button != Qt::LeftButton)
            return false;
        const auto apple =
            appleUnder(point.view, point.pixel(), m_context.document, *m_context.player->motion());
        if (apple)
            m_context.player->shakeOff(apple->node, apple->apple);
        return apple.has_value();
    }
    void playingStopped() override
    {
        if (!isBusy())
            return;
        end();
        letGo();
    }

    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("The branch is pulled · release: it swings back");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!m_context.isPlaying())
            return;
        if (offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Drag, tr("Drag: pull the branch · double click an apple: it falls"));
        else if (offers.held() == Qt::ControlModifier)
            offers.add(ToolOffers::Drag, tr("Ctrl: drag pulls the branch"));
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        const auto hand = isBusy() ? gizmoPixel(view, m_hand) : std::nullopt;
        if (!hand)
            return;
        painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
        painter.setBrush(QColor(255, 140, 30));
        painter.drawEllipse(*hand, 5.0, 5.0);
    }

private:
    void pull(const ToolPoint& point)
    {
        m_hand = pulledTo(point.view, point.pixel(), m_grabbed.point);
        const glm::dmat4 inverse =
            glm::inverse(m_context.player->motion()->geometryOf(m_context.document.scene(), m_grabbed.node));
        m_context.player->setPull(m_grabbed.node,
                                  Pull{m_grabbed.branch, m_grabbed.along,
                                       glm::dvec3(inverse * glm::dvec4(m_hand, 1.0)), pullStrength});
        m_context.host.repaint();
    }
    void letGo() { m_context.player->setPull(m_grabbed.node, {}); }

    GrabbedBranch m_grabbed;
    glm::dvec3 m_hand{0.0}; ///< world
};

} // namespace

std::unique_ptr<Tool> makePullTool(ToolContext& context)
{
    return std::make_unique<PullTool>(context);
}

} // namespace ramure
