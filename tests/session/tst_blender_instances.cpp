// Headless Blender as the judge of lists of instances and of the colours of a PLY. Skipped where there is no
// Blender.
#include "core/io/copy_list.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace tst_blender_instances {

using namespace ramure;

class TestBlenderInstances : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QJsonObject m_said;
    std::size_t m_copies = 0;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    void writeFiles()
    {
        Node tree;
        tree.id = 1;
        tree.kind = NodeKind::Tree;
        tree.name = "Oak";
        tree.params = *presetParams("TinyTree");
        tree.params.tree.translation = {3.0, 0.5, -1.0};
        tree.params.tree.rotation.y = 0.7;
        const auto scene = Scene::fromNodes({tree});
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        ExportOptions options;
        options.write.mapSize = 0;
        QVERIFY(exportScene(evaluator.at(*scene), options, path("merged.obj").toStdString()));
        options.instances = true;
        QVERIFY(exportScene(evaluator.at(*scene), options, path("listed.obj").toStdString()));
        const auto result = pipeline.evaluate(tree.params);
        m_copies = result->foliage->leaves.size() + result->foliage->apples.size();
        TriangleMesh one;
        one.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
        one.triangles = {{0, 1, 2}};
        const MeshPart parts[] = {{"bark", &one, barkMaterial()}, {"apples", &one, applesMaterial()}};
        QVERIFY(writePly(path("colours.ply").toStdString(), parts, {}));
    }

private slots:
    void initTestCase()
    {
        const QString blender = QStandardPaths::findExecutable(QStringLiteral("blender"));
        if (blender.isEmpty())
            RAMURE_CANNOT_RUN("no Blender on this machine (Debian: apt-get install blender): no judge");
        writeFiles();
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(blender,
                      {QStringLiteral("-b"), QStringLiteral("--factory-startup"), QStringLiteral("--python"),
                       QStringLiteral(RAMURE_TEST_DATA "/blender_instances.py"), QStringLiteral("--"),
                       QString::fromStdString(copyListPath(path("listed.obj").toStdString(), ".json")),
                       path("merged.obj"), path("colours.ply"), path("said.json")});
        QVERIFY(process.waitForFinished(300'000));
        QFile file(path("said.json"));
        QVERIFY2(file.open(QIODevice::ReadOnly), process.readAll().constData());
        m_said = QJsonDocument::fromJson(file.readAll()).object();
    }
    void init() { test::failOnAnyWarning(); }

    void instancesStandWhereTheMergedMeshHasThem()
    {
        QCOMPARE(m_said.value("instances").toInteger(), qint64(m_copies));
        QVERIFY(m_said.value("vertices").toInteger() > qint64(m_copies));
        QCOMPARE(m_said.value("missing").toInteger(), qint64(0));
        const double farthest = m_said.value("farthest").toDouble() / m_said.value("size").toDouble();
        QVERIFY2(farthest < 2e-6, qPrintable(QString::number(farthest)));
    }
    void coloursOfAPlyAreRead()
    {
        const glm::u8vec3 bark = barkMaterial().colour, apple = applesMaterial().colour;
        const QJsonArray expected{QJsonArray{apple.r, apple.g, apple.b}, QJsonArray{bark.r, bark.g, bark.b}};
        QCOMPARE(m_said.value("colours").toArray(), expected);
    }
};

RAMURE_SUITE(TestBlenderInstances)

} // namespace tst_blender_instances

#include "tst_blender_instances.moc"
