#include "core/base/float8.h"
#include "core/base/wide_clone.h"
#include "core/rig/pose/skin.h"
#include <array>
#include <cmath>

namespace ramure {
namespace {

using Double4 [[gnu::vector_size(32)]] = double;

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

/// In doubles, as glm::mat3_cast has it, only four at once.
[[gnu::always_inline]] inline void columnsOf(const RigidTransform& bone, Columns& out)
{
    Double4 q;
    static_assert(sizeof bone.rotation == sizeof q);
    std::memcpy(&q, &bone.rotation, sizeof q); // x, y, z, w
    const Double4 a = __builtin_shufflevector(q, q, 1, 0, 3, 3) * Double4{-1.0, 1.0, -1.0, 0.0};
    const Double4 b = __builtin_shufflevector(q, q, 2, 3, 0, 3) * Double4{-1.0, 1.0, 1.0, 0.0};
    const Double4 c = __builtin_shufflevector(q, q, 3, 2, 1, 3) * Double4{-1.0, -1.0, 1.0, 0.0};
    const double x = 2.0 * bone.rotation.x, y = 2.0 * bone.rotation.y, z = 2.0 * bone.rotation.z;
    const glm::dvec3& shift = bone.translation;
    out.x = __builtin_convertvector(Double4{1.0, 0.0, 0.0, 0.0} + (y * a + z * b), Float4);
    out.y = __builtin_convertvector(Double4{0.0, 1.0, 0.0, 0.0} + (z * c - x * a), Float4);
    out.z = __builtin_convertvector(Double4{0.0, 0.0, 1.0, 0.0} - (x * b + y * c), Float4);
    out.w = __builtin_convertvector(Double4{shift.x, shift.y, shift.z, 0.0}, Float4);
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

/// Four numbers of four things each: what was a component of one becomes a lane for all.
struct Lanes
{
    Float4 x, y, z, w;

    [[gnu::always_inline]] inline void add(Float4 weight, const Lanes& other)
    {
        x += weight * other.x;
        y += weight * other.y;
        z += weight * other.z;
        w += weight * other.w;
    }
    [[gnu::always_inline]] inline void scale(Float4 by)
    {
        x *= by;
        y *= by;
        z *= by;
        w *= by;
    }
    [[nodiscard, gnu::always_inline]] inline Float4 dot(const Lanes& other) const
    {
        return (x * other.x + y * other.y) + (z * other.z + w * other.w);
    }
};

[[gnu::always_inline]] inline Lanes lanesOf(Float4 a, Float4 b, Float4 c, Float4 d)
{
    transpose(a, b, c, d);
    return {a, b, c, d};
}

/// The mean screw motions of four influences at once (see meanScrew in skin.cpp), in floats.
[[gnu::always_inline]] inline void mixFour(const SkinInfluence* const* four,
                                           const std::vector<DualQuaternion>& bones, Columns* out)
{
    const auto weights = [four](std::size_t i) {
        return Float4{four[0]->weight[i], four[1]->weight[i], four[2]->weight[i], four[3]->weight[i]};
    };
    const auto part = [four, &bones](std::size_t i, Float4 DualQuaternion::*half) {
        return lanesOf(bones[four[0]->bone[i]].*half, bones[four[1]->bone[i]].*half,
                       bones[four[2]->bone[i]].*half, bones[four[3]->bone[i]].*half);
    };
    const Lanes pivot = part(0, &DualQuaternion::real);
    Lanes real = pivot, dual = part(0, &DualQuaternion::dual);
    real.scale(weights(0));
    dual.scale(weights(0));
    for (std::size_t i = 1; i < 3; ++i) { // a place that is not used holds the first bone with weight 0
        const Lanes bone = part(i, &DualQuaternion::real);
        const Float4 weight = bone.dot(pivot) < 0.0F ? -weights(i) : weights(i);
        real.add(weight, bone);
        dual.add(weight, part(i, &DualQuaternion::dual));
    }
    const Float4 square = real.dot(real);
    const Float4 scale =
        1.0F / Float4{std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]), std::sqrt(square[3])};
    real.scale(scale);
    dual.scale(scale);
    const auto& [x, y, z, w] = real;
    const Float4 none{};
    const Lanes columns[] = {
        lanesOf(1.0F - 2.0F * (y * y + z * z), 2.0F * (x * y + w * z), 2.0F * (x * z - w * y), none),
        lanesOf(2.0F * (x * y - w * z), 1.0F - 2.0F * (x * x + z * z), 2.0F * (y * z + w * x), none),
        lanesOf(2.0F * (x * z + w * y), 2.0F * (y * z - w * x), 1.0F - 2.0F * (x * x + y * y), none),
        lanesOf(2.0F * (w * dual.x - x * dual.w + y * dual.z - z * dual.y),
                2.0F * (w * dual.y - x * dual.z - y * dual.w + z * dual.x),
                2.0F * (w * dual.z + x * dual.y - y * dual.x - z * dual.w), none)};
    out[0] = {columns[0].x, columns[1].x, columns[2].x, columns[3].x};
    out[1] = {columns[0].y, columns[1].y, columns[2].y, columns[3].y};
    out[2] = {columns[0].z, columns[1].z, columns[2].z, columns[3].z};
    out[3] = {columns[0].w, columns[1].w, columns[2].w, columns[3].w};
}

/// The mean screw motion (see meanScrew in skin.cpp), in floats.
Columns mixed(const SkinInfluence& influence, const std::vector<DualQuaternion>& bones)
{
    const SkinInfluence* const four[] = {&influence, &influence, &influence, &influence};
    std::array<Columns, 4> made;
    mixFour(four, bones, made.data());
    return made[0];
}

[[gnu::always_inline]] inline Float4 cross(Float4 a, Float4 b)
{
    return Float4{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.0F};
}

[[gnu::always_inline]] inline Columns mixed(const SkinInfluence& influence, const std::vector<Columns>& bones)
{
    // Always three: to add a bone with weight 0 is quicker than to ask.
    const Columns &a = bones[influence.bone[0]], &b = bones[influence.bone[1]], &c = bones[influence.bone[2]];
    const float u = influence.weight[0], v = influence.weight[1], w = influence.weight[2];
    return {u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y, u * a.z + v * b.z + w * c.z,
            u * a.w + v * b.w + w * c.w};
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

constexpr std::size_t perBlock = 8;
/// So many vertices at least make a block: fewer are moved one by one, with less to load.
constexpr std::size_t fewVertices = 4;

/// Eight points or directions.
template <bool isPoint>
[[gnu::always_inline]] inline void moveBlock(const float* rest, float* out, const Columns& by)
{
    EightPoints at, now;
    at.load(rest);
    now.x = at.x * by.x[0] + at.y * by.y[0] + at.z * by.z[0];
    now.y = at.x * by.x[1] + at.y * by.y[1] + at.z * by.z[1];
    now.z = at.x * by.x[2] + at.y * by.y[2] + at.z * by.z[2];
    if constexpr (isPoint) {
        now.x += by.w[0];
        now.y += by.w[1];
        now.z += by.w[2];
    }
    now.store(out);
}

template <bool isPoint> [[gnu::always_inline]] inline Float4 movedOne(const float* rest, const Columns& by)
{
    return isPoint ? moved(rest, by) : turned(rest, by);
}

/// The points or directions of a run under one transform, eight at once. The last block may reach beyond the
/// run: the next run overwrites that. \param from,to of 3 * vertices floats in all, of which no more are read
/// or written. \param isPoint directions do not shift
template <bool isPoint>
[[gnu::always_inline]] inline void moveRun(const float* rest, float* out, std::size_t from, std::size_t to,
                                           std::size_t vertices, const Columns& by)
{
    const std::size_t lastBlock = vertices < perBlock ? 0 : vertices - perBlock + 1;
    std::size_t v = from;
    for (; v + fewVertices <= to && v < lastBlock; v += perBlock)
        moveBlock<isPoint>(rest + 3 * v, out + 3 * v, by);
    for (; v < to; ++v) {
        const Float4 value = movedOne<isPoint>(rest + 3 * v, by);
        if (v + 1 < vertices)
            storeFloat4(out + 3 * v, value);
        else
            storeLast(out + 3 * v, value);
    }
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

/// Normals under a transform that is not rigid.
[[gnu::always_inline]] inline void skewNormals(const float* rest, std::size_t count, const Columns& by,
                                               float* normals)
{
    for (std::size_t i = 0; i < 3 * count; i += 3)
        storeLast(normals + i, turnedUnit(rest + i, by));
}

bool isMixed(const SkinRun& run)
{
    return run.influence.weight[1] > 0.0F;
}

/// The transforms of mixed runs in a row, made four at once: of the one asked for and those that come next.
class MixedRuns
{
public:
    MixedRuns(const std::vector<SkinRun>& runs, const std::vector<DualQuaternion>& bones)
        : m_runs(runs)
        , m_bones(bones)
    {
    }
    /// \param run is a mixed one, behind the one asked for before.
    [[gnu::always_inline]] inline const Columns& of(std::size_t run)
    {
        if (m_next == m_made.size()) {
            std::array<const SkinInfluence*, 4> four;
            four.fill(&m_runs[run].influence);
            for (std::size_t i = 1, r = run + 1; i < four.size() && r < m_runs.size(); ++r)
                if (isMixed(m_runs[r]))
                    four[i++] = &m_runs[r].influence;
            mixFour(four.data(), m_bones, m_made.data());
            m_next = 0;
        }
        return m_made[m_next++];
    }

private:
    const std::vector<SkinRun>& m_runs;
    const std::vector<DualQuaternion>& m_bones;
    std::array<Columns, 4> m_made;
    std::size_t m_next = 4;
};

} // namespace

struct Deformer::Bones
{
    SkinMethod method = SkinMethod::Rigid;
    std::vector<Columns> columns;
    std::vector<DualQuaternion> duals; ///< for DualQuaternion only

    void setPose(std::span<const RigidTransform> pose);
    void mix(const Skin& skin, const float* rest, const float* restNormals, float* out,
             float* outNormals) const;
    void follow(const Skin& skin, const float* rest, const float* restNormals, float* out,
                float* outNormals) const;
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
    m_bones->setPose(pose);
}

RAMURE_WIDE_CLONE void Deformer::Bones::setPose(std::span<const RigidTransform> pose)
{
    columns.resize(pose.size());
    for (std::size_t b = 0; b < pose.size(); ++b)
        columnsOf(pose[b], columns[b]);
    duals.resize(method == SkinMethod::DualQuaternion ? pose.size() : 0);
    for (std::size_t b = 0; b < duals.size(); ++b)
        duals[b] = dualQuaternionOf(pose[b]);
}

/// Every run follows one bone, with its transform in registers.
RAMURE_WIDE_CLONE void Deformer::Bones::follow(const Skin& skin, const float* rest, const float* restNormals,
                                               float* out, float* outNormals) const
{
    const std::size_t vertices = skin.vertices;
    for (std::size_t r = 0; r < skin.runs.size(); ++r) {
        const SkinRun& run = skin.runs[r];
        const std::size_t from = run.firstVertex;
        const std::size_t end = r + 1 == skin.runs.size() ? vertices : skin.runs[r + 1].firstVertex;
        const Columns& by = columns[run.influence.bone[0]];
        moveRun<true>(rest, out, from, end, vertices, by);
        if (outNormals)
            moveRun<false>(restNormals, outNormals, from, end, vertices, by);
    }
}

/// Runs of one bone or more.
RAMURE_WIDE_CLONE void Deformer::Bones::mix(const Skin& skin, const float* rest, const float* restNormals,
                                            float* out, float* outNormals) const
{
    const std::size_t vertices = skin.vertices;
    MixedRuns mixedRuns(skin.runs, duals);
    for (std::size_t r = 0; r < skin.runs.size(); ++r) {
        const SkinRun& run = skin.runs[r];
        const std::size_t from = run.firstVertex;
        const std::size_t to = r + 1 == skin.runs.size() ? vertices : skin.runs[r + 1].firstVertex;
        const bool mixes = isMixed(run) && method != SkinMethod::Rigid;
        const Columns by = !mixes                         ? columns[run.influence.bone[0]]
                           : method == SkinMethod::Linear ? mixed(run.influence, columns)
                                                          : mixedRuns.of(r);
        moveRun<true>(rest, out, from, to, vertices, by);
        if (!outNormals)
            continue;
        if (run.slope != 0.0F && mixes)
            leanNormals(rest + 3 * from, restNormals + 3 * from, to - from, by, lean(run.influence),
                        run.slope, outNormals + 3 * from);
        else if (method == SkinMethod::Linear && mixes)
            skewNormals(restNormals + 3 * from, to - from, cofactors(by), outNormals + 3 * from);
        else
            moveRun<false>(restNormals, outNormals, from, to, vertices, by);
    }
}

void Deformer::deform(std::span<const glm::vec3> restPositions, std::span<const glm::vec3> restNormals,
                      const Skin& skin, std::span<glm::vec3> positions, std::span<glm::vec3> normals) const
{
    if (skin.vertices == 0)
        return;
    const float* const rest = &restPositions.data()->x;
    const float* const normalsAtRest = restNormals.empty() ? nullptr : &restNormals.data()->x;
    float* const out = &positions.data()->x;
    float* const outNormals = normals.empty() ? nullptr : &normals.data()->x;
    if (m_bones->method == SkinMethod::Rigid)
        m_bones->follow(skin, rest, normalsAtRest, out, outNormals);
    else
        m_bones->mix(skin, rest, normalsAtRest, out, outNormals);
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
