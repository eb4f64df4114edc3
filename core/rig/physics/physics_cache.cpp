#include "core/rig/physics/physics_cache.h"

#include "core/math/stage_hash.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Steps between two looks at the stop token.
constexpr std::int64_t lookEvery = 8;

PhysicsCacheOptions sane(PhysicsCacheOptions options)
{
    options.ringStates = std::max(options.ringStates, 1);
    return options;
}

} // namespace

PhysicsCache::PhysicsCache(std::shared_ptr<const TreeBody> body, const PhysicsParams& params,
                           const PhysicsCacheOptions& options)
    : m_options(sane(options))
    , m_script(params)
    , m_physics(std::move(body), params)
    , m_state(m_physics.restState())
    , m_checkpointSteps(firstCheckpointSteps())
{
}

PhysicsCache::~PhysicsCache() = default;

int PhysicsCache::firstCheckpointSteps() const
{
    if (m_options.checkpointSteps > 0)
        return m_options.checkpointSteps;
    constexpr double wantedSeconds = 3e-3, secondsPerBranch = 40e-9;
    const double stepSeconds = secondsPerBranch * std::max<double>(m_physics.body().size(), 1.0) *
                               static_cast<double>(m_script.paramsAt(0).substeps);
    return static_cast<int>(std::clamp(wantedSeconds / stepSeconds, 10.0, 100.0));
}

std::uint64_t PhysicsCache::keyAt(std::int64_t step) const
{
    return StageHash(m_physics.body().key).add(m_script.keyAt(step)).value();
}

bool PhysicsCache::isValid(const States::value_type& entry) const
{
    return entry.second.key == keyAt(entry.first);
}

/// The last valid state at or before \p step; null: only rest.
const PhysicsState* PhysicsCache::nearest(std::int64_t step) const
{
    for (auto it = m_states.upper_bound(step); it != m_states.begin();)
        if (isValid(*--it))
            return it->second.state.get();
    return nullptr;
}

/// What is valid far ahead says that all before it was computed likewise.
std::int64_t PhysicsCache::lastValid() const
{
    if (!m_lastValid) {
        m_lastValid = 0;
        for (auto it = m_states.rbegin(); it != m_states.rend() && *m_lastValid == 0; ++it)
            if (isValid(*it))
                m_lastValid = it->first;
    }
    return std::max(*m_lastValid, step());
}

void PhysicsCache::forget(States::iterator entry)
{
    m_lastValid.reset();
    m_bytes -= entry->second.state->bytes();
    m_spare = std::move(entry->second.state);
    m_states.erase(entry);
}

void PhysicsCache::dropFromRing()
{
    const std::int64_t oldest = m_ring.front();
    m_ring.pop_front();
    const auto entry = m_states.find(oldest);
    const bool isTwice = std::ranges::find(m_ring, oldest) != m_ring.end();
    if (entry != m_states.end() && !isTwice && !isCheckpoint(oldest))
        forget(entry);
}

/// Down to the memory limit: what is stale goes first, then the older half of the ring's share, then every
/// other checkpoint.
void PhysicsCache::shrink()
{
    if (m_bytes <= m_options.memoryBytes)
        return;
    for (auto it = m_states.begin(); it != m_states.end();) {
        const auto next = std::next(it);
        if (!isValid(*it))
            forget(it);
        it = next;
    }
    const std::size_t each = std::max<std::size_t>(m_state.bytes(), 1);
    while (m_bytes > m_options.memoryBytes && m_ring.size() > 1 &&
           m_ring.size() * each > m_options.memoryBytes / 4)
        dropFromRing();
    while (m_bytes > m_options.memoryBytes && m_checkpointSteps < maxPhysicsSteps) {
        m_checkpointSteps *= 2;
        for (auto it = m_states.begin(); it != m_states.end();) {
            const auto next = std::next(it);
            if (!isCheckpoint(it->first) && std::ranges::find(m_ring, it->first) == m_ring.end())
                forget(it);
            it = next;
        }
    }
}

/// The present state into the ring, and among the checkpoints if it is one.
void PhysicsCache::keep()
{
    const std::int64_t at = step();
    if (m_lastValid)
        m_lastValid = std::max(*m_lastValid, at);
    auto& kept = m_states[at];
    if (kept.state)
        m_bytes -= kept.state->bytes();
    else
        kept.state = m_spare ? std::move(m_spare) : std::make_unique<PhysicsState>();
    *kept.state = m_state;
    kept.key = keyAt(at);
    m_bytes += kept.state->bytes();
    m_ring.push_back(at);
    while (m_ring.size() > static_cast<std::size_t>(m_options.ringStates))
        dropFromRing();
    shrink();
}

void PhysicsCache::advance()
{
    const std::int64_t from = step();
    if (const PhysicsParams& params = m_script.paramsAt(from); params != m_physics.params())
        m_physics.setParams(params);
    for (const Index apple : m_script.applesAt(from))
        m_physics.shakeOff(m_state, apple);
    m_physics.step(m_state, m_script.pullAt(from));
    keep();
}

Expected<void> PhysicsCache::seek(std::int64_t target, const Progress& progress)
{
    if (target < 0 || target > maxPhysicsSteps)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("step %1 is outside 0 to %2"),
                    {std::to_string(target), std::to_string(maxPhysicsSteps)});
    const PhysicsState* start = nearest(target);
    if (target < step() || (start && start->step > step())) {
        if (start) {
            m_state = *start;
        } else {
            m_physics.setParams(m_script.paramsAt(0));
            m_state = m_physics.restState();
        }
    }
    const std::int64_t first = step();
    while (step() < target) {
        if ((step() - first) % lookEvery == 0) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            progress.report(static_cast<double>(step() - first) / static_cast<double>(target - first));
        }
        advance();
    }
    progress.report(1.0);
    return {};
}

std::int64_t PhysicsCache::stepAt(double timeSeconds) const
{
    return std::isnan(timeSeconds)
               ? 0
               : std::clamp<std::int64_t>(m_script.stepAt(timeSeconds), 0, maxPhysicsSteps);
}

void PhysicsCache::setBody(std::shared_ptr<const TreeBody> body)
{
    const PhysicsParams first = m_script.paramsAt(0);
    m_physics = TreePhysics(std::move(body), first);
    m_script = PhysicsScript(first);
    clearStates();
    m_spare.reset();
    m_checkpointSteps = firstCheckpointSteps();
    m_state = m_physics.restState();
}

void PhysicsCache::afterChange(std::int64_t from)
{
    m_lastValid.reset();
    const std::int64_t back = std::clamp<std::int64_t>(from, 0, maxPhysicsSteps);
    // At rest even the beginning may have another mode.
    if (step() == 0 || back == 0) {
        m_physics.setParams(m_script.paramsAt(0));
        m_state = m_physics.restState();
    } else if (step() > back) {
        (void)seek(back);
    }
}

void PhysicsCache::setParams(const PhysicsParams& params, std::int64_t from)
{
    m_script.setParams(params, std::max<std::int64_t>(from, 0));
    afterChange(from);
}

void PhysicsCache::setPull(const std::optional<Pull>& pull, std::int64_t from)
{
    m_script.setPull(pull, std::max<std::int64_t>(from, 0));
    afterChange(from);
}

void PhysicsCache::shakeOff(Index apple, std::int64_t at)
{
    m_script.shakeOff(apple, std::max<std::int64_t>(at, 0));
    afterChange(at);
}

void PhysicsCache::setScript(const PhysicsScript& script)
{
    m_script = script;
    afterChange(0);
}

StepState PhysicsCache::stateOf(std::int64_t at) const
{
    if (at > lastValid())
        return !m_states.empty() && at <= m_states.rbegin()->first ? StepState::Stale : StepState::Missing;
    const PhysicsState* kept = nearest(at);
    const std::int64_t from = std::max(kept ? kept->step : 0, step() <= at ? step() : 0);
    return at - from < m_checkpointSteps ? StepState::Cached : StepState::Stale;
}

std::vector<StepRange> PhysicsCache::ranges(std::int64_t first, std::int64_t last) const
{
    std::vector<StepRange> out;
    const auto add = [&](std::int64_t from, std::int64_t to, StepState state) {
        from = std::max(from, first);
        to = std::min(to, last);
        if (from > to)
            return;
        if (!out.empty() && out.back().state == state)
            out.back().last = to;
        else
            out.push_back({from, to, state});
    };
    const std::int64_t known = m_states.empty() ? 0 : m_states.rbegin()->first;
    const std::int64_t valid = lastValid();
    std::int64_t next = 0; // the first step not told yet
    const auto addValid = [&](std::int64_t at) {
        add(next, at - 1, StepState::Stale);
        const std::int64_t end = std::min(at + m_checkpointSteps - 1, valid);
        add(std::max(next, at), end, StepState::Cached);
        next = std::max(next, end + 1);
    };
    addValid(0); // rest is always at hand
    for (const auto& entry : m_states)
        if (isValid(entry))
            addValid(entry.first);
    if (step() >= next)
        addValid(step());
    add(next, known, StepState::Stale);
    add(std::max(next, known + 1), last, StepState::Missing);
    return out;
}

void PhysicsCache::clearStates()
{
    m_states.clear();
    m_ring.clear();
    m_lastValid.reset();
    m_bytes = 0;
}

void PhysicsCache::setMemoryLimit(std::size_t bytes)
{
    m_options.memoryBytes = bytes;
    shrink();
}

std::vector<const PhysicsState*> PhysicsCache::validStates() const
{
    std::vector<const PhysicsState*> out;
    for (const auto& entry : m_states)
        if (isValid(entry))
            out.push_back(entry.second.state.get());
    return out;
}

void PhysicsCache::takeStates(std::vector<PhysicsState> states, int checkpointSteps)
{
    clearStates();
    m_checkpointSteps = std::max(checkpointSteps, 1);
    for (PhysicsState& state : states) {
        const std::int64_t at = state.step;
        m_bytes += state.bytes();
        m_lastValid.reset();
        m_states[at] = {keyAt(at), std::make_unique<PhysicsState>(std::move(state))};
    }
    shrink();
}

} // namespace ramure
