#include "widgets/panels/properties/grammar/grammar_edit.h"

#include "widgets/base/theme/theme.h"
#include <QAbstractItemView>
#include <QCompleter>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStringListModel>
#include <QTextBlock>
#include <algorithm>

namespace ramure {
namespace {

// Lines in sight until the user wants others.
constexpr int usualRuleLines = 7;
constexpr int usualAxiomLines = 3;
constexpr int mostLines = 60;

/// A column counted in bytes, as an index into the line's UTF-16 text.
int characterOf(const QString& line, int byteColumn)
{
    return static_cast<int>(QString::fromUtf8(line.toUtf8().left(byteColumn - 1)).size());
}

bool isDeleting(const QKeyEvent* event)
{
    return event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete;
}

bool isMoving(const QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        return true;
    default:
        return false;
    }
}

bool isEscaped(const QString& text, int position)
{
    int quotes = 0;
    while (position - quotes > 0 && text[position - quotes - 1] == u'`')
        ++quotes;
    return quotes % 2 == 1;
}

} // namespace

int matchingBracket(const QString& text, int position)
{
    if (position < 0 || position >= text.size() || isEscaped(text, position))
        return -1;
    const bool forward = text[position] == u'[';
    if (!forward && text[position] != u']')
        return -1;
    int depth = 0;
    for (int i = position; i >= 0 && i < text.size(); i += forward ? 1 : -1) {
        if (text[i] == u'\n')
            return -1; // a rule ends with its line
        if ((text[i] != u'[' && text[i] != u']') || isEscaped(text, i))
            continue;
        depth += (text[i] == u'[') == forward ? 1 : -1;
        if (depth == 0)
            return i;
    }
    return -1;
}

GrammarEdit::GrammarEdit(GrammarText kind, QWidget* parent)
    : QPlainTextEdit(parent)
    , m_kind(kind)
    , m_lines(usualLines())
    , m_message(new QLabel(this))
    , m_replace(new QPushButton(m_message))
    , m_completer(new QCompleter(this))
{
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setUndoRedoEnabled(false);
    setTabChangesFocus(true);
    setWordWrapMode(QTextOption::WrapAnywhere);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    document()->setDocumentMargin(5);
    m_highlighter = new GrammarHighlighter(document(), kind);
    m_highlighter->setColours(palette());
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, &GrammarEdit::updateMarks);
    connect(this, &QPlainTextEdit::textChanged, this, [this] {
        if (!m_showing)
            emit edited(toPlainText());
    });
    m_message->setObjectName(QStringLiteral("problem"));
    m_message->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setAutoFillBackground(true);
    m_message->setBackgroundRole(QPalette::Base);
    m_message->setMargin(4);
    m_message->hide();
    m_replace->hide();
    m_replace->setAutoDefault(false);
    connect(m_replace, &QPushButton::clicked, this, &GrammarEdit::replacementWanted);
    setFixedHeight(heightOfLines());
    m_completer->setWidget(this);
    m_completer->setModel(new QStringListModel(m_completer));
    connect(m_completer, qOverload<const QString&>(&QCompleter::activated), this,
            &GrammarEdit::takeCompletion);
}

int GrammarEdit::usualLines() const
{
    return m_kind == GrammarText::Rules ? usualRuleLines : usualAxiomLines;
}

void GrammarEdit::setDialect(GrammarDialect dialect, const QStringList& names)
{
    m_highlighter->setDialect(dialect);
    static_cast<QStringListModel*>(m_completer->model())->setStringList(names);
}

/// The word that ends at the cursor; a single letter may be a module.
static QString wordBefore(const QTextCursor& cursor)
{
    static const QRegularExpression word(QStringLiteral("[A-Za-z_]\\w*$"));
    return word.match(cursor.block().text().left(cursor.positionInBlock())).captured();
}

/// Offers names that begin as the word does, where an expression stands.
void GrammarEdit::complete()
{
    const QString before = textCursor().block().text().left(textCursor().positionInBlock());
    const bool isExpression =
        m_kind == GrammarText::Names ? before.contains(u'=') : before.count(u'(') > before.count(u')');
    const QString word = wordBefore(textCursor());
    m_completer->setCompletionPrefix(word);
    const bool isWhole = m_completer->completionCount() == 1 && m_completer->currentCompletion() == word;
    if (word.isEmpty() || !isExpression || isWhole || m_completer->completionCount() == 0) {
        m_completer->popup()->hide();
        return;
    }
    QRect at = cursorRect();
    at.setWidth(m_completer->popup()->sizeHintForColumn(0) + 2 * fontMetrics().averageCharWidth());
    m_completer->complete(at);
    m_completer->popup()->setCurrentIndex(m_completer->completionModel()->index(0, 0));
}

void GrammarEdit::takeCompletion(const QString& name)
{
    QTextCursor cursor = textCursor();
    cursor.insertText(name.mid(wordBefore(cursor).size()));
    setTextCursor(cursor);
}

void GrammarEdit::setLines(int lines)
{
    m_lines = std::clamp(lines, 1, mostLines);
    setFixedHeight(heightOfLines());
}

void GrammarEdit::showMessage(const QString& text, bool offersReplacement)
{
    m_message->setText(text);
    m_replace->setText(tr("Replace"));
    m_replace->setToolTip(tr("Replaces lookalikes by the characters of the language"));
    m_replace->setVisible(offersReplacement);
    m_message->setVisible(!text.isEmpty());
    placeMessage();
}

/// The text keeps the rest: no line of it lies below the message.
void GrammarEdit::placeMessage()
{
    const QRect inside = rect().adjusted(frameWidth(), frameWidth(), -frameWidth(), -frameWidth());
    const QSize button = m_replace->isHidden() ? QSize() : m_replace->sizeHint() + QSize(4, 4);
    m_message->setContentsMargins(0, 0, std::max(0, button.width()), 0);
    const int height =
        m_message->isHidden() ? 0 : std::max(m_message->heightForWidth(inside.width()), button.height());
    setViewportMargins(0, 0, 0, height);
    m_message->setGeometry(inside.left(), inside.bottom() + 1 - height, inside.width(), height);
    m_replace->setGeometry(QRect(QPoint(inside.width() - button.width() + 2, 2), m_replace->sizeHint()));
}

void GrammarEdit::showText(const QString& text)
{
    if (text == toPlainText())
        return;
    const int position = textCursor().position();
    m_showing = true;
    setPlainText(text);
    m_showing = false;
    QTextCursor cursor = textCursor();
    cursor.setPosition(std::min(position, static_cast<int>(text.size())));
    setTextCursor(cursor);
    updateMarks();
}

void GrammarEdit::showProblem(int line, int column, bool isWarning)
{
    std::pair<int, int> range{-1, -1};
    const QTextBlock block = line > 0 ? document()->findBlockByNumber(line - 1) : QTextBlock();
    if (block.isValid()) {
        const int length = block.length() - 1;
        if (column > 0) {
            // At least one character is underlined; at the end of the line the last one.
            const int at = std::clamp(characterOf(block.text(), column), 0, std::max(0, length - 1));
            range = {block.position() + at, block.position() + std::min(at + 1, length)};
        } else {
            range = {block.position(), block.position() + length};
        }
    }
    if (range == m_problem && isWarning == m_problemIsWarning)
        return;
    m_problem = range;
    m_problemIsWarning = isWarning;
    updateMarks();
}

void GrammarEdit::updateMarks()
{
    QList<QTextEdit::ExtraSelection> marks;
    const auto mark = [&](int from, int to, const QTextCharFormat& format) {
        QTextEdit::ExtraSelection selection;
        const int last = static_cast<int>(document()->characterCount()) - 1;
        selection.cursor = textCursor();
        selection.cursor.setPosition(std::min(from, last));
        selection.cursor.setPosition(std::min(to, last), QTextCursor::KeepAnchor);
        selection.format = format;
        marks += selection;
    };
    const QString text = toPlainText();
    const int cursor = textCursor().position();
    QTextCharFormat pair;
    pair.setBackground(isDark(palette()) ? QColor(0x4a, 0x56, 0x4e) : QColor(0xc9, 0xe3, 0xcf));
    for (const int at : {cursor, cursor - 1}) {
        const int other = matchingBracket(text, at);
        if (other < 0)
            continue;
        mark(at, at + 1, pair);
        mark(other, other + 1, pair);
        break;
    }
    if (m_problem.first >= 0) {
        QTextCharFormat wave;
        wave.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        QColor wash = m_problemIsWarning ? warningColour(palette()) : errorColour(palette());
        wave.setUnderlineColor(wash);
        wash.setAlpha(48);
        wave.setBackground(wash);
        mark(m_problem.first, m_problem.second, wave);
    }
    setExtraSelections(marks);
}

bool GrammarEdit::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore(); // the document's undo, not the text's
            return false;
        }
    }
    return QPlainTextEdit::event(event);
}

void GrammarEdit::changeEvent(QEvent* event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_highlighter) {
        m_highlighter->setColours(palette());
        updateMarks();
    } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        setFixedHeight(heightOfLines());
    }
}

void GrammarEdit::keyPressEvent(QKeyEvent* event)
{
    const bool newLine = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (m_completer->popup()->isVisible() &&
        (newLine || event->key() == Qt::Key_Tab || event->key() == Qt::Key_Escape)) {
        event->ignore(); // the list takes them
        return;
    }
    if (newLine && m_kind == GrammarText::Axiom)
        return;
    const bool deleting = isDeleting(event);
    if (newLine || isMoving(event) ||
        (deleting != m_lastWasDeleting && (deleting || !event->text().isEmpty())))
        emit gestureBroken();
    if (deleting || !event->text().isEmpty())
        m_lastWasDeleting = deleting;
    QPlainTextEdit::keyPressEvent(event);
    if (deleting || !event->text().isEmpty())
        complete();
}

void GrammarEdit::mousePressEvent(QMouseEvent* event)
{
    emit gestureBroken();
    QPlainTextEdit::mousePressEvent(event);
}

void GrammarEdit::focusInEvent(QFocusEvent* event)
{
    QPlainTextEdit::focusInEvent(event);
    emit gestureBroken();
}

void GrammarEdit::focusOutEvent(QFocusEvent* event)
{
    QPlainTextEdit::focusOutEvent(event);
    emit gestureBroken();
}

void GrammarEdit::insertFromMimeData(const QMimeData* source)
{
    emit gestureBroken();
    if (m_kind != GrammarText::Axiom) {
        QPlainTextEdit::insertFromMimeData(source);
    } else {
        QString text = source->text();
        textCursor().insertText(text.remove(u'\n').remove(u'\r'));
    }
    emit gestureBroken();
}

void GrammarEdit::wheelEvent(QWheelEvent* event)
{
    // Without the focus, or with nothing to scroll, the wheel belongs to the panel.
    if (!hasFocus() || verticalScrollBar()->maximum() == 0)
        event->ignore();
    else
        QPlainTextEdit::wheelEvent(event);
}

void GrammarEdit::resizeEvent(QResizeEvent* event)
{
    QPlainTextEdit::resizeEvent(event);
    if (event->size() != event->oldSize())
        placeMessage();
}

int GrammarEdit::heightOfLines() const
{
    const double margins = 2.0 * document()->documentMargin() + 2.0 * frameWidth();
    return static_cast<int>(m_lines * fontMetrics().lineSpacing() + margins) + 2;
}

QSize GrammarEdit::sizeHint() const
{
    return {200, heightOfLines()};
}

QSize GrammarEdit::minimumSizeHint() const
{
    return {60, heightOfLines()};
}

} // namespace ramure
