/// \file
/// An open document: scene, selection, undo stack, results. Only commands change the scene; one pair of
/// signals tells everybody. Lives on the interface's thread; needs a QCoreApplication, no display.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/change.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/document/selection.h"
#include "core/qt/document/undo_history.h"
#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace ramure {

/// The outcome of the computation of one node. A failed one keeps the last good meshes beside the error.
struct NodeResult
{
    TreeResult tree;            ///< last good result, may be empty
    std::optional<Error> error; ///< why the present parameters give no tree
    bool draft = false;         ///< a cheap draft, its tree without mesh and report; the full result follows
    quint64 revision = 0;       ///< revision of the document when the parameters were taken
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
    [[nodiscard]] UndoHistory& history() { return m_history; }
    /// The steps of undo, to look at.
    [[nodiscard]] const QUndoStack* undoStack() const { return m_history.stack(); }
    /// Null where nothing was computed yet.
    [[nodiscard]] const NodeResult* result(NodeId id) const;
    /// The revision since which the tree of this node has its shape: results of an older one are stale. 0
    /// where there is no such node.
    [[nodiscard]] quint64 shapeRevision(NodeId id) const;
    /// Returns why the present parameters give no tree. Null if they give one, or if this is not known yet.
    [[nodiscard]] const Error* problem(NodeId id) const;
    /// The full result, or the error, of the present parameters is there.
    [[nodiscard]] bool isCurrent(NodeId id) const;

    [[nodiscard]] QString filePath() const { return m_filePath; }
    [[nodiscard]] bool isModified() const { return !m_history.isClean(); }
    /// The data that saving writes.
    [[nodiscard]] Project project() const { return {m_scene, m_extras}; }
    void setFilePath(const QString& path);
    /// Replaces everything (New, Open): clears undo, selection and results; emits changeReset.
    void reset(Scene scene, const QString& path, std::string extras = {});
    /// Marks the document as modified until it is saved: it exists nowhere on the disk, as after a recovery.
    void markModified() { m_history.resetClean(); }
    void markSaved() { m_history.setClean(); }
    /// Not undoable. Unknown ids and out-of-range branches are dropped. Silent where nothing changes.
    void setSelection(Selection selection);
    /// From the recompute object only. Ignored where there is no such node. Selected branches stay selected
    /// by their keys where the skeleton is another one.
    void setResult(NodeId id, NodeResult result);
    /// For commands that insert nodes.
    NodeId newNodeId() { return m_scene.newId(); }

    // See UndoHistory.
    void undo() { m_history.undo(); }
    void redo() { m_history.redo(); }
    void holdGesture(GestureId gesture) { m_history.hold(gesture); }
    void keepGesture(GestureId gesture) { m_history.keep(gesture); }
    bool giveUpGesture(GestureId gesture) { return m_history.giveUp(gesture); }
    void push(std::unique_ptr<DocumentCommand> command);

    /// The way for commands, and for them only: \p edit changes the scene between the two signals.
    template <class Edit> void applyChange(Change change, Edit&& edit)
    {
        change.revision = ++m_revision;
        emit aboutToBeChanged(change);
        edit(m_scene);
        settle(change);
        emit changed(change);
        followSolids(change);
    }

signals:
    void aboutToBeChanged(const ramure::Change& change);
    void changed(const ramure::Change& change);

private:
    void settle(const Change& change);
    void followSolids(const Change& edit);
    void dropGone();
    [[nodiscard]] Selection valid(Selection selection) const;
    [[nodiscard]] Selection followed(const TreeResult& before, const TreeResult& after) const;
    void tell(const Change& change, const std::function<void()>& edit);

    Scene m_scene;
    Selection m_selection;
    std::map<NodeId, NodeResult> m_results;
    std::map<NodeId, quint64> m_shapeRevisions;
    UndoHistory m_history;
    QString m_filePath;
    std::string m_extras; ///< unknown data of the project file, see Project
    quint64 m_revision = 0;
};

} // namespace ramure
