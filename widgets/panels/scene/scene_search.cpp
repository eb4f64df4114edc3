#include "widgets/panels/scene/scene_search.h"

#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/theme.h"
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>

namespace ramure {

SceneSearch::SceneSearch(QWidget* parent)
    : QWidget(parent)
    , m_field(named(new QLineEdit(this), "sceneSearch"))
    , m_below(new QWidget(this))
    , m_label(named(new QLabel(m_below), "sceneFound"))
    , m_selectAll(named(new QToolButton(m_below), "sceneSelectFound"))
{
    auto* layout = layoutOf<QVBoxLayout>(this, 4, {8, 6, 8, 6});
    layout->addWidget(m_field);
    layout->addWidget(m_below);
    auto* row = layoutOf<QHBoxLayout>(m_below, -1, {2, 0, 0, 0});
    row->addWidget(m_label, 1);
    row->addWidget(m_selectAll);
    m_field->setClearButtonEnabled(true);
    m_field->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_field->installEventFilter(this);
    m_label->setTextFormat(Qt::PlainText);
    m_label->setWordWrap(true);
    m_selectAll->setAutoRaise(true);
    m_below->hide();
    connect(m_field, &QLineEdit::textChanged, this, &SceneSearch::ask);
    connect(m_field, &QLineEdit::returnPressed, this, &SceneSearch::selectAllRequested);
    connect(m_selectAll, &QToolButton::clicked, this, &SceneSearch::selectAllRequested);
    const QLocale locale;
    const QString length = quantityName(BranchQuantity::Length),
                  radius = quantityName(BranchQuantity::Radius), order = quantityName(BranchQuantity::Order),
                  children = quantityName(BranchQuantity::Children),
                  number = quantityName(BranchQuantity::Number);
    m_field->setPlaceholderText(
        tr("Search: name, %1 > %2, %3").arg(length, locale.toString(0.3), terminalName()));
    m_field->setAccessibleName(tr("Search the scene"));
    const auto example = [](const QString& text, const QString& meaning) {
        return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
            .arg(text.toHtmlEscaped(), meaning.toHtmlEscaped());
    };
    m_field->setToolTip(
        QStringLiteral("<table>") + example(tr("oak"), tr("nodes whose name has this")) +
        example(tr("limb 3"), tr("limbs, boughs and twigs of that name")) +
        example(QStringLiteral("%1 > %2").arg(length, locale.toString(0.3)),
                tr("of limbs longer than that, in metres")) +
        example(QStringLiteral("%1 < 5 mm").arg(radius), tr("thinner at the lower end; mm, cm, m, in, ft")) +
        example(QStringLiteral("%1 2").arg(order), tr("of this depth of brackets; 0 is the trunk")) +
        example(QStringLiteral("%1 >= 3").arg(children), tr("with so many branches at the end")) +
        example(QStringLiteral("%1 = 12").arg(number), tr("the branch of that number in reports and files")) +
        example(terminalName(), tr("with none at the end")) + QStringLiteral("</table><p>") +
        tr("Several must all hold: %1. Enter selects everything found.")
            .arg(QStringLiteral("<b>%1 2 %2 &lt; %3</b>").arg(order, length, locale.toString(0.3))) +
        QStringLiteral("</p>"));
    m_selectAll->setText(tr("Select all"));
    m_selectAll->setToolTip(tr("Select everything found (Enter in the field)"));
    showBelow();
}

void SceneSearch::clear()
{
    m_field->clear();
}

void SceneSearch::ask()
{
    const auto query = SceneQuery::parse(m_field->text());
    m_problem = query ? QString() : errorText(query.error());
    if (query)
        emit queryChanged(*query);
    showBelow();
}

void SceneSearch::showCounts(int nodes, int branches, bool single)
{
    m_single = single;
    m_nodes = nodes;
    m_branches = branches;
    showBelow();
}

void SceneSearch::showBelow()
{
    const bool searching = !m_field->text().trimmed().isEmpty();
    m_below->setVisible(searching);
    QPalette colours = palette();
    if (!m_problem.isEmpty())
        colours.setColor(QPalette::WindowText, errorColour(colours));
    m_label->setPalette(colours);
    m_selectAll->setVisible(m_problem.isEmpty() && m_nodes + m_branches > 0);
    if (!m_problem.isEmpty()) {
        m_label->setText(m_problem);
        return;
    }
    QStringList found;
    if (m_nodes > 0)
        found += tr("%n node(s)", nullptr, m_nodes);
    if (m_branches > 0)
        found += m_single ? tr("%Ln branch(es)", nullptr, m_branches)
                          : tr("%Ln limb(s) or twig(s)", nullptr, m_branches);
    m_label->setText(found.isEmpty() ? tr("Nothing found") : found.join(QStringLiteral(", ")));
}

bool SceneSearch::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape) {
            if (m_field->text().isEmpty())
                emit leftDownwards();
            m_field->clear();
            return true;
        }
        if (key == Qt::Key_Down) {
            emit leftDownwards();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void SceneSearch::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_label)
        showBelow();
    QWidget::changeEvent(event);
}

} // namespace ramure
