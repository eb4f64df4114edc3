#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/check/texture_report.h"
#include "tests/support/suite.h"
#include <QFile>
#include <algorithm>
#include <cmath>

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
        const auto other = result.texture->coordinates({.tileSize = 0.5});
        QVERIFY(other && **other != **made);
        QCOMPARE(*result.texture->coordinates(TextureParams()), *made);
    }
    /// What a mesh gets after it is kept takes of the budget too, and what a cut lays open.
    void texturesAndCutsTakeOfTheBudget()
    {
        NodeParams params;
        params.grammar.iterations = 3;
        std::size_t textures = 0;
        const std::size_t bare = leastBudget(params), textured = leastBudget(params, &textures);
        QVERIFY(textures > bare / 10);
        QCOMPARE(textured - bare, textures);
        TreeEdit saw;
        saw.id = 1;
        saw.operation = EditOperation::Prune;
        saw.shape = {EditShapeKind::Box, {-9.0, -9.0, -9.0, 9.0, 1.2, 9.0}};
        params.edits = {saw};
        const TreeResult cut = *m_pipeline.evaluate(params, Stage::Mesh);
        QVERIFY(cut.cuts && !cut.cuts->empty());
        const auto arrays = [](const TriangleMesh& mesh) {
            return mesh.positions.size() * (2 * sizeof(glm::vec3) + 2 * sizeof(Index)) +
                   mesh.triangles.size() * sizeof(glm::uvec3) + mesh.colours.size() * sizeof(glm::u8vec3);
        };
        QVERIFY(leastBudget(params) >= 2 * (arrays(cut.branches->mesh) + arrays(*cut.cuts)));
    }
    /// As they are dressed: a tile is about as wide as a thick limb is around, and far too wide for twigs.
    void picturesFitEveryBranch_data()
    {
        QTest::addColumn<double>("good");
        for (const Preset& preset : courseworkPresets())
            QTest::newRow(preset.name) << 0.9;
        QTest::newRow("TreeFern") << 0.95;
        QTest::newRow("CoconutPalmRules") << 0.95;
        QTest::newRow("Baobab") << 0.8;
        QTest::newRow("JoshuaTree") << 0.8;
        QTest::newRow("Saguaro") << 0.8; // its round ends are no tubes
        QTest::newRow("EnglishOak1995") << 0.85;
    }
    void picturesFitEveryBranch()
    {
        QFETCH(const double, good);
        const auto params = presetParams(QTest::currentDataTag());
        QVERIFY2(params, test::why(params));
        const auto tree = m_pipeline.evaluate(*params, Stage::Mesh);
        QVERIFY2(tree, test::why(tree));
        const auto made = tree->texture->coordinates(params->texture);
        QVERIFY2(made, test::why(made));
        const TextureReport report = textureReport(*tree->branches, **made);
        QCOMPARE(report.mirrored, Index(0));
        QVERIFY2(report.goodShare() >= good, qPrintable(QString::number(report.goodShare())));
    }
    /// The table of stretches in both languages, by its columns.
    void theHandbookSaysHowEvenTexturesAre_data()
    {
        QTest::addColumn<QString>("page");
        QTest::addColumn<QString>("start");
        QTest::newRow("en") << "/resources/handbook/files.md"
                            << "| four cross-sections |";
        QTest::newRow("fr") << "/resources/handbook/fr/files.md"
                            << "| quatre sections |";
    }
    void theHandbookSaysHowEvenTexturesAre()
    {
        QFETCH(const QString, page);
        QFETCH(const QString, start);
        QFile file(QStringLiteral(RAMURE_SOURCE_DIR) + page);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
        const auto row =
            std::ranges::find_if(lines, [&](const QString& line) { return line.startsWith(start); });
        QVERIFY(row - lines.begin() > 2 && row != lines.end());
        const QStringList names = (row - 2)->split(u'|'), shares = row->split(u'|');
        QVERIFY(names.size() == 7 && shares.size() == 7);
        for (int i = 2; i < 6; ++i) {
            const auto tree =
                m_pipeline.evaluate(*presetParams(names[i].trimmed().toStdString()), Stage::Mesh);
            QVERIFY(tree);
            const auto made = tree->texture->coordinates(TextureParams());
            QVERIFY(made);
            const double good = 100.0 * textureReport(*tree->branches, **made).goodShare();
            QCOMPARE(shares[i].trimmed().replace(u',', u'.'), QString::number(good, 'f', 1));
        }
    }

private:
    TreeResult tree(Stage last = Stage::Mesh)
    {
        NodeParams params;
        params.grammar.iterations = 3;
        return *m_pipeline.evaluate(params, last);
    }
    /// The least budget, in bytes, under which a pipeline keeps the mesh of a tree beside that of another
    /// with as many triangles. \param textures if given, both get coordinates: what these take
    static std::size_t leastBudget(NodeParams params, std::size_t* textures = nullptr)
    {
        const auto keeps = [&](std::size_t budget) {
            TreePipeline pipeline;
            pipeline.setCacheBudget(budget);
            std::size_t bytes = 0;
            const auto mesh = [&](double softness) {
                params.mesh.forkSoftness = softness;
                TreeResult made = *pipeline.evaluate(params, Stage::Mesh);
                if (textures && made.texture->coordinates(TextureParams()))
                    bytes += made.texture->bytes();
                return made.branches;
            };
            mesh(0.7);
            const auto second = mesh(0.6);
            if (textures)
                *textures = bytes;
            mesh(0.7);
            return mesh(0.6) == second;
        };
        std::size_t low = 0, high = StageCache<int>::usualBudget;
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            (keeps(middle) ? high : low) = middle;
        }
        return high;
    }
    TreePipeline m_pipeline;
};

RAMURE_SUITE(TestTextureStage)

} // namespace tst_texture_stage

#include "tst_texture_stage.moc"
