#include "core/rig/physics/fruit_swing.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr glm::dvec3 down{0.0, -1.0, 0.0};
constexpr double supple = 0.85;  ///< share of the way that a stalk gives
constexpr double airPull = 0.25; ///< of its weight, by m/s
constexpr double fastTwig = 3.0; ///< m/s; faster ones fling their fruit no further
constexpr double upsideDown = -0.98;

} // namespace

RigidTransform hungFruit(const RigidTransform& branch, const glm::dvec3& foot, const glm::dvec3& carried)
{
    const glm::dvec3 now = branch.direction(down);
    const glm::dvec3 air = airPull / (1.0 + glm::length(carried) / fastTwig) * carried;
    const glm::dvec3 wanted = glm::normalize(down - air);
    const glm::dvec3 given = (1.0 - supple) * now + supple * wanted;
    const double length = glm::length(given);
    if (glm::dot(now, wanted) < upsideDown || length < 1e-9)
        return branch; // which way round? It lies on its twig
    const glm::dvec3 hung = given / length;
    // The shortest turn from one to the other.
    const glm::dquat turn = glm::normalize(glm::dquat(1.0 + glm::dot(now, hung), glm::cross(now, hung)));
    RigidTransform out;
    out.rotation = turn * branch.rotation;
    out.translation = branch.point(foot) - out.rotation * foot;
    return out;
}

FruitSwing::FruitSwing(const Foliage& foliage, double alpha)
{
    if (foliage.fruit.kind == FruitKind::Faithful || !hangs(foliage.fruit.kind))
        return;
    const double length = fruitRadius(foliage.fruit, alpha) * fruitReach(foliage.fruit);
    for (const FoliageItem& fruit : foliage.apples) {
        const double own = length * double(fruit.size);
        m_feet.push_back(fruit.position + fruit.orientation * glm::dvec3(0.0, own, 0.0));
        m_branches.push_back(fruit.branch);
        m_reach = std::max(m_reach, own);
    }
}

std::vector<glm::dvec3> FruitSwing::carried(const TreeBody& body, const PhysicsState& state) const
{
    std::vector<glm::dvec3> out(m_feet.size(), glm::dvec3(0.0));
    if (state.mode != PhysicsMode::Robust) // the faithful step's speeds are others
        return out;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Index slot = body.slotOf[m_branches[i]];
        out[i] = {state.channel(PhysicsState::VelX)[slot], state.channel(PhysicsState::VelY)[slot],
                  state.channel(PhysicsState::VelZ)[slot]};
    }
    return out;
}

void FruitSwing::pose(std::span<const glm::dvec3> carried, std::span<RigidTransform> bones) const
{
    for (std::size_t i = 0; i < m_feet.size(); ++i)
        bones[i] = hungFruit(bones[i], m_feet[i], carried[i]);
}

} // namespace ramure
