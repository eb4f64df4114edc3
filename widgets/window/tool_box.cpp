#include "widgets/window/tool_box.h"

#include <QAction>
#include <QGridLayout>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int fewColumns = 2, manyColumns = 3, buttonIcon = 18, buttonGap = 1, boxEdge = 4;

int rowsOf(qsizetype tools, int columns)
{
    return (int(tools) + columns - 1) / columns;
}

} // namespace

ToolBox::ToolBox(QWidget* parent)
    : QFrame(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(boxEdge, boxEdge, boxEdge, boxEdge);
    column->addStretch(1);
}

void ToolBox::addGroup(const QList<QAction*>& tools)
{
    if (tools.isEmpty())
        return;
    if (!m_groups.isEmpty()) {
        auto* line = new QFrame(this);
        line->setObjectName(QStringLiteral("groupLine"));
        line->setFixedHeight(1);
        m_lines += line;
    }
    m_groups.emplace_back();
    for (QAction* tool : tools) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(tool);
        button->setIconSize({buttonIcon, buttonIcon});
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys with the view
        m_groups.back() += button;
    }
    place(m_columns);
}

QList<QToolButton*> ToolBox::buttons() const
{
    QList<QToolButton*> all;
    for (const QList<QToolButton*>& group : m_groups)
        all += group;
    return all;
}

void ToolBox::place(int columns)
{
    m_columns = columns;
    delete m_grid;
    m_grid = new QGridLayout;
    m_grid->setSpacing(buttonGap);
    static_cast<QVBoxLayout*>(layout())->insertLayout(0, m_grid);
    int row = 0;
    for (qsizetype g = 0; g < m_groups.size(); ++g) {
        if (g > 0)
            m_grid->addWidget(m_lines[g - 1], row++, 0, 1, columns);
        for (qsizetype i = 0; i < m_groups[g].size(); ++i)
            m_grid->addWidget(m_groups[g][i], row + int(i) / columns, int(i) % columns);
        row += rowsOf(m_groups[g].size(), columns);
    }
}

int ToolBox::heightOf(int columns) const
{
    int height = 2 * boxEdge;
    for (const QList<QToolButton*>& group : m_groups)
        height += rowsOf(group.size(), columns) * (group.front()->sizeHint().height() + buttonGap);
    return height + int(m_lines.size()) * (1 + buttonGap);
}

QSize ToolBox::minimumSizeHint() const
{
    return {QFrame::minimumSizeHint().width(), heightOf(manyColumns)};
}

void ToolBox::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    const int columns = height() >= heightOf(fewColumns) ? fewColumns : manyColumns;
    if (columns == m_columns)
        return;
    place(columns);
    updateGeometry();
}

} // namespace ramure
