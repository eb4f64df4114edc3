/// \file
/// The editor for parameters in the grammar's language, and for other long texts.
#pragma once

#include "core/generators/grammar/grammar_note.h"
#include "widgets/panels/properties/param_editor.h"

namespace ramure {

class GrammarEdit;

class GrammarEditor : public ParamEditor
{
    Q_OBJECT
public:
    GrammarEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;
    void showGrammar(const GrammarParams& grammar) override;
    void showProblem(const std::optional<Error>& error) override;
    bool showMessage(const QString& text) override;
    [[nodiscard]] bool isWide() const override { return true; }

private:
    void showRemarks();
    void replaceLookalikes();

    GrammarEdit* m_edit = nullptr;
    std::string m_text;             ///< of all selected nodes
    GrammarNotes m_notes;           ///< on that text
    std::optional<Error> m_problem; ///< in it
    QString m_message;              ///< of the row; it goes before the notes
};

} // namespace ramure
