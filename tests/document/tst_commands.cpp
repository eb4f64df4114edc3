#include "core/qt/document/commands.h"
#include "tests/document/commands_fixture.h"
#include "tests/document/random_scene.h"
#include "tests/support/kind_with.h"
#include "tests/support/suite.h"

#include <limits>
#include <numbers>

namespace tst_commands {

using namespace ramure;
using namespace ramure::test;

class TestCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badValuesAreRefused();
    void lockedNodesRefuseEverything();
    void stepsNameTheValue();
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

/// The last one of a drag; long ones not at all.
void TestCommands::stepsNameTheValue()
{
    Fixture f;
    const auto step = [&] { return f.stack.text(f.stack.count() - 1); };
    const auto ends = [&](const char* text) { return step().endsWith(QLatin1String(text)); };
    QVERIFY(edit::setParam(f.document, {2}, *findParam("turtle.theta"), std::numbers::pi / 6.0));
    QVERIFY2(step().endsWith(QStringLiteral("to 30°")), qPrintable(step()));
    QVERIFY(edit::setParam(f.document, {2}, *findParam("grammar.iterations"), std::int64_t(3)));
    QVERIFY2(ends("to 3"), qPrintable(step()));
    QVERIFY(edit::setParam(f.document, {2}, *findParam("grammar.axiom"), std::string("AAA")));
    QVERIFY2(ends("Axiom"), qPrintable(step()));
    QVERIFY(edit::setComponent(f.document, {2}, *findParam("tree.scale"), 1, 2.5));
    QVERIFY2(ends("Y to 2.5"), qPrintable(step()));
    const int before = f.stack.count();
    const GestureId gesture = newGesture();
    for (const double decay : {0.6, 0.65, 0.7})
        QVERIFY(edit::setParam(f.document, {2}, *findParam("turtle.decay"), decay, gesture));
    QCOMPARE(f.stack.count(), before + 1);
    QVERIFY2(step().contains(QLatin1String("to 0.7")) || ends("to 70 %"), qPrintable(step()));
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
    f.document.undo();
    QVERIFY(present() == before);
    QCOMPARE(fileOf(f.document), file);
    QVERIFY(!f.document.isModified());
    checkNews();
    f.document.redo();
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
        f.document.undo();
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
    f.document.undo();
    QCOMPARE(f.document.scene().find(2)->params.turtle.theta, start);
}

void TestCommands::gesturesDoNotMergeAcrossSaving()
{
    Fixture f;
    const ParamDef& theta = *findParam("turtle.theta");
    const GestureId drag = newGesture();
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.4, drag));
    f.document.markSaved();
    QVERIFY(edit::setParam(f.document, {2}, theta, 0.5, drag));
    QVERIFY(f.document.isModified());
    f.document.undo();
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
    f.document.undo();
    QCOMPARE(f.document.scene().find(2)->params.turtle.alpha, 0.2);
    QCOMPARE(f.document.scene().find(3)->params.turtle.alpha, 0.5);
    f.recorder.changes.clear();
    f.document.redo();
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
    f.document.undo();
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
        f.document.undo();
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
    f.document.undo();
    const Change gone = f.recorder.takeEdit();
    QCOMPARE(gone.kinds, quint32{changeStructure | changeSelection});
    QCOMPARE(gone.nodes, (Ids{5, 6}));
    QVERIFY(f.document.selection().nodes.empty());
    QCOMPARE(f.document.shapeRevision(6), quint64{0});
    f.document.redo();
    QCOMPARE(idsOf(f.document), (Ids{1, 2, 5, 6, 3, 4}));
    const QByteArray file = fileOf(f.document);
    QVERIFY(edit::removeNodes(f.document, {3, 2, 4}));
    QCOMPARE(idsOf(f.document), (Ids{1, 5, 6}));
    f.document.undo();
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
    f.document.undo();
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
        f.document.undo();
    QCOMPARE(fileOf(f.document), file);
    while (f.stack.canRedo())
        f.document.redo();
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
    f.document.undo();
    f.document.undo();
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
    f.document.undo();
    QCOMPARE(fileOf(f.document), file);
    // A squashed parent turned aside cannot be expressed by the child alone.
    QVERIFY(edit::setParam(f.document, {1}, *findParam("tree.scale"), glm::dvec3(1.0, 3.0, 1.0)));
    QVERIFY(edit::setParam(f.document, {2}, *findParam("tree.rotation"), glm::dvec3(0.5, 0.0, 0.0)));
    const int steps = f.stack.count();
    QVERIFY(!edit::moveNode(f.document, 2, noNode, 0, true));
    QCOMPARE(f.stack.count(), steps);
    QVERIFY(edit::moveNode(f.document, 2, noNode, 0, false));
}

RAMURE_SUITE(TestCommands)

} // namespace tst_commands

#include "tst_commands.moc"
