/// \file
/// Actions that explain the program: the palette that finds everything, the handbook, the tour.
#pragma once

#include <QList>
#include <QObject>
#include <memory>

class QAction;
class QMainWindow;
class QMenu;

namespace ramure {

class ActionSet;
class Document;
class HandbookWindow;
class Palette;
struct PaletteItem;
class Preferences;
class Tour;

class HelpActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    HelpActions(ActionSet* set, Document* document, Preferences* preferences, QMainWindow* window);
    ~HelpActions() override;

    /// The menus whose actions the palette finds.
    void setMenus(const QList<QMenu*>& menus) { m_menus = menus; }
    [[nodiscard]] Palette* palette() const { return m_palette; }
    [[nodiscard]] Tour* tour() const { return m_tour; }
    /// Null until it was opened for the first time.
    [[nodiscard]] HandbookWindow* handbook() const { return m_handbook.get(); }

    void showPalette();
    /// "page" or "page#anchor"; empty: the first page.
    void showHandbook(const QString& place);
    /// Starts the tour once for each user; returns true if it has begun.
    bool startTourOnce();

signals:
    /// The parameter with this key is to be shown.
    void paramRequested(const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(const PaletteItem& item);

    ActionSet* m_set;
    Document* m_document;
    Preferences* m_preferences;
    QMainWindow* m_window;
    QList<QMenu*> m_menus;
    Palette* m_palette;
    Tour* m_tour;
    std::unique_ptr<HandbookWindow> m_handbook;
};

} // namespace ramure
