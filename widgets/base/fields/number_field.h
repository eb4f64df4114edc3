/// \file
/// The program's only field for numbers: typing with arithmetic and units, dragging, arrow keys, the wheel
/// only with the focus.
///
/// A field without the focus is dragged to the left and right (widgets/base/fields/number_drag.h); a click
/// gives it the focus, and then the mouse marks text.
#pragma once

#include "widgets/base/fields/number_scale.h"
#include "widgets/base/texts/number_format.h"
#include <QAbstractSpinBox>
#include <optional>
#include <vector>

namespace ramure {

class NumberDrag;

class NumberField : public QAbstractSpinBox
{
    Q_OBJECT
public:
    explicit NumberField(QWidget* parent = nullptr);

    void setFormat(const NumberFormat& format);
    /// Sets the range that arrow keys and typing are limited to, in the program's unit.
    void setRange(double minimum, double maximum);
    /// One arrow key; with Shift a tenth, with Ctrl or Page Up and Down ten times as much.
    void setStep(double step);
    /// How far a drag goes; without one, a step is a few pixels.
    void setScale(const NumberScale& scale) { m_scale = scale; }
    /// Dragging \p handle, a label beside the field, drags the number; a click on it gives the field the
    /// focus.
    void addHandle(QWidget* handle);
    /// Sets the value of a reset. If somebody types the text that the field shows for it, exactly this value
    /// is set: 18 degrees and a default of 0.3142 rad look the same, and a parameter that looks unchanged is
    /// unchanged.
    void setDefault(std::optional<double> value);

    /// Shows a value; std::nullopt: several nodes differ. Never emits. A text being typed stays.
    void setValue(std::optional<double> value);
    [[nodiscard]] std::optional<double> value() const { return m_value; }

    void stepBy(int steps) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user gave another value, in the program's unit and inside the range.
    void valueEdited(double value);
    /// The text that was entered is no number; \p reason says why, in the interface's language. Empty: all is
    /// well again.
    void refused(const QString& reason);
    /// A typed value was outside the range, and the nearest end was taken. \p note says which, in the
    /// interface's language. Emitted after valueEdited. An empty note withdraws it.
    void held(const QString& note);
    /// Edits between these belong together: while the field has the focus, up to a typed value's Return.
    void gestureBegan();
    void gestureEnded();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    [[nodiscard]] StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }

private:
    bool press(QMouseEvent* event);
    bool drag(QMouseEvent* event);
    bool release(QMouseEvent* event);
    void showCursor();
    void showValue();
    /// \param keepBadText leaves a text that is no number in place for another try.
    void commit(bool keepBadText);
    void enter();
    void setRefusal(const QString& reason);
    void setNote(const QString& note);
    void edit(double value);
    [[nodiscard]] double meant(double typed) const;

    NumberFormat m_format;
    double m_minimum = -1e12;
    double m_maximum = 1e12;
    double m_step = 1.0;
    double m_stepFactor = 1.0;
    std::optional<double> m_value = 0.0;
    std::optional<double> m_default;
    std::optional<NumberScale> m_scale;
    NumberDrag* m_drag = nullptr;
    std::vector<QWidget*> m_handles;
    std::optional<double> m_pressedAt; ///< x of a press that has not become a drag
    bool m_refused = false;
    bool m_noted = false;
};

} // namespace ramure
