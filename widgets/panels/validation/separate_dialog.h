/// \file
/// Moves the colliding branches of a tree apart, with progress and cancel, and says how far it came.
#pragma once

#include "core/qt/session/jobs/separation_task.h"
#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace ramure {

class SeparateDialog : public QDialog
{
    Q_OBJECT
public:
    /// Begins at once. \param document is not owned and must outlive the dialog.
    SeparateDialog(Document* document, NodeId tree, QWidget* parent = nullptr);

signals:
    /// Reports the result for the status bar.
    void messageRaised(const QString& text);

public slots:
    void reject() override; ///< stops a running job first

private:
    void finish(const std::optional<Error>& error);
    [[nodiscard]] static QString outcomeText(const Separation& outcome);

    SeparationTask* m_task;
    QLabel* m_text;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
};

} // namespace ramure
