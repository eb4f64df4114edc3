/// \file
/// What the tools that shape trees have in common: they take presses only while they are chosen, look which
/// limb is under the cursor, show what would change, and say why something cannot be done.
#pragma once

#include "widgets/view/tools/hand/hand_edit.h"
#include "widgets/view/tools/hand/symmetry.h"
#include "widgets/view/tools/tool.h"

namespace ramure {

class EditTool : public Tool
{
public:
    EditTool(ToolContext& context, HandTool kind);

    [[nodiscard]] bool isChosen() const override { return m_context.hand.tool() == m_kind; }
    [[nodiscard]] QCursor cursor() const override { return m_cursor; }
    bool hover(const ToolPoint& point) override; ///< false: the view looks for the branch, too
    void leave() override;
    bool press(const ToolPoint& point) override;
    bool wheel(const ToolPoint& point, double turn) override;
    void documentChanged(const Change& change) override;

protected:
    /// What a press on \p limb begins; \p limb is nothing beside all trees. Everything is at rest: see
    /// RestTool.
    /// \return whether the tool takes it
    virtual bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) = 0;
    /// Presses with Shift are the tool's, too; else they select.
    [[nodiscard]] virtual bool takesShift() const { return false; }
    /// The gesture goes on, and its tree is gone or another document is open: nothing is to be kept.
    virtual void forget() {}
    /// Branches that the tool would change.
    [[nodiscard]] virtual std::vector<Index> affected(const LimbHit&) { return {}; }
    /// affected() would be gone: shown in a colour that warns.
    [[nodiscard]] virtual bool takesAway() const { return false; }
    /// How much of the tree aim() would take: "12 branches, 3.4 m".
    [[nodiscard]] QString aimedLoss() const { return lossWords(m_loss); }
    [[nodiscard]] static QString lossWords(const HandLoss& loss);

    /// In the last picture, whatever is being computed for the next one. \param patience for what is picked
    /// in
    [[nodiscard]] std::optional<LimbHit> limbAt(const ToolPoint& point, std::chrono::milliseconds patience);
    void offerLimbs(ToolOffers& offers) const; ///< HandOptions::limbOrder by the wheel
    /// What the cursor was over last.
    [[nodiscard]] const std::optional<LimbHit>& aim() const { return m_aim; }
    void setAim(const std::optional<LimbHit>& aim);
    /// All limbs that are meant: those selected, where \p hit is one of them.
    [[nodiscard]] std::vector<LimbHit> meantBy(const LimbHit& hit)
    {
        return m_context.limbs.meantBy(m_context.document, hit);
    }
    /// Those that the options want beside what is done to a limb of this tree; it lasts until the tree
    /// changes.
    [[nodiscard]] Symmetry symmetryOf(NodeId node);
    /// The limbs, and behind each its twins, at the same share of their lengths; each limb once.
    static std::vector<LimbHit> withTwins(const std::vector<LimbHit>& limbs, Symmetry& symmetry);
    /// Where nothing happens for want of a limb: to the status bar.
    void reportMissing(const Symmetry& symmetry);
    /// As the options have it: HandOptions::fallsAfter, where what is cut falls.
    [[nodiscard]] std::optional<double> fallsAfter() const;
    /// What was cut is still there: why, goes to the status bar.
    void reportFall();
    /// A press that cannot be done: why, goes to the status bar. \return true, so that take() has the
    /// gesture: what was meant to shape a tree must not select
    bool refuse(const Error& why);
    void missed(); ///< nothing was hit: to the status bar
    /// What went wrong goes to the status bar. \return whether nothing did
    bool report(const Expected<void>& done);
    [[nodiscard]] glm::dmat4 worldOf(NodeId node) const;

private:
    [[nodiscard]] std::optional<LimbHit> twigNear(const PickScene& scene, const ToolPoint& point);
    [[nodiscard]] std::optional<LimbHit> twigAt(const ToolPoint& point, std::chrono::milliseconds patience);

    HandTool m_kind;
    QCursor m_cursor;
    glm::dvec3 m_eye{0.0}; ///< world, where the picture was last looked at from
    std::optional<LimbHit> m_aim;
    HandLoss m_loss; ///< of m_aim, where the tool takes away
};

/// Acts on the limb that is clicked; a press can be moved to another one before it is let go.
class ClickTool : public EditTool
{
public:
    using EditTool::EditTool;

    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override { setAim({}); }
    void sceneReady() override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    void forget() override { m_waiting.reset(); }
    virtual Expected<void> act(const LimbHit& limb, Qt::KeyboardModifiers held) = 0;

private:
    std::optional<ToolPoint> m_waiting; ///< a click before there was anything to pick in
};

/// Beside all trees: the one that is selected, or the only one; noNode: there is none.
NodeId treeMeant(const Document& document);
/// A ring around a place on a limb.
void paintRing(QPainter& painter, const PickView& view, const glm::dmat4& world, const LimbHit& limb,
               const QColor& colour);
inline const QColor handRed(226, 74, 51), handGreen(90, 200, 90);

} // namespace ramure
