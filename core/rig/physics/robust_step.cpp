#include "core/rig/physics/robust_step.h"

#include "core/math/reproducible.h"
#include "core/rig/physics/apple_fall.h"
#include "core/rig/physics/lanes.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

using namespace lanes;

constexpr Index slotsAtATime = 64;

/// rate² = springiness * g / reach: a tree of 5 m sways at half a hertz, a twig of 30 cm flutters at two.
constexpr double springiness = 5.0;
/// Turn of a lone twig across a wind of 1 m/s, and of a lone level twig under its weight, rad.
constexpr double turnOfWind = 0.025, turnOfWeight = 0.015;
/// Air that a branch is carried through faster than this, m/s, presses no more: what whips wildly would shake
/// all that it carries ever more.
constexpr double fastAir = 6.0;
constexpr double leastStiffness = 1e-3;
constexpr double leastRatio = 0.02, mostRatio = 20.0;
/// Faster swings than this in a substep could not be seen as swings.
constexpr double mostTurnOfSubstep = 2.0;

struct StepColumns
{
    double *rotW, *rotX, *rotY, *rotZ, *velX, *velY, *velZ;
    double *bendX, *bendY, *bendZ, *rateX, *rateY, *rateZ;
    const double *dirX, *dirY, *dirZ, *length, *give, *drag, *weight, *held;
    const double *keepXX, *keepXV, *keepVX, *keepVV;
};

/// What the slots of a block get from elsewhere.
struct Around
{
    double w[slotsAtATime], x[slotsAtATime], y[slotsAtATime],
        z[slotsAtATime]; ///< rotation of the frame that the branch rests in
    double velX[slotsAtATime], velY[slotsAtATime], velZ[slotsAtATime]; ///< of p0
    double airX[slotsAtATime], airY[slotsAtATime], airZ[slotsAtATime]; ///< wind
};

void gatherParents(const TreeBody& body, const StepColumns& c, bool isParentFrame, Index first, Index count,
                   Around& out)
{
    for (Index i = 0; i < count; ++i) {
        const Index parent = body.parent[first + i];
        const bool isRoot = parent == noIndex;
        const bool isFixed = isRoot || !isParentFrame;
        out.w[i] = isFixed ? 1.0 : c.rotW[parent];
        out.x[i] = isFixed ? 0.0 : c.rotX[parent];
        out.y[i] = isFixed ? 0.0 : c.rotY[parent];
        out.z[i] = isFixed ? 0.0 : c.rotZ[parent];
        out.velX[i] = isRoot ? 0.0 : c.velX[parent];
        out.velY[i] = isRoot ? 0.0 : c.velY[parent];
        out.velZ[i] = isRoot ? 0.0 : c.velZ[parent];
    }
}

RAMURE_VECTOR_CLONES
void addWave(const double* sine, const double* cosine, const double (&s)[3], const double (&c)[3],
             std::size_t count, Around& out)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t i = 0; i < count; ++i) {
        out.airX[i] += s[0] * sine[i] + c[0] * cosine[i];
        out.airY[i] += s[1] * sine[i] + c[1] * cosine[i];
        out.airZ[i] += s[2] * sine[i] + c[2] * cosine[i];
    }
}

void blow(const WindField& wind, const WindField::Moment& moment, Index first, Index count, Around& out)
{
    for (Index i = 0; i < count; ++i) {
        out.airX[i] = moment.mean.x;
        out.airY[i] = moment.mean.y;
        out.airZ[i] = moment.mean.z;
    }
    for (int w = 0; w < WindField::waves; ++w) {
        const glm::dvec3 sine = moment.sine[std::size_t(w)], cosine = moment.cosine[std::size_t(w)];
        const double s[3] = {sine.x, sine.y, sine.z}, c[3] = {cosine.x, cosine.y, cosine.z};
        addWave(wind.sinOf(w) + first, wind.cosOf(w) + first, s, c, count, out);
    }
}

/// The bend that turns the unit vector \p rest to where rest + load points; at most about 152 degrees.
inline Vec bendOf(Vec rest, Vec load)
{
    const Vec sum = rest + load;
    const double size = std::sqrt(dot(sum, sum));
    const double whole = size + 1.0 + dot(rest, load);
    const double least = 0.25 * size + 1e-30;
    return (1.0 / (whole > least ? whole : least)) * cross(rest, load);
}

RAMURE_VECTOR_CLONES
void stepBlock(const StepColumns& c, double perSecond, const Around& around, std::size_t first,
               std::size_t count)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t i = first + lane;
        const Quat frame{around.w[lane], around.x[lane], around.y[lane], around.z[lane]};
        const Vec rest{c.dirX[i], c.dirY[i], c.dirZ[i]};
        const Quat old{c.rotW[i], c.rotX[i], c.rotY[i], c.rotZ[i]};
        // The air that passes the branch, and its weight.
        const Vec carried{around.velX[lane], around.velY[lane], around.velZ[lane]};
        const Vec air{around.airX[lane], around.airY[lane], around.airZ[lane]};
        const double felt = c.drag[i] / std::sqrt(1.0 + dot(carried, carried) * (1.0 / (fastAir * fastAir)));
        const Vec pressed = c.give[i] * (turnOfWind * air - Vec{0.0, c.weight[i], 0.0}) - felt * carried;
        const Vec load = turned(conjugate(frame), pressed) + Vec{0.0, c.held[i], 0.0};
        const Vec target = bendOf(rest, load);
        // The spring, solved exactly.
        const Vec away = Vec{c.bendX[i], c.bendY[i], c.bendZ[i]} - target;
        const Vec rate{c.rateX[i], c.rateY[i], c.rateZ[i]};
        const Vec bend = target + (c.keepXX[i] * away + c.keepXV[i] * rate);
        const Vec after = c.keepVX[i] * away + c.keepVV[i] * rate;
        c.bendX[i] = bend.x;
        c.bendY[i] = bend.y;
        c.bendZ[i] = bend.z;
        c.rateX[i] = after.x;
        c.rateY[i] = after.y;
        c.rateZ[i] = after.z;
        const double w = 1.0 / std::sqrt(1.0 + dot(bend, bend));
        const Quat now = renormalised(frame * Quat{w, w * bend.x, w * bend.y, w * bend.z});
        const Vec way = turned(now, rest) - turned(old, rest);
        const Vec velocity = carried + (c.length[i] * perSecond) * way;
        c.rotW[i] = now.w;
        c.rotX[i] = now.x;
        c.rotY[i] = now.y;
        c.rotZ[i] = now.z;
        c.velX[i] = velocity.x;
        c.velY[i] = velocity.y;
        c.velZ[i] = velocity.z;
    }
}

/// How the spring carries (bend - target, rate) over the time \p h.
void solve(double rate, double ratio, double h, Springs& out)
{
    const double a = ratio * rate;
    double even = 1.0, odd = h; // exp(-a h) times cos and sin / frequency, or cosh and sinh / frequency
    if (ratio < 1.0) {
        const double frequency = rate * std::sqrt(1.0 - ratio * ratio);
        const double fade = maths::exp(-a * h);
        const auto [sine, cosine] = maths::sincos(frequency * h);
        even = fade * cosine;
        odd = frequency * h > 1e-9 ? fade * sine / frequency : fade * h;
    } else {
        const double spread = rate * std::sqrt(ratio * ratio - 1.0);
        const double slow = maths::exp(-rate * rate / (a + spread) * h), fast = maths::exp(-(a + spread) * h);
        even = 0.5 * (slow + fast);
        odd = spread * h > 1e-9 ? 0.5 * (slow - fast) / spread : slow * h;
    }
    out.keepXX.push_back(even + a * odd);
    out.keepXV.push_back(odd);
    out.keepVX.push_back(-rate * rate * odd);
    out.keepVV.push_back(even - a * odd);
}

double stiffnessOf(double restitution)
{
    return std::max(restitution / 1000.0, leastStiffness);
}

double giveOf(const TreeBody& body, Index slot, double stiffness)
{
    return body.length[slot] / std::max(body.reach[slot], 1e-9) / stiffness;
}

double weightOf(const Masses& masses, Index slot, double gravity)
{
    const double heavier = masses.bare[slot] > 0.0 ? masses.mass[slot] / masses.bare[slot] : 1.0;
    return turnOfWeight * gravity * std::min(heavier, 6.0);
}

} // namespace

std::vector<double> heldLoads(const TreeBody& body, const HeldWeight& held)
{
    const Masses masses = massesOf(body, held.appleMass, {});
    const double stiffness = stiffnessOf(held.restitution);
    std::vector<double> out(body.size());
    for (Index slot = 0; slot < body.size(); ++slot)
        out[slot] = giveOf(body, slot, stiffness) * weightOf(masses, slot, held.gravity);
    return out;
}

Springs springsOf(const TreeBody& body, const PhysicsParams& params, const Masses& masses)
{
    Springs out;
    out.seconds = params.stepSeconds / static_cast<double>(params.substeps);
    const double stiffness = stiffnessOf(params.restitution);
    const double ratio =
        std::clamp(-maths::log(std::max(params.damping, 1e-30)) / std::numbers::pi, leastRatio, mostRatio);
    for (Index slot = 0; slot < body.size(); ++slot) {
        const double reach = std::max(body.reach[slot], 1e-9);
        out.rate.push_back(std::min(std::sqrt(springiness * earthGravity * stiffness / reach),
                                    mostTurnOfSubstep / out.seconds));
        out.give.push_back(giveOf(body, slot, stiffness));
        out.weight.push_back(weightOf(masses, slot, params.gravity));
        // The air that a swinging branch pushes away slows it, as it shakes the branches that are carried
        // through it. Of soft branches no more than of usual ones: what shakes them must not be more than
        // what slows them.
        out.drag.push_back(turnOfWind * body.length[slot] / reach / std::max(stiffness, 1.0));
        const double ownAir = 0.5 * out.rate.back() * out.drag.back() * body.length[slot];
        solve(out.rate.back(), std::min(ratio + ownAir, mostRatio), out.seconds, out);
    }
    return out;
}

void robustStep(const StepInputs& in, PhysicsState& state, double timeSeconds)
{
    const TreeBody& body = in.body;
    const Springs& s = in.springs;
    const auto at = [&](PhysicsState::Channel channel) { return state.channel(channel).data(); };
    using State = PhysicsState;
    const StepColumns columns{
        at(State::RotW),  at(State::RotX),    at(State::RotY),  at(State::RotZ),  at(State::VelX),
        at(State::VelY),  at(State::VelZ),    at(State::BendX), at(State::BendY), at(State::BendZ),
        at(State::RateX), at(State::RateY),   at(State::RateZ), body.dirX.data(), body.dirY.data(),
        body.dirZ.data(), body.length.data(), s.give.data(),    s.drag.data(),    s.weight.data(),
        in.held.data(),   s.keepXX.data(),    s.keepXV.data(),  s.keepVX.data(),  s.keepVV.data()};
    const WindField::Moment moment = in.wind.at(timeSeconds);
    const bool isParentFrame = in.params.restFrame == RestFrame::Parent;
    Around around;
    Index first = 0;
    for (const Index end : body.depthEnd)
        while (first < end) {
            const Index count = std::min(slotsAtATime, end - first);
            gatherParents(body, columns, isParentFrame, first, count, around);
            blow(in.wind, moment, first, count, around);
            stepBlock(columns, 1.0 / s.seconds, around, first, count);
            first += count;
        }
}

} // namespace ramure
