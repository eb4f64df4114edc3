/// \file
/// A run of tree physics that can be entered anywhere (ANIMATION 4.9): fixed steps, checkpoints, and the last
/// states in full. Straight play and any order of seeks give the same bits.
///
/// A state is kept under a hash of the body and of all inputs of the run before it. An edit at step s makes
/// only later states stale, and taking the edit back makes them good again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/rig/physics/physics_script.h"
#include "core/rig/physics/tree_physics.h"
#include <deque>
#include <map>

namespace ramure {

/// Most steps of a run.
inline constexpr std::int64_t maxPhysicsSteps = 10'000'000;

enum class StepState : std::uint8_t {
    Missing, ///< was never computed
    Stale,   ///< was computed, but something changed before it
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
    /// Between two checkpoints, at first; doubled whenever the memory is used up. 0: as many as take about 3
    /// ms, 10 to 100, so that small trees keep long runs in little memory.
    int checkpointSteps = 0;
    int ringStates = 64; ///< the last states, for single steps back
    std::size_t memoryBytes = std::size_t(512)
                              << 20; ///< memory for all states together; the ring takes a quarter at most
};

class PhysicsCache
{
public:
    PhysicsCache(std::shared_ptr<const TreeBody> body, const PhysicsParams& params,
                 const PhysicsCacheOptions& options = {});
    ~PhysicsCache();
    PhysicsCache(const PhysicsCache&) = delete;
    PhysicsCache& operator=(const PhysicsCache&) = delete;

    [[nodiscard]] const TreePhysics& physics() const { return m_physics; }
    [[nodiscard]] const PhysicsState& state() const { return m_state; } ///< at the present step
    [[nodiscard]] std::int64_t step() const { return m_state.step; }
    /// Returns the parameters that act from the present step on.
    [[nodiscard]] const PhysicsParams& params() const { return m_script.paramsAt(step()); }
    [[nodiscard]] const PhysicsScript& script() const { return m_script; }

    /// Errors: Invalid (negative or above maxPhysicsSteps), Cancelled. After a cancel the present step is one
    /// on the way, and the computed states are kept.
    Expected<void> seek(std::int64_t step, const Progress& progress = {});
    /// round(T / step length), clamped to 0 .. maxPhysicsSteps.
    [[nodiscard]] std::int64_t stepAt(double timeSeconds) const;
    [[nodiscard]] double timeAt(std::int64_t step) const { return m_script.timeAt(step); }

    /// Pose at the present step.
    void pose(Pose& out) const { m_physics.pose(m_state, out); }

    /// Another tree: all states, the hand and the apples are forgotten; the parameters at the beginning stay.
    void setBody(std::shared_ptr<const TreeBody> body);
    // What follows has effect from state `from` on (see PhysicsScript). Where the present step lies behind,
    // it goes back there.
    void setParams(const PhysicsParams& params, std::int64_t from);
    void setPull(const std::optional<Pull>& pull, std::int64_t from);
    void shakeOff(Index apple, std::int64_t at);
    /// Another script altogether.
    void setScript(const PhysicsScript& script);

    [[nodiscard]] StepState stateOf(std::int64_t step) const;
    /// The band under the timeline's ruler: \p first .. \p last cut into runs of one state, in order.
    [[nodiscard]] std::vector<StepRange> ranges(std::int64_t first, std::int64_t last) const;

    /// All states go; the script and the present state stay.
    void clearStates();
    [[nodiscard]] std::size_t bytes() const { return m_bytes; } ///< memory of the kept states
    void setMemoryLimit(std::size_t bytes);
    [[nodiscard]] int checkpointSteps() const { return m_checkpointSteps; } ///< present distance

    /// States worth writing down: valid, by step. And back, in place of all others (see physics_bake.h).
    [[nodiscard]] std::vector<const PhysicsState*> validStates() const;
    void takeStates(std::vector<PhysicsState> states, int checkpointSteps);

private:
    struct Kept
    {
        std::uint64_t key = 0;
        std::unique_ptr<PhysicsState> state;
    };
    using States = std::map<std::int64_t, Kept>;

    [[nodiscard]] int firstCheckpointSteps() const;
    [[nodiscard]] std::uint64_t keyAt(std::int64_t step) const;
    [[nodiscard]] bool isValid(const States::value_type& entry) const;
    [[nodiscard]] bool isCheckpoint(std::int64_t step) const { return step % m_checkpointSteps == 0; }
    [[nodiscard]] const PhysicsState* nearest(std::int64_t step) const;
    [[nodiscard]] std::int64_t lastValid() const;
    void advance();
    void keep();
    void forget(States::iterator entry);
    void dropFromRing();
    void shrink();
    void afterChange(std::int64_t from);

    PhysicsCacheOptions m_options;
    PhysicsScript m_script;
    TreePhysics m_physics;
    PhysicsState m_state;
    States m_states;                                 ///< checkpoints and ring
    std::deque<std::int64_t> m_ring;                 ///< steps of the last states, oldest first
    std::unique_ptr<PhysicsState> m_spare;           ///< memory of a state let go, for the next one
    mutable std::optional<std::int64_t> m_lastValid; ///< index in m_states, if known
    int m_checkpointSteps;
    std::size_t m_bytes = 0;
};

} // namespace ramure
