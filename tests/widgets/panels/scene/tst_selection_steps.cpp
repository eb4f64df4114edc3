#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/scene/node_edits.h"
#include "widgets/panels/scene/selection_steps.h"
#include <algorithm>

namespace tst_selection_steps {

using namespace ramure;

class TestSelectionSteps : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<test::TreeDocument> m_trees;
    NodeId m_tree = noNode;

    Document& document() { return m_trees->document(); }
    std::vector<Index> stepped(std::vector<Index> from, SelectionStep step)
    {
        const Index active = from.back();
        m_trees->select(m_tree, std::move(from), active);
        return afterStep(document(), step).branches;
    }
    QStringList names()
    {
        QStringList all;
        for (const Node& node : document().scene().nodes())
            all += QString::fromStdString(node.name);
        return all;
    }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_trees = std::make_unique<test::TreeDocument>();
        m_tree = m_trees->add(test::smallForks(), "T");
        QVERIFY(m_tree != noNode);
    }

    void nothingSelectedLeadsNowhere()
    {
        document().setSelection({});
        for (const auto step : {SelectionStep::Parent, SelectionStep::Children, SelectionStep::Siblings,
                                SelectionStep::Subtree, SelectionStep::Order})
            QVERIFY(afterStep(document(), step) == Selection());
    }

    void branchesStepByTheirParents()
    {
        const Skeleton& bones = m_trees->skeleton(m_tree);
        for (Index branch = 0; branch < bones.size(); ++branch) {
            std::vector<Index> children, siblings, level, subtree;
            for (Index b = 0; b < bones.size(); ++b) {
                if (bones.parent[b] == branch)
                    children.push_back(b);
                if (bones.parent[b] == bones.parent[branch])
                    siblings.push_back(b);
                if (bones.level[b] == bones.level[branch])
                    level.push_back(b);
                Index up = b;
                while (up != branch && up != noIndex)
                    up = bones.parent[up];
                if (up == branch)
                    subtree.push_back(b);
            }
            const Index parent = bones.parent[branch];
            QCOMPARE(stepped({branch}, SelectionStep::Parent),
                     std::vector<Index>{parent == noIndex ? branch : parent});
            QCOMPARE(stepped({branch}, SelectionStep::Children),
                     children.empty() ? std::vector<Index>{branch} : children);
            QCOMPARE(stepped({branch}, SelectionStep::Siblings), siblings);
            QCOMPARE(stepped({branch}, SelectionStep::Order), level);
            QCOMPARE(stepped({branch}, SelectionStep::Subtree), subtree);
        }
    }

    void theActiveBranchIsFollowed()
    {
        const Skeleton& bones = m_trees->skeleton(m_tree);
        m_trees->select(m_tree, {0}, 0);
        const Index child = afterStep(document(), SelectionStep::Children).activeBranch;
        QCOMPARE(bones.parent[child], Index{0});
        m_trees->select(m_tree, {child}, child);
        QCOMPARE(afterStep(document(), SelectionStep::Parent).activeBranch, Index{0});
    }

    void nodesMoveInTheirRowsAsOneStep()
    {
        const NodeId b = m_trees->addGroup();
        QVERIFY(edit::setNodeName(document(), b, QStringLiteral("B")));
        const NodeId a = m_trees->addGroup();
        QVERIFY(edit::setNodeName(document(), a, QStringLiteral("A")));
        QCOMPARE(names(), QStringList({"A", "B", "T"}));
        const int steps = document().undoStack()->count();
        QVERIFY(edit::shiftNodes(document(), {a, b}, 1));
        QCOMPARE(names(), QStringList({"T", "A", "B"}));
        QCOMPARE(document().undoStack()->count(), steps + 1);
        QVERIFY(edit::shiftNodes(document(), {a, b}, 1)); // they stand at the end
        QCOMPARE(document().undoStack()->count(), steps + 1);
        QVERIFY(edit::shiftNodes(document(), {b}, -1));
        QCOMPARE(names(), QStringList({"T", "B", "A"}));
        document().undo();
        document().undo();
        QCOMPARE(names(), QStringList({"A", "B", "T"}));
        QVERIFY(edit::setNodeLocked(document(), {a}, true));
        const int locked = document().undoStack()->count();
        QVERIFY(!edit::shiftNodes(document(), {a, b}, 1));
        QCOMPARE(document().undoStack()->count(), locked);
        QCOMPARE(names(), QStringList({"A", "B", "T"}));
    }

    void isolatingHidesTheRestAndShowsItAgain()
    {
        const NodeId group = m_trees->addGroup();
        const NodeId inside = m_trees->add(test::smallForks(), "I");
        QVERIFY(edit::moveNode(document(), inside, group, 0, false));
        const auto shown = [&](NodeId id) { return document().scene().isShown(id); };
        const int steps = document().undoStack()->count();
        QVERIFY(edit::isolateNodes(document(), {inside}));
        QVERIFY(shown(inside) && shown(group) && !shown(m_tree));
        QVERIFY(edit::isolateNodes(document(), {m_tree}));
        QVERIFY(!shown(inside) && shown(m_tree));
        QVERIFY(edit::isolateNodes(document(), {m_tree}));
        QVERIFY(shown(inside) && shown(m_tree));
        QCOMPARE(document().undoStack()->count(), steps + 3);
        for (int i = 0; i < 3; ++i)
            document().undo();
        QVERIFY(shown(inside) && shown(group) && shown(m_tree));
    }
};

RAMURE_SUITE(TestSelectionSteps)

} // namespace tst_selection_steps

#include "tst_selection_steps.moc"
