#include "core/qt/document/undo_step.h"

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
    if (edit.frozen)
        addShared(edit.frozen.pointer().get(), edit.frozen->bytes.size());
}

void MemoryCount::add(const Node& node)
{
    m_bytes += sizeof(node) + node.extras.capacity();
    for (const TreeEdit& edit : node.params.edits)
        add(edit);
    add(node.animation);
    add(node.mesh);
}

} // namespace ramure
