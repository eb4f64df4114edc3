#include "widgets/panels/properties/grammar_editor.h"

#include "core/generators/parametric/parametric_grammar.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/grammar/height_grip.h"
#include <QVBoxLayout>

namespace ramure {

namespace {

GrammarText kindOf(const ParamDef& def)
{
    if (def.get == findParam("grammar.constants")->get)
        return GrammarText::Names;
    return (def.flags & paramMultiline) != 0 ? GrammarText::Rules : GrammarText::Axiom;
}

} // namespace

GrammarEditor::GrammarEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_edit = new GrammarEdit(kindOf(def), this);
    layout->setSpacing(0);
    layout->addWidget(m_edit);
    layout->addWidget(new HeightGrip(m_edit, this));
    setFocusProxy(m_edit);
    connect(m_edit, &GrammarEdit::edited, this,
            [this](const QString& text) { emitEdit(text.toStdString()); });
    connect(m_edit, &GrammarEdit::gestureBroken, this, &GrammarEditor::nextGesture);
}

void GrammarEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    m_edit->showText(value ? QString::fromStdString(std::get<std::string>(*value)) : QString());
    m_edit->setPlaceholderText(value ? QString() : QStringLiteral("—"));
}

void GrammarEditor::showGrammar(const GrammarParams& grammar)
{
    QStringList names;
    if (grammar.dialect == GrammarDialect::Parametric) {
        names = {QStringLiteral("abs("),  QStringLiteral("age"),  QStringLiteral("cos("),
                 QStringLiteral("max("),  QStringLiteral("min("), QStringLiteral("order"),
                 QStringLiteral("rand("), QStringLiteral("sin("), QStringLiteral("sqrt(")};
        if (const auto constants = parseConstants(grammar))
            for (const auto& [name, value] : *constants)
                names += QString::fromStdString(name);
        names.sort();
    }
    m_edit->setDialect(grammar.dialect, names);
}

void GrammarEditor::showProblem(const std::optional<Error>& error)
{
    const bool here = error && error->path == def().key;
    // The axiom is one line: its errors may come with a column alone.
    const int line = here && error->line == 0 && error->column > 0 ? 1 : here ? error->line : 0;
    m_edit->showProblem(line, here ? error->column : 0);
}

bool GrammarEditor::showMessage(const QString& text)
{
    m_edit->showMessage(text);
    return true;
}

void GrammarEditor::retranslate(const QString& name)
{
    m_edit->setAccessibleName(name);
}

} // namespace ramure
