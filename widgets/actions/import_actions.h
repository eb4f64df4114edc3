/// \file
/// File > Import: objects of any mesh file and their keys from Blender. They are opened as well: into a scene
/// of their own.
#pragma once

#include "core/qt/document/document.h"
#include <QList>
#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

class QAction;
class QProgressDialog;

namespace ramure {

class ActionSet;
class Chooser;
class ImportTask;
class Preferences;

class ImportActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions. \p window stands behind the progress dialog.
    ImportActions(Document* document, Preferences* preferences, Chooser* chooser, ActionSet* set,
                  QWidget* window);

    /// Is this something that can be imported: a folder, or a file of a format that is read?
    [[nodiscard]] static bool canImport(const QString& path);
    /// Such files, as a file dialog has it.
    [[nodiscard]] static QString fileFilter();
    /// Reads a file in the background, adds it to the scene and reports its notes. \param stays the objects
    /// keep the place that the file gives them, even if something stands there; else they are moved beside it
    /// (edit::moveBeside)
    void importPath(const QString& path, bool stays = false);
    /// Reads it in the background and hands it on; the document is left alone. \p take says whether it was
    /// wanted, and gets nothing where there was an error, which has been told, or the user has cancelled.
    void openPath(const QString& path, std::function<bool(std::optional<Scene>)> take);
    [[nodiscard]] bool isRunning() const;
    /// Asks for a file, and imports it.
    void chooseFile();
    void chooseToWear(); ///< for an arm, which wears the mesh where it stands

signals:
    void imported(ramure::NodeId top);

private:
    void chooseFolder();
    void choose(bool stays);
    void begin(const QString& path, const QString& title, const QString& text);
    void finish(ramure::NodeId top, const std::optional<Error>& error);
    void tellNotes(const QString& text);
    void showProgress(double fraction);

    Preferences* m_preferences;
    Chooser* m_chooser;
    ImportTask* m_task;
    QWidget* m_window;
    QString m_path;
    std::function<bool(std::optional<Scene>)> m_take; ///< called with the scene that is being opened
    QPointer<QProgressDialog> m_progress;
};

} // namespace ramure
