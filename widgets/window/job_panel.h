/// \file
/// In the status bar: what one background job is doing, how far it is, and a button to give it up. Nothing
/// while the job rests.
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace ramure {

class Job;

class JobPanel : public QWidget
{
    Q_OBJECT
public:
    /// \param job is not owned and must outlive the panel. \param name of the object, for tests and style.
    JobPanel(Job* job, const QString& name, QWidget* parent = nullptr);

    /// "Baking the motion"; in the present language.
    void setText(const QString& text);

private:
    Job* m_job;
    QLabel* m_text;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QTimer* m_patience; ///< short work shows nothing
};

} // namespace ramure
