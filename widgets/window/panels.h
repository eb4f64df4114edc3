/// \file
/// The panels around the view, a row each: the docks, their tabs, the View menu, their titles and their help
/// are made from the rows. A new panel is its own files and a row of panels.cpp.
#pragma once

#include <cstdint>
#include <span>

class QWidget;

namespace ramure {

class Analysis;
class Document;
class KeyActions;
class KeyCommands;
class KeyModel;
class PlayActions;
class Player;
class Preferences;

/// What panels are made of. Not owned.
struct PanelServices
{
    Document* document;
    Preferences* preferences;
    Analysis* analysis;
    Player* player;
    PlayActions* plays;
    KeyModel* keyModel;
    KeyCommands* keyCommands;
    KeyActions* keyActions;
};

/// Where a panel stands at first: those of one place share it as tabs, the first of them in front.
enum class PanelPlace : std::uint8_t { UpperRight, LowerRight, Bottom };

struct PanelRow
{
    const char* dock;  ///< "sceneDock": the name of its dock; "view.panel.sceneDock" is its action
    const char* title; ///< English, context "ramure::MainWindow"
    PanelPlace place;
    const char* help; ///< page and heading of the handbook: "window#scene"
    QWidget* (*make)(const PanelServices& services, QWidget* parent);
};

/// In the order of the View menu.
std::span<const PanelRow> panels();

} // namespace ramure
