#include "core/generators/growth/grown_skeleton.h"
#include "tests/support/suite.h"
#include <cmath>
#include <ctime>
#include <set>

namespace tst_growth_sliders {

using namespace ramure;

namespace {

/// A tree of a few thousand metamers at most whatever one slider says.
GrowthParams small(double age)
{
    GrowthParams params;
    params.age = age;
    params.height = 5.0;
    params.crownWidth = 4.0;
    params.maturity = 20.0;
    params.leaderUntil = 8.0;
    return params;
}

struct Slider
{
    const char* name;
    double GrowthParams::*value;
    double low, high;
};

/// The hard limits, but for the sizes: those are a small tree's.
constexpr Slider sliders[] = {
    {"height", &GrowthParams::height, 0.05, 150.0},
    {"crownWidth", &GrowthParams::crownWidth, 0.02, 40.0},
    {"crownBase", &GrowthParams::crownBase, 0.0, 0.95},
    {"crownWidest", &GrowthParams::crownWidest, 0.0, 1.0},
    {"crownTop", &GrowthParams::crownTop, 0.05, 3.0},
    {"maturity", &GrowthParams::maturity, 2.0, 2000.0},
    {"density", &GrowthParams::density, 0.05, 10.0},
    {"leaderUntil", &GrowthParams::leaderUntil, 0.0, 1e5},
    {"apicalControl", &GrowthParams::apicalControl, 0.0, 1.0},
    {"sideLength", &GrowthParams::sideLength, 0.1, 1.0},
    {"autonomy", &GrowthParams::autonomy, 0.0, 1.0},
    {"internode", &GrowthParams::internode, 0.02, 5.0},
    {"divergence", &GrowthParams::divergence, -6.3, 6.3},
    {"axil", &GrowthParams::axil, 0.0, 2.6},
    {"acrotony", &GrowthParams::acrotony, 0.0, 1.0},
    {"branching", &GrowthParams::branching, 0.0, 2.0},
    {"shortShoots", &GrowthParams::shortShoots, 0.0, 1.0},
    {"sympodial", &GrowthParams::sympodial, 0.0, 1.0},
    {"shadeTolerance", &GrowthParams::shadeTolerance, 0.0, 1.0},
    {"shedding", &GrowthParams::shedding, 0.0, 1.0},
    {"light", &GrowthParams::light, 0.0, 2.0},
    {"upright", &GrowthParams::upright, -1.0, 1.0},
    {"weeping", &GrowthParams::weeping, 0.0, 2.0},
    {"plagiotropy", &GrowthParams::plagiotropy, 0.0, 1.0},
    {"wander", &GrowthParams::wander, 0.0, 2.0},
    {"droop", &GrowthParams::droop, 0.0, 2.0},
    {"reaction", &GrowthParams::reaction, 0.0, 1.0},
    {"reiteration", &GrowthParams::reiteration, 0.0, 1.0},
    {"pipeExponent", &GrowthParams::pipeExponent, 1.5, 4.0},
    {"tipRadius", &GrowthParams::tipRadius, 0.0001, 0.1},
    {"girth", &GrowthParams::girth, 0.0, 1.0},
    {"sunlight", &GrowthParams::sunlight, 0.0, 1.0},
};

void checkTree(const Skeleton& tree, const char* what)
{
    std::set<std::uint64_t> keys;
    for (Index i = 0; i < tree.size(); ++i) {
        const Index parent = tree.parent[i];
        QVERIFY2(parent == noIndex || parent < i, what);
        QVERIFY2(parent == noIndex || tree.p0[i] == tree.p1[parent], what);
        QVERIFY2(std::isfinite(tree.p1[i].x) && std::isfinite(tree.p1[i].y) && std::isfinite(tree.p1[i].z),
                 what);
        QVERIFY2(std::isfinite(tree.a0[i]) && tree.a1[i] > 0.0 && tree.a1[i] <= tree.a0[i], what);
        QVERIFY2(tree.length(i) > 0.0, what);
        QVERIFY2(keys.insert(tree.key[i]).second, what);
    }
}

/// A tree, or a refusal by limit: whatever it is, soon and sound.
void grows(const GrowthParams& params, const char* what)
{
    constexpr double seconds = 2.0;
    const std::clock_t start = std::clock();
    const auto history = growHistory(params, 1);
    if (!history) {
        QVERIFY2(history.error().code == ErrorCode::Limit, what);
        return;
    }
    for (const GrowthYear& year : history->years)
        QVERIFY2(std::isfinite(year.light) && std::isfinite(year.vigour), what);
    for (const double age : {0.5, 0.37 * params.age, params.age})
        checkTree(skeletonAtAge(*history, age), what);
    QVERIFY2(double(std::clock() - start) / CLOCKS_PER_SEC < seconds, what); // of the processor's time
}

} // namespace

class TestGrowthSliders : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void everySliderAtItsEnds()
    {
        for (const Slider& slider : sliders)
            for (const double value : {slider.low, slider.high}) {
                GrowthParams params = small(18.0);
                params.*slider.value = value;
                grows(params, slider.name);
            }
    }
};

RAMURE_SUITE(TestGrowthSliders)

} // namespace tst_growth_sliders

#include "tst_growth_sliders.moc"
