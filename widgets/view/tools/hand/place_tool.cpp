// One leaf, fruit or flower where the hand wants it.
#include "core/params/tree_edit_table.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QPainter>

namespace ramure {
namespace {

class PlaceTool : public ClickTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::PlaceTool)
public:
    using ClickTool::ClickTool;

    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("Release: it grows here, on the side that was clicked · Esc: not at all");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!isChosen() || offers.held() != Qt::NoModifier)
            return;
        switch (m_context.hand.options().organ) {
        case EditOrgan::Leaf:
            return offers.add(ToolOffers::Click, tr("Click a branch: a leaf grows there"));
        case EditOrgan::Fruit:
            return offers.add(ToolOffers::Click, tr("Click a branch: a fruit hangs there"));
        case EditOrgan::Flower:
            return offers.add(ToolOffers::Click, tr("Click a branch: a flower opens there"));
        }
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        if (aim())
            paintRing(painter, view, worldOf(aim()->node), *aim(), handGreen);
    }

protected:
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers) override;

private:
    void sayWhatItIs(NodeId tree);
};

Expected<void> PlaceTool::act(const LimbHit& limb, Qt::KeyboardModifiers)
{
    const HandOptions& options = m_context.hand.options();
    TreeEdit edit;
    edit.operation = EditOperation::Place;
    edit.factor = options.organSize;
    edit.organ = options.organ;
    auto done = putAround(m_context.document, limb, std::move(edit), options.copies);
    if (done) {
        m_context.host.showOrgans(options.organ); // a click that nothing follows would be made again
        sayWhatItIs(limb.node);
    }
    return done;
}

/// A tree bears one kind: who asks for a flower on an apple tree gets what it bears, and is told.
void PlaceTool::sayWhatItIs(NodeId tree)
{
    const FruitKind kind = m_context.document.scene().find(tree)->params.fruit.kind;
    const EditOrgan wanted = m_context.hand.options().organ;
    const bool blooms = kind == FruitKind::Blossom;
    if (wanted == EditOrgan::Flower && !blooms)
        m_context.host.raiseMessage(tr("This tree bears fruit: one was put there. “Fruit” in its "
                                       "parameters makes flowers of all."));
    else if (wanted == EditOrgan::Fruit && blooms)
        m_context.host.raiseMessage(tr("This tree blooms: a flower was put there. “Fruit” in its "
                                       "parameters makes fruit of all."));
}

} // namespace

std::unique_ptr<Tool> makePlaceTool(ToolContext& context)
{
    return std::make_unique<PlaceTool>(context, HandTool::Place);
}

} // namespace ramure
