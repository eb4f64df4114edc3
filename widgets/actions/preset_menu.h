/// \file
/// Menus of the presets, a submenu for each group: species first, then what grammars are shown with.
#pragma once

#include "core/presets/presets.h"

class QAction;
class QMenu;

namespace ramure {

void addPreset(QMenu* menu, const Preset& preset, QAction* action);
/// Sets its name and its tips.
void describePreset(const Preset& preset, QAction* action);
/// Brings the presets of each submenu into the order of the alphabet, after describePreset() of each.
void sortGroups(QMenu* menu);

} // namespace ramure
