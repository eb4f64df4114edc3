/// \file
/// Puts imported meshes on arms. Large ones are turned, fitted and checked on a thread of their own, and the
/// arm keeps its old mesh until that is done.
#pragma once

#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/job.h"
#include <QObject>
#include <memory>
#include <optional>

namespace ramure {

class ArmDresser : public QObject
{
    Q_OBJECT
public:
    /// Meshes with fewer vertices are put on at once, in about 2 ms.
    static constexpr Index fewVertices = 50'000;

    /// \p document is not owned and must outlive this object.
    explicit ArmDresser(Document* document, QObject* parent = nullptr);

    /// Puts a mesh on an arm like edit::wearMesh, as one undo step, and emits finished() afterwards. \param
    /// axis the axis of a fitted mesh, which becomes the arm's "armSkin.axis"; unset: the arm's value counts.
    /// Errors: those of edit::wearMesh as far as they are known at once; Invalid while another mesh is being
    /// put on.
    Expected<void> wear(NodeId arm, NodeId mesh, bool fitted, std::optional<MeshAxis> axis = {});
    /// Makes the mesh that an arm wears as long as the arm is now, its foot at the arm's; where the arm's
    /// "armSkin.axis" is the longest, that is turned along it. Errors: Unknown (node), Invalid (no arm,
    /// locked, it wears none, another mesh is being put on).
    Expected<void> fitAgain(NodeId arm);
    [[nodiscard]] Job* job() { return &m_job; }

signals:
    /// Without an error the arm wears the mesh. Errors: those of edit::wearMesh; Invalid if the arm or the
    /// mesh was changed meanwhile; Cancelled.
    void finished(const std::optional<ramure::Error>& error);

private:
    friend Expected<void> edit::wearMesh(Document& document, NodeId arm, NodeId mesh, bool fitted);
    struct Work;
    Expected<void> doOrBegin(const std::shared_ptr<Work>& work);

    Document* m_document;
    Job m_job;
};

} // namespace ramure
