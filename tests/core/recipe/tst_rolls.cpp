#include "tests/support/shaped_tree.h"

namespace tst_rolls {

using namespace ramure;
using namespace ramure::test;

/// Steps that turn cross-sections about their axis.
class TestRolls : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theTipHasNothingToRoll()
    {
        Shaped shaped;
        TreeEdit edit = editOf(EditOperation::Roll, shaped.address[1]);
        edit.from = 1.0;
        QVERIFY(!shaped.make(edit));
        QVERIFY(shaped.params.edits.empty());
    }

    void noWoodMoves()
    {
        Shaped shaped;
        TreeEdit edit = editOf(EditOperation::Roll, shaped.address[1]);
        edit.from = 0.0;
        edit.angleRad = 0.75;
        const Skeleton before = shaped.skeleton();
        QVERIFY(shaped.make(edit));
        const Skeleton after = shaped.skeleton();
        QVERIFY(after.p0 == before.p0 && after.p1 == before.p1 && after.a1 == before.a1);
        QCOMPARE(after.key, before.key);
        QCOMPARE(after.rolls.size(), std::size_t(1));
        QCOMPARE(after.rolls.front().second, 0.75);
        QVERIFY(shaped.make(edit)); // rolls add up
        QCOMPARE(shaped.skeleton().rolls.front().second, 1.5);
    }

    /// What is merged into one branch is two where a roll begins within it.
    void mergingKeepsRolls()
    {
        Shaped shaped;
        const Index branches = shaped.tree().simplified->skeleton.size();
        TreeEdit edit = editOf(EditOperation::Roll, shaped.address[1]);
        edit.angleRad = 0.75;
        for (const double from : {0.0, 0.4}) {
            edit.from = from;
            QVERIFY(shaped.make(edit));
            const TreeResult tree = shaped.tree();
            const Skeleton& merged = tree.simplified->skeleton;
            QCOMPARE(merged.size(), branches + (from > 0.0 ? 1 : 0));
            QCOMPARE(merged.rolls.size(), tree.skeleton->rolls.size());
            for (const auto& [branch, roll] : merged.rolls)
                QVERIFY(std::ranges::count(tree.skeleton->rolls, std::pair(merged.source[branch], roll)) ==
                        1);
            QCOMPARE(merged.rollOfEach().size(), std::size_t(merged.size()));
        }
    }
};

RAMURE_SUITE(TestRolls)

} // namespace tst_rolls

#include "tst_rolls.moc"
