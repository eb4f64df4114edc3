// One leaf, fruit or flower where the hand wants it.
#include "core/params/tree_edit_table.h"
#include "widgets/base/core_text.h"
#include "widgets/view/tools/edit_tool.h"
#include "widgets/view/tools/tool_table.h"
#include "widgets/view/tools/turned_limb.h"
#include <QCoreApplication>
#include <QPainter>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

class PlaceTool : public ClickTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::PlaceTool)
public:
    explicit PlaceTool(ToolContext& context)
        : ClickTool(context, HandTool::Place)
    {
    }

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
    auto gesture = HandEdit::begin(m_context.document, limb.node);
    if (!gesture)
        return tl::unexpected(gesture.error());
    const HandOptions& options = m_context.hand.options();
    const auto frame = (*gesture)->context().frameOn(limb.address, limb.share);
    const glm::dvec3 aside = TurnedLimb(m_context.document, limb).direction(limb.aside);
    const double azimuth =
        frame ? std::atan2(glm::dot(aside, frame->binormal), glm::dot(aside, frame->normal)) : 0.0;
    std::vector<TreeEdit> edits;
    for (int copy = 0; copy < options.copies; ++copy) {
        TreeEdit edit;
        edit.operation = EditOperation::Place;
        edit.target.address = limb.address;
        edit.at = limb.share;
        edit.azimuthRad = azimuth + 2.0 * std::numbers::pi * copy / options.copies;
        edit.factor = options.organSize;
        edit.organ = options.organ;
        edits.push_back(std::move(edit));
    }
    auto done = (*gesture)->replace(edits).and_then([&] { return (*gesture)->show(); });
    done ? (*gesture)->keep() : (*gesture)->cancel();
    if (done)
        sayWhatItIs(limb.node);
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
    return std::make_unique<PlaceTool>(context);
}

} // namespace ramure
