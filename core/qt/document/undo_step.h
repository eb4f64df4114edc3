/// \file
/// What stands on the undo stack. For UndoHistory only.
#pragma once

#include "core/qt/document/document_command.h"
#include <QUndoCommand>

namespace ramure {

/// One step: the commands of a gesture, those of a OneStep, or one alone, in the order in which they were
/// done.
class UndoStep final : public QUndoCommand
{
public:
    using Commands = std::vector<std::unique_ptr<DocumentCommand>>;

    /// \param commands all done; the stack's first redo() does nothing
    UndoStep(Commands commands, GestureId gesture, const QString& text);

    /// Steps of one gesture may merge, whatever their commands are.
    [[nodiscard]] int id() const override { return m_gesture == 0 ? -1 : 1; }
    void undo() override;
    void redo() override;
    bool mergeWith(const QUndoCommand* other) override;

    /// What this gesture does, once it is kept, becomes part of this step, see UndoHistory::joinToLast.
    void awaitGesture(GestureId gesture) { m_awaited = gesture; }
    [[nodiscard]] bool awaits(GestureId gesture) const { return gesture != 0 && gesture == m_awaited; }
    /// \pre the scene is as after both
    void join(Commands next);

    /// Not less than the memory that it holds: data that is shared with other steps counts in full.
    [[nodiscard]] std::size_t mostBytes() const { return m_mostBytes; }
    void countMemory(MemoryCount& memory) const;
    /// A step of the same content that never merges; this one is empty afterwards. \pre it is done
    [[nodiscard]] std::unique_ptr<UndoStep> moved();

private:
    void measure();

    Commands m_commands;
    GestureId m_gesture;
    GestureId m_awaited = 0;
    std::size_t m_mostBytes = 0;
    bool m_isDone = true; ///< the scene is as after redo() already: the next one does nothing
};

/// Adds a command that is done to those before it, or to the last of them, where both are of one gesture.
/// What ends where it began does not stay.
void addCommand(UndoStep::Commands& commands, std::unique_ptr<DocumentCommand> next);

} // namespace ramure
