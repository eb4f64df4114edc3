// Gestures whose edits come onto the undo stack only when they are kept.
#include "core/document/document_command.h"
#include "core/document/joined_steps.h"

namespace ramure {
namespace {

/// The last step that can be undone; null where it must not change any more. A command on the stack may only
/// take in what is done already, as in QUndoStack's own merging.
DocumentCommand* lastStep(const QUndoStack& stack)
{
    if (stack.index() == 0 || stack.isClean())
        return nullptr;
    return dynamic_cast<DocumentCommand*>(const_cast<QUndoCommand*>(stack.command(stack.index() - 1)));
}

} // namespace

void joinToLastStep(Document& document, GestureId gesture)
{
    if (DocumentCommand* last = document.isHeld(gesture) ? lastStep(*document.undoStack()) : nullptr)
        last->awaitGesture(gesture);
}

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
    if (!held || held->isObsolete()) // it ended where it began
        return;
    DocumentCommand* last = lastStep(m_undoStack);
    if (last && last->awaits(gesture) && !m_undoStack.canRedo())
        last->join(std::move(held));
    else
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
