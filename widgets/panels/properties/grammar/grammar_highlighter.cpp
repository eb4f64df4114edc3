#include "widgets/panels/properties/grammar/grammar_highlighter.h"

#include "widgets/base/theme.h"
#include <QRegularExpression>

namespace ramure {

GrammarHighlighter::GrammarHighlighter(QTextDocument* document, GrammarText kind)
    : QSyntaxHighlighter(document)
    , m_kind(kind)
{
}

void GrammarHighlighter::setColours(const QPalette& palette)
{
    const bool dark = isDark(palette);
    m_symbol.setForeground(palette.color(QPalette::Text));
    m_arrow.setForeground(dark ? QColor(0x8f, 0x9a, 0x94) : QColor(0x7a, 0x82, 0x7d));
    m_bracket.setForeground(dark ? QColor(0xe0, 0xa4, 0x58) : QColor(0xa8, 0x5a, 0x0a));
    m_turn.setForeground(dark ? QColor(0x7f, 0xb8, 0xe6) : QColor(0x1f, 0x66, 0xa3));
    m_number.setForeground(dark ? QColor(0xc3, 0x9a, 0xe0) : QColor(0x7a, 0x3f, 0xa3));
    m_comment.setForeground(dark ? QColor(0x7c, 0x85, 0x80) : QColor(0x87, 0x8e, 0x8a));
    m_comment.setFontItalic(true);
    m_escape.setForeground(dark ? QColor(0x7a, 0xc7, 0x8b) : QColor(0x2c, 0x7a, 0x3f));
    rehighlight();
}

void GrammarHighlighter::highlightBlock(const QString& text)
{
    if (m_kind == GrammarText::Generations && currentBlock().blockNumber() % 2 == 0) {
        setFormat(0, static_cast<int>(text.size()), m_comment);
        return;
    }
    if (m_kind != GrammarText::Rules)
        return highlightSymbols(text, 0);
    const qsizetype first = text.indexOf(QRegularExpression(QStringLiteral("\\S")));
    if (first >= 0 && text[first] == u'#') {
        setFormat(0, static_cast<int>(text.size()), m_comment);
        return;
    }
    const qsizetype arrow = text.indexOf(QLatin1String("->"));
    if (arrow < 0)
        return;
    QTextCharFormat head = m_symbol;
    head.setFontWeight(QFont::Bold);
    setFormat(0, static_cast<int>(arrow), head);
    setFormat(static_cast<int>(arrow), 2, m_arrow);
    highlightSymbols(text, arrow + 2);
    // "0.5:" and "default:", each after the arrow or a bar.
    static const QRegularExpression label(QStringLiteral("(?:->|(?<!`)\\|)\\s*([^\\s:|`\\[\\]]+\\s*:)"));
    for (auto it = label.globalMatch(text, arrow); it.hasNext();) {
        const auto match = it.next();
        setFormat(static_cast<int>(match.capturedStart(1)), static_cast<int>(match.capturedLength(1)),
                  m_number);
    }
}

void GrammarHighlighter::highlightSymbols(const QString& text, qsizetype from)
{
    for (qsizetype i = from; i < text.size(); ++i) {
        const int at = static_cast<int>(i);
        switch (text[i].unicode()) {
        case u'[':
        case u']':
            setFormat(at, 1, m_bracket);
            break;
        case u'+':
        case u'-':
        case u'/':
        case u'\\':
        case u'^':
        case u'_':
            setFormat(at, 1, m_turn);
            break;
        case u'|':
            setFormat(at, 1, m_arrow);
            break;
        case u'`':
            setFormat(at, 2, m_escape);
            ++i;
            break;
        default:
            setFormat(at, 1, m_symbol);
        }
    }
}

} // namespace ramure
