#include "core/base/float4.h"
#include "core/base/wide_clone.h"
#include "core/pose/skin.h"
#include <cmath>

namespace ramure {
namespace {

/// The columns of a 3 x 4 matrix.
struct Columns
{
    Float4 x, y, z, w;
};

/// A unit dual quaternion, parts in the order x, y, z, w.
struct DualQuaternion
{
    Float4 real, dual;
};

Columns columnsOf(const RigidTransform& bone)
{
    const glm::dmat3 turn = glm::mat3_cast(bone.rotation);
    const auto column = [](const glm::dvec3& v) { return Float4{float(v.x), float(v.y), float(v.z), 0.0F}; };
    return {column(turn[0]), column(turn[1]), column(turn[2]), column(bone.translation)};
}

DualQuaternion dualQuaternionOf(const RigidTransform& bone)
{
    const glm::dquat& q = bone.rotation;
    const glm::dquat dual = (glm::dquat(0.0, bone.translation) * q) * 0.5;
    const auto four = [](const glm::dquat& v) {
        return Float4{float(v.x), float(v.y), float(v.z), float(v.w)};
    };
    return {four(q), four(dual)};
}

[[gnu::always_inline]] inline float sum(Float4 v)
{
    return (v[0] + v[1]) + (v[2] + v[3]);
}

/// The mean screw motion (see dualQuaternionMatrix in skin.cpp), in floats.
Columns mixed(const SkinInfluence& influence, const std::vector<DualQuaternion>& bones)
{
    const DualQuaternion& pivot = bones[influence.bone[0]];
    Float4 real = influence.weight[0] * pivot.real, dual = influence.weight[0] * pivot.dual;
    for (std::size_t i = 1; i < 3 && influence.weight[i] > 0.0F; ++i) {
        const DualQuaternion& bone = bones[influence.bone[i]];
        const float weight = sum(bone.real * pivot.real) < 0.0F ? -influence.weight[i] : influence.weight[i];
        real += weight * bone.real;
        dual += weight * bone.dual;
    }
    const float scale = 1.0F / std::sqrt(sum(real * real));
    const Float4 q = real * scale, d = dual * scale;
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    return {Float4{1.0F - 2.0F * (y * y + z * z), 2.0F * (x * y + w * z), 2.0F * (x * z - w * y), 0.0F},
            Float4{2.0F * (x * y - w * z), 1.0F - 2.0F * (x * x + z * z), 2.0F * (y * z + w * x), 0.0F},
            Float4{2.0F * (x * z + w * y), 2.0F * (y * z - w * x), 1.0F - 2.0F * (x * x + y * y), 0.0F},
            2.0F * Float4{w * d[0] - x * d[3] + y * d[2] - z * d[1],
                          w * d[1] - x * d[2] - y * d[3] + z * d[0],
                          w * d[2] + x * d[1] - y * d[0] - z * d[3], 0.0F}};
}

[[gnu::always_inline]] inline Float4 cross(Float4 a, Float4 b)
{
    return Float4{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.0F};
}

[[gnu::always_inline]] inline Columns mixed(const SkinInfluence& influence, const std::vector<Columns>& bones)
{
    const Columns& first = bones[influence.bone[0]];
    const float weight = influence.weight[0];
    Columns all{weight * first.x, weight * first.y, weight * first.z, weight * first.w};
    for (std::size_t i = 1; i < 3 && influence.weight[i] > 0.0F; ++i) {
        const Columns& bone = bones[influence.bone[i]];
        const float share = influence.weight[i];
        all.x += share * bone.x;
        all.y += share * bone.y;
        all.z += share * bone.z;
        all.w += share * bone.w;
    }
    return all;
}

/// How a place at rest moves as weight passes from the first bone to the second.
Columns leaning(const SkinInfluence& influence, const std::vector<Columns>& bones)
{
    const Columns& a = bones[influence.bone[0]];
    const Columns& b = bones[influence.bone[1]];
    return {b.x - a.x, b.y - a.y, b.z - a.z, b.w - a.w};
}

/// The vector part of a * conjugate(b).
Float4 timesConjugate(Float4 a, Float4 b)
{
    const Float4 turned = b[3] * a - a[3] * b + cross(b, a);
    return Float4{turned[0], turned[1], turned[2], 0.0F};
}

/// The derivative of the mean screw motion.
Columns leaning(const SkinInfluence& influence, const std::vector<DualQuaternion>& bones)
{
    const DualQuaternion& first = bones[influence.bone[0]];
    Float4 real{}, dual{}, realTo = -first.real, dualTo = -first.dual;
    for (std::size_t i = 0; i < 3 && influence.weight[i] > 0.0F; ++i) {
        const DualQuaternion& bone = bones[influence.bone[i]];
        const float sign = sum(bone.real * first.real) < 0.0F ? -1.0F : 1.0F;
        real += sign * influence.weight[i] * bone.real;
        dual += sign * influence.weight[i] * bone.dual;
        if (i == 1) {
            realTo += sign * bone.real;
            dualTo += sign * bone.dual;
        }
    }
    const float scale = 1.0F / std::sqrt(sum(real * real));
    const Float4 q = real * scale, d = dual * scale;
    const float along = sum(q * realTo);
    const Float4 turning = (realTo - along * q) * scale;
    const Float4 shifting = (dualTo - along * d) * scale;
    const Float4 spin = 2.0F * timesConjugate(turning, q);
    const Columns now = mixed(influence, bones);
    return {cross(spin, now.x), cross(spin, now.y), cross(spin, now.z),
            2.0F * (timesConjugate(shifting, q) + timesConjugate(d, turning))};
}

/// What normals follow under a transform that is not rigid: determinant times inverse transpose.
[[gnu::always_inline]] inline Columns cofactors(const Columns& m)
{
    return {cross(m.y, m.z), cross(m.z, m.x), cross(m.x, m.y), Float4{}};
}

[[gnu::always_inline]] inline Float4 moved(const float* rest, const Columns& by)
{
    return rest[0] * by.x + rest[1] * by.y + rest[2] * by.z + by.w;
}

[[gnu::always_inline]] inline Float4 turned(const float* rest, const Columns& by)
{
    return rest[0] * by.x + rest[1] * by.y + rest[2] * by.z;
}

/// Under a transform that is not rigid; one that flattens the normal leaves it as it was.
[[gnu::always_inline]] inline Float4 turnedUnit(const float* rest, const Columns& by)
{
    const Float4 normal = turned(rest, by);
    const float square = sum(normal * normal);
    return square > 0.0F ? normal * (1.0F / std::sqrt(square)) : Float4{rest[0], rest[1], rest[2], 0.0F};
}

/// Four floats are stored where three are meant: the next vertex overwrites the fourth. Only the last one of
/// all has nothing behind it.
void storeLast(float* out, Float4 value)
{
    out[0] = value[0];
    out[1] = value[1];
    out[2] = value[2];
}

/// Normals where the weights change along Z: that column of the deformation leans as the place itself does.
void leanNormals(const float* rest, const float* restNormals, std::size_t count, const Columns& by,
                 const Columns& lean, float slope, float* normals)
{
    for (std::size_t i = 0; i < 3 * count; i += 3) {
        const Columns turn = cofactors({by.x, by.y, by.z + slope * moved(rest + i, lean), Float4{}});
        storeLast(normals + i, turnedUnit(restNormals + i, turn));
    }
}

} // namespace

struct Deformer::Bones
{
    SkinMethod method = SkinMethod::Rigid;
    std::vector<Columns> columns;
    std::vector<DualQuaternion> duals; ///< for DualQuaternion only

    void deform(const Skin& skin, const float* rest, const float* restNormals, float* out,
                float* outNormals) const;
    [[nodiscard, gnu::always_inline]] inline Columns transform(const SkinInfluence& influence) const
    {
        if (influence.weight[1] == 0.0F || method == SkinMethod::Rigid)
            return columns[influence.bone[0]];
        return method == SkinMethod::Linear ? mixed(influence, columns) : mixed(influence, duals);
    }
    [[nodiscard]] Columns lean(const SkinInfluence& influence) const
    {
        return method == SkinMethod::Linear ? leaning(influence, columns) : leaning(influence, duals);
    }
};

Deformer::Deformer()
    : m_bones(std::make_unique<Bones>())
{
}

Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

void Deformer::setPose(std::span<const RigidTransform> pose, SkinMethod method)
{
    m_bones->method = method;
    m_bones->columns.resize(pose.size());
    for (std::size_t b = 0; b < pose.size(); ++b)
        m_bones->columns[b] = columnsOf(pose[b]);
    m_bones->duals.resize(method == SkinMethod::DualQuaternion ? pose.size() : 0);
    for (std::size_t b = 0; b < m_bones->duals.size(); ++b)
        m_bones->duals[b] = dualQuaternionOf(pose[b]);
}

/// All runs, with loops for positions and for normals that keep the transform in registers.
RAMURE_WIDE_CLONE void Deformer::Bones::deform(const Skin& skin, const float* rest, const float* restNormals,
                                               float* out, float* outNormals) const
{
    const std::size_t last = std::size_t(skin.vertices) - 1;
    for (std::size_t r = 0; r < skin.runs.size(); ++r) {
        const SkinRun& run = skin.runs[r];
        const bool isLast = r + 1 == skin.runs.size();
        const std::size_t end = isLast ? last : skin.runs[r + 1].firstVertex;
        const Columns by = transform(run.influence);
        const std::size_t first = 3 * std::size_t(run.firstVertex);
        for (std::size_t i = first; i < 3 * end; i += 3)
            storeFloat4(out + i, moved(rest + i, by));
        if (isLast)
            storeLast(out + 3 * last, moved(rest + 3 * last, by));
        if (!outNormals)
            continue;
        if (run.slope != 0.0F && method != SkinMethod::Rigid && run.influence.weight[1] > 0.0F) {
            const std::size_t from = run.firstVertex, count = end + (isLast ? 1 : 0) - from;
            leanNormals(rest + 3 * from, restNormals + 3 * from, count, by, lean(run.influence), run.slope,
                        outNormals + 3 * from);
            continue;
        }
        const bool skews = method == SkinMethod::Linear && run.influence.weight[1] > 0.0F;
        const Columns turn = skews ? cofactors(by) : by;
        const auto normal = [&](std::size_t i) {
            return skews ? turnedUnit(restNormals + i, turn) : turned(restNormals + i, turn);
        };
        for (std::size_t i = first; i < 3 * end; i += 3)
            storeFloat4(outNormals + i, normal(i));
        if (isLast)
            storeLast(outNormals + 3 * last, normal(3 * last));
    }
}

void Deformer::deform(std::span<const glm::vec3> restPositions, std::span<const glm::vec3> restNormals,
                      const Skin& skin, std::span<glm::vec3> positions, std::span<glm::vec3> normals) const
{
    if (skin.vertices == 0)
        return;
    m_bones->deform(skin, &restPositions.data()->x, &restNormals.data()->x, &positions.data()->x,
                    normals.empty() ? nullptr : &normals.data()->x);
}

TriangleMesh deformed(const TriangleMesh& rest, const Skin& skin, std::span<const RigidTransform> pose,
                      SkinMethod method)
{
    TriangleMesh moved = rest;
    Deformer deformer;
    deformer.setPose(pose, method);
    deformer.deform(rest.positions, rest.normals, skin, moved.positions, moved.normals);
    return moved;
}

} // namespace ramure
