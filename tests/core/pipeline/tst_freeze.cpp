#include "core/math/random.h"
#include "core/pipeline/freeze.h"
#include "core/skeleton/packed_skeleton.h"
#include "tests/support/shaped_tree.h"
#include <cstring>

namespace tst_freeze {

using namespace ramure;
using namespace ramure::test;

namespace {

void append(NodeParams& tree, TreeEdit step)
{
    if (step.id == 0)
        step.id = newEditId(tree.edits, step);
    tree.edits.push_back(std::move(step));
}

/// Crooked and heavy, with twigs on its limbs and one limb cut.
NodeParams stacked()
{
    NodeParams tree = plainTree();
    append(tree, newStep(EditOperation::Gnarl));
    append(tree, newStep(EditOperation::Grammar));
    append(tree, newStep(EditOperation::Sag));
    const Skeleton grown = *grownTree(plainTree(), Stage::Skeleton).grown;
    TreeEdit cut = editOf(EditOperation::Cut, axesOf(grown).axes[1].address);
    cut.at = 0.7;
    if (!make(tree, cut))
        qFatal("the limb cannot be cut");
    return tree;
}

NodeParams frozen(const NodeParams& tree, std::size_t count)
{
    NodeParams out = tree;
    auto steps = frozenBehind(tree, count);
    if (!steps)
        qFatal("%s", why(steps).constData());
    out.edits = std::move(*steps);
    return out;
}

std::vector<EditState> states(const NodeParams& tree)
{
    std::vector<EditState> list;
    const TreeResult result = grownTree(tree, Stage::Skeleton);
    for (const EditOutcome& outcome : *result.edits)
        list.push_back(outcome.state);
    return list;
}

} // namespace

/// What steps have made, kept.
class TestFreeze : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenBytesAreRefused()
    {
        const std::string good = packSkeleton(*grownTree(stacked(), Stage::Skeleton).skeleton);
        QVERIFY(unpackSkeleton(good));
        for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 150)
            QVERIFY(!unpackSkeleton(std::string_view(good).substr(0, size)));
        QVERIFY(!unpackSkeleton(good + '\0'));
        constexpr std::size_t head = 7 * sizeof(std::uint32_t);
        std::string circle = good, point = good, count = good;
        std::memset(circle.data() + head, 0x11, 4); // the first branch stands on a later one
        QVERIFY(!unpackSkeleton(circle));
        const double noNumber = std::nan("");
        const std::size_t branches = grownTree(stacked(), Stage::Skeleton).skeleton->size();
        std::memcpy(point.data() + head + 4 * branches, &noNumber, sizeof noNumber);
        QVERIFY(!unpackSkeleton(point));
        std::memset(count.data() + 4, 0xff, 4); // more branches than there is memory for
        QVERIFY(!unpackSkeleton(count));
        Random random(5, RandomStream::Test);
        for (int i = 0; i < test::runs(400); ++i) {
            std::string bytes = good;
            for (int k = 0; k < 3; ++k)
                bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
                    static_cast<char>(1u << random.below(8));
            if (const auto read = unpackSkeleton(bytes)) // whatever is read is a tree
                QCOMPARE(packSkeleton(*read), bytes);
        }
    }

    void bytesGiveTheSameTree()
    {
        std::vector<NodeParams> trees{stacked()};
        for (const char* preset : {"TinyTree", "FanTree", "EnglishOak1995", "ParkTree"})
            trees.push_back(*presetParams(preset));
        for (const NodeParams& params : trees) {
            const Skeleton tree = *grownTree(params, Stage::Skeleton).skeleton;
            const auto read = unpackSkeleton(packSkeleton(tree));
            QVERIFY2(read, why(read).constData());
            QVERIFY(*read == tree);
        }
        QVERIFY(*unpackSkeleton(packSkeleton(Skeleton())) == Skeleton());
    }

    void theTreeStaysWhereverItIsFrozen()
    {
        const NodeParams tree = stacked();
        const TreeResult whole = grownTree(tree);
        for (std::size_t count = 0; count <= tree.edits.size(); ++count) {
            const TreeResult now = grownTree(frozen(tree, count));
            QVERIFY(now.skeleton->p0 == whole.skeleton->p0);
            QVERIFY(now.skeleton->p1 == whole.skeleton->p1);
            QVERIFY(now.skeleton->a1 == whole.skeleton->a1);
            QVERIFY(now.skeleton->parent == whole.skeleton->parent);
            QVERIFY(now.skeleton->sawn == whole.skeleton->sawn);
            for (Index a = 0; a < axesOf(*whole.skeleton).axes.size(); ++a)
                QCOMPARE(axesOf(*now.skeleton).axes[a].address, axesOf(*whole.skeleton).axes[a].address);
        }
    }

    void whatIsAboveDoesNotRun()
    {
        const NodeParams tree = stacked();
        NodeParams held = frozen(tree, 2);
        QCOMPARE(states(held), (std::vector{EditState::Frozen, EditState::Frozen, EditState::ByAddress,
                                            EditState::ByAddress, EditState::ByAddress}));
        const Skeleton before = *grownTree(held, Stage::Skeleton).skeleton;
        NodeParams other = held;
        other.grammar.axiom = "F";
        other.edits[0].enabled = false;
        QVERIFY(*grownTree(other, Stage::Skeleton).skeleton == before);
        QCOMPARE(states(other).front(), EditState::Off);
        other.edits[2].enabled = false; // thawed: a single piece, and no limb to cut
        QCOMPARE(grownTree(other, Stage::Skeleton).grown->size(), Index(1));
        other.edits.erase(other.edits.begin() + 2);
        QCOMPARE(states(other).back(), EditState::Unplaced);
        held.edits.erase(held.edits.begin() + 2);
        QVERIFY(*grownTree(held, Stage::Skeleton).skeleton == *grownTree(tree, Stage::Skeleton).skeleton);
    }

    /// One pipeline, as an editor has: its stages must tell the two trees apart.
    void onePipelineKnowsBoth()
    {
        const NodeParams tree = stacked();
        NodeParams held = frozen(tree, 3), other = tree;
        other.turtle.theta = 0.4;
        NodeParams otherHeld = held;
        otherHeld.turtle.theta = 0.4;
        TreePipeline pipeline;
        const auto of = [&](const NodeParams& params) { return *pipeline.evaluate(params)->skeleton; };
        const Skeleton whole = of(tree);
        QVERIFY(of(held).p1 == whole.p1);
        QVERIFY(of(other).p1 != whole.p1);
        QVERIFY(of(otherHeld).p1 == whole.p1);
        QVERIFY(of(other) == *grownTree(other).skeleton);
        QVERIFY(of(tree) == whole);
    }

    void aTreeIsNotFrozenBelowAFrozenStep()
    {
        const NodeParams held = frozen(stacked(), 3);
        const auto refused = frozenBehind(held, 1);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Invalid);
        QVERIFY(frozenBehind(held, held.edits.size()));
        TreeEdit empty = newStep(EditOperation::Frozen);
        QVERIFY(!checkTreeEdit(empty));
    }

    /// Edits on what sources, drawings and grafts have made find it in the frozen tree too.
    void editsFindWhatStepsHaveMade()
    {
        NodeParams tree = stacked();
        const TreeAxes axes = axesOf(*grownTree(tree, Stage::Skeleton).skeleton);
        for (const Axis& axis : axes.axes) {
            NodeParams edited = tree;
            TreeEdit bend = editOf(EditOperation::Bend, axis.address);
            bend.rotation = {0.2, 0.1, 0.0};
            if (axis.parent == noIndex || !make(edited, bend))
                continue;
            const NodeParams held = frozen(edited, edited.edits.size() - 1);
            QCOMPARE(states(held).back(), EditState::ByAddress);
            QVERIFY(grownTree(held, Stage::Skeleton).skeleton->p1 ==
                    grownTree(edited, Stage::Skeleton).skeleton->p1);
        }
    }
};

RAMURE_SUITE(TestFreeze)

} // namespace tst_freeze

#include "tst_freeze.moc"
