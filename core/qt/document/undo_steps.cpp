// The steps of undo: how commands and gestures become steps, and how the oldest of them go.
#include "core/qt/document/undo_step.h"

#include <QScopedValueRollback>
#include <QSignalBlocker>

namespace ramure {

// Steps

void addCommand(UndoStep::Commands& commands, std::unique_ptr<DocumentCommand> next)
{
    const bool merges =
        !commands.empty() && next->gesture() != 0 && commands.back()->mergeWith(std::as_const(*next));
    if (!merges)
        commands.push_back(std::move(next));
    else if (commands.back()->isObsolete())
        commands.pop_back();
}

UndoStep::UndoStep(Commands commands, GestureId gesture, const QString& text)
    : QUndoCommand(text)
    , m_commands(std::move(commands))
    , m_gesture(gesture)
{
    measure();
}

void UndoStep::undo()
{
    for (std::size_t i = m_commands.size(); i-- > 0;)
        m_commands[i]->swap();
}

void UndoStep::redo()
{
    if (std::exchange(m_isDone, false))
        return;
    for (const auto& command : m_commands)
        command->swap();
}

bool UndoStep::mergeWith(const QUndoCommand* other)
{
    const auto& next = static_cast<const UndoStep&>(*other);
    if (next.m_gesture != m_gesture || next.m_commands.size() != 1 ||
        !m_commands.back()->mergeWith(*next.m_commands.front()))
        return false;
    if (m_commands.back()->isObsolete())
        m_commands.pop_back();
    setObsolete(m_commands.empty());
    setText(next.text()); // it may name the value
    measure();
    return true;
}

void UndoStep::join(Commands next)
{
    std::ranges::move(next, std::back_inserter(m_commands));
    m_awaited = 0;
    measure();
}

void UndoStep::countMemory(MemoryCount& memory) const
{
    for (const auto& command : m_commands)
        command->countMemory(memory);
}

void UndoStep::measure()
{
    MemoryCount memory(false);
    countMemory(memory);
    m_mostBytes = memory.bytes();
}

std::unique_ptr<UndoStep> UndoStep::moved()
{
    return std::make_unique<UndoStep>(std::exchange(m_commands, {}), 0, text());
}

// Memory

void MemoryCount::addShared(const void* data, std::size_t bytes)
{
    if (!m_sharedOnce || m_seen.insert(data).second)
        m_bytes += bytes;
}

void MemoryCount::add(const SharedValue<TriangleMesh>& mesh)
{
    if (mesh)
        addShared(mesh.pointer().get(), bytesOf(*mesh));
}

void MemoryCount::add(const NodeAnimation::TrackPtr& track)
{
    const auto addPage = [this](const void* page, std::size_t bytes) { addShared(page, bytes); };
    if (track)
        std::visit([&addPage](const auto& keyed) { keyed.keys().eachPage(addPage); }, *track);
}

void MemoryCount::add(const NodeAnimation& animation)
{
    for (const auto& [channel, track] : animation.tracks())
        add(track);
}

void MemoryCount::add(const TreeEdit& edit)
{
    m_bytes += sizeof(edit) + edit.points.size() * sizeof(StrokePoint) +
               edit.shape.points.size() * sizeof(glm::dvec3) +
               edit.shape.triangles.size() * sizeof(edit.shape.triangles[0]) +
               edit.limb.size() * sizeof(LimbPiece);
}

void MemoryCount::add(const Node& node)
{
    m_bytes += sizeof(node) + node.extras.capacity() + node.params.branches.size() * sizeof(BranchParams);
    for (const TreeEdit& edit : node.params.edits)
        add(edit);
    add(node.animation);
    add(node.mesh);
}

// The document

/// The last step that can be undone; null where it must not change any more: a saved one.
UndoStep* Document::lastStep()
{
    if (!m_undoStack.canUndo() || m_undoStack.isClean())
        return nullptr;
    return static_cast<UndoStep*>(const_cast<QUndoCommand*>(m_undoStack.command(m_undoStack.index() - 1)));
}

void Document::joinToLastStep(quint64 gesture)
{
    if (UndoStep* last = isHeld(gesture) ? lastStep() : nullptr)
        last->awaitGesture(gesture);
}

/// Does what changes the scene by commands; no other command may come in between.
void Document::run(const std::function<void()>& change)
{
    const QScopedValueRollback changing(m_isChanging, true);
    change();
}

void Document::push(std::unique_ptr<DocumentCommand> command)
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
void Document::pushStep(Commands commands, quint64 gesture, const QString& text)
{
    if (commands.empty())
        return;
    auto step = std::make_unique<UndoStep>(std::move(commands), gesture, text);
    const int tooMany = stepsTooMany(*step);
    forgetSteps(tooMany);
    m_undoStack.push(step.release());
    if (tooMany > 0 && !std::exchange(m_hasForgotten, true))
        emit stepsForgotten();
}

/// How many of the oldest steps must go to make room for one more. What can be redone goes anyway.
int Document::stepsTooMany(const UndoStep& next) const
{
    const auto step = [this](int i) { return static_cast<const UndoStep*>(m_undoStack.command(i)); };
    std::size_t most = next.mostBytes();
    for (int i = 0; i < m_undoStack.index(); ++i)
        most += step(i)->mostBytes();
    if (most <= m_undoMemory)
        return 0;
    // Now exactly: what the scene has costs nothing, and what several steps share counts once.
    MemoryCount memory(true);
    for (const Node& node : m_scene.nodes())
        memory.add(node);
    const std::size_t allowed = memory.bytes() + m_undoMemory;
    next.countMemory(memory);
    for (int i = m_undoStack.index(); i-- > 0;) {
        step(i)->countMemory(memory);
        if (memory.bytes() > allowed)
            return i + 1;
    }
    return 0;
}

/// QUndoStack drops its oldest steps by number only: so it is filled anew. The step that is pushed next tells
/// everybody.
void Document::forgetSteps(int count)
{
    if (count == 0)
        return;
    std::vector<std::unique_ptr<UndoStep>> left;
    for (int i = count; i < m_undoStack.index(); ++i)
        left.push_back(static_cast<UndoStep*>(const_cast<QUndoCommand*>(m_undoStack.command(i)))->moved());
    const int clean = m_undoStack.cleanIndex() - count;
    const QSignalBlocker quiet(m_undoStack);
    m_undoStack.clear();
    if (clean != 0)
        m_undoStack.resetClean();
    for (auto& step : left) {
        m_undoStack.push(step.release());
        if (m_undoStack.index() == clean)
            m_undoStack.setClean();
    }
}

void Document::beginStep(const QString& text)
{
    if (m_openSteps++ > 0)
        return;
    settleGesture();
    m_openText = text;
}

void Document::endStep()
{
    if (--m_openSteps == 0)
        pushStep(std::exchange(m_open, {}), 0, m_openText);
}

// Gestures

void Document::holdGesture(quint64 gesture)
{
    keepGesture(m_heldGesture);
    m_heldGesture = gesture;
}

void Document::keepGesture(quint64 gesture)
{
    if (!isHeld(gesture))
        return;
    m_heldGesture = 0;
    Commands held = std::exchange(m_held, {});
    if (held.empty()) // it ended where it began
        return;
    UndoStep* last = lastStep();
    if (last && last->awaits(gesture) && !m_undoStack.canRedo())
        return last->join(std::move(held));
    const QString text = held.back()->text();
    pushStep(std::move(held), gesture, text);
}

bool Document::giveUpGesture(quint64 gesture)
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
bool Document::endGesture(bool keep)
{
    const bool hasChanged = !m_held.empty();
    if (keep)
        keepGesture(m_heldGesture);
    else
        giveUpGesture(m_heldGesture);
    emit gestureEnded();
    return hasChanged;
}

void Document::settleGesture()
{
    if (m_heldGesture != 0)
        endGesture(true);
}

void Document::undo()
{
    if (!m_isChanging && m_openSteps == 0 && !endGesture(false))
        run([this] { m_undoStack.undo(); });
}

void Document::redo()
{
    if (m_isChanging || m_openSteps > 0)
        return;
    endGesture(false);
    run([this] { m_undoStack.redo(); });
}

void Document::goToStep(int count)
{
    if (m_isChanging || m_openSteps > 0)
        return;
    endGesture(false);
    run([this, count] { m_undoStack.setIndex(count); });
}

} // namespace ramure
