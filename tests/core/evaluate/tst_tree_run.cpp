#include "core/evaluate/tree_run.h"

#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace tst_tree_run {

using namespace ramure;

namespace {

Node oakOf(double age, double day)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = presetParams("EnglishOak").value_or(NodeParams{});
    node.params.growth.age = age;
    node.params.season.day = day;
    return node;
}

void keyEvenly(Node& node, const char* param, double from, double to)
{
    std::vector<Key> keys(2);
    keys[0].mode = keys[1].mode = KeyMode::Linear;
    keys[1].time = ticksOf(2.0);
    keys[0].value = from;
    keys[1].value = to;
    node.animation.set(Channel{ChannelPart::Parameter, 0, paramId(*findParam(param))},
                       AnyTrack(Track::fromKeys(keys).value()));
}

PosedTree posedAt(Evaluator& evaluator, const Node& node, double seconds)
{
    auto posed = evaluator.posedTree(node, Stage::Foliage, seconds, true);
    if (!posed)
        qFatal("%s", posed.error().message().c_str());
    return std::move(*posed);
}

bool areSame(const Foliage& a, const Foliage& b)
{
    return std::ranges::equal(a.leaves, b.leaves, [](const FoliageItem& x, const FoliageItem& y) {
        return x.branch == y.branch && x.number == y.number && x.position == y.position && x.size == y.size &&
               x.tint == y.tint;
    });
}

bool areSame(const NodeMotion& a, const NodeMotion& b)
{
    return a.firstLeaf == b.firstLeaf &&
           std::ranges::equal(*a.bones, *b.bones, [](const RigidTransform& x, const RigidTransform& y) {
               return x.rotation == y.rotation && x.translation == y.translation;
           });
}

} // namespace

/// A moment of a tree is an age, a day and a second.
class TestTreeRun : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void momentsThatAreNoneAreRefused()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        Node node = oakOf(6.0, 200.0);
        QVERIFY(!evaluator.posedTree(node, Stage::Foliage, std::nan(""), true));
        for (const double day : {-1.0, 400.0, std::nan("")}) {
            node.params.season.day = day;
            const auto none = evaluator.posedTree(node, Stage::Foliage, 0.5, true);
            QVERIFY(!none);
            QCOMPARE(QString::fromStdString(none.error().path), QStringLiteral("season.day"));
        }
    }

    /// With keys on all three hands, a frame has what each of them says: in any order of frames, as if it
    /// were the only one.
    void keysOfAllThreeGiveThatMoment()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        Node node = oakOf(6.0, 100.0);
        keyEvenly(node, "growth.age", 6.0, 8.0);
        keyEvenly(node, "season.day", 60.0, 360.0);
        for (const double seconds : {1.5, 0.5, 1.0, 1.5}) {
            const PosedTree now = posedAt(evaluator, node, seconds);
            const Node alone = oakOf(6.0 + seconds, 60.0 + 150.0 * seconds);
            TreePipeline fresh;
            Evaluator other(pipelineSource(fresh));
            const PosedTree then = posedAt(other, alone, seconds);
            QCOMPARE(now.rest.skeleton->size(), then.rest.skeleton->size());
            QVERIFY(areSame(*now.rest.foliage, *then.rest.foliage));
            QVERIFY(areSame(now.motion, then.motion));
            QVERIFY(*now.rest.leaves == *then.rest.leaves);
        }
    }

    /// A day runs no mesher, binds no bark and merges no leaves; a second grows no tree.
    void eachHandMovesItsOwn()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        Node node = oakOf(7.0, 200.0);
        const PosedTree summer = posedAt(evaluator, node, 0.5);
        const PosedTree later = posedAt(evaluator, node, 0.75);
        QVERIFY(later.rest.foliage == summer.rest.foliage && later.rest.skeleton == summer.rest.skeleton);
        QVERIFY(!areSame(later.motion, summer.motion));
        for (const double day : {15.0, 125.0, 300.0, 315.0}) {
            node.params.season.day = day;
            const PosedTree now = posedAt(evaluator, node, 0.75);
            QVERIFY(now.rest.branches == summer.rest.branches && now.rest.placed == summer.rest.placed);
            QVERIFY(now.motion.branches == summer.motion.branches);
            QVERIFY(now.rest.foliage != summer.rest.foliage && !now.rest.leaves.isMade());
            const std::size_t leaves = now.rest.foliage->leaves.size();
            QCOMPARE(now.motion.bones->size(), std::size_t(now.motion.firstLeaf) + leaves);
            QCOMPARE(now.motion.leaves->vertices, now.rest.leaves.vertexCount());
            QCOMPARE(now.rest.leaves->vertexCount(), now.rest.leaves.vertexCount());
            QCOMPARE(now.rest.leaves->faceCount(), now.rest.leaves.faceCount());
        }
        node.params.season.day = 200.0;
        QVERIFY(areSame(posedAt(evaluator, node, 0.75).motion, later.motion));
    }
};

RAMURE_SUITE(TestTreeRun)

} // namespace tst_tree_run

#include "tst_tree_run.moc"
