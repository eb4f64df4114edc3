#include "widgets/actions/help_actions.h"

#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/palette/palette.h"
#include "widgets/dialogs/palette/palette_sources.h"
#include "widgets/help/handbook_window.h"
#include "widgets/help/help_places.h"
#include "widgets/help/tour.h"
#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <iterator>

namespace ramure {

HelpActions::HelpActions(ActionSet* set, Document* document, Preferences* preferences, QMainWindow* window)
    : QObject(window)
    , m_set(set)
    , m_document(document)
    , m_preferences(preferences)
    , m_window(window)
    , m_palette(new Palette(window))
    , m_tour(new Tour(window, set, document))
{
    set->add(this, {{"help.find", Actions::tr("&Find anything…"), "search", Qt::Key_F3,
                     Actions::tr("Finds every command, parameter and page of the handbook"),
                     [this] { showPalette(); }},
                    {"help.handbook", Actions::tr("&Handbook"), "handbook", Qt::Key_F1,
                     Actions::tr("Explains the parameter or panel under the mouse"),
                     [this] { showHandbook(helpPlaceHere()); }},
                    {"help.tour", Actions::tr("&Tour"), "tour", noKeys,
                     Actions::tr("Five steps through the window"), [this] { m_tour->start(); }}});
    connect(m_palette, &Palette::chosen, this, &HelpActions::take, Qt::QueuedConnection);
    qApp->installEventFilter(this);
}

HelpActions::~HelpActions() = default;

void HelpActions::showPalette()
{
    std::vector<PaletteItem> items = commandItems(*m_set, m_menus);
    for (std::vector<PaletteItem> more : {paramItems(*m_document), pageItems()})
        std::ranges::move(more, std::back_inserter(items));
    m_palette->open(std::move(items), m_preferences->recentFinds());
}

void HelpActions::take(const PaletteItem& item)
{
    m_preferences->addRecentFind(paletteName(item));
    switch (item.kind) {
    case PaletteItem::Command:
        if (QAction* action = m_set->find(item.id))
            action->trigger();
        break;
    case PaletteItem::Parameter:
        emit paramRequested(item.id);
        break;
    case PaletteItem::Page:
        showHandbook(item.id);
        break;
    }
}

void HelpActions::showHandbook(const QString& place)
{
    if (!m_handbook)
        m_handbook = std::make_unique<HandbookWindow>();
    m_handbook->showPlace(place);
}

bool HelpActions::startTourOnce()
{
    if (m_preferences->tourSeen())
        return false;
    m_preferences->tourSeen.set(true);
    m_tour->start();
    return true;
}

/// In dialogs, which the window's shortcuts do not reach.
bool HelpActions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto* widget = qobject_cast<QWidget*>(watched);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isElsewhere = widget && widget->window() != m_window && widget->window() != m_handbook.get();
    if (!isElsewhere || QKeySequence(key->keyCombination()) != m_set->find("help.handbook")->shortcut())
        return false;
    const QString place = helpPlace(widget);
    if (!place.isEmpty())
        showHandbook(place);
    return !place.isEmpty();
}

} // namespace ramure
