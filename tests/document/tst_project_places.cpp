#include "core/qt/document/project/project_file.h"
#include "core/qt/session/jobs/unplaced_edits.h"
#include "core/skeleton/edit_places.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace tst_project_places {

using namespace ramure;

namespace {

/// One tree whose only edit has \p place.
QByteArray withPlace(const QByteArray& place)
{
    return R"({"format":"ramure","version":3,"nodes":[{"id":1,"kind":"tree","branches":)"
           R"({"0000000000000005":{"roll":0.5,"place":)" +
           place + "}}}]}";
}
QByteArray withAxis(const QByteArray& axis)
{
    return withPlace(R"({"tree":"00c0ffee00c0ffee","fork":0,"piece":0,"share":0.5,"way":[)" + axis + "]}");
}
const QByteArray goodAxis =
    R"({"id":"00c0ffee00c0ffee","fork":0,"mate":0,"forks":1,"mates":1,"s":0,"share":0,"downAngle":0,)"
    R"("azimuth":0,"length":1,"radius":0.1})";

/// What the document holds, as a file of version 2: branches are known by their keys alone.
QByteArray olderFile(const Document& document)
{
    QJsonObject root = QJsonDocument::fromJson(writeProject(document.project())).object();
    root["version"] = 2;
    QJsonArray nodes = root["nodes"].toArray();
    for (auto&& node : nodes) {
        QJsonObject object = node.toObject();
        QJsonObject branches = object["branches"].toObject();
        for (auto&& branch : branches) {
            QJsonObject values = branch.toObject();
            values.remove("place");
            branch = values;
        }
        object["branches"] = branches;
        node = object;
    }
    root["nodes"] = nodes;
    return QJsonDocument(root).toJson();
}

} // namespace

/// Where edits were made, in project files.
class TestProjectPlaces : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void brokenPlaces_data();
    void brokenPlaces();
    void thereAndBack();
    void olderFilesFindThePlaces();
    void olderFilesKeepWhatHasNone();
};

void TestProjectPlaces::brokenPlaces_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("path");
    const QByteArray place = "nodes[0].branches.0000000000000005.place";
    const auto axisWithout = [](const char* key) {
        QJsonObject axis = QJsonDocument::fromJson(goodAxis).object();
        axis.remove(QLatin1String(key));
        return withAxis(QJsonDocument(axis).toJson());
    };
    QTest::newRow("a number") << withPlace("7") << place;
    QTest::newRow("null") << withPlace("null") << place;
    QTest::newRow("empty") << withPlace("{}") << place + ".tree";
    QTest::newRow("no way") << withPlace(R"({"tree":"00c0ffee00c0ffee","fork":0,"piece":0,"share":0.5})")
                            << place + ".way";
    QTest::newRow("way of numbers") << withAxis("7") << place + ".way[0].id";
    QTest::newRow("negative rank")
        << withPlace(R"({"tree":"00c0ffee00c0ffee","fork":-1,"piece":0,"share":0.5,"way":[]})")
        << place + ".fork";
    QTest::newRow("second axis") << withAxis(goodAxis + ",{}") << place + ".way[1].id";
    for (const char* key : {"fork", "mates", "s", "azimuth", "radius"})
        QTest::newRow(key) << axisWithout(key) << place + ".way[0]." + key;
}

void TestProjectPlaces::brokenPlaces()
{
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, path);
    const auto project = readProject(file);
    QVERIFY(!project);
    QCOMPARE(project.error().code, ErrorCode::Invalid);
    QCOMPARE(QByteArray::fromStdString(project.error().path), path);
}

void TestProjectPlaces::thereAndBack()
{
    QVERIFY(readProject(withAxis(goodAxis)));
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks());
    const std::uint64_t name = trees.skeleton(tree).name(5);
    QVERIFY(edit::setBranchRoll(trees.document(), tree, {name}, 0.5));
    QVERIFY(!trees.document().scene().find(tree)->params.branches.at(name).place.way.empty());
    const QByteArray bytes = writeProject(trees.document().project());
    const auto back = readProject(bytes);
    QVERIFY2(back, test::why(back));
    QVERIFY(back->scene == trees.document().scene());
    QCOMPARE(writeProject(*back), bytes);
}

void TestProjectPlaces::olderFilesFindThePlaces()
{
    test::TreeDocument trees;
    NodeParams forks = test::smallForks();
    forks.mesh.leastRadius = forks.mesh.forkLength = 0.0; // what such files had
    const NodeId tree = trees.add(forks);
    for (const Index branch : {2u, 5u, 12u})
        QVERIFY(
            edit::setBranchRoll(trees.document(), tree, {trees.skeleton(tree).name(branch)}, 0.1 * branch));
    const auto old = readProject(olderFile(trees.document()));
    QVERIFY2(old, test::why(old));
    QVERIFY(old->scene == trees.document().scene());
}

void TestProjectPlaces::olderFilesKeepWhatHasNone()
{
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks());
    QVERIFY(edit::setBranchRoll(trees.document(), tree, {42}, 0.5)); // no such branch
    QCOMPARE(unplacedEdits(trees.document()), (std::vector<UnplacedEdit>{{tree, 42, false}}));
    auto old = readProject(olderFile(trees.document()));
    QVERIFY2(old, test::why(old));
    QVERIFY(old->scene.find(tree)->params.branches.at(42).place.way.empty());
    // Nor does a tree that cannot be grown keep a file from being opened.
    Node broken = *old->scene.find(tree);
    broken.params.grammar.axiom.assign(1, '[');
    test::TreeDocument other;
    other.document().reset(*Scene::fromNodes({broken}), {});
    const auto still = readProject(olderFile(other.document()));
    QVERIFY2(still, test::why(still));
    QCOMPARE(still->scene.find(tree)->params.branches.size(), std::size_t{1});
}

RAMURE_SUITE(TestProjectPlaces)

} // namespace tst_project_places

#include "tst_project_places.moc"
