/// \file
/// After a crash: which documents were open, and what to do with them.
#pragma once

#include "widgets/base/chooser.h"
#include <QDialog>

class QPushButton;
class QTreeWidget;

namespace ramure {

class RecoveryDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param entries at least one; the first is selected.
    explicit RecoveryDialog(const QList<RecoveryEntry>& entries, QWidget* parent = nullptr);

    /// Returns the choice; Later if the dialog was just closed.
    [[nodiscard]] RecoveryAnswer answer() const { return m_answer; }

private:
    void finish(RecoveryAnswer::Action action);
    void addEntries(const QList<RecoveryEntry>& entries);

    RecoveryAnswer m_answer;
    QTreeWidget* m_list;
};

} // namespace ramure
