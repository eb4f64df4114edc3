/// \file
/// A slider over the soft range of a real or whole number.
#pragma once

#include <QSlider>
#include <optional>

namespace ramure {

class NumberSlider : public QSlider
{
    Q_OBJECT
public:
    explicit NumberSlider(QWidget* parent = nullptr);

    /// \param step of the arrow keys. A range over several powers of ten is shown by its logarithm.
    void setSoftRange(double minimum, double maximum, double step, bool whole);
    /// Never emits. Values outside the range put the handle at its end and stay as they are.
    void setNumber(std::optional<double> value);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void numberEdited(double value);
    void gestureBegan();
    void gestureEnded();

protected:
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] double numberAt(int position) const;
    [[nodiscard]] int positionOf(double value) const;
    void moveBy(double steps);
    [[nodiscard]] double knobAt() const;
    void dragTo(double x);
    void edit(double value);

    double m_minimum = 0.0;
    double m_maximum = 1.0;
    double m_step = 0.01;
    bool m_whole = false;
    bool m_logarithmic = false;
    bool m_showing = false;  ///< setNumber is moving the handle
    bool m_dragging = false; ///< between press and release: the handle stays under the hand
    double m_grip = 0.0;     ///< from the handle's centre to where it was taken
    std::optional<double> m_number;
};

} // namespace ramure
