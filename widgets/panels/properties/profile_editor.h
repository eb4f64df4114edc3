/// \file
/// The outline of a crown: a curve to drag, and its numbers as text below.
#pragma once

#include "widgets/panels/properties/param_editor.h"

class QLineEdit;

namespace ramure {

class ProfileCurve;

class ProfileEditor : public ParamEditor
{
    Q_OBJECT
public:
    ProfileEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;
    [[nodiscard]] bool isWide() const override { return true; }
    [[nodiscard]] ProfileCurve* curve() const { return m_curve; }

private:
    void takeText();

    ProfileCurve* m_curve = nullptr;
    QLineEdit* m_text = nullptr;
};

} // namespace ramure
