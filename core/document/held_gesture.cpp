// Gestures whose edits come onto the undo stack only when they are kept.
#include "core/document/document_command.h"

namespace ramure {

void Document::holdGesture(quint64 gesture)
{
    keepGesture(m_heldGesture);
    m_heldGesture = gesture;
    m_heldIndex = m_undoStack.index();
}

void Document::keepGesture(quint64 gesture)
{
    if (!isHeld(gesture))
        return;
    m_heldGesture = 0;
    auto held = std::exchange(m_held, nullptr);
    if (held && !held->isObsolete()) // else it ended where it began
        m_undoStack.push(held.release());
}

bool Document::giveUpGesture(quint64 gesture)
{
    if (!isHeld(gesture))
        return false;
    m_heldGesture = 0;
    if (const auto held = std::exchange(m_held, nullptr))
        held->undo();
    return true;
}

void Document::push(std::unique_ptr<DocumentCommand> command)
{
    if (isHeld(command->gesture()) && m_undoStack.index() != m_heldIndex)
        keepGesture(m_heldGesture); // undone or edited under the hand
    if (!isHeld(command->gesture())) {
        m_undoStack.push(command.release());
        return;
    }
    command->redo();
    command->setDone();
    if (!m_held) {
        m_held = std::move(command);
    } else if (!m_held->mergeWith(command.get())) {
        keepGesture(m_heldGesture);
        m_undoStack.push(command.release());
    }
}

} // namespace ramure
