#include "core/qt/document/commands.h"
#include "core/qt/document/edit_script.h"
#include "core/qt/document/project/project_edits.h"
#include "core/scene/preset_scene.h"
#include "tests/document/commands_fixture.h"
#include "tests/support/shaped_tree.h"

#include <QJsonDocument>

namespace tst_commands_edits {

using namespace ramure;
using namespace ramure::test;

namespace {

const std::vector<TreeEdit>& editsOf(const Document& document, NodeId id = 2)
{
    return document.scene().find(id)->params.edits;
}

Document& withPlainTree(Document& document)
{
    Node node = makeNode(2);
    node.params = plainTree();
    document.reset(*Scene::fromNodes({node}), {});
    return document;
}

QByteArray hex(std::uint64_t address)
{
    return QByteArray::number(qulonglong(address), 16).rightJustified(16, '0');
}

} // namespace

/// The list of a tree's edits under commands, in files and from scripts.
class TestEditCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void whatIsRefused();
    void putChangesAndMerges();
    void removesAndSwitches();
    void renamesAndReorders();
    void copiesToOtherTrees();
    void filesKeepAll();
    void badFiles_data();
    void badFiles();
    void badScripts_data();
    void badScripts();
    void scriptsAreAsByHand();
    void scriptsOfEverySystem();
    void randomEditsUndoAndRedo();
};

void TestEditCommands::whatIsRefused()
{
    Fixture f;
    const TreeEdit cut = editOf(EditOperation::Cut, 5);
    QVERIFY(!edit::putTreeEdits(f.document, 99, {cut}));
    QVERIFY(!edit::putTreeEdits(f.document, 1, {cut}));
    TreeEdit wrong = cut;
    wrong.at = 2.0;
    const auto put = edit::putTreeEdits(f.document, 2, {cut, wrong});
    QVERIFY(!put);
    QCOMPARE(put.error().path, std::string("edits[1].at"));
    QVERIFY(!edit::removeTreeEdits(f.document, 2, {7}));
    QVERIFY(!edit::setTreeEditsEnabled(f.document, 2, {7}, false));
    QVERIFY(!edit::renameTreeEdit(f.document, 2, 7, "x"));
    QVERIFY(!edit::moveTreeEdit(f.document, 2, 7, 0));
    QVERIFY(!edit::copyTreeEdits(f.document, 2, {7}, {3}));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(edit::setNodeLocked(f.document, {2}, true));
    QVERIFY(!edit::putTreeEdits(f.document, 2, {cut}));
    QCOMPARE(f.stack.count(), 1);
}

void TestEditCommands::putChangesAndMerges()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    const GestureId drag = newGesture();
    TreeEdit cut = editOf(EditOperation::Cut, 5);
    const auto ids = edit::putTreeEdits(f.document, 2, {cut, editOf(EditOperation::Remove, 6)}, drag);
    QVERIFY(ids && ids->size() == 2 && (*ids)[0] != 0 && (*ids)[0] != (*ids)[1]);
    const Change news = f.recorder.takeEdit();
    QCOMPARE(news.kinds, quint32{changeBranches});
    QCOMPARE(news.firstStale, Stage::Skeleton);
    QCOMPARE(f.document.shapeRevision(2), news.revision);
    cut.id = ids->front();
    for (const double at : {0.6, 0.7, 0.8}) {
        cut.at = at;
        QVERIFY(edit::putTreeEdits(f.document, 2, {cut}, drag));
    }
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(editsOf(f.document).size(), std::size_t{2});
    QCOMPARE(editsOf(f.document).front().at, 0.8);
    f.document.undo();
    QCOMPARE(fileOf(f.document), file);
    f.document.redo();
    QCOMPARE(editsOf(f.document).front().at, 0.8);
    QVERIFY(edit::putTreeEdits(f.document, 2, {cut})); // changes nothing
    QCOMPARE(f.stack.count(), 1);
    // A gesture over several edits, some of which it makes, is one step back.
    const QByteArray two = fileOf(f.document);
    const GestureId several = newGesture();
    cut.at = 0.2;
    const auto made = edit::putTreeEdits(f.document, 2, {cut, editOf(EditOperation::Leaves, 9)}, several);
    TreeEdit leaves = editOf(EditOperation::Leaves, 9);
    leaves.id = (*made)[1];
    leaves.shown = false;
    QVERIFY(edit::putTreeEdits(f.document, 2, {leaves, editOf(EditOperation::Keep, 9)}, several));
    QVERIFY(edit::removeTreeEdits(f.document, 2, {(*ids)[1]}, several));
    QCOMPARE(f.stack.count(), 2);
    QCOMPARE(editsOf(f.document).size(), std::size_t{3});
    const QByteArray three = fileOf(f.document);
    f.document.undo();
    QCOMPARE(fileOf(f.document), two);
    f.document.redo();
    QCOMPARE(fileOf(f.document), three);
    f.document.undo();
    // A gesture that ends where it began is no step.
    const GestureId back = newGesture();
    cut.at = 0.1;
    QVERIFY(edit::putTreeEdits(f.document, 2, {cut}, back));
    cut.at = 0.8;
    QVERIFY(edit::putTreeEdits(f.document, 2, {cut}, back));
    QCOMPARE(f.stack.index(), 1);
}

void TestEditCommands::removesAndSwitches()
{
    Fixture f;
    const auto ids =
        *edit::putTreeEdits(f.document, 2, {editOf(EditOperation::Cut, 5), editOf(EditOperation::Remove, 6)});
    QVERIFY(edit::setTreeEditsEnabled(f.document, 2, ids, false));
    QVERIFY(!editsOf(f.document)[0].enabled && !editsOf(f.document)[1].enabled);
    f.document.undo();
    QVERIFY(editsOf(f.document)[0].enabled);
    QVERIFY(edit::removeTreeEdits(f.document, 2, {ids[0]}));
    QCOMPARE(editsOf(f.document).size(), std::size_t{1});
    QCOMPARE(editsOf(f.document).front().id, ids[1]);
    f.document.undo();
    QCOMPARE(editsOf(f.document).front().id, ids[0]);
}

void TestEditCommands::renamesAndReorders()
{
    Fixture f;
    const auto ids = *edit::putTreeEdits(
        f.document, 2,
        {editOf(EditOperation::Cut, 5), editOf(EditOperation::Remove, 6), editOf(EditOperation::Leaves, 7)});
    f.recorder.changes.clear();
    QVERIFY(edit::renameTreeEdit(f.document, 2, ids[1], QString::fromUtf8("mort à gauche")));
    QCOMPARE(f.recorder.takeEdit().firstStale, Stage::Placement);
    QCOMPARE(editsOf(f.document)[1].name, std::string("mort à gauche"));
    QVERIFY(edit::moveTreeEdit(f.document, 2, ids[0], 2));
    QCOMPARE(editsOf(f.document)[2].id, ids[0]);
    QVERIFY(edit::moveTreeEdit(f.document, 2, ids[0], 99));
    QCOMPARE(f.stack.count(), 3); // it is the last already
    QVERIFY(edit::moveTreeEdit(f.document, 2, ids[2], 0));
    QCOMPARE(editsOf(f.document)[0].id, ids[2]);
}

void TestEditCommands::copiesToOtherTrees()
{
    Fixture f;
    const auto ids =
        *edit::putTreeEdits(f.document, 2, {editOf(EditOperation::Cut, 5), editOf(EditOperation::Remove, 6)});
    QVERIFY(edit::copyTreeEdits(f.document, 2, {ids[1]}, {3, 4, 3}));
    QCOMPARE(f.stack.count(), 2);
    QCOMPARE(editsOf(f.document, 3).size(), std::size_t{1});
    QVERIFY(editsOf(f.document, 4) == editsOf(f.document, 3));
    QCOMPARE(editsOf(f.document, 3).front().id, ids[1]);
    QVERIFY(edit::copyTreeEdits(f.document, 2, ids, {3}));
    QCOMPARE(editsOf(f.document, 3).size(), std::size_t{2});
    f.document.undo();
    f.document.undo();
    QVERIFY(editsOf(f.document, 3).empty() && editsOf(f.document, 4).empty());
}

void TestEditCommands::filesKeepAll()
{
    Document document;
    withPlainTree(document);
    Random random(11, RandomStream::Test);
    NodeParams params = plainTree();
    EditContext context(*grownTree(params, Stage::Skeleton).grown, {});
    for (int i = 0; i < 200; ++i) {
        if (i % 20 == 0)
            context = EditContext(*grownTree(plainTree(), Stage::Skeleton).grown, {});
        const Skeleton now = context.skeleton();
        TreeEdit edit = randomEdit(axesOf(now), now, random);
        edit.name = i % 3 == 0 ? "a name" : "";
        edit.enabled = i % 5 != 0;
        if (auto ready = context.prepared(std::move(edit), true)) {
            ready->id = newEditId(params.edits, *ready);
            params.edits.push_back(*ready);
        }
    }
    TreeEdit graft = editOf(EditOperation::Graft, axesOf(context.skeleton()).axes.front().address);
    graft.limb = context.limb(graft.target.address);
    graft.limb.front().sawn = graft.limb.front().bare = true;
    graft.limb.front().organs = {{EditOrgan::Fruit, 0.25, -2.0, {0.1, 0.2, 0.3}, {0, 1, 0}, {1, 0, 0}}};
    params.edits.push_back(*context.prepared(graft, true));
    params.edits.back().id = newEditId(params.edits, graft);
    QVERIFY(params.edits.size() > 150);
    const auto ids = edit::putTreeEdits(document, 2, params.edits);
    QVERIFY2(ids, why(ids).constData());
    const QByteArray file = fileOf(document);
    const auto read = readProject(file);
    QVERIFY2(read, why(read).constData());
    QCOMPARE(writeProject(*read), file);
    // Values that an operation has not are not kept: what is read is what acts.
    const std::vector<TreeEdit>& edits = read->scene.find(2)->params.edits;
    QCOMPARE(edits.size(), params.edits.size());
    QVERIFY(edits.back().limb == graft.limb);
    params.edits = edits;
    NodeParams same = plainTree();
    same.edits = editsOf(document);
    QVERIFY(*grownTree(params, Stage::Skeleton).skeleton == *grownTree(same, Stage::Skeleton).skeleton);
}

void TestEditCommands::badFiles_data()
{
    QTest::addColumn<QByteArray>("edits");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](const char* edits, const char* path) {
        QTest::newRow(edits) << QByteArray(edits) << QByteArray("nodes[0].edits") + path;
    };
    row("7", "");
    row("[7]", "[0]");
    row(R"([{"op": "remove"}])", "[0].id");
    row(R"([{"id": "0000000000000001", "op": "graft", "limb": [[-1, 0, 0, 0, 0, 0, 1, 0, 0.1, 0.1, 7]]}])",
        "[0].limb[0]");
    row(R"([{"id": "0000000000000001", "op": "graft", "limb": [[-1, 0, 0, 0, 0, 0, 1, 0, 0.1, 0.1, 0, 1]]}])",
        "[0].limb[0]");
    row(R"([{"id": "0000000000000001", "op": "remove"}])", "[0].target");
    row(R"([{"id": "0000000000000001", "op": "remove", "target": "x"}])", "[0].target");
    row(R"([{"id": "0000000000000001", "op": "remove", "target": {"id": "x"}}])", "[0].target.id");
    row(R"([{"id": "0000000000000001", "op": "cut", "target": {"id": "0000000000000002"}, "at": "x"}])",
        "[0].at");
    row(R"([{"id": "0000000000000001", "op": "cut", "target": {"id": "0000000000000002"}, "at": 7}])",
        "[0].at");
    row(R"([{"id": "0000000000000001", "op": "cut", "target": {"id": "0000000000000002"}, "size": 7}])",
        "[0].size");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"ball": [1]}}])", "[0].shape");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"sphere": [1]}}])", "[0].shape.sphere");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"profile": [0, 0, 0, 1, 1, 1]}}])",
        "[0].shape.profile");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"profile": [0, 0, 0, 1, 1, 1, 1]}}])",
        "[0].shape");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"mesh": {}}}])", "[0].shape");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"mesh": {"points": [1]}}}])",
        "[0].shape.mesh.points");
    row(R"([{"id": "0000000000000001", "op": "draw", "points": [[1, 2, 3], [1]]}])", "[0].points[1]");
    row(R"([{"id": "0000000000000001", "op": "prune", "shape": {"sphere": [0, 0, 0, 1]}},)"
        R"({"id": "0000000000000001", "op": "prune", "shape": {"sphere": [0, 0, 0, 1]}}])",
        "[1].id");
}

void TestEditCommands::badFiles()
{
    QFETCH(QByteArray, edits);
    QFETCH(QByteArray, path);
    const QByteArray file = R"({"format": "ramure", "version": 3, "nodes": [{"id": 2, "kind": "tree", )"
                            R"("name": "a", "edits": )" +
                            edits + "}]}";
    const auto read = readProject(file);
    QVERIFY(!read);
    QCOMPARE(QByteArray::fromStdString(read.error().path), path);
}

void TestEditCommands::badScripts_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("code");
    const auto row = [](const char* line, ErrorCode code) {
        QTest::newRow(line) << QByteArray(line) << static_cast<int>(code);
    };
    row("cut", ErrorCode::Syntax);
    row("[]", ErrorCode::Syntax);
    row("{}", ErrorCode::Unknown);
    row(R"({"op": "grow", "target": "TRUNK"})", ErrorCode::Unknown);
    row(R"({"op": "remove"})", ErrorCode::Invalid);
    row(R"({"op": "remove", "target": "123"})", ErrorCode::Invalid);
    row(R"({"op": "remove", "target": "0123456789abcdef"})", ErrorCode::Unknown);
    row(R"({"op": "remove", "target": "TRUNK"})", ErrorCode::Invalid);
    row(R"({"op": "cut", "target": "TRUNK", "at": 1.5})", ErrorCode::Invalid);
    row(R"({"op": "cut", "target": "TRUNK", "frame": "world"})", ErrorCode::Invalid);
    row(R"({"op": "cut", "target": [], "at": 0.5})", ErrorCode::Invalid);
    row(R"({"op": "draw", "parent": "TRUNK", "at": 0.5, "points": [[1, 2]]})", ErrorCode::Invalid);
    row(R"({"op": "place", "organ": "leaf"})", ErrorCode::Invalid);
    row(R"({"op": "place", "target": "TRUNK"})", ErrorCode::Invalid);
    row(R"({"op": "place", "target": "TRUNK", "organ": "nut"})", ErrorCode::Invalid);
    // Nobody means a sphere about the origin.
    row(R"({"op": "leaves", "shown": false})", ErrorCode::Invalid);
    row(R"({"op": "attract", "strength": 1})", ErrorCode::Invalid);
}

void TestEditCommands::badScripts()
{
    QFETCH(QByteArray, line);
    QFETCH(int, code);
    Document document;
    withPlainTree(document);
    const QByteArray file = fileOf(document);
    const QByteArray trunk = hex(axesOf(*grownTree(plainTree(), Stage::Skeleton).grown).axes.front().address);
    line.replace("TRUNK", trunk);
    const auto replayed = replayEdits(
        document, 2, R"({"op": "length", "target": ")" + trunk + "\", \"factor\": 2}\n\n" + line + "\n");
    QVERIFY(!replayed);
    QCOMPARE(static_cast<int>(replayed.error().code), code);
    QCOMPARE(replayed.error().line, 3);
    QCOMPARE(fileOf(document), file);
    QVERIFY(!replayEdits(document, 9, {}));
}

void TestEditCommands::scriptsOfEverySystem()
{
    const auto axes = axesOf(*grownTree(plainTree(), Stage::Skeleton).grown).axes;
    QByteArray lines("\n");
    for (const std::size_t limb : {0U, 1U})
        lines += R"({"op": "length", "target": ")" + hex(axes[limb].address) + "\", \"factor\": 2}\n";
    Document plain;
    withPlainTree(plain);
    QVERIFY(replayEdits(plain, 2, lines));
    for (const QByteArray& text :
         {QByteArray(lines).replace("\n", "\r\n"), QByteArray(lines).replace("\n", "\r"),
          "\xEF\xBB\xBF" + lines, lines + "\x1A"}) {
        Document other;
        withPlainTree(other);
        const auto replayed = replayEdits(other, 2, text);
        QVERIFY2(replayed, why(replayed).constData());
        QCOMPARE(fileOf(other), fileOf(plain));
    }
}

void TestEditCommands::scriptsAreAsByHand()
{
    Document script, hand;
    withPlainTree(script);
    withPlainTree(hand);
    std::vector<std::uint64_t> address;
    for (const Axis& axis : axesOf(*grownTree(plainTree(), Stage::Skeleton).grown).axes)
        address.push_back(axis.address);
    const QByteArray lines =
        R"({"op": "cut", "target": "LIMB", "at": 0.4})"
        "\n"
        R"({"op": "bend", "target": "TRUNK", "from": 0.5, "rotation": [0.5, 0, 0.25], "name": "wind"})"
        "\n\r\n"
        R"({"op": "draw", "id": "00000000000000aa", "parent": "TRUNK", "at": 0.5, "points": [[1, 3, 0, 0.05]]})"
        "\n"
        R"({"op": "move", "target": "UPPER", "at": 0.9, "azimuth": 45})"
        "\n"
        R"({"op": "place", "target": "UPPER", "at": 0.25, "azimuth": 90, "organ": "fruit", "factor": 1.5})"
        "\n"
        R"({"op": "length", "target": ["00000000000000aa", "UPPER"], "factor": 1.5})"
        "\n"
        R"({"op": "bend", "target": "UPPER", "rotation": [0.1, 0, 0], "frame": "parent"})"
        "\n"
        R"({"op": "bend", "target": "UPPER", "to": 0.75, "rotation": [0.1, 0, 0], "frame": "parent"})"
        "\n"
        R"({"op": "comb", "centre": [0, 3, 0], "radius": 2, "direction": [1, 0, 0], "points": [[1, 3, 0], [2, 3, 0, 1.5]]})";
    const QByteArray named = QByteArray(lines)
                                 .replace("TRUNK", hex(address[0]))
                                 .replace("LIMB", hex(address[1]))
                                 .replace("UPPER", hex(address[3]));
    const auto replayed = replayEdits(script, 2, named);
    QVERIFY2(replayed, why(replayed).constData());
    QCOMPARE(script.undoStack()->count(), 1);
    const auto put = [&hand](TreeEdit edit, bool inTreeSpace = true) {
        EditContext context(*grownTree(plainTree(), Stage::Skeleton).grown, editsOf(hand));
        QVERIFY(edit::putTreeEdits(hand, 2, {*context.prepared(std::move(edit), inTreeSpace)}));
    };
    TreeEdit edit = editOf(EditOperation::Cut, address[1]);
    edit.at = 0.4;
    put(edit);
    edit = editOf(EditOperation::Bend, address[0]);
    edit.from = 0.5;
    edit.rotation = {0.5, 0.0, 0.25};
    edit.name = "wind";
    put(edit);
    edit = editOf(EditOperation::Draw, address[0]);
    edit.id = 0xaa;
    edit.points = {{{1.0, 3.0, 0.0}, 0.05}};
    put(edit);
    edit = editOf(EditOperation::Move, address[3]);
    edit.at = 0.9;
    edit.azimuthRad = std::numbers::pi / 4;
    put(edit);
    edit = editOf(EditOperation::Place, address[3]);
    edit.at = 0.25;
    edit.azimuthRad = std::numbers::pi / 2;
    edit.organ = EditOrgan::Fruit;
    edit.factor = 1.5;
    put(edit);
    for (const std::uint64_t target : {std::uint64_t{0xaa}, address[3]}) {
        edit = editOf(EditOperation::Length, target);
        edit.factor = 1.5;
        put(edit);
    }
    edit = editOf(EditOperation::Bend, address[3]);
    edit.rotation = {0.1, 0.0, 0.0};
    put(edit, false);
    edit.to = 0.75; // bit by bit
    put(edit, false);
    edit = editOf(EditOperation::Comb, 0); // a stroke
    edit.centre = {0.0, 3.0, 0.0};
    edit.radius = 2.0;
    edit.direction = {1.0, 0.0, 0.0};
    edit.points = {{{1.0, 3.0, 0.0}, 0.0}, {{2.0, 3.0, 0.0}, 1.5}};
    put(edit);
    QCOMPARE(editsOf(hand).back().points.size(), std::size_t(2));
    QCOMPARE(fileOf(script), fileOf(hand));
}

void TestEditCommands::randomEditsUndoAndRedo()
{
    Document document;
    withPlainTree(document);
    Random random(5, RandomStream::Test);
    std::vector<QByteArray> files{fileOf(document)};
    const Skeleton grown = *grownTree(plainTree(), Stage::Skeleton).grown;
    while (files.size() <= 1000) {
        const std::vector<TreeEdit>& edits = editsOf(document);
        const std::size_t steps = static_cast<std::size_t>(document.undoStack()->count());
        const auto any = [&] { return edits[random.below(static_cast<std::uint32_t>(edits.size()))].id; };
        const std::uint32_t what = edits.size() < 5 ? 0 : random.below(edits.size() > 40 ? 8 : 6);
        if (what < 3) {
            EditContext context(grown, edits);
            const Skeleton now = context.skeleton();
            if (auto ready = context.prepared(randomEdit(axesOf(now), now, random), true))
                QVERIFY(edit::putTreeEdits(document, 2, {*ready}));
        } else if (what == 3) {
            QVERIFY(edit::moveTreeEdit(document, 2, any(), static_cast<int>(random.below(9))));
        } else if (what == 4) {
            QVERIFY(edit::setTreeEditsEnabled(document, 2, {any()}, random.below(2) == 0));
        } else if (what == 5) {
            QVERIFY(edit::renameTreeEdit(document, 2, any(), QString::number(random.below(9))));
        } else {
            QVERIFY(edit::removeTreeEdits(document, 2, {any()}));
        }
        if (static_cast<std::size_t>(document.undoStack()->count()) > steps)
            files.push_back(fileOf(document));
    }
    for (std::size_t i = files.size() - 1; i-- > 0;) {
        document.undo();
        QVERIFY(fileOf(document) == files[i]);
    }
    for (std::size_t i = 1; i < files.size(); ++i) {
        document.redo();
        QVERIFY(fileOf(document) == files[i]);
    }
}

RAMURE_SUITE(TestEditCommands)

} // namespace tst_commands_edits

#include "tst_commands_edits.moc"
