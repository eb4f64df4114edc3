#include "core/session/moving_source.h"

#include <algorithm>
#include <cmath>

namespace ramure {

MovingSource::MovingSource(TreeSource rest, const TimelineSettings& timeline)
    : m_rest(std::move(rest))
    , m_timeline(timeline)
    , m_arms(timeline)
{
}

TreeSource MovingSource::at(double timeSeconds)
{
    return [this, timeSeconds](const Node& node, Stage last, const Progress& progress) {
        const auto make = [&](const Node& now) {
            return timeSeconds <= 0.0 ? m_rest(now, last, progress)
                                      : moved(now, node.params.physics, last, timeSeconds, progress);
        };
        if (!node.animation.movesParams())
            return make(node);
        Node now = node;
        now.params = paramsAt(node.params, node.animation, timeSeconds);
        return make(now);
    };
}

Expected<TreeResult> MovingSource::moved(const Node& node, const PhysicsParams& physics, Stage last,
                                         double timeSeconds, const Progress& progress)
{
    // Apples weigh: they must be known even where nobody asked for them.
    auto tree = m_rest(node, std::max(last, Stage::Foliage), progress.part(0.0, 0.4));
    if (!tree)
        return tree;
    TreeRun& run = m_runs[node.id];
    if (auto set = run.setTree(*tree, node.params); !set)
        return fail(std::move(set.error()));
    if (!std::isfinite(timeSeconds) || timeSeconds > run.cache().timeAt(maxPhysicsSteps))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the time lies beyond what the physics counts"));
    run.setPhysics(physics, node.animation, timeSeconds);
    const auto motion = run.motionAt(timeSeconds, m_timeline, progress.part(0.4, 0.9));
    if (!motion)
        return fail(motion.error());
    return movedTree(std::move(*tree), *motion, progress.part(0.9, 1.0));
}

} // namespace ramure
