#include "widgets/window/main_window_export.h"

#include "core/qt/document/document.h"
#include "core/qt/session/motion/player.h"
#include "widgets/actions/billboard_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/chooser.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/sequence_task.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/validation/validation_panel.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/job_panel.h"
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStatusBar>
#include <QUrl>

namespace ramure {

/// Sequences are written while the work goes on.
MainWindow::Exports::Exports(MainWindow* window)
    : m_window(*window)
    , m_sequences(new SequenceTask(window))
{
    QObject::connect(window->m_files, &FileActions::exportRequested, window, [this] { showDialog(); });
    QObject::connect(window->m_files, &FileActions::exportAgainRequested, window, [this] { repeat(); });
    QObject::connect(window->findChild<LevelsPanel*>(), &LevelsPanel::exportRequested, window,
                     [this](const LevelOptions& levels) { showLevels(levels); });
    QObject::connect(window->m_billboards, &BillboardActions::exported, window,
                     [this](const QString& path) { tellExported(path); });
    JobPanel* progress = m_window.addJob(m_sequences, "sequenceProgress");
    QObject::connect(m_sequences, &Job::runningChanged, &m_window, [this, progress](bool running) {
        if (running)
            progress->setText(MainWindow::tr("Writing %Ln file(s)", nullptr, int(m_sequences->fileCount())));
    });
    QObject::connect(m_sequences, &Job::finished, &m_window, [this](const std::optional<Error>& error) {
        const QString folder = QDir::toNativeSeparators(QFileInfo(m_sequences->path()).absolutePath());
        if (error && error->code == ErrorCode::Cancelled)
            m_window.statusBar()->showMessage(
                MainWindow::tr("The export was cancelled; the files written so far are whole"),
                MainWindow::messageMs);
        else if (error)
            m_window.m_chooser->report(
                Severity::Error, QStringLiteral("%1\n%2").arg(
                                     MainWindow::tr("The export has ended with an error; the files written "
                                                    "before it are whole."),
                                     errorTextWithPlace(*error)));
        else
            m_window.m_banner->showMessage(
                Severity::Info,
                MainWindow::tr("%Ln file(s) written to %1", nullptr, int(m_sequences->fileCount()))
                    .arg(folder),
                MainWindow::tr("Show in folder"), [this, path = m_sequences->path()] { showInFolder(path); });
    });
}

ExportDialog* MainWindow::Exports::newDialog()
{
    auto* dialog = new ExportDialog(m_window.m_document, m_window.m_recompute, m_window.m_preferences,
                                    m_window.m_chooser, &m_window, m_window.m_player->frame());
    dialog->setSequenceTask(m_sequences);
    if (const Viewport* view = m_window.m_host->viewport()) {
        ViewSettings* settings = m_window.m_host->settings();
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
        QObject::connect(dialog, &ExportDialog::windShown, settings,
                         [settings](WindProfile game) { settings->gameWind.set(game); });
        QObject::connect(dialog, &QDialog::finished, settings,
                         [settings, before = settings->gameWind()] { settings->gameWind.set(before); });
    }
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAnalysis(m_window.m_analysis);
    QObject::connect(dialog, &ExportDialog::showRequested, &m_window, [this](NodeId tree) {
        m_window.m_document->setSelection({{tree}, noNode, {}, noIndex});
        MainWindow::showPanel(m_window.m_validation);
    });
    const auto remember = [this, dialog] {
        m_last = {dialog->settings(), dialog->path()};
        m_window.m_files->setLastExport(m_last.path);
    };
    QObject::connect(dialog, &ExportDialog::started, &m_window, remember);
    QObject::connect(dialog, &ExportDialog::exported, &m_window, [this, remember](const QString& path) {
        remember();
        tellExported(path);
    });
    return dialog;
}

void MainWindow::Exports::showDialog()
{
    ExportDialog* dialog = newDialog();
    if (const auto levels = m_window.findChild<LevelsPanel*>()->chosen())
        dialog->offerLevels(*levels);
    dialog->open();
}

void MainWindow::Exports::showLevels(const LevelOptions& levels)
{
    ExportDialog* dialog = newDialog();
    dialog->setLevels(levels);
    dialog->open();
}

void MainWindow::Exports::repeat()
{
    ExportDialog* dialog = newDialog();
    dialog->open();
    dialog->repeat(m_last.settings, m_last.path);
}

void MainWindow::Exports::tellExported(const QString& path)
{
    // Of levels and sequences the path itself is no file; of several files it may be their folder.
    const QFileInfo file(path);
    const QString place = QDir::toNativeSeparators(path);
    const QString size = QLocale().formattedDataSize(file.size(), 1, QLocale::DataSizeSIFormat);
    m_window.m_banner->showMessage(Severity::Info,
                                   file.isFile() ? MainWindow::tr("Exported to %1 (%2)").arg(place, size)
                                                 : MainWindow::tr("Exported to %1").arg(place),
                                   MainWindow::tr("Show in folder"), [this, path] { showInFolder(path); });
}

void MainWindow::Exports::showInFolder(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDir(folder).exists() || !QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        m_window.m_banner->showMessage(
            Severity::Warning,
            MainWindow::tr("The folder %1 cannot be shown").arg(QDir::toNativeSeparators(folder)));
}

} // namespace ramure
