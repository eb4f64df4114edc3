#include "widgets/panels/properties/grammar/generations_view.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/properties/grammar/grammar_highlighter.h"
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLocale>
#include <QScrollBar>
#include <QTextBlock>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

namespace ramure {
namespace {

constexpr int pauseMs = 60;           ///< the strings follow typing, but not every key
constexpr qsizetype headLength = 220; ///< of a long string these are shown,
constexpr qsizetype tailLength = 60;  ///< and these
constexpr QStringView ellipsis = u" … ";
constexpr int shownLines = 14;

/// The beginning and the end.
QString elided(const std::string& text)
{
    const QString all = QString::fromUtf8(text);
    if (all.size() <= headLength + tailLength + ellipsis.size())
        return all;
    return all.left(headLength) + ellipsis.toString() + all.right(tailLength);
}

} // namespace

GenerationsView::GenerationsView(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_fold(named(new QToolButton(this), "generationsFold"))
    , m_summary(named(new QLabel(this), "generationsSummary"))
    , m_text(named(new QPlainTextEdit(this), "generationsText"))
    , m_highlighter(new GrammarHighlighter(m_text->document(), GrammarText::Generations))
    , m_timer(new QTimer(this))
{
    setObjectName(QStringLiteral("generations"));
    auto* layout = layoutOf<QVBoxLayout>(this, 4);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    m_fold->setText(tr("Generations"));
    m_fold->setAutoRaise(true);
    m_fold->setIconSize({12, 12});
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_summary->setWordWrap(true);
    row->addWidget(m_fold);
    row->addWidget(m_summary, 1);
    layout->addLayout(row);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setAccessibleName(tr("Strings of the generations"));
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setWordWrapMode(QTextOption::WrapAnywhere);
    m_text->setFixedHeight(m_text->fontMetrics().lineSpacing() * shownLines);
    m_text->hide();
    layout->addWidget(m_text);
    m_text->viewport()->installEventFilter(this);
    connect(m_text, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        if (m_text->hasFocus())
            QToolTip::showText(m_text->viewport()->mapToGlobal(m_text->cursorRect().bottomLeft()),
                               moduleAt(m_text->textCursor().position()), m_text->viewport());
    });
    m_highlighter->setColours(palette());
    m_timer->setSingleShot(true);
    m_timer->setInterval(pauseMs);
    connect(m_timer, &QTimer::timeout, this, &GenerationsView::showGenerations);
    connect(m_fold, &QToolButton::clicked, this, [this] { setUnfolded(!m_unfolded); });
    connect(m_document, &Document::changed, this, &GenerationsView::follow);
    setUnfolded(false);
}

void GenerationsView::setTree(NodeId tree)
{
    m_tree = tree;
    m_stale = true;
    showSummary();
    if (m_unfolded)
        m_timer->start();
}

void GenerationsView::setUnfolded(bool unfolded)
{
    m_unfolded = unfolded;
    m_text->setVisible(unfolded);
    if (unfolded && m_stale)
        showGenerations();
    m_fold->setIcon(icon(unfolded ? "fold-open" : "fold-closed"));
    m_fold->setToolTip(unfolded ? tr("Hide the strings") : tr("Show the string of each generation"));
    showSummary();
    if (unfolded)
        m_timer->start();
}

void GenerationsView::follow(const Change& change)
{
    const bool mine = std::ranges::count(change.nodes, m_tree) > 0;
    if (mine && change.has(changeResults))
        showSummary();
    if (mine && change.has(changeParams) && change.firstStale == Stage::Symbols) {
        m_stale = true;
        if (m_unfolded)
            m_timer->start();
    }
}

void GenerationsView::showSummary()
{
    const NodeResult* result = m_document->result(m_tree);
    const bool known = result && !result->error && result->tree.symbols && result->tree.skeleton;
    m_summary->setText(
        known
            ? tr("%1, %2").arg(tr("%Ln symbol(s)", nullptr, static_cast<int>(result->tree.symbols->size())),
                               tr("%Ln branch(es)", nullptr, static_cast<int>(result->tree.skeleton->size())))
            : QString());
}

void GenerationsView::showGenerations()
{
    m_timer->stop();
    // Out of sight nothing is computed; showEvent catches up.
    if (!m_unfolded || !isVisible())
        return;
    m_stale = false;
    const Node* node = m_document->scene().find(m_tree);
    if (!node) {
        m_text->clear();
        return;
    }
    m_generations.clear();
    m_highlighter->setDialect(node->params.grammar.dialect);
    auto generations = generationsOf(node->params.grammar);
    if (!generations) {
        m_text->setPlainText(tr("The rules give no string yet."));
        return;
    }
    const QLocale locale;
    QStringList lines;
    double before = 0.0;
    for (std::size_t i = 0; i < generations->size(); ++i) {
        const Generation& generation = (*generations)[i];
        const int shown = static_cast<int>(std::min(generation.symbols, 2e9));
        QString heading = i == 0 ? tr("Axiom") : tr("Generation %1").arg(i);
        heading += QStringLiteral(" · ") + (generation.atLeast ? tr("more than %Ln symbol(s)", nullptr, shown)
                                                               : tr("%Ln symbol(s)", nullptr, shown));
        if (i > 0 && before > 0.0 && !generation.atLeast)
            heading += QStringLiteral(" · ×") + locale.toString(generation.symbols / before, 'f', 2);
        before = generation.symbols;
        lines += heading;
        lines += generation.text ? elided(*generation.text) : QStringLiteral("…");
    }
    const auto rest = node->params.grammar.iterations - static_cast<std::int64_t>(generations->size()) + 1;
    if (rest > 0)
        lines += tr("… and %Ln more generation(s)", nullptr, static_cast<int>(rest));
    const int place = m_text->verticalScrollBar()->value();
    m_generations = std::move(*generations);
    m_text->setPlainText(lines.join(u'\n'));
    m_text->verticalScrollBar()->setValue(place);
}

QString GenerationsView::moduleAt(int position) const
{
    const QTextBlock block = m_text->document()->findBlock(position);
    const auto generation = static_cast<std::size_t>(block.blockNumber() / 2);
    if (block.blockNumber() % 2 == 0 || generation >= m_generations.size())
        return {};
    const ModuleWord& word = m_generations[generation].word;
    const auto size = static_cast<qsizetype>(word.modules.size());
    qsizetype at = position - block.position();
    if (block.length() - 1 < size && at >= headLength) // behind the ellipsis
        at = at < headLength + ellipsis.size() ? size : size - (block.length() - 1 - at);
    if (at < 0 || at >= size)
        return {};
    const Module& module = word.modules[static_cast<std::size_t>(at)];
    QStringList numbers;
    for (std::size_t i = 0; i < word.numbersOf(module); ++i)
        numbers += QString::number(word.numbers[module.firstNumber + i], 'g', 6);
    return numbers.isEmpty() ? QString()
                             : QStringLiteral("%1(%2)")
                                   .arg(QLatin1Char(module.name))
                                   .arg(numbers.join(QStringLiteral(", ")));
}

bool GenerationsView::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::eventFilter(watched, event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QTextCursor cursor = m_text->cursorForPosition(help->pos());
    // The cursor goes between two letters, to the nearer place: it may stand behind the one that is meant.
    if (m_text->cursorRect(cursor).left() > help->pos().x())
        cursor.movePosition(QTextCursor::PreviousCharacter);
    QToolTip::showText(help->globalPos(), moduleAt(cursor.position()), m_text->viewport());
    return true;
}

void GenerationsView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_stale && m_unfolded)
        m_timer->start();
}

void GenerationsView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        m_highlighter->setColours(palette());
    QWidget::changeEvent(event);
}

} // namespace ramure
