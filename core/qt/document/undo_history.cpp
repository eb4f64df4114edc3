#include "core/qt/document/undo_history.h"

#include "core/qt/document/undo_step.h"
#include "core/scene/scene.h"

#include <QScopedValueRollback>
#include <QSignalBlocker>

namespace ramure {

UndoHistory::UndoHistory(const Scene& scene)
    : m_scene(scene)
{
}

UndoHistory::~UndoHistory() = default;

/// The last step that can be undone; null where it must not change any more: a saved one.
UndoStep* UndoHistory::lastStep()
{
    if (!m_stack.canUndo() || m_stack.isClean())
        return nullptr;
    return static_cast<UndoStep*>(const_cast<QUndoCommand*>(m_stack.command(m_stack.index() - 1)));
}

void UndoHistory::joinToLast(GestureId gesture)
{
    if (UndoStep* last = isHeld(gesture) ? lastStep() : nullptr)
        last->awaitGesture(gesture);
}

/// Does what changes the scene by commands; no other command may come in between.
void UndoHistory::run(const std::function<void()>& change)
{
    const QScopedValueRollback changing(m_isChanging, true);
    change();
}

void UndoHistory::push(std::unique_ptr<DocumentCommand> command)
{
    if (m_isChanging) {
        qWarning("A command in the middle of another one is not done: \"%s\"", qPrintable(command->text()));
        return;
    }
    if (m_openSteps == 0 && m_heldGesture != 0 && !isHeld(command->gesture()))
        endGesture(true);
    run([&command] { command->swap(); });
    if (m_openSteps > 0)
        return addCommand(m_open, std::move(command));
    if (isHeld(command->gesture()))
        return addCommand(m_held, std::move(command));
    const GestureId gesture = command->gesture();
    const QString text = command->text();
    Commands alone;
    alone.push_back(std::move(command));
    pushStep(std::move(alone), gesture, text);
}

/// \pre the commands are done, and what was held is on the stack
void UndoHistory::pushStep(Commands commands, GestureId gesture, const QString& text)
{
    if (commands.empty())
        return;
    auto step = std::make_unique<UndoStep>(std::move(commands), gesture, text);
    const int tooMany = stepsTooMany(*step);
    forgetSteps(tooMany);
    m_stack.push(step.release());
    if (tooMany > 0 && !std::exchange(m_hasForgotten, true))
        emit stepsForgotten();
}

/// How many of the oldest steps must go to make room for one more. What can be redone goes anyway.
int UndoHistory::stepsTooMany(const UndoStep& next) const
{
    const auto step = [this](int i) { return static_cast<const UndoStep*>(m_stack.command(i)); };
    std::size_t most = next.mostBytes();
    for (int i = 0; i < m_stack.index(); ++i)
        most += step(i)->mostBytes();
    if (most <= m_memory)
        return 0;
    // Now exactly: what the scene has costs nothing, and what several steps share counts once.
    MemoryCount memory(true);
    for (const Node& node : m_scene.nodes())
        memory.add(node);
    const std::size_t allowed = memory.bytes() + m_memory;
    next.countMemory(memory);
    for (int i = m_stack.index(); i-- > 0;) {
        step(i)->countMemory(memory);
        if (memory.bytes() > allowed)
            return i + 1;
    }
    return 0;
}

/// QUndoStack drops its oldest steps by number only: so it is filled anew. The step that is pushed next tells
/// everybody.
void UndoHistory::forgetSteps(int count)
{
    if (count == 0)
        return;
    std::vector<std::unique_ptr<UndoStep>> left;
    for (int i = count; i < m_stack.index(); ++i)
        left.push_back(static_cast<UndoStep*>(const_cast<QUndoCommand*>(m_stack.command(i)))->moved());
    const int clean = m_stack.cleanIndex() - count;
    const QSignalBlocker quiet(m_stack);
    m_stack.clear();
    if (clean != 0)
        m_stack.resetClean();
    for (auto& step : left) {
        m_stack.push(step.release());
        if (m_stack.index() == clean)
            m_stack.setClean();
    }
}

void UndoHistory::beginStep(const QString& text)
{
    if (m_openSteps++ > 0)
        return;
    settle();
    m_openText = text;
}

void UndoHistory::endStep()
{
    if (--m_openSteps == 0)
        pushStep(std::exchange(m_open, {}), 0, m_openText);
}

// Gestures

void UndoHistory::hold(GestureId gesture)
{
    keep(m_heldGesture);
    m_heldGesture = gesture;
}

void UndoHistory::keep(GestureId gesture)
{
    if (!isHeld(gesture))
        return;
    m_heldGesture = 0;
    Commands held = std::exchange(m_held, {});
    if (held.empty()) // it ended where it began
        return;
    UndoStep* last = lastStep();
    if (last && last->awaits(gesture) && !m_stack.canRedo())
        return last->join(std::move(held));
    const QString text = held.back()->text();
    pushStep(std::move(held), gesture, text);
}

bool UndoHistory::giveUp(GestureId gesture)
{
    if (!isHeld(gesture))
        return false;
    m_heldGesture = 0;
    const Commands held = std::exchange(m_held, {});
    run([&held] {
        for (std::size_t i = held.size(); i-- > 0;)
            held[i]->swap();
    });
    return true;
}

/// Something else is to be done now. \return whether the gesture had changed anything
bool UndoHistory::endGesture(bool keeps)
{
    const bool hasChanged = !m_held.empty();
    if (keeps)
        keep(m_heldGesture);
    else
        giveUp(m_heldGesture);
    emit gestureEnded();
    return hasChanged;
}

void UndoHistory::settle()
{
    if (m_heldGesture != 0)
        endGesture(true);
}

void UndoHistory::drop()
{
    m_heldGesture = 0;
    m_held.clear();
    emit gestureEnded();
}

void UndoHistory::clear()
{
    m_stack.clear();
    m_hasForgotten = false;
}

void UndoHistory::undo()
{
    if (!m_isChanging && m_openSteps == 0 && !endGesture(false))
        run([this] { m_stack.undo(); });
}

void UndoHistory::redo()
{
    if (m_isChanging || m_openSteps > 0)
        return;
    endGesture(false);
    run([this] { m_stack.redo(); });
}

void UndoHistory::goToStep(int count)
{
    if (m_isChanging || m_openSteps > 0)
        return;
    endGesture(false);
    run([this, count] { m_stack.setIndex(count); });
}

} // namespace ramure

#include "moc_undo_history.cpp"
