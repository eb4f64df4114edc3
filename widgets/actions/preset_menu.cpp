#include "widgets/actions/preset_menu.h"

#include "widgets/base/core_text.h"
#include "widgets/base/preset_title.h"
#include <QMenu>
#include <string_view>

namespace ramure {

void addPreset(QMenu* menu, const Preset& preset, QAction* action)
{
    if (std::string_view(preset.group) == presets().front().group) {
        menu->addAction(action);
        return;
    }
    const QString group = QString::fromUtf8(preset.group);
    auto* submenu = menu->findChild<QMenu*>(group, Qt::FindDirectChildrenOnly);
    if (!submenu) {
        submenu = new QMenu(menu);
        submenu->setObjectName(group);
        submenu->setToolTipsVisible(true);
        menu->addMenu(submenu);
    }
    submenu->addAction(action);
}

void describePreset(const Preset& preset, QAction* action)
{
    action->setText(presetTitle(QString::fromLatin1(preset.name)));
    action->setToolTip(presetTip(preset));
    action->setStatusTip(action->toolTip());
}

void nameGroups(QMenu* menu)
{
    for (QMenu* submenu : menu->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
        submenu->setTitle(coreText(submenu->objectName().toUtf8().constData()));
}

} // namespace ramure
