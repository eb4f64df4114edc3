#include "core/rig/physics/limb_fall.h"

#include "core/math/frame.h"
#include "core/math/reproducible.h"
#include "core/rig/physics/apple_fall.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr double longestStep = 0.005; ///< s; longer ones are several
constexpr int rounds = 12;            ///< of impulses in a step
constexpr int footPoints = 8;
/// Twigs give where an apple springs back, and catch where it rolls.
constexpr double bounceShare = 0.4, leastFriction = 0.6;
constexpr double slowImpact = 0.5; ///< m/s: slower ones do not bounce
/// Each second on the ground leaves so little of a motion, and each in the air of a turn.
constexpr double groundLoss = 3.0, airLoss = 0.2;
/// Slower than this, m/s at its ends, for so many seconds, and it rests.
constexpr double stillLimb = 0.03, stillSeconds = 0.3;
/// What stands upon its foot is pushed over, rad/s, and comes off once it leans so far (of its upright
/// height).
constexpr double push = 0.35, tearsOff = 0.25;

glm::dmat3 crossMatrix(const glm::dvec3& v)
{
    return {{0.0, v.z, -v.y}, {-v.z, 0.0, v.x}, {v.y, -v.x, 0.0}};
}

/// Of a point of mass 1.
glm::dmat3 inertiaOf(const glm::dvec3& at)
{
    return glm::dot(at, at) * glm::dmat3(1.0) - glm::outerProduct(at, at);
}

struct Lump
{
    glm::dvec3 at;
    double mass, radius;
};

/// Two of each branch, so that they turn as rods do.
std::array<Lump, 2> lumpsOf(const TreeBody& body, Index slot)
{
    const double r = 0.5 * (body.a0[slot] + body.a1[slot]);
    const double mass = 0.5 * (body.length[slot] + r) * (r * r + 1e-12);
    const double aside = 0.5 / std::numbers::sqrt3; // of the length: a rod's own radius of gyration
    const glm::dvec3 middle = 0.5 * (body.p0[slot] + body.p1[slot]),
                     way = aside * (body.p1[slot] - body.p0[slot]);
    return {Lump{middle - way, mass, r}, Lump{middle + way, mass, r}};
}

glm::dvec3 directionOf(const TreeBody& body, Index slot)
{
    return {body.dirX[slot], body.dirY[slot], body.dirZ[slot]};
}

void weigh(const TreeBody& body, const std::vector<Index>& slots, LooseBody& limb)
{
    double mass = 0.0;
    glm::dvec3 moment(0.0);
    for (const Index slot : slots)
        for (const Lump& lump : lumpsOf(body, slot)) {
            mass += lump.mass;
            moment += lump.mass * lump.at;
        }
    limb.centre = mass > 0.0 ? moment / mass : body.p0[limb.root];
    limb.inertia = glm::dmat3(mass > 0.0 ? 0.0 : 1.0);
    for (const Index slot : slots)
        for (const Lump& lump : lumpsOf(body, slot))
            if (mass > 0.0) {
                const double thick = 0.5 * lump.radius * lump.radius + 1e-9;
                limb.inertia +=
                    lump.mass / mass * (inertiaOf(lump.at - limb.centre) + thick * glm::dmat3(1.0));
            }
}

void findBalls(const TreeBody& body, const std::vector<Index>& slots, LooseBody& limb)
{
    limb.foot = body.p0[limb.root];
    const Frame frame = frameFromTangent(directionOf(body, limb.root));
    for (int i = 0; i < footPoints; ++i) {
        const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * i / footPoints);
        const glm::dvec3 out = cosine * frame.normal + sine * frame.binormal;
        limb.balls.emplace_back(limb.foot + body.a0[limb.root] * out - limb.centre, 0.0);
    }
    for (const Index slot : slots)
        limb.balls.emplace_back(body.p1[slot] - limb.centre, body.a1[slot]);
}

/// Whether the way down from a limb's stump comes back to it.
bool holdsItself(const TreeBody& body, Index limb)
{
    Index at = limb;
    for (std::size_t i = 0; i <= body.limbs.size(); ++i) {
        const Index stump = body.limbs[at].stump;
        if (stump == noIndex || body.limbOf[stump] == noIndex)
            return false;
        at = body.limbOf[stump];
        if (at == limb)
            return true;
    }
    return true;
}

struct Contact
{
    glm::dvec3 lever;   ///< from the centre
    double speed = 0.0; ///< m/s, upwards, that it is to have
    double pressed = 0.0;
    glm::dvec2 rubbed{0.0};
};

/// One step of a body of 1 kg.
class LimbStep
{
public:
    LimbStep(const LooseBody& body, const PhysicsParams& params, double h, FallingLimb& limb)
        : m_body(body)
        , m_limb(limb)
        , m_gravity(earthGravity * params.gravity)
        , m_bounce(bounceShare * params.appleBounce)
        , m_friction(std::max(params.appleFriction, leastFriction))
        , m_h(h)
    {
    }

    void run()
    {
        m_limb.velocity.y -= m_gravity * m_h;
        m_limb.spin *= std::max(1.0 - airLoss * m_h, 0.0);
        findContacts();
        const bool tears = m_limb.phase == LimbPhase::Tearing;
        for (int i = 0; i < rounds && (tears || !m_contacts.empty()); ++i) {
            if (tears)
                holdFoot();
            for (Contact& contact : m_contacts)
                solve(contact);
        }
        if (!m_contacts.empty()) {
            const double kept = std::max(1.0 - groundLoss * m_h, 0.0);
            m_limb.velocity *= kept;
            m_limb.spin *= kept;
        }
        move(tears);
        lift();
    }

private:
    [[nodiscard]] glm::dvec3 speedAt(const glm::dvec3& lever) const
    {
        return m_limb.velocity + glm::cross(m_limb.spin, lever);
    }
    void push(const glm::dvec3& impulse, const glm::dvec3& lever)
    {
        m_limb.velocity += impulse;
        m_limb.spin += m_inverse * glm::cross(lever, impulse);
    }
    /// What of a push along \p way at \p lever becomes speed there.
    [[nodiscard]] double give(const glm::dvec3& way, const glm::dvec3& lever) const
    {
        return 1.0 + glm::dot(glm::cross(m_inverse * glm::cross(lever, way), lever), way);
    }

    /// Whatever would come below the ground in this step.
    void findContacts()
    {
        const glm::dmat3 turn = glm::mat3_cast(m_limb.rotation);
        m_inverse = turn * glm::inverse(m_body.inertia) * glm::transpose(turn);
        for (const auto& [at, radius] : m_body.balls) {
            const glm::dvec3 lever = turn * at - glm::dvec3(0.0, radius, 0.0);
            const double speed = speedAt(lever).y, height = std::max(m_limb.centre.y + lever.y, 0.0);
            if (height + m_h * speed > 0.0)
                continue;
            // Down to the ground and no further.
            m_contacts.push_back({lever, speed < -slowImpact ? -m_bounce * speed : -height / m_h});
        }
    }

    void solve(Contact& contact)
    {
        const glm::dvec3 up(0.0, 1.0, 0.0);
        const double wanted = contact.speed - speedAt(contact.lever).y;
        const double before = contact.pressed;
        contact.pressed = std::max(before + wanted / give(up, contact.lever), 0.0);
        push((contact.pressed - before) * up, contact.lever);
        const double most = m_friction * contact.pressed;
        const std::array<glm::dvec3, 2> ways{glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)};
        for (int i = 0; i < 2; ++i) {
            const glm::dvec3& way = ways[std::size_t(i)];
            const double rubbed = contact.rubbed[i];
            const double slide = glm::dot(speedAt(contact.lever), way);
            contact.rubbed[i] = std::clamp(rubbed - slide / give(way, contact.lever), -most, most);
            push((contact.rubbed[i] - rubbed) * way, contact.lever);
        }
    }

    /// The foot stays where it was cut.
    void holdFoot()
    {
        const glm::dvec3 lever = m_limb.rotation * (m_body.foot - m_body.centre);
        const glm::dmat3 cross = crossMatrix(lever);
        const glm::dmat3 give = glm::dmat3(1.0) - cross * m_inverse * cross;
        push(-(glm::inverse(give) * speedAt(lever)), lever);
    }

    void move(bool tears)
    {
        const auto foot = [this] { return m_limb.centre + m_limb.rotation * (m_body.foot - m_body.centre); };
        const glm::dvec3 stood = foot();
        m_limb.centre += m_h * m_limb.velocity;
        const double angle = glm::length(m_limb.spin) * m_h;
        if (angle > 0.0)
            m_limb.rotation = glm::normalize(maths::angleAxis(angle, m_limb.spin / glm::length(m_limb.spin)) *
                                             m_limb.rotation);
        if (!tears)
            return;
        m_limb.centre += stood - foot();
        if (m_limb.centre.y - stood.y < tearsOff * glm::distance(m_limb.centre, stood))
            m_limb.phase = LimbPhase::Falling;
    }

    void lift()
    {
        const glm::dmat3 turn = glm::mat3_cast(m_limb.rotation);
        double lowest = 0.0;
        for (const auto& [at, radius] : m_body.balls)
            lowest = std::min(lowest, m_limb.centre.y + (turn * at).y - radius);
        m_limb.centre.y -= lowest;
        // What the impulses have left of the fall is none.
        if (m_limb.velocity.y < 0.0)
            m_limb.velocity.y = std::min(m_limb.velocity.y - lowest / m_h, 0.0);
    }

    const LooseBody& m_body;
    FallingLimb& m_limb;
    double m_gravity, m_bounce, m_friction, m_h;
    glm::dmat3 m_inverse{1.0}; ///< of the inertia, tree space
    std::vector<Contact> m_contacts;
};

double reachOf(const LooseBody& body)
{
    double reach = 0.0;
    for (const auto& [at, radius] : body.balls)
        reach = std::max(reach, glm::length(at) + radius);
    return reach;
}

/// Low enough to lie on something.
bool isDown(const LooseBody& body, const FallingLimb& limb)
{
    double lowest = limb.centre.y;
    for (const auto& [at, radius] : body.balls)
        lowest = std::min(lowest, limb.centre.y + (limb.rotation * at).y - radius);
    return lowest < 1e-3 * reachOf(body) + 1e-6;
}

} // namespace

void takeLimbs(const std::vector<LooseLimb>& limbs, TreeBody& body)
{
    for (const LooseLimb& limb : limbs) {
        LooseBody own;
        own.root = body.slotOf[limb.first];
        own.stump = limb.stump == noIndex ? noIndex : body.slotOf[limb.stump];
        own.seconds = limb.seconds;
        body.limbs.push_back(own);
    }
    if (body.limbs.empty())
        return;
    body.limbOf.assign(body.size(), noIndex);
    for (Index i = 0; i < body.limbs.size(); ++i)
        body.limbOf[body.limbs[i].root] = i;
    std::vector<std::vector<Index>> slots(body.limbs.size());
    for (Index slot = 0; slot < body.size(); ++slot) {
        if (const Index parent = body.parent[slot]; parent != noIndex)
            body.limbOf[slot] = body.limbOf[parent];
        if (body.limbOf[slot] != noIndex)
            slots[body.limbOf[slot]].push_back(slot);
    }
    for (Index i = 0; i < body.limbs.size(); ++i) {
        weigh(body, slots[i], body.limbs[i]);
        findBalls(body, slots[i], body.limbs[i]);
    }
    for (Index i = 0; i < body.limbs.size(); ++i)
        if (holdsItself(body, i))
            body.limbs[i].stump = noIndex;
}

void letGo(const LooseBody& body, const RigidTransform& held, const glm::dvec3& velocity, FallingLimb& limb)
{
    limb.rotation = held.rotation;
    limb.centre = held.point(body.centre);
    limb.velocity = velocity;
    limb.spin = glm::dvec3(0.0);
    limb.calm = 0;
    const glm::dvec3 up = limb.centre - held.point(body.foot);
    const bool stands = up.y > tearsOff * glm::length(up);
    limb.phase = stands ? LimbPhase::Tearing : LimbPhase::Falling;
    if (!stands)
        return;
    // Over to the side that it leans to.
    const double lean = maths::hypot(up.x, up.z);
    const glm::dvec3 side =
        lean > 1e-9 * up.y ? glm::dvec3(up.x, 0.0, up.z) / lean : glm::dvec3(1.0, 0.0, 0.0);
    limb.spin = push * glm::cross(glm::dvec3(0.0, 1.0, 0.0), side);
    limb.velocity = glm::cross(limb.spin, up);
}

void stepLimb(const LooseBody& body, const PhysicsParams& params, double seconds, FallingLimb& limb)
{
    const bool falls = limb.phase == LimbPhase::Tearing || limb.phase == LimbPhase::Falling;
    if (!falls || !(params.gravity > 0.0))
        return;
    const FallingLimb before = limb;
    const auto steps = static_cast<int>(std::ceil(seconds / longestStep));
    for (int i = 0; i < steps; ++i)
        LimbStep(body, params, seconds / steps, limb).run();
    const glm::dquat turn = limb.rotation - before.rotation; // half the angle, where that is small
    const double speed =
        (glm::distance(limb.centre, before.centre) + 2.0 * std::sqrt(glm::dot(turn, turn)) * reachOf(body)) /
        seconds;
    const bool isCalm = speed < stillLimb && isDown(body, limb);
    limb.calm = isCalm ? limb.calm + 1 : 0;
    if (static_cast<double>(limb.calm) * seconds >= stillSeconds) {
        limb.phase = LimbPhase::Resting;
        limb.velocity = limb.spin = glm::dvec3(0.0);
    }
}

} // namespace ramure
