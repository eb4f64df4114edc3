/// \file
/// Menus of the presets: those of the coursework stand in the menu itself, species in a submenu of their
/// group.
#pragma once

#include "core/params/presets.h"

class QAction;
class QMenu;

namespace ramure {

void addPreset(QMenu* menu, const Preset& preset, QAction* action);
/// Its name and its tips, in the language of now.
void describePreset(const Preset& preset, QAction* action);
/// The submenus' titles, in the language of now.
void nameGroups(QMenu* menu);

} // namespace ramure
