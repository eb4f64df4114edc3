#include "core/rig/arm/arm_driver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr std::int64_t firstSnapshotTicks = 120;
constexpr std::size_t mostSnapshots = 512;
constexpr double mostSeconds = 86400.0;

ArmDriver::Source constantJoints(std::span<const ArmJoint> joints, ArmDriver::Target target)
{
    ArmGiven given;
    given.joints.assign(joints.begin(), joints.end());
    given.pinned.assign(2 * joints.size(), 0);
    return [given = std::move(given), target = std::move(target)](double seconds) {
        ArmGiven now = given;
        if (target)
            now.target = target(seconds);
        return now;
    };
}

/// The angles that tracks turn.
std::vector<unsigned char> pinnedAngles(const NodeAnimation& animation, std::size_t joints)
{
    std::vector<unsigned char> pinned(2 * joints, 0);
    for (std::size_t i = 0; i < pinned.size(); ++i)
        pinned[i] = animation.find({ChannelPart::Joint, static_cast<std::uint8_t>(i / 2),
                                    static_cast<ParamId>(jointAngleNumber(i % 2 == 0))})
                        ? 1
                        : 0;
    return pinned;
}

} // namespace

ArmDriver::ArmDriver(std::span<const ArmJoint> joints, const ArmSolverParams& params, Target target)
    : ArmDriver(constantJoints(joints, std::move(target)), params)
{
}

ArmDriver::ArmDriver(Source source, const ArmSolverParams& params)
    : m_source(std::move(source))
    , m_motion(m_source(0.0).joints, params)
    , m_snapshots{m_motion}
    , m_snapshotTicks(firstSnapshotTicks)
{
}

double ArmDriver::residualNow(const ArmGiven& given) const
{
    ArmChain chain(given.joints);
    chain.setAngles(m_motion.angles());
    return glm::distance(chain.tip(), *given.target);
}

/// Of long runs fewer, so that they need no more memory than short ones.
void ArmDriver::keepSnapshot()
{
    m_snapshots.push_back(m_motion);
    if (m_snapshots.size() <= mostSnapshots)
        return;
    for (std::size_t i = 1; 2 * i < m_snapshots.size(); ++i)
        m_snapshots[i] = std::move(m_snapshots[2 * i]);
    m_snapshots.erase(m_snapshots.begin() + std::ptrdiff_t((m_snapshots.size() + 1) / 2), m_snapshots.end());
    m_snapshotTicks *= 2;
}

Expected<void> ArmDriver::goTo(std::int64_t tick, const Progress& progress)
{
    const auto nearest = std::min<std::size_t>(std::size_t(tick / m_snapshotTicks), m_snapshots.size() - 1);
    if (m_motion.ticks() > tick || m_motion.ticks() < m_snapshots[nearest].ticks())
        m_motion = m_snapshots[nearest];
    const std::int64_t from = m_motion.ticks();
    while (m_motion.ticks() < tick) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        // What is seen at the end of a tick answers to what is given then.
        const ArmGiven given = m_source(double(m_motion.ticks() + 1) * armTickSeconds);
        m_motion.setJoints(given.joints, given.pinned);
        m_motion.setTarget(*given.target);
        m_motion.tick();
        if (m_residuals.size() < std::size_t(m_motion.ticks()))
            m_residuals.push_back(static_cast<float>(residualNow(given)));
        if (m_motion.ticks() == std::int64_t(m_snapshots.size()) * m_snapshotTicks) {
            keepSnapshot();
            progress.report(double(m_motion.ticks() - from) / double(tick - from));
        }
    }
    return {};
}

Expected<ArmMoment> ArmDriver::momentAt(double timeSeconds, const Progress& progress)
{
    if (!std::isfinite(timeSeconds) || timeSeconds > mostSeconds)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The time must be a number of seconds, at most a day"));
    const double seconds = std::max(timeSeconds, 0.0);
    ArmGiven given = m_source(seconds);
    ArmMoment moment;
    moment.target = given.target;
    moment.angles = armAngles(given.joints);
    if (given.target) {
        const double ticks = seconds / armTickSeconds;
        // A frame that falls on a tick must not need the one after it because of a rounding error.
        const auto last = static_cast<std::int64_t>(std::ceil(ticks - 1e-9));
        RAMURE_TRY(goTo(last, progress));
        const std::vector<double> between =
            m_motion.anglesBetween(last > 0 ? std::min(ticks - double(last - 1), 1.0) : 1.0);
        for (std::size_t i = 0; i < between.size(); ++i)
            if (!given.pinned[i])
                moment.angles[i] = between[i];
        moment.figures = m_motion.solver().figures();
        const auto end = m_residuals.begin() + last;
        moment.residuals.assign(end - std::min<std::int64_t>(last, mostResiduals), end);
    }
    setArmAngles(given.joints, moment.angles);
    for (ArmJoint& joint : given.joints) { // limits that move may be a little elsewhere than at the tick
        settleAngle(joint.phi);
        settleAngle(joint.theta);
    }
    moment.angles = armAngles(given.joints);
    if (given.target)
        moment.residual = glm::distance(ArmChain(given.joints).tip(), *given.target);
    moment.joints = std::move(given.joints);
    return moment;
}

ArmDriver::Source armSource(const NodeParams& params, const NodeAnimation& animation)
{
    NodeParams own; // without what paramsAt would copy for nothing
    own.joints = params.joints;
    own.arm = params.arm;
    own.grammar = {{}, {}};
    const bool moves = animation.movesParams();
    return [own, animation, moves, pinned = pinnedAngles(animation, params.joints.size())](double seconds) {
        const NodeParams now = moves ? paramsAt(own, animation, seconds) : own;
        return ArmGiven{now.joints,
                        now.arm.follows ? std::optional(now.arm.target) : std::optional<glm::dvec3>(),
                        pinned};
    };
}

ArmDriver armDriver(const NodeParams& params, const NodeAnimation& animation)
{
    return {armSource(params, animation), params.ik};
}

} // namespace ramure
