/// \file
/// A short text in one line.
#pragma once

#include "widgets/panels/properties/param_editor.h"

class QLineEdit;

namespace ramure {

class TextEditor : public ParamEditor
{
    Q_OBJECT
public:
    TextEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;

private:
    QLineEdit* m_edit = nullptr;
};

} // namespace ramure
