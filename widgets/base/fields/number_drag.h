/// \file
/// A number under the mouse, between press and release: on its field, its label or its slider.
#pragma once

#include "widgets/base/fields/number_scale.h"
#include <QObject>
#include <optional>

namespace ramure {

class NumberDrag : public QObject
{
    Q_OBJECT
public:
    /// From one end of the scale to the other, without keys; sliders take their own length.
    static constexpr double pixels = 300.0;

    using QObject::QObject;

    struct Start
    {
        double value = 0.0;
        double least = 0.0, most = 1.0; ///< the value is held to these
        double factor = 1.0;            ///< shown = value * factor: what is shown gets round
        double x = 0.0;                 ///< of the mouse, pixels
        double length = pixels;
        /// Where on the scale a handle is held that stays under the mouse. If the mouse goes beyond an end,
        /// it must come back as far before the number changes again.
        std::optional<double> held{};
    };
    /// \param before what Esc brings back; without one, as where several nodes had several values, it only
    /// ends the drag.
    void begin(const NumberScale& scale, const Start& start, std::optional<double> before);
    [[nodiscard]] bool isOn() const { return m_on; }
    /// Moves the drag. Shift makes it ten times as fine, Ctrl ten times as coarse; a key pressed on the way
    /// makes no jump.
    void moveTo(double x, Qt::KeyboardModifiers modifiers);
    void end();

signals:
    /// Another value; after Esc the one from before.
    void moved(double value);
    /// Released, given up with Esc, or taken back by a key that undoes or redoes.
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    NumberScale m_scale;
    Start m_start;
    std::optional<double> m_before;
    double m_position = 0.0;
    double m_x = 0.0;
    bool m_on = false;
};

} // namespace ramure
