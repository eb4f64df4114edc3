#include "widgets/panels/properties/param_editor.h"

#include "widgets/base/texts/core_text.h"
#include <algorithm>

namespace ramure {

std::optional<ParamValue> commonValue(std::span<const ParamValue> values)
{
    if (values.empty() ||
        !std::ranges::all_of(values, [&](const ParamValue& v) { return v == values.front(); }))
        return std::nullopt;
    return values.front();
}

ParamEditor::ParamEditor(const ParamDef& def, QWidget* parent)
    : QWidget(parent)
    , m_def(def)
{
    setObjectName(QString::fromLatin1(def.key));
}

QString ParamEditor::name() const
{
    return coreText(m_def.label);
}

void ParamEditor::setStandard(const std::optional<ParamValue>&)
{
}

void ParamEditor::showGrammar(const GrammarParams&)
{
}

void ParamEditor::showProblem(const std::optional<Error>&)
{
}

void ParamEditor::setAngleUnit(AngleUnit)
{
}

void ParamEditor::addHandle(QWidget*)
{
}

bool ParamEditor::showMessage(const QString&)
{
    return false;
}

void ParamEditor::nextGesture()
{
    m_gesture = newGesture();
}

void ParamEditor::emitEdit(const ParamValue& value)
{
    emit valueEdited(value, m_gesture);
}

void ParamEditor::emitComponent(int axis, double value)
{
    emit componentEdited(axis, value, m_gesture);
}

void ParamEditor::emitSingleEdit(const ParamValue& value)
{
    emit valueEdited(value, 0);
}

} // namespace ramure
