#include "widgets/panels/properties/grammar/grammar_highlighter.h"

#include "widgets/base/theme/theme.h"
#include <QRegularExpression>
#include <algorithm>

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

void GrammarHighlighter::setDialect(GrammarDialect dialect)
{
    if (dialect == m_dialect)
        return;
    m_dialect = dialect;
    rehighlight();
}

void GrammarHighlighter::highlightBlock(const QString& text)
{
    if (m_kind == GrammarText::Generations && currentBlock().blockNumber() % 2 == 0) {
        setFormat(0, static_cast<int>(text.size()), m_comment);
        return;
    }
    if (m_dialect == GrammarDialect::Parametric || m_kind == GrammarText::Names)
        return highlightModules(text);
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

/// Between parentheses, in conditions and among the constants stand expressions: names and numbers. All else
/// are modules; those in front of the arrow are bold.
void GrammarHighlighter::highlightModules(const QString& text)
{
    static const QRegularExpression token(QStringLiteral(
        "#(?!(?:define|ignore|consider)\\b).*|/\\*.*?(?:\\*/|$)|-?->|\u2192|\\d+(\\.\\d*)?([eE][+-]?\\d+)?|"
        "\\.\\d+([eE][+-]?\\d+)?|[A-Za-z_]\\w*|\\S"));
    QTextCharFormat head = m_symbol;
    head.setFontWeight(QFont::Bold);
    bool isHead = m_kind == GrammarText::Rules && text.contains(QLatin1String("->"));
    bool isCondition = m_kind == GrammarText::Names;
    int depth = 0;
    for (auto it = token.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        const QString found = match.captured();
        const int at = static_cast<int>(match.capturedStart()), size = static_cast<int>(found.size());
        const QChar first = found[0];
        if ((first == u'#' && size > 1) || found.startsWith(QLatin1String("/*"))) {
            setFormat(at, size, m_comment);
        } else if (found.endsWith(QLatin1String("->")) || first == u'\u2192') {
            isHead = isCondition = false;
            setFormat(at, size, m_arrow);
        } else if (first.isDigit() || (first == u'.' && size > 1)) {
            setFormat(at, size, m_number);
        } else if (first == u'(' || first == u')') {
            depth = std::max(0, depth + (first == u'(' ? 1 : -1));
            setFormat(at, size, m_arrow);
        } else if (depth > 0 || isCondition) {
            setFormat(at, size, first.isLetter() || first == u'_' ? m_escape : m_symbol);
        } else if (first == u':') {
            isCondition = isHead;
            setFormat(at, size, m_arrow);
        } else if (isHead) {
            setFormat(at, size, first == u'<' || first == u'>' ? m_arrow : head);
        } else {
            highlightWord(at, found);
        }
    }
}

void GrammarHighlighter::highlightWord(int at, const QString& word)
{
    const QChar first = word[0];
    const bool turns = QStringLiteral("+-&^\\/|$").contains(first);
    setFormat(at, static_cast<int>(word.size()),
              first == u'[' || first == u']' ? m_bracket
              : turns                        ? m_turn
                                             : m_symbol);
}

} // namespace ramure
