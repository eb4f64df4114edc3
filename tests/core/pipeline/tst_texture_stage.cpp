#include "core/pipeline/tree_pipeline.h"
#include "tests/support/suite.h"

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

private:
    TreeResult tree(Stage last = Stage::Mesh)
    {
        NodeParams params;
        params.grammar.iterations = 3;
        return *m_pipeline.evaluate(params, last);
    }
    TreePipeline m_pipeline;
};

QTEST_GUILESS_MAIN(TestTextureStage)
#include "tst_texture_stage.moc"
