/// \file
/// One of several named items: a combo box, empty where the selected nodes differ.
#pragma once

#include "widgets/panels/properties/param_editor.h"

class QComboBox;

namespace ramure {

class ChoiceEditor : public ParamEditor
{
    Q_OBJECT
public:
    ChoiceEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;

private:
    QComboBox* m_box = nullptr;
};

} // namespace ramure
