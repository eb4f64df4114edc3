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

    /// A twig of nothing has a frame of nothing, and its cards are there.
    void nothingHasAFrame()
    {
        const SprayFrame frame = sprayFrame({});
        QCOMPARE(frame.half, glm::dvec3(0.0));
        QCOMPARE(sprayCards(frame, 3).faceCount(), Index(4));
    }

    /// The first card faces the eye that looks along -Z, the second one that looks along X. Each has its half
    /// of its own cell, and no two cells touch.
    void cardsCross()
    {
        const SprayFrame frame{{1.0, 2.0, 3.0}, {0.5, 1.0, 0.25}};
        for (int twig = 0; twig < SprayAtlas::count; ++twig) {
            const TriangleMesh cards = sprayCards(frame, twig);
            QCOMPARE(cards.positions.size(), std::size_t(8));
            QCOMPARE(cards.uv.size(), std::size_t(8));
            QCOMPARE(cards.colours.size(), cards.triangles.size());
            for (const glm::uvec3& face : cards.triangles) {
                const glm::vec3 a = cards.positions[face.x];
                const glm::vec3 across = glm::cross(cards.positions[face.y] - a, cards.positions[face.z] - a);
                QVERIFY(glm::dot(across, cards.normals[face.x]) > 0.0f);
            }
            for (std::size_t v = 0; v < 8; ++v) {
                const glm::vec2 cell = 0.5f * glm::vec2(twig % 2, twig / 2);
                const glm::vec2 in = 2.0f * (cards.uv[v] - cell);
                QVERIFY(in.x >= 0.0f && in.x <= 1.0f && in.y >= 0.0f && in.y <= 1.0f);
                QVERIFY(v < 4 ? in.x <= 0.5f : in.x >= 0.5f);
                const glm::dvec3 from = glm::abs(glm::dvec3(cards.positions[v]) - frame.middle);
                QVERIFY(v < 4 ? from.z < 1e-6 : from.x < 1e-6);
            }
        }
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
            for (const TriangleMesh& twig : level.sprays->twigs) {
                QVERIFY(twig.faceCount() > 4);
                QCOMPARE(twig.colours.size(), twig.triangles.size());
            }
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
