// Tracks in the document: commands, project file, the player's frames, import.
#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/session/jobs/import_task.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace tst_tracks {

using namespace ramure;

namespace {

const Channel moveX{ChannelPart::GlobalTranslation, 0, 0};
const Channel turn{ChannelPart::GlobalOrientation, 0, 0};

NodeAnimation::TrackPtr slope(double last)
{
    Key a, b;
    a.mode = b.mode = KeyMode::Linear;
    b.time = ticksPerSecond;
    b.value = last;
    return std::make_shared<const AnyTrack>(*Track::fromKeys({a, b}));
}

Node nodeOf(NodeId id, NodeId parent, NodeKind kind)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = kind;
    node.name = std::string("n").append(std::to_string(id));
    return node;
}

/// Group 1 with primitive 2, group 3 beside it.
struct Fixture
{
    Fixture()
    {
        document.reset(
            *Scene::fromNodes({nodeOf(1, noNode, NodeKind::Group), nodeOf(2, 1, NodeKind::Primitive),
                               nodeOf(3, noNode, NodeKind::Group)}),
            {});
    }
    Document document;
    const QUndoStack& stack = *document.undoStack();
};

} // namespace

class TestTracks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badEditsAreRefused()
    {
        Fixture f;
        QVERIFY(!edit::setTracks(f.document, {{77, moveX, slope(1.0)}}, QStringLiteral("x")));
        QVERIFY(!edit::setTracks(f.document, {{2, turn, slope(1.0)}}, QStringLiteral("x")));
        const Channel own{ChannelPart::LocalTranslation, 0, 0}; // a group has no geometry
        QVERIFY(!edit::setTracks(f.document, {{2, moveX, slope(1.0)}, {1, own, slope(1.0)}},
                                 QStringLiteral("x")));
        const Channel wind{ChannelPart::Parameter, 0, paramId(*findParam("physics.windStrength"))};
        QVERIFY(!edit::setTracks(f.document, {{2, wind, slope(1.0)}}, QStringLiteral("x")));
        QVERIFY(edit::setNodeLocked(f.document, {1}, true));
        QVERIFY(!edit::setTracks(f.document, {{2, moveX, slope(1.0)}}, QStringLiteral("x")));
        QVERIFY(f.document.scene().find(2)->animation.empty());
        QCOMPARE(f.stack.count(), 1);
    }
    void aDragIsOneStepAndNoneWhereItEndsWhereItBegan()
    {
        Fixture f;
        QVERIFY(edit::setTracks(f.document, {{2, moveX, slope(1.0)}}, QStringLiteral("x")));
        const QByteArray file = writeProject(f.document.project());
        const GestureId drag = newGesture();
        for (const double last : {2.0, 3.0, 4.0})
            QVERIFY(edit::setTracks(f.document, {{2, moveX, slope(last)}}, QStringLiteral("x"), drag));
        QCOMPARE(f.stack.count(), 2);
        QCOMPARE(worldTransformAt(f.document.scene(), 2, 0.5).world[3].x, 2.0);
        f.document.undo();
        QCOMPARE(writeProject(f.document.project()), file);
        f.document.redo();
        QCOMPARE(worldTransformAt(f.document.scene(), 2, 0.5).world[3].x, 2.0);
        const GestureId back = newGesture();
        for (const double last : {9.0, 4.0})
            QVERIFY(edit::setTracks(f.document, {{2, moveX, slope(last)}}, QStringLiteral("x"), back));
        QCOMPARE(f.stack.count(), 2);
        QVERIFY(edit::setTracks(f.document, {{2, moveX, nullptr}}, QStringLiteral("x")));
        QVERIFY(f.document.scene().find(2)->animation.empty());
    }
    void newsNameTheNodes()
    {
        Fixture f;
        std::vector<Change> seen;
        connect(&f.document, &Document::changed, this, [&](const Change& change) { seen.push_back(change); });
        QVERIFY(edit::setTracks(f.document, {{2, moveX, slope(1.0)}, {3, moveX, slope(1.0)}},
                                QStringLiteral("x")));
        QVERIFY(!seen.empty());
        QCOMPARE(seen.front().kinds, quint32{changeTracks});
        QCOMPARE(seen.front().nodes, (std::vector<NodeId>{2, 3}));
    }
    void insertedKeysHaveTheValueOfTheirTime()
    {
        Fixture f;
        QVERIFY(edit::setTracks(f.document, {{2, moveX, slope(1.0)}}, QStringLiteral("x")));
        const Channel radius{ChannelPart::Parameter, 0, paramId(*findParam("primitive.radius"))};
        QVERIFY(edit::insertKeys(f.document, {2, 3}, {moveX, turn, radius}, ticksPerSecond / 2));
        QCOMPARE(f.stack.count(), 2); // one step
        const NodeAnimation& animation = f.document.scene().find(2)->animation;
        const Track& x = std::get<Track>(*animation.find(moveX));
        QCOMPARE(x.size(), std::size_t(3));
        QCOMPARE(x.keys()[1].value, 0.5);
        QVERIFY(x.keys()[1].mode == KeyMode::Linear);
        QCOMPARE(std::get<Track>(*animation.find(radius)).keys()[0].value, 0.5);
        QVERIFY(animation.find(turn));
        QVERIFY(!f.document.scene().find(3)->animation.find(radius));
        const QByteArray file = writeProject(f.document.project());
        QVERIFY(edit::insertKeys(f.document, {2}, {moveX}, ticksPerSecond / 2)); // there is one already
        QCOMPARE(writeProject(f.document.project()), file);
        QCOMPARE(f.stack.count(), 2);
    }
    void reparentingKeepsThePlaceAtTheTime()
    {
        Fixture f;
        QVERIFY(edit::setTracks(f.document,
                                {{1, moveX, slope(4.0)}, {2, moveX, slope(2.0)}, {3, moveX, slope(-6.0)}},
                                QStringLiteral("x")));
        const glm::dmat4 before = worldTransformAt(f.document.scene(), 2, 0.5).world;
        QVERIFY(edit::moveNode(f.document, 2, 3, 0, true, 0.5));
        QVERIFY(glm::length(before[3] - worldTransformAt(f.document.scene(), 2, 0.5).world[3]) < 1e-12);
        QCOMPARE(f.document.scene().find(2)->parent, NodeId(3));
    }
    void badTracksInFilesAreNamed_data()
    {
        QTest::addColumn<QByteArray>("tracks");
        QTest::addColumn<QByteArray>("path");
        const QByteArray x = "\"global.translation.x\": ";
        QTest::newRow("no object") << QByteArray("[]") << QByteArray("nodes[0].tracks");
        QTest::newRow("no track") << QByteArray("{" + x + "3}")
                                  << QByteArray("nodes[0].tracks.global.translation.x");
        QTest::newRow("no keys") << QByteArray("{" + x + "{}}")
                                 << QByteArray("nodes[0].tracks.global.translation.x.keys");
        const auto key = [&](const char* text) {
            return QByteArray("{" + x + "{\"keys\": [" + text + "]}}");
        };
        const QByteArray at = "nodes[0].tracks.global.translation.x.keys[0]";
        QTest::newRow("no time") << key("{\"value\": 1}") << QByteArray(at + ".time");
        QTest::newRow("time") << key("{\"time\": 1e9, \"value\": 1}") << QByteArray(at + ".time");
        QTest::newRow("value") << key("{\"time\": 0, \"value\": \"1\"}") << QByteArray(at + ".value");
        QTest::newRow("mode") << key("{\"time\": 0, \"value\": 1, \"mode\": \"WOBBLE\"}")
                              << QByteArray(at + ".mode");
        QTest::newRow("unknown") << key("{\"time\": 0, \"value\": 1, \"wobble\": 1}")
                                 << QByteArray(at + ".wobble");
        QTest::newRow("order") << key("{\"time\": 1, \"value\": 1}, {\"time\": 1, \"value\": 1}")
                               << QByteArray("nodes[0].tracks.global.translation.x.keys[1].time");
        QTest::newRow("period") << key("{\"time\": 0, \"value\": 1, \"period\": -1}")
                                << QByteArray(at + ".period");
        QTest::newRow("quaternion")
            << QByteArray("{\"global.orientation\": {\"keys\": [{\"time\": 0, \"value\": [0, 0, 0, 0]}]}}")
            << QByteArray("nodes[0].tracks.global.orientation.keys[0].value");
    }
    void badTracksInFilesAreNamed()
    {
        QFETCH(QByteArray, tracks);
        QFETCH(QByteArray, path);
        const auto project =
            readProject("{\"format\": \"ramure\", \"version\": 1, \"nodes\": [{\"id\": 1, \"kind\": "
                        "\"group\", \"name\": \"x\", \"tracks\": " +
                        tracks + "}]}");
        QVERIFY(!project);
        QCOMPARE(QByteArray::fromStdString(project.error().path), path);
    }
    void whatIsUnknownIsKept()
    {
        const QByteArray text =
            "{\"format\": \"ramure\", \"version\": 1, \"nodes\": [{\"id\": 1, \"kind\": \"group\", "
            "\"name\": \"x\", \"tracks\": {\"future.track\": 5, \"global.scale.x\": "
            "{\"keys\": [{\"time\": 0.5, \"value\": 2}], \"colour\": \"red\"}}}]}";
        const auto project = readProject(text);
        QVERIFY2(project, test::why(project));
        const QByteArray out = writeProject(*project);
        QVERIFY(out.contains("future.track") && out.contains("colour"));
        QCOMPARE(writeProject(*readProject(out)), out);
    }
    void demosRoundTrip()
    {
        for (const DemoScene& demo : demoScenes()) {
            const Scene scene = demo.make();
            const auto back = readProject(writeProject({scene, {}}));
            QVERIFY2(back, test::why(back));
            QVERIFY(back->scene == scene);
        }
    }
    void thePlayersFramesSayWhereNodesAre()
    {
        Document document;
        Player player(&document);
        document.reset(*demoScene("MovingCylinder"), {});
        QVERIFY(player.waitForIdle(20'000));
        QVERIFY(!player.motion()->transforms.empty()); // at rest too
        player.seek(30);
        QVERIFY(player.waitForIdle(20'000));
        const auto motion = player.motion();
        QCOMPARE(motion->frame, std::int64_t(30));
        const glm::dmat4 expected = worldTransformAt(document.scene(), 1, 1.25).geometry;
        QVERIFY(motion->geometryOf(document.scene(), 1) == expected);
        // An edit of a key is on show at once, though nothing plays.
        QVERIFY(edit::setTracks(document, {{1, moveX, slope(3.0)}}, QStringLiteral("x")));
        QVERIFY(player.waitForIdle(20'000));
        QCOMPARE(player.motion()->transforms.at(1).world[3].x, 3.0);
        while (document.undoStack()->canUndo())
            document.undo();
        QVERIFY(player.waitForIdle(20'000));
        QVERIFY(player.motion()->geometryOf(document.scene(), 1) == expected);
    }
    void objectsWithTracksOfParametersChange()
    {
        Fixture f;
        Player player(&f.document);
        const Channel radius{ChannelPart::Parameter, 0, paramId(*findParam("primitive.radius"))};
        const Channel red{ChannelPart::Parameter, 0, paramId(*findParam("surface.color"))};
        QVERIFY(edit::setTracks(f.document, {{2, radius, slope(2.0)}, {2, red, slope(1.0)}},
                                QStringLiteral("x")));
        player.seek(24);
        QVERIFY(player.waitForIdle(20'000));
        const ObjectNow& now = player.motion()->objects.at(2);
        QVERIFY(now.mesh);
        QCOMPARE(now.surface.color.x, 1.0);
    }
    void anImportIsOneStepAndAnErrorChangesNothing()
    {
        QTemporaryDir temporary;
        const auto write = [&](const char* name, const QByteArray& bytes) {
            QFile file(temporary.filePath(QLatin1String(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
        };
        write("A.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("A.animation", "0,LINEAR,0,0,0,0,0,0,1,1,1,1\n20,LINEAR,1,0,0,0,0,0,1,1,1,1\n");
        Fixture f;
        const QByteArray before = writeProject(f.document.project());
        ImportTask task(&f.document);
        QSignalSpy finished(&task, &ImportTask::finished);
        task.start(temporary.path());
        QVERIFY(finished.wait(test::patience(20'000)));
        QCOMPARE(f.document.scene().nodes().size(), std::size_t(4));
        QVERIFY(f.document.scene().timeline().lastFrame >= 480);
        QVERIFY(!task.notes().empty());
        QCOMPARE(f.stack.count(), 1);
        f.document.undo();
        QCOMPARE(writeProject(f.document.project()), before);
        write("B.animation", "0,LINEAR\n");
        task.start(temporary.path());
        QVERIFY(finished.wait(test::patience(20'000)));
        QCOMPARE(writeProject(f.document.project()), before);
    }
};

RAMURE_SUITE(TestTracks)

} // namespace tst_tracks

#include "tst_tracks.moc"
