/// \file
/// Colours for the text form of grammars (core/generators/grammar/grammar.h).
#pragma once

#include <QSyntaxHighlighter>

namespace ramure {

enum class GrammarText {
    Axiom,       ///< a plain string of symbols
    Rules,       ///< lines of rules
    Generations, ///< headings and strings of symbols, line by line
};

class GrammarHighlighter : public QSyntaxHighlighter
{
    Q_OBJECT
public:
    GrammarHighlighter(QTextDocument* document, GrammarText kind);
    /// Takes the colours that fit the palette of the editor.
    void setColours(const QPalette& palette);

protected:
    void highlightBlock(const QString& text) override;

private:
    void highlightSymbols(const QString& text, qsizetype from);

    GrammarText m_kind;
    QTextCharFormat m_symbol, m_arrow, m_bracket, m_turn, m_number, m_comment, m_escape;
};

} // namespace ramure
