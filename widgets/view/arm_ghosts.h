/// \file
/// The ghosts of arms: their segments as they stood and will stand, with what their tracks and their inverse
/// kinematics make of the joints by then. Computed on a thread of its own: an arm that follows its target has
/// to be followed there.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/render_scene.h"
#include <QObject>
#include <memory>
#include <vector>

namespace ramure {

/// One arm, and when and where copies of it are wanted.
struct ArmGhosts
{
    struct Copy
    {
        double seconds = 0.0;
        glm::dmat4 geometry{1.0}; ///< of the node then
        glm::u8vec4 colour{255};
        bool operator==(const Copy&) const = default;
    };
    Node arm;
    double now = 0.0; ///< s; copies that stand as the arm does now are left out
    glm::dmat4 geometryNow{1.0};
    std::vector<Copy> copies; ///< drawn in this order

    bool operator==(const ArmGhosts& other) const;
};

class ArmGhostMaker : public QObject
{
    Q_OBJECT
public:
    explicit ArmGhostMaker(QObject* parent = nullptr);
    ~ArmGhostMaker() override;

    /// What is to be shown from now on; those from before stay until these are there.
    void show(std::vector<ArmGhosts> wanted);
    [[nodiscard]] std::size_t count() const { return m_made.size(); }
    [[nodiscard]] bool isBusy() const { return m_work.isRunning(); }
    void addTo(RenderScene& scene) const;
    /// Two placements are the same but for rounding.
    static bool isNear(const glm::dmat4& a, const glm::dmat4& b);

signals:
    void changed();

private:
    struct Made
    {
        std::shared_ptr<const LineSet> lines;
        std::shared_ptr<const PointSet> joints;
        glm::dmat4 place{1.0};
    };
    static std::vector<Made> made(const std::vector<ArmGhosts>& wanted, Evaluator& arms,
                                  const Progress& progress);

    std::vector<ArmGhosts> m_wanted;
    std::vector<Made> m_made;
    std::shared_ptr<Evaluator> m_arms; ///< of the thread
    Job m_work{nullptr, Job::Manner::Polite};
};

} // namespace ramure
