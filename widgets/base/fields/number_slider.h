/// \file
/// A slider over the soft range of a real or whole number. A press beside the handle brings it there; from
/// then on the handle stays under the mouse, and with Shift it is ten times as fine (the tooltip says so).
#pragma once

#include "widgets/base/fields/number_scale.h"
#include <QSlider>
#include <optional>

namespace ramure {

class NumberDrag;

class NumberSlider : public QSlider
{
    Q_OBJECT
public:
    explicit NumberSlider(QWidget* parent = nullptr);

    /// \param step of the arrow keys. How the range lies along the slider:
    /// widgets/base/fields/number_scale.h.
    void setSoftRange(double minimum, double maximum, double step, bool whole);
    /// Dragged values are rounded as the field shows them: times \p factor.
    void setFactor(double factor) { m_factor = factor; }
    /// Never emits. Values outside the range put the handle at its end and stay as they are.
    void setNumber(std::optional<double> value);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void numberEdited(double value);
    void gestureBegan();
    void gestureEnded();

protected:
    bool event(QEvent* event) override; ///< the tooltip: that of the row around it, and what Shift does
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] double numberAt(int position) const;
    [[nodiscard]] int positionOf(double value) const;
    void moveBy(double steps);
    [[nodiscard]] double grooveLength() const;
    [[nodiscard]] double knobAt() const;
    [[nodiscard]] double along(double x) const; ///< pixels from the end of small numbers
    [[nodiscard]] int positionAt(double x) const;
    void edit(double value);

    NumberScale m_scale;
    double m_factor = 1.0;
    NumberDrag* m_drag;
    bool m_showing = false; ///< setNumber is moving the handle
    std::optional<double> m_number;
};

} // namespace ramure
