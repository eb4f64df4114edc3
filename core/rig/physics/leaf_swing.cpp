#include "core/rig/physics/leaf_swing.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/rig/physics/lanes.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace ramure {
namespace {

using namespace lanes;

/// Of a leaf of 9 cm, at stiffness 1; longer ones swing more slowly.
constexpr double usualHertz = 3.5, usualLength = 0.09;
constexpr double dampingRatio = 0.35; ///< leaves are light: the air damps them well
/// tan(angle / 2) of a usual leaf across a wind of 4 m/s, and on a twig that lies on its side.
constexpr double leafTurnOfWind = 0.3, leafTurnOfWeight = 0.2;
/// The same at most, and of the flutter at its strongest.
constexpr double mostLeafTurn = 0.9, mostFlutter = 0.22;
/// Share of the drag that a leaf has edge on.
constexpr float edgeOn = 0.35F;
/// Twigs whip faster than this, m/s, in storms alone; faster ones fling their leaves no further.
constexpr double fastTwigOfLeaves = 6.0;

/// The leaves of a twig flutter at one of so many rates, each with a phase of its own: to know their sines is
/// to know four numbers a rate.
constexpr std::size_t notes = 32;
using Note = std::array<float, 4>; ///< sine and cosine of the twist, then of the nod

std::array<Note, notes> notesAt(double seconds, double hertz)
{
    std::array<Note, notes> out{};
    for (std::size_t i = 0; i < notes; ++i) {
        const double rate = fullTurn * hertz * (0.7 + 0.6 * double(i) / notes);
        const auto twist = maths::sincos(std::fmod(1.37 * rate * seconds, fullTurn));
        const auto nod = maths::sincos(std::fmod(rate * seconds, fullTurn));
        out[i] = {float(twist.sin), float(twist.cos), float(nod.sin), float(nod.cos)};
    }
    return out;
}

/// What makes a tree's leaves answer as they do.
struct Answer
{
    double drag, sag;   ///< tan(angle / 2) by (speed / 4 m/s)², and by the turn of the weight
    double flutter;     ///< at its strongest
    double heldGravity; ///< under which they hung as they were placed
    double gravity;     ///< now
    double rise;        ///< how much of the wind they have heard of yet, 0..1
};

constexpr std::size_t leavesAtATime = 64;

/// What the twigs of a block are in: their turn since their rest, and the air that passes them, m/s.
struct TwigBlock
{
    double w[leavesAtATime], x[leavesAtATime], y[leavesAtATime], z[leavesAtATime];
    double airX[leavesAtATime], airY[leavesAtATime], airZ[leavesAtATime];
    double velX[leavesAtATime], velY[leavesAtATime], velZ[leavesAtATime];
};

/// Of the branches of a block; the faithful step's speeds are others, of which leaves feel nothing.
void gather(const TreeBody& body, const PhysicsState& state, std::span<const Index> branches,
            const glm::dvec3& air, TwigBlock& out)
{
    const auto channel = [&](int number) { return state.channel(number).data(); };
    const double *w = channel(PhysicsState::RotW), *x = channel(PhysicsState::RotX),
                 *y = channel(PhysicsState::RotY), *z = channel(PhysicsState::RotZ);
    const double *velX = channel(PhysicsState::VelX), *velY = channel(PhysicsState::VelY),
                 *velZ = channel(PhysicsState::VelZ);
    const double share = state.mode == PhysicsMode::Robust ? 1.0 : 0.0;
    for (std::size_t i = 0; i < branches.size(); ++i) {
        const Index slot = body.slotOf[branches[i]];
        out.w[i] = w[slot], out.x[i] = x[slot], out.y[i] = y[slot], out.z[i] = z[slot];
        out.velX[i] = share * velX[slot], out.velY[i] = share * velY[slot], out.velZ[i] = share * velZ[slot];
        out.airX[i] = air.x, out.airY[i] = air.y, out.airZ[i] = air.z;
    }
}

RAMURE_VECTOR_CLONES
void addWave(const double* sine, const double* cosine, const glm::dvec3& s, const glm::dvec3& c,
             std::size_t count, TwigBlock& out)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t i = 0; i < count; ++i) {
        out.airX[i] += s.x * sine[i] + c.x * cosine[i];
        out.airY[i] += s.y * sine[i] + c.y * cosine[i];
        out.airZ[i] += s.z * sine[i] + c.z * cosine[i];
    }
}

/// What the leaves of a twig feel, in tree space at rest: where the wind blows to, of length 1; its pull at
/// full area; the pull of the weight; the note, as loud as they flutter.
enum Felt : std::uint8_t { WindX, WindY, WindZ, Drag, SagX, SagY, SagZ, TwistSin, TwistCos, NodSin, NodCos };
constexpr std::size_t feltCount = 11;
using FeltTwig = std::array<float, feltCount>;

struct FeltBlock
{
    double of[TwistSin][leavesAtATime];
    double flutter[leavesAtATime];
};

RAMURE_VECTOR_CLONES
void feel(const TwigBlock& around, const Answer& answer, std::size_t count, FeltBlock& out)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t i = 0; i < count; ++i) {
        const Quat back{around.w[i], -around.x[i], -around.y[i], -around.z[i]};
        const Vec carried{around.velX[i], around.velY[i], around.velZ[i]};
        const double whip =
            1.0 / std::sqrt(1.0 + dot(carried, carried) * (1.0 / (fastTwigOfLeaves * fastTwigOfLeaves)));
        const Vec air = Vec{around.airX[i], around.airY[i], around.airZ[i]} - whip * carried;
        const double speed = std::sqrt(dot(air, air)), square = speed * speed * (1.0 / 16.0);
        const Vec way = turned(back, (1.0 / (speed + 1e-30)) * air);
        const double drag = answer.drag * square;
        const Vec weight = turned(back, Vec{0.0, -answer.gravity, 0.0});
        const Vec more = answer.sag * (weight + Vec{0.0, answer.heldGravity, 0.0});
        const Vec sag = answer.rise / (1.0 + std::sqrt(dot(more, more)) * (1.0 / mostLeafTurn)) * more;
        out.of[WindX][i] = way.x, out.of[WindY][i] = way.y, out.of[WindZ][i] = way.z;
        out.of[Drag][i] = answer.rise * drag / (1.0 + drag * (1.0 / mostLeafTurn));
        out.of[SagX][i] = sag.x, out.of[SagY][i] = sag.y, out.of[SagZ][i] = sag.z;
        out.flutter[i] = answer.rise * answer.flutter * square / (1.0 + square);
    }
}

/// By leaf, the arrays of LeafSwing.
struct Rests
{
    const float *alongX, *alongY, *alongZ, *upperX, *upperY, *upperZ, *give, *sin, *cos;
};

using Float8 [[gnu::vector_size(32)]] = float;
/// What the leaves of a block feel, one after the other; twigs write a little past their last leaf.
using Spread = float[feltCount][leavesAtATime + 8];

RAMURE_VECTOR_CLONES
void spread(const FeltTwig& felt, std::size_t from, std::size_t to, Spread& out)
{
    for (std::size_t part = 0; part < feltCount; ++part) {
        const Float8 value = felt[part] - Float8{};
        for (std::size_t i = from; i < to; i += 8)
            std::memcpy(&out[part][i], &value, sizeof value);
    }
}

RAMURE_VECTOR_CLONES
void swingBlock(const Rests& r, const Spread& felt, std::size_t first, std::size_t count, float* outX,
                float* outY, float* outZ)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        const float ax = r.alongX[i], ay = r.alongY[i], az = r.alongZ[i];
        const float ux = r.upperX[i], uy = r.upperY[i], uz = r.upperZ[i];
        const float wx = felt[WindX][k], wy = felt[WindY][k], wz = felt[WindZ][k];
        // The wind has its hold on a leaf by the area that it meets.
        const float facing = std::abs(wx * ux + wy * uy + wz * uz);
        const float pull = (edgeOn + (1.0F - edgeOn) * facing) * felt[Drag][k], give = r.give[i];
        const float fx = give * (pull * wx + felt[SagX][k]), fy = give * (pull * wy + felt[SagY][k]),
                    fz = give * (pull * wz + felt[SagZ][k]);
        const float twist = give * (felt[TwistSin][k] * r.cos[i] + felt[TwistCos][k] * r.sin[i]);
        const float nod = give * (felt[NodSin][k] * r.cos[i] - felt[NodCos][k] * r.sin[i]);
        outX[i] = ay * fz - az * fy + twist * ax + nod * (ay * uz - az * uy);
        outY[i] = az * fx - ax * fz + twist * ay + nod * (az * ux - ax * uz);
        outZ[i] = ax * fy - ay * fx + twist * az + nod * (ax * uy - ay * ux);
    }
}

/// Where leaves hang: on a bone, or between two; then their own bones.
struct Bones
{
    struct Bone
    {
        double w[leavesAtATime], x[leavesAtATime], y[leavesAtATime], z[leavesAtATime];
        double atX[leavesAtATime], atY[leavesAtATime], atZ[leavesAtATime];

        void set(std::size_t i, const RigidTransform& to)
        {
            w[i] = to.rotation.w, x[i] = to.rotation.x, y[i] = to.rotation.y, z[i] = to.rotation.z;
            atX[i] = to.translation.x, atY[i] = to.translation.y, atZ[i] = to.translation.z;
        }
        [[nodiscard]] Quat rotation(std::size_t i) const { return {w[i], x[i], y[i], z[i]}; }
        [[nodiscard]] Vec translation(std::size_t i) const { return {atX[i], atY[i], atZ[i]}; }
    };
    Bone bone, other;
    double share[leavesAtATime]; ///< of the other
    double footX[leavesAtATime], footY[leavesAtATime], footZ[leavesAtATime];
    // Where the bark bends: its place at rest, and now. Else 0.
    double held[leavesAtATime], fromX[leavesAtATime], fromY[leavesAtATime], fromZ[leavesAtATime],
        toX[leavesAtATime], toY[leavesAtATime], toZ[leavesAtATime];
};

/// Turns about the foot, then goes where the anchor goes: the mean screw of its bones
/// (core/rig/pose/skin.cpp).
RAMURE_VECTOR_CLONES
void poseBlock(const float* bendX, const float* bendY, const float* bendZ, std::size_t count, Bones& b)
{
    RAMURE_INDEPENDENT_ROUNDS
    for (std::size_t i = 0; i < count; ++i) {
        const Quat p = b.bone.rotation(i), q = b.other.rotation(i);
        const Vec atP = b.bone.translation(i), atQ = b.other.translation(i);
        const double dot4 = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z;
        const double ofQ = dot4 < 0.0 ? -b.share[i] : b.share[i], ofP = 1.0 - b.share[i];
        const Quat sum{ofP * p.w + ofQ * q.w, ofP * p.x + ofQ * q.x, ofP * p.y + ofQ * q.y,
                       ofP * p.z + ofQ * q.z};
        const double whole = 1.0 / (sum.w * sum.w + sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
        const Quat dualP = Quat{0.0, ofP * atP.x, ofP * atP.y, ofP * atP.z} * p;
        const Quat dualQ = Quat{0.0, ofQ * atQ.x, ofQ * atQ.y, ofQ * atQ.z} * q;
        const Quat dual{dualP.w + dualQ.w, dualP.x + dualQ.x, dualP.y + dualQ.y, dualP.z + dualQ.z};
        const Quat moved = dual * conjugate(sum);
        const Vec at = whole * Vec{moved.x, moved.y, moved.z};
        const double unit = std::sqrt(whole);
        const Quat base{unit * sum.w, unit * sum.x, unit * sum.y, unit * sum.z};

        const Vec bend{double(bendX[i]), double(bendY[i]), double(bendZ[i])};
        const double share = 1.0 / std::sqrt(1.0 + dot(bend, bend));
        const Quat swung{share, share * bend.x, share * bend.y, share * bend.z};
        const Vec foot{b.footX[i], b.footY[i], b.footZ[i]};
        const Vec from{b.fromX[i], b.fromY[i], b.fromZ[i]};
        const Vec bent = Vec{b.toX[i], b.toY[i], b.toZ[i]} - (at + turned(base, from));
        const Vec to = at + turned(base, foot - turned(swung, foot)) + b.held[i] * bent;
        const Quat now = base * swung;
        b.bone.w[i] = now.w, b.bone.x[i] = now.x, b.bone.y[i] = now.y, b.bone.z[i] = now.z;
        b.bone.atX[i] = to.x, b.bone.atY[i] = to.y, b.bone.atZ[i] = to.z;
    }
}

/// Area of a leaf that is 1 long.
double areaOf(const LeafForm& form)
{
    const TriangleMesh leaf = leafMesh(form);
    double area = 0.0;
    for (const glm::uvec3& t : leaf.triangles) {
        const glm::dvec3 a(leaf.positions[t.x]), b(leaf.positions[t.y]), c(leaf.positions[t.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

} // namespace

void LeafBends::resize(std::size_t leaves)
{
    for (std::vector<float>* part : {&x, &y, &z})
        part->resize(leaves);
}

void LeafBends::blend(const LeafBends& other, float weight)
{
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += weight * (other.x[i] - x[i]);
        y[i] += weight * (other.y[i] - y[i]);
        z[i] += weight * (other.z[i] - z[i]);
    }
}

LeafSwing::LeafSwing(const Skeleton& skeleton, const Foliage& foliage, double alpha, BarkAnchors anchors)
    : m_anchors(std::move(anchors))
{
    const LeafRow& row = leafRow(foliage.form.shape);
    const double area = areaOf(foliage.form);
    m_drag = 1.5 * area / (area + 0.15);
    m_loose = 0.7 + 0.6 * std::min(row.petiole * foliage.form.petiole, 1.5);
    m_hertz =
        usualHertz * std::sqrt(usualLength / std::max(leafLength(foliage.form, alpha), 1e-3 * usualLength));
    m_hertz = std::clamp(m_hertz, 0.4, 6.0);
    double reach = 0.0;
    for (const glm::vec3& at : oneLeaf(foliage.form, alpha, FoliageModel::Fine).positions)
        reach = std::max(reach, double(glm::length(at)));
    for (const FoliageItem& leaf : foliage.leaves) {
        m_reach = std::max(m_reach, leaf.size * reach);
        if (m_branches.empty() || m_branches.back() != leaf.branch)
            addTwig(skeleton, leaf.branch);
        addLeaf(leaf, skeleton.key[leaf.branch]);
        m_ends.back() = size();
    }
}

void LeafSwing::addTwig(const Skeleton& skeleton, Index branch)
{
    m_branches.push_back(branch);
    m_ends.push_back(size());
    m_notes.push_back(Random(skeleton.key[branch], RandomStream::LeafSwing).below(notes));
    m_places.parent.push_back(noIndex);
    m_places.p0.push_back(skeleton.p0[branch]);
    m_places.p1.push_back(skeleton.p1[branch]);
}

void LeafSwing::addLeaf(const FoliageItem& leaf, std::uint64_t branchKey)
{
    const glm::vec3 along(leaf.orientation * glm::dvec3(0.0, 1.0, 0.0));
    const glm::vec3 upper(leaf.orientation * glm::dvec3(0.0, 0.0, 1.0));
    Random random(branchKey, RandomStream::LeafSwing, leaf.number + 1ull);
    const auto phase = maths::sincos(random.range(0.0, fullTurn));
    m_alongX.push_back(along.x), m_alongY.push_back(along.y), m_alongZ.push_back(along.z);
    m_upperX.push_back(upper.x), m_upperY.push_back(upper.y), m_upperZ.push_back(upper.z);
    m_sin.push_back(static_cast<float>(phase.sin)), m_cos.push_back(static_cast<float>(phase.cos));
    m_give.push_back(static_cast<float>(random.range(0.75, 1.25)));
    m_foot.push_back(leaf.position);
}

std::vector<LeafSwing::FeltTwig> LeafSwing::feltAt(const TreeBody& body, const PhysicsState& state,
                                                   const PhysicsParams& params, const LeafParams& leaf)
{
    const double t = state.timeSeconds, hertz = m_hertz * std::sqrt(leaf.stiffness);
    const bool isRobust = state.mode == PhysicsMode::Robust;
    WindField::Moment wind;
    if (isRobust) {
        m_places.reach = body.reach; // waves are as long as the tree is high
        m_wind.setParams(m_places, params);
        wind = m_wind.felt(t, fullTurn * hertz, dampingRatio);
    } else {
        wind.mean = faithfulWind(params, t);
    }
    // A run begins in air that no leaf has felt yet.
    const double told = fullTurn * hertz * t;
    const Answer answer{leafTurnOfWind * m_drag * m_loose / leaf.stiffness,
                        leafTurnOfWeight / leaf.stiffness,
                        mostFlutter * m_loose * leaf.flutter / std::sqrt(std::max(leaf.stiffness, 0.25)),
                        state.held.gravity,
                        params.gravity,
                        1.0 - (1.0 + told) * maths::exp(-told)};
    const std::array<Note, notes> all = notesAt(t, hertz);
    std::vector<FeltTwig> out(m_branches.size());
    for (std::size_t first = 0; first < out.size(); first += leavesAtATime) {
        const std::size_t count = std::min(leavesAtATime, out.size() - first);
        TwigBlock around;
        gather(body, state, std::span(m_branches).subspan(first, count), wind.mean, around);
        for (std::size_t wave = 0; isRobust && wave < WindField::waves; ++wave)
            addWave(m_wind.sinOf(int(wave)) + first, m_wind.cosOf(int(wave)) + first, wind.sine[wave],
                    wind.cosine[wave], count, around);
        FeltBlock felt;
        feel(around, answer, count, felt);
        for (std::size_t i = 0; i < count; ++i) {
            FeltTwig& to = out[first + i];
            for (std::size_t part = 0; part < TwistSin; ++part)
                to[part] = static_cast<float>(felt.of[part][i]);
            const Note& note = all[m_notes[first + i]];
            for (std::size_t part = 0; part < note.size(); ++part)
                to[TwistSin + part] = static_cast<float>(felt.flutter[i]) * note[part];
        }
    }
    return out;
}

void LeafSwing::swing(const TreeBody& body, const PhysicsState& state, const PhysicsParams& params,
                      const LeafParams& leaf, LeafBends& out)
{
    out.resize(size());
    const std::vector<FeltTwig> felt = feltAt(body, state, params, leaf);
    const Rests rests{m_alongX.data(), m_alongY.data(), m_alongZ.data(), m_upperX.data(), m_upperY.data(),
                      m_upperZ.data(), m_give.data(),   m_sin.data(),    m_cos.data()};
    Spread all;
    std::size_t twig = 0;
    for (std::size_t first = 0; first < size(); first += leavesAtATime) {
        const std::size_t last = std::min(first + leavesAtATime, size());
        for (std::size_t from = first; from < last;) {
            const std::size_t to = std::min<std::size_t>(m_ends[twig], last);
            spread(felt[twig], from - first, to - first, all);
            twig += m_ends[twig] == to ? 1 : 0;
            from = to;
        }
        swingBlock(rests, all, first, last - first, out.x.data(), out.y.data(), out.z.data());
    }
}

/// The triangles of the bark that bend go as all of it does.
void LeafSwing::carry(std::span<const RigidTransform> branches, SkinMethod method)
{
    m_corners.resize(m_anchors.corners.size());
    if (m_corners.empty())
        return;
    m_deformer.setPose(branches, method);
    m_deformer.deform(m_anchors.corners, {}, m_anchors.cornerSkin, m_corners, {});
}

void LeafSwing::pose(std::span<const RigidTransform> branches, SkinMethod method, const LeafBends& bends,
                     std::span<RigidTransform> out)
{
    carry(branches, method);
    const auto placeOf = [this](const std::vector<glm::vec3>& corners, std::size_t number) {
        const glm::dvec3& shares = m_anchors.shares[number];
        const auto corner = [&](std::size_t k) { return glm::dvec3(corners[3 * number + k]); };
        return shares.x * corner(0) + shares.y * corner(1) + shares.z * corner(2);
    };
    Bones bones;
    std::size_t run = 0, bent = 0;
    const std::vector<SkinRun>& runs = m_anchors.leaves.runs;
    for (std::size_t first = 0; first < size(); first += leavesAtATime) {
        const std::size_t count = std::min(leavesAtATime, size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = first + k;
            if (run + 1 < runs.size() && runs[run + 1].firstVertex == i)
                ++run;
            const SkinInfluence& anchor = runs[run].influence;
            const bool isRare = method == SkinMethod::Linear || anchor.weight[2] > 0.0F;
            bones.bone.set(k, isRare ? skinTransform(anchor, branches, method, m_foot[i])
                                     : branches[anchor.bone[0]]);
            bones.other.set(k, branches[anchor.bone[1]]);
            bones.share[k] = isRare ? 0.0 : double(anchor.weight[1]);
            bones.footX[k] = m_foot[i].x, bones.footY[k] = m_foot[i].y, bones.footZ[k] = m_foot[i].z;
            const bool isBent = bent < m_anchors.bent.size() && m_anchors.bent[bent] == i;
            const glm::dvec3 from = isBent ? placeOf(m_anchors.corners, bent) : glm::dvec3(0.0);
            const glm::dvec3 to = isBent ? placeOf(m_corners, bent++) : glm::dvec3(0.0);
            bones.held[k] = isBent ? 1.0 : 0.0;
            bones.fromX[k] = from.x, bones.fromY[k] = from.y, bones.fromZ[k] = from.z;
            bones.toX[k] = to.x, bones.toY[k] = to.y, bones.toZ[k] = to.z;
        }
        poseBlock(bends.x.data() + first, bends.y.data() + first, bends.z.data() + first, count, bones);
        for (std::size_t k = 0; k < count; ++k)
            out[first + k] = {{bones.bone.w[k], bones.bone.x[k], bones.bone.y[k], bones.bone.z[k]},
                              {bones.bone.atX[k], bones.bone.atY[k], bones.bone.atZ[k]}};
    }
}

} // namespace ramure
