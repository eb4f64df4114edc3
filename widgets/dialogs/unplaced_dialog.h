/// \file
/// Lists hand edits on branches that have gone, with their former places, and lets the user delete them.
#pragma once

#include "core/qt/session/jobs/unplaced_edits.h"
#include <QDialog>

class QPushButton;
class QTreeWidget;

namespace ramure {

class UnplacedDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the dialog, which closes when no edit is left.
    explicit UnplacedDialog(Document* document, QWidget* parent = nullptr);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void follow();
    /// \param all also edits that are not selected
    void remove(bool all);

    Document* m_document;
    std::vector<UnplacedEdit> m_edits; ///< in the order of the rows
    QTreeWidget* m_list;
    QPushButton* m_delete;
};

} // namespace ramure
