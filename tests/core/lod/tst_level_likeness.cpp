#include "core/lod/level_likeness.h"

#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <cmath>
#include <stop_token>

namespace tst_level_likeness {

using namespace ramure;

namespace {

struct Made
{
    NodeParams params;
    std::vector<TreeLevel> levels;
};

Made made(const char* preset, std::vector<std::int64_t> budgets, bool billboard)
{
    Made out{*presetParams(preset), {}};
    LevelOptions options;
    options.count = std::int64_t(budgets.size());
    options.budgets = std::move(budgets);
    options.cards = true;
    options.billboard = billboard;
    const TreeResult tree = *TreePipeline().evaluate(out.params, stageOfLevels(options));
    auto levels = treeLevels(tree, out.params, options);
    if (!levels)
        qFatal("%s", levels.error().message().c_str());
    out.levels = std::move(*levels);
    return out;
}

} // namespace

class TestLevelLikeness : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void itCanBeCancelled()
    {
        const Made tree = made("TinyTree", {1'000, 500}, false);
        std::stop_source source;
        source.request_stop();
        const auto found =
            likenessOf(tree.levels, tree.params, std::vector<int>{40}, 128, {source.get_token(), {}});
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::Cancelled);
    }

    /// A level is like itself.
    void theSameIsAlike()
    {
        Made tree = made("EnglishOak1995", {5'000}, false);
        tree.levels.push_back(tree.levels.front());
        const auto found = likenessOf(tree.levels, tree.params, std::vector<int>{60}, 256);
        QVERIFY2(found, test::why(found));
        QCOMPARE(found->size(), std::size_t(1));
        QCOMPARE(found->front().overlap, 1.0);
        QCOMPARE(found->front().outline, 1.0);
        QCOMPARE(found->front().cover, 1.0);
        QCOMPARE(found->front().colourDistance, 0.0);
    }

    /// Two species of twelve, others in each RAMURE_ROUND: where a level of 20,000, 5,000 or 1,250 triangles
    /// takes over it covers as much of the screen and has the colour of the one before. The figures of all
    /// are printed by `ramure-cli levels --check`.
    void levelsHaveTheColourOfTheTree()
    {
        constexpr std::array species{"EnglishOak",    "SilverBirch",   "NorwaySpruce",  "ScotsPine",
                                     "CoconutPalm",   "WeepingWillow", "CommonAsh",     "OrchardApple",
                                     "EuropeanBeech", "JapaneseMaple", "HorseChestnut", "LombardyPoplar"};
        const auto round = std::size_t(qEnvironmentVariableIntValue("RAMURE_ROUND"));
        for (const std::size_t k : {2 * round % 12, (2 * round + 1) % 12}) {
            const Made tree = made(species[k], {20'000, 5'000, 1'250}, true);
            const auto found = likenessOf(tree.levels, tree.params, std::vector<int>{162, 162, 162}, 512);
            QVERIFY2(found, test::why(found));
            QCOMPARE(found->size(), std::size_t(3));
            for (std::size_t i = 0; i < found->size(); ++i) {
                const LevelLikeness& own = (*found)[i];
                const bool isBillboard = i == 2;
                qInfo("%s, level %d: overlap %.3f, outline %.3f, cover %.2f, colour %.1f", species[k],
                      int(i + 1), own.overlap, own.outline, own.cover, own.colourDistance);
                QVERIFY2(std::abs(own.cover - 1.0) < (isBillboard ? 0.35 : 0.16), species[k]);
                QVERIFY2(own.colourDistance < (isBillboard ? 8.0 : 3.5), species[k]);
                QVERIFY2(own.overlap > (isBillboard ? 0.42 : 0.54), species[k]);
            }
        }
    }
};

RAMURE_SUITE(TestLevelLikeness)

} // namespace tst_level_likeness

#include "tst_level_likeness.moc"
