#include "core/math/random.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/hand_bench.h"
#include "tests/support/shaped_tree.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/panels/edits/edit_model.h"
#include "widgets/panels/edits/edits_panel.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>
#include <map>
#include <memory>

namespace tst_edits_panel {

using namespace ramure;

/// The list of what a hand did to a tree.
class TestEditsPanel : public QObject
{
    Q_OBJECT
private:
    struct Bench : test::HandBench
    {
        EditsPanel panel{&document};
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
        [[nodiscard]] QString text(int row, int column = EditModel::Name)
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
        QVERIFY(empty->isVisible());
        QVERIFY(empty->text().contains(QStringLiteral("tree 1"))); // the only one
        bench.document.reset(Scene(), {});
        QVERIFY(empty->text().contains(QStringLiteral("Select a tree")));
    }
    void bendsAreListedChosenAndDeleted()
    {
        Bench bench;
        QVERIFY(edit::turnBranches(bench.document, 1, {{12345, glm::dvec3(0.3)}})); // no such branch
        QCOMPARE(bench.panel.model()->rowCount(), 1);
        QVERIFY(bench.text(0, EditModel::Limb).contains(QStringLiteral("no place")));
        bench.choose(0);
        bench.button("editDelete")->click();
        QCOMPARE(bench.panel.model()->rowCount(), 0);
        QVERIFY(bench.document.scene().find(1)->params.branches.empty());
        bench.shape();
        const Index twig = bench.twig();
        const std::uint64_t name = bench.skeleton().name(twig);
        QVERIFY(edit::setBranchRoll(bench.document, 1, {name}, 0.2));
        QVERIFY(edit::turnBranches(bench.document, 1, {{name, glm::dvec3(0.3)}}));
        bench.grow();
        QCOMPARE(bench.panel.model()->rowCount(), 4);
        QVERIFY(bench.text(3).contains(QStringLiteral("Bend")));
        QVERIFY(!bench.text(3, EditModel::Limb).isEmpty());
        QVERIFY(!(bench.panel.model()->index(3, 0).flags() & (Qt::ItemIsUserCheckable | Qt::ItemIsEditable)));
        bench.choose(3);
        emit bench.panel.view()->clicked(bench.panel.model()->index(3, 0));
        QCOMPARE(bench.document.selection().branches, std::vector<Index>{twig});
        QVERIFY(!bench.button("editUp")->isEnabled() && !bench.button("editCopy")->isEnabled());
        const int steps = bench.steps();
        bench.button("editDelete")->click();
        QCOMPARE(bench.panel.model()->rowCount(), 3);
        QCOMPARE(bench.steps(), steps + 1);
        const auto& branches = bench.document.scene().find(1)->params.branches;
        QVERIFY(branches.at(name).bendRad == glm::dvec3(0.0) && branches.at(name).rollRad == 0.2);
        bench.document.undo();
        QCOMPARE(bench.panel.model()->rowCount(), 4);
        bench.panel.view()->selectAll(); // edits and bends: one step again
        bench.button("editDelete")->click();
        QCOMPARE(bench.panel.model()->rowCount(), 0);
        QCOMPARE(bench.steps(), steps + 1);
    }
    void rowsSayWhatWasDone()
    {
        Bench bench;
        bench.shape();
        QVERIFY(!bench.panel.findChild<EmptyPage*>()->isVisible());
        QCOMPARE(bench.panel.model()->rowCount(), 3);
        QVERIFY(bench.text(0).startsWith(QStringLiteral("Thickness ×")));
        QVERIFY(bench.text(1).startsWith(QStringLiteral("Length ×")));
        QCOMPARE(bench.text(2), QStringLiteral("Leaves off"));
        QVERIFY(!bench.text(0, EditModel::Limb).isEmpty());
        bench.document.undo();
        QCOMPARE(bench.panel.model()->rowCount(), 2);
    }
    void namesAreGiven()
    {
        Bench bench;
        bench.shape();
        const QModelIndex row = bench.panel.model()->index(1, 0);
        QVERIFY(bench.panel.model()->setData(row, QStringLiteral("  Longer  "), Qt::EditRole));
        QCOMPARE(bench.text(1), QStringLiteral("Longer"));
        bench.document.undo();
        QVERIFY(bench.text(1).startsWith(QStringLiteral("Length")));
        QVERIFY(!bench.panel.model()->setData(row, row.data(Qt::EditRole), Qt::EditRole));
    }
    void rowsAreSwitchedOff()
    {
        Bench bench;
        bench.shape();
        const QModelIndex row = bench.panel.model()->index(0, 0);
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
        bench.choose(2);
        QVERIFY(!bench.button("editDown")->isEnabled());
        bench.button("editUp")->click();
        QCOMPARE(bench.text(1), QStringLiteral("Leaves off"));
        QCOMPARE(bench.panel.view()->currentIndex().row(), 1); // it goes with the edit
        QTest::keyClick(bench.panel.view(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(bench.text(2), QStringLiteral("Leaves off"));
        const std::unique_ptr<QMimeData> data(
            bench.panel.model()->mimeData({bench.panel.model()->index(2, 0)}));
        bench.panel.model()->dropMimeData(data.get(), Qt::MoveAction, 0, 0, {});
        QCOMPARE(bench.text(0), QStringLiteral("Leaves off"));
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
        bench.choose(1);
        QTest::keyClick(bench.panel.view(), Qt::Key_Delete);
        QCOMPARE(bench.panel.model()->rowCount(), 2);
        QCOMPARE(bench.document.scene().nodes().size(), std::size_t(1));
        bench.document.undo();
        QCOMPARE(bench.panel.model()->rowCount(), 3);
        bench.panel.view()->selectAll();
        bench.button("editDelete")->click();
        QVERIFY(bench.panel.findChild<EmptyPage*>()->isVisible());
    }
    void aRowSelectsItsBranch()
    {
        Bench bench;
        bench.shape();
        const auto limb = LimbFinder().limb(bench.document, 1, bench.edits().front().target.address);
        bench.choose(0);
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
        QVERIFY(!bench.panel.model()->isLost(0));
        TreeEdit lost = bench.edits().front();
        lost.target.address += 1;
        lost.target.place = {};
        QVERIFY(edit::putTreeEdits(bench.document, 1, {lost}).has_value());
        bench.grow();
        QVERIFY(bench.panel.model()->isLost(0));
        QVERIFY(bench.text(0, EditModel::Limb).contains(QStringLiteral("no place")));
        QVERIFY(!bench.panel.model()->index(0, EditModel::Limb).data(Qt::DecorationRole).isNull());
    }
    void lockedTreesRefuse()
    {
        Bench bench;
        bench.shape();
        QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
        const QSignalSpy refusals(&bench.panel, &EditsPanel::messageRaised);
        bench.choose(0);
        bench.panel.removeSelected();
        QVERIFY(!bench.panel.model()->setData(bench.panel.model()->index(0, 0), Qt::Unchecked,
                                              Qt::CheckStateRole));
        QCOMPARE(refusals.size(), 2);
        QCOMPARE(bench.edits().size(), std::size_t(3));
    }
    void textsAreTranslated()
    {
        const test::InStars stars;
        Bench bench;
        bench.shape();
        QVERIFY(bench.text(2).startsWith(u'★'));
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

void TestEditsPanel::limbsAreCalledByOrderAndPlace()
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
void TestEditsPanel::editsElsewhereRenameNoLimb()
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

RAMURE_SUITE(TestEditsPanel)

} // namespace tst_edits_panel

#include "tst_edits_panel.moc"
