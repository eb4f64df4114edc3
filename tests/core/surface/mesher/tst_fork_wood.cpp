#include "core/generators/variety.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/check/wood_sections.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <string_view>
#include <vector>

namespace tst_fork_wood {

using namespace ramure;
using namespace ramure::test;

namespace {

/// The bars below are of all seeds together: a sanitizer looks at fewer species, not at fewer seeds.
constexpr int seeds = 6;
constexpr int everySpecies = isSanitized ? 6 : 1;
constexpr double thickLimb = 0.01; ///< m
constexpr std::size_t fewLimbs = 10;

/// Bars, of the worst fork of a trunk and of the middle limb and twin. Species that miss one have their own:
/// nobody may get worse.
struct Bars
{
    std::string_view preset;
    double quarter = 0.25,
           whole = 0.40; ///< share of the wood lost within a quarter of a diameter, within one
    double leastCollar = 1.15, mostCollar = 1.5, mostTwins = 1.1;
};
constexpr Bars own[] = {
    // Whorls of limbs around a stem of half the width.
    {.preset = "Baobab", .quarter = 0.29, .whole = 0.48, .leastCollar = 1.12},
    {.preset = "CaliforniaBlackOak", .mostCollar = 1.52},
    {.preset = "CommonYew1995", .quarter = 0.32, .mostTwins = 1.12}, // many stems at a fork
    {.preset = "EnglishOak1995", .quarter = 0.27},
    {.preset = "LiveOak1995", .quarter = 0.27},
    {.preset = "StonePine1995", .quarter = 0.28},
    {.preset = "WhiteWillow1995", .quarter = 0.31},
    // Limbs run along the stem, some of them inside it.
    {.preset = "WeepingWillow1995", .quarter = 0.46, .whole = 0.54, .leastCollar = 1.0},
    {.preset = "ItalianCypress1995", .leastCollar = 1.0},
    {.preset = "GiantSequoia1995", .leastCollar = 1.0},
    {.preset = "LombardyPoplar1995", .leastCollar = 1.12},
    {.preset = "DouglasFir1995", .leastCollar = 1.1},
    {.preset = "BlackTupelo", .leastCollar = 1.14},
    // Grown by years: stout limbs of one year stand close to each other.
    {.preset = "LombardyPoplar", .leastCollar = 1.0},
    {.preset = "ItalianCypress", .leastCollar = 1.0},
    {.preset = "Hornbeam", .leastCollar = 1.11},
    {.preset = "Rowan", .leastCollar = 1.13},
    {.preset = "LiveOak", .mostCollar = 1.56},
    {.preset = "RedOak", .mostCollar = 1.55},
    {.preset = "StonePine", .whole = 0.48}, // whorls part into the umbrella
    // Without a budget all branches have the same few cross-sections.
    {.preset = "ParkTree", .leastCollar = 1.07},
    {.preset = "UmbrellaAcacia", .leastCollar = 1.09},
    // Fronds around the end of a trunk.
    {.preset = "DatePalm", .quarter = 0.66, .whole = 0.48, .leastCollar = 1.0},
    {.preset = "FanPalm", .quarter = 0.43, .whole = 0.63, .leastCollar = 1.0},
    {.preset = "CoconutPalm", .quarter = 0.42, .leastCollar = 1.0},
    {.preset = "CoconutPalmRules", .leastCollar = 1.0},
};

Bars barsOf(std::string_view preset)
{
    const auto found = std::ranges::find(own, preset, &Bars::preset);
    return found != std::end(own) ? *found : Bars{.preset = preset};
}

/// Coursework and book say how thick their branches are, and forms are species in another state.
bool isMeasured(const Preset& preset)
{
    const std::string_view group = preset.group;
    return group != "Coursework" && group != "The Algorithmic Beauty of Plants" && group != "Forms";
}

double middleOf(std::vector<double> values)
{
    if (values.empty())
        return 1.0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace

/// What a close look sees of the mesh of every species: the wood that is lost on the way up the trunk, the
/// collars of limbs, and twins.
class TestForkWood : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }

    void woodGoesOn_data()
    {
        QTest::addColumn<QString>("name");
        int nth = 0;
        for (const Preset& preset : presets())
            if (isMeasured(preset) && nth++ % everySpecies == 0)
                QTest::newRow(preset.name) << QString(preset.name);
    }
    void woodGoesOn()
    {
        QFETCH(QString, name);
        const Bars bars = barsOf(name.toStdString());
        WoodLoss worst;
        std::vector<double> collars, twins;
        for (int seed = 1; seed <= seeds; ++seed) {
            TreePipeline pipeline;
            const auto tree =
                pipeline.evaluate(reseeded(presetParams(name.toStdString()).value(), seed), Stage::Mesh);
            QVERIFY2(tree, why(tree));
            const WoodSections wood(*tree->branches);
            const WoodLoss loss = wood.lossUpTheTrunk();
            const auto where = [seed](const char* within, double share, double height) {
                return QString("seed %1 at %2 m: %3 within %4").arg(seed).arg(height).arg(share).arg(within);
            };
            QVERIFY2(loss.quarter <= bars.quarter,
                     qPrintable(where("a quarter of a diameter", loss.quarter, loss.quarterHeight)));
            QVERIFY2(loss.whole <= bars.whole, qPrintable(where("a diameter", loss.whole, loss.wholeHeight)));
            worst.quarter = std::max(worst.quarter, loss.quarter);
            worst.whole = std::max(worst.whole, loss.whole);
            for (const Swelling& swelling : wood.swellings(thickLimb))
                if (swelling.share <= 0.5)
                    collars.push_back(swelling.ratio);
                else if (swelling.share > 0.9)
                    twins.push_back(swelling.ratio);
        }
        const double collar = middleOf(collars), twin = middleOf(twins);
        qInfo("%s: loses %.2f within a quarter, %.2f within one; %zu limbs %.2f, %zu twins %.2f",
              qPrintable(name), worst.quarter, worst.whole, collars.size(), collar, twins.size(), twin);
        QVERIFY2(collars.size() < fewLimbs || (collar >= bars.leastCollar && collar <= bars.mostCollar),
                 qPrintable(QString::number(collar)));
        QVERIFY2(twin >= 1.0 && twin <= bars.mostTwins, qPrintable(QString::number(twin)));
    }
};

RAMURE_SUITE(TestForkWood)

} // namespace tst_fork_wood

#include "tst_fork_wood.moc"
