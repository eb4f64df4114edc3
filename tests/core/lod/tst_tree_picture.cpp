#include "core/lod/tree_picture.h"

#include "core/lod/mip_coverage.h"
#include "core/lod/spray_picture.h"
#include "core/lod/tree_levels.h"
#include "core/math/box.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_tree_picture {

using namespace ramure;

namespace {

std::vector<TreeLevel> levelsOf(NodeParams params, std::vector<std::int64_t> budgets,
                                const LevelParts& parts = {})
{
    LevelOptions options;
    options.count = std::int64_t(budgets.size());
    options.budgets = std::move(budgets);
    options.cards = options.billboard = true;
    const TreeResult tree = *TreePipeline().evaluate(params, stageOfLevels(options));
    auto levels = treeLevels(tree, params, options, parts);
    if (!levels)
        qFatal("%s", levels.error().message().c_str());
    return std::move(*levels);
}

NodeParams young(const char* preset, double age)
{
    NodeParams params = *presetParams(preset);
    params.growth.age = age;
    return params;
}

Box boxOf(const TreeLevel& level)
{
    Box box;
    for (const auto& mesh : {level.bark, level.leaves, level.apples})
        for (std::size_t v = 0; mesh && v < mesh->positions.size(); ++v)
            box.add(glm::dvec3(mesh->positions[v]));
    return box;
}

} // namespace

class TestTreePicture : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingHasNoPicture()
    {
        for (const std::vector<ShownSurface>& surfaces :
             {std::vector<ShownSurface>(), {{std::make_shared<const TriangleMesh>()}}}) {
            const auto picture = treePicture(surfaces, glm::dvec3(0.0));
            QVERIFY(!picture);
            QCOMPARE(picture.error().code, ErrorCode::Invalid);
        }
    }
    void tooFewTrianglesAreRefused()
    {
        LevelOptions options{.count = 1, .budgets = {10}, .billboard = true};
        const auto levels = treeLevels({}, {}, options);
        QVERIFY(!levels);
        QCOMPARE(levels.error().code, ErrorCode::Invalid);
        QVERIFY2(levels.error().message().find("10") != std::string::npos, test::why(levels));
    }

    /// Trees of all sorts: without leaves, a palm, a conifer.
    void itStandsForTheTree_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<bool>("hasLeaves");
        for (const char* name : {"EnglishOak", "ScotsPine"}) {
            QTest::addRow("%s", name) << QByteArray(name) << true;
            QTest::addRow("%s, bare", name) << QByteArray(name) << false;
        }
        QTest::newRow("palm") << QByteArray("CoconutPalmRules") << true;
        QTest::newRow("coursework") << QByteArray("TinyTree") << true;
    }
    void itStandsForTheTree()
    {
        QFETCH(QByteArray, name);
        QFETCH(bool, hasLeaves);
        LevelParts parts;
        parts.leaves = hasLeaves;
        const auto levels = levelsOf(young(name.constData(), 20.0), {2'000}, parts);
        QCOMPARE(levels.size(), std::size_t(2));
        const TreeLevel& last = levels.back();
        QVERIFY(last.billboard && last.billboardAtlas && !last.bark && !last.leaves);
        QCOMPARE(last.triangles(), std::int64_t(2 * billboardCards));
        QCOMPARE(last.billboardAtlas->cards.size(), std::size_t(billboardCards));
        QVERIFY(last.detail >= levels.front().detail);
        const Box box = boxOf(levels.front()).grown(0.12 * boxOf(levels.front()).radius());
        for (const glm::vec3& place : last.billboard->positions)
            QVERIFY(glm::all(glm::greaterThanEqual(glm::dvec3(place), box.min)) &&
                    glm::all(glm::lessThanEqual(glm::dvec3(place), box.max)));
        for (const glm::vec2& uv : last.billboard->uv)
            QVERIFY(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F);
        QCOMPARE(last.billboard->uv.size(), last.billboard->positions.size());
    }

    /// Something is seen on every card; between cards nothing is, so that no card shows its neighbour's; the
    /// smaller versions show as much.
    void picturesAreApart()
    {
        const auto levels = levelsOf(young("EnglishOak", 20.0), {2'000});
        const CardAtlas& atlas = *levels.back().billboardAtlas;
        constexpr int size = 256;
        const auto maps = sprayMaps(atlas, size);
        QVERIFY2(maps, test::why(maps));
        std::vector<float> alpha;
        std::vector<std::size_t> opaque(atlas.cards.size(), 0);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const std::uint8_t own = maps->colour[std::size_t(y) * size + std::size_t(x)].a;
                alpha.push_back(float(own) / 255.0F);
                const glm::vec2 at((float(x) + 0.5F) / size, (float(y) + 0.5F) / size);
                bool isOnCard = false;
                for (std::size_t k = 0; k < atlas.cards.size(); ++k)
                    if (glm::all(glm::greaterThan(at, atlas.cards[k].low - 1.0F / size)) &&
                        glm::all(glm::lessThan(at, atlas.cards[k].high + 1.0F / size))) {
                        isOnCard = true;
                        opaque[k] += own >= 128 ? 1 : 0;
                    }
                QVERIFY(isOnCard || own < 128);
            }
        for (const std::size_t count : opaque)
            QVERIFY2(count > 500, QByteArray::number(qulonglong(count)));
        const auto shares = opaqueShares(alpha, size, 4);
        for (const double share : shares)
            QVERIFY2(std::abs(share - shares[0]) < 0.02 * shares[0], QByteArray::number(share));
    }

    void sameBytesAgain()
    {
        const NodeParams params = young("SilverBirch", 15.0);
        const auto once = levelsOf(params, {1'500}), again = levelsOf(params, {1'500});
        QVERIFY(*once.back().billboard == *again.back().billboard);
        QCOMPARE(once.back().billboardAtlas->hash, again.back().billboardAtlas->hash);
        const auto one = sprayMaps(*once.back().billboardAtlas, 128),
                   other = sprayMaps(*again.back().billboardAtlas, 128);
        QVERIFY(one->colour == other->colour && one->normal == other->normal);
    }
};

RAMURE_SUITE(TestTreePicture)

} // namespace tst_tree_picture

#include "tst_tree_picture.moc"
