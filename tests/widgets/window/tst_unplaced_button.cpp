// Edits whose branches have gone: counted in the status bar, listed on a click, deleted if wanted.
#include "tests/support/turned_branches.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/dialogs/unplaced_dialog.h"
#include "widgets/window/unplaced_button.h"

#include <QPushButton>
#include <QTreeWidget>

namespace tst_unplaced_button {

using namespace ramure;

class TestUnplacedButton : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

    /// A tree that has lost the branches of three edits.
    static NodeId loseThree(test::TreeDocument& trees)
    {
        const NodeId tree = trees.add(test::smallForks(), "Oak");
        const TreeResult& grown = trees.document().result(tree)->tree;
        const NodeParams params = trees.document().scene().find(tree)->params;
        std::vector<TreeEdit> steps = test::bends(grown, params, {{3, {0.5, 0.0, 0.0}}});
        steps.push_back(test::roll(grown, params, 1, 0.25));
        steps.push_back({.operation = EditOperation::Roll, .target = {.address = 42}, .angleRad = 0.25});
        if (!edit::putTreeEdits(trees.document(), tree, steps) ||
            !edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), std::string("F")) ||
            !trees.compute(tree))
            qFatal("the tree cannot be made");
        return tree;
    }

private slots:
    void init() { test::failOnWidgetWarning(); }

    void thereOnlyWhenNeeded()
    {
        test::TreeDocument trees;
        UnplacedButton button(&trees.document());
        QVERIFY(button.isHidden());
        loseThree(trees);
        QVERIFY(!button.isHidden());
        QVERIFY(button.text().startsWith(QLatin1Char('3')));
        trees.document().reset({}, {});
        QVERIFY(button.isHidden());
    }

    void clicksListThem()
    {
        test::TreeDocument trees;
        loseThree(trees);
        UnplacedButton button(&trees.document());
        button.click();
        auto* dialog = button.findChild<UnplacedDialog*>();
        QVERIFY(dialog);
        auto* list = dialog->findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItemCount(), 3);
        QStringList texts;
        for (int row = 0; row < 3; ++row) {
            QCOMPARE(list->topLevelItem(row)->text(0), QStringLiteral("Oak"));
            texts += list->topLevelItem(row)->text(1) + list->topLevelItem(row)->text(2);
        }
        QCOMPARE(texts.filter(QStringLiteral("by hand")).size(), 1);
        QCOMPARE(texts.filter(QStringLiteral("Bend")).size(), 1);
        QCOMPARE(texts.filter(QStringLiteral("Roll")).size(), 2);
    }

    void deletedOnesComeBackWithUndo()
    {
        test::TreeDocument trees;
        const NodeId tree = loseThree(trees);
        UnplacedDialog dialog(&trees.document());
        dialog.show();
        auto* list = dialog.findChild<QTreeWidget*>();
        QTest::keyClick(list, Qt::Key_Delete); // the first is selected
        QCOMPARE(list->topLevelItemCount(), 2);
        QCOMPARE(trees.document().scene().find(tree)->params.edits.size(), std::size_t{2});
        trees.document().undo();
        QCOMPARE(list->topLevelItemCount(), 3);
        list->clearSelection();
        auto* remove = dialog.findChild<QPushButton*>(QStringLiteral("deleteEdits"));
        QVERIFY(!remove->isEnabled());
        dialog.findChild<QPushButton*>(QStringLiteral("deleteAllEdits"))->click();
        QVERIFY(!dialog.isVisible()); // nothing is left to show
        QVERIFY(trees.document().scene().find(tree)->params.edits.empty());
    }
};

RAMURE_SUITE(TestUnplacedButton)

} // namespace tst_unplaced_button

#include "tst_unplaced_button.moc"
