#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/scene/preset_scene.h"
#include "tests/document/commands_fixture.h"
#include "tests/document/random_scene.h"
#include "tests/support/suite.h"

#include <QElapsedTimer>
#include <map>
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
    void branchBends();
    void turnedBranches();
    void newTrees();
    void newTreeOfEveryPresetIsAnotherTree();
    void newTreeNeedsSomethingThatVaries();
    void resetGivesThePresetsValues();
    void randomEditsUndoAndRedo();
    void editsOfTheMeshUndoToTheSameBytes();
};

void TestBranchCommands::branchRolls()
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
    f.document.undo();
    f.document.undo();
    QCOMPARE(fileOf(f.document), file);
}

void TestBranchCommands::branchBends()
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
    f.document.undo();
    QCOMPARE(fileOf(f.document), bent);
    f.document.undo();
    f.document.undo();
    QCOMPARE(fileOf(f.document), file);
    f.document.redo();
    f.document.redo();
    QCOMPARE(fileOf(f.document), bent);
}

void TestBranchCommands::turnedBranches()
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
    f.document.undo();
    QVERIFY(!f.document.scene().find(2)->params.branches.contains(5));
    f.document.undo();
    QCOMPARE(fileOf(f.document), file);
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
    std::map<std::uint64_t, glm::dvec3> bends;
    for (std::uint32_t i = random.below(4); i > 0; --i)
        bends[random.below(6)] = glm::dvec3(random.range(-1, 1), random.range(-1, 1), random.range(-1, 1));
    edit::setBranchBends(document, 2, bends);
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
