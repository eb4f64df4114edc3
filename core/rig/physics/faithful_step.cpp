#include "core/rig/physics/faithful_step.h"

#include "core/rig/physics/lanes.h"
#include <algorithm>

namespace ramure {
namespace {

using namespace lanes;

/// Slots computed side by side; their parents' rotations are gathered first, so that the loop over them has
/// no indirect access.
constexpr Index branchesAtATime = 64;

struct StepColumns
{
    double *rotW, *rotX, *rotY, *rotZ, *velX, *velY, *velZ; // state
    double *turnW, *turnX, *turnY, *turnZ;                  // this step's rotations
    const double *dirX, *dirY, *dirZ, *length, *a0;         // at rest
    const double *mass, *windage;
};

struct Constants
{
    double seconds, perSecond, u, v, gravity, restitution, damping;
};

struct Parents
{
    double w[branchesAtATime], x[branchesAtATime], y[branchesAtATime], z[branchesAtATime];
};

void gatherParents(const TreeBody& body, const StepRotations& turn, Index first, Index count, Parents& out)
{
    for (Index i = 0; i < count; ++i) {
        const Index parent = body.parent[first + i];
        const bool isRoot = parent == noIndex;
        out.w[i] = isRoot ? 1.0 : turn.w[parent];
        out.x[i] = isRoot ? 0.0 : turn.x[parent];
        out.y[i] = isRoot ? 0.0 : turn.y[parent];
        out.z[i] = isRoot ? 0.0 : turn.z[parent];
    }
}

/// The shortest rotation from one unit vector to another.
inline Quat between(Vec from, Vec to)
{
    const double cosine = dot(from, to);
    // Exactly backwards any axis across will do; just before it, the cross product is as good.
    const double half = 0.5 * (1.0 + cosine);
    const bool isBack = half < 1e-24;
    const double w = std::sqrt(isBack ? 1.0 : half);
    const bool nearX = std::abs(from.x) > 0.7;
    const Vec side = cross(from, {nearX ? 0.0 : 1.0, nearX ? 1.0 : 0.0, 0.0});
    const Vec axis = cross(from, to);
    const double scale = isBack ? 1.0 / std::sqrt(dot(side, side)) : 0.5 / w;
    return {isBack ? 0.0 : w, scale * (isBack ? side.x : axis.x), scale * (isBack ? side.y : axis.y),
            scale * (isBack ? side.z : axis.z)};
}

RAMURE_VECTOR_CLONES
void stepBlock(const StepColumns& c, const Constants& k, const Parents& parents, std::size_t first,
               std::size_t count)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t i = first + lane;
        // 1. Moved by the parent.
        const Quat moved{parents.w[lane], parents.x[lane], parents.y[lane], parents.z[lane]};
        const Vec rest{c.dirX[i], c.dirY[i], c.dirZ[i]};
        const Quat rotation = moved * Quat{c.rotW[i], c.rotX[i], c.rotY[i], c.rotZ[i]};
        const Vec before = turned(rotation, rest);
        // 2. Wind and weight.
        const double wind = k.seconds * c.windage[i];
        const Vec velocity{c.velX[i] + wind * k.u, c.velY[i] - k.seconds * (c.mass[i] * k.gravity),
                           c.velZ[i] + wind * k.v};
        // 3. The length is kept.
        const double length = c.length[i];
        const Vec goal = length * before + k.seconds * velocity;
        const double far = std::sqrt(dot(goal, goal));
        const bool stays = !(far > 0.0) || !(length > 0.0);
        const double inverse = 1.0 / (stays ? 1.0 : far);
        const Vec now{stays ? before.x : inverse * goal.x, stays ? before.y : inverse * goal.y,
                      stays ? before.z : inverse * goal.z};
        const Quat turn = between(before, now);
        const double speed = length * k.perSecond;
        // 4. Back towards rest.
        const double cosine = dot(rest, now);
        const Vec towards = rest - cosine * now;
        const double sine = std::sqrt(dot(towards, towards));
        const bool isAway = sine > 1e-300;
        const double angle = angleOf(isAway ? sine : 0.0, isAway ? cosine : 1.0);
        const double kick = k.restitution * c.a0[i] * (angle * angle) / (isAway ? sine : 1.0);
        // 5. Damping.
        const Vec after = k.damping * (speed * (now - before) + kick * towards);
        c.velX[i] = after.x;
        c.velY[i] = after.y;
        c.velZ[i] = after.z;
        // 6. On to the children.
        const Quat step = turn * moved;
        c.turnW[i] = step.w;
        c.turnX[i] = step.x;
        c.turnY[i] = step.y;
        c.turnZ[i] = step.z;
        const Quat whole = renormalised(turn * rotation);
        c.rotW[i] = whole.w;
        c.rotX[i] = whole.x;
        c.rotY[i] = whole.y;
        c.rotZ[i] = whole.z;
    }
}

} // namespace

void faithfulStep(const StepInputs& in, PhysicsState& state)
{
    const TreeBody& body = in.body;
    StepRotations& turn = in.rotations;
    turn.resize(body.size());
    const auto column = [&](PhysicsState::Channel channel) { return state.channel(channel).data(); };
    const StepColumns columns{column(PhysicsState::RotW),
                              column(PhysicsState::RotX),
                              column(PhysicsState::RotY),
                              column(PhysicsState::RotZ),
                              column(PhysicsState::VelX),
                              column(PhysicsState::VelY),
                              column(PhysicsState::VelZ),
                              turn.w.data(),
                              turn.x.data(),
                              turn.y.data(),
                              turn.z.data(),
                              body.dirX.data(),
                              body.dirY.data(),
                              body.dirZ.data(),
                              body.length.data(),
                              body.a0.data(),
                              in.masses.mass.data(),
                              in.masses.windage.data()};
    const glm::dvec3 wind = faithfulWind(in.params, state.timeSeconds);
    const double seconds = in.params.stepSeconds;
    const Constants constants{seconds,           1.0 / seconds,         wind.x,           wind.z,
                              in.params.gravity, in.params.restitution, in.params.damping};
    Parents parents;
    Index first = 0;
    for (const Index end : body.depthEnd)
        for (; first < end;) {
            const Index count = std::min(branchesAtATime, end - first);
            gatherParents(body, turn, first, count, parents);
            stepBlock(columns, constants, parents, first, count);
            first += count;
        }
}

} // namespace ramure
