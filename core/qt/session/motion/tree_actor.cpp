#include "core/qt/session/motion/tree_actor.h"

#include <algorithm>
#include <utility>

namespace ramure {

Expected<void> TreeActor::prepare(const MotionTree& wanted, const TreeResult& shape, const NodeParams& params,
                                  const MotionRequest& request, std::size_t memoryBytes)
{
    const auto isOther = m_run.setTree(shape, params);
    RAMURE_TRY(isOther);
    m_lookAtBake = m_lookAtBake || *isOther;
    PhysicsCache& cache = m_run.cache();
    cache.setMemoryLimit(memoryBytes);
    const double seconds = request.timeline.timeOf(request.frame);
    if (m_run.setPhysics(wanted.node->params.physics, wanted.node->animation, seconds, request.live))
        m_lookAtBake = true;
    if (!request.live)
        return {};
    cache.setPull(wanted.pull, cache.step());
    for (const Index apple : wanted.shaken)
        cache.shakeOff(m_run.fruitOfPhysics(apple), cache.step());
    return {};
}

void TreeActor::forgetHand()
{
    PhysicsScript calm = m_run.cache().script();
    calm.clear();
    m_run.cache().setScript(calm);
    m_lookAtBake = true;
}

/// The run is, from its beginning on, the one that the file says it holds.
bool TreeActor::isBakeOfUse() const
{
    return m_bake && !m_run.isMixed() && m_bake->params == m_run.params() &&
           m_bake->bodyKey == m_run.cache().physics().body().key;
}

/// The hand, or other parameters, may have put their own states in the place of some.
bool TreeActor::isBakeHere() const
{
    return m_bakedStep >= 0 && m_run.cache().ranges(0, m_bakedStep) ==
                                   std::vector<StepRange>{{0, m_bakedStep, StepState::Cached}};
}

BakeState TreeActor::bakeState() const
{
    if (m_bakeFile.empty())
        return BakeState::None;
    return isBakeOfUse() ? BakeState::Good : BakeState::Stale;
}

/// A file is read when it is new, and again when what made its states stale is taken back.
Expected<void> TreeActor::takeBake(const MotionTree& wanted, const Progress& progress)
{
    const bool isNew = m_bakeFile != wanted.bakeFile || m_bakeVersion != wanted.bakeVersion;
    if (isNew && wanted.bakeFile.empty() && m_bakedStep >= 0)
        m_run.cache().clearStates(); // freed
    const bool look = isNew || (std::exchange(m_lookAtBake, false) && isBakeOfUse() &&
                                m_run.cache().script() == PhysicsScript(m_run.params()) && !isBakeHere());
    if (isNew) {
        m_bakeFile = wanted.bakeFile;
        m_bakeVersion = wanted.bakeVersion;
        m_bakedStep = -1;
        m_bake.reset();
    }
    if (!look || m_bakeFile.empty())
        return {};
    const auto loaded = loadBake(m_run.cache(), m_run.params(), m_bakeFile, progress);
    const auto label = readBakeLabel(m_bakeFile);
    m_bake = label ? std::optional(*label) : std::nullopt;
    if (loaded) {
        const auto states = m_run.cache().validStates();
        m_bakedStep = states.empty() ? 0 : states.back()->step;
        return {};
    }
    if (loaded.error().code == ErrorCode::Cancelled)
        m_lookAtBake = true;
    else if (isBakeOfUse())
        m_bake.reset(); // it says that it is this run, and yet it is not sound
    return loaded;
}

/// A frame is as good as its worst tree. By ranges: a timeline may have a million frames.
void TreeActor::addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const
{
    const auto stepOf = [&](std::size_t i) {
        return std::max<std::int64_t>(
            m_run.cache().stepAt(timeline.timeOf(timeline.firstFrame + std::int64_t(i))), 0);
    };
    std::size_t i = 0;
    for (const StepRange& range : m_run.cache().ranges(0, stepOf(states.size() - 1)))
        for (; i < states.size() && stepOf(i) <= range.last; ++i)
            states[i] = std::min(states[i], static_cast<FrameState>(range.state));
}

} // namespace ramure
