#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "tests/support/suite.h"

namespace tst_timeline {

using namespace ramure;

/// The timeline's settings in commands and project files.
class TestTimeline : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void badFilesSayWhere_data();
    void badFilesSayWhere();
    void badSettingsChangeNothing();
    void settingsAreUndoable();
    void aGestureIsOneStep();
    void filesKeepSettings();
    void defaultsAreLeftOut();
    void unknownKeysAreKept();
};

static QByteArray fileWith(const QByteArray& timeline)
{
    return R"({"format": "ramure", "nodes": [], "version": 1, "timeline": )" + timeline + "}";
}

void TestTimeline::badFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("timeline");
    QTest::addColumn<QString>("path");
    const auto row = [](const char* name, const QByteArray& timeline, const char* path) {
        QTest::newRow(name) << timeline << QString(path);
    };
    row("no object", "[1, 2]", "timeline");
    row("a text as rate", R"({"framesPerSecond": "24"})", "timeline.framesPerSecond");
    row("no frames", R"({"framesPerSecond": 0})", "timeline.framesPerSecond");
    row("half a frame", R"({"firstFrame": 0.5})", "timeline.firstFrame");
    row("a text as frame", R"({"lastFrame": "9"})", "timeline.lastFrame");
    row("backwards", R"({"firstFrame": 9, "lastFrame": 8})", "timeline.lastFrame");
    row("far", R"({"lastFrame": 1000001})", "timeline.lastFrame");
    row("an unknown loop", R"({"loop": "twice"})", "timeline.loop");
    row("a text as seamless", R"({"seamless": "yes"})", "timeline.seamless");
    row("a number as loop", R"({"loop": 1})", "timeline.loop");
}

void TestTimeline::badFilesSayWhere()
{
    QFETCH(QByteArray, timeline);
    QFETCH(QString, path);
    const auto project = readProject(fileWith(timeline));
    QVERIFY(!project);
    QCOMPARE(QString::fromStdString(project.error().path), path);
}

void TestTimeline::badSettingsChangeNothing()
{
    Document document;
    QVERIFY(!edit::setTimeline(document, {0.0, 0, 10, PlayLoop::Loop}));
    QVERIFY(!edit::setTimeline(document, {24.0, 10, 0, PlayLoop::Loop}));
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(edit::setTimeline(document, document.scene().timeline()));
    QCOMPARE(document.undoStack()->count(), 0);
}

void TestTimeline::settingsAreUndoable()
{
    Document document;
    const TimelineSettings before = document.scene().timeline(), after{30.0, 5, 90, PlayLoop::PingPong};
    quint32 kinds = 0;
    QObject::connect(&document, &Document::changed, [&](const Change& change) { kinds |= change.kinds; });
    QVERIFY(edit::setTimeline(document, after));
    QVERIFY(document.scene().timeline() == after);
    QCOMPARE(kinds & ~quint32(changeFile), quint32(changeTimeline));
    QVERIFY(document.isModified());
    document.undo();
    QVERIFY(document.scene().timeline() == before);
    QVERIFY(!document.isModified());
    document.redo();
    QVERIFY(document.scene().timeline() == after);
}

void TestTimeline::aGestureIsOneStep()
{
    Document document;
    const GestureId gesture = newGesture();
    for (const int last : {100, 120, 140})
        QVERIFY(edit::setTimeline(document, {24.0, 0, last, PlayLoop::Loop}, gesture));
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(edit::setTimeline(document, TimelineSettings{}, gesture)); // back where it began
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!document.isModified());
}

void TestTimeline::filesKeepSettings()
{
    Project project;
    project.scene.setTimeline({29.97, -10, 1000000, PlayLoop::Once, true});
    const QByteArray bytes = writeProject(project);
    const auto read = readProject(bytes);
    QVERIFY(read);
    QVERIFY(read->scene == project.scene);
    QCOMPARE(writeProject(*read), bytes);
}

void TestTimeline::defaultsAreLeftOut()
{
    QVERIFY(!writeProject(Project{}).contains("timeline"));
    Project project;
    project.scene.setTimeline({24.0, 0, 99, PlayLoop::Loop});
    const QByteArray bytes = writeProject(project);
    QVERIFY(bytes.contains("lastFrame"));
    QVERIFY(!bytes.contains("framesPerSecond") && !bytes.contains("loop") && !bytes.contains("seamless"));
}

void TestTimeline::unknownKeysAreKept()
{
    const auto project = readProject(fileWith(R"({"lastFrame": 12, "markers": [1, 2]})"));
    QVERIFY(project);
    QCOMPARE(project->scene.timeline().lastFrame, std::int64_t(12));
    const QByteArray bytes = writeProject(*project);
    QVERIFY(bytes.contains("markers"));
    QCOMPARE(readProject(bytes)->extras, project->extras);
}

RAMURE_SUITE(TestTimeline)

} // namespace tst_timeline

#include "tst_timeline.moc"
