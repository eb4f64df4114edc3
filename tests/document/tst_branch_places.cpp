#include "core/math/random.h"
#include "core/qt/session/jobs/unplaced_edits.h"
#include "core/recipe/edit_context.h"
#include "core/skeleton/axes.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"

#include <set>

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
    /// The branch of this name.
    [[nodiscard]] Index branch(std::uint64_t name)
    {
        for (Index i = 0; i < trees.skeleton(tree).size(); ++i)
            if (trees.skeleton(tree).name(i) == name)
                return i;
        return noIndex;
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
    void unknownTreesAndBranches();
    void editsFollowTheirBranches();
    void renamedBranchesAreEditedUnderTheirNames();
    void lostOnesAreListedAndComeBack();
    void lostEditsOfLimbsAreListed();
    void selectedBranchesStaySelected();
    void whatIsDoneToOtherLimbsMovesNone();
    void randomEditsUndoToTheSameBytes();
};

void TestBranchPlaces::unknownTreesAndBranches()
{
    Fixture f;
    QVERIFY(!edit::removeBranchEdits(f.trees.document(), 99, {1}));
    const NodeId group = f.trees.addGroup();
    QVERIFY(!edit::removeBranchEdits(f.trees.document(), group, {1}));
    const int steps = f.trees.document().undoStack()->count();
    QVERIFY(edit::removeBranchEdits(f.trees.document(), f.tree, {1, 2}));
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {f.trees.skeleton(f.tree).name(3)}, 0.0));
    QCOMPARE(f.trees.document().undoStack()->count(), steps); // nothing changed
}

void TestBranchPlaces::editsFollowTheirBranches()
{
    Fixture f;
    const std::uint64_t name = f.trees.skeleton(f.tree).name(9); // where the trunk goes on
    QVERIFY(edit::turnBranches(f.trees.document(), f.tree, {{name, {0.3, 0.0, 0.0}}}));
    QVERIFY(f.trees.compute(f.tree));
    const double bent = f.trees.skeleton(f.tree).p1[9].z;
    QVERIFY(std::abs(bent) > 1e-3);
    f.setAxiom(twigInFront);
    QCOMPARE(f.branch(name), Index{10});
    QVERIFY(std::abs(f.trees.skeleton(f.tree).p1[10].z - bent) < 1e-9);
    QVERIFY(unplacedEdits(f.trees.document()).empty());
}

void TestBranchPlaces::renamedBranchesAreEditedUnderTheirNames()
{
    Fixture f;
    const std::uint64_t name = f.trees.skeleton(f.tree).name(9);
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {name}, 0.5));
    f.setAxiom(twigInFront);
    const Index now = f.branch(name);
    QVERIFY(now != noIndex);
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {f.trees.skeleton(f.tree).name(now)}, 0.7));
    QCOMPARE(f.params().branches.size(), std::size_t{1});
    QCOMPARE(f.params().branches.at(name).rollRad, 0.7);
    // The branch that has the old key has another name now: editing it is another edit.
    for (Index i = 0; i < f.trees.skeleton(f.tree).size(); ++i)
        if (f.trees.skeleton(f.tree).key[i] == name && i != now)
            QVERIFY(f.trees.skeleton(f.tree).name(i) != name);
}

void TestBranchPlaces::whatIsDoneToOtherLimbsMovesNone()
{
    Fixture f;
    Document& document = f.trees.document();
    std::vector<std::uint64_t> names;
    for (Index i = 0; i < f.trees.skeleton(f.tree).size(); ++i)
        names.push_back(f.trees.skeleton(f.tree).key[i]);
    QVERIFY(edit::setBranchRoll(document, f.tree, names, 0.5));
    QVERIFY(f.trees.compute(f.tree));
    const std::vector<Axis> axes = axesOf(*document.result(f.tree)->tree.grown).axes;
    for (std::size_t removed = 1; removed < axes.size(); ++removed) {
        TreeEdit remove;
        remove.operation = EditOperation::Remove;
        remove.target.address = axes[removed].address;
        const auto ids = edit::putTreeEdits(document, f.tree, {remove});
        QVERIFY(ids && f.trees.compute(f.tree));
        const Skeleton& left = f.trees.skeleton(f.tree);
        QVERIFY(left.size() < names.size());
        for (const std::uint64_t name : names)
            if (std::ranges::find(left.key, name) != left.key.end())
                QCOMPARE(left.key[f.branch(name)], name);
        QVERIFY(edit::removeTreeEdits(document, f.tree, *ids));
    }
}

void TestBranchPlaces::lostOnesAreListedAndComeBack()
{
    Fixture f;
    const std::uint64_t name = f.trees.skeleton(f.tree).name(5);
    QVERIFY(edit::setBranchRoll(f.trees.document(), f.tree, {name}, 0.5));
    f.setAxiom("F");
    QCOMPARE(unplacedEdits(f.trees.document()), (std::vector<UnplacedEdit>{{f.tree, name, false}}));
    QCOMPARE(f.params().branches.at(name).rollRad, 0.5); // kept
    f.setAxiom(axiom);
    QVERIFY(unplacedEdits(f.trees.document()).empty());
    QCOMPARE(f.branch(name), Index{5});
    f.setAxiom("F");
    QVERIFY(edit::removeBranchEdits(f.trees.document(), f.tree, {name}));
    QVERIFY(f.params().branches.empty());
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
    QCOMPARE(unplacedEdits(document), (std::vector<UnplacedEdit>{{f.tree, ids->front(), true}}));
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
        const std::uint64_t name = skeleton.name(random.below(skeleton.size()));
        switch (random.below(4)) {
        case 0:
            QVERIFY(edit::setBranchRoll(document, f.tree, {name}, 0.1 * random.below(3)));
            break;
        case 1:
            QVERIFY(edit::turnBranches(document, f.tree, {{name, {0.1, 0.0, 0.2}}}));
            break;
        case 2:
            f.setAxiom(std::string(random.below(3), 'F') + (random.below(2) == 0 ? "[+F]" : "") + axiom);
            break;
        default:
            QVERIFY(edit::removeBranchEdits(document, f.tree, {name}));
            break;
        }
        QVERIFY(f.trees.compute(f.tree));
        std::set<std::uint64_t> names;
        for (Index b = 0; b < f.trees.skeleton(f.tree).size(); ++b)
            names.insert(f.trees.skeleton(f.tree).name(b));
        QCOMPARE(names.size(), std::size_t{f.trees.skeleton(f.tree).size()});
        for (const UnplacedEdit& edit : unplacedEdits(document))
            QVERIFY(f.params().branches.contains(edit.name) && !names.contains(edit.name));
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
