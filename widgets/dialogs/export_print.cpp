// What the export dialog does about prints.
#include "core/document/document.h"
#include "widgets/base/core_text.h"
#include "widgets/dialogs/export_dialog.h"
#include "widgets/dialogs/export_task.h"
#include "widgets/dialogs/moment_form.h"
#include "widgets/dialogs/print_form.h"

namespace ramure {

bool ExportDialog::isPrint() const
{
    return format() && m_printing->isWanted();
}

void ExportDialog::takePrint()
{
    forgetPrint();
    takeFormat();
}

/// What was prepared is another print's.
void ExportDialog::forgetPrint()
{
    m_print.reset();
    m_printing->setPrint(nullptr);
}

/// Made on the task's thread; written where \p file has a name.
void ExportDialog::startPrint(const QString& file)
{
    if (m_task->isRunning())
        return;
    if (const auto fine = checkPrint(m_printing->options()); !fine) {
        setMessage(errorText(fine.error()), true);
        return;
    }
    setMessage(file.isEmpty() ? tr("Preparing the print…") : QString(), false);
    m_isPreparing = file.isEmpty();
    m_task->startPrint(*m_document, options(), m_printing->options(), m_print, file,
                       [this](const std::shared_ptr<const ScenePrint>& print) {
                           m_print = print;
                           m_printing->setPrint(&print->tree);
                           adjustSize();
                       });
    updateWidgets();
}

/// True where the dialog goes on, since nothing was to be written.
bool ExportDialog::hasPrepared(const std::optional<Error>& error)
{
    if (!std::exchange(m_isPreparing, false) || error)
        return false;
    setMessage({}, false);
    return true;
}

} // namespace ramure
