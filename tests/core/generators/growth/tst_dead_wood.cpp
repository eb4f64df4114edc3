#include "core/generators/growth/grown_skeleton.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <limits>

namespace tst_dead_wood {

using namespace ramure;

namespace {

constexpr const char* kinds[] = {"EnglishOak", "ScotsPine", "EuropeanBeech", "NorwaySpruce"};

GrowthParams paramsOf(const QString& name, double deadWood, double age = 40.0)
{
    GrowthParams params = presetParams(name.toStdString()).value().growth;
    params.age = age;
    params.deadWood = deadWood;
    return params;
}

Skeleton grown(const GrowthParams& params, std::uint64_t seed = 1)
{
    const auto history = growHistory(params, seed);
    return history ? skeletonAtAge(*history, params.age) : Skeleton();
}

bool isBare(const Skeleton& tree, Index branch)
{
    return std::ranges::binary_search(tree.bare, branch);
}

/// Share of the ends of branches that are dead; of those in the outer fifth of the crown, too.
struct Ends
{
    double dead = 0.0, deadOutside = 0.0;
};

Ends endsOf(const Skeleton& tree)
{
    std::vector<bool> goesOn(tree.size(), false);
    double top = 0.0, wide = 0.0;
    for (Index i = 0; i < tree.size(); ++i) {
        if (tree.parent[i] != noIndex)
            goesOn[tree.parent[i]] = true;
        top = std::max(top, tree.p1[i].y);
        wide = std::max(wide, std::hypot(tree.p1[i].x, tree.p1[i].z));
    }
    double ends = 0.0, dead = 0.0, outer = 0.0, deadOuter = 0.0;
    for (Index i = 0; i < tree.size(); ++i) {
        if (goesOn[i])
            continue;
        const bool isOutside = tree.p1[i].y > 0.9 * top;
        ends += 1.0;
        dead += isBare(tree, i) ? 1.0 : 0.0;
        outer += isOutside ? 1.0 : 0.0;
        deadOuter += isOutside && isBare(tree, i) ? 1.0 : 0.0;
    }
    return {ends > 0.0 ? dead / ends : 0.0, outer > 0.0 ? deadOuter / outer : 0.0};
}

void addKinds()
{
    QTest::addColumn<QString>("name");
    for (const char* name : kinds)
        QTest::newRow(name) << QString(name);
}

} // namespace

/// Limbs that died in the shade and stand.
class TestDeadWood : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongNumbersAreErrors()
    {
        for (const double wrong : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
            const auto history = growHistory(paramsOf("EnglishOak", wrong), 1);
            QVERIFY(!history && history.error().path == "growth.deadWood");
        }
    }

    void withoutItNothingIsDead_data() { addKinds(); }
    void withoutItNothingIsDead()
    {
        QFETCH(const QString, name);
        QVERIFY(grown(paramsOf(name, 0.0)).bare.empty());
    }

    void deadWoodStandsInTheShade_data() { addKinds(); }
    /// What is dead carries nothing that lives, is more the longer it stands, and is none of the outermost.
    void deadWoodStandsInTheShade()
    {
        QFETCH(const QString, name);
        double before = 0.0;
        for (const double deadWood : {0.5, 1.0, 3.0}) {
            const Skeleton tree = grown(paramsOf(name, deadWood));
            QVERIFY(!tree.empty());
            for (Index i = 0; i < tree.size(); ++i)
                if (tree.parent[i] != noIndex && isBare(tree, tree.parent[i]))
                    QVERIFY(isBare(tree, i));
            const Ends ends = endsOf(tree);
            qInfo("%s, %g: %.3f dead, %.3f outside", qPrintable(name), deadWood, ends.dead, ends.deadOutside);
            QVERIFY(ends.dead >= before && ends.dead < 0.6);
            QVERIFY(ends.deadOutside <= 0.01);
            before = ends.dead;
        }
        // Spruces of this age keep all of their limbs.
        QVERIFY(name == QLatin1String("NorwaySpruce") || before > 0.03);
    }

    /// Any age is cut out of one run, with what was dead then; and growing on changes nothing before.
    void deadWoodHasItsYears_data() { addKinds(); }
    void deadWoodHasItsYears()
    {
        QFETCH(const QString, name);
        const auto history = growHistory(paramsOf(name, 1.0), 2);
        QVERIFY(history);
        for (const double age : {15.0, 22.5, 31.0}) {
            const Skeleton cut = skeletonAtAge(*history, age), alone = grown(paramsOf(name, 1.0, age), 2);
            QVERIFY(cut == alone);
        }
    }

    void meshesStayClosed_data() { addKinds(); }
    void meshesStayClosed()
    {
        QFETCH(const QString, name);
        const NodeParams preset = presetParams(name.toStdString()).value();
        BranchMeshOptions options;
        static_cast<MeshParams&>(options) = preset.mesh;
        const auto mesh = buildCheckedBranchMesh(grown(paramsOf(name, 1.5)), options);
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY(mesh->report.valid);
    }

    /// Cutting a limb leaves the dead wood elsewhere as it was.
    void cutsLeaveDeadWoodElsewhere()
    {
        const GrowthParams params = paramsOf("EnglishOak", 1.0, 30.0);
        const auto whole = growHistory(params, 1);
        QVERIFY(whole);
        GrowthCut cut;
        cut.age = 26;
        for (Index a = 1; a < whole->axisAddress.size() && cut.axis == 0; ++a)
            if (whole->axisOrder[a] == 1)
                cut.axis = whole->axisAddress[a];
        const auto after = growHistory(params, 1, {cut});
        QVERIFY(after);
        const Ends before = endsOf(skeletonAtAge(*whole, 30.0)), now = endsOf(skeletonAtAge(*after, 30.0));
        QVERIFY(std::abs(before.dead - now.dead) < 0.05);
    }
};

RAMURE_SUITE(TestDeadWood)

} // namespace tst_dead_wood

#include "tst_dead_wood.moc"
