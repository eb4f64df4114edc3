#include "core/math/random.h"
#include "core/qt/session/jobs/unplaced_edits.h"
#include "core/recipe/edit_context.h"
#include "core/skeleton/axes.h"
#include "tests/support/suite.h"
#include "tests/support/turned_branches.h"
#include "tests/widgets/tree_document.h"

namespace tst_branch_places {

using namespace ramure;

namespace {

const std::string twigInFront = "[+F]F[+F[+F][-F][^F]][-F[+F][-F][^F]]_F[+F][-F][^F]";
const std::string axiom = twigInFront.substr(4);

/// A tree in a document that is grown again after each edit.
struct Fixture
{
    Fixture() { tree = trees.add(test::smallForks()); }
    void setAxiom(const std::string& text)
    {
        QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), text));
        QVERIFY(trees.compute(tree));
    }
    [[nodiscard]] const NodeParams& params() { return trees.document().scene().find(tree)->params; }
    void bend(Index branch, const glm::dvec3& bendRad)
    {
        const auto steps = test::bends(trees.document().result(tree)->tree, params(), {{branch, bendRad}});
        QVERIFY(edit::putTreeEdits(trees.document(), tree, steps));
        QVERIFY(trees.compute(tree));
    }
    test::TreeDocument trees;
    NodeId tree = noNode;
};

} // namespace

/// What is set by hand stays on its branch, whatever else grows.
class TestBranchPlaces : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void editsFollowTheirBranches();
    void rollsAreChangedWhereTheirBranchIs();
    void lostOnesAreListedAndComeBack();
    void lostEditsOfLimbsAreListed();
    void selectedBranchesStaySelected();
    void whatIsDoneToOtherLimbsMovesNone();
    void randomEditsUndoToTheSameBytes();
};

void TestBranchPlaces::editsFollowTheirBranches()
{
    Fixture f;
    f.bend(9, {0.3, 0.0, 0.0}); // where the trunk goes on
    const double bent = f.trees.skeleton(f.tree).p1[9].z;
    QVERIFY(std::abs(bent) > 1e-3);
    f.setAxiom(twigInFront);
    QVERIFY(std::abs(f.trees.skeleton(f.tree).p1[10].z - bent) < 1e-9);
    QVERIFY(unplacedEdits(f.trees.document()).empty());
}

void TestBranchPlaces::rollsAreChangedWhereTheirBranchIs()
{
    Fixture f;
    const auto key = [&f](Index branch) { return f.trees.skeleton(f.tree).key[branch]; };
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {key(9)}, 0.5));
    f.setAxiom(twigInFront);
    QCOMPARE(edit::branchRolls(f.trees.document(), f.tree, {key(9), key(10)}),
             (std::vector<double>{0.0, 0.5}));
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {key(10)}, 0.7));
    QCOMPARE(f.params().edits.size(), std::size_t{1});
    QCOMPARE(f.params().edits.front().angleRad, 0.7);
}

void TestBranchPlaces::whatIsDoneToOtherLimbsMovesNone()
{
    Fixture f;
    Document& document = f.trees.document();
    std::vector<std::uint64_t> names;
    for (Index i = 0; i < f.trees.skeleton(f.tree).size(); ++i)
        names.push_back(f.trees.skeleton(f.tree).key[i]);
    const std::vector<Axis> axes = axesOf(*document.result(f.tree)->tree.grown).axes;
    for (std::size_t removed = 1; removed < axes.size(); ++removed) {
        TreeEdit remove;
        remove.operation = EditOperation::Remove;
        remove.target.address = axes[removed].address;
        const auto ids = edit::putTreeEdits(document, f.tree, {remove});
        QVERIFY(ids && f.trees.compute(f.tree));
        const Skeleton& left = f.trees.skeleton(f.tree);
        QVERIFY(left.size() < names.size());
        QVERIFY(std::ranges::all_of(
            left.key, [&names](std::uint64_t key) { return std::ranges::find(names, key) != names.end(); }));
        QVERIFY(edit::removeTreeEdits(document, f.tree, *ids));
    }
}

void TestBranchPlaces::lostOnesAreListedAndComeBack()
{
    Fixture f;
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {f.trees.skeleton(f.tree).key[5]}, 0.5));
    const std::uint64_t id = f.params().edits.front().id;
    f.setAxiom("F");
    QCOMPARE(unplacedEdits(f.trees.document()), (std::vector<UnplacedEdit>{{f.tree, id}}));
    f.setAxiom(axiom);
    QVERIFY(unplacedEdits(f.trees.document()).empty());
    QCOMPARE(f.trees.skeleton(f.tree).rollOfEach()[5], 0.5);
    f.setAxiom("F");
    QVERIFY(edit::removeTreeEdits(f.trees.document(), f.tree, {id}));
    QVERIFY(f.params().edits.empty());
    f.trees.document().undo();
    QCOMPARE(unplacedEdits(f.trees.document()).size(), std::size_t{1});
}

void TestBranchPlaces::lostEditsOfLimbsAreListed()
{
    Fixture f;
    Document& document = f.trees.document();
    const Skeleton& grown = *document.result(f.tree)->tree.grown;
    TreeEdit cut;
    cut.operation = EditOperation::Cut;
    cut.target.address = axesOf(grown).axes[5].address;
    const auto ids = edit::putTreeEdits(document, f.tree, {*EditContext(grown, {}).prepared(cut, true)});
    QVERIFY(ids && f.trees.compute(f.tree));
    QVERIFY(unplacedEdits(document).empty());
    f.setAxiom("F");
    QCOMPARE(unplacedEdits(document), (std::vector<UnplacedEdit>{{f.tree, ids->front()}}));
    f.setAxiom(axiom);
    QVERIFY(unplacedEdits(document).empty());
    f.setAxiom("F");
    QVERIFY(edit::removeTreeEdits(document, f.tree, *ids));
    QVERIFY(unplacedEdits(document).empty());
}

void TestBranchPlaces::selectedBranchesStaySelected()
{
    Fixture f;
    f.trees.select(f.tree, {5, 9}, 9);
    f.setAxiom(twigInFront);
    QCOMPARE(f.trees.document().selection().branches, (std::vector<Index>{6, 10}));
    QCOMPARE(f.trees.document().selection().activeBranch, Index{10});
    f.setAxiom("F[+F]F");
    QVERIFY(f.trees.document().selection().branches.size() < 2);
}

void TestBranchPlaces::randomEditsUndoToTheSameBytes()
{
    Random random(11, RandomStream::Test);
    Fixture f;
    Document& document = f.trees.document();
    const QByteArray before = writeProject(document.project());
    for (int i = 0; i < 60; ++i) {
        const Skeleton& skeleton = f.trees.skeleton(f.tree);
        const Index branch = random.below(skeleton.size());
        switch (random.below(4)) {
        case 0:
            QVERIFY(edit::setBranchRoll(document, f.tree, {skeleton.key[branch]}, 0.1 * random.below(3)));
            break;
        case 1:
            f.bend(branch, {0.1, 0.0, 0.2});
            break;
        case 2:
            f.setAxiom(std::string(random.below(3), 'F') + (random.below(2) == 0 ? "[+F]" : "") + axiom);
            break;
        default:
            if (!f.params().edits.empty())
                QVERIFY(edit::removeTreeEdits(document, f.tree, {f.params().edits.back().id}));
            break;
        }
        QVERIFY(f.trees.compute(f.tree));
    }
    const QByteArray after = writeProject(document.project());
    document.history().goToStep(1); // the first one made the tree
    QCOMPARE(writeProject(document.project()), before);
    document.history().goToStep(document.undoStack()->count());
    QCOMPARE(writeProject(document.project()), after);
}

RAMURE_SUITE(TestBranchPlaces)

} // namespace tst_branch_places

#include "tst_branch_places.moc"
