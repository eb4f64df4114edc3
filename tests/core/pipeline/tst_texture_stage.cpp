#include "core/params/presets.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/surface/check/texture_report.h"
#include "tests/support/suite.h"

namespace tst_texture_stage {

using namespace ramure;

class TestTextureStage : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void wrongTilesAreErrors()
    {
        for (const double size : {-1.0, 1e-9, 2000.0}) {
            const auto made = tree().texture->coordinates({.tileSize = size});
            QVERIFY(!made);
            QCOMPARE(made.error().code, ErrorCode::Invalid);
            QCOMPARE(made.error().path, std::string("texture.tileSize"));
        }
    }
    void aCancelLeavesNothingBehind()
    {
        std::stop_source stop;
        stop.request_stop();
        const TreeResult result = tree();
        QCOMPARE(result.texture->coordinates(TextureParams(), {stop.get_token(), {}}).error().code,
                 ErrorCode::Cancelled);
        QVERIFY(result.texture->coordinates(TextureParams()));
    }
    void onlyMeshesHaveOne()
    {
        QVERIFY(!tree(Stage::Sections).texture);
        QVERIFY(!m_pipeline.evaluateDraft(NodeParams())->texture);
    }
    void isComputedOnce()
    {
        const TreeResult result = tree();
        const auto made = result.texture->coordinates(TextureParams());
        QVERIFY2(made, test::why(made));
        QCOMPARE(**made, *textureCoordinates(*result.branches, {}));
        QCOMPARE(*result.texture->coordinates(TextureParams()), *made);
        QCOMPARE(*tree().texture->coordinates(TextureParams()), *made); // evaluated again: the same stage
        const auto other = result.texture->coordinates({.seamsAround = false});
        QVERIFY(other && **other != **made);
        QCOMPARE(*result.texture->coordinates(TextureParams()), *made);
    }
    /// As they are dressed: a tile is about as wide as a thick limb is around, and far too wide for twigs.
    void picturesFitEveryBranch_data()
    {
        QTest::addColumn<double>("good");
        for (const Preset& preset : courseworkPresets())
            QTest::newRow(preset.name) << 0.95;
        QTest::newRow("TreeFern") << 0.95;
        QTest::newRow("CoconutPalm") << 0.95;
        QTest::newRow("Baobab") << 0.8;
        QTest::newRow("JoshuaTree") << 0.8;
        QTest::newRow("Saguaro") << 0.8; // its round ends are no tubes
        QTest::newRow("EnglishOak") << 0.85;
    }
    void picturesFitEveryBranch()
    {
        QFETCH(const double, good);
        const auto params = presetParams(QTest::currentDataTag());
        QVERIFY2(params, test::why(params));
        const auto tree = m_pipeline.evaluate(*params, Stage::Mesh);
        QVERIFY2(tree, test::why(tree));
        const auto made = tree->texture->coordinates(*params);
        QVERIFY2(made, test::why(made));
        const TextureReport report = textureReport(*tree->branches, **made);
        QCOMPARE(report.mirrored, Index(0));
        QVERIFY2(report.goodShare() >= good, qPrintable(QString::number(report.goodShare())));
    }

private:
    TreeResult tree(Stage last = Stage::Mesh)
    {
        NodeParams params;
        params.grammar.iterations = 3;
        return *m_pipeline.evaluate(params, last);
    }
    TreePipeline m_pipeline;
};

RAMURE_SUITE(TestTextureStage)

} // namespace tst_texture_stage

#include "tst_texture_stage.moc"
