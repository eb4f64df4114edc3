/// \file
/// What tools have in common that change a number of a limb, or several: a drag does it, the wheel while it
/// is held, or a number that is typed; a click goes on without the button, until Enter or another click.
#pragma once

#include "core/math/angle.h"
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/typed_number.h"

namespace ramure {

/// A drag over so many pixels doubles a factor; a notch of the wheel multiplies it by this.
inline constexpr double pixelsPerDouble = 140.0, factorPerNotch = 1.05;
inline constexpr double anglePerPixel = 0.5 * oneDegree;

class NumberTool : public EditTool
{
public:
    using EditTool::EditTool;

    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void release(const ToolPoint& point) override;
    void pressAgain(const ToolPoint& point) override;
    void cancel() override { finish(false); }
    bool wheel(const ToolPoint& point, double turn) override;
    [[nodiscard]] bool takesKeys() const override { return true; }
    void key(const QKeyEvent& event, bool pressed) override;
    void focusLost() override;

protected:
    void forget() override { m_edit.reset(); }
    /// The gesture has begun; \p point is where.
    void start(std::unique_ptr<HandEdit> edit, const ToolPoint& point);
    /// The hand has changed something by now.
    [[nodiscard]] virtual bool isChanged() const = 0;
    virtual void turnWheel(double notches) = 0;
    [[nodiscard]] virtual bool takesMinus() const { return false; }
    /// The document gets what the hand wants.
    virtual void show() = 0;

    [[nodiscard]] HandEdit* edit() const { return m_edit.get(); } ///< null: none goes on
    [[nodiscard]] const TypedNumber& typed() const { return m_typed; }
    [[nodiscard]] bool isByKeys() const { return m_byKeys; } ///< clicked: goes on without the button
    void setAt(QPointF at) { m_at = at; }
    [[nodiscard]] QPointF at() const { return m_at; } ///< where the hand is

private:
    void finish(bool keep);

    std::unique_ptr<HandEdit> m_edit;
    TypedNumber m_typed;
    bool m_byKeys = false;
    QPointF m_at;
};

} // namespace ramure
