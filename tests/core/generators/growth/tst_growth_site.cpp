#include "core/generators/growth/grown_skeleton.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>
#include <numbers>

namespace tst_growth_site {

using namespace ramure;

namespace {

constexpr double quarter = 0.5 * std::numbers::pi;
constexpr double age = 25.0;

/// Species as unlike as can be, by row.
constexpr const char* kinds[] = {"Hawthorn", "ScotsPine", "EuropeanBeech", "NorwaySpruce"};

GrowthParams paramsOf(const QString& name)
{
    GrowthParams params = presetParams(name.toStdString()).value().growth;
    params.age = age;
    return params;
}

Skeleton grown(const GrowthParams& params, std::uint64_t seed = 3)
{
    const auto history = growHistory(params, seed);
    return history ? skeletonAtAge(*history, params.age) : Skeleton{};
}

/// The middle of the wood, m.
glm::dvec3 middleOf(const Skeleton& tree)
{
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& end : tree.p1)
        sum += end;
    return sum / std::max(double(tree.size()), 1.0);
}

double topOf(const Skeleton& tree)
{
    double top = 0.0;
    for (const glm::dvec3& end : tree.p1)
        top = std::max(top, end.y);
    return top;
}

void addKinds()
{
    QTest::addColumn<QString>("name");
    for (const char* name : kinds)
        QTest::newRow(name) << QString(name);
}

} // namespace

/// What wind, light from one side, a slope and a lean make of a tree.
class TestGrowthSite : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongNumbersAreErrors()
    {
        const auto refused = [](double GrowthParams::*member, double value, const char* path) {
            GrowthParams params;
            params.*member = value;
            const auto history = growHistory(params, 1);
            return !history && history.error().code == ErrorCode::Invalid && history.error().path == path;
        };
        QVERIFY(refused(&GrowthParams::wind, 200.0, "growth.wind"));
        QVERIFY(refused(&GrowthParams::wind, -1.0, "growth.wind"));
        QVERIFY(refused(&GrowthParams::sideLight, 1.1, "growth.sideLight"));
        QVERIFY(refused(&GrowthParams::slope, 1.6, "growth.slope"));
        QVERIFY(refused(&GrowthParams::lean, std::numeric_limits<double>::quiet_NaN(), "growth.lean"));
        QVERIFY(refused(&GrowthParams::windDirection, std::numeric_limits<double>::infinity(),
                        "growth.windDirection"));
    }

    void directionsAloneChangeNothing()
    {
        GrowthParams params = paramsOf("Hawthorn");
        const Skeleton tree = grown(params);
        params.windDirection = params.lightDirection = params.slopeDirection = 2.0;
        QCOMPARE(grown(params).p1, tree.p1);
    }

    void windMakesFlags_data() { addKinds(); }
    /// The crown stands to leeward, the more the stronger the wind is, and lower.
    void windMakesFlags()
    {
        QFETCH(QString, name);
        GrowthParams params = paramsOf(name);
        const Skeleton calm = grown(params);
        params.windDirection = quarter; // against Z
        double aside = middleOf(calm).z, top = topOf(calm);
        const double width = params.crownWidth;
        for (const double wind : {4.0, 12.0}) {
            params.wind = wind;
            const Skeleton blown = grown(params);
            QVERIFY2(
                middleOf(blown).z < aside - 0.01 * width,
                qPrintable(QString("%1 m/s: %2, before %3").arg(wind).arg(middleOf(blown).z).arg(aside)));
            QVERIFY(topOf(blown) < 1.02 * top);
            aside = middleOf(blown).z;
            top = topOf(blown);
        }
        QVERIFY(top < 0.95 * topOf(calm));
    }

    void crownsGrowToTheLight_data() { addKinds(); }
    void crownsGrowToTheLight()
    {
        QFETCH(QString, name);
        GrowthParams params = paramsOf(name);
        const double middle = middleOf(grown(params)).x;
        params.sideLight = 1.0;
        const double lit = middleOf(grown(params)).x;
        QVERIFY2(lit > middle + 0.02 * params.crownWidth, qPrintable(QString("%1, %2").arg(middle).arg(lit)));
        params.lightDirection = 2.0 * quarter;
        QVERIFY(middleOf(grown(params)).x < middle - 0.02 * params.crownWidth);
    }

    void nothingGrowsIntoASlope_data() { addKinds(); }
    void nothingGrowsIntoASlope()
    {
        QFETCH(QString, name);
        GrowthParams params = paramsOf(name);
        params.slope = 0.7;
        const double grade = std::tan(params.slope), middle = middleOf(grown(paramsOf(name))).x;
        const Skeleton tree = grown(params);
        for (const glm::dvec3& end : tree.p1)
            QVERIFY(end.y + grade * end.x > -0.05 * params.height);
        QVERIFY(middleOf(tree).x > middle); // downhill there is more light
    }

    void leaningStemsTurnUp_data() { addKinds(); }
    void leaningStemsTurnUp()
    {
        QFETCH(QString, name);
        GrowthParams params = paramsOf(name);
        params.lean = 0.8;
        params.slopeDirection = 2.0 * quarter;
        const Skeleton tree = grown(params);
        const glm::dvec3 foot = glm::normalize(tree.p1[0] - tree.p0[0]);
        QVERIFY2(foot.x < -0.4, qPrintable(QString::number(foot.x)));
        glm::dvec3 above(0.0); // of the stem from a third of its height on
        for (Index i = 0; i < tree.size(); ++i)
            if (tree.level[i] == 0 && tree.p0[i].y > topOf(tree) / 3.0)
                above += tree.p1[i] - tree.p0[i];
        QVERIFY(glm::length(above) > 0.0);
        QVERIFY2(glm::normalize(above).y > 0.9, qPrintable(QString::number(glm::normalize(above).y)));
    }

    void neighboursShareTheLight_data() { addKinds(); }
    /// Beside another tree a crown grows to its own side; between two, the stem gets bare.
    void neighboursShareTheLight()
    {
        QFETCH(QString, name);
        GrowthParams params = paramsOf(name);
        const Skeleton alone = grown(params);
        const double near = 0.2 * params.crownWidth;
        const auto beside = [&params](const std::vector<double>& places) {
            GrowthParams crowded = params;
            for (const double x : places)
                crowded.space.neighbours.push_back(
                    {{x, 0.0, 0.0}, params.height, params.crownWidth, params.crownBase, params.maturity});
            return grown(crowded);
        };
        const double middle = middleOf(alone).x;
        QVERIFY(middleOf(beside({near})).x < middle - 0.01 * params.crownWidth);
        QVERIFY(middleOf(beside({-near})).x > middle + 0.01 * params.crownWidth);
        const Skeleton between = beside({-near, near, -2.0 * near, 2.0 * near});
        QVERIFY(!between.empty());
        QVERIFY(between.size() < alone.size());
        QVERIFY(middleOf(between).y / topOf(between) > middleOf(alone).y / topOf(alone));
        QVERIFY(!beside({0.0}).empty()); // at the same place
    }

    /// At once: a leaning tree on a slope in a gale, in light from one side.
    void meshesStayClosed_data() { addKinds(); }
    void meshesStayClosed()
    {
        QFETCH(QString, name);
        NodeParams preset = presetParams(name.toStdString()).value();
        GrowthParams params = paramsOf(name);
        params.wind = 30.0;
        params.slope = params.lean = 1.2;
        params.sideLight = 1.0;
        params.lightDirection = -quarter;
        const Skeleton tree = grown(params);
        QVERIFY(!tree.empty());
        BranchMeshOptions options;
        static_cast<MeshParams&>(options) = preset.mesh;
        const auto mesh = buildCheckedBranchMesh(tree, options);
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY(mesh->report.valid);
    }
};

RAMURE_SUITE(TestGrowthSite)

} // namespace tst_growth_site

#include "tst_growth_site.moc"
