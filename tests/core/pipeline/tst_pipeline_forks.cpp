#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_pipeline_forks {

using namespace ramure;

/// The parameters of forks: refused outside their ranges, and of the stages only the mesh depends on them.
class TestPipelineForks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void valuesOutsideTheRangeAreErrors();
    void onlyTheMeshChanges_data();
    void onlyTheMeshChanges();
    void reachHasNoSayWithoutSoftness();
};

namespace {

NodeParams tree(const char* preset, int iterations)
{
    NodeParams params = *presetParams(preset);
    params.grammar.iterations = iterations;
    return params;
}

void set(NodeParams& params, const QString& name, double value)
{
    if (name == "forkSoftness")
        params.mesh.forkSoftness = value;
    else if (name == "forkReach")
        params.mesh.forkReach = value;
    else if (name == "nearTwinRatio")
        params.mesh.nearTwinRatio = value;
    else
        params.mesh.clampOvershoot = value != 0.0;
}

} // namespace

void TestPipelineForks::valuesOutsideTheRangeAreErrors()
{
    TreePipeline pipeline;
    for (const char* name : {"forkSoftness", "forkReach", "nearTwinRatio"})
        for (const double bad : {-0.001, 4.001, double(NAN), double(INFINITY)}) {
            NodeParams params = tree("TinyTree", 2);
            set(params, name, bad);
            const auto result = pipeline.evaluate(params, Stage::Mesh);
            QVERIFY(!result);
            QCOMPARE(result.error().path, "mesh." + std::string(name));
        }
}

void TestPipelineForks::onlyTheMeshChanges_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("value");
    QTest::newRow("softness") << "forkSoftness" << 0.2;
    QTest::newRow("reach") << "forkReach" << 0.5;
    QTest::newRow("overshoot") << "clampOvershoot" << 1.0;
    QTest::newRow("twins") << "nearTwinRatio" << 1.5;
}

void TestPipelineForks::onlyTheMeshChanges()
{
    QFETCH(QString, name);
    QFETCH(double, value);
    TreePipeline pipeline;
    NodeParams params = tree("FanTree", 4);
    params.leaf = {}; // a plant's leaves stand on the mesh
    params.fruit = {};
    const auto before = pipeline.evaluate(params, Stage::Foliage);
    set(params, name, value);
    const auto after = pipeline.evaluate(params, Stage::Foliage);
    QVERIFY(before && after);
    QVERIFY(before->sections == after->sections);
    QVERIFY(before->foliage == after->foliage);
    QVERIFY(before->branches->mesh.positions != after->branches->mesh.positions);
    QVERIFY(after->report->valid);
}

void TestPipelineForks::reachHasNoSayWithoutSoftness()
{
    TreePipeline pipeline;
    NodeParams params = tree("TinyTree", 2);
    params.mesh.forkSoftness = 0.0;
    const auto before = pipeline.evaluate(params, Stage::Mesh);
    params.mesh.forkReach = 3.0;
    const auto after = pipeline.evaluate(params, Stage::Mesh);
    QVERIFY(before && after && before->branches == after->branches);
}

RAMURE_SUITE(TestPipelineForks)

} // namespace tst_pipeline_forks

#include "tst_pipeline_forks.moc"
