/// \file
/// A run of tree physics that can be entered anywhere (ANIMATION 4.9): fixed steps, checkpoints, and the last
/// states in full. Straight play and any order of seeks give the same bits.
///
/// What steers the run (parameters, the hand, apples shaken off) is a list of changes, each from a step on. A
/// state is kept under a hash of the body and of all changes before it: an edit at step s makes stale only
/// what comes after s, and taking the edit back makes it good again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/physics/tree_physics.h"
#include "core/pose/driver.h"
#include <deque>
#include <map>

namespace ramure {

enum class StepState : std::uint8_t {
    Missing, ///< was never computed
    Stale,   ///< was computed for other parameters
    Cached,  ///< at most a few steps away from a state that is kept
};

/// Steps first .. last, both included, all in one state.
struct StepRange
{
    std::int64_t first = 0, last = 0;
    StepState state = StepState::Missing;
    bool operator==(const StepRange&) const = default;
};

struct PhysicsCacheOptions
{
    int checkpointSteps = 10; ///< at first; doubled whenever the memory is used up
    int ringStates = 64;      ///< the last states, for single steps back; fewer where memory is short
    std::size_t memoryBytes = std::size_t(512)
                              << 20; ///< for checkpoints and ring; at least one state each is kept
};

class PhysicsCache final : public PoseDriver
{
public:
    PhysicsCache(std::shared_ptr<const TreeBody> body, const PhysicsParams& params,
                 const PhysicsCacheOptions& options = {});
    ~PhysicsCache() override;

    [[nodiscard]] const TreePhysics& physics() const { return m_physics; }
    [[nodiscard]] const PhysicsState& state() const { return m_state; } ///< at the present step
    [[nodiscard]] std::int64_t step() const { return m_state.step; }
    /// Those at the present step.
    [[nodiscard]] const PhysicsParams& params() const { return m_physics.params(); }

    /// To step \p step, at most maxPhysicsSteps. Errors: Invalid (negative or too large), Cancelled: then the
    /// present step is one on the way and what was computed is kept.
    Expected<void> seek(std::int64_t step, const Progress& progress = {});
    /// The step at a time: round(T / step), with the step lengths that the run has (SPEC A7).
    [[nodiscard]] std::int64_t stepAt(double timeSeconds) const;
    [[nodiscard]] double timeAt(std::int64_t step) const;

    [[nodiscard]] std::size_t boneCount() const override;
    Expected<void> poseAt(double timeSeconds, Pose& out, const Progress& progress) override;
    /// Pose of the present step.
    void pose(Pose& out) const { m_physics.pose(m_state, out); }

    /// Another tree: everything is forgotten.
    void setBody(std::shared_ptr<const TreeBody> body);
    /// New parameters for all steps from state \p fromStep on; later changes of parameters are forgotten,
    /// those of the hand stay. 0: the whole run. The present state moves back to \p fromStep if it lay
    /// behind.
    void setParams(const PhysicsParams& params, std::int64_t fromStep);
    /// The hand from \p fromStep on (none: let go); later hands are forgotten.
    void setPull(const std::optional<Pull>& pull, std::int64_t fromStep);
    /// An apple let go at state \p step.
    void shakeOff(Index apple, std::int64_t step);
    /// Forgets hand and apples, and all parameters but those at the beginning.
    void clearChanges();
    /// Forgets all states; changes stay.
    void clearStates();

    [[nodiscard]] StepState stateOf(std::int64_t step) const;
    /// The band under the timeline's ruler: first .. last cut into runs of one state, in order.
    [[nodiscard]] std::vector<StepRange> ranges(std::int64_t first, std::int64_t last) const;

    [[nodiscard]] std::size_t bytes() const { return m_bytes; } ///< of all states kept
    void setMemoryLimit(std::size_t bytes);
    [[nodiscard]] int checkpointSteps() const { return m_checkpointSteps; } ///< present distance

private:
    friend class PhysicsBake;
    struct Change;
    struct Kept;

    // see physics_cache.cpp
    PhysicsCacheOptions m_options;
    TreePhysics m_physics;
    PhysicsState m_state;
    int m_checkpointSteps;
    std::size_t m_bytes = 0;
    struct Private;
    std::unique_ptr<Private> m_private;
};

/// Most steps of a run.
inline constexpr std::int64_t maxPhysicsSteps = 10'000'000;

} // namespace ramure
