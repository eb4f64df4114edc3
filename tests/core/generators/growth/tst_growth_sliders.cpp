#include "core/generators/growth/grown_skeleton.h"
#include "core/params/param_def.h"
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

/// What a tree of a few thousand metamers can have of a row's hard range.
std::pair<double, double> range(const ParamDef& def)
{
    const std::string_view key = def.key;
    return {key == "growth.internode" ? 0.02 : def.hardMin, key == "growth.crownWidth" ? 40.0 : def.hardMax};
}

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
        int rows = 0;
        for (const ParamDef& def : paramTable()) {
            const std::string_view key = def.key;
            if (def.type != ParamType::Real || !key.starts_with("growth.") || key == "growth.age")
                continue;
            ++rows;
            const auto [low, high] = range(def);
            for (const double value : {low, high}) {
                NodeParams params;
                params.growth = small(18.0);
                def.assign(params, value);
                grows(params.growth, def.key);
            }
        }
        QVERIFY(rows > 30);
    }
};

RAMURE_SUITE(TestGrowthSliders)

} // namespace tst_growth_sliders

#include "tst_growth_sliders.moc"
