/// \file
/// Exports from the main window: the dialog, the same again, sequences that are written while the work goes
/// on, and where the files went.
#pragma once

#include "widgets/window/main_window.h"
#include <QVariantMap>

namespace ramure {

class ExportDialog;
class SequenceTask;
struct LevelOptions;

class MainWindow::Exports
{
public:
    /// Follows the actions and panels of the window, which must be there, and which must outlive this.
    explicit Exports(MainWindow* window);

private:
    /// The page for games has the levels that the panel of levels shows.
    void showDialog();
    /// Opens the dialog on its page for games.
    void showLevels(const LevelOptions& levels);
    /// Repeats the last export in its dialog, which says how far it is and closes itself.
    void repeat();
    /// Says where an export went, and offers the way there.
    void tellExported(const QString& path);
    [[nodiscard]] ExportDialog* newDialog();
    void showInFolder(const QString& path);

    MainWindow& m_window;
    SequenceTask* m_sequences;
    struct
    {
        QVariantMap settings; ///< ExportDialog::settings
        QString path;
    } m_last;
};

} // namespace ramure
