#include "widgets/panels/properties/grammar_editor.h"

#include "core/generators/parametric/grammar_notes.h"
#include "core/generators/parametric/parametric_grammar.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/grammar/height_grip.h"
#include <QVBoxLayout>
#include <algorithm>

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
    m_edit->setAccessibleName(name());
    setFocusProxy(m_edit);
    connect(m_edit, &GrammarEdit::edited, this,
            [this](const QString& text) { emitEdit(text.toStdString()); });
    connect(m_edit, &GrammarEdit::gestureBroken, this, &GrammarEditor::nextGesture);
    connect(m_edit, &GrammarEdit::replacementWanted, this, &GrammarEditor::replaceLookalikes);
}

void GrammarEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    m_text = value ? std::get<std::string>(*value) : std::string();
    m_edit->showText(QString::fromStdString(m_text));
    m_edit->setPlaceholderText(value ? QString() : QStringLiteral("—"));
}

void GrammarEditor::showGrammar(const GrammarParams& grammar)
{
    QStringList names;
    if (grammar.dialect == GrammarDialect::Parametric) {
        names = {QStringLiteral("abs("),  QStringLiteral("age"),  QStringLiteral("cos("),
                 QStringLiteral("max("),  QStringLiteral("min("), QStringLiteral("order"),
                 QStringLiteral("rand("), QStringLiteral("sin("), QStringLiteral("sqrt("),
                 QStringLiteral("tan(")};
        if (const auto constants = parseConstants(grammar))
            for (const auto& [name, value] : *constants)
                names += QString::fromStdString(name);
        names.sort();
    }
    m_edit->setDialect(grammar.dialect, names);
    m_notes = grammarNotes(grammar);
    NodeParams node;
    node.grammar = grammar;
    const bool isOfAll = def().get(node) == ParamValue(m_text); // else the selected nodes differ
    std::erase_if(m_notes, [&](const GrammarNote& note) { return !isOfAll || note.what.path != def().key; });
    showRemarks();
}

void GrammarEditor::showProblem(const std::optional<Error>& error)
{
    m_problem = error && error->path == def().key ? error : std::nullopt;
    showRemarks();
}

bool GrammarEditor::showMessage(const QString& text)
{
    m_message = text;
    showRemarks();
    return true;
}

/// An error goes before what is only remarked.
void GrammarEditor::showRemarks()
{
    QString text = m_message;
    std::optional<Error> place = m_problem;
    if (text.isEmpty() && !place && !m_notes.empty()) {
        place = m_notes.front().what;
        place->path.clear(); // the editor itself is the place
        text = errorTextWithPlace(*place);
        text[0] = text[0].toUpper();
        if (const auto more = static_cast<int>(m_notes.size()) - 1; more > 0)
            text += u' ' + tr("(and %n more)", nullptr, more);
    }
    // The axiom is one line: its errors may come with a column alone.
    const int line = place && place->line == 0 && place->column > 0 ? 1 : place ? place->line : 0;
    m_edit->showProblem(line, place ? place->column : 0, !m_problem);
    const bool canReplace =
        std::ranges::any_of(m_notes, [](const GrammarNote& note) { return note.replacement.has_value(); });
    m_edit->showMessage(text, canReplace && !text.isEmpty());
}

void GrammarEditor::replaceLookalikes()
{
    emitSingleEdit(withReplacements(m_text, def().key, m_notes));
}

} // namespace ramure
