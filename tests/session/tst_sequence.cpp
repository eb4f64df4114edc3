#include "core/evaluate/evaluator.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/motion/sequence.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace tst_sequence {

using namespace ramure;

/// Files of many frames: their names, their bytes, how large they get, and what a cancelled one leaves.
class TestSequence : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    Scene m_scene;
    TreePipeline m_pipeline;

    [[nodiscard]] QString name(const QString& file) const { return m_folder->filePath(file); }
    [[nodiscard]] std::string path(const char* file) const { return name(QLatin1String(file)).toStdString(); }
    [[nodiscard]] QByteArray bytes(const QString& file) const
    {
        QFile in(name(file));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    [[nodiscard]] QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

private slots:
    void initTestCase()
    {
        Node node;
        node.id = m_scene.newId();
        node.kind = NodeKind::Tree;
        node.name = std::string(1, 'T');
        node.params = presetParams("TinyTree").value();
        QVERIFY(m_scene.insert({node}, noNode, 0));
    }
    void init()
    {
        test::failOnAnyWarning();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void badSequencesAreRefused()
    {
        const std::pair<FrameSequence, const char*> cases[] = {
            {{-1, 5, 1, 24.0}, "first"},
            {{5, 4, 1, 24.0}, "last"},
            {{0, 5, 0, 24.0}, "step"},
            {{0, 5, -3, 24.0}, "step"},
            {{0, mostFrame + 1, 1, 24.0}, "last"},
            {{0, mostFrame, 1, 24.0}, "last"},
        };
        for (const auto& [frames, where] : cases) {
            const auto done = exportSequence(m_scene, {}, frames, pipelineSource(m_pipeline), path("a.obj"));
            QVERIFY(!done);
            QCOMPARE(done.error().path, std::string(where));
        }
        QCOMPARE(exportSequence(m_scene, {}, {0, 1, 1, 24.0}, pipelineSource(m_pipeline), path("a.dae"))
                     .error()
                     .code,
                 ErrorCode::Unknown);
        QVERIFY(files().isEmpty());
    }

    void namesHaveNumbers()
    {
        QCOMPARE(numberedFile("a/tree.obj", 7), std::string("a/tree_0007.obj"));
        QCOMPARE(numberedFile("tree.v2.obj", 0), std::string("tree.v2_0000.obj"));
        QCOMPARE(numberedFile("tree.obj", 123456), std::string("tree_123456.obj"));
        QCOMPARE(numberedFile("folder.d/tree", 1), std::string("folder.d/tree_0001"));
    }

    void everyFileIsThatOfItsMoment()
    {
        const FrameSequence frames{10, 50, 20, 30.0};
        QVERIFY(exportSequence(m_scene, {}, frames, pipelineSource(m_pipeline), path("tree.obj")));
        QCOMPARE(files(), (QStringList{QStringLiteral("tree_0010.mtl"), QStringLiteral("tree_0010.obj"),
                                       QStringLiteral("tree_0030.mtl"), QStringLiteral("tree_0030.obj"),
                                       QStringLiteral("tree_0050.mtl"), QStringLiteral("tree_0050.obj")}));
        QVERIFY(bytes(QStringLiteral("tree_0010.obj")) != bytes(QStringLiteral("tree_0050.obj")));
        for (const int frame : {50, 10, 30}) {
            Evaluator moving(pipelineSource(m_pipeline));
            QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("one")));
            const QString file = QStringLiteral("tree_%1.obj").arg(frame, 4, 10, QLatin1Char('0'));
            QVERIFY(exportScene(moving.at(m_scene, frame / 30.0), {},
                                name(QStringLiteral("one/") + file).toStdString()));
            QVERIFY(bytes(QStringLiteral("one/") + file) == bytes(file));
        }
    }

    void sizesAreKnownBefore()
    {
        for (const bool texture : {false, true})
            for (const char* file : {"size.obj", "size.ply"})
                for (const bool ascii : {false, true}) {
                    ExportOptions options;
                    options.texture = texture;
                    options.write.ascii = ascii;
                    const TreeSource rest = pipelineSource(m_pipeline);
                    QVERIFY(exportScene(Evaluator(rest).at(m_scene), options, path(file)));
                    const auto real = double(QFileInfo(name(QLatin1String(file))).size());
                    const auto said = double(estimatedFileBytes(m_scene, options, rest, path(file)));
                    QVERIFY2(said > 0.75 * real && said < 1.3 * real,
                             qPrintable(QStringLiteral("%1 %2 %3: %4 for %5")
                                            .arg(QLatin1String(file))
                                            .arg(texture)
                                            .arg(ascii)
                                            .arg(said)
                                            .arg(real)));
                }
        ExportOptions hidden;
        hidden.nodes = {77};
        QCOMPARE(estimatedFileBytes(m_scene, hidden, pipelineSource(m_pipeline), path("a.obj")), 0U);
    }

    /// Written sizes in bytes, as `ramure-cli export preset:NAME -o a.glb` gave them, with `--wind-loop 2`
    /// and with `--levels 3`: a change of the format has new ones.
    void sizesOfGlbAreWithinATenth_data()
    {
        QTest::addColumn<double>("still");
        QTest::addColumn<double>("moving");
        QTest::addColumn<double>("levels");
        QTest::newRow("EnglishOak1995") << 142609372.0 << 192324804.0 << 170956340.0;
        QTest::newRow("SilverBirch1995") << 59806432.0 << 80255800.0 << 84896912.0;
        QTest::newRow("ScotsPine1995") << 190366292.0 << 262948080.0 << 0.0;
        QTest::newRow("SmallTree") << 32410308.0 << 43303640.0 << 44629376.0;
        QTest::newRow("CoconutPalmRules") << 6369796.0 << 8446404.0 << 0.0;
        QTest::newRow("OrchardApple1995") << 40020216.0 << 53490072.0 << 0.0;
    }
    void sizesOfGlbAreWithinATenth()
    {
        QFETCH(double, still);
        QFETCH(double, moving);
        QFETCH(double, levels);
        const auto scene = presetScene(QTest::currentDataTag());
        QVERIFY(scene);
        ExportOptions options;
        options.texture = true;
        const TreeSource rest = pipelineSource(m_pipeline);
        const auto isNear = [&](double real, double slack = 0.1) {
            const auto said = double(estimatedFileBytes(*scene, options, rest, path("a.glb")));
            return std::abs(said - real) <= slack * real;
        };
        QVERIFY(isNear(still));
        options.clip.resize(48);
        QVERIFY(isNear(moving));
        options.clip.clear();
        if (levels > 0.0) {
            options.levels.count = 3;
            QVERIFY(isNear(levels, 0.15)); // bark and leaves share them as each tree allows
        }
    }

    /// Which have one mesh in the file (tst_glb_motion); those with another bark, or that move, have their
    /// own.
    void equalTreesOfAGlbCountOnce()
    {
        Node node = m_scene.nodes().front();
        std::vector<Node> row;
        for (int i = 0; i < 3; ++i) {
            node.id = static_cast<NodeId>(i + 1);
            node.params.tree.translation.x = 3.0 * i;
            row.push_back(node);
        }
        const TreeSource rest = pipelineSource(m_pipeline);
        const auto bytes = [&](const Scene& scene, const char* file, const ExportOptions& options = {}) {
            return double(estimatedFileBytes(scene, options, rest, path(file)));
        };
        const Scene equal = *Scene::fromNodes(row);
        const double one = bytes(m_scene, "a.glb");
        QVERIFY(one > 0.0);
        QCOMPARE(bytes(equal, "a.glb"), one);
        QVERIFY(bytes(equal, "a.obj") > 2.9 * bytes(m_scene, "a.obj"));
        QVERIFY(exportScene(Evaluator(rest).at(equal), {}, path("a.glb")));
        const auto real = double(QFileInfo(name(QStringLiteral("a.glb"))).size());
        QVERIFY2(std::abs(one - real) < 0.2 * real, qPrintable(QString::number(one / real)));
        ExportOptions moving;
        moving.clip.resize(10);
        QVERIFY(bytes(equal, "a.glb", moving) > 2.5 * bytes(m_scene, "a.glb", moving));
        row[2].params.bark.family = BarkFamily::Corky;
        QVERIFY(bytes(*Scene::fromNodes(row), "a.glb") > 1.9 * one);
    }

    void cancellingLeavesWholeFilesOnly()
    {
        const FrameSequence frames{0, 1000, 1, 24.0};
        QVERIFY(exportSequence(m_scene, {}, {0, 0, 1, 24.0}, pipelineSource(m_pipeline), path("w.ply")));
        const qint64 whole = QFileInfo(name(QStringLiteral("w_0000.ply"))).size();
        for (const double until : {0.0, 0.0016, 0.0031, 0.0052}) {
            std::stop_source stop;
            const Progress progress{stop.get_token(), [&](double fraction) {
                                        if (fraction > until)
                                            stop.request_stop();
                                    }};
            const auto done =
                exportSequence(m_scene, {}, frames, pipelineSource(m_pipeline), path("tree.ply"), progress);
            QVERIFY(!done);
            QCOMPARE(done.error().code, ErrorCode::Cancelled);
            for (const QString& file : files())
                QCOMPARE(QFileInfo(name(file)).size(), whole);
        }
    }
};

RAMURE_SUITE(TestSequence)

} // namespace tst_sequence

#include "tst_sequence.moc"
