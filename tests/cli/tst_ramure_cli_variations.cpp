#include "core/generators/variety.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/session/jobs/variations.h"
#include "tests/cli/batch_support.h"

namespace tst_ramure_cli_variations {

using namespace ramure;
using test::runCli;

/// The table that the editor's "Variations…" writes, grown by the batch as it is.
class TestRamureCliVariations : public test::FolderSuite
{
    Q_OBJECT

private slots:
    void init() { begin(); }

    void aBatchGrowsTheTreesOfThePictures()
    {
        Node tree;
        tree.kind = NodeKind::Tree;
        tree.name = "my tree, \"bent\"";
        tree.params = *presetParams("TinyTree");
        tree.params.sections.radialDivisions = 4; // no preset is like it
        auto rows = spreadVariations(
            {{findParam("variation.angle"), 0.1, 0.6}, {findParam("foliage.leavesDensity"), 0, 3}}, 11, 4);
        rows.push_back({3, {}}); // starred before anything was varied
        QVERIFY(saveVariations(tree, rows, path("my trees.csv")));
        const auto run = runCli({"batch", path("my trees.csv"), "-o", path("out"), "--file", "{row}.obj"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const auto lines = test::linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines.size(), rows.size());
        TreePipeline pipeline;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto grown = pipeline.evaluate(*variedParams(tree.params, rows[i]));
            QVERIFY(grown);
            const QJsonObject counts = lines[i].value("counts").toObject();
            QCOMPARE(counts.value("branches").toInteger(), qint64(grown->skeleton->size()));
            QCOMPARE(counts.value("leaves").toInteger(), qint64(grown->foliage->leaves.size()));
            QCOMPARE(counts.value("vertices").toInteger(), qint64(grown->branches->mesh.positions.size()));
            QCOMPARE(lines[i].value("input").toString(), QStringLiteral("my trees-tree.ramure"));
        }
    }
};

RAMURE_SUITE(TestRamureCliVariations)

} // namespace tst_ramure_cli_variations

#include "tst_ramure_cli_variations.moc"
