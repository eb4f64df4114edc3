// A limb is copied with all on it, and grows somewhere else.
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QPainter>
#include <utility>

namespace ramure {
namespace {

class GraftTool : public ClickTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::GraftTool)
public:
    explicit GraftTool(ToolContext& context)
        : ClickTool(context, HandTool::Graft)
    {
        connect(&context.hand, &HandSettings::toolChanged, this, [this] { m_source.reset(); });
    }

    [[nodiscard]] QString hint(Qt::KeyboardModifiers held) const override
    {
        return copies(held) ? tr("Release: copy this limb · Esc: not this one")
                            : tr("Release: it grows here · Esc: nowhere");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!isChosen())
            return;
        if (offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Click,
                       m_source ? tr("Click: the copy grows here · Shift + click: copy another limb")
                                : tr("Click a limb: copy it"));
        else if (offers.held() == Qt::ShiftModifier)
            offers.add(ToolOffers::Click, tr("Shift: click copies another limb"));
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        if (aim() && m_source)
            paintRing(painter, view, worldOf(aim()->node), *aim(), handGreen);
    }

protected:
    [[nodiscard]] bool takesShift() const override { return true; }
    void forget() override
    {
        ClickTool::forget();
        m_source.reset();
    }
    std::vector<Index> affected(const LimbHit& limb) override
    {
        return m_source ? std::vector<Index>() : m_context.limbs.above(m_context.document, limb, true);
    }
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers held) override
    {
        return copies(held) ? copy(limb) : put(limb);
    }

private:
    struct Source
    {
        NodeId node = noNode;
        std::uint64_t address = 0;
        std::vector<LimbPiece> limb; ///< for other trees
    };
    [[nodiscard]] bool copies(Qt::KeyboardModifiers held) const
    {
        return !m_source || held.testFlag(Qt::ShiftModifier);
    }
    Expected<void> copy(const LimbHit& limb);
    Expected<void> put(const LimbHit& limb);

    std::optional<Source> m_source;
};

Expected<void> GraftTool::copy(const LimbHit& limb)
{
    return HandEdit::begin(m_context.document, limb.node).map([&](std::unique_ptr<HandEdit>&& gesture) {
        m_source = Source{limb.node, limb.address, gesture->context().limb(limb.address)};
        m_context.host.raiseMessage(tr("The limb is copied: click its new place."));
        m_context.host.updateHint();
    });
}

Expected<void> GraftTool::put(const LimbHit& limb)
{
    const HandOptions& options = m_context.hand.options();
    TreeEdit edit;
    edit.operation = EditOperation::Graft;
    edit.factor = options.graftSize;
    if (m_source->node == limb.node)
        edit.other.address = m_source->address;
    else
        edit.limb = m_source->limb;
    return putAround(m_context.document, limb, std::move(edit), options.copies);
}

} // namespace

std::unique_ptr<Tool> makeGraftTool(ToolContext& context)
{
    return std::make_unique<GraftTool>(context);
}

} // namespace ramure
