/// \file
/// The File menu: new, open, save, recent files, and the question about unsaved changes.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/base/chooser.h"
#include <QList>
#include <QObject>
#include <optional>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class ImportActions;
class Preferences;

class FileActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    FileActions(Document* document, Preferences* preferences, Chooser* chooser, ActionSet* set,
                QObject* parent);

    /// Appends what begins a scene: presets, demos, files.
    void fillNewMenus(QMenu* menu);
    /// Sets the name of the last exported file for the menu entry that exports it again; empty: there is
    /// nothing to repeat.
    void setLastExport(const QString& path);
    /// Sets the actions that open objects which are no projects. Without it only projects open. Not owned.
    void setImports(ImportActions* imports) { m_imports = imports; }

    /// Asks about unsaved changes where there are any. True: the document may go.
    bool mayDiscard();
    /// Each returns whether it was done; errors are reported to the chooser, and the document stays as it
    /// was.
    bool newEmpty(); ///< a scene without a node
    /// \param preset as namedTree takes it.
    bool newFromPreset(const QString& preset);
    bool newFromDemo(const QString& demo); ///< see core/scene/demo_scenes.h
    /// A project, or objects into a new scene without a name; what can be read asks about unsaved changes.
    /// Objects are read in the background: openEnded() then says later how it ended.
    bool openFile(const QString& path);
    [[nodiscard]] bool isOpening() const;
    bool open();
    bool save(); ///< "save as" where the document has no file yet
    bool saveAs();

    /// Returns "tree.ramure", or the name for a document without a file.
    [[nodiscard]] QString documentName() const;

signals:
    void openEnded(bool opened); ///< once for every openFile
    void succeeded();            ///< a file was opened or saved: what went wrong before it is past
    void exportRequested();
    void exportAgainRequested();
    void quitRequested();

private:
    void packPictures();
    bool saveTo(const QString& path);
    bool openProject(const QString& path);
    bool takeObjects(const QString& path, std::optional<Scene> scene);
    void resetTo(Scene scene, const QString& path, std::string extras = {});
    bool startWith(Expected<Scene> scene, const QString& why);
    void reportError(const QString& what, const Error& error);
    void fillRecentMenu();
    void remember(const QString& path);
    [[nodiscard]] QString projectFilter() const;

    Document* m_document;
    Preferences* m_preferences;
    Chooser* m_chooser;
    ActionSet* m_set;
    ImportActions* m_imports = nullptr;
    QMenu* m_recentMenu = nullptr;
    std::vector<QAction*> m_presets;
    QList<QAction*> m_demos;
};

} // namespace ramure
