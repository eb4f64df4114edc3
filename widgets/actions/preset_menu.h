/// \file
/// Menus of the presets, a submenu for each group: species first, then what grammars are shown with.
#pragma once

#include "core/params/presets.h"

class QAction;
class QMenu;

namespace ramure {

void addPreset(QMenu* menu, const Preset& preset, QAction* action);
/// Its name and its tips, in the language of now.
void describePreset(const Preset& preset, QAction* action);
/// The submenus' titles, and their presets in the order of the alphabet, in the language of now. After
/// describePreset() of each.
void nameGroups(QMenu* menu);

} // namespace ramure
