#include "core/rig/pose/skin.h"

#include "core/base/parallel.h"
#include "core/math/hermite.h"
#include "core/skeleton/sections.h"
#include "core/surface/foliage/bark_place.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace ramure {
namespace {

constexpr int curveSteps = 16;
constexpr double roomAboveFork = 1.0; ///< radii, over which a tube lets go of its parent above the walls
constexpr double bendRadii = 2.0;     ///< the same where a single child goes on
constexpr double mostOfFork = 0.9, mostOfBend = 0.5; ///< of a branch's length
/// Weights are multiples of this: the points of one cross-section get the same.
constexpr double weightSteps = 1024.0;

double smoothstep(double x)
{
    const double u = std::clamp(x, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

SkinInfluence follow(Index bone)
{
    return {{bone, bone, bone}, {1.0F, 0.0F, 0.0F}};
}

/// Up to nine bones; the three that weigh most stay.
class Mix
{
public:
    void add(Index bone, double weight)
    {
        if (weight <= 0.0)
            return;
        for (std::size_t i = 0; i < m_count; ++i)
            if (m_bones[i].index == bone) {
                m_bones[i].weight += weight;
                return;
            }
        m_bones[m_count++] = {bone, weight};
    }
    [[nodiscard]] SkinInfluence influence()
    {
        for (std::size_t i = 1; i < m_count; ++i)
            for (std::size_t k = i; k > 0 && outweighs(m_bones[k], m_bones[k - 1]); --k)
                std::swap(m_bones[k], m_bones[k - 1]);
        const std::size_t kept = std::min<std::size_t>(m_count, 3);
        double sum = 0.0;
        for (std::size_t i = 0; i < kept; ++i)
            sum += m_bones[i].weight;
        SkinInfluence made = follow(m_bones[0].index);
        for (std::size_t i = 0; i < kept; ++i) {
            made.bone[i] = m_bones[i].index;
            made.weight[i] = static_cast<float>(m_bones[i].weight / sum);
        }
        return made;
    }

private:
    struct Bone
    {
        Index index;
        double weight;
    };
    static bool outweighs(const Bone& a, const Bone& b)
    {
        return a.weight > b.weight || (a.weight == b.weight && a.index < b.index);
    }
    std::array<Bone, 9> m_bones{};
    std::size_t m_count = 0;
};

/// How much a point of a branch follows the parent's bone, by its height over the tube's start.
class BranchBlend
{
public:
    BranchBlend(const BranchMesh& mesh, const Skeleton& skeleton)
        : m_skeleton(skeleton)
        , m_tubes(skeleton.size())
    {
        std::vector<float> walls(skeleton.size(), 0.0F);
        for (const ForkVertex& fork : mesh.forkVertices)
            walls[fork.parent] = std::max(walls[fork.parent], fork.along);
        for (const TubeRange& tube : mesh.tubes) {
            if (tube.parent == noIndex || tube.parent == tube.branch) // or the upper part of a branch
                continue;
            const double length = skeleton.length(tube.branch);
            const double radius = skeleton.a1[tube.parent];
            const double wall = walls[tube.parent];
            const double clear = wall > 0.0 ? std::min(wall + roomAboveFork * radius, mostOfFork * length)
                                            : std::min(bendRadii * radius, mostOfBend * length);
            m_tubes[tube.branch] = {tube.parent, clear};
        }
    }

    [[nodiscard]] SkinInfluence at(Index branch, const glm::dvec3& point)
    {
        const Tube& tube = m_tubes[branch];
        if (tube.parent == noIndex || tube.clear <= 0.0)
            return follow(branch);
        const glm::dvec3& start = m_skeleton.p1[tube.parent];
        const double reach = tube.clear + 2.0 * std::max(m_skeleton.a0[branch], m_skeleton.a1[tube.parent]);
        const glm::dvec3 away = point - start;
        if (glm::dot(away, away) > reach * reach)
            return follow(branch);
        setCurve(branch, start);
        const double parents = parentWeight(tube, alongCurve(point) - m_startsAt);
        Mix mix;
        mix.add(tube.parent, parents);
        mix.add(branch, 1.0 - parents);
        return mix.influence();
    }

    [[nodiscard]] SkinInfluence at(const ForkVertex& fork) const
    {
        Mix mix;
        double parents = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            if (fork.branch[i] != noIndex)
                parents += double(fork.weight[i]) * parentWeight(m_tubes[fork.branch[i]], double(fork.along));
        mix.add(fork.parent, parents);
        for (std::size_t i = 0; i < 3; ++i)
            if (fork.branch[i] != noIndex)
                mix.add(fork.branch[i], (1.0 - parents) * double(fork.weight[i]));
        return mix.influence();
    }

private:
    struct Tube
    {
        Index parent = noIndex;
        double clear = 0.0; ///< m: above it a tube follows its own bone alone
    };

    static double parentWeight(const Tube& tube, double along)
    {
        if (tube.clear <= 0.0)
            return 0.0;
        return std::round((1.0 - smoothstep(along / tube.clear)) * weightSteps) / weightSteps;
    }

    /// A branch chained behind its sibling starts in the middle of its own curve.
    void setCurve(Index branch, const glm::dvec3& start)
    {
        if (branch == m_branch)
            return;
        m_branch = branch;
        const BranchCurve curve = branchCurve(m_skeleton, branch);
        for (int i = 0; i <= curveSteps; ++i)
            m_points[std::size_t(i)] =
                hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(i) / curveSteps).point;
        m_along[0] = 0.0;
        for (std::size_t i = 1; i <= curveSteps; ++i)
            m_along[i] = m_along[i - 1] + glm::length(m_points[i] - m_points[i - 1]);
        m_startsAt = alongCurve(start);
    }

    [[nodiscard]] double alongCurve(const glm::dvec3& point) const
    {
        double nearest = std::numeric_limits<double>::max(), along = 0.0;
        for (std::size_t i = 0; i < curveSteps; ++i) {
            const glm::dvec3 way = m_points[i + 1] - m_points[i], away = point - m_points[i];
            const double square = glm::dot(way, way);
            const double part = square > 0.0 ? std::clamp(glm::dot(away, way) / square, 0.0, 1.0) : 0.0;
            const glm::dvec3 left = away - part * way;
            const double distance = glm::dot(left, left);
            if (distance < nearest) {
                nearest = distance;
                along = m_along[i] + part * (m_along[i + 1] - m_along[i]);
            }
        }
        return along;
    }

    const Skeleton& m_skeleton;
    std::vector<Tube> m_tubes; ///< by branch
    Index m_branch = noIndex;  ///< whose curve it is
    std::array<glm::dvec3, curveSteps + 1> m_points{};
    std::array<double, curveSteps + 1> m_along{};
    double m_startsAt = 0.0;
};

void append(Skin& skin, Index vertex, const SkinInfluence& influence)
{
    if (skin.runs.empty() || !(skin.runs.back().influence == influence))
        skin.runs.push_back({vertex, influence});
}

void appendAnchor(BarkAnchors& anchors, Index leaf, const BarkPlace& place, const TriangleMesh& mesh,
                  const Skin& bark)
{
    Mix mix;
    bool bends = false;
    for (int k = 0; k < 3; ++k) {
        const SkinInfluence& at = bark.of(place.triangle[k]);
        bends = bends || !(at == bark.of(place.triangle[0]));
        for (std::size_t i = 0; i < 3; ++i)
            mix.add(at.bone[i], place.shares[k] * double(at.weight[i]));
    }
    append(anchors.leaves, leaf, bends ? mix.influence() : bark.of(place.triangle[0]));
    if (!bends)
        return;
    anchors.bent.push_back(leaf);
    anchors.shares.push_back(place.shares);
    for (int k = 0; k < 3; ++k) {
        append(anchors.cornerSkin, static_cast<Index>(anchors.corners.size()), bark.of(place.triangle[k]));
        anchors.corners.push_back(mesh.positions[place.triangle[k]]);
    }
}

tl::unexpected<Error> mismatch()
{
    return fail(ErrorCode::Invalid, RAMURE_NOOP("The mesh was not made of this skeleton"));
}

bool belongs(const BranchMesh& mesh, const Skeleton& skeleton)
{
    const auto isBranch = [&](Index branch) { return branch < skeleton.size(); };
    const auto orNone = [&](Index branch) { return branch == noIndex || isBranch(branch); };
    return mesh.mesh.branch.size() == mesh.mesh.positions.size() &&
           std::all_of(mesh.mesh.branch.begin(), mesh.mesh.branch.end(), isBranch) &&
           std::all_of(mesh.tubes.begin(), mesh.tubes.end(),
                       [&](const TubeRange& tube) { return isBranch(tube.branch) && orNone(tube.parent); }) &&
           std::all_of(mesh.forkVertices.begin(), mesh.forkVertices.end(), [&](const ForkVertex& fork) {
               return isBranch(fork.parent) && isBranch(fork.branch[0]) && isBranch(fork.branch[1]) &&
                      orNone(fork.branch[2]);
           });
}

glm::dmat4 rigidMatrix(const glm::dquat& rotation, const glm::dvec3& translation)
{
    glm::dmat4 matrix = glm::mat4_cast(rotation);
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

glm::dmat4 linearMatrix(const SkinInfluence& influence, std::span<const RigidTransform> pose)
{
    glm::dmat4 sum(0.0);
    for (std::size_t i = 0; i < 3 && influence.weight[i] > 0.0F; ++i) {
        const RigidTransform& bone = pose[influence.bone[i]];
        sum += double(influence.weight[i]) * rigidMatrix(bone.rotation, bone.translation);
    }
    sum[3][3] = 1.0;
    return sum;
}

/// Kavan, Collins, Zara, O'Sullivan: Geometric skinning with approximate dual quaternion blending, 2008.
RigidTransform meanScrew(const SkinInfluence& influence, std::span<const RigidTransform> pose)
{
    const glm::dquat& pivot = pose[influence.bone[0]].rotation;
    glm::dquat real(0.0, 0.0, 0.0, 0.0), dual(0.0, 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < 3 && influence.weight[i] > 0.0F; ++i) {
        const RigidTransform& bone = pose[influence.bone[i]];
        const double weight =
            glm::dot(bone.rotation, pivot) < 0.0 ? -double(influence.weight[i]) : double(influence.weight[i]);
        real = real + bone.rotation * weight;
        dual = dual + (glm::dquat(0.0, bone.translation) * bone.rotation) * (0.5 * weight);
    }
    const double scale = 1.0 / glm::length(real);
    real = real * scale;
    dual = dual * scale;
    const glm::dquat moved = dual * glm::conjugate(real) * 2.0;
    return {real, {moved.x, moved.y, moved.z}};
}

} // namespace

const SkinInfluence& Skin::of(Index vertex) const
{
    const auto after = std::upper_bound(runs.begin(), runs.end(), vertex,
                                        [](Index v, const SkinRun& run) { return v < run.firstVertex; });
    return std::prev(after)->influence;
}

Expected<Skin> bindBranches(const BranchMesh& mesh, const Skeleton& skeleton, bool smooth)
{
    if (!belongs(mesh, skeleton))
        return mismatch();
    Skin skin;
    skin.vertices = mesh.mesh.vertexCount();
    skin.bones = skeleton.size();
    const std::vector<Index>& owner = mesh.mesh.branch;
    if (!smooth) {
        for (Index v = 0; v < skin.vertices; ++v)
            append(skin, v, follow(owner[v]));
        return skin;
    }
    BranchBlend blend(mesh, skeleton);
    auto fork = mesh.forkVertices.begin();
    for (Index v = 0; v < skin.vertices; ++v) {
        const bool inFork = fork != mesh.forkVertices.end() && fork->vertex == v;
        append(skin, v, inFork ? blend.at(*fork) : blend.at(owner[v], glm::dvec3(mesh.mesh.positions[v])));
        if (inFork)
            ++fork;
    }
    return skin;
}

Expected<BarkAnchors> bindAnchors(std::span<const FoliageItem> items, const BranchMesh& branches,
                                  const Skeleton& skeleton, const Skin& bark)
{
    if (!belongs(branches, skeleton) || bark.vertices != branches.mesh.vertexCount() ||
        !std::all_of(items.begin(), items.end(),
                     [&](const FoliageItem& item) { return item.branch < skeleton.size(); }))
        return mismatch();
    const std::vector<std::span<const glm::uvec3>> tubes = trianglesOfTubes(branches, skeleton.size());
    std::vector<BarkPlace> places(items.size());
    parallelFor(items.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const std::span<const glm::uvec3> tube = tubes[items[i].branch]; !tube.empty())
                places[i] = nearestOnBark(branches.mesh, tube, items[i].position);
    });
    BarkAnchors out;
    out.leaves.vertices = static_cast<Index>(items.size());
    out.leaves.bones = out.cornerSkin.bones = skeleton.size();
    for (Index i = 0; i < items.size(); ++i)
        if (places[i].triangle.x == noIndex)
            append(out.leaves, i, follow(items[i].branch));
        else
            appendAnchor(out, i, places[i], branches.mesh, bark);
    out.cornerSkin.vertices = static_cast<Index>(out.corners.size());
    return out;
}

Expected<Skin> bindFoliage(const TriangleMesh& mesh, std::span<const FoliageItem> items,
                           const BranchMesh& branches, const Skeleton& skeleton, bool smooth)
{
    const bool fits = items.empty() ? mesh.positions.empty() : mesh.positions.size() % items.size() == 0;
    if (!fits || !belongs(branches, skeleton) ||
        !std::all_of(items.begin(), items.end(),
                     [&](const FoliageItem& item) { return item.branch < skeleton.size(); }))
        return mismatch();
    Skin skin;
    skin.vertices = mesh.vertexCount();
    skin.bones = skeleton.size();
    const std::size_t perItem = items.empty() ? 0 : mesh.positions.size() / items.size();
    BranchBlend blend(branches, skeleton);
    for (std::size_t i = 0; i < items.size(); ++i)
        append(skin, static_cast<Index>(i * perItem),
               smooth ? blend.at(items[i].branch, items[i].position) : follow(items[i].branch));
    return skin;
}

Skin bindRigidly(const TriangleMesh& mesh)
{
    Skin skin;
    skin.vertices = mesh.vertexCount();
    for (Index v = 0; v < skin.vertices; ++v) {
        const Index branch = mesh.branch[v];
        if (v == 0 || branch != mesh.branch[v - 1])
            skin.runs.push_back({v, {{branch, branch, branch}, {1.0F, 0.0F, 0.0F}}});
        skin.bones = std::max(skin.bones, branch + 1);
    }
    return skin;
}

Expected<Skin> bindLoose(Index vertices, std::size_t pieces, Index firstBone)
{
    const bool fits = pieces == 0 ? vertices == 0 : vertices % pieces == 0;
    if (!fits)
        return mismatch();
    Skin skin;
    skin.vertices = vertices;
    skin.bones = firstBone + static_cast<Index>(pieces);
    const std::size_t perPiece = pieces == 0 ? 0 : vertices / pieces;
    for (std::size_t i = 0; i < pieces; ++i)
        append(skin, static_cast<Index>(i * perPiece), follow(firstBone + static_cast<Index>(i)));
    return skin;
}

glm::dmat4 skinMatrix(const SkinInfluence& influence, std::span<const RigidTransform> pose, SkinMethod method)
{
    if (influence.weight[1] == 0.0F || method == SkinMethod::Rigid) {
        const RigidTransform& bone = pose[influence.bone[0]];
        return rigidMatrix(bone.rotation, bone.translation);
    }
    if (method == SkinMethod::Linear)
        return linearMatrix(influence, pose);
    const RigidTransform mean = meanScrew(influence, pose);
    return rigidMatrix(mean.rotation, mean.translation);
}

RigidTransform skinTransform(const SkinInfluence& influence, std::span<const RigidTransform> pose,
                             SkinMethod method, const glm::dvec3& place)
{
    if (influence.weight[1] == 0.0F || method == SkinMethod::Rigid)
        return pose[influence.bone[0]];
    RigidTransform mean = meanScrew(influence, pose);
    if (method == SkinMethod::Linear)
        mean.translation =
            glm::dvec3(linearMatrix(influence, pose) * glm::dvec4(place, 1.0)) - mean.rotation * place;
    return mean;
}

} // namespace ramure
