#include "core/document/commands.h"
#include "tests/document/random_scene.h"
#include "tests/document/recorder.h"
#include "tests/support/kind_with.h"
#include "tests/support/suite.h"

#include <QElapsedTimer>
#include <cmath>
#include <limits>
#include <set>

using namespace ramure;

using Ids = std::vector<NodeId>;

static Node makeNode(NodeId id, NodeId parent = noNode, NodeKind kind = NodeKind::Tree)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = kind;
    node.name = std::string("n").append(std::to_string(id));
    return node;
}
static Ids idsOf(const Document& document)
{
    Ids ids;
    for (const Node& node : document.scene().nodes())
        ids.push_back(node.id);
    return ids;
}
static QByteArray fileOf(const Document& document)
{
    return writeProject(document.project());
}

/// Group 1 with trees 2 and 3, tree 4 beside it.
struct Fixture
{
    explicit Fixture(NodeKind kind = NodeKind::Tree)
    {
        document.reset(*Scene::fromNodes({makeNode(1, noNode, NodeKind::Group), makeNode(2, 1, kind),
                                          makeNode(3, 1, kind), makeNode(4, noNode, kind)}),
                       {});
        recorder.changes.clear();
    }
    Document document;
    test::Recorder recorder{document};
    QUndoStack& stack = *document.undoStack();
};

class TestCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badValuesAreRefused();
    void lockedNodesRefuseEverything();
    void badStructureIsRefused();

    void everyParameter_data();
    void everyParameter();
    void gesturesMerge_data();
    void gesturesMerge();
    void gestureBackToTheStartLeavesNothing();
    void gesturesDoNotMergeAcrossSaving();
    void severalNodes();
    void severalParameters();
    void stateOfNodes();
    void insertAndRemove();
    void removeWithinRemove();
    void duplicates();
    void moves();
    void moveKeepsTheWorld();
    void branchRolls();
    void branchBends();
    void turnedBranches();
    void newTrees();
    void randomEditsUndoAndRedo();
};

void TestCommands::badValuesAreRefused()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    const ParamDef& alpha = *findParam("turtle.alpha");
    QVERIFY(!edit::setParam(f.document, {2}, alpha, std::numeric_limits<double>::quiet_NaN()));
    QVERIFY(!edit::setParam(f.document, {2}, alpha, std::numeric_limits<double>::infinity()));
    QVERIFY(!edit::setParam(f.document, {2}, alpha, -1.0));
    QVERIFY(!edit::setParam(f.document, {2}, alpha, std::string("0.2")));
    QVERIFY(!edit::setParam(f.document, {2, 1}, alpha, 0.3)); // groups have none
    QCOMPARE(edit::setParam(f.document, {2, 9}, alpha, 0.3).error().code, ErrorCode::Unknown);
    QVERIFY(!edit::setParams(f.document, {2}, {{&alpha, 0.3}, {findParam("turtle.decay"), -1.0}}, "x"));
    QVERIFY(!edit::setBranchRoll(f.document, 2, {1}, std::numeric_limits<double>::quiet_NaN()));
    QVERIFY(!edit::setBranchRoll(f.document, 1, {1}, 0.5));
    QVERIFY(!edit::setBranchRoll(f.document, 9, {1}, 0.5));
    QVERIFY(!edit::newTree(f.document, {1}));
    QVERIFY(!edit::newTree(f.document, {}));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(f.recorder.changes.empty());
    QCOMPARE(fileOf(f.document), before);
}

void TestCommands::lockedNodesRefuseEverything()
{
    Fixture f;
    QVERIFY(edit::setNodeLocked(f.document, {1}, true));
    const QByteArray before = fileOf(f.document);
    const int steps = f.stack.count();
    for (const NodeId id : {1u, 2u}) { // locked itself, and below a locked one
        QVERIFY(!edit::setParam(f.document, {id}, *findParam("tree.scale"), glm::dvec3(2.0)));
        QVERIFY(!edit::setNodeName(f.document, id, "x"));
        QVERIFY(!edit::setNodeVisible(f.document, {id}, false));
        QVERIFY(!edit::removeNodes(f.document, {4, id}));
        QVERIFY(!edit::moveNode(f.document, id, noNode, 5, false));
        QVERIFY(!edit::moveNode(f.document, 4, id, 0, false));
        QVERIFY(!edit::insertNodes(f.document, {makeNode(1)}, id, 0));
    }
    QVERIFY(!edit::setBranchRoll(f.document, 2, {1}, 0.5));
    QVERIFY(!edit::newTree(f.document, {2}));
    QVERIFY(!edit::duplicateNodes(f.document, {2}));
    QCOMPARE(f.stack.count(), steps);
    QCOMPARE(fileOf(f.document), before);
    QVERIFY(edit::setNodeLocked(f.document, {2}, true));
    QVERIFY(edit::setNodeLocked(f.document, {1}, false));
    QVERIFY(!edit::removeNodes(f.document, {1})); // a locked node below
    QVERIFY(edit::setNodeName(f.document, 3, "free"));
}

void TestCommands::badStructureIsRefused()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    QVERIFY(!edit::insertNodes(f.document, {}, noNode, 0));
    QVERIFY(!edit::insertNodes(f.document, {makeNode(1)}, 77, 0));
    QVERIFY(!edit::insertNodes(f.document, {makeNode(1), makeNode(2, 5)}, noNode, 0));
    Node bad = makeNode(1);
    bad.params.turtle.alpha = -1.0;
    QVERIFY(!edit::insertNodes(f.document, {bad}, noNode, 0));
    QVERIFY(!edit::removeNodes(f.document, {77}));
    QVERIFY(!edit::duplicateNodes(f.document, {77}));
    QVERIFY(!edit::moveNode(f.document, 1, 2, 0, false));
    QVERIFY(!edit::moveNode(f.document, 1, 1, 0, false));
    QVERIFY(!edit::moveNode(f.document, 77, 1, 0, false));
    QVERIFY(!edit::moveNode(f.document, 2, 77, 0, false));
    QVERIFY(!edit::setNodeName(f.document, 77, "x"));
    QVERIFY(!edit::setNodeLocked(f.document, {77}, true));
    QCOMPARE(f.stack.count(), 0);
    QCOMPARE(fileOf(f.document), before);
    QVERIFY(edit::removeNodes(f.document, {})); // nothing to do is no error, and no step
    QVERIFY(edit::setNodeVisible(f.document, {}, false));
    QCOMPARE(f.stack.count(), 0);
}

static void addParameterRows()
{
    QTest::addColumn<int>("row");
    for (const ParamDef& def : paramTable())
        QTest::newRow(def.key) << int(paramId(def));
}
static const ParamDef& fetchedDef()
{
    QFETCH(int, row);
    return paramTable()[static_cast<std::size_t>(row)];
}
/// Allowed, and another one than \p than.
static ParamValue otherValue(const ParamDef& def, const ParamValue& than, Random& random)
{
    ParamValue value = than;
    while (value == than)
        value = test::randomValue(def, random);
    return value;
}

void TestCommands::everyParameter_data()
{
    addParameterRows();
}

void TestCommands::everyParameter()
{
    const ParamDef& def = fetchedDef();
    Fixture f(test::kindWith(def));
    Random random(1, RandomStream::Test);
    const ParamValue before = def.get(f.document.scene().find(2)->params);
    const ParamValue after = otherValue(def, before, random);
    const auto present = [&] { return def.get(f.document.scene().find(2)->params); };
    const QByteArray file = fileOf(f.document);
    const auto checkNews = [&] {
        const Change news = f.recorder.takeEdit();
        QCOMPARE(news.kinds, quint32{changeParams});
        QCOMPARE(news.nodes, (Ids{2}));
        QCOMPARE(news.params, (std::vector<ParamId>{paramId(def)}));
        QCOMPARE(news.firstStale, def.stage);
        QCOMPARE(news.revision, f.document.revision());
        QCOMPARE(f.document.shapeRevision(2) == news.revision, def.stage < Stage::Placement);
    };
    QVERIFY(edit::setParam(f.document, {2}, def, after));
    QVERIFY(present() == after);
    QVERIFY(f.document.isModified());
    QVERIFY(f.stack.undoText().contains(QString(def.label)));
    checkNews();
    QVERIFY(edit::setParam(f.document, {2}, def, after)); // the same again is no step
    QCOMPARE(f.stack.count(), 1);
    QVERIFY(f.recorder.changes.empty());
    f.stack.undo();
    QVERIFY(present() == before);
    QCOMPARE(fileOf(f.document), file);
    QVERIFY(!f.document.isModified());
    checkNews();
    f.stack.redo();
    QVERIFY(present() == after);
    checkNews();
    QVERIFY(f.recorder.paired());
}

void TestCommands::gesturesMerge_data()
{
    addParameterRows();
}

void TestCommands::gesturesMerge()
{
    const ParamDef& def = fetchedDef();
    Fixture f(test::kindWith(def));
    Random random(2, RandomStream::Test);
    const QByteArray file = fileOf(f.document);
    ParamValue value = def.get(f.document.scene().find(2)->params);
    const ParamValue first = value;
    const GestureId drag = newGesture();
    for (int i = 0; i < 5; ++i) {
        value = otherValue(def, value, random);
        if (value == first && i == 4)
            value = otherValue(def, value, random);
        QVERIFY(edit::setParam(f.document, {2, 3}, def, value, drag));
    }
    if (value != first)
        QCOMPARE(f.stack.count(), 1);
    QVERIFY(edit::setParam(f.document, {2}, def, otherValue(def, value, random), newGesture()));
    QVERIFY(edit::setParam(f.document, {2}, def, value)); // without a gesture nothing merges
    QVERIFY(edit::setParam(f.document, {4}, def,
                           otherValue(def, def.get(f.document.scene().find(4)->params), random)));
    while (f.stack.canUndo())
        f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    QVERIFY(f.recorder.paired());
}

void TestCommands::gestureBackToTheStartLeavesNothing()
{
    Fixture f;
    const ParamDef& theta = *findParam("turtle.theta");
    const double start = f.document.scene().find(2)->params.turtle.theta;
    const GestureId drag = newGesture();
    for (const double value : {0.4, 0.5, start})
        QVERIFY(edit::setParam(f.document, {2}, theta, value, drag));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(!f.document.isModified());
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.6, drag)); // and on in the same drag
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.7, drag));
    QCOMPARE(f.stack.count(), 1);
    f.stack.undo();
    QCOMPARE(f.document.scene().find(2)->params.turtle.theta, start);
}

void TestCommands::gesturesDoNotMergeAcrossSaving()
{
    Fixture f;
    const ParamDef& theta = *findParam("turtle.theta");
    const GestureId drag = newGesture();
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.4, drag));
    f.stack.setClean();
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.5, drag));
    QVERIFY(f.document.isModified());
    f.stack.undo();
    QVERIFY(!f.document.isModified());
    QCOMPARE(f.document.scene().find(2)->params.turtle.theta, 0.4);
}

void TestCommands::severalNodes()
{
    Fixture f;
    const ParamDef& alpha = *findParam("turtle.alpha");
    QVERIFY(edit::setParam(f.document, {3}, alpha, 0.5));
    QVERIFY(edit::setParam(f.document, {2, 3, 2, 4}, alpha, 0.5)); // one has it already
    QCOMPARE(f.stack.count(), 2);
    f.stack.undo();
    QCOMPARE(f.document.scene().find(2)->params.turtle.alpha, 0.2);
    QCOMPARE(f.document.scene().find(3)->params.turtle.alpha, 0.5);
    f.recorder.changes.clear();
    f.stack.redo();
    QCOMPARE(f.recorder.takeEdit().nodes, (Ids{2, 3, 4}));
    QCOMPARE(f.document.scene().find(4)->params.turtle.alpha, 0.5);
}

void TestCommands::severalParameters()
{
    Fixture f;
    const std::vector<std::pair<const ParamDef*, ParamValue>> values{
        {findParam("foliage.leavesDensity"), std::int64_t{3}},
        {findParam("turtle.alpha"), 0.5},
        {findParam("turtle.alpha"), 0.6},
        {findParam("sections.lengthDivisions"), std::int64_t{5}},
    };
    QVERIFY(edit::setParams(f.document, {2}, values, "Paste"));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.stack.undoText(), "Paste");
    const Change news = f.recorder.takeEdit();
    QCOMPARE(news.params.size(), std::size_t{3});
    QCOMPARE(news.firstStale, findParam("turtle.alpha")->stage);
    QCOMPARE(f.document.scene().find(2)->params.turtle.alpha, 0.6);
    f.stack.undo();
    QVERIFY(f.document.scene().find(2)->params == NodeParams{});
}

void TestCommands::stateOfNodes()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::setNodeName(f.document, 2, "Chêne 樹"));
    QCOMPARE(f.recorder.takeEdit().kinds, quint32{changeNodeState});
    QVERIFY(edit::setNodeName(f.document, 2, "Chêne 樹"));
    QVERIFY(edit::setNodeVisible(f.document, {1, 2}, false));
    QVERIFY(edit::setNodeLocked(f.document, {2}, true));
    QVERIFY(edit::setNodeLocked(f.document, {2}, false));
    QCOMPARE(f.stack.count(), 4);
    QCOMPARE(f.document.scene().find(2)->name, std::string("Chêne 樹"));
    QVERIFY(!f.document.scene().find(1)->visible);
    QCOMPARE(f.document.shapeRevision(2), quint64{1}); // none of this touches the shape
    while (f.stack.canUndo())
        f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestCommands::insertAndRemove()
{
    Fixture f;
    const auto top =
        edit::insertNodes(f.document, {makeNode(1, noNode, NodeKind::Group), makeNode(2, 1)}, 1, 1);
    QVERIFY2(top, test::why(top));
    QCOMPARE(*top, 5u);
    QCOMPARE(idsOf(f.document), (Ids{1, 2, 5, 6, 3, 4}));
    QCOMPARE(f.document.selection().nodes, (Ids{5}));
    QCOMPARE(f.recorder.changes[0].kinds, quint32{changeStructure});
    QCOMPARE(f.recorder.changes[0].nodes, (Ids{5, 6}));
    QVERIFY(f.document.shapeRevision(6) > 0);
    f.recorder.changes.clear();
    f.stack.undo();
    const Change gone = f.recorder.takeEdit();
    QCOMPARE(gone.kinds, quint32{changeStructure | changeSelection});
    QCOMPARE(gone.nodes, (Ids{5, 6}));
    QVERIFY(f.document.selection().nodes.empty());
    QCOMPARE(f.document.shapeRevision(6), quint64{0});
    f.stack.redo();
    QCOMPARE(idsOf(f.document), (Ids{1, 2, 5, 6, 3, 4}));
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::removeNodes(f.document, {3, 2, 4}));
    QCOMPARE(idsOf(f.document), (Ids{1, 5, 6}));
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    QVERIFY(f.recorder.paired());
}

void TestCommands::removeWithinRemove()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::removeNodes(f.document, {3, 1, 3}));
    QCOMPARE(idsOf(f.document), (Ids{4}));
    QCOMPARE(f.stack.count(), 1);
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestCommands::duplicates()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    const auto copies = edit::duplicateNodes(f.document, {2, 3, 4});
    QVERIFY2(copies, test::why(copies));
    QCOMPARE(idsOf(f.document), (Ids{1, 2, 5, 3, 6, 4, 7}));
    QCOMPARE(f.document.selection().nodes, *copies);
    QCOMPARE(f.document.scene().find(5)->name, std::string("n2 2"));
    const auto again = edit::duplicateNodes(f.document, {2, 5});
    QVERIFY(again);
    QCOMPARE(f.document.scene().find(8)->name, std::string("n2 3"));
    QCOMPARE(f.document.scene().find(9)->name, std::string("n2 4"));
    const auto deep = edit::duplicateNodes(f.document, {1, 2});
    QVERIFY(deep);
    QCOMPARE(deep->size(), std::size_t{1});
    QCOMPARE(f.document.scene().children(deep->front()).size(), f.document.scene().children(1).size());
    while (f.stack.canUndo())
        f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    while (f.stack.canRedo())
        f.stack.redo();
    QCOMPARE(f.document.scene().children(noNode), (Ids{1, deep->front(), 4, 7}));
}

void TestCommands::moves()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::moveNode(f.document, 2, 1, 0, false)); // where it is
    QVERIFY(edit::moveNode(f.document, 4, noNode, 99, true));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(edit::moveNode(f.document, 2, 1, 1, false));
    QCOMPARE(idsOf(f.document), (Ids{1, 3, 2, 4}));
    QVERIFY(edit::moveNode(f.document, 1, 4, 0, false));
    QCOMPARE(idsOf(f.document), (Ids{4, 1, 3, 2}));
    const Change news = f.recorder.changes.back();
    QCOMPARE(news.kinds, quint32{changeStructure});
    QCOMPARE(news.nodes, (Ids{1, 3, 2}));
    QCOMPARE(f.document.shapeRevision(2), quint64{1}); // moving computes nothing anew
    f.stack.undo();
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestCommands::moveKeepsTheWorld()
{
    Fixture f;
    QVERIFY(edit::setParams(f.document, {1},
                            {{findParam("tree.translation"), glm::dvec3(1.0, 2.0, 3.0)},
                             {findParam("tree.rotation"), glm::dvec3(0.1, 0.2, 0.3)},
                             {findParam("tree.scale"), glm::dvec3(2.0)}},
                            "Place"));
    const glm::dmat4 world = worldMatrix(f.document.scene(), 2);
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::moveNode(f.document, 2, noNode, 0, true));
    const glm::dmat4 after = worldMatrix(f.document.scene(), 2);
    for (int column = 0; column < 4; ++column)
        QVERIFY(glm::length(world[column] - after[column]) < 1e-12);
    QVERIFY(f.recorder.changes.back().has(changeParams) || f.recorder.changes.front().has(changeParams));
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    // A squashed parent turned aside cannot be expressed by the child alone.
    QVERIFY(edit::setParam(f.document, {1}, *findParam("tree.scale"), glm::dvec3(1.0, 3.0, 1.0)));
    QVERIFY(edit::setParam(f.document, {2}, *findParam("tree.rotation"), glm::dvec3(0.5, 0.0, 0.0)));
    const int steps = f.stack.count();
    QVERIFY(!edit::moveNode(f.document, 2, noNode, 0, true));
    QCOMPARE(f.stack.count(), steps);
    QVERIFY(edit::moveNode(f.document, 2, noNode, 0, false));
}

void TestCommands::branchRolls()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    const GestureId drag = newGesture();
    QVERIFY(edit::setBranchRoll(f.document, 2, {7, 5, 7}, 0.5, drag));
    const Change news = f.recorder.takeEdit();
    QCOMPARE(news.kinds, quint32{changeBranches});
    QCOMPARE(news.firstStale, Stage::Sections);
    QCOMPARE(f.document.shapeRevision(2), news.revision);
    QVERIFY(edit::setBranchRoll(f.document, 2, {5, 7}, 0.75, drag));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.document.scene().find(2)->params.branches.at(5).rollRad, 0.75);
    QVERIFY(edit::setBranchRoll(f.document, 2, {5, 7}, 0.0, drag)); // where the drag began
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(f.document.scene().find(2)->params.branches.empty());
    QVERIFY(edit::setBranchRoll(f.document, 2, {5}, 0.5));
    QVERIFY(edit::setBranchRoll(f.document, 2, {5}, 0.0));
    f.stack.undo();
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestCommands::branchBends()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(!edit::setBranchBends(f.document, 99, {{5, {1.0, 0.0, 0.0}}}));
    QVERIFY(!edit::setBranchBends(f.document, 2, {{5, {std::nan(""), 0.0, 0.0}}}));
    QVERIFY(edit::setBranchBends(f.document, 2, {}));
    QVERIFY(edit::setBranchBends(f.document, 2, {{5, glm::dvec3(0.0)}}));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(edit::setBranchRoll(f.document, 2, {5}, 0.5));
    f.recorder.changes.clear();
    QVERIFY(edit::setBranchBends(f.document, 2, {{5, {0.1, 0.2, 0.3}}, {7, {0.0, 0.0, 1.0}}}));
    const Change news = f.recorder.takeEdit();
    QCOMPARE(news.kinds, quint32{changeBranches});
    QCOMPARE(news.firstStale, Stage::Simplified);
    QCOMPARE(f.document.scene().find(2)->params.branches.at(5).rollRad, 0.5);
    QVERIFY(f.document.scene().find(2)->params.branches.at(5).bendRad == glm::dvec3(0.1, 0.2, 0.3));
    const QByteArray bent = fileOf(f.document);
    // Those that are not named lose their bend, and keep the rest.
    QVERIFY(edit::setBranchBends(f.document, 2, {{7, {0.0, 0.0, 1.0}}}));
    QVERIFY(f.document.scene().find(2)->params.branches.at(5).bendRad == glm::dvec3(0.0));
    QCOMPARE(f.document.scene().find(2)->params.branches.at(5).rollRad, 0.5);
    f.stack.undo();
    QCOMPARE(fileOf(f.document), bent);
    f.stack.undo();
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    f.stack.redo();
    f.stack.redo();
    QCOMPARE(fileOf(f.document), bent);
}

void TestCommands::turnedBranches()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(!edit::turnBranches(f.document, 99, {{5, {1.0, 0.0, 0.0}}}));
    QVERIFY(!edit::turnBranches(f.document, 2, {{5, {std::nan(""), 0.0, 0.0}}}));
    QVERIFY(edit::turnBranches(f.document, 2, {{5, glm::dvec3(0.0)}}));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(edit::setBranchBends(f.document, 2, {{3, {1.0, 0.0, 0.0}}}));
    const GestureId drag = newGesture();
    // The bend of one of them does not change at first: the drag is one step all the same.
    QVERIFY(edit::turnBranches(f.document, 2, {{5, {0.1, 0.0, 0.0}}, {7, glm::dvec3(0.0)}}, drag));
    QVERIFY(edit::turnBranches(f.document, 2, {{5, {0.2, 0.0, 0.0}}, {7, {0.0, 0.3, 0.0}}}, drag));
    QCOMPARE(f.stack.count(), 2);
    const auto& branches = f.document.scene().find(2)->params.branches;
    QVERIFY(branches.at(3).bendRad == glm::dvec3(1.0, 0.0, 0.0));
    QVERIFY(branches.at(7).bendRad == glm::dvec3(0.0, 0.3, 0.0));
    f.stack.undo();
    QVERIFY(!f.document.scene().find(2)->params.branches.contains(5));
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestCommands::newTrees()
{
    Fixture f;
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::newTree(f.document, {1, 2, 3, 4}));
    QCOMPARE(f.stack.count(), 1);
    std::set<std::int64_t> seeds;
    for (const NodeId id : {2u, 3u, 4u}) {
        const NodeParams& params = f.document.scene().find(id)->params;
        QVERIFY(params.grammar.stochastic);
        QCOMPARE(params.foliage.seed, params.grammar.seed);
        seeds.insert(params.grammar.seed);
    }
    QCOMPARE(seeds.size(), std::size_t{3});
    const QByteArray once = fileOf(f.document);
    f.stack.undo();
    QCOMPARE(fileOf(f.document), file);
    QVERIFY(edit::newTree(f.document, {1, 2, 3, 4})); // the same way gives the same trees
    QCOMPARE(fileOf(f.document), once);
    seeds.clear();
    for (int i = 0; i < 2000; ++i) {
        QVERIFY(edit::newTree(f.document, {2}));
        QVERIFY(seeds.insert(f.document.scene().find(2)->params.grammar.seed).second);
    }
    // Seeds over 2^31 and the largest one are as good.
    for (const double seed : {0.0, findParam("grammar.seed")->hardMax}) {
        QVERIFY(edit::setParam(f.document, {2}, *findParam("grammar.seed"), static_cast<std::int64_t>(seed)));
        QVERIFY(edit::newTree(f.document, {2}));
    }
}

/// One edit of any kind; most succeed.
static void randomEdit(Document& document, Random& random)
{
    const std::vector<Node>& nodes = document.scene().nodes();
    const auto pick = [&]() -> NodeId {
        if (nodes.empty() || random.below(8) == 0)
            return noNode;
        return nodes[random.below(static_cast<std::uint32_t>(nodes.size()))].id;
    };
    static thread_local GestureId gesture = newGesture();
    if (random.below(4) == 0)
        gesture = newGesture();
    const int row = static_cast<int>(random.below(6)) - 1;
    const bool full = nodes.size() > 40; // every state is kept: small ones keep the test quick
    switch (random.below(13)) {
    case 0:
        if (!full)
            edit::insertNodes(document, {test::randomNode(1, noNode, random)}, pick(), row);
        break;
    case 1:
        edit::removeNodes(document, {pick(), pick()});
        break;
    case 2:
        if (!full)
            edit::duplicateNodes(document, {pick(), pick()});
        break;
    case 3:
        edit::moveNode(document, pick(), pick(), row, random.below(2) == 0);
        break;
    case 4:
        edit::setNodeName(document, pick(), QString::number(random.below(10)));
        break;
    case 5:
        edit::setNodeVisible(document, {pick(), pick()}, random.below(2) == 0);
        break;
    case 6:
        edit::setNodeLocked(document, {pick(), pick()}, random.below(16) == 0);
        break;
    case 7:
        edit::setBranchRoll(document, pick(), {random.below(3), random.below(3)}, random.range(-1, 1),
                            gesture);
        break;
    case 8:
        edit::newTree(document, {pick(), pick()});
        break;
    case 9: {
        TimelineSettings timeline = document.scene().timeline();
        timeline.framesPerSecond = 23.0 + random.below(3);
        timeline.lastFrame = 10 + random.below(3);
        timeline.loop = PlayLoop(random.below(3));
        edit::setTimeline(document, timeline, random.below(2) == 0 ? gesture : 0);
        break;
    }
    default: {
        const ParamDef& def = paramTable()[random.below(static_cast<std::uint32_t>(paramTable().size()))];
        edit::setParam(document, {pick()}, def, test::randomValue(def, random),
                       random.below(2) == 0 ? gesture : 0);
    }
    }
}

void TestCommands::randomEditsUndoAndRedo()
{
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        Random random(seed, RandomStream::Test);
        Document document;
        document.reset(test::randomScene(random), {});
        test::Recorder recorder(document);
        const QByteArray before = fileOf(document);
        std::vector<Scene> states{document.scene()}; // state i is that of undo index i
        QElapsedTimer timer;
        qint64 spent = 0;
        int tries = 0;
        for (; document.undoStack()->index() < 1000 && tries < 20000; ++tries) {
            timer.start();
            if (random.below(16) == 0)
                document.undoStack()->undo();
            else
                randomEdit(document, random);
            spent += timer.nsecsElapsed();
            states.resize(static_cast<std::size_t>(document.undoStack()->index()) + 1);
            states.back() = document.scene();
        }
        qInfo("%d edits in %lld us: %d steps, %zu nodes", tries, spent / 1000, document.undoStack()->count(),
              document.scene().nodes().size());
        while (document.undoStack()->canRedo())
            document.undoStack()->redo();
        const QByteArray after = fileOf(document);
        QCOMPARE(document.undoStack()->count(), 1000);
        while (document.undoStack()->canUndo()) {
            const auto index = static_cast<std::size_t>(document.undoStack()->index());
            if (index < states.size())
                QVERIFY(document.scene() == states[index]);
            document.undoStack()->undo();
        }
        QCOMPARE(fileOf(document), before);
        while (document.undoStack()->canRedo())
            document.undoStack()->redo();
        QCOMPARE(fileOf(document), after);
        QVERIFY(recorder.paired());
        QVERIFY(readProject(after));
    }
}

QTEST_GUILESS_MAIN(TestCommands)
#include "tst_commands.moc"
