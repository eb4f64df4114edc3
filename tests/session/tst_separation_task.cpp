#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/session/jobs/separation_task.h"
#include "tests/support/suite.h"

#include <QSignalSpy>

namespace tst_separation_task {

using namespace ramure;

class TestSeparationTask : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void onlyTreesAreTreated();
    void theOutcomeIsOneUndoStep();
    void errorsAndCancelChangeNothing();
    void aTreeChangedMeanwhileIsLeftAlone();
    void destroyedWhileItRuns();

private:
    static Scene tinyTree()
    {
        Scene scene;
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Tree;
        node.name = "Tiny";
        node.params = *presetParams("TinyTree");
        scene.insert({node}, noNode, 0);
        return scene;
    }
    struct Bench
    {
        Bench()
        {
            document.reset(tinyTree(), {});
            tree = document.scene().nodes().front().id;
            connect(&task, &SeparationTask::finished, &task, [this](const std::optional<Error>& e) {
                error = e;
                ++finished;
            });
        }
        [[nodiscard]] QByteArray file() const { return writeProject(document.project()); }

        Document document;
        NodeId tree = noNode;
        SeparationTask task{&document};
        std::optional<Error> error;
        int finished = 0;
    };
};

void TestSeparationTask::onlyTreesAreTreated()
{
    Bench bench;
    QCOMPARE(bench.task.start(77).error().code, ErrorCode::Unknown);
    Node group;
    group.id = 1;
    group.name = "Group";
    const auto id = edit::insertNodes(bench.document, {group}, noNode, 0);
    QCOMPARE(bench.task.start(*id).error().code, ErrorCode::Invalid);
    QVERIFY(!bench.task.isRunning());
    bench.task.cancel();
}

void TestSeparationTask::theOutcomeIsOneUndoStep()
{
    Bench bench;
    const QByteArray before = bench.file();
    QVERIFY(bench.task.start(bench.tree));
    QVERIFY(bench.task.isRunning());
    QVERIFY(bench.task.start(bench.tree)); // the one that runs goes on
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 1, test::patience(60'000));
    QVERIFY(!bench.error);
    QVERIFY(!bench.task.isRunning());
    QVERIFY(bench.task.outcome().before > 0 && bench.task.outcome().rest.empty());
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const QByteArray after = bench.file();
    QVERIFY(after != before && after.contains("\"bend\""));
    const auto read = readProject(after);
    QVERIFY(read);
    QCOMPARE(writeProject(*read), after);
    bench.document.undo();
    QCOMPARE(bench.file(), before);
    bench.document.redo();
    QCOMPARE(bench.file(), after);
    // Nothing collides any more: no further step.
    QVERIFY(bench.task.start(bench.tree));
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 2, test::patience(60'000));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    QCOMPARE(bench.task.outcome().before, std::size_t(0));
}

void TestSeparationTask::errorsAndCancelChangeNothing()
{
    Bench bench;
    QVERIFY(bench.task.start(bench.tree));
    bench.task.cancel();
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 1, test::patience(60'000));
    QVERIFY(bench.error && bench.error->code == ErrorCode::Cancelled);
    QVERIFY(edit::setParam(bench.document, {bench.tree}, *findParam("grammar.axiom"), std::string("[")));
    QVERIFY(bench.task.start(bench.tree));
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 2, test::patience(60'000));
    QVERIFY(bench.error && bench.error->path == "grammar.axiom");
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestSeparationTask::aTreeChangedMeanwhileIsLeftAlone()
{
    Bench bench;
    QVERIFY(bench.task.start(bench.tree));
    QVERIFY(edit::setParam(bench.document, {bench.tree}, *findParam("turtle.alpha"), 0.3));
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 1, test::patience(60'000));
    QVERIFY(bench.error && bench.error->code == ErrorCode::Invalid);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    QVERIFY(bench.task.start(bench.tree));
    QVERIFY(edit::removeNodes(bench.document, {bench.tree}));
    QTRY_COMPARE_WITH_TIMEOUT(bench.finished, 2, test::patience(60'000));
    QVERIFY(bench.error);
}

void TestSeparationTask::destroyedWhileItRuns()
{
    Bench bench;
    SeparationTask task(&bench.document);
    QVERIFY(task.start(bench.tree));
}

RAMURE_SUITE(TestSeparationTask)

} // namespace tst_separation_task

#include "tst_separation_task.moc"
