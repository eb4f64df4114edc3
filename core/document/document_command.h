/// \file
/// What the commands share. For the command families of this folder only; everybody else uses commands.h.
#pragma once

#include "core/document/commands.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <algorithm>
#include <memory>
#include <utility>

namespace ramure {

/// Undo and redo are the same: what the command holds and what the scene holds are swapped.
class DocumentCommand : public QUndoCommand
{
    Q_DECLARE_TR_FUNCTIONS(DocumentCommand)
public:
    DocumentCommand(Document& document, CommandId id, GestureId gesture, const QString& text)
        : QUndoCommand(text)
        , m_document(document)
        , m_id(id)
        , m_gesture(gesture)
    {
    }
    [[nodiscard]] int id() const override { return m_gesture == 0 ? -1 : static_cast<int>(m_id); }
    [[nodiscard]] CommandId commandId() const { return m_id; }
    [[nodiscard]] GestureId gesture() const { return m_gesture; }
    void undo() final
    {
        for (std::size_t i = m_joined.size(); i-- > 0;)
            m_joined[i]->undo();
        swap();
    }
    void redo() final
    {
        if (!std::exchange(m_isDone, false))
            swap();
        for (const auto& next : m_joined)
            next->redo();
    }
    /// The scene is as after redo() already: the next one does nothing.
    void setDone() { m_isDone = true; }
    /// What is done by this gesture later is part of this command, see joinToLastStep.
    void awaitGesture(GestureId gesture) { m_awaited = gesture; }
    [[nodiscard]] bool awaits(GestureId gesture) const { return gesture != 0 && gesture == m_awaited; }
    /// \pre the scene is as after both
    void join(std::unique_ptr<DocumentCommand> next)
    {
        next->m_isDone = false;
        m_joined.push_back(std::move(next));
        m_awaited = 0;
    }

protected:
    virtual void swap() = 0;
    [[nodiscard]] Document& document() const { return m_document; }

private:
    Document& m_document;
    CommandId m_id;
    GestureId m_gesture;
    bool m_isDone = false;
    GestureId m_awaited = 0;
    std::vector<std::unique_ptr<DocumentCommand>> m_joined; ///< done after this one
};

/// Sets any values. A Target names one value of the scene:
///     using Value; static constexpr CommandId id; NodeId node; bool operator==;
///     Value get(const Node&) const; void set(Node&, Value) const; void describe(Change&) const;
template <class Target> class SetCommand final : public DocumentCommand
{
public:
    struct Entry
    {
        Target target;
        typename Target::Value value;
    };

    /// \p entries: each target once, with the value that it gets.
    SetCommand(Document& document, std::vector<Entry> entries, GestureId gesture, const QString& text)
        : DocumentCommand(document, Target::id, gesture, text)
        , m_entries(std::move(entries))
    {
    }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = dynamic_cast<const SetCommand*>(other);
        const auto sameTarget = [](const Entry& a, const Entry& b) { return a.target == b.target; };
        if (!next || next->gesture() != gesture() ||
            !std::equal(m_entries.begin(), m_entries.end(), next->m_entries.begin(), next->m_entries.end(),
                        sameTarget))
            return false;
        // The scene has the other's values already, and this one has those from before both: nothing to take
        // over.
        setObsolete(!changesAnything(document().scene(), m_entries));
        setText(next->text()); // it may name the value
        return true;
    }
    static bool changesAnything(const Scene& scene, const std::vector<Entry>& entries)
    {
        return std::any_of(entries.begin(), entries.end(), [&scene](const Entry& entry) {
            const Node* node = scene.find(entry.target.node);
            return node && entry.target.get(*node) != entry.value;
        });
    }

private:
    void swap() override
    {
        Change change;
        for (const Entry& entry : m_entries)
            entry.target.describe(change);
        document().applyChange(change, [this](Scene& scene) {
            for (Entry& entry : m_entries)
                if (Node* node = scene.find(entry.target.node)) {
                    typename Target::Value before = entry.target.get(*node);
                    entry.target.set(*node, std::move(entry.value));
                    entry.value = std::move(before);
                }
        });
    }

    std::vector<Entry> m_entries;
};

/// Pushes unless nothing would change.
template <class Target>
void pushSet(Document& document, std::vector<typename SetCommand<Target>::Entry> entries, const QString& text,
             GestureId gesture = 0)
{
    if (SetCommand<Target>::changesAnything(document.scene(), entries))
        document.push(std::make_unique<SetCommand<Target>>(document, std::move(entries), gesture, text));
}

/// Adds what is not there yet.
template <class T> void addOnce(std::vector<T>& list, const T& item)
{
    if (std::find(list.begin(), list.end(), item) == list.end())
        list.push_back(item);
}

/// Errors: Unknown, Invalid (locked).
Expected<void> checkEditable(const Scene& scene, NodeId id);
/// An arm that may be changed. Errors: those of checkEditable; Invalid (no arm).
Expected<const Node*> editableArm(const Scene& scene, NodeId id);
/// The nodes, each once. Errors: those of checkEditable.
Expected<std::vector<NodeId>> editable(const Scene& scene, const std::vector<NodeId>& ids);
tl::unexpected<Error> unknownNode(NodeId id);

} // namespace ramure
