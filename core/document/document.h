/// \file
/// An open document: scene, selection, undo stack, results. Only commands change the scene; one pair of
/// signals tells everybody. Lives on the interface's thread; needs a QCoreApplication, no display.
#pragma once

#include "core/document/change.h"
#include "core/document/selection.h"
#include "core/pipeline/tree_pipeline.h"
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>

namespace ramure {

/// The outcome of the computation of one node. A failed one keeps the last good meshes beside the error.
struct NodeResult
{
    TreeResult tree;            ///< last good result, may be empty
    std::optional<Error> error; ///< why the present parameters give no tree
    bool draft = false;         ///< a cheap draft; the full result follows
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
    [[nodiscard]] QUndoStack* undoStack() { return &m_undoStack; }
    [[nodiscard]] const QUndoStack* undoStack() const { return &m_undoStack; }
    /// Null where nothing was computed yet.
    [[nodiscard]] const NodeResult* result(NodeId id) const;

    [[nodiscard]] QString filePath() const { return m_filePath; }
    [[nodiscard]] bool isModified() const { return !m_undoStack.isClean(); }
    void setFilePath(const QString& path);
    /// Replaces everything (New, Open): clears undo, selection and results; emits changeReset.
    void reset(Scene scene, const QString& path);
    /// Not undoable. Unknown ids and out-of-range branches are dropped.
    void setSelection(Selection selection);
    /// From the recompute object only.
    void setResult(NodeId id, NodeResult result);

    /// The way for commands, and for them only: \p edit changes the scene between the two signals.
    template <class Edit> void applyChange(Change change, Edit&& edit)
    {
        change.revision = ++m_revision;
        emit aboutToBeChanged(change);
        edit(m_scene);
        dropStale();
        emit changed(change);
    }

signals:
    void aboutToBeChanged(const ramure::Change& change);
    void changed(const ramure::Change& change);

private:
    void dropStale(); ///< selection and results of nodes that are gone

    Scene m_scene;
    Selection m_selection;
    std::map<NodeId, NodeResult> m_results;
    QUndoStack m_undoStack;
    QString m_filePath;
    quint64 m_revision = 0;
};

} // namespace ramure
