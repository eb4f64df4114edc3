#include "core/lod/leaf_sprays.h"

#include "core/lod/tree_levels.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_leaf_sprays {

using namespace ramure;

namespace {

struct Grown
{
    NodeParams params;
    TreeResult tree;
};

const Grown& oak()
{
    static const Grown made = [] {
        Grown out;
        out.params = *presetParams("EnglishOak");
        out.params.growth.age = 25.0;
        out.tree = *TreePipeline().evaluate(out.params, Stage::Foliage);
        return out;
    }();
    return made;
}

std::vector<TreeLevel> levelsOf(const Grown& grown, std::vector<std::int64_t> budgets, bool cards = true)
{
    LevelOptions options;
    options.count = std::int64_t(budgets.size());
    options.budgets = std::move(budgets);
    options.cards = cards;
    auto levels = treeLevels(grown.tree, grown.params, options);
    if (!levels)
        qFatal("%s", levels.error().message().c_str());
    return std::move(*levels);
}

} // namespace

class TestLeafSprays : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// The first card of a spray faces the eye that looks along -Z, the second one that looks along X. Each
    /// has its own place in the picture.
    void cardsCross()
    {
        const auto levels = levelsOf(oak(), {8'000});
        const CardAtlas& atlas = *levels[0].sprays;
        QCOMPARE(atlas.cards.size(), 2 * atlas.surfaces.size());
        for (std::size_t k = 0; k < atlas.cards.size(); ++k) {
            const TriangleMesh card = meshOf(atlas.cards[k]);
            QCOMPARE(card.faceCount(), Index(2));
            QCOMPARE(card.uv.size(), std::size_t(4));
            for (const glm::uvec3& face : card.triangles) {
                const glm::vec3 a = card.positions[face.x];
                const glm::vec3 across = glm::cross(card.positions[face.y] - a, card.positions[face.z] - a);
                QVERIFY(glm::dot(across, card.normals[face.x]) > 0.0f);
            }
            for (const glm::vec2& uv : card.uv)
                QVERIFY(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f);
            for (const glm::vec3& place : card.positions) {
                const glm::dvec3 from = glm::abs(glm::dvec3(place) - atlas.cards[k].middle);
                QVERIFY(k % 2 == 0 ? from.z < 1e-6 : from.x < 1e-6);
            }
            for (std::size_t other = 0; other < k; ++other)
                QVERIFY(glm::any(glm::lessThan(atlas.cards[k].high, atlas.cards[other].low)) ||
                        glm::any(glm::lessThan(atlas.cards[other].high, atlas.cards[k].low)));
        }
    }

    /// Few clusters have each its own picture, whose colours are those of its leaves.
    void fewHaveTheirOwnPictures()
    {
        const auto levels = levelsOf(oak(), {8'000, 1'250});
        QCOMPARE(levels[0].sprays->surfaces.size(), sharedTwigs);
        const CardAtlas& own = *levels[1].sprays;
        QCOMPARE(own.surfaces.size(), levels[1].foliage->leaves.size());
        QVERIFY(own.surfaces.size() <= mostOwnTwigs);
        std::size_t shown = 0;
        for (const ShownSurface& twig : own.surfaces)
            shown += twig.copies.size();
        QCOMPARE(shown, oak().tree.foliage->leaves.size());
        for (const FoliageItem& item : levels[1].foliage->leaves)
            QCOMPARE(item.tint, glm::vec3(1.0F));
    }

    /// Leaves keep their size: a card is as large as the twig that it shows, which has many.
    void levelsShowTheTreesOwnTwigs()
    {
        const auto levels = levelsOf(oak(), {30'000, 8'000, 2'000});
        for (const TreeLevel& level : levels) {
            QVERIFY(level.sprays);
            QCOMPARE(level.leaves->faceCount(), 4 * Index(level.foliage->leaves.size()));
            QCOMPARE(level.leaves->uv.size(), level.leaves->positions.size());
            QCOMPARE(level.leafOf.size(), level.foliage->leaves.size());
            QVERIFY(std::abs(level.leafArea / levels.front().leafArea - 1.0) < 0.35);
            for (const ShownSurface& twig : level.sprays->surfaces)
                QVERIFY(!twig.copies.empty());
            for (const FoliageItem& item : level.foliage->leaves) {
                QVERIFY(std::isfinite(item.size) && item.size > 0.0f);
                QVERIFY(glm::all(glm::lessThanEqual(item.tint, glm::vec3(1.0f))));
            }
        }
        QVERIFY(levels[1].sprays->hash != levels[0].sprays->hash);
    }

    void theSameTreeHasTheSameSprays()
    {
        const auto once = levelsOf(oak(), {6'000}), again = levelsOf(oak(), {6'000});
        QCOMPARE(once[0].sprays->hash, again[0].sprays->hash);
        QVERIFY(*once[0].leaves == *again[0].leaves);
    }

    /// Without cards, with pictures of its own, or as the squares of the coursework it has leaves.
    void whoHasNoPicturesHasLeaves()
    {
        QVERIFY(!levelsOf(oak(), {6'000}, false)[0].sprays);
        Grown own = oak();
        own.params.leafPictures.colour = "leaf.png";
        QVERIFY(!levelsOf(own, {6'000})[0].sprays);
        Grown faithful = oak();
        faithful.params.leaf.shape = LeafShape::Faithful;
        faithful.params.foliage.leavesDensity = 1;
        faithful.tree = *TreePipeline().evaluate(faithful.params, Stage::Foliage);
        QVERIFY(!levelsOf(faithful, {20'000})[0].sprays);
    }

    /// The crown has the mean colour of its leaves.
    void coloursAreThoseOfTheLeaves()
    {
        Grown autumn = oak();
        autumn.params.leaf.season = 0.5;
        autumn.tree = *TreePipeline().evaluate(autumn.params, Stage::Foliage);
        for (const Grown* grown : {&oak(), static_cast<const Grown*>(&autumn)}) {
            const auto level = std::move(levelsOf(*grown, {8'000})[0]);
            glm::dvec3 leaves(0.0), cards(0.0);
            double area = 0.0, shown = 0.0;
            for (const FoliageItem& leaf : grown->tree.foliage->leaves) {
                const double own = double(leaf.size) * double(leaf.size);
                leaves += own * glm::dvec3(leaf.tone * leaf.tint);
                area += own;
            }
            for (const FoliageItem& card : level.foliage->leaves) {
                const double own = double(card.size) * double(card.size);
                cards += own * glm::dvec3(card.tint);
                shown += own;
            }
            // The picture is as much darker than its brightest leaf as the cards are brighter.
            for (int k = 0; k < 3; ++k)
                QVERIFY(cards[k] / shown > 0.95 * leaves[k] / area && cards[k] / shown <= 1.0);
        }
    }
};

RAMURE_SUITE(TestLeafSprays)

} // namespace tst_leaf_sprays

#include "tst_leaf_sprays.moc"
