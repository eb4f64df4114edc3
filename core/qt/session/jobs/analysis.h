/// \file
/// Analyses the meshes of a document's trees in the background: what crosses, what collides, how well shaped
/// the triangles are. The findings stand beside the results and are no part of the document: neither undo
/// nor "modified" knows of them.
#pragma once

#include "core/qt/document/document.h"
#include "core/surface/check/mesh_analysis.h"
#include <QObject>
#include <functional>
#include <memory>

namespace ramure {

/// Analyses the mesh of each tree some time after its full result has arrived, on a thread of the lowest
/// priority, one tree after the other. An edit that reshapes the tree drops the running analysis and its
/// findings. If an earlier mesh comes back, for example by undo, its findings are remembered.
class Analysis : public QObject
{
    Q_OBJECT
public:
    using Function = std::function<Expected<MeshAnalysis>(
        const BranchMesh& branches, const Skeleton& skeleton, const Progress& progress)>;
    enum class State {
        None,    ///< no full mesh to look at
        Waiting, ///< its turn has not come yet
        Running,
        Done,
        Cancelled, ///< until start() or another mesh
        Failed,    ///< see error()
    };

    /// \param document must outlive this object.
    explicit Analysis(Document* document, QObject* parent = nullptr);
    Analysis(Document* document, Function function, QObject* parent = nullptr); ///< for tests
    ~Analysis() override; ///< stops what runs and joins the thread

    [[nodiscard]] State state(NodeId tree) const;
    /// Findings for the mesh that the document shows now; null while there are none.
    [[nodiscard]] std::shared_ptr<const MeshAnalysis> findings(NodeId tree) const;
    /// The reason of State::Failed.
    [[nodiscard]] std::optional<Error> error(NodeId tree) const;
    [[nodiscard]] double fraction(NodeId tree) const; ///< progress of the running check, 0..1

    /// How long a result rests before it is looked at, default 250 ms.
    void setRest(int milliseconds);
    /// Blocks (with an event loop) until nothing runs or waits. False on time-out.
    bool waitForAll(int timeoutMs);

public slots:
    void cancel(ramure::NodeId tree);
    /// After a cancel or a failure, and for those who do not want to wait for the rest.
    void start(ramure::NodeId tree);

signals:
    void changed(ramure::NodeId tree); ///< its state or its findings changed
    void progress(ramure::NodeId tree, double fraction);

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace ramure
