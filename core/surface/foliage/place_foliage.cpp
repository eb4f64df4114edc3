#include "core/surface/foliage/place_foliage.h"

#include "core/base/parallel.h"
#include "core/math/frame.h"
#include "core/math/random.h"
#include "core/surface/foliage/foliage_shapes.h"
#include "core/surface/foliage/fruit_placement.h"
#include "core/surface/foliage/leaf_damage.h"
#include "core/surface/foliage/leaf_light.h"
#include "core/surface/foliage/leaf_placement.h"
#include "core/surface/foliage/leaf_season.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/organ_placement.h"
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

std::vector<Index> thinBranches(const Skeleton& skeleton, double below)
{
    std::vector<Index> thin;
    auto bare = skeleton.bare.begin();
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (bare != skeleton.bare.end() && *bare == i)
            ++bare;
        else if (skeleton.a0[i] < below)
            thin.push_back(i);
    }
    return thin;
}

/// Copy number \p copy of a shape, at an item's place. Shapes with colours give each copy its tone.
void place(const FoliageItem& item, Index level, const TriangleMesh& shape, std::size_t copy,
           TriangleMesh& mesh)
{
    const std::size_t vertices = shape.positions.size(), faces = shape.triangles.size(),
                      first = copy * vertices;
    const glm::mat3 turn(glm::mat3_cast(item.orientation));
    const glm::vec3 centre(item.position);
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions[first + i] = centre + turn * (item.size * shape.positions[i]);
        mesh.normals[first + i] = turn * shape.normals[i];
        mesh.branch[first + i] = item.branch;
        mesh.level[first + i] = level;
    }
    for (std::size_t f = 0; f < faces; ++f)
        mesh.triangles[copy * faces + f] = shape.triangles[f] + static_cast<Index>(first);
    for (std::size_t f = 0; f < shape.colours.size(); ++f)
        mesh.colours[copy * faces + f] =
            glm::u8vec3(item.tone * item.tint * glm::vec3(shape.colours[f]) + 0.5F);
}

TriangleMesh scaled(TriangleMesh shape, double scale)
{
    for (glm::vec3& position : shape.positions)
        position *= static_cast<float>(scale);
    return shape;
}

/// A copy of \p shape for every item.
TriangleMesh scatter(const Skeleton& skeleton, const std::vector<FoliageItem>& items,
                     const TriangleMesh& shape, const Progress& progress)
{
    const std::size_t vertices = shape.positions.size(), faces = shape.triangles.size();
    TriangleMesh mesh;
    if (progress.cancelled())
        return mesh; // before the memory is taken
    mesh.positions.resize(items.size() * vertices);
    mesh.normals.resize(items.size() * vertices);
    mesh.branch.resize(items.size() * vertices);
    mesh.level.resize(items.size() * vertices);
    mesh.triangles.resize(items.size() * faces);
    mesh.colours.resize(items.size() * shape.colours.size());
    parallelFor(items.size(), std::max<std::size_t>(1, verticesAtOnce / vertices),
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end && !progress.cancelled(); ++i)
                        place(items[i], skeleton.level[items[i].branch], shape, i, mesh);
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

/// The rule of SPEC A3.
Expected<std::vector<FoliageItem>> placeFaithfully(const Placing& placing, std::size_t density,
                                                   const Progress& progress)
{
    const std::vector<Index>& twigs = placing.twigs;
    if (!twigs.empty() && density > maxLeaves / twigs.size())
        return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 leaves"), maxLeaves,
                              "foliage.leavesDensity");
    std::vector<FoliageItem> leaves(twigs.size() * density);
    parallelFor(twigs.size(), branchesAtOnce, [&](std::size_t begin, std::size_t end) {
        if (progress.cancelled())
            return;
        Placer placer(placing.skeleton, placing.isTip, placing.alpha);
        for (std::size_t i = begin; i < end; ++i) {
            placer.setBranch(twigs[i]);
            Random random(placing.seed, RandomStream::Leaves, placing.skeleton.key[twigs[i]]);
            for (std::size_t leaf = 0; leaf < density; ++leaf)
                leaves[i * density + leaf] = placer.draw(random);
        }
    });
    return leaves;
}

Expected<std::vector<FoliageItem>> placeApples(const Placing& placing, double probability)
{
    std::vector<FoliageItem> apples;
    Placer placer(placing.skeleton, placing.isTip, placing.alpha);
    for (const Index branch : placing.twigs) {
        Random random(placing.seed, RandomStream::Apples, placing.skeleton.key[branch]);
        if (random.unit() >= probability)
            continue;
        placer.setBranch(branch);
        apples.push_back(placer.draw(random));
        if (apples.size() > maxApples)
            return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 apples"), maxApples,
                                  "foliage.applesProbability");
    }
    return apples;
}

} // namespace

tl::unexpected<Error> tooMuchFoliage(const char* text, std::size_t limit, const char* path)
{
    auto error = fail(ErrorCode::Limit, text, {std::to_string(limit)});
    error.value().path = path;
    return error;
}

Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, const LeafParams& leaf,
                               const FruitParams& fruit, double alpha, const Progress& progress)
{
    const Placing placing{skeleton, thinBranches(skeleton, alpha * params.leavesCutoff), tips(skeleton),
                          alpha, static_cast<std::uint64_t>(params.seed)};
    const auto density = static_cast<std::size_t>(std::max<std::int64_t>(params.leavesDensity, 0));
    auto leaves = leaf.shape == LeafShape::Faithful ? placeFaithfully(placing, density, progress)
                  : density == 0                    ? Expected<std::vector<FoliageItem>>()
                                                    : placeLeaves(placing, leaf, progress);
    RAMURE_TRY(leaves);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    const FruitForm hung = fruitForm(fruit);
    auto apples = fruit.kind == FruitKind::Faithful ? placeApples(placing, params.applesProbability)
                                                    : placeFruit(placing, hung, params.applesProbability);
    RAMURE_TRY(apples);
    Foliage made{std::move(*leaves), std::move(*apples), {}, leafForm(leaf), hung};
    RAMURE_TRY(placeOrgans(skeleton, leaf, alpha, made));
    if (leaf.shape != LeafShape::Faithful) {
        growByLight(leaf.shade, made);
        damageLeaves(skeleton, leaf.damage, made);
    }
    if (hung.ripens)
        ripen(skeleton, fruit.ripeness, made);
    if (made.form.turns && made.form.shape != LeafShape::Faithful)
        turnLeaves(skeleton, leaf.season, made);
    if (leaf.shape != LeafShape::Faithful)
        dropFruit(skeleton, leaf.season, made);
    return made;
}

Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, double alpha,
                               const Progress& progress)
{
    return placeFoliage(skeleton, params, LeafParams(), FruitParams(), alpha, progress);
}

TriangleMesh oneLeaf(const LeafForm& form, double alpha, FoliageModel model)
{
    const bool faithful = form.shape == LeafShape::Faithful;
    const double size = leafLength(form, alpha);
    const bool rhomb = model == FoliageModel::Rhomb;
    if (model == FoliageModel::Fine)
        return scaled(faithful ? unitTriangle() : leafMesh(form), size);
    if (!faithful)
        return scaled(leafCard(form, rhomb ? CardOutline::Rhomb : CardOutline::Square), size);
    return scaled(rhomb ? rhombIn(unitSquare()) : unitSquare(), size);
}

TriangleMesh oneApple(const FruitForm& form, double alpha, FoliageModel model)
{
    return scaled(model == FoliageModel::Fine ? fruitMesh(form) : fruitCube(form), fruitRadius(form, alpha));
}

TriangleMesh buildLeaves(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model,
                         const Progress& progress)
{
    return scatter(skeleton, foliage.leaves, oneLeaf(foliage.form, alpha, model), progress);
}

TriangleMesh buildApples(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model,
                         const Progress& progress)
{
    return scatter(skeleton, foliage.apples, oneApple(foliage.fruit, alpha, model), progress);
}

} // namespace ramure
