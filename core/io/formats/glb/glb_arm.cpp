#include "core/io/formats/glb/glb_arm.h"

#include "core/math/reproducible.h"
#include "core/rig/arm/arm_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

namespace ramure::glb {

namespace {

/// Turns that lead a chain, Z up, along directions one after the other. \param directions unit
void setDirections(std::span<ArmJoint> joints, std::span<const glm::dvec3> directions)
{
    glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const glm::dvec3 own(glm::dot(directions[j], x), glm::dot(directions[j], y),
                             glm::dot(directions[j], z));
        const double across = maths::hypot(own.x, own.y);
        // A straight one need not turn, and a turn about itself is not seen.
        const double phi = across < 1e-9 ? 0.0 : maths::atan2(own.y, own.x);
        const double theta = across < 1e-9 && own.z > 0.0 ? 0.0 : maths::atan2(across, own.z);
        joints[j].phi.angleRad = phi;
        joints[j].theta.angleRad = theta;
        const auto [sp, cp] = maths::sincos(phi);
        const auto [st, ct] = maths::sincos(theta);
        const glm::dvec3 turned = cp * x + sp * y;
        y = cp * y - sp * x;
        x = ct * turned - st * z;
        z = st * turned + ct * z;
    }
}

/// How far the vertices that mostly follow a joint go from it along a direction.
double reachOf(const ReadGlbMesh& mesh, Index joint, const glm::dvec3& from, const glm::dvec3& direction)
{
    double most = 0.0;
    for (const Primitive& primitive : mesh.primitives)
        for (std::size_t v = 0; v < primitive.joints.size(); ++v)
            for (int k = 0; k < 4; ++k)
                if (primitive.joints[v][k] == joint && primitive.weights[v][k] >= 0.5F)
                    most = std::max(most, glm::dot(glm::dvec3(primitive.positions[v]) - from, direction));
    return most;
}

/// A chain's own axis where there is nothing else to tell its direction: Y, as most programs have it.
glm::dvec3 axisOf(const glm::dmat4& joint)
{
    const glm::dvec3 y(joint[1]);
    return glm::length(y) > 0.0 ? glm::normalize(y) : glm::dvec3(0.0, 1.0, 0.0);
}

/// Points from the foot to the tip, as the mesh was bound.
std::vector<glm::dvec3> pointsOf(const Chain& chain, const ReadGlbMesh& mesh)
{
    std::vector<glm::dvec3> points;
    for (const glm::dmat4& bind : chain.binds)
        points.emplace_back(bind[3]);
    const std::size_t last = points.size() - 1;
    const glm::dvec3 step = last > 0 ? points[last] - points[last - 1] : glm::dvec3(0.0);
    const double length = glm::length(step);
    const glm::dvec3 direction = length > 0.0 ? step / length : axisOf(chain.binds[last]);
    const double reach = reachOf(mesh, chain.order[last], points[last], direction);
    points.push_back(points[last] + direction * (reach > 0.0 ? reach : length > 0.0 ? length : 1.0));
    return points;
}

/// The shortest turn of Z to a direction.
glm::dmat3 turnOfZ(const glm::dvec3& to)
{
    const glm::dvec3 z(0.0, 0.0, 1.0);
    if (to.z < -1.0 + 1e-12)
        return {{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};
    const glm::dvec3 axis = glm::cross(z, to);
    return glm::mat3_cast(glm::normalize(glm::dquat(1.0 + to.z, axis.x, axis.y, axis.z)));
}

/// The same direction by an angle that is nearest to another one.
double nearest(double angle, double to)
{
    constexpr double turn = 2.0 * std::numbers::pi;
    return angle + turn * std::round((to - angle) / turn);
}

/// Of vertices that follow more than one segment how far they are from the nearest joint between two, at
/// most.
double windowOf(const ReadGlbMesh& straight, std::span<const ArmJoint> joints)
{
    double most = 0.0;
    for (const Primitive& primitive : straight.primitives)
        for (std::size_t v = 0; v < primitive.weights.size(); ++v) {
            const glm::vec4& weights = primitive.weights[v];
            if (std::max({weights.x, weights.y, weights.z, weights.w}) > 0.99F)
                continue;
            double height = 0.0, least = std::numeric_limits<double>::max();
            for (std::size_t j = 0; j + 1 < joints.size(); ++j) {
                height += joints[j].length;
                least = std::min(least, std::abs(double(primitive.positions[v].z) - height));
            }
            most = joints.size() > 1 ? std::max(most, least) : most;
        }
    return most;
}

} // namespace

void poseArm(const ChainArm& arm, const Chain& chain, std::span<const glm::dmat4> transforms,
             std::span<ArmJoint> joints)
{
    glm::dmat3 frame(1.0);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const glm::dmat4 moved = transforms[j] * glm::inverse(chain.binds[j]);
        const glm::dmat3 own =
            glm::transpose(frame) * glm::transpose(arm.upright) * glm::dmat3(moved) * arm.axes[j];
        const glm::dvec3 z = glm::normalize(own[2]);
        const double across = maths::hypot(z.x, z.y);
        // A turn half around, bent the other way, looks the same but for the roll: Y tells which one it is. A
        // straight joint has no other direction for its turn.
        double phi = maths::atan2(-own[1].x, own[1].y), theta = maths::atan2(across, z.z);
        if (across > 1e-6) {
            const double seen = maths::atan2(z.y, z.x);
            const bool isOther = maths::sincos(seen - phi).cos < 0.0;
            phi = isOther ? seen + std::numbers::pi : seen;
            theta = isOther ? -theta : theta;
        }
        joints[j].phi.angleRad = nearest(phi, joints[j].phi.angleRad);
        joints[j].theta.angleRad = theta;
        const auto [sp, cp] = maths::sincos(phi);
        const auto [st, ct] = maths::sincos(theta);
        frame = frame * glm::dmat3(cp, sp, 0.0, -sp, cp, 0.0, 0.0, 0.0, 1.0) *
                glm::dmat3(ct, 0.0, -st, 0.0, 1.0, 0.0, st, 0.0, ct);
    }
}

std::vector<Index> chainOf(const std::vector<Index>& parents)
{
    std::vector<Index> child(parents.size(), noIndex), out;
    Index at = noIndex;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        Index& place = parents[i] == noIndex ? at : child[parents[i]];
        if (place != noIndex)
            return {};
        place = static_cast<Index>(i);
    }
    for (; at != noIndex && out.size() <= parents.size(); at = child[at])
        out.push_back(at);
    return out.size() == parents.size() ? out : std::vector<Index>();
}

Expected<ChainArm> armOf(const Chain& chain, ReadGlbMesh& mesh, const std::string& place)
{
    const std::size_t count = chain.order.size();
    if (count == 0 || count > mostArmJoints)
        return wrong(place, RAMURE_NOOP("%1 joints: an arm has 1 to %2"),
                     {std::to_string(count), std::to_string(mostArmJoints)});
    const std::vector<glm::dvec3> points = pointsOf(chain, mesh);
    std::vector<glm::dmat4> moved;
    for (std::size_t j = 0; j < count; ++j)
        moved.push_back(chain.transforms[j] * glm::inverse(chain.binds[j]));
    const glm::dvec3 first = points[1] - points[0];
    if (!(glm::length(first) > 1e-9))
        return wrong(place, RAMURE_NOOP("two joints at one place"));
    // The arm stands up as its first segment was bound, and the mesh comes as that segment has turned it.
    ChainArm out;
    out.upright = turnOfZ(glm::normalize(first));
    const glm::dmat3 held = glm::transpose(out.upright) * glm::dmat3(moved[0]);
    std::vector<ArmJoint> bound(count);
    std::vector<glm::dvec3> directions;
    for (std::size_t j = 0; j < count; ++j) {
        const glm::dvec3 seen = glm::dmat3(moved[j]) * (points[j + 1] - points[j]);
        const glm::dvec3 step = held * (points[j + 1] - points[j]);
        if (!(glm::length(step) > 1e-9 && glm::length(seen) > 1e-9))
            return wrong(place, RAMURE_NOOP("two joints at one place"));
        out.joints.emplace_back().length = glm::length(seen);
        bound[j].length = glm::length(step);
        directions.push_back(glm::normalize(step));
    }
    out.place = glm::dmat4(out.upright) * glm::inverse(armUpright());
    out.place[3] = chain.transforms[0][3];
    setDirections(bound, directions);
    std::vector<RigidTransform> pose;
    ArmChain(bound).pose(pose);
    glm::dmat4 atFoot(held);
    atFoot[3] = glm::dvec4(-(held * points[0]), 1.0);
    std::vector<glm::dmat4> straighten(count);
    for (std::size_t j = 0; j < count; ++j) {
        out.axes.push_back(glm::inverse(held) * glm::mat3_cast(pose[j].rotation));
        straighten[chain.order[j]] = pose[j].inverse().matrix() * atFoot;
    }
    poseArm(out, chain, chain.transforms, out.joints);
    RAMURE_TRY(applySkin(mesh, straighten, place));
    out.window = windowOf(mesh, bound);
    return out;
}

} // namespace ramure::glb
