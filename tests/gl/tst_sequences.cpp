// Sequences of meshes and pictures from the editor are, byte for byte, those of the command line.
#include "core/presets/presets.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "widgets/dialogs/export/sequence_task.h"
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace tst_sequences {

using namespace ramure;

class TestSequences : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = test::patience(120'000);
    QTemporaryDir m_folder;
    Document m_document;
    Recompute m_recompute{&m_document};

    QString path(const QString& name) const { return m_folder.filePath(name); }
    static QByteArray bytes(const QString& file)
    {
        QFile in(file);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    static void cli(const QStringList& arguments)
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(QStringLiteral(RAMURE_CLI), arguments);
        QVERIFY(process.waitForFinished(patienceMs));
        QCOMPARE(process.exitCode(), 0);
    }
    static void waitFor(SequenceTask& task)
    {
        QSignalSpy finished(&task, &Job::finished);
        QVERIFY(finished.wait(patienceMs));
        const auto error = finished[0][0].value<std::optional<Error>>();
        QVERIFY2(!error, error ? error->message().c_str() : "");
    }
    void compareFolders(const QString& one, const QString& other, int count)
    {
        const QStringList names = QDir(path(one)).entryList(QDir::Files, QDir::Name);
        QCOMPARE(names.size(), count);
        QCOMPARE(QDir(path(other)).entryList(QDir::Files, QDir::Name), names);
        for (const QString& name : names) {
            const QByteArray first = bytes(path(one + u'/' + name));
            QVERIFY2(first.size() > 100, qPrintable(name));
            QVERIFY2(first == bytes(path(other + u'/' + name)), qPrintable(name));
        }
    }
    /// What the command line sees: all that is there at the first frame.
    static PictureLook look(const Document& document, QSize size)
    {
        PictureLook look;
        look.size = size;
        look.options.quality = Quality::Good;
        const RenderScene rest = SceneBuilder().build(
            document.scene(),
            [&](NodeId id) { return document.result(id) ? &document.result(id)->tree : nullptr; },
            SceneView());
        look.camera.frame(rest.framePoints(), double(size.width()) / size.height());
        return look;
    }

private slots:
    void initTestCase()
    {
        test::failOnAnyWarning();
        Scene scene;
        Node tree;
        tree.id = scene.newId();
        tree.kind = NodeKind::Tree;
        tree.name = "TinyTree";
        tree.params = presetParams("TinyTree").value();
        QVERIFY(scene.insert({tree}, noNode, 0));
        m_document.reset(std::move(scene), {});
        QVERIFY(m_recompute.waitForFull(patienceMs));
        for (const char* folder :
             {"mine", "cli", "shots", "cli-shots", "turn", "cli-turn", "film", "cli-film", "stopped"})
            QVERIFY(QDir(m_folder.path()).mkdir(QLatin1String(folder)));
    }
    void init() { test::failOnAnyWarning(); }

    void meshesAreThoseOfTheCommandLine()
    {
        SequenceTask task;
        ExportOptions options;
        options.texture = true; // as the command line does without --no-texture
        task.startMeshes(m_document, options, {0, 40, 20, 24.0}, path(QStringLiteral("mine/tree.obj")));
        waitFor(task);
        cli({QStringLiteral("export"), QStringLiteral("preset:TinyTree"), QStringLiteral("--frames"),
             QStringLiteral("0:40:20"), QStringLiteral("-o"), path(QStringLiteral("cli/tree.obj"))});
        compareFolders(QStringLiteral("mine"), QStringLiteral("cli"),
                       14); // three meshes, three materials, eight maps
    }

    void picturesAreThoseOfTheCommandLine()
    {
        SequenceTask task;
        task.startPictures(m_document, look(m_document, {320, 200}),
                           frameShots({0, 20, 10, 24.0}, path(QStringLiteral("shots/p.png")).toStdString()));
        waitFor(task);
        cli({QStringLiteral("render"), QStringLiteral("preset:TinyTree"), QStringLiteral("--frames"),
             QStringLiteral("0:20:10"), QStringLiteral("--size"), QStringLiteral("320x200"),
             QStringLiteral("-o"), path(QStringLiteral("cli-shots/p.png"))});
        compareFolders(QStringLiteral("shots"), QStringLiteral("cli-shots"), 3);
    }

    void turntablesAreThoseOfTheCommandLine()
    {
        SequenceTask task;
        PictureLook around = look(m_document, {320, 200});
        around.allAround = true;
        task.startPictures(m_document, around,
                           turntableShots(4, 0.0, path(QStringLiteral("turn/p.png")).toStdString()));
        waitFor(task);
        cli({QStringLiteral("render"), QStringLiteral("preset:TinyTree"), QStringLiteral("--turntable"),
             QStringLiteral("4"), QStringLiteral("--size"), QStringLiteral("320x200"), QStringLiteral("-o"),
             path(QStringLiteral("cli-turn/p.png"))});
        compareFolders(QStringLiteral("turn"), QStringLiteral("cli-turn"), 4);
        const QImage front(path(QStringLiteral("turn/p_0000.png")));
        QVERIFY(front != QImage(path(QStringLiteral("turn/p_0001.png"))));
    }

    /// The encoder is a stand-in that keeps what it is given.
    void filmsAreThoseOfTheCommandLine()
    {
        const QString program = path(QStringLiteral("bin/ffmpeg"));
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("bin")));
        QFile script(program);
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write("#!/bin/sh\nfor last; do :; done\ncat > \"$last\"\n");
        script.close();
        QVERIFY(script.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        const QByteArray before = qgetenv("PATH");
        qputenv("PATH", QFile::encodeName(path(QStringLiteral("bin"))) + ':' + before);
        SequenceTask task;
        PictureLook around = look(m_document, {320, 200});
        around.allAround = true;
        around.film = path(QStringLiteral("film/p.mp4")).toStdString();
        task.startPictures(m_document, around, turntableShots(3, 0.0, around.film));
        QCOMPARE(task.fileCount(), std::int64_t(1));
        waitFor(task);
        cli({QStringLiteral("render"), QStringLiteral("preset:TinyTree"), QStringLiteral("--turntable"),
             QStringLiteral("3"), QStringLiteral("--size"), QStringLiteral("320x200"), QStringLiteral("-o"),
             path(QStringLiteral("cli-film/p.mp4"))});
        qputenv("PATH", before);
        compareFolders(QStringLiteral("film"), QStringLiteral("cli-film"), 1);
        QCOMPARE(bytes(path(QStringLiteral("film/p.mp4"))).size(), 3 * 4 * 320 * 200);
    }

    void transparentPicturesHaveNoWorld()
    {
        SequenceTask task;
        PictureLook clear = look(m_document, {320, 200});
        clear.options.world = false;
        const std::string file = path(QStringLiteral("clear.png")).toStdString();
        task.startPictures(m_document, clear, {{0.0, 0.0, file}});
        waitFor(task);
        const QImage picture(path(QStringLiteral("clear.png")));
        QCOMPARE(picture.size(), QSize(320, 200));
        QCOMPARE(qAlpha(picture.pixel(2, 2)), 0);
        int opaque = 0;
        for (int x = 0; x < 320; ++x)
            for (int y = 0; y < 200; ++y)
                opaque += qAlpha(picture.pixel(x, y)) == 255 ? 1 : 0;
        QVERIFY(opaque > 500);
    }

    /// By the button, and by the end of the task's life, at several moments of the work.
    void cancelledSequencesLeaveWholePictures()
    {
        const QString folder = path(QStringLiteral("stopped"));
        for (int i = 0; i < 6; ++i) {
            SequenceTask task;
            QSignalSpy progress(&task, &Job::progress), finished(&task, &Job::finished);
            task.startPictures(
                m_document, look(m_document, {320, 200}),
                frameShots({0, 500, 1, 24.0}, (folder + QStringLiteral("/p.png")).toStdString()));
            QTRY_VERIFY_WITH_TIMEOUT(progress.count() >= i || finished.count() == 1, patienceMs);
            if (i % 2 == 0)
                continue;
            task.cancel();
            QVERIFY(finished.count() == 1 || finished.wait(patienceMs));
            QCOMPARE(finished[0][0].value<std::optional<Error>>()->code, ErrorCode::Cancelled);
        }
        for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden)) {
            QVERIFY2(name.endsWith(QStringLiteral(".png")), qPrintable(name));
            QVERIFY2(!QImage(folder + u'/' + name).isNull(), qPrintable(name));
        }
    }

    void placesThatCannotBeWrittenAreNamed()
    {
        SequenceTask task;
        QSignalSpy finished(&task, &Job::finished);
        task.startPictures(m_document, look(m_document, {64, 64}),
                           {{0.0, 0.0, path(QStringLiteral("no/folder/p.png")).toStdString()}});
        QVERIFY(finished.wait(patienceMs));
        const auto error = finished[0][0].value<std::optional<Error>>();
        QVERIFY(error);
        QCOMPARE(error->code, ErrorCode::Io);
        QVERIFY(error->message().find("no/folder/p.png") != std::string::npos);
    }
};

RAMURE_SUITE(TestSequences)

} // namespace tst_sequences

#include "tst_sequences.moc"
