#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "tests/support/suite.h"
#include <limits>

namespace tst_view_bookmarks {

using namespace ramure;

/// Kept views in commands and project files.
class TestViewBookmarks : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void keepingAndForgettingAreUndoable();
    void badViewsChangeNothing();
    void filesKeepViews();
    void badFilesSayWhere_data();
    void badFilesSayWhere();
    void unknownKeysAreKept();
};

static ViewBookmark someView()
{
    return {{1.0, 2.5, -0.1}, 7.25, 0.3, -0.2, 0.8, true};
}

void TestViewBookmarks::keepingAndForgettingAreUndoable()
{
    Document document;
    quint32 kinds = 0;
    QObject::connect(&document, &Document::changed, [&](const Change& change) { kinds |= change.kinds; });
    QVERIFY(edit::setBookmark(document, 2, someView()));
    QVERIFY(document.scene().bookmarks()[2] == someView());
    QCOMPARE(kinds & ~quint32(changeFile), quint32(changeBookmarks));
    QVERIFY(document.isModified());
    QVERIFY(edit::setBookmark(document, 2, someView())); // as it is already
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(edit::setBookmark(document, 2, {}));
    QVERIFY(!document.scene().bookmarks()[2]);
    document.undo();
    QVERIFY(document.scene().bookmarks()[2] == someView());
    document.undo();
    QVERIFY(!document.scene().bookmarks()[2]);
    QVERIFY(!document.isModified());
}

void TestViewBookmarks::badViewsChangeNothing()
{
    Document document;
    ViewBookmark flat = someView();
    flat.distance = 0.0;
    ViewBookmark nowhere = someView();
    nowhere.target.y = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!edit::setBookmark(document, 0, flat));
    QVERIFY(!edit::setBookmark(document, 0, nowhere));
    QVERIFY(!edit::setBookmark(document, viewBookmarkCount, someView()));
    QCOMPARE(document.undoStack()->count(), 0);
}

void TestViewBookmarks::filesKeepViews()
{
    QVERIFY(!writeProject(Project{}).contains("views"));
    Project project;
    ViewBookmarks bookmarks;
    bookmarks[0] = someView();
    bookmarks[8] = ViewBookmark{};
    project.scene.setBookmarks(bookmarks);
    const QByteArray bytes = writeProject(project);
    const auto read = readProject(bytes);
    QVERIFY(read);
    QVERIFY(read->scene == project.scene);
    QVERIFY(read->extras.empty());
    QCOMPARE(writeProject(*read), bytes);
}

static QByteArray fileWith(const QByteArray& views)
{
    return R"({"format": "ramure", "nodes": [], "version": 1, "views": )" + views + "}";
}

void TestViewBookmarks::badFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("views");
    QTest::addColumn<QString>("path");
    const auto row = [](const char* name, const QByteArray& views, const char* path) {
        QTest::newRow(name) << views << QString(path);
    };
    row("no object", "[]", "views");
    row("a view that is none", R"({"4": 1})", "views.4");
    row("no target", R"({"4": {}})", "views.4.target");
    row("a text in the target", R"({"4": {"target": [0, "1", 0]}})", "views.4.target");
    row("no distance", R"({"4": {"target": [0, 1, 0]}})", "views.4.distance");
    row("too near", R"({"1": {"target": [0, 1, 0], "distance": 0, "yaw": 0, "pitch": 0, "fov": 0.7}})",
        "views.1.distance");
    row("upside down", R"({"1": {"target": [0, 1, 0], "distance": 1, "yaw": 0, "pitch": 2, "fov": 0.7}})",
        "views.1.pitch");
}

void TestViewBookmarks::badFilesSayWhere()
{
    QFETCH(QByteArray, views);
    QFETCH(QString, path);
    const auto project = readProject(fileWith(views));
    QVERIFY(!project);
    QCOMPARE(QString::fromStdString(project.error().path), path);
}

void TestViewBookmarks::unknownKeysAreKept()
{
    const auto project = readProject(fileWith(R"({"10": {"distance": 3}})"));
    QVERIFY(project);
    const QByteArray bytes = writeProject(*project);
    QVERIFY(bytes.contains("\"10\""));
    QCOMPARE(readProject(bytes)->extras, project->extras);
}

RAMURE_SUITE(TestViewBookmarks)

} // namespace tst_view_bookmarks

#include "tst_view_bookmarks.moc"
