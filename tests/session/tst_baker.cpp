#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/baker.h"
#include "core/qt/session/motion/player.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace tst_baker {

using namespace ramure;

/// Motion baked beside a project: written, loaded, stale, damaged, foreign, freed.
class TestBaker : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = test::patience(30'000);
    static constexpr std::size_t memory = std::size_t(256) << 20;

    struct Bench
    {
        Bench()
        {
            recompute.setRest(0);
            baker.connect(&baker, &Baker::filesChanged, &player, &Player::reloadBakes);
            player.connect(&player, &Player::bakeRefused, &player,
                           [this](const Error& error) { refusals.push_back(error); });
        }
        void openTrees(const QString& path, int count = 1)
        {
            Scene scene;
            for (int i = 0; i < count; ++i) {
                Node node;
                node.id = scene.newId();
                node.kind = NodeKind::Tree;
                node.name = std::string(1, 'T');
                node.params = presetParams("TinyTree").value();
                QVERIFY(scene.insert({node}, noNode, i));
            }
            document.reset(std::move(scene), path);
            QVERIFY(recompute.waitForFull(patienceMs));
            QVERIFY(player.waitForIdle(patienceMs));
        }
        Expected<void> bake()
        {
            QSignalSpy finished(baker.job(), &Job::finished);
            if (auto started = baker.start(memory); !started)
                return started;
            if (!finished.wait(patienceMs))
                qFatal("no end");
            if (!player.waitForIdle(patienceMs))
                qFatal("busy");
            const auto error = finished[0][0].value<std::optional<Error>>();
            return error ? fail(*error) : Expected<void>();
        }
        void seek(qint64 frame)
        {
            player.seek(frame);
            QVERIFY(player.waitForIdle(patienceMs));
        }
        bool settled(BakeState state)
        {
            return QTest::qWaitFor([&] { return player.bakeState() == state && !player.isBusy(); },
                                   patienceMs);
        }
        std::vector<RigidTransform> bones() { return *player.motion()->of(1)->bones; }

        Document document;
        Recompute recompute{&document};
        Player player{&document};
        Baker baker{&document};
        std::vector<Error> refusals;
    };

    std::unique_ptr<QTemporaryDir> m_folder;
    [[nodiscard]] QString file(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    static QByteArray bytes(const QString& path)
    {
        QFile in(path);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    static void write(const QString& path, const QByteArray& content)
    {
        QFile out(path);
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(content) == content.size());
    }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void whatCannotBeBakedIsTold()
    {
        Bench bench;
        bench.openTrees({});
        QVERIFY(bench.bake().error().message().find("save that first") != std::string::npos);
        bench.openTrees(file("oak.ramure"));
        TimelineSettings rest;
        rest.firstFrame = -10;
        rest.lastFrame = 0;
        QVERIFY(edit::setTimeline(bench.document, rest));
        QVERIFY(bench.bake().error().message().find("frame 0") != std::string::npos);
        bench.openTrees(file("oak.ramure"), 0);
        QVERIFY(bench.bake().error().message().find("no visible tree") != std::string::npos);
        bench.openTrees(m_folder->filePath(QStringLiteral("no/folder/oak.ramure")));
        QCOMPARE(bench.bake().error().code, ErrorCode::Io);
        bench.openTrees(file("oak.ramure"));
        write(file("oak.motion-1.bake"), "a poem");
        const auto foreign = bench.bake();
        QVERIFY(foreign.error().message().find("oak.motion-1.bake") != std::string::npos);
        QVERIFY(!bench.baker.remove());
        QCOMPARE(bytes(file("oak.motion-1.bake")), QByteArray("a poem"));
    }

    void openedAgainSeeksAreAtOnceAndTheSame()
    {
        std::vector<RigidTransform> computed;
        {
            Bench bench;
            bench.openTrees(file("oak.ramure"), 2);
            bench.seek(200);
            computed = bench.bones();
            QCOMPARE(bench.player.bakeState(), BakeState::None);
            const auto baked = bench.bake();
            QVERIFY2(baked, test::why(baked));
            QVERIFY(bench.settled(BakeState::Good));
            QVERIFY(bench.bones() == computed);
            QVERIFY(bench.baker.bytes() > 1000);
        }
        QCOMPARE(bakeFiles(file("oak.ramure")),
                 (QStringList{file("oak.motion-1.bake"), file("oak.motion-2.bake")}));
        Bench bench;
        bench.openTrees(file("oak.ramure"), 2);
        QVERIFY(bench.settled(BakeState::Good));
        QCOMPARE(bench.player.band(), (std::vector<FrameRange>{{0, 250, FrameState::Cached}}));
        bench.seek(200);
        QVERIFY(bench.bones() == computed);
        QVERIFY(bench.refusals.empty());
    }

    void editsMakeItStaleAndUndoMakesItGoodAgain()
    {
        Bench bench;
        bench.openTrees(file("oak.ramure"));
        QVERIFY(bench.bake());
        QVERIFY(bench.settled(BakeState::Good));
        bench.seek(100);
        const auto before = bench.bones();
        const std::pair<const char*, ParamValue> edits[] = {
            {"physics.gravity", 2.0}, {"physics.seed", std::int64_t(2)}, {"turtle.alpha", 2.0}};
        for (const auto& [key, value] : edits) {
            QVERIFY(edit::setParam(bench.document, {1}, *findParam(key), value));
            QVERIFY(bench.recompute.waitForFull(patienceMs));
            QVERIFY2(bench.settled(BakeState::Stale), key);
            bench.seek(120);
            bench.document.undo();
            QVERIFY(bench.recompute.waitForFull(patienceMs));
            QVERIFY2(bench.settled(BakeState::Good), key);
            bench.seek(100);
            QVERIFY(bench.bones() == before);
            QCOMPARE(bench.player.band(), (std::vector<FrameRange>{{0, 250, FrameState::Cached}}));
        }
        QVERIFY(bench.refusals.empty());
    }

    void stoppingBringsItBackAfterTheHand()
    {
        Bench bench;
        bench.openTrees(file("oak.ramure"));
        QVERIFY(bench.bake());
        QVERIFY(bench.settled(BakeState::Good));
        bench.seek(200);
        const auto before = bench.bones();
        bench.seek(20);
        bench.player.play();
        bench.player.setPull(1, Pull{2, 1.0, {3.0, 3.0, 0.0}, 20.0});
        QVERIFY(QTest::qWaitFor([&] { return bench.player.frame() > 40; }, patienceMs));
        bench.player.stop();
        QVERIFY(bench.player.waitForIdle(patienceMs));
        QTRY_COMPARE(bench.player.band(), (std::vector<FrameRange>{{0, 250, FrameState::Cached}}));
        bench.seek(200);
        QVERIFY(bench.bones() == before);
    }

    void brokenForeignAndStaleFilesAreNeverTrusted()
    {
        std::vector<RigidTransform> computed;
        {
            Bench bench;
            bench.openTrees(file("oak.ramure"));
            bench.seek(60);
            computed = bench.bones();
            QVERIFY(bench.bake());
        }
        const QString baked = file("oak.motion-1.bake");
        const QByteArray good = bytes(baked);
        QByteArray damaged = good;
        damaged[good.size() / 2] = char(damaged[good.size() / 2] ^ 4);
        const std::pair<QByteArray, const char*> cases[] = {{damaged, "damaged"},
                                                            {good.left(good.size() / 3), "cut short"},
                                                            {"#!/bin/sh\n", "not a file of"}};
        for (const auto& [content, reason] : cases) {
            write(baked, content);
            Bench bench;
            bench.openTrees(file("oak.ramure"));
            QVERIFY(bench.settled(BakeState::Stale));
            QVERIFY2(bench.refusals.size() == 1, reason);
            QVERIFY2(bench.refusals[0].message().find(reason) != std::string::npos,
                     bench.refusals[0].message().c_str());
            QCOMPARE(QString::fromStdString(bench.refusals[0].file), baked);
            bench.seek(60);
            QVERIFY(bench.bones() == computed);
        }
        write(baked, good);
        Bench bench;
        bench.openTrees({});
        QVERIFY(edit::setParam(bench.document, {1}, *findParam("physics.damping"), 0.5));
        bench.document.setFilePath(file("oak.ramure"));
        QVERIFY(bench.settled(BakeState::Stale));
        QTRY_COMPARE(bench.refusals.size(), std::size_t(1));
        QVERIFY(bench.refusals[0].message().find("other parameters") != std::string::npos);
    }

    void freedMotionIsGone()
    {
        Bench bench;
        bench.openTrees(file("oak.ramure"));
        QVERIFY(bench.bake());
        QVERIFY(bench.settled(BakeState::Good));
        write(file("oak.motion-1.bake.txt"), "notes"); // not ours
        QVERIFY(bench.baker.remove());
        QVERIFY(bench.settled(BakeState::None));
        QVERIFY(bakeFiles(file("oak.ramure")).isEmpty());
        QVERIFY(QFile::exists(file("oak.motion-1.bake.txt")));
        QCOMPARE(bench.player.band().back().state, FrameState::Missing);
    }

    void cancellingLeavesNoFile()
    {
        Bench bench;
        bench.openTrees(file("oak.ramure"));
        TimelineSettings longRun;
        longRun.lastFrame = mostFrame;
        QVERIFY(edit::setTimeline(bench.document, longRun));
        QSignalSpy finished(bench.baker.job(), &Job::finished);
        QSignalSpy progress(bench.baker.job(), &Job::progress);
        QVERIFY(bench.baker.start(memory));
        QVERIFY(bench.baker.job()->isRunning());
        QVERIFY(progress.wait(patienceMs));
        bench.baker.job()->cancel();
        QVERIFY(finished.wait(patienceMs));
        QCOMPARE(finished[0][0].value<std::optional<Error>>()->code, ErrorCode::Cancelled);
        QVERIFY(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }

    void closingWhileBakingEndsCleanly()
    {
        for (int i = 0; i < 3; ++i) {
            Bench bench;
            bench.openTrees(file("oak.ramure"));
            TimelineSettings longRun;
            longRun.lastFrame = mostFrame;
            QVERIFY(edit::setTimeline(bench.document, longRun));
            QSignalSpy progress(bench.baker.job(), &Job::progress);
            QVERIFY(bench.baker.start(memory));
            QTRY_VERIFY_WITH_TIMEOUT(progress.count() >= i, patienceMs);
        }
        QVERIFY(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
};

RAMURE_SUITE(TestBaker)

} // namespace tst_baker

#include "tst_baker.moc"
