#include "widgets/panels/validation/separate_dialog.h"

#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace ramure {
SeparateDialog::SeparateDialog(Document* document, NodeId tree, QWidget* parent)
    : QDialog(parent)
    , m_task(new SeparationTask(document, this))
    , m_text(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_cancel(new QPushButton(this))
{
    setWindowTitle(tr("Move colliding branches apart"));
    auto* layout = layoutOf<QVBoxLayout>(this, 12, {18, 18, 18, 14});
    m_text->setWordWrap(true);
    m_text->setMinimumWidth(360);
    m_text->setText(
        tr("Turning branches and looking at the mesh again, until none collide or no turn helps…"));
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_cancel->setText(tr("Cancel"));
    layout->addWidget(m_text);
    layout->addWidget(m_progress);
    layout->addWidget(m_cancel, 0, Qt::AlignRight);
    connect(m_cancel, &QPushButton::clicked, this, &SeparateDialog::reject);
    connect(m_task, &SeparationTask::progress, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(fraction * progressSteps)); });
    connect(m_task, &SeparationTask::finished, this, &SeparateDialog::finish);
    if (const auto started = m_task->start(tree); !started)
        finish(started.error());
}

void SeparateDialog::reject()
{
    if (!m_task->isRunning())
        return QDialog::reject();
    m_task->cancel();
    m_cancel->setEnabled(false);
}

void SeparateDialog::finish(const std::optional<Error>& error)
{
    m_cancel->setEnabled(true);
    if (!error) {
        emit messageRaised(outcomeText(m_task->outcome()));
        return accept();
    }
    if (error->code == ErrorCode::Cancelled)
        return QDialog::reject();
    m_progress->hide();
    m_text->setText(errorText(*error));
    m_cancel->setText(tr("Close"));
}

QString SeparateDialog::outcomeText(const Separation& outcome)
{
    const int before = static_cast<int>(outcome.before), rest = static_cast<int>(outcome.rest.size());
    if (before == 0)
        return tr("No branches collide.");
    if (rest == 0)
        return tr("All %Ln colliding pair(s) moved apart", nullptr, before);
    return tr("%1 of %Ln colliding pair(s) moved apart; the rest are listed", nullptr, before)
        .arg(QLocale().toString(before - rest));
}

} // namespace ramure
