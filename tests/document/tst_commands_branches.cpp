#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/scene/preset_scene.h"
#include "tests/document/commands_fixture.h"
#include "tests/document/random_scene.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"

#include <QElapsedTimer>
#include <set>

namespace tst_commands_branches {

using namespace ramure;
using namespace ramure::test;

/// What is done to branches by hand, new trees, and edits of all kinds in any order.
class TestBranchCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void branchRolls();
    void newTrees();
    void newTreeOfEveryPresetIsAnotherTree();
    void newTreeNeedsSomethingThatVaries();
    void resetGivesThePresetsValues();
    void randomEditsUndoAndRedo();
    void editsOfTheMeshUndoToTheSameBytes();
};

void TestBranchCommands::branchRolls()
{
    test::TreeDocument trees;
    Document& document = trees.document();
    const NodeId tree = trees.add(test::smallForks());
    const auto key = [&](Index branch) { return trees.skeleton(tree).key[branch]; };
    const auto rolls = [&] { return edit::branchRolls(document, tree, {key(5), key(7), 42}); };
    const int before = document.undoStack()->count();
    const QByteArray file = fileOf(document);
    QCOMPARE(edit::setBranchRoll(document, tree, {42}, 0.5).error().code, ErrorCode::Unknown);
    QVERIFY(edit::setBranchRoll(document, tree, {key(5)}, 0.0)); // as it is
    QCOMPARE(document.undoStack()->count(), before);
    test::Recorder recorder(document);
    const GestureId drag = newGesture();
    QVERIFY(edit::setBranchRoll(document, tree, {key(7), key(5)}, 0.5, drag));
    const Change news = recorder.takeEdit();
    QCOMPARE(news.kinds, quint32{changeBranches});
    QCOMPARE(document.shapeRevision(tree), news.revision);
    QVERIFY(trees.compute(tree));
    QVERIFY(edit::setBranchRoll(document, tree, {key(5), key(7)}, 0.75, drag));
    QCOMPARE(document.undoStack()->count(), before + 1);
    QVERIFY(trees.compute(tree));
    QCOMPARE(rolls(), (std::vector<double>{0.75, 0.75, 0.0}));
    QCOMPARE(document.scene().find(tree)->params.edits.size(), std::size_t{2});
    for (const Index branch : {Index(5), Index(7)})
        QCOMPARE(trees.skeleton(tree).rollOfEach()[branch], 0.75);
    QVERIFY(edit::setBranchRoll(document, tree, {key(5)}, 0.0));
    QCOMPARE(rolls(), (std::vector<double>{0.0, 0.75, 0.0}));
    document.undo();
    QVERIFY(edit::setBranchRoll(document, tree, {key(5), key(7)}, 0.0));
    QVERIFY(document.scene().find(tree)->params.edits.empty());
    document.undo();
    document.undo();
    QCOMPARE(fileOf(document), file);
}

void TestBranchCommands::newTrees()
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
    f.document.undo();
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

void TestBranchCommands::newTreeOfEveryPresetIsAnotherTree()
{
    TreePipeline pipeline;
    for (const Preset& preset : presets()) {
        Document document;
        document.reset(*presetScene(preset.name), {});
        const auto skeleton = [&] {
            return pipeline.evaluate(document.scene().nodes().front().params, Stage::Skeleton)->skeleton;
        };
        const auto first = skeleton();
        QVERIFY(edit::newTree(document, {1}));
        const auto second = skeleton();
        QVERIFY(edit::newTree(document, {1}));
        const auto third = skeleton();
        QVERIFY2(!(*first == *second) && !(*second == *third), preset.name);
    }
}

void TestBranchCommands::newTreeNeedsSomethingThatVaries()
{
    Document document;
    document.reset(*presetScene("Fern2D"), {}); // its rules have no chances
    for (const char* key : {"variation.angle", "variation.length", "variation.radius"})
        QVERIFY(edit::setParam(document, {1}, *findParam(key), 0.0));
    const int steps = document.undoStack()->count();
    const QByteArray file = fileOf(document);
    QVERIFY(!edit::newTree(document, {1}));
    QCOMPARE(document.undoStack()->count(), steps);
    QCOMPARE(fileOf(document), file);
    const ParamDef& rules = *findParam("grammar.rules");
    QVERIFY(edit::setParam(document, {1}, rules, std::string("X -> 1: F | 0: FF"))); // there is one outcome
    QVERIFY(!edit::newTree(document, {1}));
    QVERIFY(edit::setParam(document, {1}, rules, std::string("X -> 1: F | 2: FF")));
    QVERIFY(edit::newTree(document, {1}));
    document.undo();
    QVERIFY(edit::setParam(document, {1}, *findParam("grammar.iterations"), std::int64_t(0)));
    QVERIFY(!edit::newTree(document, {1}));
}

void TestBranchCommands::resetGivesThePresetsValues()
{
    Fixture f;
    Node tree = *presetTree("FanTree");
    tree.id = 9; // replaced
    QVERIFY(edit::insertNodes(f.document, {tree}, noNode, 0));
    const NodeId fan = f.document.scene().nodes().front().id;
    const ParamDef &theta = *findParam("turtle.theta"), &alpha = *findParam("turtle.alpha");
    QVERIFY(edit::setParam(f.document, {fan, 2}, theta, 1.0));
    QVERIFY(edit::setParam(f.document, {fan, 2}, alpha, 1.0));
    const int steps = f.stack.count();
    QVERIFY(edit::resetParams(f.document, {fan, 2}, {&theta, &alpha}, "Reset"));
    QCOMPARE(f.stack.count(), steps + 1);
    QCOMPARE(f.document.scene().find(fan)->params.turtle, presetParams("FanTree")->turtle);
    QCOMPARE(f.document.scene().find(2)->params.turtle, TurtleParams());
    QVERIFY(edit::resetParams(f.document, {fan}, {&theta}, "Reset")); // nothing to do
    QCOMPARE(f.stack.count(), steps + 1);
    QVERIFY(!edit::resetParams(f.document, {1}, {&theta}, "Reset")); // a group has none
    QVERIFY(edit::duplicateNodes(f.document, {fan}));
    QCOMPARE(f.document.scene().find(f.document.selection().activeNode())->preset, std::string("FanTree"));
}

/// Mostly one that the tree has already.
static TreeEdit randomStep(Random& random)
{
    TreeEdit step{.id = 1 + random.below(3), .operation = EditOperation::Bend, .target = {.address = 5}};
    step.rotation = glm::dvec3(random.range(-1, 1), random.range(-1, 1), random.range(-1, 1));
    return step;
}

/// One edit of any kind; most succeed.
static void randomEdit(Document& document, Random& random)
{
    const NodeList nodes = document.scene().nodes();
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
        edit::putTreeEdits(document, pick(), {randomStep(random)}, gesture);
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

/// Values of the mesh and the texture, drags of them, and branches moved apart.
static void randomMeshEdit(Document& document, Random& random, GestureId gesture)
{
    static const std::vector<const ParamDef*> defs = [] {
        std::vector<const ParamDef*> found;
        for (const ParamDef& def : paramTable())
            for (const char* group : {"mesh.", "texture.", "sections."})
                if (std::string(def.key).starts_with(group))
                    found.push_back(&def);
        return found;
    }();
    if (random.below(4) > 0) {
        const ParamDef& def = *defs[random.below(static_cast<std::uint32_t>(defs.size()))];
        edit::setParam(document, {2}, def, test::randomValue(def, random),
                       random.below(2) == 0 ? gesture : 0);
        return;
    }
    edit::putTreeEdits(document, 2, {randomStep(random), randomStep(random)});
}

void TestBranchCommands::editsOfTheMeshUndoToTheSameBytes()
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed, RandomStream::Test);
        Fixture f;
        std::vector<QByteArray> files{fileOf(f.document)}; // that of undo index i
        GestureId gesture = newGesture();
        for (int i = 0; i < 150; ++i) {
            if (random.below(6) == 0)
                gesture = newGesture();
            if (random.below(10) == 0)
                f.document.undo();
            randomMeshEdit(f.document, random, gesture);
            files.resize(static_cast<std::size_t>(f.stack.index()) + 1);
            files.back() = fileOf(f.document);
        }
        QVERIFY(files.size() > 20);
        while (f.stack.canUndo()) {
            f.document.undo();
            QCOMPARE(fileOf(f.document), files[static_cast<std::size_t>(f.stack.index())]);
        }
        for (std::size_t i = 1; i < files.size(); ++i) {
            f.document.redo();
            QCOMPARE(fileOf(f.document), files[i]);
        }
    }
}

void TestBranchCommands::randomEditsUndoAndRedo()
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
                document.undo();
            else
                randomEdit(document, random);
            spent += timer.nsecsElapsed();
            states.resize(static_cast<std::size_t>(document.undoStack()->index()) + 1);
            states.back() = document.scene();
        }
        qInfo("%d edits in %lld us: %d steps, %zu nodes", tries, spent / 1000, document.undoStack()->count(),
              document.scene().nodes().size());
        while (document.undoStack()->canRedo())
            document.redo();
        const QByteArray after = fileOf(document);
        QCOMPARE(document.undoStack()->count(), 1000);
        while (document.undoStack()->canUndo()) {
            const auto index = static_cast<std::size_t>(document.undoStack()->index());
            if (index < states.size())
                QVERIFY(document.scene() == states[index]);
            document.undo();
        }
        QCOMPARE(fileOf(document), before);
        while (document.undoStack()->canRedo())
            document.redo();
        QCOMPARE(fileOf(document), after);
        QVERIFY(recorder.paired());
        QVERIFY(readProject(after));
    }
}

RAMURE_SUITE(TestBranchCommands)

} // namespace tst_commands_branches

#include "tst_commands_branches.moc"
