#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/edit_script.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/preset_scene.h"
#include "core/skeleton/skeleton.h"
#include "tests/support/suite.h"

#include <QFile>
#include <cmath>

namespace tst_recipe_files {

using namespace ramure;
using test::why;

/// Recipes in files and scripts.
class TestRecipeFiles : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badStepsAreRefusedWithTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("step");
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("values no object")
            << QByteArray(R"("op":"sag","values":3)") << QByteArray("edits[0].values");
        QTest::newRow("unknown value") << QByteArray(R"("op":"sag","values":{"sag.colour":1})")
                                       << QByteArray("edits[0].values.sag.colour");
        QTest::newRow("of another kind") << QByteArray(R"("op":"sag","values":{"gnarl.angle":1})")
                                         << QByteArray("edits[0].values.gnarl.angle");
        QTest::newRow("out of range") << QByteArray(R"("op":"sag","values":{"sag.amount":1e9})")
                                      << QByteArray("edits[0].values.sag.amount");
        QTest::newRow("text for a number") << QByteArray(R"("op":"sag","values":{"sag.amount":"much"})")
                                           << QByteArray("edits[0].values.sag.amount");
        QTest::newRow("no frozen tree") << QByteArray(R"("op":"frozen")") << QByteArray("edits[0].tree");
        QTest::newRow("broken frozen tree")
            << QByteArray(R"("op":"frozen","tree":"UlNLMQ==")") << QByteArray("edits[0].tree");
        QTest::newRow("values of a hand edit")
            << QByteArray(R"("op":"remove","target":{"id":"00000000000000aa"},"values":{})")
            << QByteArray("edits[0].values");
    }
    void badStepsAreRefusedWithTheirPlace()
    {
        QFETCH(QByteArray, step);
        QFETCH(QByteArray, path);
        const auto read = readProject(fileOf(step));
        QVERIFY(!read);
        QCOMPARE(QByteArray::fromStdString(read.error().path), "nodes[0]." + path);
    }

    /// Of a program to come: kept, greyed, written back, and the tree is as if it were not there.
    void unknownStepsAreKept_data()
    {
        QTest::addColumn<QByteArray>("step");
        QTest::newRow("kind") << QByteArray(R"("op":"lichen","values":{"lichen.amount":0.5},"more":[1,2])");
        QTest::newRow("version") << QByteArray(R"("op":"sag","version":99,"values":{"sag.new":0.5})");
    }
    void unknownStepsAreKept()
    {
        QFETCH(QByteArray, step);
        const auto project = readProject(fileOf(step));
        QVERIFY2(project, why(project).constData());
        const Node& node = project->scene.nodes().front();
        QCOMPARE(node.params.edits.size(), std::size_t(1));
        QCOMPARE(node.params.edits.front().operation, EditOperation::Unknown);
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(node.params, Stage::Skeleton);
        QVERIFY2(tree, why(tree).constData());
        QCOMPARE(tree->edits->front().state, EditState::Idle);
        QVERIFY(tree->skeleton->p1 == tree->grown->p1);
        const auto again = readProject(writeProject(*project));
        QVERIFY2(again, why(again).constData());
        QVERIFY(again->scene.nodes().front().params.edits == node.params.edits);
        QVERIFY(writeProject(*project).contains("99") || writeProject(*project).contains("lichen.amount"));
    }

    void stepsRoundTrip()
    {
        Document document;
        document.reset(*presetScene("EnglishOak1995"), {}, {});
        const NodeId tree = document.scene().nodes().front().id;
        for (const EditOperationInfo& info : editOperations())
            if (!stepParams(info.operation).empty())
                QVERIFY(edit::putTreeEdits(document, tree, {newStep(info.operation)}));
        const auto list = document.scene().find(tree)->params.edits;
        QVERIFY(edit::setStepParam(document, tree, list[0].id, *findParam("sag.amount"), 7.5));
        const auto idOf = [&list](EditOperation operation) {
            return std::ranges::find(list, operation, &TreeEdit::operation)->id;
        };
        QVERIFY(edit::setStepParam(document, tree, idOf(EditOperation::Grammar), *findParam("grammar.rules"),
                                   std::string("A -> F\nB -> A\n")));
        QVERIFY(edit::setStepParam(document, tree, idOf(EditOperation::WeberPenn), *findParam("stand.offset"),
                                   glm::dvec3(1.0, 0.0, -0.5)));
        QVERIFY(edit::freezeTree(document, tree, list[1].id));
        QCOMPARE(document.scene().find(tree)->params.edits[2].operation, EditOperation::Frozen);
        QVERIFY(!edit::freezeTree(document, tree, 0)); // below it
        const Project project = document.project();
        const auto again = readProject(writeProject(project));
        QVERIFY2(again, why(again).constData());
        QVERIFY(again->scene.nodes().front().params.edits == document.scene().find(tree)->params.edits);
        while (document.undoStack()->canUndo())
            document.undo();
        QVERIFY(document.scene().find(tree)->params == presetScene("EnglishOak1995")->nodes().front().params);
    }

    /// Ten files of an older version: counts are exact, places to 1e-9 m.
    void oldFilesGrowAsTheyDid_data()
    {
        QTest::addColumn<QByteArray>("line");
        QFile table(QStringLiteral(RAMURE_TEST_DATA "/archive/expected.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        table.readLine();
        while (!table.atEnd())
            if (const QByteArray line = table.readLine().trimmed(); !line.isEmpty())
                QTest::newRow(line.left(line.indexOf('.')).constData()) << line;
    }
    void oldFilesGrowAsTheyDid()
    {
        QFETCH(QByteArray, line);
        const QList<QByteArray> cells = line.split(',');
        const auto project = loadProjectFile(QStringLiteral(RAMURE_TEST_DATA "/archive/") + cells[0]);
        QVERIFY2(project, why(project).constData());
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(project->scene.nodes().front().params, Stage::Skeleton);
        QVERIFY2(tree, why(tree).constData());
        const SkeletonStats stats = skeletonStats(*tree->skeleton);
        QCOMPARE(stats.branches, Index(cells[1].toUInt()));
        QCOMPARE(stats.terminals, Index(cells[2].toUInt()));
        const double values[] = {stats.totalLength, stats.sumA1, stats.min.x, stats.min.y,
                                 stats.min.z,       stats.max.x, stats.max.y, stats.max.z};
        for (std::size_t i = 0; i < std::size(values); ++i)
            QVERIFY2(std::abs(values[i] - cells[qsizetype(i) + 3].toDouble()) < 1e-9 * (i < 2 ? 1e3 : 1.0),
                     cells[0].constData());
        const int placed =
            tree->edits ? int(std::ranges::count(*tree->edits, EditState::ByAddress, &EditOutcome::state))
                        : 0;
        QCOMPARE(placed, cells[11].toInt());
    }

    void scriptsChangeSteps()
    {
        Document document;
        document.reset(*presetScene("TinyTree"), {}, {});
        const NodeId tree = document.scene().nodes().front().id;
        const auto edits = [&]() -> const std::vector<TreeEdit>& {
            return document.scene().find(tree)->params.edits;
        };
        QVERIFY(replayEdits(document, tree,
                            "{\"op\":\"sag\",\"values\":{\"sag.amount\":4}}\n"
                            "{\"op\":\"gnarl\",\"name\":\"Crooked\"}\n"
                            "{\"op\":\"flare\"}\n"
                            "{\"step\":\"Crooked\",\"move\":2}\n"
                            "{\"step\":\"#3\",\"enabled\":false,\"values\":{\"sag.amount\":6}}\n"
                            "{\"step\":\"flare\",\"remove\":true}\n"));
        QCOMPARE(edits().size(), std::size_t(2));
        QCOMPARE(edits()[0].operation, EditOperation::Gnarl);
        QCOMPARE(edits()[1].values->step.sag.amount, 6.0);
        QVERIFY(!edits()[1].enabled);
        document.undo();
        QVERIFY(edits().empty());
        QVERIFY(replayEdits(document, tree,
                            "{\"op\":\"gnarl\"}\n{\"op\":\"sag\"}\n{\"step\":\"gnarl\",\"freeze\":true}\n"));
        QCOMPARE(edits()[1].operation, EditOperation::Frozen);
        document.undo();
        for (const char* bad : {"{\"step\":\"#1\",\"remove\":true}", "{\"step\":\"#1\",\"freeze\":false}",
                                "{\"step\":\"sag\"}", "{\"op\":\"sag\"}\n{\"step\":\"sag\",\"move\":9}",
                                "{\"op\":\"sag\"}\n{\"step\":\"sag\",\"colour\":9}",
                                "{\"op\":\"sag\"}\n{\"step\":\"sag\",\"values\":{\"sag.amount\":1e9}}"})
            QVERIFY2(!replayEdits(document, tree, bad), bad);
        QVERIFY(edits().empty());
    }

private:
    static QByteArray fileOf(const QByteArray& step)
    {
        return R"({"format":"ramure","version":5,"nodes":[{"id":1,"kind":"tree","edits":[{"id":"00000000000000bb",)" +
               step + "}]}]}";
    }
};

RAMURE_SUITE(TestRecipeFiles)

} // namespace tst_recipe_files

#include "tst_recipe_files.moc"
