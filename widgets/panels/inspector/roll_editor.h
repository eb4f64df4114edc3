/// \file
/// The frames of the selected branches turned by hand: a slider, a field and a way back. One gesture is one
/// undo step.
#pragma once

#include "core/qt/document/commands.h"
#include "widgets/base/texts/number_format.h"
#include <QWidget>
#include <cstdint>
#include <vector>

class QLabel;
class QToolButton;

namespace ramure {

class NumberField;
class NumberSlider;

class RollEditor : public QWidget
{
    Q_OBJECT
public:
    explicit RollEditor(Document* document, QWidget* parent = nullptr);

    /// The branches by Skeleton::name. Reads their rolls from the document: call again after each change.
    void showBranches(NodeId node, std::vector<std::uint64_t> keys);
    void setAngleUnit(AngleUnit unit);

signals:
    /// Why an edit was refused, in the interface's language.
    void refused(const QString& reason);

private:
    void nextGesture();
    void apply(double rollRad, GestureId gesture);

    Document* m_document;
    NodeId m_node = noNode;
    std::vector<std::uint64_t> m_keys;
    GestureId m_gesture;
    QLabel* m_name = nullptr;
    QLabel* m_hint = nullptr;
    NumberSlider* m_slider = nullptr;
    NumberField* m_field = nullptr;
    QToolButton* m_reset = nullptr;
};

} // namespace ramure
