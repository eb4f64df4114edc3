// What the export dialog does about prints.
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/recompute.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/print_form.h"
#include <QCheckBox>
#include <QProgressBar>
#include <QTimer>

namespace ramure {

constexpr int printRestMs = 300;

void ExportDialog::buildPrint()
{
    m_printRest->setSingleShot(true);
    m_printRest->setInterval(printRestMs);
    connect(m_printRest, &QTimer::timeout, this, &ExportDialog::preparePrint);
    connect(m_printing, &PrintForm::changed, this, &ExportDialog::takePrint);
    connect(m_printing, &PrintForm::prepareRequested, this, &ExportDialog::preparePrint);
    connect(m_printing, &PrintForm::cancelRequested, this, &ExportDialog::cancelPrint);
    connect(m_preparer, &Job::progress, this, [this](double fraction) {
        m_printing->setProgress(fraction);
        m_progress->setValue(static_cast<int>(fraction * m_progress->maximum()));
    });
    connect(m_recompute, &Recompute::busyChanged, this,
            [this](bool busy) { m_printing->setMayPrepare(!busy); });
    for (QCheckBox* box : {m_selection, m_hidden})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::forgetPrint);
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeStructure | changeParams | changeNodeState | changeReset | changeBranches |
                       changeTracks))
            forgetPrint();
    });
}

bool ExportDialog::isPrint() const
{
    return format() && m_printing->isWanted();
}

bool ExportDialog::isPreparing() const
{
    return m_printRest->isActive() || m_preparer->isRunning();
}

void ExportDialog::takePrint()
{
    forgetPrint();
    takeFormat();
}

/// What was prepared is another print's. One that is being prepared is begun anew with what is wanted now.
void ExportDialog::forgetPrint()
{
    m_print.reset();
    m_printing->setPrint(nullptr);
    if (!isPreparing())
        return;
    m_preparer->forget();
    if (isPrint())
        return m_printRest->start();
    m_printRest->stop();
    m_printing->setPreparing(false);
}

/// In the background; nothing is written.
void ExportDialog::preparePrint()
{
    m_printRest->stop();
    if (const auto fine = checkPrint(m_printing->options()); !fine)
        return takePrepared(fail(fine.error()));
    setMessage({}, false);
    m_printing->setPreparing(true);
    m_preparer->start(
        [which = options(), print = m_printing->options(), scene = m_document->scene(),
         source = snapshotOf(*m_document)](
            const Progress& progress) -> Expected<std::shared_ptr<const ScenePrint>> {
            Evaluator evaluator(source, scene.timeline());
            auto made = printScene(evaluator.at(scene), which, print, progress);
            RAMURE_TRY(made);
            return std::make_shared<const ScenePrint>(std::move(*made));
        },
        [this](Expected<std::shared_ptr<const ScenePrint>>&& made) { takePrepared(made); });
}

void ExportDialog::takePrepared(const Expected<std::shared_ptr<const ScenePrint>>& made)
{
    m_printing->setPreparing(false);
    const bool writes = std::exchange(m_writesPrint, false);
    if (!made) {
        m_printing->setPrint(nullptr);
        const bool isCancelled = made.error().code == ErrorCode::Cancelled;
        setMessage(isCancelled ? tr("Cancelled. No file was changed.") : errorText(made.error()),
                   !isCancelled);
        return updateWidgets();
    }
    m_print = *made;
    m_printing->setPrint({m_print, &m_print->tree});
    if (writes)
        return writePreparedPrint();
    updateWidgets();
    makeRoom(pageHint());
}

void ExportDialog::cancelPrint()
{
    if (m_printRest->isActive()) {
        m_printRest->stop();
        takePrepared(fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")));
    } else {
        m_preparer->cancel();
    }
}

/// As it was prepared; what was not, or is being prepared, is waited for.
void ExportDialog::writePreparedPrint()
{
    if (m_task->isRunning())
        return;
    if (m_print) {
        m_task->startPrint(m_print, options().write, path());
    } else {
        m_writesPrint = true;
        if (!m_preparer->isRunning())
            preparePrint();
    }
    updateWidgets();
}

} // namespace ramure
