#include "core/rig/physics/tree_physics.h"

#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/rig/physics/apple_fall.h"
#include "core/rig/physics/faithful_step.h"
#include "core/rig/physics/limb_fall.h"
#include "core/rig/physics/robust_step.h"
#include <algorithm>
#include <cmath>
#include <string_view>

namespace ramure {
namespace {

PhysicsParams clamped(const PhysicsParams& params)
{
    NodeParams node;
    node.physics = params;
    for (const ParamDef& def : paramTable())
        if (std::string_view(def.key).starts_with("physics."))
            def.assign(node, clampValue(def, def.get(node)));
    return node.physics;
}

glm::dquat rotationOf(const PhysicsState& state, Index slot)
{
    return {state.channel(PhysicsState::RotW)[slot], state.channel(PhysicsState::RotX)[slot],
            state.channel(PhysicsState::RotY)[slot], state.channel(PhysicsState::RotZ)[slot]};
}

glm::dvec3 vectorOf(const PhysicsState& state, PhysicsState::Channel x, Index slot)
{
    return {state.channel(x)[slot], state.channel(x + 1)[slot], state.channel(x + 2)[slot]};
}

void setVector(PhysicsState& state, PhysicsState::Channel x, Index slot, const glm::dvec3& value)
{
    for (int i = 0; i < 3; ++i)
        state.channel(x + i)[slot] = value[i];
}

glm::dvec3 restDirection(const TreeBody& body, Index slot)
{
    return {body.dirX[slot], body.dirY[slot], body.dirZ[slot]};
}

/// The frame that a branch rests in.
glm::dquat frameOf(const TreeBody& body, const PhysicsState& state, const PhysicsParams& params, Index slot)
{
    const bool isFixed = body.parent[slot] == noIndex || params.restFrame == RestFrame::World;
    return isFixed ? glm::dquat(1.0, 0.0, 0.0, 0.0) : rotationOf(state, body.parent[slot]);
}

glm::dvec3 p0Of(const TreeBody& body, const PhysicsState& state, Index slot)
{
    glm::dvec3 below(0.0);
    Index root = slot;
    for (Index at = body.parent[slot]; at != noIndex; at = body.parent[at]) {
        below += rotationOf(state, at) * (body.p0[root] - body.p0[at]);
        root = at;
    }
    return body.p0[root] + below;
}

RigidTransform boneOf(const TreeBody& body, const PhysicsState& state, Index slot)
{
    const glm::dquat rotation = rotationOf(state, slot);
    return {rotation, p0Of(body, state, slot) - rotation * body.p0[slot]};
}

/// How far a limb has come from where its branches would be if it were still held.
RigidTransform limbPose(const TreeBody& body, const PhysicsState& state, Index limb)
{
    const LooseBody& own = body.limbs[limb];
    const FallingLimb& now = state.limbs[limb];
    if (now.phase != LimbPhase::Hanging)
        return {now.rotation, now.centre - now.rotation * own.centre};
    if (own.stump == noIndex)
        return {};
    const RigidTransform held = boneOf(body, state, own.stump);
    const Index below = body.limbOf[own.stump];
    return below == noIndex ? held : limbPose(body, state, below) * held;
}

void stepLimbs(const TreeBody& body, const PhysicsParams& params, PhysicsState& state)
{
    for (Index i = 0; i < body.limbs.size(); ++i) {
        const LooseBody& limb = body.limbs[i];
        FallingLimb& now = state.limbs[i];
        if (now.phase == LimbPhase::Hanging && state.timeSeconds >= limb.seconds)
            letGo(limb, limbPose(body, state, i),
                  limb.stump == noIndex ? glm::dvec3(0.0) : vectorOf(state, PhysicsState::VelX, limb.stump),
                  now);
        stepLimb(limb, params, params.stepSeconds, now);
    }
}

bool isOff(const TreeBody& body, Index slot)
{
    return !body.limbOf.empty() && body.limbOf[slot] != noIndex;
}

/// Springs know bends where the faithful step knows only directions, and the other way round.
void convert(const TreeBody& body, const PhysicsParams& params, PhysicsState& state)
{
    const PhysicsState old = state;
    state.mode = params.mode;
    state.values.resize(std::size_t(state.channels()) * state.slotCount);
    for (Index slot = 0; slot < state.slotCount; ++slot) {
        if (params.mode == PhysicsMode::Faithful) {
            const Index parent = body.parent[slot];
            const glm::dvec3 carried =
                parent == noIndex ? glm::dvec3(0.0) : vectorOf(old, PhysicsState::VelX, parent);
            setVector(state, PhysicsState::VelX, slot, vectorOf(old, PhysicsState::VelX, slot) - carried);
            continue;
        }
        const glm::dvec3 rest = restDirection(body, slot);
        const glm::dvec3 now =
            glm::conjugate(frameOf(body, old, params, slot)) * (rotationOf(old, slot) * rest);
        const double whole = std::max(1.0 + glm::dot(rest, now), 0.05);
        setVector(state, PhysicsState::BendX, slot, glm::cross(rest, now) / whole);
        setVector(state, PhysicsState::RateX, slot, glm::dvec3(0.0));
    }
}

} // namespace

void StepRotations::resize(std::size_t count)
{
    w.resize(count);
    x.resize(count);
    y.resize(count);
    z.resize(count);
}

Masses massesOf(const TreeBody& body, double appleMass, std::vector<Index> loose)
{
    Masses out{std::move(loose), body.a1, body.a1, {}};
    for (Index apple = 0; apple < body.appleSlot.size(); ++apple)
        if (!std::ranges::binary_search(out.loose, apple))
            out.mass[body.appleSlot[apple]] += appleMass;
    for (Index slot = body.size(); slot-- > 0;)
        if (const Index parent = body.parent[slot]; parent != noIndex) {
            out.mass[parent] += out.mass[slot];
            out.bare[parent] += out.bare[slot];
        }
    // A twig without any thickness has no mass: the wind leaves it alone rather than blow it to infinity.
    for (const double mass : out.mass)
        out.windage.push_back(mass > 0.0 ? 1.0 / std::sqrt(mass) : 0.0);
    return out;
}

struct TreePhysics::Prepared
{
    PhysicsParams params;
    Masses masses;
    Springs springs;
    WindField wind;
    StepRotations rotations;
    HeldWeight heldFor;
    std::vector<double> held; ///< for heldFor
    bool hasMasses = false, hasSprings = false, hasWind = false;

    void setParams(const PhysicsParams& next)
    {
        hasMasses = hasMasses && next.appleMass == params.appleMass;
        hasSprings = hasSprings && next.gravity == params.gravity && next.damping == params.damping &&
                     next.restitution == params.restitution && next.stepSeconds == params.stepSeconds &&
                     next.substeps == params.substeps;
        hasWind = false;
        params = next;
    }

    void prepare(const TreeBody& body, const PhysicsState& state)
    {
        const auto sameApples = [&] {
            return masses.loose.size() == state.loose.size() &&
                   std::ranges::all_of(state.loose, [&](const LooseApple& apple) {
                       return std::ranges::binary_search(masses.loose, apple.apple);
                   });
        };
        if (!hasMasses || !sameApples()) {
            std::vector<Index> loose;
            for (const LooseApple& apple : state.loose)
                loose.push_back(apple.apple);
            std::ranges::sort(loose);
            masses = massesOf(body, params.appleMass, std::move(loose));
            hasMasses = true;
            hasSprings = false;
        }
        if (params.mode == PhysicsMode::Faithful)
            return;
        if (!hasSprings)
            springs = springsOf(body, params, masses);
        if (held.size() != body.size() || heldFor != state.held)
            held = heldLoads(body, heldFor = state.held);
        if (!hasWind)
            wind.setParams(body, params);
        hasSprings = hasWind = true;
    }
};

TreePhysics::TreePhysics(std::shared_ptr<const TreeBody> body, const PhysicsParams& params)
    : m_body(std::move(body))
    , m_prepared(std::make_unique<Prepared>())
{
    setParams(params);
}

TreePhysics::~TreePhysics() = default;
TreePhysics::TreePhysics(TreePhysics&&) noexcept = default;
TreePhysics& TreePhysics::operator=(TreePhysics&&) noexcept = default;

const TreeBody& TreePhysics::body() const
{
    return *m_body;
}

const PhysicsParams& TreePhysics::params() const
{
    return m_prepared->params;
}

void TreePhysics::setParams(const PhysicsParams& params)
{
    m_prepared->setParams(clamped(params));
}

PhysicsState TreePhysics::restState() const
{
    PhysicsState state;
    state.mode = params().mode;
    state.held = heldWeight(params());
    state.slotCount = m_body->size();
    state.clockStepSeconds = params().stepSeconds;
    state.limbs.resize(m_body->limbs.size());
    state.values.assign(std::size_t(state.channels()) * state.slotCount, 0.0);
    std::ranges::fill(state.channel(PhysicsState::RotW), 1.0);
    return state;
}

namespace {

/// A spring from a point of a branch to the hand acts on that branch and on all that carry it.
struct Grip
{
    const TreeBody& body;
    const PhysicsParams& params;
    const Springs& springs;
    Index held = 0;
    glm::dvec3 point{0.0}; ///< where the branch is held
    glm::dvec3 force{0.0}; ///< towards the hand, m
};

/// By each branch's share of the way.
void pullFaithfully(const Grip& grip, PhysicsState& state)
{
    for (Index slot = grip.held; slot != noIndex; slot = grip.body.parent[slot]) {
        const double reach = grip.body.reach[slot];
        if (!(grip.body.length[slot] > 0.0))
            continue;
        const double kick = 300.0 * grip.body.a0[slot] * grip.params.stepSeconds / 0.01;
        setVector(state, PhysicsState::VelX, slot,
                  vectorOf(state, PhysicsState::VelX, slot) +
                      kick * grip.body.length[slot] / (reach * reach) * grip.force);
    }
}

/// By its lever: so the hand takes from the swing what it does not put in.
void pullRobustly(const Grip& grip, PhysicsState& state)
{
    glm::dvec3 p0 = p0Of(grip.body, state, grip.held);
    for (Index slot = grip.held, above = noIndex; slot != noIndex;
         above = slot, slot = grip.body.parent[slot]) {
        if (above != noIndex)
            p0 -= rotationOf(state, slot) * (grip.body.p0[above] - grip.body.p0[slot]);
        const double reach = grip.body.reach[slot];
        if (!(grip.body.length[slot] > 0.0))
            continue;
        // As much as a spring would turn it, but never so much at once that it overshoots.
        const double rate = grip.springs.rate[slot], h = grip.params.stepSeconds;
        const double gain =
            std::min(rate * rate * h, 0.15 / h) * grip.body.length[slot] / (reach * reach * reach);
        const glm::dvec3 rest = restDirection(grip.body, slot);
        glm::dvec3 turn = glm::conjugate(frameOf(grip.body, state, grip.params, slot)) *
                          glm::cross(grip.point - p0, grip.force);
        turn -= glm::dot(turn, rest) * rest; // branches bend, they do not twist
        setVector(state, PhysicsState::RateX, slot, vectorOf(state, PhysicsState::RateX, slot) + gain * turn);
    }
}

void pullBranches(const TreeBody& body, const PhysicsParams& params, const Pull& pull, const Springs& springs,
                  PhysicsState& state)
{
    if (pull.branch >= body.size() || isOff(body, body.slotOf[pull.branch]))
        return;
    Grip grip{body, params, springs, body.slotOf[pull.branch]};
    const glm::dvec3 along = std::clamp(pull.along, 0.0, 1.0) * (body.p1[grip.held] - body.p0[grip.held]);
    grip.point = p0Of(body, state, grip.held) + rotationOf(state, grip.held) * along;
    const glm::dvec3 way = pull.target - grip.point;
    if (!(glm::dot(way, way) < 1e12)) // far away, or no number
        return;
    grip.force = std::clamp(pull.strength, 0.0, 100.0) * way;
    if (params.mode == PhysicsMode::Faithful)
        return pullFaithfully(grip, state);
    // A hand is no spring of steel: it gives where the branch swings.
    grip.force -= 0.5 / springs.rate[grip.held] * std::clamp(pull.strength, 0.0, 2.0) *
                  vectorOf(state, PhysicsState::VelX, grip.held);
    pullRobustly(grip, state);
}

} // namespace

void TreePhysics::step(PhysicsState& state, const std::optional<Pull>& pull)
{
    Prepared& p = *m_prepared;
    p.prepare(*m_body, state);
    if (state.mode != p.params.mode)
        convert(*m_body, p.params, state);
    if (state.clockStepSeconds != p.params.stepSeconds) {
        state.clockTime = state.timeSeconds;
        state.clockStep = state.step;
        state.clockStepSeconds = p.params.stepSeconds;
    }
    if (pull)
        pullBranches(*m_body, p.params, *pull, p.springs, state);
    const StepInputs in{*m_body, p.params, p.masses, p.springs, p.held, p.wind, p.rotations};
    if (p.params.mode == PhysicsMode::Faithful)
        faithfulStep(in, state);
    else
        for (std::int64_t i = 0; i < p.params.substeps; ++i)
            robustStep(in, state, state.timeSeconds + static_cast<double>(i) * p.springs.seconds);
    for (LooseApple& apple : state.loose)
        stepLooseApple(apple, p.params, m_body->appleRadius, p.params.stepSeconds);
    stepLimbs(*m_body, p.params, state);
    ++state.step;
    state.timeSeconds =
        state.clockTime + static_cast<double>(state.step - state.clockStep) * state.clockStepSeconds;
}

void TreePhysics::shakeOff(PhysicsState& state, Index apple) const
{
    const bool isLoose =
        std::ranges::any_of(state.loose, [&](const LooseApple& l) { return l.apple == apple; });
    if (apple >= m_body->appleSlot.size() || isLoose)
        return;
    const Index slot = m_body->appleSlot[apple];
    const glm::dquat rotation = rotationOf(state, slot);
    LooseApple loose;
    loose.apple = apple;
    loose.position =
        p0Of(*m_body, state, slot) + rotation * (m_body->applePosition[apple] - m_body->p0[slot]);
    loose.orientation = glm::normalize(rotation * m_body->appleOrientation[apple]);
    loose.velocity = vectorOf(state, PhysicsState::VelX, slot);
    if (isOff(*m_body, slot)) {
        const Index limb = m_body->limbOf[slot];
        const RigidTransform carried = limbPose(*m_body, state, limb);
        loose.position = carried.point(loose.position);
        loose.orientation = glm::normalize(carried.rotation * loose.orientation);
        loose.velocity += state.limbs[limb].velocity;
    }
    state.loose.push_back(loose);
}

void TreePhysics::pose(const PhysicsState& state, Pose& out) const
{
    const TreeBody& body = *m_body;
    out.timeSeconds = state.timeSeconds;
    out.bones.resize(body.size());
    for (Index slot = 0; slot < body.size(); ++slot) {
        const Index parent = body.parent[slot];
        const glm::dvec3& rest = body.p0[slot];
        const glm::dvec3 p0 = parent == noIndex ? rest : out.bones[body.branchOf[parent]].point(rest);
        const glm::dquat rotation = rotationOf(state, slot);
        out.bones[body.branchOf[slot]] = {rotation, p0 - rotation * rest};
    }
    if (body.limbs.empty() || state.step == 0)
        return;
    std::vector<RigidTransform> limbs;
    for (Index i = 0; i < body.limbs.size(); ++i)
        limbs.push_back(limbPose(body, state, i));
    for (Index slot = 0; slot < body.size(); ++slot)
        if (isOff(body, slot)) {
            RigidTransform& bone = out.bones[body.branchOf[slot]];
            bone = limbs[body.limbOf[slot]] * bone;
        }
}

std::vector<RigidTransform> TreePhysics::loosePoses(const PhysicsState& state) const
{
    std::vector<RigidTransform> out;
    for (const LooseApple& apple : state.loose) {
        const glm::dquat rotation = apple.orientation * glm::conjugate(m_body->appleOrientation[apple.apple]);
        out.push_back({rotation, apple.position - rotation * m_body->applePosition[apple.apple]});
    }
    return out;
}

PhysicsFigures TreePhysics::figures(const PhysicsState& state) const
{
    const TreeBody& body = *m_body;
    m_prepared->prepare(body, state);
    PhysicsFigures out;
    Pose now;
    pose(state, now);
    double smallestCosine = 1.0;
    for (Index slot = 0; slot < body.size(); ++slot) {
        const RigidTransform& bone = now.bones[body.branchOf[slot]];
        const glm::dvec3 way = bone.point(body.p1[slot]) - bone.point(body.p0[slot]);
        const glm::dvec3 velocity = vectorOf(state, PhysicsState::VelX, slot);
        out.kineticEnergy += 0.5 * m_prepared->masses.mass[slot] * glm::dot(velocity, velocity);
        if (!(body.length[slot] > 0.0))
            continue;
        const double length = glm::length(way);
        out.lengthError = std::max(out.lengthError, std::abs(length / body.length[slot] - 1.0));
        smallestCosine = std::min(smallestCosine, glm::dot(way, restDirection(body, slot)) / length);
    }
    out.largestTurnRad = maths::acos(std::max(smallestCosine, -1.0));
    if (body.size() > 0)
        out.tip = now.bones[body.branchOf[body.firstTerminal]].point(body.p1[body.firstTerminal]);
    return out;
}

double TreePhysics::swingRate(Index branch) const
{
    if (branch >= m_body->size())
        return 0.0;
    Prepared& p = *m_prepared;
    if (!p.hasMasses)
        p.masses = massesOf(*m_body, p.params.appleMass, p.masses.loose);
    if (!p.hasSprings)
        p.springs = springsOf(*m_body, p.params, p.masses);
    p.hasMasses = p.hasSprings = true;
    return p.springs.rate[m_body->slotOf[branch]];
}

} // namespace ramure
