#include "widgets/dialogs/export/print_preparer.h"

#include "core/qt/document/document.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/dialogs/export/print_form.h"

namespace ramure {

constexpr int printRestMs = 300;

PrintPreparer::PrintPreparer(const Document* document, PrintForm* form,
                             std::function<ExportOptions()> options, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_form(form)
    , m_options(std::move(options))
    , m_job(nullptr, Job::Manner::Polite)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(printRestMs);
    connect(&m_rest, &QTimer::timeout, this, &PrintPreparer::prepare);
    connect(form, &PrintForm::changed, this, &PrintPreparer::forget);
    connect(form, &PrintForm::prepareRequested, this, &PrintPreparer::prepare);
    connect(form, &PrintForm::cancelRequested, this, &PrintPreparer::cancel);
    connect(&m_job, &Job::progress, form, &PrintForm::setProgress);
    connect(&m_job, &Job::progress, this, &PrintPreparer::progress);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeStructure | changeParams | changeNodeState | changeReset | changeBranches |
                       changeTracks))
            forget();
    });
}

void PrintPreparer::forget()
{
    m_print.reset();
    m_form->setPrint(nullptr);
    if (!isRunning())
        return;
    m_job.forget();
    if (m_form->isWanted())
        return m_rest.start();
    m_rest.stop();
    m_form->setPreparing(false);
}

void PrintPreparer::prepare()
{
    m_rest.stop();
    if (const auto fine = checkPrint(m_form->options()); !fine)
        return take(fail(fine.error()));
    emit began();
    m_form->setPreparing(true);
    m_job.start(
        [which = m_options(), print = m_form->options(), scene = m_document->scene(),
         source = snapshotOf(*m_document)](
            const Progress& progress) -> Expected<std::shared_ptr<const ScenePrint>> {
            Evaluator evaluator(source, scene.timeline());
            auto made = printScene(evaluator.at(scene), which, print, progress);
            RAMURE_TRY(made);
            return std::make_shared<const ScenePrint>(std::move(*made));
        },
        [this](Expected<std::shared_ptr<const ScenePrint>>&& made) { take(made); });
}

void PrintPreparer::take(const Expected<std::shared_ptr<const ScenePrint>>& made)
{
    m_form->setPreparing(false);
    m_print = made.value_or(nullptr);
    m_form->setPrint(m_print ? std::shared_ptr<const PrintedTree>(m_print, &m_print->tree) : nullptr);
    emit finished(made ? std::nullopt : std::optional(made.error()));
}

void PrintPreparer::cancel()
{
    if (m_rest.isActive()) {
        m_rest.stop();
        take(fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")));
    } else {
        m_job.cancel();
    }
}

} // namespace ramure
