// What a click does to a limb: cut, remove, keep only it, its leaves on or off.
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QPainter>

namespace ramure {
namespace {

/// Takes limbs away, and those that are like them around the trunk.
class TakeTool : public ClickTool
{
public:
    using ClickTool::ClickTool;

protected:
    [[nodiscard]] bool takesAway() const override { return true; }
    std::vector<Index> aboveAll(const std::vector<LimbHit>& limbs, bool whole)
    {
        std::vector<Index> all;
        Symmetry symmetry = symmetryOf(limbs.front().node);
        for (const LimbHit& each : withTwins(limbs, symmetry)) {
            const std::vector<Index> own = m_context.limbs.above(m_context.document, each, whole);
            all.insert(all.end(), own.begin(), own.end());
        }
        return all;
    }
    Expected<void> removeWithTwins(const std::vector<LimbHit>& limbs, bool whole,
                                   std::optional<double> fallsAfter = {})
    {
        Symmetry symmetry = symmetryOf(limbs.front().node);
        const std::vector<LimbHit> all = withTwins(limbs, symmetry);
        auto done = removeLimbs(m_context.document, all, whole, fallsAfter);
        if (done)
            reportMissing(symmetry);
        return done;
    }
};

class CutTool : public TakeTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::CutTool)
public:
    using TakeTool::TakeTool;
    void offer(ToolOffers& offers) const override
    {
        if (isChosen() && offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Click, aim() ? tr("Click: cut here, %1 would go").arg(aimedLoss())
                                                : tr("Click a branch: cut it there"));
    }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return aim() ? tr("Release: cut here, %1 would go · Esc: not at all").arg(aimedLoss())
                     : tr("Release: nothing is cut");
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        if (aim())
            paintRing(painter, view, worldOf(aim()->node), *aim(), handRed);
    }

protected:
    std::vector<Index> affected(const LimbHit& limb) override { return aboveAll({limb}, false); }
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers) override
    {
        auto done = removeWithTwins({limb}, false, fallsAfter());
        if (done)
            reportFall();
        return done;
    }
};

class RemoveTool : public TakeTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::RemoveTool)
public:
    using TakeTool::TakeTool;
    void offer(ToolOffers& offers) const override
    {
        offerLimbs(offers);
        if (isChosen() && offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Click,
                       aim() ? tr("Click: the limb goes, %1").arg(aimedLoss())
                             : tr("Click: the limb goes · one of several selected: all of them"));
    }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return aim() ? tr("Release: %1 go · Esc: all stays").arg(aimedLoss()) : tr("Release: all stays");
    }

protected:
    std::vector<Index> affected(const LimbHit& limb) override { return aboveAll(meantBy(limb), true); }
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers) override
    {
        return removeWithTwins(meantBy(limb), true);
    }
};

class KeepTool : public ClickTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::KeepTool)
public:
    using ClickTool::ClickTool;
    void offer(ToolOffers& offers) const override
    {
        offerLimbs(offers);
        if (isChosen() && offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Click, tr("Click: all goes but this limb"));
    }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("Release: all goes but this limb · Esc: all stays");
    }

protected:
    std::vector<Index> affected(const LimbHit& limb) override
    {
        return m_context.limbs.above(m_context.document, limb, true);
    }
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers) override
    {
        return keepLimb(m_context.document, limb);
    }
};

class LeavesTool : public ClickTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::LeavesTool)
public:
    using ClickTool::ClickTool;
    void offer(ToolOffers& offers) const override
    {
        offerLimbs(offers);
        if (isChosen() && offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Click, tr("Click: the leaves of the limb go; once more: they come back"));
    }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("Release: leaves off or on · Esc: as they were");
    }

protected:
    std::vector<Index> affected(const LimbHit& limb) override
    {
        return m_context.limbs.above(m_context.document, limb, true);
    }
    Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers) override
    {
        return toggleLeaves(m_context.document, meantBy(limb));
    }
};

} // namespace

std::unique_ptr<Tool> makeCutTool(ToolContext& context)
{
    return std::make_unique<CutTool>(context, HandTool::Cut);
}
std::unique_ptr<Tool> makeRemoveTool(ToolContext& context)
{
    return std::make_unique<RemoveTool>(context, HandTool::Remove);
}
std::unique_ptr<Tool> makeKeepTool(ToolContext& context)
{
    return std::make_unique<KeepTool>(context, HandTool::Keep);
}
std::unique_ptr<Tool> makeLeavesTool(ToolContext& context)
{
    return std::make_unique<LeavesTool>(context, HandTool::Leaves);
}

} // namespace ramure
