/// \file
/// Real and whole numbers: a slider over the soft range beside a field; a dice for seeds.
#pragma once

#include "widgets/panels/properties/param_editor.h"

class QToolButton;

namespace ramure {

class NumberField;
class NumberSlider;

class NumberEditor : public ParamEditor
{
    Q_OBJECT
public:
    NumberEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;
    void setStandard(const std::optional<ParamValue>& value) override;
    void addHandle(QWidget* label) override;
    void setAngleUnit(AngleUnit unit) override;

private:
    [[nodiscard]] ParamValue asValue(double number) const;
    void throwDice();

    NumberField* m_field = nullptr;
    NumberSlider* m_slider = nullptr; ///< null for seeds
    QToolButton* m_dice = nullptr;    ///< seeds only
};

} // namespace ramure
