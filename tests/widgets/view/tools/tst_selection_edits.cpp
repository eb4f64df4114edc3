#include "tests/support/suite.h"
#include "widgets/view/tools/selection_edits.h"

namespace tst_selection_edits {

using namespace ramure;

namespace {

PickHit hitOf(NodeId node, Index branch)
{
    return {node, branch, {}};
}

/// A click on a limb that has only this branch.
Selection afterClick(const Selection& selection, const std::optional<PickHit>& hit, bool extend)
{
    return afterClick(selection, hit, hit ? std::vector{hit->branch} : std::vector<Index>(), extend);
}

Selection selectionOf(std::vector<NodeId> nodes, NodeId branchNode, std::vector<Index> branches, Index active)
{
    return {std::move(nodes), branchNode, std::move(branches), active};
}

} // namespace

class TestSelectionEdits : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void clickOnNothing()
    {
        QCOMPARE(afterClick({}, std::nullopt, false), Selection());
        const Selection some = selectionOf({4}, 4, {1, 2}, 2);
        QCOMPARE(afterClick(some, std::nullopt, false), selectionOf({4}, noNode, {}, noIndex));
        QCOMPARE(afterClick(some, std::nullopt, true), some);
    }
    void clickReplaces()
    {
        const Selection some = selectionOf({4, 5}, 4, {1, 2}, 2);
        QCOMPARE(afterClick(some, hitOf(5, 7), false), selectionOf({5}, 5, {7}, 7));
        QCOMPARE(afterClick(some, hitOf(4, 1), false), selectionOf({4}, 4, {1}, 1));
    }
    void shiftTogglesAndKeepsTheOrder()
    {
        Selection selection;
        for (const Index branch : {5u, 2u, 9u})
            selection = afterClick(selection, hitOf(4, branch), true);
        QCOMPARE(selection, selectionOf({4}, 4, {2, 5, 9}, 9));
        selection = afterClick(selection, hitOf(4, 9), true);
        QCOMPARE(selection, selectionOf({4}, 4, {2, 5}, 5));
        selection = afterClick(selection, hitOf(4, 2), true);
        QCOMPARE(selection, selectionOf({4}, 4, {5}, 5));
        selection = afterClick(selection, hitOf(4, 5), true);
        QCOMPARE(selection, selectionOf({4}, noNode, {}, noIndex));
    }
    void theFirstClickSelectsTheLimbTheSecondTheBranch()
    {
        const std::vector<Index> limb{3, 4, 8}, other{5, 6};
        const Selection whole = selectionOf({4}, 4, limb, 4), alone = selectionOf({4}, 4, {4}, 4);
        QCOMPARE(afterClick({}, hitOf(4, 4), limb, false), whole);
        QCOMPARE(afterClick(whole, hitOf(4, 4), limb, false), alone);
        QCOMPARE(afterClick(alone, hitOf(4, 4), limb, false), whole);
        QCOMPARE(afterClick(whole, hitOf(4, 8), limb, false), selectionOf({4}, 4, {8}, 8));
        QCOMPARE(afterClick(alone, hitOf(4, 5), other, false), selectionOf({4}, 4, other, 5));
        // The same numbers in another tree are other branches.
        QCOMPARE(afterClick(whole, hitOf(6, 4), limb, false), selectionOf({6}, 6, limb, 4));
        const Selection both = afterClick(whole, hitOf(4, 5), other, true);
        QCOMPARE(both, selectionOf({4}, 4, {3, 4, 5, 6, 8}, 5));
        QCOMPARE(afterClick(both, hitOf(4, 3), limb, true), selectionOf({4}, 4, other, 5));
        QCOMPARE(afterClick(both, hitOf(4, 3), limb, false), selectionOf({4}, 4, limb, 3));
        QCOMPARE(afterClick(alone, hitOf(4, 4), limb, true), selectionOf({4}, noNode, {}, noIndex));
    }
    void anotherTreeTakesTheBranchesOver()
    {
        const Selection some = selectionOf({4}, 4, {1, 2}, 2);
        QCOMPARE(afterClick(some, hitOf(6, 3), true), selectionOf({4, 6}, 6, {3}, 3));
    }
    void meshesWithoutBranches()
    {
        QCOMPARE(afterClick(selectionOf({4}, 4, {1}, 1), hitOf(6, noIndex), false),
                 selectionOf({6}, noNode, {}, noIndex));
    }
    void emptyBox()
    {
        const Selection some = selectionOf({4}, 4, {1, 2}, 2);
        QCOMPARE(afterBox(some, {}, false), selectionOf({4}, noNode, {}, noIndex));
        QCOMPARE(afterBox(some, {}, true), some);
    }
    void boxReplacesOrAdds()
    {
        const Selection some = selectionOf({4}, 4, {1, 5}, 5);
        QCOMPARE(afterBox(some, {{4, {2, 3}}}, false), selectionOf({4}, 4, {2, 3}, 2));
        QCOMPARE(afterBox(some, {{4, {2, 5, 8}}}, true), selectionOf({4}, 4, {1, 2, 5, 8}, 5));
    }
    void boxOverSeveralTrees()
    {
        const std::vector<PickedBranches> picked{{4, {1}}, {6, {1, 2, 3}}, {7, {1, 2}}};
        QCOMPARE(afterBox({}, picked, false), selectionOf({4, 7, 6}, 6, {1, 2, 3}, 1));
        QCOMPARE(afterBox(selectionOf({7}, 7, {0}, 0), picked, false), selectionOf({4, 6, 7}, 7, {1, 2}, 1));
        QCOMPARE(afterBox(selectionOf({7}, 7, {0}, 0), picked, true),
                 selectionOf({4, 6, 7}, 7, {0, 1, 2}, 0));
    }
};

RAMURE_SUITE(TestSelectionEdits)

} // namespace tst_selection_edits

#include "tst_selection_edits.moc"
