/// \file
/// What steers a run of physics, step by step: parameters, the hand, apples let go. Changes have effect on
/// the step from the state they name to the next; the state itself stays.
#pragma once

#include "core/rig/physics/physics_state.h"
#include <utility>
#include <vector>

namespace ramure {

class PhysicsScript
{
public:
    using ParamChange = std::pair<std::int64_t, PhysicsParams>;
    using PullChange = std::pair<std::int64_t, std::optional<Pull>>;
    using AppleChange = std::pair<std::int64_t, Index>;

    explicit PhysicsScript(const PhysicsParams& params) { setParams(params, 0); }

    /// From state \p from on, whatever was said for later steps. What says the same as before leaves no
    /// trace.
    void setParams(const PhysicsParams& params, std::int64_t from);
    void setPull(const std::optional<Pull>& pull, std::int64_t from);
    /// Once for each apple: the earlier of two counts.
    void shakeOff(Index apple, std::int64_t at);
    /// Only the parameters at the beginning remain.
    void clear();

    /// Returns the parameters that act between state \p step and the next one.
    [[nodiscard]] const PhysicsParams& paramsAt(std::int64_t step) const;
    [[nodiscard]] const std::optional<Pull>& pullAt(std::int64_t step) const;
    /// Apples let go at a state, in the order in which they were asked for.
    [[nodiscard]] std::vector<Index> applesAt(std::int64_t step) const;

    /// A hash of all that made state \p step what it is.
    [[nodiscard]] std::uint64_t keyAt(std::int64_t step) const;

    /// Time of a state, and the state of a time: round((T - start) / step length) within stretches of one
    /// step length.
    [[nodiscard]] double timeAt(std::int64_t step) const;
    [[nodiscard]] std::int64_t stepAt(double timeSeconds) const;

    [[nodiscard]] const std::vector<ParamChange>& paramChanges() const { return m_params; }
    [[nodiscard]] const std::vector<PullChange>& pullChanges() const { return m_pulls; }
    [[nodiscard]] const std::vector<AppleChange>& appleChanges() const { return m_apples; }
    bool operator==(const PhysicsScript& other) const
    {
        return m_params == other.m_params && m_pulls == other.m_pulls && m_apples == other.m_apples;
    }

private:
    std::vector<ParamChange> m_params; ///< by step; the first at 0
    std::vector<PullChange> m_pulls;
    std::vector<AppleChange> m_apples;
    std::vector<std::uint64_t> m_paramKeys, m_pullKeys, m_appleKeys; ///< of all changes up to each
};

} // namespace ramure
