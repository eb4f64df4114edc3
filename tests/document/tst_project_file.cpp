#include "core/qt/document/project/project_file.h"
#include "core/qt/document/project/project_json.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/document/random_scene.h"
#include "tests/support/cannot_run.h"
#include "tests/support/failing_disk.h"
#include "tests/support/kind_with.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <unistd.h>

namespace tst_project_file {

using namespace ramure;

static QByteArray inProject(const QByteArray& nodes)
{
    return R"({"format":"ramure","version":5,"nodes":[)" + nodes + "]}";
}
static QByteArray inNode(const QByteArray& members)
{
    return inProject(R"({"id":1,"kind":"tree")" + members + "}");
}
static QByteArray allOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("<cannot be opened>");
}

class TestProjectFile : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badFilesAreRefusedWithTheirPlace_data();
    void badFilesAreRefusedWithTheirPlace();
    void syntaxErrorsHaveLineAndColumn();
    void deepNestingIsAnError();
    void mutatedFilesNeverCrash();
    void truncatedFilesAreRefused();
    void randomBytesAreRefused();

    void smallestFile();
    void everyParameterRoundTrips_data();
    void everyParameterRoundTrips();
    void randomScenesRoundTrip();
    void defaultsAreLeftOut();
    void textsAreArraysOfLines();
    void numbersAreShortest();
    void unknownKeysAreKept();
    void unknownKindsAreKept();
    void parentsMayStandBehind();

    void savesAndLoads();
    void savingFailsWithoutHarm_data();
    void savingFailsWithoutHarm();
    void fullDiskLeavesTheOldFile();
    void missingFilesAreErrors();
    void tooLargeFilesAreRefused();
};

void TestProjectFile::badFilesAreRefusedWithTheirPlace_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("path");
    const int invalid = int(ErrorCode::Invalid), syntax = int(ErrorCode::Syntax);
    const auto row = [](const char* name, const QByteArray& bytes, int code, const char* path = "") {
        QTest::newRow(name) << bytes << code << QByteArray(path);
    };
    row("empty", "", syntax);
    row("no JSON", "tree", syntax);
    row("an array", "[]", invalid);
    row("not UTF-8", "{\"format\":\"\xff\"}", syntax);
    row("no format", R"({"version":1,"nodes":[]})", invalid, "format");
    row("another format", R"({"format":"blender","version":1,"nodes":[]})", invalid, "format");
    row("no version", R"({"format":"ramure","nodes":[]})", invalid, "version");
    row("version 0", R"({"format":"ramure","version":0,"nodes":[]})", invalid, "version");
    row("version 1.5", R"({"format":"ramure","version":1.5,"nodes":[]})", invalid, "version");
    row("newer", R"({"format":"ramure","version":6,"nodes":7})", int(ErrorCode::Version), "version");
    row("no nodes", R"({"format":"ramure","version":1})", invalid, "nodes");
    row("nodes no array", R"({"format":"ramure","version":1,"nodes":{}})", invalid, "nodes");
    row("node no object", inProject("7"), invalid, "nodes[0]");
    row("no id", inProject(R"({"kind":"tree"})"), invalid, "nodes[0].id");
    row("id 0", inProject(R"({"id":0,"kind":"tree"})"), invalid, "nodes[0].id");
    row("id -1", inProject(R"({"id":-1,"kind":"tree"})"), invalid, "nodes[0].id");
    row("id 2^32", inProject(R"({"id":4294967296,"kind":"tree"})"), invalid, "nodes[0].id");
    row("id 1e300", inProject(R"({"id":1e300,"kind":"tree"})"), invalid, "nodes[0].id");
    row("id twice", inProject(R"({"id":1,"kind":"tree"},{"id":1,"kind":"tree"})"), invalid, "nodes[1].id");
    row("no kind", inProject(R"({"id":1})"), invalid, "nodes[0].kind");
    row("unknown parent", inProject(R"({"id":1,"kind":"tree","parent":2})"), invalid, "nodes[0].parent");
    row("own parent", inProject(R"({"id":1,"kind":"tree","parent":1})"), invalid, "nodes[0].parent");
    row("circle", inProject(R"({"id":1,"kind":"tree","parent":2},{"id":2,"kind":"tree","parent":1})"),
        invalid, "nodes[0].parent");
    row("parent null", inProject(R"({"id":1,"kind":"tree","parent":null})"), invalid, "nodes[0].parent");
    row("name", inNode(R"(,"name":1)"), invalid, "nodes[0].name");
    row("preset", inNode(R"(,"preset":1)"), invalid, "nodes[0].preset");
    row("visible", inNode(R"(,"visible":1)"), invalid, "nodes[0].visible");
    row("locked", inNode(R"(,"locked":"yes")"), invalid, "nodes[0].locked");
    row("params", inNode(R"(,"params":[])"), invalid, "nodes[0].params");
    row("range",
        inProject(
            R"({"id":1,"kind":"group"},{"id":2,"kind":"tree","params":{"sections.radialDivisions":2}})"),
        invalid, "nodes[1].params.sections.radialDivisions");
    row("huge", inNode(R"(,"params":{"turtle.alpha":1e308})"), invalid, "nodes[0].params.turtle.alpha");
    row("infinite", inNode(R"(,"params":{"turtle.alpha":1e999})"), syntax);
    row("text for a number", inNode(R"(,"params":{"turtle.alpha":"0.2"})"), invalid,
        "nodes[0].params.turtle.alpha");
    row("no whole number", inNode(R"(,"params":{"grammar.iterations":2.5})"), invalid,
        "nodes[0].params.grammar.iterations");
    row("number for a bool", inNode(R"(,"params":{"grammar.stochastic":1})"), invalid,
        "nodes[0].params.grammar.stochastic");
    row("short vector", inNode(R"(,"params":{"tree.scale":[1,1]})"), invalid, "nodes[0].params.tree.scale");
    row("vector of texts", inNode(R"(,"params":{"tree.scale":[1,1,"1"]})"), invalid,
        "nodes[0].params.tree.scale[2]");
    row("line no text", inNode(R"(,"params":{"grammar.rules":["A -> B",3]})"), invalid,
        "nodes[0].params.grammar.rules[1]");
    row("text null", inNode(R"(,"params":{"grammar.axiom":null})"), invalid, "nodes[0].params.grammar.axiom");
    row("zero byte", inNode(R"(,"params":{"grammar.axiom":"a\u0000b"})"), invalid,
        "nodes[0].params.grammar.axiom");
    row("branches", inNode(R"(,"branches":[])"), invalid, "nodes[0].branches");
    row("branch key", inNode(R"(,"branches":{"12":{}})"), invalid, "nodes[0].branches.12");
    row("branch key capital", inNode(R"(,"branches":{"00000000000000AB":{}})"), invalid,
        "nodes[0].branches.00000000000000AB");
    row("branch", inNode(R"(,"branches":{"0000000000000001":1})"), invalid,
        "nodes[0].branches.0000000000000001");
    for (const char* bend : {"1", "[1,2]", "[1,2,\"x\"]", "{}", "[1,2,3,4]"})
        row("bend",
            inNode((std::string(R"(,"branches":{"0000000000000001":{"bend":)") + bend + "}}").c_str()),
            invalid, "nodes[0].branches.0000000000000001.bend");
    row("roll", inNode(R"(,"branches":{"0000000000000001":{"roll":"x"}})"), invalid,
        "nodes[0].branches.0000000000000001.roll");
}

void TestProjectFile::badFilesAreRefusedWithTheirPlace()
{
    QFETCH(QByteArray, bytes);
    const auto project = readProject(bytes, "a.ramure");
    QVERIFY(!project);
    QTEST(QByteArray::fromStdString(project.error().path), "path");
    QTEST(int(project.error().code), "code");
    QVERIFY(!project.error().plain().empty());
    QCOMPARE(project.error().file, std::string("a.ramure"));
}

void TestProjectFile::syntaxErrorsHaveLineAndColumn()
{
    const auto project = readProject("{\n  \"format\": \"ramure\",\n  \"version\" 1\n}", {});
    QVERIFY(!project);
    QCOMPARE(project.error().line, 3);
    QCOMPARE(project.error().column, 13);
    const auto first = readProject("?", {});
    QCOMPARE(first.error().line, 1);
    QCOMPARE(first.error().column, 1);
}

void TestProjectFile::deepNestingIsAnError()
{
    const QByteArray deep = inNode(",\"x\":" + QByteArray(100000, '[') + QByteArray(100000, ']'));
    QCOMPARE(readProject(deep).error().code, ErrorCode::Syntax);
    // A deep scene is no deep file.
    std::vector<Node> chain(20000);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        chain[i].id = static_cast<NodeId>(i + 1);
        chain[i].parent = static_cast<NodeId>(i);
    }
    Project project{*Scene::fromNodes(chain), {}};
    const auto back = readProject(writeProject(project));
    QVERIFY2(back, test::why(back));
    QVERIFY(back->scene == project.scene);
}

void TestProjectFile::mutatedFilesNeverCrash()
{
    Random random(3, RandomStream::Test);
    int accepted = 0;
    for (int i = 0; i < 2000; ++i) {
        QByteArray bytes = writeProject({test::randomScene(random, 4), R"({"more":{"a":1}})"});
        for (std::uint32_t edits = 1 + random.below(4); edits-- > 0 && !bytes.isEmpty();) {
            const auto at = static_cast<qsizetype>(random.below(static_cast<std::uint32_t>(bytes.size())));
            const char byte = "0123456789-.eE[]{}\",:\\ \xff"[random.below(24)];
            switch (random.below(4)) {
            case 0:
                bytes[at] = byte;
                break;
            case 1:
                bytes.insert(at, byte);
                break;
            case 2:
                bytes.remove(at, 1 + random.below(8));
                break;
            default:
                bytes.insert(at, bytes.mid(at, 1 + random.below(40)));
                break;
            }
        }
        const auto project = readProject(bytes);
        if (!project) {
            QVERIFY(!project.error().plain().empty());
            continue;
        }
        ++accepted;
        for (const Node& node : project->scene.nodes())
            QVERIFY(checkParams(node.params));
        // What was accepted is understood: writing and reading it again changes nothing more.
        const QByteArray written = writeProject(*project);
        const auto again = readProject(written);
        QVERIFY2(again, test::why(again));
        QCOMPARE(writeProject(*again), written);
    }
    QVERIFY(accepted > 0 && accepted < 2000);
}

void TestProjectFile::truncatedFilesAreRefused()
{
    Random random(4, RandomStream::Test);
    const QByteArray bytes = writeProject({test::randomScene(random, 6), {}}).trimmed();
    for (qsizetype length = 0; length < bytes.size(); ++length)
        QVERIFY(!readProject(bytes.first(length)));
}

void TestProjectFile::randomBytesAreRefused()
{
    Random random(5, RandomStream::Test);
    for (int i = 0; i < 500; ++i) {
        QByteArray bytes(static_cast<qsizetype>(random.below(300)), '\0');
        for (char& c : bytes)
            c = static_cast<char>(random.below(256));
        QVERIFY(!readProject(bytes));
    }
}

void TestProjectFile::smallestFile()
{
    const auto project = readProject(R"({"format":"ramure","version":1,"nodes":[]})");
    QVERIFY2(project, test::why(project));
    QVERIFY(project->scene.empty());
    QVERIFY(project->extras.empty());
    const auto plain = readProject(inNode(""));
    QVERIFY2(plain, test::why(plain));
    QCOMPARE(plain->scene.nodes().size(), std::size_t{1});
    QVERIFY(plain->scene.nodes().front().params == NodeParams{});
}

void TestProjectFile::everyParameterRoundTrips_data()
{
    QTest::addColumn<int>("row");
    for (const ParamDef& def : paramTable())
        QTest::newRow(def.key) << int(paramId(def));
}

void TestProjectFile::everyParameterRoundTrips()
{
    QFETCH(int, row);
    const ParamDef& def = paramTable()[static_cast<std::size_t>(row)];
    Random random(6, RandomStream::Test);
    for (int i = 0; i < 50; ++i) {
        Node node;
        node.id = 1;
        node.kind = test::kindWith(def);
        const ParamValue value = test::randomValue(def, random);
        QVERIFY(setParam(node.params, def, value));
        Project project{*Scene::fromNodes({node}), {}};
        const QByteArray bytes = writeProject(project);
        QCOMPARE(bytes.contains(def.key), value != defaultValue(def));
        const auto back = readProject(bytes);
        QVERIFY2(back, test::why(back));
        QVERIFY(def.get(back->scene.nodes().front().params) == value);
        QVERIFY(back->scene == project.scene);
    }
}

void TestProjectFile::randomScenesRoundTrip()
{
    Random random(7, RandomStream::Test);
    for (int i = 0; i < 300; ++i) {
        Project project{test::randomScene(random), {}};
        const QByteArray bytes = writeProject(project);
        const auto back = readProject(bytes);
        QVERIFY2(back, test::why(back));
        QVERIFY(back->scene == project.scene);
        QCOMPARE(writeProject(*back), bytes);
    }
}

void TestProjectFile::defaultsAreLeftOut()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "Oak";
    node.params.tree.translation = {-0.0, 0.0, -0.0};
    QCOMPARE(writeProject({*Scene::fromNodes({node}), {}}), QByteArray(R"({
    "format": "ramure",
    "nodes": [
        {
            "id": 1,
            "kind": "tree",
            "name": "Oak"
        }
    ],
    "version": 5
}
)"));
}

void TestProjectFile::textsAreArraysOfLines()
{
    const auto project =
        readProject(inNode(R"(,"params":{"grammar.rules":["A -> B","","B -> C"],"grammar.axiom":"A"})"));
    QVERIFY2(project, test::why(project));
    QCOMPARE(project->scene.nodes().front().params.grammar.rules, std::string("A -> B\n\nB -> C"));
    const QByteArray bytes = writeProject(*project);
    QVERIFY(bytes.contains("\"A -> B\",\n"));
    QVERIFY(bytes.contains("\"grammar.axiom\": \"A\""));
}

void TestProjectFile::numbersAreShortest()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params.turtle.alpha = 0.3;
    node.params.turtle.decay = 0.1 + 0.2;
    node.params.tree.scale = {-0.0 + 2.0, 2.5, 1.0};
    const QByteArray bytes = writeProject({*Scene::fromNodes({node}), {}});
    QVERIFY(bytes.contains("\"turtle.alpha\": 0.3,"));
    QVERIFY(bytes.contains("\"turtle.decay\": 0.30000000000000004"));
}

void TestProjectFile::unknownKeysAreKept()
{
    const QByteArray bytes = R"({
    "camera": {
        "eye": [
            1,
            2.5,
            9007199254740993
        ]
    },
    "format": "ramure",
    "nodes": [
        {
            "branches": {
                "00000000000000ab": {
                    "pruned": true,
                    "roll": 0.5
                }
            },
            "id": 1,
            "kind": "group",
            "name": "",
            "params": {
                "grammar.axiom": "kept, since groups have none",
                "physics.wind": 0.1,
                "tree.scale": [
                    2,
                    2,
                    2
                ]
            },
            "weather": null
        }
    ],
    "version": 5
}
)";
    const auto project = readProject(bytes);
    QVERIFY2(project, test::why(project));
    QCOMPARE(writeProject(*project), bytes);
    // They follow the node, also when its known values go.
    Project changed = *project;
    changed.scene.find(1)->params = NodeParams{};
    const QByteArray without = writeProject(changed);
    QVERIFY(without.contains("\"pruned\": true"));
    QVERIFY(without.contains("physics.wind") && !without.contains("tree.scale"));
}

void TestProjectFile::unknownKindsAreKept()
{
    const QByteArray odd = inProject(
        R"({"id":1,"kind":"cloud","locked":true,"name":"Sky","branches":[7],"drops":[1,{"size":0.1}],)"
        R"("edits":"none","mesh":4,"params":{"cloud.cover":0.25,"tree.translation":[1,2,3]},)"
        R"("tracks":{"cloud.cover":{"keys":[]}}},{"id":2,"kind":"group","name":"below","parent":1})");
    auto read = readProject(odd);
    QVERIFY2(read, test::why(read));
    const Node& cloud = read->scene.nodes().front();
    QCOMPARE(cloud.kind, NodeKind::Unknown);
    QCOMPARE(glm::dvec3(worldMatrix(read->scene, 2)[3]), glm::dvec3(1, 2, 3));
    QVERIFY(!isShape(cloud.kind) && !isObject(cloud.kind));
    const QByteArray bytes = QJsonDocument::fromJson(odd).toJson(QJsonDocument::Indented);
    QCOMPARE(writeProject(*read), bytes);
    read->scene.find(1)->params.tree.translation.x = 9.0;
    QByteArray wanted = bytes;
    wanted.replace(QByteArray("                    1,\n                    2,"),
                   QByteArray("                    9,\n                    2,"));
    QVERIFY(wanted != bytes);
    QCOMPARE(writeProject(*read), wanted);
}

void TestProjectFile::parentsMayStandBehind()
{
    const auto project =
        readProject(inProject(R"({"id":3,"kind":"tree","parent":1},{"id":1,"kind":"group"})"));
    QVERIFY2(project, test::why(project));
    QCOMPARE(project->scene.nodes().front().id, 1u);
}

void TestProjectFile::savesAndLoads()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("é 树.ramure");
    Random random(8, RandomStream::Test);
    Project project{test::randomScene(random), {}};
    for (int i = 0; i < 3; ++i) {
        QVERIFY2(saveProjectFile(project, path), "saving");
        const auto back = loadProjectFile(path);
        QVERIFY2(back, test::why(back));
        QVERIFY(back->scene == project.scene);
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

void TestProjectFile::savingFailsWithoutHarm_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("missing folder") << "none/a.ramure";
    QTest::newRow("a folder") << "folder";
    QTest::newRow("a device") << "device.ramure";
    QTest::newRow("below a file") << "old.ramure/a.ramure";
    QTest::newRow("no name") << "";
    QTest::newRow("too long a name") << QString(300, u'x') + ".ramure";
}

void TestProjectFile::savingFailsWithoutHarm()
{
    QFETCH(QString, name);
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("folder"));
    QVERIFY(QFile::link("/dev/null", folder.filePath("device.ramure")));
    QVERIFY(saveProjectFile({}, folder.filePath("old.ramure")));
    const QByteArray before = allOf(folder.filePath("old.ramure"));
    const QString path = name.isEmpty() ? QString() : folder.filePath(name);
    const auto saved = saveProjectFile({}, path);
    QVERIFY(!saved);
    QCOMPARE(saved.error().code, ErrorCode::Io);
    QCOMPARE(saved.error().file, path.toStdString());
    QVERIFY(!saved.error().args.front().empty());
    QCOMPARE(allOf(folder.filePath("old.ramure")), before);
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 3);
    QVERIFY(QFileInfo(folder.filePath("device.ramure")).isSymLink());
}

void TestProjectFile::fullDiskLeavesTheOldFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("old.ramure");
    QVERIFY(saveProjectFile({}, path));
    const QByteArray before = allOf(path);
    Random random(9, RandomStream::Test);
    for (const rlim_t size : {rlim_t{0}, rlim_t{100}, rlim_t{20000}}) {
        Project big{test::randomScene(random), {}};
        while (writeProject(big).size() < 40000) {
            const NodeId id = big.scene.newId();
            QVERIFY(big.scene.insert({test::randomNode(id, noNode, random)}, noNode, 0));
        }
        Expected<void> saved;
        {
            const test::SmallDisk disk(size);
            saved = saveProjectFile(big, path);
        }
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::Io);
        QCOMPARE(saved.error().message(), path.toStdString() + ": cannot be written: File too large");
        QCOMPARE(allOf(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }
    if (geteuid() != 0) { // the administrator may write anywhere
        QVERIFY(QFile::setPermissions(folder.path(), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
        QVERIFY(!saveProjectFile({}, path));
        QVERIFY(QFile::setPermissions(folder.path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner |
                                                         QFileDevice::ExeOwner));
        QCOMPARE(allOf(path), before);
    }
}

void TestProjectFile::missingFilesAreErrors()
{
    QTemporaryDir folder;
    for (const QString& path : {folder.filePath("none.ramure"), folder.path(), QString()}) {
        const auto project = loadProjectFile(path);
        QVERIFY(!project);
        QCOMPARE(project.error().code, ErrorCode::Io);
        QCOMPARE(project.error().file, path.toStdString());
    }
}

void TestProjectFile::tooLargeFilesAreRefused()
{
    QTemporaryDir folder;
    QFile file(folder.filePath("large.ramure"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    if (!file.resize(projectSizeLimit + 1)) // sparse: takes no space
        RAMURE_CANNOT_RUN("no sparse files here");
    file.close();
    const auto project = loadProjectFile(file.fileName());
    QVERIFY(!project);
    QCOMPARE(project.error().code, ErrorCode::Limit);
}

RAMURE_SUITE(TestProjectFile)

} // namespace tst_project_file

#include "tst_project_file.moc"
