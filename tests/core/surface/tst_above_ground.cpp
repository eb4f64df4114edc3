#include "core/generators/variety.h"
#include "core/params/source_facts.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_above_ground {

using namespace ramure;

namespace {

/// m below the ground that nobody sees.
constexpr double allowed = 0.1;
constexpr int otherSeeds = test::isSanitized ? 0 : 3;

double lowestOf(const Skeleton& skeleton)
{
    double lowest = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i)
        lowest = std::min(lowest, skeleton.p1[i].y);
    return lowest;
}

double lowestOf(const Foliage& foliage, const TriangleMesh& leaf)
{
    double lowest = 0.0;
    for (const FoliageItem& item : foliage.leaves)
        for (const glm::vec3& corner : leaf.positions)
            lowest = std::min(
                lowest, (item.position + item.orientation * (double(item.size) * glm::dvec3(corner))).y);
    return lowest;
}

} // namespace

/// No tree that ships grows into the ground it stands on.
class TestAboveGround : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// Without a clearance, as the paper has it, limbs that sink do so.
    void onlyTreesWithAClearanceStayAbove()
    {
        NodeParams params = *presetParams("NorwaySpruce1995");
        params.weberPenn.clearance = 0.0;
        TreePipeline pipeline;
        QVERIFY(lowestOf(*pipeline.evaluate(params, Stage::Skeleton)->skeleton) < -0.5);
        params.weberPenn.clearance = 1.0;
        QVERIFY(lowestOf(*pipeline.evaluate(params, Stage::Skeleton)->skeleton) >= 0.0);
    }
    void nothingIsBelow_data()
    {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < presets().size(); ++i)
            QTest::newRow(presets()[i].name) << int(i);
    }
    void nothingIsBelow()
    {
        QFETCH(int, number);
        const Preset& preset = presets()[std::size_t(number)];
        TreePipeline pipeline;
        for (int seed = 0; seed <= otherSeeds; ++seed) {
            const NodeParams params = seed > 0 ? reseeded(preset.params, seed) : preset.params;
            const auto tree = pipeline.evaluate(params, Stage::Foliage);
            QVERIFY2(tree, test::why(tree));
            QVERIFY2(lowestOf(*tree->skeleton) >= -allowed,
                     qPrintable(QString::number(lowestOf(*tree->skeleton))));
            const double leaves = lowestOf(
                *tree->foliage, oneLeaf(tree->foliage->form, trunkRadius(params), FoliageModel::Fine));
            QVERIFY2(leaves >= -allowed, qPrintable(QString::number(leaves)));
        }
    }
};

RAMURE_SUITE(TestAboveGround)

} // namespace tst_above_ground

#include "tst_above_ground.moc"
