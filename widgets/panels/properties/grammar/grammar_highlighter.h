/// \file
/// Colours for the text forms of grammars (core/generators/grammar/grammar.h and
/// core/generators/parametric/parametric_grammar.h).
#pragma once

#include "core/params/node_params.h"
#include <QSyntaxHighlighter>

namespace ramure {

enum class GrammarText {
    Axiom,       ///< a plain string of symbols
    Rules,       ///< lines of rules
    Names,       ///< lines of names and expressions
    Generations, ///< headings and strings of symbols, line by line
};

class GrammarHighlighter : public QSyntaxHighlighter
{
    Q_OBJECT
public:
    GrammarHighlighter(QTextDocument* document, GrammarText kind);
    /// Takes the colours that fit the palette of the editor.
    void setColours(const QPalette& palette);
    void setDialect(GrammarDialect dialect);

protected:
    void highlightBlock(const QString& text) override;

private:
    void highlightSymbols(const QString& text, qsizetype from);
    void highlightModules(const QString& text);
    void highlightWord(int at, const QString& word);

    GrammarText m_kind;
    GrammarDialect m_dialect = GrammarDialect::Classic;
    QTextCharFormat m_symbol, m_arrow, m_bracket, m_turn, m_number, m_comment, m_escape;
};

} // namespace ramure
