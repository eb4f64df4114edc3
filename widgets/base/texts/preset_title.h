/// \file
/// Names of the trees that ship with the program, in the interface's language (context "presets").
#pragma once

#include <QString>

namespace ramure {

struct Node;
struct Preset;

/// "SilverBirch": "Silver Birch", in French "Bouleau verruqueux"; other names as spacedName() has them.
QString presetTitle(const QString& name);
/// Returns the title of a group of presets for menus and galleries. Scripts know the group by Preset::group.
QString presetGroupTitle(const char* group);
/// All names it has, for a search: the title, the English and the Latin one.
QString presetNames(const Preset& preset);
/// Returns its Latin name, if it has one, and a short description.
QString presetTip(const Preset& preset);
/// Not what grammars and points are shown with: these stand before the species among the presets, and behind
/// them in menus and galleries.
bool isSpecies(const Preset& preset);
/// Names a tree just made of a preset by its title where that is no English one: names of nodes and files are
/// without blanks else.
void giveTitle(Node& tree);

} // namespace ramure
