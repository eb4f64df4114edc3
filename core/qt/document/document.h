/// \file
/// An open document: scene, selection, undo stack, results. Only commands change the scene; one pair of
/// signals tells everybody. Lives on the interface's thread; needs a QCoreApplication, no display.
///
/// A gesture that is held (holdGesture) has changed the scene, but is no step of undo yet. The document ends
/// it before it does anything else: it keeps the gesture before the command of somebody else, before a step
/// of several commands and before saving; it gives the gesture up before undo, redo and reset.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/change.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/document/selection.h"
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace ramure {

class DocumentCommand;
class UndoStep;

/// The outcome of the computation of one node. A failed one keeps the last good meshes beside the error.
struct NodeResult
{
    TreeResult tree;            ///< last good result, may be empty
    std::optional<Error> error; ///< why the present parameters give no tree
    bool draft = false;         ///< a cheap draft, its tree without mesh and report; the full result follows
    quint64 revision = 0;       ///< of the document when its parameters were taken
};

class Document : public QObject
{
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    [[nodiscard]] const Scene& scene() const { return m_scene; }
    [[nodiscard]] const Selection& selection() const { return m_selection; }
    [[nodiscard]] quint64 revision() const { return m_revision; }
    /// The steps of undo, to look at.
    [[nodiscard]] const QUndoStack* undoStack() const { return &m_undoStack; }
    /// Null where nothing was computed yet.
    [[nodiscard]] const NodeResult* result(NodeId id) const;
    /// The revision since which the tree of this node has its shape: results of an older one are stale. 0
    /// where there is no such node.
    [[nodiscard]] quint64 shapeRevision(NodeId id) const;
    /// Why the present parameters give no tree. Null where they give one, and as long as nobody knows.
    [[nodiscard]] const Error* problem(NodeId id) const;
    /// The full result, or the error, of the present parameters is there.
    [[nodiscard]] bool isCurrent(NodeId id) const;

    [[nodiscard]] QString filePath() const { return m_filePath; }
    [[nodiscard]] bool isModified() const { return !m_held.empty() || !m_undoStack.isClean(); }
    /// What saving writes.
    [[nodiscard]] Project project() const { return {m_scene, m_extras}; }
    void setFilePath(const QString& path);
    /// Replaces everything (New, Open): clears undo, selection and results; emits changeReset.
    void reset(Scene scene, const QString& path, std::string extras = {});
    /// What is open is nowhere on the disk, as after a recovery: modified, until saved.
    void markModified() { m_undoStack.resetClean(); }
    void markSaved() { m_undoStack.setClean(); }
    /// Not undoable. Unknown ids and out-of-range branches are dropped. Silent where nothing changes.
    void setSelection(Selection selection);
    /// From the recompute object only. Ignored where there is no such node. Selected branches stay selected
    /// by their keys where the skeleton is another one.
    void setResult(NodeId id, NodeResult result);
    /// For commands that insert nodes.
    NodeId newNodeId() { return m_scene.newId(); }

    /// There is a step to take back, or a gesture to give up.
    [[nodiscard]] bool canUndo() const { return m_heldGesture != 0 || m_undoStack.canUndo(); }
    /// Gives up the gesture that is held. Where that changes nothing, takes the last step back.
    void undo();
    /// Gives up the gesture that is held and makes the next step again.
    void redo();
    /// Gives up the gesture that is held and goes to the state after so many steps.
    void goToStep(int count);

    /// Edits of this gesture are made at once, but become a step of undo, all of them one, only when they are
    /// kept: until then what could be redone can be redone. One gesture at a time: one that is held already
    /// is kept. A gesture that the document has ended (gestureEnded) is not held any more: edits that name it
    /// are steps of their own.
    void holdGesture(quint64 gesture);
    [[nodiscard]] bool isHeld(quint64 gesture) const { return gesture != 0 && gesture == m_heldGesture; }
    [[nodiscard]] bool isHolding() const { return m_heldGesture != 0; } ///< any gesture
    /// Makes the gesture a step of undo. Does nothing where it is not held.
    void keepGesture(quint64 gesture);
    /// Brings everything back to the last bit. \returns false where the gesture is not held
    bool giveUpGesture(quint64 gesture);
    /// Keeps whatever gesture is held: before saving, or asking whether to save.
    void settleGesture();
    /// When \p gesture, which is held, is kept, it does not become a step of its own: the step that is the
    /// last one now takes it in. Where the file was saved meanwhile, it is a step of its own.
    void joinToLastStep(quint64 gesture);
    /// For commands: does it, and puts it on the undo stack, or to the gesture that is held. A command in the
    /// middle of another one (in an answer to changed(), say) is refused with a warning: it would get onto
    /// the stack before that one.
    void push(std::unique_ptr<DocumentCommand> command);
    /// See OneStep (commands.h).
    void beginStep(const QString& text);
    void endStep();
    /// The oldest steps are forgotten where all of them together hold more memory than this.
    void setUndoMemory(std::size_t bytes) { m_undoMemory = bytes; }
    static constexpr std::size_t usualUndoMemory = std::size_t(1) << 30;

    /// The way for commands, and for them only: \p edit changes the scene between the two signals.
    template <class Edit> void applyChange(Change change, Edit&& edit)
    {
        change.revision = ++m_revision;
        emit aboutToBeChanged(change);
        edit(m_scene);
        settle(change);
        emit changed(change);
        followSolids();
    }

signals:
    void aboutToBeChanged(const ramure::Change& change);
    void changed(const ramure::Change& change);
    /// The document has ended whatever a hand was doing, see above. A tool or panel that is in the middle of
    /// something stops: the rest of its drag does nothing.
    void gestureEnded();
    /// The oldest steps of undo are gone, see setUndoMemory. Once until the next reset().
    void stepsForgotten();

private:
    using Commands = std::vector<std::unique_ptr<DocumentCommand>>;

    void settle(const Change& change);
    void followSolids();
    void dropGone();
    [[nodiscard]] Selection valid(Selection selection) const;
    [[nodiscard]] Selection followed(const TreeResult& before, const TreeResult& after) const;
    void tell(const Change& change, const std::function<void()>& edit);
    bool endGesture(bool keep);
    void run(const std::function<void()>& change);
    void pushStep(Commands commands, quint64 gesture, const QString& text);
    [[nodiscard]] int stepsTooMany(const UndoStep& next) const;
    void forgetSteps(int count);
    [[nodiscard]] UndoStep* lastStep();

    Scene m_scene;
    Selection m_selection;
    std::map<NodeId, NodeResult> m_results;
    std::map<NodeId, quint64> m_shapeRevisions;
    QUndoStack m_undoStack;
    QString m_filePath;
    std::string m_extras; ///< of the project file, see Project
    quint64 m_revision = 0;
    std::size_t m_undoMemory = usualUndoMemory;
    bool m_hasForgotten = false; ///< since the last reset
    quint64 m_heldGesture = 0;
    Commands m_held;     ///< what it has done so far
    int m_openSteps = 0; ///< beginStep() without endStep()
    QString m_openText;
    Commands m_open;           ///< what was done since beginStep()
    bool m_isChanging = false; ///< a command is being done, undone or redone
};

} // namespace ramure
