#include "core/surface/foliage/foliage.h"

#include "core/base/parallel.h"
#include "core/math/frame.h"
#include "core/math/random.h"
#include "core/surface/foliage/foliage_shapes.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr std::size_t branchesAtOnce = 256, verticesAtOnce = 8192;

/// The branches' lines and where foliage may stand around them.
class Placer
{
public:
    /// \param isTip per branch: it has no children
    Placer(const Skeleton& skeleton, const std::vector<std::uint8_t>& isTip, double alpha)
        : m_skeleton(skeleton)
        , m_isTip(isTip)
        , m_alpha(alpha)
    {
    }

    void setBranch(Index branch)
    {
        m_branch = branch;
        const glm::dvec3 axis = m_skeleton.p1[branch] - m_skeleton.p0[branch];
        const double length = glm::length(axis);
        m_frame = length > 0.0 ? frameFromTangent(axis / length) : Frame();
        m_reach = m_isTip[branch] != 0 ? length + m_alpha : length;
    }

    FoliageItem draw(Random& random) const
    {
        const double along = m_reach * random.unit();
        const glm::dvec2 across = 0.5 * m_alpha * drawOnDisc(random);
        FoliageItem item;
        item.branch = m_branch;
        item.position = m_skeleton.p0[m_branch] + along * m_frame.tangent + across.x * m_frame.normal +
                        across.y * m_frame.binormal;
        item.orientation = drawOrientation(random);
        return item;
    }

private:
    /// Even over the open unit disc, by rejection: plain arithmetic, the same on every machine.
    static glm::dvec2 drawOnDisc(Random& random)
    {
        for (;;) {
            const double x = random.range(-1.0, 1.0), y = random.range(-1.0, 1.0);
            if (x * x + y * y < 1.0)
                return {x, y};
        }
    }
    /// Even over all rotations: G. Marsaglia, "Choosing a point from the surface of a sphere", 1972, his
    /// point of the sphere in four dimensions.
    static glm::dquat drawOrientation(Random& random)
    {
        const glm::dvec2 a = drawOnDisc(random), b = drawOnDisc(random);
        const double inA = glm::dot(a, a), inB = glm::dot(b, b);
        if (inB == 0.0)
            return {1.0, 0.0, 0.0, 0.0};
        const double share = std::sqrt((1.0 - inA) / inB);
        return {a.x, a.y, share * b.x, share * b.y};
    }

    const Skeleton& m_skeleton;
    const std::vector<std::uint8_t>& m_isTip;
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

/// Copy number \p copy of a shape, at an item's place.
void place(const FoliageItem& item, Index level, const std::vector<glm::vec3>& scaled,
           const TriangleMesh& shape, std::size_t copy, TriangleMesh& mesh)
{
    const std::size_t vertices = scaled.size(), faces = shape.triangles.size(), first = copy * vertices;
    const glm::mat3 turn(glm::mat3_cast(item.orientation));
    const glm::vec3 centre(item.position);
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions[first + i] = centre + turn * scaled[i];
        mesh.normals[first + i] = turn * shape.normals[i];
        mesh.branch[first + i] = item.branch;
        mesh.level[first + i] = level;
    }
    for (std::size_t f = 0; f < faces; ++f)
        mesh.triangles[copy * faces + f] = shape.triangles[f] + static_cast<Index>(first);
}

/// A copy of \p shape, scaled, for every item.
TriangleMesh scatter(const Skeleton& skeleton, const std::vector<FoliageItem>& items,
                     const TriangleMesh& shape, double scale)
{
    const std::size_t vertices = shape.positions.size(), faces = shape.triangles.size();
    std::vector<glm::vec3> scaled = shape.positions;
    for (glm::vec3& position : scaled)
        position *= static_cast<float>(scale);
    TriangleMesh mesh;
    mesh.positions.resize(items.size() * vertices);
    mesh.normals.resize(items.size() * vertices);
    mesh.branch.resize(items.size() * vertices);
    mesh.level.resize(items.size() * vertices);
    mesh.triangles.resize(items.size() * faces);
    parallelFor(items.size(), std::max<std::size_t>(1, verticesAtOnce / vertices),
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                        place(items[i], skeleton.level[items[i].branch], scaled, shape, i, mesh);
                });
    return mesh;
}

std::vector<std::uint8_t> tips(const Skeleton& skeleton)
{
    std::vector<std::uint8_t> isTip(skeleton.size(), 1);
    for (const Index parent : skeleton.parent)
        if (parent != noIndex)
            isTip[parent] = 0;
    return isTip;
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
    foliage.leaves.resize(thin.size() * density);
    const std::vector<std::uint8_t> isTip = tips(skeleton);
    parallelFor(thin.size(), branchesAtOnce, [&](std::size_t begin, std::size_t end) {
        if (progress.cancelled())
            return;
        Placer placer(skeleton, isTip, alpha);
        for (std::size_t i = begin; i < end; ++i) {
            placer.setBranch(thin[i]);
            Random random(seed, RandomStream::Leaves, skeleton.key[thin[i]]);
            for (std::size_t leaf = 0; leaf < density; ++leaf)
                foliage.leaves[i * density + leaf] = placer.draw(random);
        }
    });
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    Placer placer(skeleton, isTip, alpha);
    for (const Index branch : thin) {
        Random random(seed, RandomStream::Apples, skeleton.key[branch]);
        if (random.unit() >= params.applesProbability)
            continue;
        placer.setBranch(branch);
        foliage.apples.push_back(placer.draw(random));
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
