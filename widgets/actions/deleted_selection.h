/// \file
/// What was selected when it was deleted is selected again where that is undone.
#pragma once

#include "core/qt/document/selection.h"
#include <QObject>

class QUndoCommand;

namespace ramure {

class Document;

class DeletedSelection : public QObject
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive this.
    DeletedSelection(Document* document, QObject* parent);
    /// Right after the deletion, which is the newest step of undo. \param before what was selected until
    /// then.
    void remember(Selection before);

private:
    void follow(int index);
    void bringBack();

    Document* m_document;
    const QUndoCommand* m_deletion = nullptr; ///< only ever compared
    int m_index = 0;                          ///< of the deletion
    Selection m_before;
    bool m_waits = false; ///< for the tree whose branches were selected
};

} // namespace ramure
