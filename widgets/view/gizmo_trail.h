/// \file
/// The paths of the selected nodes through the world, and their ghosts: translucent copies where they were
/// and will be. Paths are computed on a thread of their own; ghosts are places of meshes that are there
/// already.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/qt/session/jobs/job.h"
#include "core/scene/motion_path.h"
#include "widgets/view/arm_ghosts.h"
#include "widgets/view/render/pick/pick_scene.h"
#include "widgets/view/tools/gizmo_settings.h"
#include <QObject>
#include <functional>
#include <map>

class QPainter;

namespace ramure {

class GizmoTrail : public QObject
{
    Q_OBJECT
public:
    static constexpr std::size_t mostPaths = 64;    ///< of the nodes selected last
    static constexpr std::size_t mostCopies = 1500; ///< nodes times ghosts
    static constexpr std::size_t mostTwigs = 3000;  ///< lines of a tree's ghost: its thickest branches

    using TreeOf = std::function<const TreeResult*(NodeId)>;

    explicit GizmoTrail(QObject* parent = nullptr);
    ~GizmoTrail() override;

    /// What is to be shown from now on: computes only where something differs.
    /// \param still nothing plays: ghosts are shown
    void show(const Scene& scene, const std::vector<NodeId>& nodes, const GizmoSettings& how,
              std::int64_t frame, bool still);
    /// Adds paths and ghosts to a scene that is drawn. \p trees: as they are shown.
    void addTo(RenderScene& scene, const TreeOf& trees);
    /// Skeletons are others than before.
    void forgetSkeletons();
    /// Marks where the nodes are on their paths.
    void paintPlayhead(QPainter& painter, const PickView& view, double seconds) const;

    [[nodiscard]] bool isEmpty() const
    {
        return m_lines.empty() && m_ghosts.empty() && m_arms.count() == 0 && !m_arms.isBusy();
    }
    [[nodiscard]] quint64 revision() const { return m_revision; } ///< of what addTo adds
    /// Paths or ghosts of arms are being computed.
    [[nodiscard]] bool isBusy() const { return m_work.isRunning() || m_arms.isBusy(); }
    [[nodiscard]] const std::vector<std::shared_ptr<const MotionPath>>& paths() const { return m_paths; }
    /// How many copies there are of all nodes together.
    [[nodiscard]] std::size_t ghostCount() const { return m_ghosts.size() + m_arms.count(); }

signals:
    void changed();

private:
    struct Ghost
    {
        NodeId node = noNode;
        glm::dmat4 geometry{1.0};
        glm::u8vec4 colour{255};
    };
    struct Made
    {
        std::vector<std::shared_ptr<const MotionPath>> paths;
        std::vector<std::shared_ptr<const LineSet>> lines;
        std::vector<std::shared_ptr<const PointSet>> points;
    };
    static Made made(const std::vector<MotionChain>& chains, const TimelineSettings& timeline,
                     const Progress& progress);
    void showPaths(const Scene& scene, const std::vector<NodeId>& nodes, bool on);
    void showGhosts(const Scene& scene, const std::vector<NodeId>& nodes, const GhostFrames& frames,
                    std::int64_t frame);
    void clearPaths();
    std::shared_ptr<const LineSet> twigs(const std::shared_ptr<const SimplifiedSkeleton>& of,
                                         const glm::u8vec4& colour);

    std::vector<MotionChain> m_chains;
    TimelineSettings m_timeline;
    std::vector<std::shared_ptr<const MotionPath>> m_paths;
    std::vector<std::shared_ptr<const LineSet>> m_lines;
    std::vector<std::shared_ptr<const PointSet>> m_points;
    std::vector<Ghost> m_ghosts;
    ArmGhostMaker m_arms;
    /// Lines of a skeleton in one colour; those that were not asked for last time go.
    struct Twigs
    {
        std::shared_ptr<const SimplifiedSkeleton> of;
        glm::u8vec4 colour{0};
        std::shared_ptr<const LineSet> lines;
        bool used = false;
    };
    std::vector<Twigs> m_twigs;
    quint64 m_revision = 0;
    Job m_work{nullptr, Job::Manner::Polite};
};

} // namespace ramure
