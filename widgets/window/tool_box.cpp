#include "widgets/window/tool_box.h"

#include <QAction>
#include <QGridLayout>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int columns = 2, iconSide = 18;

} // namespace

QGridLayout* ToolBox::grid()
{
    if (m_grid)
        return m_grid;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 5, 4, 5);
    m_grid = new QGridLayout;
    m_grid->setSpacing(1);
    column->addLayout(m_grid);
    column->addStretch(1);
    return m_grid;
}

void ToolBox::addGroup(const QList<QAction*>& tools)
{
    QGridLayout* into = grid();
    if (!m_buttons.isEmpty()) {
        auto* line = new QFrame(this);
        line->setObjectName(QStringLiteral("groupLine"));
        line->setFixedHeight(1);
        into->addWidget(line, into->rowCount(), 0, 1, columns);
    }
    const int row = into->rowCount();
    for (qsizetype i = 0; i < tools.size(); ++i) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(tools[i]);
        button->setIconSize({iconSide, iconSide});
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus); // a click leaves the keys with the view
        into->addWidget(button, row + int(i) / columns, int(i) % columns);
        m_buttons += button;
    }
}

} // namespace ramure
