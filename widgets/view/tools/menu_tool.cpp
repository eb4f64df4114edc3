// A right click asks for a menu when the button is let go; a drag with it does not.
#include "widgets/view/tools/pending_pick.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>

namespace ramure {
namespace {

class MenuTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::MenuTool)
public:
    using Tool::Tool;

    [[nodiscard]] bool goesOn() const override { return false; }
    bool press(const ToolPoint& point) override { return point.button == Qt::RightButton; }
    void release(const ToolPoint& point) override
    {
        if (!point.isDrag())
            m_context.picks->menu(point.at);
    }
    void offer(ToolOffers& offers) const override
    {
        if (offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Menu, tr("right: menu"));
    }
};

} // namespace

std::unique_ptr<Tool> makeMenuTool(ToolContext& context)
{
    return std::make_unique<MenuTool>(context);
}

} // namespace ramure
