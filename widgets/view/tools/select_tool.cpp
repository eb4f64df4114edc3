// A click selects, a drag selects by a box; Shift adds.
#include "widgets/view/tools/pending_pick.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>

namespace ramure {
namespace {

class SelectTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::SelectTool)
public:
    using Tool::Tool;

    [[nodiscard]] bool goesOn() const override { return isBusy() && m_isBox; }
    bool press(const ToolPoint& point) override
    {
        m_isBox = false;
        return point.button == Qt::LeftButton;
    }
    void drag(const ToolPoint& point) override
    {
        m_isBox = m_isBox || point.isDrag();
        m_box = QRectF(point.pressed, point.at).normalized();
        m_context.host.repaint();
    }
    void release(const ToolPoint& point) override
    {
        const bool extend = point.held.testFlag(Qt::ShiftModifier);
        if (m_isBox)
            m_context.picks->box(point.pressed, point.at, extend);
        else
            m_context.picks->click(point.at, extend);
    }

    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("Everything in the box is selected · Shift: added");
    }
    void offer(ToolOffers& offers) const override
    {
        if (m_context.hand.tool() != HandTool::None)
            return;
        const bool overBranch = m_context.isOverBranch();
        const bool overNode = m_context.document.scene().find(m_context.hoverNode) != nullptr;
        if (offers.held() == Qt::ShiftModifier)
            offers.add(ToolOffers::Click, overBranch || overNode
                                              ? tr("Shift: click adds or takes away, drag adds a box")
                                              : tr("Shift: drag adds a box"));
        if (offers.held() != Qt::NoModifier)
            return;
        if (!m_context.isPlaying())
            offers.add(ToolOffers::Click, overBranch ? tr("Click: limb · again: this branch of it")
                                          : overNode ? tr("Click: select")
                                                     : tr("Click: select nothing"));
        if (!m_context.document.selection().branches.empty())
            offers.add(ToolOffers::Keys, tr("Esc: only the tree"));
        offers.add(ToolOffers::More, tr("Shift: add"));
        offers.add(ToolOffers::More, tr("drag: box"));
    }
    void paint(QPainter& painter, const PickView&) override
    {
        if (!goesOn())
            return;
        QColor colour = QGuiApplication::palette().color(QPalette::Highlight);
        painter.setPen(QPen(colour, 1.0, Qt::DashLine));
        colour.setAlpha(40);
        painter.setBrush(colour);
        painter.drawRect(m_box);
    }

private:
    bool m_isBox = false; ///< the pointer has left the place of the press
    QRectF m_box;
};

} // namespace

std::unique_ptr<Tool> makeSelectTool(ToolContext& context)
{
    return std::make_unique<SelectTool>(context);
}

} // namespace ramure
