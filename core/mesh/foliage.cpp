#include "core/mesh/foliage.h"

#include "core/geometry/frame.h"
#include "core/mesh/foliage_shapes.h"
#include "core/random/random.h"
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr double twoPi = 2.0 * std::numbers::pi;

/// The branches' lines and where foliage may stand around them.
class Placer
{
public:
    Placer(const Skeleton& skeleton, double alpha)
        : m_skeleton(skeleton)
        , m_children(childLists(skeleton))
        , m_alpha(alpha)
    {
    }

    void setBranch(Index branch)
    {
        m_branch = branch;
        const glm::dvec3 axis = m_skeleton.p1[branch] - m_skeleton.p0[branch];
        const double length = glm::length(axis);
        m_frame = length > 0.0 ? frameFromTangent(axis / length) : Frame();
        m_reach = m_children.count(branch) == 0 ? length + m_alpha : length;
    }

    FoliageItem draw(Random& random) const
    {
        const double along = m_reach * random.unit();
        const double across = 0.5 * m_alpha * std::sqrt(random.unit());
        const double around = twoPi * random.unit();
        FoliageItem item;
        item.branch = m_branch;
        item.position = m_skeleton.p0[m_branch] + along * m_frame.tangent +
                        across * (std::cos(around) * m_frame.normal + std::sin(around) * m_frame.binormal);
        item.orientation = drawOrientation(random);
        return item;
    }

private:
    /// Uniform over all rotations: K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
    static glm::dquat drawOrientation(Random& random)
    {
        const double share = random.unit();
        const double a = twoPi * random.unit(), b = twoPi * random.unit();
        const double r0 = std::sqrt(1.0 - share), r1 = std::sqrt(share);
        return {r1 * std::cos(b), r0 * std::sin(a), r0 * std::cos(a), r1 * std::sin(b)};
    }

    const Skeleton& m_skeleton;
    ChildLists m_children;
    double m_alpha;
    Index m_branch = noIndex;
    Frame m_frame;
    double m_reach = 0.0;
};

tl::unexpected<Error> tooMany(const char* text, std::size_t limit, const char* path)
{
    auto error = fail(ErrorCode::Limit, text, {std::to_string(limit)});
    error.value().path = path;
    return error;
}

std::vector<Index> thinBranches(const Skeleton& skeleton, double below)
{
    std::vector<Index> thin;
    for (Index i = 0; i < skeleton.size(); ++i)
        if (skeleton.a0[i] < below)
            thin.push_back(i);
    return thin;
}

/// A copy of \p shape, scaled, for every item.
TriangleMesh scatter(const Skeleton& skeleton, const std::vector<FoliageItem>& items,
                     const TriangleMesh& shape, double scale)
{
    const std::size_t vertices = shape.positions.size(), faces = shape.triangles.size();
    TriangleMesh mesh;
    mesh.positions.resize(items.size() * vertices);
    mesh.normals.resize(mesh.positions.size());
    mesh.branch.resize(mesh.positions.size());
    mesh.level.resize(mesh.positions.size());
    mesh.triangles.resize(items.size() * faces);
    std::size_t vertex = 0, face = 0;
    for (const FoliageItem& item : items) {
        const glm::dmat3 turn = glm::mat3_cast(item.orientation);
        const auto first = static_cast<Index>(vertex);
        for (std::size_t i = 0; i < vertices; ++i, ++vertex) {
            mesh.positions[vertex] =
                glm::vec3(item.position + turn * (scale * glm::dvec3(shape.positions[i])));
            mesh.normals[vertex] = glm::vec3(turn * glm::dvec3(shape.normals[i]));
            mesh.branch[vertex] = item.branch;
            mesh.level[vertex] = skeleton.level[item.branch];
        }
        for (const glm::uvec3& triangle : shape.triangles)
            mesh.triangles[face++] = triangle + first;
    }
    return mesh;
}

} // namespace

Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, double alpha,
                               const Progress& progress)
{
    const std::vector<Index> thin = thinBranches(skeleton, alpha * params.leavesCutoff);
    const auto density = static_cast<std::size_t>(std::max<std::int64_t>(params.leavesDensity, 0));
    if (!thin.empty() && density > maxLeaves / thin.size())
        return tooMany(RAMURE_NOOP("the tree would carry more than %1 leaves"), maxLeaves,
                       "foliage.leavesDensity");
    const auto seed = static_cast<std::uint64_t>(params.seed);
    Foliage foliage;
    foliage.leaves.reserve(thin.size() * density);
    Placer placer(skeleton, alpha);
    for (std::size_t i = 0; i < thin.size(); ++i) {
        if (i % 4096 == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        placer.setBranch(thin[i]);
        Random forLeaves(seed, RandomStream::Leaves, skeleton.key[thin[i]]);
        for (std::size_t leaf = 0; leaf < density; ++leaf)
            foliage.leaves.push_back(placer.draw(forLeaves));
        Random forApples(seed, RandomStream::Apples, skeleton.key[thin[i]]);
        if (forApples.unit() < params.applesProbability)
            foliage.apples.push_back(placer.draw(forApples));
        if (foliage.apples.size() > maxApples)
            return tooMany(RAMURE_NOOP("the tree would carry more than %1 apples"), maxApples,
                           "foliage.applesProbability");
    }
    return foliage;
}

TriangleMesh buildLeaves(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model)
{
    const TriangleMesh shape = model == FoliageModel::Rough ? unitSquare() : unitTriangle();
    return scatter(skeleton, foliage.leaves, shape, alpha);
}

TriangleMesh buildApples(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model)
{
    if (model == FoliageModel::Rough)
        return scatter(skeleton, foliage.apples, unitCube(), alpha);
    return scatter(skeleton, foliage.apples, unitSphere(), 0.5 * alpha);
}

} // namespace ramure
