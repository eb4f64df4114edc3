// Exports from the main window: the dialog, the same again, and where files went.
#include "core/qt/document/document.h"
#include "core/qt/session/motion/player.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/validation/validation_panel.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QUrl>

namespace ramure {

ExportDialog* MainWindow::newExportDialog()
{
    auto* dialog =
        new ExportDialog(m_document, m_recompute, m_preferences, m_chooser, this, m_player->frame());
    dialog->setSequenceTask(m_sequences);
    if (const Viewport* view = m_host->viewport()) {
        ViewSettings* settings = m_host->settings();
        PictureLook look;
        look.camera = view->camera();
        look.through = view->seenThrough();
        look.options.shading = settings->shadingMode();
        look.options.light = settings->light();
        look.view.mode = settings->displayMode();
        look.view.leaves = settings->leavesVisible();
        look.view.apples = settings->applesVisible();
        dialog->setPictureLook(look);
        dialog->offerWind();
        connect(dialog, &ExportDialog::windShown, settings,
                [settings](WindProfile game) { settings->gameWind.set(game); });
        connect(dialog, &QDialog::finished, settings,
                [settings, before = settings->gameWind()] { settings->gameWind.set(before); });
    }
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAnalysis(m_analysis);
    connect(dialog, &ExportDialog::showRequested, this, [this](NodeId tree) {
        m_document->setSelection({{tree}, noNode, {}, noIndex});
        showPanel(m_validation);
    });
    const auto remember = [this, dialog] {
        m_lastExport = {dialog->settings(), dialog->path()};
        m_files->setLastExport(m_lastExport.path);
    };
    connect(dialog, &ExportDialog::started, this, remember);
    connect(dialog, &ExportDialog::exported, this, [this, remember](const QString& path) {
        remember();
        tellExported(path);
    });
    return dialog;
}

/// What the panel of levels shows is what its page for games would write.
void MainWindow::showExportDialog()
{
    ExportDialog* dialog = newExportDialog();
    if (const auto levels = findChild<LevelsPanel*>()->chosen())
        dialog->offerLevels(*levels);
    dialog->open();
}

/// On its page for games.
void MainWindow::showLevelExport(const LevelOptions& levels)
{
    ExportDialog* dialog = newExportDialog();
    dialog->setLevels(levels);
    dialog->open();
}

/// In its dialog, which says how far it is and closes itself.
void MainWindow::repeatExport()
{
    ExportDialog* dialog = newExportDialog();
    dialog->open();
    dialog->repeat(m_lastExport.settings, m_lastExport.path);
}

/// Where it went, and the way there.
void MainWindow::tellExported(const QString& path)
{
    // Of levels and sequences the path itself is no file; of several files it may be their folder.
    const QFileInfo file(path);
    const QString place = QDir::toNativeSeparators(path);
    const QString size = QLocale().formattedDataSize(file.size(), 1, QLocale::DataSizeSIFormat);
    m_banner->showMessage(Severity::Info,
                          file.isFile() ? tr("Exported to %1 (%2)").arg(place, size)
                                        : tr("Exported to %1").arg(place),
                          tr("Show in folder"), [this, path] { showInFolder(path); });
}

void MainWindow::showInFolder(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDir(folder).exists() || !QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        m_banner->showMessage(Severity::Warning,
                              tr("The folder %1 cannot be shown").arg(QDir::toNativeSeparators(folder)));
}

} // namespace ramure
