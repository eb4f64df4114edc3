#include "core/qt/document/project/project_file.h"
#include "core/qt/session/export/exporter.h"
#include "tests/cli/cli_support.h"
#include "tests/support/random_scene.h"

namespace tst_same_moment {

using namespace ramure;

/// A file of the command line holds the moment that the one evaluator gives, to the byte.
class TestSameMoment : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void filesHoldTheEvaluatedMoment_data()
    {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<double>("seconds");
        QTest::newRow("rest") << 1U << 0.0;
        QTest::newRow("moved") << 1U << 0.75;
        QTest::newRow("another scene") << 2U << 1.625;
    }
    void filesHoldTheEvaluatedMoment()
    {
        QFETCH(unsigned, seed);
        QFETCH(double, seconds);
        QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("a.ramure"));
        QVERIFY(saveProjectFile({test::RandomScene(seed).make(), {}}, project));
        const QString file = folder.filePath(QStringLiteral("a.obj"));
        const auto run = test::runCli({"export", project, "--time", QString::number(seconds), "-o", file});
        QVERIFY2(run.code == 0, qPrintable(run.err));

        const auto opened = loadProjectFile(project);
        QVERIFY(opened);
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline), opened->scene.timeline());
        ExportOptions options;
        options.texture = true;
        QTemporaryDir beside;
        const QString meant = beside.filePath(QStringLiteral("a.obj"));
        QVERIFY(exportScene(evaluator.at(opened->scene, seconds), options, meant.toStdString()));
        QVERIFY(!test::bytesOf(file).isEmpty());
        QVERIFY(test::bytesOf(file) == test::bytesOf(meant));
    }
};

RAMURE_SUITE(TestSameMoment)

} // namespace tst_same_moment

#include "tst_same_moment.moc"
