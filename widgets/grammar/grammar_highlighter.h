/// \file
/// Colours for the text form of grammars (core/grammar/grammar.h).
#pragma once

#include <QSyntaxHighlighter>

namespace ramure {

class GrammarHighlighter : public QSyntaxHighlighter
{
    Q_OBJECT
public:
    /// \param rules true: lines of rules; false: an axiom, which is a plain string of symbols.
    GrammarHighlighter(QTextDocument* document, bool rules);
    /// Takes the colours that fit the palette of the editor.
    void setColours(const QPalette& palette);

protected:
    void highlightBlock(const QString& text) override;

private:
    void highlightSymbols(const QString& text, qsizetype from);

    bool m_rules;
    QTextCharFormat m_symbol, m_arrow, m_bracket, m_turn, m_number, m_comment, m_escape;
};

} // namespace ramure
