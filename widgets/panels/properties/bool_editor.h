/// \file
/// A flag: a check box, partly checked where the selected nodes differ.
#pragma once

#include "widgets/panels/properties/param_editor.h"

class QCheckBox;

namespace ramure {

class BoolEditor : public ParamEditor
{
    Q_OBJECT
public:
    BoolEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;

private:
    void showState();

    QCheckBox* m_box = nullptr;
};

} // namespace ramure
