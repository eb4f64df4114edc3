#include "core/math/random.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/hand_bench.h"
#include "tests/support/shaped_tree.h"
#include "tests/support/turned_branches.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/panels/recipe/recipe_model.h"
#include "widgets/panels/recipe/recipe_panel.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>
#include <map>
#include <memory>

namespace tst_recipe_panel {

using namespace ramure;

/// The list of what a hand did to a tree.
class TestRecipePanel : public QObject
{
    Q_OBJECT
private:
    struct Bench : test::HandBench
    {
        RecipePanel panel{&document};
        QAbstractItemModelTester tester{panel.model(),
                                        QAbstractItemModelTester::FailureReportingMode::QtTest};

        explicit Bench(int trees = 1)
            : HandBench(HandTool::None, trees)
        {
            panel.resize(340, 400);
            panel.show();
        }
        /// A cut, thicker limbs, and leaves that are gone.
        void shape()
        {
            document.setSelection({{1}, noNode, {}, noIndex});
            const LimbHit limb = this->limb(twig());
            for (const EditOperation operation :
                 {EditOperation::Thickness, EditOperation::Length, EditOperation::Leaves}) {
                auto gesture = HandEdit::begin(document, 1);
                QVERIFY(gesture.has_value());
                TreeEdit edit;
                edit.operation = operation;
                edit.target.address = limb.address;
                edit.factor = 1.5;
                edit.shown = false;
                QVERIFY((*gesture)->add(edit).has_value());
                QVERIFY((*gesture)->show().has_value());
            }
            grow();
        }
        [[nodiscard]] QString text(int row, int column = RecipeModel::Name)
        {
            return panel.model()->index(row, column).data().toString();
        }
        void choose(int row) { panel.view()->setCurrentIndex(panel.model()->index(row, 0)); }
        QToolButton* button(const char* name) { return panel.findChild<QToolButton*>(QLatin1String(name)); }
        [[nodiscard]] int steps() { return document.undoStack()->count(); }
    };

private slots:
    void init() { test::failOnWidgetWarning(); }
    void limbsAreCalledByOrderAndPlace();
    void editsElsewhereRenameNoLimb();

    void withoutEditsItSaysWhatItIsFor()
    {
        Bench bench;
        auto* empty = bench.panel.findChild<EmptyPage*>();
        QVERIFY(!empty->isVisible()); // the only tree, with its source alone
        QCOMPARE(bench.panel.model()->rowCount(), 1);
        QCOMPARE(bench.text(0), QStringLiteral("Grammar"));
        bench.document.reset(Scene(), {});
        QVERIFY(empty->isVisible());
        QVERIFY(empty->text().contains(QStringLiteral("Select a tree")));
    }
    void bendsOfBranchesAreSteps()
    {
        Bench bench;
        const Index twig = bench.twig();
        const auto steps = test::bends(bench.document.result(1)->tree, bench.document.scene().find(1)->params,
                                       {{twig, glm::dvec3(0.3)}});
        QVERIFY(edit::putTreeEdits(bench.document, 1, steps));
        bench.grow();
        QCOMPARE(bench.panel.model()->rowCount(), 2);
        QCOMPARE(bench.text(1), QStringLiteral("Bend"));
        QVERIFY(!bench.text(1, RecipeModel::Limb).isEmpty());
        QVERIFY(bench.panel.model()->index(1, 0).flags() & Qt::ItemIsUserCheckable);
        bench.choose(1);
        emit bench.panel.view()->clicked(bench.panel.model()->index(1, 0));
        QVERIFY(std::ranges::count(bench.document.selection().branches, twig) == 1);
        bench.button("editDelete")->click();
        QCOMPARE(bench.panel.model()->rowCount(), 1);
    }
    void rowsSayWhatWasDone()
    {
        Bench bench;
        bench.shape();
        QVERIFY(!bench.panel.findChild<EmptyPage*>()->isVisible());
        QCOMPARE(bench.panel.model()->rowCount(), 4);
        QVERIFY(bench.text(1).startsWith(QStringLiteral("Thickness ×")));
        QVERIFY(bench.text(2).startsWith(QStringLiteral("Length ×")));
        QCOMPARE(bench.text(3), QStringLiteral("Leaves off"));
        QVERIFY(!bench.text(1, RecipeModel::Limb).isEmpty());
        bench.document.undo();
        QCOMPARE(bench.panel.model()->rowCount(), 3);
    }
    void stepsHaveValuesAndSayWhere()
    {
        Bench bench;
        TreeEdit sag = newStep(EditOperation::Sag), lost = newStep(EditOperation::Gnarl);
        NodeParams values = *lost.values;
        values.step.where = "order = 9";
        lost.values = StepValues(std::move(values));
        const auto ids = edit::putTreeEdits(bench.document, 1, {sag, lost});
        QVERIFY(ids);
        bench.grow();
        QCOMPARE(bench.text(1), QStringLiteral("Sag"));
        QCOMPARE(bench.text(1, RecipeModel::Limb), QStringLiteral("order > 0"));
        QCOMPARE(bench.text(2, RecipeModel::Limb), QStringLiteral("order = 9"));
        QVERIFY(!bench.panel.model()->isLost(1) && bench.panel.model()->isLost(2));
        QVERIFY(bench.panel.model()
                    ->index(2, 0)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("condition")));
        QSignalSpy chosen(&bench.panel, &RecipePanel::stepChosen);
        bench.choose(1);
        QCOMPARE(chosen.back().at(1).toULongLong(), quint64(ids->front()));
        bench.choose(0);
        QCOMPARE(chosen.back().at(1).toULongLong(), quint64(0));
        QVERIFY(!bench.button("editDelete")->isEnabled());
        QVERIFY(edit::duplicateTreeEdits(bench.document, 1, {ids->front()}));
        QCOMPARE(bench.text(2), QStringLiteral("Sag"));
        QVERIFY(bench.edits()[1].id != bench.edits()[0].id);
    }
    void manyHandEditsHaveOneRow()
    {
        Bench bench;
        const std::uint64_t limb = bench.limb(bench.twig()).address;
        std::vector<TreeEdit> edits(12, test::editOf(EditOperation::Thickness, limb));
        edits.push_back(newStep(EditOperation::Gnarl));
        QVERIFY(edit::putTreeEdits(bench.document, 1, edits));
        bench.grow();
        RecipeModel& model = *bench.panel.model();
        QCOMPARE(model.rowCount(), 3); // the source, the edits, the modifier
        const QModelIndex group = model.index(1, 0);
        QVERIFY(model.isGroup(group) && model.rowCount(group) == 12);
        QVERIFY(bench.text(1).startsWith(QStringLiteral("12 hand edit")));
        QVERIFY(!bench.panel.view()->isExpanded(group));
        QCOMPARE(model.rowOf(bench.edits()[11].id), 12);
        QCOMPARE(model.indexOf(12).parent(), group);
        // One of them off, then all on, as one step.
        QVERIFY(edit::setTreeEditsEnabled(bench.document, 1, {bench.edits()[4].id}, false));
        QCOMPARE(group.data(Qt::CheckStateRole).toInt(), int(Qt::PartiallyChecked));
        const int steps = bench.steps();
        QVERIFY(model.setData(group, Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(group.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QCOMPARE(bench.steps(), steps + 1);
        // Whoever asks for an edit sees it, also behind another change of the list.
        bench.panel.select(bench.edits()[7].id);
        QVERIFY(bench.panel.view()->isExpanded(model.index(1, 0)));
        QVERIFY(edit::removeTreeEdits(bench.document, 1, {bench.edits()[11].id}));
        QVERIFY(bench.panel.view()->isExpanded(model.index(1, 0)));
        // A modifier that is dropped among them parts them.
        const std::unique_ptr<QMimeData> data(model.mimeData({model.index(2, 0)}));
        model.dropMimeData(data.get(), Qt::MoveAction, 3, 0, model.index(1, 0));
        QCOMPARE(bench.edits()[3].operation, EditOperation::Gnarl);
        QCOMPARE(model.rowCount(), 13);
        bench.document.undo();
        bench.choose(1);
        bench.button("editDelete")->click();
        QCOMPARE(bench.edits().size(), std::size_t(1));
    }
    void stepsAreFrozen()
    {
        Bench bench;
        TreeEdit gnarl = newStep(EditOperation::Gnarl);
        QVERIFY(edit::putTreeEdits(bench.document, 1, {gnarl, newStep(EditOperation::Sag)}));
        bench.grow();
        const auto before = bench.skeleton().p1;
        bench.choose(1);
        bench.panel.freeze();
        bench.grow();
        QCOMPARE(bench.panel.model()->rowCount(), 4);
        QCOMPARE(bench.text(2), QStringLiteral("Frozen tree"));
        QVERIFY(bench.panel.model()->isFrozen(0) && bench.panel.model()->isFrozen(1));
        QVERIFY(!bench.panel.model()->isFrozen(2) && !bench.panel.model()->isFrozen(3));
        QVERIFY(!bench.panel.model()->index(1, 0).data(Qt::ForegroundRole).isNull());
        QVERIFY(bench.skeleton().p1 == before);
        bench.document.undo();
        QVERIFY(!bench.panel.model()->isFrozen(0));
    }
    void aRowSelectsTheAxesOfItsCondition()
    {
        Bench bench;
        TreeEdit gnarl = newStep(EditOperation::Gnarl);
        NodeParams values = *gnarl.values;
        values.step.where = "order = 2";
        gnarl.values = StepValues(std::move(values));
        QVERIFY(edit::putTreeEdits(bench.document, 1, {gnarl}));
        bench.grow();
        bench.choose(1);
        bench.panel.selectBranches();
        const std::vector<Index> chosen = bench.document.selection().branches;
        QVERIFY(!chosen.empty() && chosen.size() < bench.skeleton().size());
        const TreeAxes axes = axesOf(*bench.document.result(1)->tree.skeleton);
        for (const Index branch : chosen)
            QCOMPARE(axes.axes[axes.axisOf[bench.skeleton().source[branch]]].order, Index(2));
    }
    void namesAreGiven()
    {
        Bench bench;
        bench.shape();
        const QModelIndex row = bench.panel.model()->index(2, 0);
        QVERIFY(bench.panel.model()->setData(row, QStringLiteral("  Longer  "), Qt::EditRole));
        QCOMPARE(bench.text(2), QStringLiteral("Longer"));
        bench.document.undo();
        QVERIFY(bench.text(2).startsWith(QStringLiteral("Length")));
        QVERIFY(!bench.panel.model()->setData(row, row.data(Qt::EditRole), Qt::EditRole));
    }
    void rowsAreSwitchedOff()
    {
        Bench bench;
        bench.shape();
        const QModelIndex row = bench.panel.model()->index(1, 0);
        QVERIFY(bench.panel.model()->setData(row, Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!bench.edits().front().enabled);
        QCOMPARE(row.data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        bench.document.undo();
        QVERIFY(bench.edits().front().enabled);
    }
    void rowsAreMoved()
    {
        Bench bench;
        bench.shape();
        bench.choose(3);
        QVERIFY(!bench.button("editDown")->isEnabled());
        bench.button("editUp")->click();
        QCOMPARE(bench.text(2), QStringLiteral("Leaves off"));
        QCOMPARE(bench.panel.view()->currentIndex().row(), 2); // it goes with the edit
        QTest::keyClick(bench.panel.view(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(bench.text(3), QStringLiteral("Leaves off"));
        const std::unique_ptr<QMimeData> data(
            bench.panel.model()->mimeData({bench.panel.model()->index(3, 0)}));
        bench.panel.model()->dropMimeData(data.get(), Qt::MoveAction, 0, 0, {});
        QCOMPARE(bench.text(1), QStringLiteral("Leaves off"));
        const int steps = bench.steps();
        QMimeData wrong;
        QVERIFY(!bench.panel.model()->dropMimeData(&wrong, Qt::MoveAction, 0, 0, {}));
        QCOMPARE(bench.steps(), steps);
    }
    void rowsAreDeleted()
    {
        Bench bench;
        bench.shape();
        QVERIFY(!bench.button("editDelete")->isEnabled());
        bench.choose(2);
        QTest::keyClick(bench.panel.view(), Qt::Key_Delete);
        QCOMPARE(bench.panel.model()->rowCount(), 3);
        QCOMPARE(bench.document.scene().nodes().size(), std::size_t(1));
        bench.document.undo();
        QCOMPARE(bench.panel.model()->rowCount(), 4);
        bench.panel.view()->selectAll();
        bench.button("editDelete")->click();
        QCOMPARE(bench.panel.model()->rowCount(), 1); // the source stays
    }
    void aRowSelectsItsBranch()
    {
        Bench bench;
        bench.shape();
        const auto limb = LimbFinder().limb(bench.document, 1, bench.edits().front().target.address);
        bench.choose(1);
        bench.panel.selectBranches();
        QCOMPARE(bench.document.selection().branches, limb);
        QCOMPARE(bench.document.selection().branchNode, NodeId(1));
    }
    void rowsAreCopiedToAnotherTree()
    {
        Bench bench(2);
        bench.shape();
        bench.panel.view()->selectAll();
        QVERIFY(bench.button("editCopy")->isEnabled());
        QMenu* menu = bench.button("editCopy")->menu();
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 1);
        menu->actions().front()->trigger();
        QCOMPARE(bench.edits(2).size(), std::size_t(3));
        bench.document.undo();
        QVERIFY(bench.edits(2).empty());
    }
    void whatHasNoPlaceIsMarked()
    {
        Bench bench;
        bench.shape();
        QVERIFY(!bench.panel.model()->isLost(1));
        TreeEdit lost = bench.edits().front();
        lost.target.address += 1;
        lost.target.place = {};
        QVERIFY(edit::putTreeEdits(bench.document, 1, {lost}).has_value());
        bench.grow();
        QVERIFY(bench.panel.model()->isLost(1));
        QVERIFY(bench.text(1, RecipeModel::Limb).contains(QStringLiteral("no place")));
        QVERIFY(!bench.panel.model()->index(1, RecipeModel::Limb).data(Qt::DecorationRole).isNull());
    }
    void lockedTreesRefuse()
    {
        Bench bench;
        bench.shape();
        QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
        const QSignalSpy refusals(&bench.panel, &RecipePanel::messageRaised);
        bench.choose(1);
        bench.panel.removeSelected();
        QVERIFY(!bench.panel.model()->setData(bench.panel.model()->index(1, 0), Qt::Unchecked,
                                              Qt::CheckStateRole));
        QCOMPARE(refusals.size(), 2);
        QCOMPARE(bench.edits().size(), std::size_t(3));
    }
    void textsAreTranslated()
    {
        const test::InStars stars;
        Bench bench;
        bench.shape();
        QVERIFY(bench.text(3).startsWith(u'★'));
        QVERIFY(bench.button("editDelete")->toolTip().startsWith(u'★'));
    }
};

namespace {

std::map<std::uint64_t, QString> namesByAddress(const TreeResult& tree)
{
    const TreeAxes axes = axesOf(*tree.skeleton);
    const BranchRows rows(tree);
    const BranchNames names;
    std::map<std::uint64_t, QString> all;
    for (Index b = 0; b < tree.simplified->skeleton.size(); ++b)
        all[axes.axes[axes.axisOf[tree.simplified->skeleton.source[b]]].address] =
            names.axis(rows, rows.axisOf(b));
    return all;
}

TreeEdit drawnOn(std::uint64_t parent, double at, const glm::dvec3& to)
{
    TreeEdit edit = test::editOf(EditOperation::Draw, parent);
    edit.at = at;
    edit.points = {{to, 0.0}};
    if (parent == 0)
        edit.points.insert(edit.points.begin(), {{to.x, 0.0, to.z}, 0.0});
    return edit;
}

} // namespace

void TestRecipePanel::limbsAreCalledByOrderAndPlace()
{
    test::Shaped shaped;
    const auto names = namesByAddress(shaped.tree());
    QCOMPARE(names.at(shaped.address[0]), QStringLiteral("Trunk"));
    QCOMPARE(names.at(shaped.address[1]), QStringLiteral("Limb 1 of the trunk, 1.0 m up"));
    QVERIFY(names.at(shaped.address[2]).startsWith(QStringLiteral("Bough 1 of limb 1")));
    QVERIFY(names.at(shaped.address[3]).startsWith(QStringLiteral("Limb 2 of the trunk")));
}

/// Whatever grows or goes beside them, or stands beside the tree. What edits make is called after all that
/// grew.
void TestRecipePanel::editsElsewhereRenameNoLimb()
{
    test::Shaped shaped;
    const auto before = namesByAddress(shaped.tree());
    const auto low = shaped.make(drawnOn(shaped.address[0], 0.1, {1.0, 1.0, 1.0}));
    const auto stem = shaped.make(drawnOn(0, 0.5, {3.0, 2.0, 0.0}));
    QVERIFY(low && stem);
    QVERIFY(shaped.make(test::editOf(EditOperation::Remove, shaped.address[1])));
    const auto after = namesByAddress(shaped.tree());
    for (const std::size_t kept : {0, 3})
        QCOMPARE(after.at(shaped.address[kept]), before.at(shaped.address[kept]));
    QVERIFY(after.at(*low).startsWith(QStringLiteral("Limb 3 of the trunk")));
    QCOMPARE(after.at(*stem), QStringLiteral("Trunk 2"));

    // The same of a tree of many limbs.
    Random random(40, RandomStream::Test);
    NodeParams params = presetParams("SmallTree").value_or(NodeParams());
    const TreeResult grown = test::grownTree(params);
    const auto names = namesByAddress(grown);
    QVERIFY(names.size() > 50);
    const TreeAxes axes = axesOf(*grown.skeleton);
    EditContext context(*grown.grown, {});
    for (int i = 0; i < 12; ++i) {
        const Axis& axis = axes.axes[random.below(static_cast<std::uint32_t>(axes.axes.size()))];
        TreeEdit edit = i % 2 == 0 ? drawnOn(axis.address, random.range(0.1, 0.9), {0.3, 0.4, 0.2})
                                   : test::editOf(EditOperation::Remove, axis.address);
        if (axis.order > 0)
            (void)test::make(params, edit, context); // it may be gone already
    }
    int kept = 0;
    for (const auto& [address, name] : namesByAddress(test::grownTree(params)))
        if (const auto was = names.find(address); was != names.end()) {
            QCOMPARE(name, was->second);
            ++kept;
        }
    QVERIFY(kept > 20);
}

RAMURE_SUITE(TestRecipePanel)

} // namespace tst_recipe_panel

#include "tst_recipe_panel.moc"
