/// \file
/// Three numbers: X, Y and Z.
#pragma once

#include "widgets/panels/properties/param_editor.h"
#include <array>

namespace ramure {

class NumberField;

class VectorEditor : public ParamEditor
{
    Q_OBJECT
public:
    VectorEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;
    void setStandard(const std::optional<ParamValue>& value) override;
    void setAngleUnit(AngleUnit unit) override;
    [[nodiscard]] bool isWide() const override { return true; }

private:
    std::array<NumberField*, 3> m_fields{};
};

} // namespace ramure
