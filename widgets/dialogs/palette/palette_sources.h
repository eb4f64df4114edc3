/// \file
/// Collects the items of the palette; texts in the interface's present language.
#pragma once

#include "widgets/dialogs/palette/palette_item.h"
#include <QList>
#include <vector>

class QMenu;

namespace ramure {

class ActionSet;
class Document;

/// Every action of the set that stands in one of the menus.
std::vector<PaletteItem> commandItems(const ActionSet& set, const QList<QMenu*>& menus);
/// Every row of the parameter table; disabled where no node of the scene has it.
std::vector<PaletteItem> paramItems(const Document& document);
/// Every page and heading of the handbook.
std::vector<PaletteItem> pageItems();

} // namespace ramure
