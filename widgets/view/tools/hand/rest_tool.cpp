// A hand shapes trees as they have grown, not as the timeline moves them: a press of a shaping tool on a tree
// that moves brings the timeline to the frame where it is at rest, and does nothing else. One on a locked
// tree is refused. Neither selects.
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace ramure {
namespace {

class RestTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::RestTool)
public:
    using Tool::Tool;

    bool press(const ToolPoint& point) override
    {
        if (point.button != Qt::LeftButton || !shapes(point))
            return false;
        if (!isAwayFromRest())
            return refusesLocked(point);
        Player& player = *m_context.player;
        player.pause();
        player.seek(restFrame());
        m_context.host.raiseMessage(
            tr("Trees are shaped at rest: the timeline is at frame %1 now. Press again.").arg(restText()));
        m_context.host.updateHint();
        return true;
    }
    [[nodiscard]] bool goesOn() const override { return false; }
    [[nodiscard]] QString hintAt(const ToolPoint& point) const override
    {
        return shapes(point) && isAwayFromRest()
                   ? tr("Click: to frame %1, where the tree is at rest and can be shaped").arg(restText())
                   : QString();
    }

private:
    [[nodiscard]] bool shapes(const ToolPoint& point) const;
    [[nodiscard]] bool isAwayFromRest() const;
    bool refusesLocked(const ToolPoint& point);
    /// Physics begin at second 0; frames before it show the same.
    [[nodiscard]] std::int64_t restFrame() const
    {
        return std::min<std::int64_t>(m_context.document.scene().timeline().firstFrame, 0);
    }
    [[nodiscard]] QString restText() const { return QLocale().toString(qlonglong(restFrame())); }
};

/// A press here would shape a tree if it were at rest. While it plays, Bend and Ctrl pull instead.
bool RestTool::shapes(const ToolPoint& point) const
{
    const HandTool tool = m_context.hand.tool();
    if (tool == HandTool::Bend && m_context.isPlaying())
        return false;
    if (tool != HandTool::None && point.held == Qt::NoModifier)
        return true;
    if (tool == HandTool::Graft && point.held == Qt::ShiftModifier)
        return true;
    if (tool == HandTool::Bend && point.held == Qt::ShiftModifier)
        return m_context.isOverBranch();
    return point.held.testFlag(Qt::ControlModifier) && !m_context.isPlaying() && m_context.isOverBranch();
}

bool RestTool::isAwayFromRest() const
{
    if (!m_context.player)
        return false;
    const auto motion = m_context.player->motion();
    return m_context.isPlaying() || std::ranges::any_of(motion->nodes, [this](const auto& entry) {
               const Node* node = m_context.document.scene().find(entry.first);
               return node && node->kind == NodeKind::Tree && entry.second.moves();
           });
}

bool RestTool::refusesLocked(const ToolPoint& point)
{
    const auto scene = m_context.host.pickScene(pickPatience);
    const auto hit = scene ? scene->pick(point.view, point.pixel()) : std::nullopt;
    const Node* node = hit ? m_context.document.scene().find(hit->node) : nullptr;
    if (!node || node->kind != NodeKind::Tree || !m_context.document.scene().isLocked(node->id))
        return false;
    m_context.host.raiseMessage(errorText(HandEdit::begin(m_context.document, node->id).error()));
    return true;
}

} // namespace

std::unique_ptr<Tool> makeRestTool(ToolContext& context)
{
    return std::make_unique<RestTool>(context);
}

} // namespace ramure
