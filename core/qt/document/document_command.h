/// \file
/// Parts that the commands share. For the command families of this folder only; everybody else uses
/// commands.h.
#pragma once

#include "core/qt/document/commands.h"

#include <QCoreApplication>
#include <algorithm>
#include <memory>
#include <unordered_set>
#include <utility>

namespace ramure {

/// Adds up the memory that steps of undo hold.
class MemoryCount
{
public:
    /// \param sharedOnce data that several steps share counts once; else each time, which is quicker
    explicit MemoryCount(bool sharedOnce)
        : m_sharedOnce(sharedOnce)
    {
    }
    void add(std::size_t bytes) { m_bytes += bytes; }
    void add(const SharedValue<TriangleMesh>& mesh);
    void add(const NodeAnimation::TrackPtr& track);
    void add(const NodeAnimation& animation);
    void add(const TreeEdit& edit);
    void add(const Node& node);
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    void addShared(const void* data, std::size_t bytes);

    bool m_sharedOnce;
    std::unordered_set<const void*> m_seen;
    std::size_t m_bytes = 0;
};

/// One change of a document. Undo and redo are the same: swap() exchanges the command's data with the
/// scene's.
class DocumentCommand
{
    Q_DECLARE_TR_FUNCTIONS(DocumentCommand)
public:
    DocumentCommand(Document& document, GestureId gesture, QString text)
        : m_document(document)
        , m_gesture(gesture)
        , m_text(std::move(text))
    {
    }
    virtual ~DocumentCommand() = default;
    DocumentCommand(const DocumentCommand&) = delete;
    DocumentCommand& operator=(const DocumentCommand&) = delete;

    [[nodiscard]] GestureId gesture() const { return m_gesture; }
    [[nodiscard]] const QString& text() const { return m_text; }
    virtual void swap() = 0;
    /// Takes in a command of the same gesture. \pre both are done, \p next after this one
    virtual bool mergeWith(const DocumentCommand& /*next*/) { return false; }
    /// It has ended where it began, and may be forgotten.
    [[nodiscard]] bool isObsolete() const { return m_isObsolete; }
    virtual void countMemory(MemoryCount& memory) const = 0;

protected:
    [[nodiscard]] Document& document() const { return m_document; }
    void setText(const QString& text) { m_text = text; }
    void setObsolete(bool obsolete) { m_isObsolete = obsolete; }

private:
    Document& m_document;
    GestureId m_gesture;
    QString m_text;
    bool m_isObsolete = false;
};

/// Sets any values. A Target names one value of the scene:
///     using Value; NodeId node; bool operator==;
///     Value get(const Node&) const; void set(Node&, Value) const; void describe(Change&) const;
/// and, where values hold memory of their own, static void count(MemoryCount&, const Value&);
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
        : DocumentCommand(document, gesture, text)
        , m_entries(std::move(entries))
    {
    }
    bool mergeWith(const DocumentCommand& other) override
    {
        const auto* next = dynamic_cast<const SetCommand*>(&other);
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
    void countMemory(MemoryCount& memory) const override
    {
        memory.add(sizeof(*this) + m_entries.size() * sizeof(Entry));
        if constexpr (requires(const Entry& entry) { Target::count(memory, entry.value); })
            for (const Entry& entry : m_entries)
                Target::count(memory, entry.value);
    }

private:
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

/// Adds the item unless the list has it already.
template <class T> void addOnce(std::vector<T>& list, const T& item)
{
    if (std::find(list.begin(), list.end(), item) == list.end())
        list.push_back(item);
}

/// Errors: Unknown, Invalid (locked).
Expected<void> checkEditable(const Scene& scene, NodeId id);
/// Returns an arm that may be changed. Errors: those of checkEditable; Invalid (no arm).
Expected<const Node*> editableArm(const Scene& scene, NodeId id);
/// Returns the nodes, each once. Errors: those of checkEditable.
Expected<std::vector<NodeId>> editable(const Scene& scene, const std::vector<NodeId>& ids);
tl::unexpected<Error> unknownNode(NodeId id);

} // namespace ramure
