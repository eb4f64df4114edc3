#include "widgets/actions/deleted_selection.h"

#include "core/qt/document/document.h"

namespace ramure {

DeletedSelection::DeletedSelection(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(document->undoStack(), &QUndoStack::indexChanged, this, &DeletedSelection::follow);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeSelection) && !m_document->selection().nodes.empty())
            m_waits = false; // something else is meant by now
        if (change.has(changeResults))
            bringBack();
    });
}

void DeletedSelection::remember(Selection before)
{
    m_index = m_document->undoStack()->index() - 1;
    m_deletion = m_document->undoStack()->command(m_index);
    m_before = std::move(before);
}

void DeletedSelection::follow(int index)
{
    m_waits = m_deletion && index == m_index && m_document->undoStack()->command(index) == m_deletion;
    bringBack();
}

/// Branches have the numbers they had once their tree has grown again.
void DeletedSelection::bringBack()
{
    if (!m_waits || (!m_before.branches.empty() && !m_document->isCurrent(m_before.branchNode)))
        return;
    m_waits = false;
    m_document->setSelection(m_before);
}

} // namespace ramure
