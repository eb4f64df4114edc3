#include "widgets/dialogs/palette/palette_sources.h"

#include "core/params/param_def.h"
#include "core/qt/document/document.h"
#include "widgets/base/action_list.h"
#include "widgets/base/action_set.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/help/handbook.h"
#include <QCoreApplication>

namespace ramure {
namespace {

struct PaletteWords
{
    Q_DECLARE_TR_FUNCTIONS(Palette)
};

QString inside(const QString& outer, const QString& inner)
{
    return inner.isEmpty() ? outer : outer + QStringLiteral(" › ") + inner;
}

} // namespace

std::vector<PaletteItem> commandItems(const ActionSet& set, const QList<QMenu*>& menus)
{
    std::vector<PaletteItem> items;
    for (const ListedAction& listed : listedActions(set, menus)) {
        const QAction& action = *listed.action;
        if (!action.isVisible())
            continue;
        PaletteItem item;
        item.kind = PaletteItem::Command;
        item.id = action.objectName();
        item.title = listed.text.section(QStringLiteral(" › "), -1);
        item.place = inside(listed.menu, listed.text.section(QStringLiteral(" › "), 0, -2));
        item.words = item.id + u' ' + action.statusTip();
        item.keys = action.shortcut().toString(QKeySequence::NativeText);
        item.enabled = action.isEnabled();
        if (!item.enabled)
            item.reason = action.statusTip();
        item.icon = action.isChecked() ? icon("check") : action.icon();
        items.push_back(std::move(item));
    }
    return items;
}

std::vector<PaletteItem> paramItems(const Document& document)
{
    std::vector<PaletteItem> items;
    for (const ParamDef& def : paramTable()) {
        PaletteItem item;
        item.kind = PaletteItem::Parameter;
        item.id = QString::fromLatin1(def.key);
        item.title = coreText(def.label);
        item.place = inside(PaletteWords::tr("Properties"), coreText(def.group));
        item.words = item.id + u' ' + coreText(def.tooltip);
        item.enabled = nodeWithParam(document, def) != noNode;
        if (!item.enabled)
            item.reason = whyNoNode(document, def);
        item.icon = icon("properties");
        items.push_back(std::move(item));
    }
    return items;
}

std::vector<PaletteItem> pageItems()
{
    std::vector<PaletteItem> items;
    for (const HandbookPage& page : readHandbook()) {
        for (const HandbookHeading& heading : page.headings) {
            const bool isTitle = &heading == &page.headings.front();
            PaletteItem item;
            item.kind = PaletteItem::Page;
            item.id = isTitle ? page.id : page.id + u'#' + heading.anchor;
            item.title = heading.text;
            item.place = inside(PaletteWords::tr("Handbook"), isTitle ? QString() : page.title());
            item.icon = icon("handbook");
            items.push_back(std::move(item));
        }
    }
    return items;
}

} // namespace ramure
