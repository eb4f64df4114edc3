#include "core/surface/check/collisions.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Parameters of the closest points of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
std::array<double, 2> closest(const glm::dvec3& p, const glm::dvec3& u, const glm::dvec3& q,
                              const glm::dvec3& v)
{
    const glm::dvec3 r = p - q;
    const double a = glm::dot(u, u), e = glm::dot(v, v), f = glm::dot(v, r);
    if (a <= 0.0 && e <= 0.0)
        return {0.0, 0.0};
    if (a <= 0.0)
        return {0.0, std::clamp(f / e, 0.0, 1.0)};
    const double c = glm::dot(u, r);
    if (e <= 0.0)
        return {std::clamp(-c / a, 0.0, 1.0), 0.0};
    const double b = glm::dot(u, v), denominator = a * e - b * b;
    const double s = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    const double t = (b * s + f) / e;
    if (t < 0.0)
        return {std::clamp(-c / a, 0.0, 1.0), 0.0};
    if (t > 1.0)
        return {std::clamp((b - c) / a, 0.0, 1.0), 1.0};
    return {s, t};
}

} // namespace

BranchTube branchTube(const BranchCurve& curve, double a0, double a1)
{
    BranchTube tube;
    for (std::size_t i = 0; i <= BranchTube::pieces; ++i) {
        const double t = double(i) / double(BranchTube::pieces);
        tube.points[i] = hermite(curve.h0, curve.h1, curve.v0, curve.v1, t).point;
        tube.radii[i] = a0 + (a1 - a0) * t;
    }
    return tube;
}

TubeContact tubeContact(const BranchTube& first, const BranchTube& second)
{
    TubeContact deepest;
    bool known = false;
    for (std::size_t i = 0; i < BranchTube::pieces; ++i)
        for (std::size_t k = 0; k < BranchTube::pieces; ++k) {
            const glm::dvec3 u = first.points[i + 1] - first.points[i];
            const glm::dvec3 v = second.points[k + 1] - second.points[k];
            const auto [s, t] = closest(first.points[i], u, second.points[k], v);
            TubeContact here;
            here.onFirst = first.points[i] + s * u;
            here.onSecond = second.points[k] + t * v;
            here.radiusFirst = first.radii[i] + s * (first.radii[i + 1] - first.radii[i]);
            here.radiusSecond = second.radii[k] + t * (second.radii[k + 1] - second.radii[k]);
            here.depth = here.radiusFirst + here.radiusSecond - glm::distance(here.onFirst, here.onSecond);
            if (!known || here.depth > deepest.depth)
                deepest = here;
            known = true;
        }
    return deepest;
}

std::vector<Collision> findCollisions(const Skeleton& skeleton, std::span<const CrossingBranches> crossings)
{
    const auto tubeOf = [&](Index branch) {
        return branchTube(branchCurve(skeleton, branch), skeleton.a0[branch], skeleton.a1[branch]);
    };
    std::vector<Collision> collisions;
    collisions.reserve(crossings.size());
    for (const CrossingBranches& pair : crossings) {
        const TubeContact contact = tubeContact(tubeOf(pair.first), tubeOf(pair.second));
        collisions.push_back(
            {pair.first, pair.second, pair.facePairs, pair.place, std::max(contact.depth, 0.0)});
    }
    std::stable_sort(collisions.begin(), collisions.end(),
                     [](const Collision& a, const Collision& b) { return a.depth > b.depth; });
    return collisions;
}

} // namespace ramure
