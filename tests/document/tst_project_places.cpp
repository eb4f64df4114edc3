#include "core/math/random.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/document/project/project_json.h"
#include "core/qt/document/project/project_places.h"
#include "core/qt/session/jobs/unplaced_edits.h"
#include "core/skeleton/bend.h"
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

/// The document's only tree without its steps, as an older file with these values of branches.
QByteArray olderFile(const Document& document, int version, const QJsonObject& branches)
{
    QJsonObject root = QJsonDocument::fromJson(writeProject(document.project())).object();
    root["version"] = version;
    QJsonObject node = root["nodes"].toArray()[0].toObject();
    node.remove("edits");
    node["branches"] = branches;
    root["nodes"] = QJsonArray({node});
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
    void olderBranchesBecomeSteps_data();
    void olderBranchesBecomeSteps();
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
    QVERIFY(edit::setBranchRoll(trees.document(), tree, {trees.skeleton(tree).key[5]}, 0.5));
    QVERIFY(!trees.document().scene().find(tree)->params.edits.front().target.place.way.empty());
    const QByteArray bytes = writeProject(trees.document().project());
    const auto back = readProject(bytes);
    QVERIFY2(back, test::why(back));
    QVERIFY(back->scene == trees.document().scene());
    QCOMPARE(writeProject(*back), bytes);
}

/// Older files have rolls and bends of branches beside the recipe, in files of version 2 by keys alone: the
/// tree stands as it did.
void TestProjectPlaces::olderBranchesBecomeSteps_data()
{
    QTest::addColumn<int>("version");
    for (const int version : {2, 3, 5})
        QTest::addRow("%d", version) << version;
}

void TestProjectPlaces::olderBranchesBecomeSteps()
{
    QFETCH(int, version);
    for (const char* preset : {"TinyTree", "SmallTree", "EnglishOak1995", "ParkTree"}) {
        test::TreeDocument trees;
        NodeParams params = *presetParams(preset);
        params.mesh.leastRadius = params.mesh.forkLength = 0.0; // what such files had
        params.mesh.targetTriangles = 1000;
        params.foliage.leavesCutoff = 0.0;
        const NodeId tree = trees.add(params);
        const TreeResult before = trees.document().result(tree)->tree;
        const Skeleton& grown = before.simplified->skeleton;
        const TreeAxes axes = axesOf(*before.skeleton);
        Random random(std::uint64_t(version), RandomStream::Test);
        std::vector<glm::dvec3> bends(grown.size(), glm::dvec3(0.0));
        std::vector<double> rolls(grown.size(), 0.0);
        QJsonObject branches;
        for (int i = 0; i < 12; ++i) {
            Index branch = random.below(grown.size());
            for (; branch != noIndex;
                 branch = i < 4 ? grown.parent[branch] : noIndex) { // as a chain that was dragged
                bends[branch] = {random.range(-0.5, 0.5), random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
                rolls[branch] = random.range(-3.0, 3.0);
                QJsonObject values{{"roll", rolls[branch]},
                                   {"bend", QJsonArray{bends[branch].x, bends[branch].y, bends[branch].z}}};
                if (version > 2)
                    values["place"] = json::writePlace(placeOf(axes, grown.source[branch], treeMark(axes)));
                branches[json::branchKey(grown.key[branch])] = values;
            }
        }
        const auto old = readProject(olderFile(trees.document(), version, branches));
        QVERIFY2(old, test::why(old));
        const auto after = TreePipeline().evaluate(old->scene.find(tree)->params, Stage::Simplified);
        QVERIFY2(after, test::why(after));
        Skeleton expected = grown;
        bendBranches(expected, bends);
        const Skeleton& now = after->simplified->skeleton;
        QCOMPARE(now.key, expected.key);
        for (Index b = 0; b < now.size(); ++b) {
            const double away =
                std::max(glm::distance(now.p0[b], expected.p0[b]), glm::distance(now.p1[b], expected.p1[b]));
            QVERIFY2(away < 1e-9, qPrintable(QStringLiteral("%1 %2: %3 m").arg(preset).arg(b).arg(away)));
        }
        QCOMPARE(now.a0, expected.a0);
        QCOMPARE(now.rollOfEach(), rolls);
        const auto again = readProject(writeProject(*old));
        QVERIFY(again && again->scene == old->scene);
    }
}

void TestProjectPlaces::olderFilesKeepWhatHasNone()
{
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks());
    const QJsonObject lost{{json::branchKey(42), QJsonObject{{"roll", 0.5}, {"bend", QJsonArray{0, 0, 1}}}}};
    const auto old = readProject(olderFile(trees.document(), 2, lost));
    QVERIFY2(old, test::why(old));
    trees.document().reset(old->scene, {});
    QVERIFY(trees.compute(tree));
    QCOMPARE(unplacedEdits(trees.document()).size(), std::size_t{2});
    // Nor does a tree that cannot be grown keep a file from being opened.
    Node broken = *old->scene.find(tree);
    broken.params.grammar.axiom.assign(1, '[');
    test::TreeDocument other;
    other.document().reset(*Scene::fromNodes({broken}), {});
    const auto still = readProject(olderFile(other.document(), 2, lost));
    QVERIFY2(still, test::why(still));
    QCOMPARE(still->scene.find(tree)->params.edits.size(), std::size_t{2});
}

RAMURE_SUITE(TestProjectPlaces)

} // namespace tst_project_places

#include "tst_project_places.moc"
