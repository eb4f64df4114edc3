/// \file
/// The value of the selected keys: one number, or three angles of an orientation. Keys of other kinds than
/// the first selected one stay as they are.
#pragma once

#include "core/qt/document/commands.h"
#include <QWidget>
#include <array>

class QLabel;

namespace ramure {

class KeyModel;
class NumberField;

class KeyValues : public QWidget
{
    Q_OBJECT
public:
    /// \param model is not owned and must outlive the widget.
    explicit KeyValues(KeyModel* model, QWidget* parent = nullptr);

signals:
    void messageRaised(const QString& text);

private:
    void showValues();
    [[nodiscard]] std::array<std::optional<double>, 3> commonAngles() const;
    void setNumber(double value);
    void setAngle(int axis, double angleRad);
    void report(const Expected<void>& done);

    KeyModel* m_model;
    std::array<NumberField*, 3> m_fields{};
    bool m_angles = false;
    GestureId m_gesture = 0;
};

} // namespace ramure
