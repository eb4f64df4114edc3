// Which columns the scene panel shows.
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/scene_tree.h"
#include <QHeaderView>
#include <QMenu>

namespace ramure {

/// Of a column in the settings.
static QString columnKey(SceneModel::Column column)
{
    constexpr const char* keys[SceneModel::columns] = {"name",   "visible",  "locked", "length",
                                                       "radius", "children", "level"};
    return QString::fromLatin1(keys[column]);
}

void ScenePanel::showColumns()
{
    const QStringList shown = m_preferences->sceneColumns();
    for (int column = SceneModel::VisibleColumn; column < SceneModel::columns; ++column) {
        const bool hidden = !shown.contains(columnKey(static_cast<SceneModel::Column>(column)));
        m_view->setColumnHidden(column, hidden);
        m_list->setColumnHidden(column, hidden);
    }
}

void ScenePanel::chooseColumn(SceneModel::Column column, bool on)
{
    QStringList shown;
    for (int each = SceneModel::VisibleColumn; each < SceneModel::columns; ++each)
        if (each == column ? on : !m_view->isColumnHidden(each))
            shown += columnKey(static_cast<SceneModel::Column>(each));
    m_preferences->sceneColumns.set(shown);
    showColumns();
}

void ScenePanel::fillColumnMenu(QMenu* menu)
{
    for (int column = SceneModel::VisibleColumn; column < SceneModel::columns; ++column) {
        QString name = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        if (name.isEmpty())
            name = m_model->headerData(column, Qt::Horizontal, Qt::AccessibleTextRole).toString();
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setChecked(!m_view->isColumnHidden(column));
        connect(action, &QAction::toggled, this,
                [this, column](bool on) { chooseColumn(static_cast<SceneModel::Column>(column), on); });
    }
}

void ScenePanel::showHeaderMenu(const QPoint& position)
{
    QMenu menu(this);
    fillColumnMenu(&menu);
    menu.exec(presentView()->header()->mapToGlobal(position));
}

} // namespace ramure
