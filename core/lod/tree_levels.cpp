#include "core/lod/tree_levels.h"

#include "core/lod/leaf_clusters.h"
#include "core/lod/level_leaves.h"
#include "core/lod/tree_picture.h"
#include "core/math/reproducible.h"
#include "core/params/source_facts.h"
#include "core/pipeline/bark_feet.h"
#include "core/surface/check/verdict.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/plain_colours.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/season/foliage_on_day.h"
#include "core/surface/texture/cut_wood.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>

namespace ramure {
namespace {

/// Of a level's triangles, those of leaves, where they are more than the bark's; and of fruit, at most.
constexpr double leastLeafShare = 0.3, mostLeafShare = 0.7, fruitShare = 0.1;
/// Of the triangles of the bark, what its twigs need at least; the rest makes it round.
constexpr double woodShare = 0.75;
/// Leaves are as detailed as lets this share of them stay.
constexpr double wantedLeaves = 0.5;
constexpr double mostFruitGrowth = 2.0;
/// Bends are straightened, rad, where so small a share of the triangles is left.
constexpr double someBends = 0.2, manyBends = 0.35, manyBendsBelow = 0.05;
constexpr int mostTrials = 8;
/// No further trial where a level is so near to its budget.
constexpr double nearEnough = 0.004;

std::int64_t facesOf(const std::shared_ptr<const TriangleMesh>& mesh)
{
    return mesh ? mesh->faceCount() : 0;
}

tl::unexpected<Error> cancelled()
{
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
}

/// All that the levels of one tree have in common.
class LevelMaker
{
public:
    LevelMaker(const TreeResult& tree, const NodeParams& params, const LevelParts& parts,
               const LevelOptions& options)
        : m_tree(tree)
        , m_params(params)
        , m_parts(parts)
        , m_skeleton(tree.simplified->skeleton)
        , m_order(*tree.skeleton, *tree.simplified)
        , m_alpha(trunkRadius(params))
        , m_axes(m_order.axes())
        , m_stood(options.beginsWhole())
        , m_cards(options.cards)
    {
    }

    Expected<void> prepare(const Progress& progress);
    /// The tree as it is.
    Expected<TreeLevel> whole(const Progress& progress);
    Expected<TreeLevel> level(std::int64_t budget, const Progress& progress);
    [[nodiscard]] std::int64_t usualBudget(const TreeLevel& before) const;
    /// The tree on crossed cards. \param finest whose bark they show, with all leaves
    Expected<TreeLevel> billboard(const TreeLevel& finest) const;

private:
    struct Split
    {
        std::size_t leafShape = 0;
        std::size_t leaves = 0, apples = 0; ///< how many
        double bark = 0.0;                  ///< triangles
    };
    struct Wood
    {
        PrunedTree pruned;
        std::shared_ptr<const BranchMesh> mesh;
    };

    [[nodiscard]] Split splitOf(std::int64_t budget) const;
    [[nodiscard]] std::int64_t leafFaces(const Split& split) const;
    [[nodiscard]] double mergeRadFor(std::int64_t budget) const;
    Expected<Wood> woodFor(std::int64_t budget, Split& split, const Progress& progress);
    Expected<Wood> build(double triangles, double mergeRad, const Progress& progress) const;
    [[nodiscard]] std::int64_t fillLeaves(std::int64_t budget, std::int64_t bark, Split& split) const;
    [[nodiscard]] std::vector<double> rolls(const PrunedTree& pruned) const;
    void addFoliage(TreeLevel& level, const Split& split);
    void addLeaves(TreeLevel& level, const Split& split, Foliage& foliage);
    void addSprays(TreeLevel& level, Foliage& foliage);
    void addApples(TreeLevel& level, const Split& split, Foliage& foliage);
    void stand(const TreeLevel& level);
    Expected<void> addBark(TreeLevel& level, const Progress& progress);
    void measure(TreeLevel& level);

    const TreeResult& m_tree;
    const NodeParams& m_params;
    const LevelParts& m_parts;
    const Skeleton& m_skeleton;
    TwigOrder m_order;
    double m_alpha;
    Index m_axes;                          ///< of the level before
    bool m_stood = false, m_cards = false; ///< leaves and fruit stand on the bark that they are seen on
    Foliage m_foliage;                     ///< all of the tree's
    std::vector<LeafCluster> m_clusters;   ///< of the level before
    std::vector<double> m_appleChance;
    std::vector<Index> m_leaves, m_apples; ///< of the level before
    std::vector<LeafShapeOfLevel> m_shapes;
    glm::dvec3 m_crown{0.0};                    ///< the middle of all leaves
    double m_leafArea = 0.0, m_appleArea = 0.0; ///< m² of all, the fruit's of their size squares alone
    std::int64_t m_appleFaces = 0;
    double m_wholeFaces = 0.0, m_wholeLeafFaces = 0.0;
    double m_tileSize = 0.0;
};

Expected<void> LevelMaker::prepare(const Progress& progress)
{
    if (m_parts.leaves || m_parts.apples) {
        if (m_stood) {
            m_foliage = *m_tree.foliage;
        } else {
            auto placed = foliageOf(m_skeleton, m_params, progress);
            RAMURE_TRY(placed);
            m_foliage = std::move(*placed);
        }
    }
    if (!m_parts.leaves)
        m_foliage.leaves.clear();
    if (!m_parts.apples)
        m_foliage.apples.clear();
    const auto numbers = [](const std::vector<FoliageItem>& items) {
        std::vector<Index> out(items.size());
        std::iota(out.begin(), out.end(), Index(0));
        return out;
    };
    m_leaves = numbers(m_foliage.leaves);
    m_apples = numbers(m_foliage.apples);
    m_clusters = singleClusters(m_leaves);
    m_appleChance = itemChances(m_foliage.apples);
    if (!m_leaves.empty())
        m_shapes = leafShapesOfLevels(m_foliage.form, m_params.leafPictures, m_alpha, m_cards);
    if (m_shapes.empty())
        m_leaves.clear(); // without width they are nothing
    if (!m_apples.empty())
        m_appleFaces = oneApple(m_foliage.fruit, m_alpha, FoliageModel::Fine).faceCount();
    for (const Index i : m_leaves)
        m_crown += m_foliage.leaves[i].position / static_cast<double>(m_leaves.size());
    for (const Index i : m_leaves)
        m_leafArea +=
            m_shapes.front().area * double(m_foliage.leaves[i].size) * double(m_foliage.leaves[i].size);
    for (const FoliageItem& item : m_foliage.apples)
        m_appleArea += double(item.size) * double(item.size);
    if (!m_leaves.empty())
        m_wholeLeafFaces = double(m_leaves.size()) * m_shapes.front().mesh.faceCount();
    const SectionParams& sections = m_params.sections;
    const double bark = m_params.mesh.targetTriangles > 0
                            ? double(m_params.mesh.targetTriangles)
                            : 2.0 * m_skeleton.size() * double(sections.lengthDivisions - 1) *
                                  double(sections.radialDivisions);
    m_wholeFaces = bark + m_wholeLeafFaces + double(m_apples.size()) * double(m_appleFaces);
    return {};
}

Expected<TreeLevel> LevelMaker::whole(const Progress& progress)
{
    TreeLevel out;
    out.wood = m_order.pruned(m_order.axes(), 0.0);
    out.branches = m_parts.branches ? m_tree.branches : nullptr;
    out.leafOf = m_leaves;
    out.appleOf = m_apples;
    out.leafArea = m_leafArea;
    out.foliage = std::make_shared<const Foliage>(m_foliage);
    if (m_parts.leaves && m_tree.leaves && !m_tree.leaves->empty()) {
        TriangleMesh leaves = *m_tree.leaves;
        if (m_parts.texture)
            addLeafTexture(leaves, m_foliage.form);
        out.leaves = std::make_shared<const TriangleMesh>(std::move(leaves));
    }
    if (m_parts.apples && m_tree.apples && !m_tree.apples->empty()) {
        TriangleMesh apples = *m_tree.apples;
        if (m_parts.texture)
            addAppleTexture(apples, m_foliage.fruit);
        out.apples = std::make_shared<const TriangleMesh>(std::move(apples));
    }
    RAMURE_TRY(addBark(out, progress));
    return out;
}

double LevelMaker::mergeRadFor(std::int64_t budget) const
{
    const double own = m_params.simplify.enabled ? m_params.simplify.rotationThreshold : 0.0;
    if (double(budget) >= m_wholeFaces)
        return 0.0;
    return std::max(own, double(budget) < manyBendsBelow * m_wholeFaces ? manyBends : someBends);
}

/// Leaves and bark share a level about as they share the tree.
LevelMaker::Split LevelMaker::splitOf(std::int64_t budget) const
{
    Split out;
    const auto wanted = static_cast<double>(budget);
    double rest = wanted;
    if (m_appleFaces > 0) {
        const double most = m_parts.branches || !m_leaves.empty() ? fruitShare * wanted : wanted;
        out.apples = std::min(m_apples.size(), static_cast<std::size_t>(most / double(m_appleFaces)));
        rest -= double(out.apples) * double(m_appleFaces);
    }
    if (!m_leaves.empty()) {
        const double share =
            m_parts.branches
                ? std::clamp(m_wholeLeafFaces / m_wholeFaces, leastLeafShare, mostLeafShare) * rest
                : rest;
        const double wish = wantedLeaves * double(m_leaves.size());
        while (out.leafShape + 1 < m_shapes.size() &&
               share / double(m_shapes[out.leafShape].mesh.faceCount()) < wish)
            ++out.leafShape;
        const double each = m_shapes[out.leafShape].mesh.faceCount();
        out.leaves =
            std::min(m_leaves.size(), std::max<std::size_t>(1, static_cast<std::size_t>(share / each)));
        rest -= double(out.leaves) * each;
    }
    out.bark = m_parts.branches ? rest : 0.0;
    return out;
}

std::int64_t LevelMaker::leafFaces(const Split& split) const
{
    return m_leaves.empty()
               ? 0
               : static_cast<std::int64_t>(split.leaves) * m_shapes[split.leafShape].mesh.faceCount();
}

/// As many leaves as the bark has left room for. \return the triangles of all.
std::int64_t LevelMaker::fillLeaves(std::int64_t budget, std::int64_t bark, Split& split) const
{
    const std::int64_t fruit = static_cast<std::int64_t>(split.apples) * m_appleFaces;
    if (!m_leaves.empty()) {
        const std::int64_t each = m_shapes[split.leafShape].mesh.faceCount();
        const std::int64_t room = std::max<std::int64_t>(1, (budget - bark - fruit) / each);
        split.leaves = std::min(m_leaves.size(), static_cast<std::size_t>(room));
    }
    return bark + fruit + leafFaces(split);
}

std::vector<double> LevelMaker::rolls(const PrunedTree& pruned) const
{
    const std::vector<double> all = m_skeleton.rollOfEach();
    std::vector<double> out(all.empty() ? 0 : pruned.skeleton.size(), 0.0);
    for (Index b = 0; b < out.size(); ++b)
        out[b] = all[pruned.run(b).front()];
    return out;
}

Expected<LevelMaker::Wood> LevelMaker::build(double triangles, double mergeRad,
                                             const Progress& progress) const
{
    Wood out{m_order.pruned(m_axes, mergeRad), nullptr};
    const std::vector<double> turns = rolls(out.pruned);
    BranchMeshOptions options{m_params.sections,  m_params.mesh,     true, turns,
                              treeSeed(m_params), groundOf(m_params)};
    options.targetTriangles = std::max<std::int64_t>(1, std::llround(triangles));
    auto mesh = buildBranchMesh(out.pruned.skeleton, options, progress);
    RAMURE_TRY(mesh);
    out.mesh = std::make_shared<const BranchMesh>(std::move(*mesh));
    return out;
}

/// What a mesh comes to is known when it is there: the next one is told by how much the last was off, and
/// where its branches alone are too many, fewer twigs stay.
Expected<LevelMaker::Wood> LevelMaker::woodFor(std::int64_t budget, Split& split, const Progress& progress)
{
    const double mergeRad = mergeRadFor(budget);
    m_axes =
        std::min(m_axes, double(budget) < m_wholeFaces ? m_order.axesFor(woodShare * split.bark, mergeRad)
                                                       : m_order.axes());
    std::optional<Wood> best;
    Split bestSplit = split;
    double wanted = split.bark, bestMiss = 0.0;
    double tooFew = 0.0, tooMany = 0.0;
    for (int trial = 0; trial < mostTrials; ++trial) {
        const double from = double(trial) / mostTrials;
        auto wood = build(wanted, mergeRad, progress.part(from, from + 1.0 / mostTrials));
        if (!wood)
            return wood;
        const std::int64_t bark = wood->mesh->mesh.faceCount();
        const BudgetFit fit = wood->mesh->budget;
        Split filled = split;
        const double all = static_cast<double>(fillLeaves(budget, bark, filled));
        const double miss = std::abs(all - double(budget));
        if (!best || miss < bestMiss) {
            best = std::move(*wood);
            bestSplit = filled;
            bestMiss = miss;
        }
        if (miss <= nearEnough * double(budget))
            break;
        const double off = split.bark / double(bark);
        if (fit == BudgetFit::Smallest && double(bark) > split.bark) {
            if (m_axes == m_order.leastAxes())
                break;
            m_axes = std::max(m_order.leastAxes(),
                              static_cast<Index>(0.95 * double(m_axes) * std::min(off, 0.95)));
            tooFew = tooMany = 0.0;
            continue;
        }
        if (fit == BudgetFit::Largest && double(bark) < split.bark)
            break;
        // By the ratio it swings to and fro where the mesher's steps are coarse: between two it is halved.
        (double(bark) < split.bark ? tooFew : tooMany) = wanted;
        wanted = tooFew > 0.0 && tooMany > 0.0 ? 0.5 * (tooFew + tooMany)
                                               : std::clamp(wanted * off, 0.5 * split.bark, 2.0 * split.bark);
    }
    split = bestSplit;
    return std::move(*best);
}

/// Once, on the first bark they are seen on: later levels have them in the same places.
void LevelMaker::stand(const TreeLevel& level)
{
    if (std::exchange(m_stood, true) || !level.branches)
        return;
    Foliage own{{}, {}, {}, m_foliage.form, m_foliage.fruit};
    const auto take = [&](const std::vector<FoliageItem>& from, std::vector<FoliageItem>& to) {
        for (FoliageItem item : from)
            if (item.branch = level.wood.branchOf[item.branch]; item.branch != noIndex)
                to.push_back(item);
    };
    const auto put = [&](const std::vector<FoliageItem>& from, std::vector<FoliageItem>& to) {
        auto next = from.begin();
        for (FoliageItem& item : to)
            if (level.wood.branchOf[item.branch] != noIndex)
                item.position = (next++)->position;
    };
    take(m_foliage.leaves, own.leaves);
    take(m_foliage.apples, own.apples);
    standOnBark(own, *level.branches, level.wood.skeleton.size(), m_alpha);
    put(own.leaves, m_foliage.leaves);
    put(own.apples, m_foliage.apples);
}

void LevelMaker::addLeaves(TreeLevel& level, const Split& split, Foliage& foliage)
{
    const LeafShapeOfLevel& whole = m_shapes.front();
    const LeafShapeOfLevel& own = m_shapes[split.leafShape];
    const double each = double(m_foliage.leaves.size()) / double(split.leaves) * whole.area / own.area;
    const LeafShapeOfLevel shape = broadened(own, each, m_alpha);
    m_clusters = joinedClusters(m_foliage.leaves, std::move(m_clusters), level.wood.branchOf, whole.middle,
                                split.leaves);
    m_leaves.clear();
    std::ranges::transform(m_clusters, std::back_inserter(m_leaves), &LeafCluster::leaf);
    level.leafOf = m_leaves;
    if (own.isSpray)
        return addSprays(level, foliage);
    for (const LeafCluster& cluster : m_clusters)
        foliage.leaves.push_back(leafOfCluster(m_foliage.leaves, cluster, whole, shape, m_crown));
    level.leafScale =
        std::sqrt(double(m_foliage.leaves.size()) / double(m_leaves.size()) * whole.area / shape.area);
    foliage.form = shape.form;
    TriangleMesh leaves = buildLeaves(m_skeleton, foliage, m_alpha, shape.model);
    level.leafArea = areaOf(leaves);
    if (m_parts.texture) {
        const std::vector<glm::vec2>& uv = shape.mesh.uv;
        if (uv.empty())
            addLeafTexture(leaves, shape.form);
        else
            for (std::size_t v = 0; v < leaves.positions.size(); ++v)
                leaves.uv.push_back(uv[v % uv.size()]);
    }
    level.leaves = std::make_shared<const TriangleMesh>(std::move(leaves));
}

void LevelMaker::addSprays(TreeLevel& level, Foliage& foliage)
{
    LeafSprays sprays = leafSprays(m_foliage, m_clusters, m_shapes.front());
    level.leaves = std::make_shared<const TriangleMesh>(buildSprays(m_skeleton, sprays));
    level.leafArea = sprays.area;
    level.sprays = std::move(sprays.atlas);
    foliage.leaves = std::move(sprays.items);
}

void LevelMaker::addApples(TreeLevel& level, const Split& split, Foliage& foliage)
{
    level.appleOf = m_apples =
        chosenItems(m_foliage.apples, m_appleChance, m_apples, level.wood.branchOf, split.apples);
    for (const Index i : level.appleOf)
        foliage.apples.push_back(m_foliage.apples[i]);
    double squares = 0.0;
    for (const FoliageItem& item : foliage.apples)
        squares += double(item.size) * double(item.size);
    enlarge(foliage.apples, std::min(m_appleArea, mostFruitGrowth * mostFruitGrowth * squares), 1.0);
    TriangleMesh apples = buildApples(m_skeleton, foliage, m_alpha, FoliageModel::Fine);
    if (m_parts.texture)
        addAppleTexture(apples, foliage.fruit);
    level.apples = std::make_shared<const TriangleMesh>(std::move(apples));
}

void LevelMaker::addFoliage(TreeLevel& level, const Split& split)
{
    Foliage foliage{{}, {}, {}, m_foliage.form, m_foliage.fruit};
    if (!m_leaves.empty())
        addLeaves(level, split, foliage);
    if (split.apples > 0)
        addApples(level, split, foliage);
    else
        m_apples.clear();
    level.foliage = std::make_shared<const Foliage>(std::move(foliage));
}

/// With the tree's numbers of branches, and the tiles of the first level.
Expected<void> LevelMaker::addBark(TreeLevel& level, const Progress& progress)
{
    if (!level.branches)
        return {};
    TriangleMesh bark = level.branches->mesh;
    if (m_parts.texture) {
        TextureParams params = m_params.texture;
        if (m_tileSize > 0.0)
            params.tileSize = m_tileSize;
        const bool isWhole = level.branches == m_tree.branches;
        const auto texture = isWhole ? m_tree.texture->coordinates(params, progress)
                                     : TextureStage(level.branches).coordinates(params, progress);
        RAMURE_TRY(texture);
        m_tileSize = (*texture)->tileSize;
        wear(bark, **texture);
    }
    const auto renumber = [&](TriangleMesh& mesh) {
        for (std::size_t v = 0; v < mesh.branch.size(); ++v) {
            mesh.branch[v] = level.wood.run(mesh.branch[v]).front();
            mesh.level[v] = m_skeleton.level[mesh.branch[v]];
        }
    };
    renumber(bark);
    level.bark = std::make_shared<const TriangleMesh>(std::move(bark));
    if (TriangleMesh cuts = cutWood(*level.branches, level.wood.skeleton); !cuts.empty()) {
        renumber(cuts);
        level.cuts = std::make_shared<const TriangleMesh>(std::move(cuts));
    }
    return {};
}

/// A leaf that is a pixel wide can be any other one, and where it is in a cluster that is as small does not
/// matter; so can a twig that is thinner than half of one.
void LevelMaker::measure(TreeLevel& level)
{
    double detail = 0.5 * m_order.thickestGone(m_axes);
    if (level.leaves && !level.foliage->leaves.empty())
        detail = std::max({detail, std::sqrt(level.leafArea / double(level.foliage->leaves.size())),
                           extentOf(m_foliage.leaves, m_clusters, m_shapes.front())});
    if (level.branches) { // how far an edge of its bark is from the round of the thickest branch
        const TriangleMesh& bark = level.branches->mesh;
        const double thickest = *std::ranges::max_element(m_skeleton.a0);
        const double chordSquared = 2.0 * areaOf(bark) / double(bark.faceCount());
        detail = std::max(detail, std::min(chordSquared / (8.0 * thickest), thickest));
    }
    level.detail = detail;
}

/// Where a level's leaves are so simple that they need less than their share, the bark does not get the rest:
/// it would be finer than that of the level before.
std::int64_t LevelMaker::usualBudget(const TreeLevel& before) const
{
    const double budget = levelStep * double(before.triangles());
    const double most = levelBarkStep * double(facesOf(before.bark));
    const double excess = std::max(0.0, splitOf(std::llround(budget)).bark - most);
    return std::max<std::int64_t>(leastBudget, std::llround(m_leaves.empty() ? budget : budget - excess));
}

Expected<TreeLevel> LevelMaker::level(std::int64_t budget, const Progress& progress)
{
    Split split = splitOf(budget);
    TreeLevel out;
    out.wood = m_order.pruned(m_order.leastAxes(), 0.0);
    if (m_parts.branches) {
        auto wood = woodFor(budget, split, progress.part(0.0, 0.7));
        RAMURE_TRY(wood);
        out.wood = std::move(wood->pruned);
        out.branches = std::move(wood->mesh);
        const auto report = validateMesh(out.branches->mesh);
        RAMURE_TRY(report);
        if (verdictOn(*report, nullptr, out.branches->roots) == MeshVerdict::Broken)
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the bark of a level does not pass its proof"));
    }
    if (progress.cancelled())
        return cancelled();
    stand(out);
    addFoliage(out, split);
    RAMURE_TRY(addBark(out, progress.part(0.7, 1.0)));
    const std::int64_t got = out.triangles();
    if (std::abs(double(got - budget)) > levelSlack * double(budget))
        return fail(ErrorCode::Limit,
                    RAMURE_NOOP("this tree has no level of %1 triangles: the nearest has %2"),
                    {std::to_string(budget), std::to_string(got)});
    measure(out);
    return out;
}

Expected<TreeLevel> LevelMaker::billboard(const TreeLevel& finest) const
{
    std::vector<ShownSurface> surfaces;
    if (finest.bark)
        surfaces.push_back({finest.bark, {}, {}, m_params.bark, plainBark});
    if (!m_leaves.empty()) {
        const LeafForm& form = m_foliage.form;
        const bool isPlain = form.shape == LeafShape::Faithful;
        surfaces.push_back({std::make_shared<const TriangleMesh>(m_shapes.front().mesh),
                            m_foliage.leaves,
                            form,
                            {},
                            isPlain      ? plainLeaf
                            : form.onDay ? glm::u8vec3(255)
                                         : leafColour(form.shape, form.turns)});
    }
    if (!m_foliage.apples.empty())
        surfaces.push_back(
            {std::make_shared<const TriangleMesh>(oneApple(m_foliage.fruit, m_alpha, FoliageModel::Fine)),
             m_foliage.apples,
             {},
             {},
             m_foliage.fruit.kind == FruitKind::Faithful ? plainFruit : glm::u8vec3(255)});
    glm::dvec3 foot(0.0);
    double roots = 0.0;
    for (Index b = 0; b < m_skeleton.size(); ++b)
        if (m_skeleton.parent[b] == noIndex) {
            foot += m_skeleton.p0[b];
            roots += 1.0;
        }
    auto picture = treePicture(surfaces, foot / std::max(roots, 1.0));
    RAMURE_TRY(picture);
    TreeLevel out;
    out.wood = m_order.pruned(m_order.leastAxes(), 0.0);
    TriangleMesh& cards = picture->cards;
    cards.branch.assign(cards.positions.size(), 0); // wind moves them with the trunk
    cards.level.assign(cards.positions.size(), 0);
    out.billboard = std::make_shared<const TriangleMesh>(std::move(cards));
    out.billboardAtlas = std::move(picture->atlas);
    // Between two cards the outline of a round crown is so much nearer to the trunk.
    double broadest = 0.0;
    for (const ShownCard& card : out.billboardAtlas->cards)
        broadest = std::max(broadest, card.half.x);
    out.detail = broadest * (1.0 - maths::cos(0.5 * std::numbers::pi / billboardCards));
    return out;
}

} // namespace

std::int64_t TreeLevel::triangles() const
{
    return facesOf(bark) + facesOf(leaves) + facesOf(apples) + facesOf(billboard);
}

Expected<std::vector<TreeLevel>> treeLevels(const TreeResult& tree, const NodeParams& params,
                                            const LevelOptions& options, const LevelParts& parts,
                                            const Progress& progress)
{
    RAMURE_TRY(checkLevels(options));
    LevelMaker maker(tree, params, parts, options);
    RAMURE_TRY(maker.prepare(progress.part(0.0, 0.2)));
    std::vector<TreeLevel> out;
    for (std::int64_t i = 0; i < options.count; ++i) {
        if (progress.cancelled())
            return cancelled();
        const auto share = [&](std::int64_t done) {
            return 0.2 + 0.8 * double(done) / double(options.total());
        };
        const Progress part = progress.part(share(i), share(i + 1));
        const bool isWhole = i == 0 && options.beginsWhole();
        const std::int64_t budget = !options.beginsWhole() ? options.budgets[static_cast<std::size_t>(i)]
                                                           : (isWhole ? 0 : maker.usualBudget(out.back()));
        auto made = isWhole ? maker.whole(part) : maker.level(budget, part);
        RAMURE_TRY(made);
        if (i == 0)
            made->detail = 0.0;
        out.push_back(std::move(*made));
    }
    if (options.billboard) {
        auto last = maker.billboard(out.front());
        RAMURE_TRY(last);
        last->detail = std::max(last->detail, out.back().detail);
        out.push_back(std::move(*last));
    }
    return out;
}

} // namespace ramure
