#include "widgets/actions/preset_menu.h"

#include "widgets/base/texts/preset_title.h"
#include <QCollator>
#include <QLocale>
#include <QMenu>
#include <algorithm>

namespace ramure {

static constexpr const char* isSpeciesKey = "isSpecies";

void addPreset(QMenu* menu, const Preset& preset, QAction* action)
{
    const QString group = QString::fromUtf8(preset.group);
    auto* submenu = menu->findChild<QMenu*>(group, Qt::FindDirectChildrenOnly);
    if (!submenu) {
        submenu = new QMenu(presetGroupTitle(preset.group), menu);
        submenu->setObjectName(group);
        submenu->setToolTipsVisible(true);
        submenu->menuAction()->setProperty(isSpeciesKey, isSpecies(preset));
        const QList<QAction*> groups = menu->actions();
        const auto before = std::ranges::find_if(groups, [&preset](const QAction* other) {
            return isSpecies(preset) && !other->property(isSpeciesKey).toBool();
        });
        menu->insertMenu(before == groups.end() ? nullptr : *before, submenu);
    }
    submenu->addAction(action);
}

void describePreset(const Preset& preset, QAction* action)
{
    action->setText(presetTitle(QString::fromLatin1(preset.name)));
    action->setToolTip(presetTip(preset));
    action->setStatusTip(action->toolTip());
}

void sortGroups(QMenu* menu)
{
    QCollator collator{QLocale()};
    collator.setNumericMode(true);
    for (QMenu* submenu : menu->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!submenu->menuAction()->property(isSpeciesKey).isValid())
            continue;
        QList<QAction*> actions = submenu->actions();
        std::ranges::stable_sort(actions, [&collator](const QAction* a, const QAction* b) {
            return collator.compare(a->text(), b->text()) < 0;
        });
        submenu->addActions(actions); // of those that are there: to the end
    }
}

} // namespace ramure
