#include "widgets/window/job_panel.h"

#include "core/qt/session/jobs/job.h"
#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/theme/icons.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>

namespace ramure {

JobPanel::JobPanel(Job* job, const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_job(job)
    , m_text(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_cancel(new QToolButton(this))
    , m_patience(new QTimer(this))
{
    setObjectName(name);
    auto* row = layoutOf<QHBoxLayout>(this, 8, {8, 3, 8, 3});
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    m_progress->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    m_cancel->setAutoRaise(true);
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    row->addWidget(m_text);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);
    m_patience->setSingleShot(true);
    m_patience->setInterval(patienceMs);
    connect(m_patience, &QTimer::timeout, this, [this] { setVisible(m_job->isRunning()); });
    connect(m_cancel, &QToolButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        m_job->cancel();
    });
    connect(m_job, &Job::runningChanged, this, [this](bool running) {
        m_progress->setValue(0);
        m_cancel->setEnabled(true);
        if (running) {
            m_patience->start();
        } else {
            m_patience->stop();
            hide();
        }
    });
    connect(m_job, &Job::progress, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(fraction * progressSteps)); });
    m_cancel->setToolTip(tr("Give this up; no half-written file stays"));
    m_cancel->setAccessibleName(tr("Cancel"));
    hide();
}

void JobPanel::setText(const QString& text)
{
    m_text->setText(text);
    m_progress->setAccessibleName(text);
}

} // namespace ramure
