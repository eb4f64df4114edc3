#include "core/arm/arm_driver.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr std::int64_t snapshotTicks = 120;
constexpr double mostSeconds = 86400.0;

} // namespace

ArmDriver::ArmDriver(std::span<const ArmJoint> joints, const ArmSolverParams& params, Target target)
    : m_joints(joints.begin(), joints.end())
    , m_target(std::move(target))
    , m_motion(joints, params)
    , m_snapshots{m_motion}
{
}

Expected<void> ArmDriver::goTo(std::int64_t tick, const Progress& progress)
{
    const auto nearest = std::min<std::size_t>(std::size_t(tick / snapshotTicks), m_snapshots.size() - 1);
    if (m_motion.ticks() > tick || m_motion.ticks() < m_snapshots[nearest].ticks())
        m_motion = m_snapshots[nearest];
    const std::int64_t from = m_motion.ticks();
    while (m_motion.ticks() < tick) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        // What is seen at the end of a tick answers to where the target is then.
        if (m_target)
            m_motion.setTarget(m_target(double(m_motion.ticks() + 1) * armTickSeconds));
        m_motion.tick();
        if (m_motion.ticks() == std::int64_t(m_snapshots.size()) * snapshotTicks) {
            m_snapshots.push_back(m_motion);
            progress.report(double(m_motion.ticks() - from) / double(tick - from));
        }
    }
    return {};
}

Expected<ArmMoment> ArmDriver::momentAt(double timeSeconds, const Progress& progress)
{
    if (!std::isfinite(timeSeconds) || timeSeconds > mostSeconds)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The time must be a number of seconds, at most a day"));
    const double ticks = std::max(timeSeconds, 0.0) / armTickSeconds;
    // A frame that falls on a tick must not need the one after it because of a rounding error.
    const double last = std::ceil(ticks - 1e-9);
    if (const auto gone = goTo(std::int64_t(last), progress); !gone)
        return fail(gone.error());
    ArmMoment moment;
    moment.angles = m_motion.anglesBetween(last > 0.0 ? std::min(ticks - (last - 1.0), 1.0) : 1.0);
    moment.figures = m_motion.solver().figures();
    if (m_target) {
        ArmChain chain(m_joints);
        chain.setAngles(moment.angles);
        moment.residual = glm::distance(chain.tip(), m_target(std::max(timeSeconds, 0.0)));
    }
    return moment;
}

Expected<void> ArmDriver::poseAt(double timeSeconds, Pose& out, const Progress& progress)
{
    const Expected<ArmMoment> moment = momentAt(timeSeconds, progress);
    if (!moment)
        return fail(moment.error());
    ArmChain chain(m_joints);
    chain.setAngles(moment->angles);
    out.timeSeconds = timeSeconds;
    chain.pose(out.bones);
    return {};
}

} // namespace ramure
