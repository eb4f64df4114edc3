/// \file
/// File > Import: objects and their keys from Blender.
#pragma once

#include "core/document/document.h"
#include <QList>
#include <QObject>
#include <QPointer>
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

    [[nodiscard]] QList<QAction*> actions() const { return {m_file, m_folder}; }
    /// Is this something that can be imported: .obj, .animation, a folder?
    [[nodiscard]] static bool canImport(const QString& path);
    /// Reads it in the background, adds it to the scene and tells what was guessed.
    void importPath(const QString& path);
    [[nodiscard]] bool isRunning() const;
    /// Asks for a file, and imports it.
    void chooseFile();

signals:
    void imported(ramure::NodeId top);

private:
    void chooseFolder();
    void finish(const std::optional<Error>& error);
    void showProgress(double fraction);

    Preferences* m_preferences;
    Chooser* m_chooser;
    ImportTask* m_task;
    QWidget* m_window;
    QAction* m_file;
    QAction* m_folder;
    QString m_path;
    QPointer<QProgressDialog> m_progress;
};

} // namespace ramure
