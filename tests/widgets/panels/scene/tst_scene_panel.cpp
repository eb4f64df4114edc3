#include "tests/widgets/base/fixture.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/scene/scene_model.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/scene_results.h"
#include "widgets/panels/scene/scene_search.h"
#include "widgets/panels/scene/scene_tree.h"
#include <QAbstractItemModelTester>
#include <QHeaderView>
#include <QMouseEvent>

namespace tst_scene_panel {

using namespace ramure;

namespace {

NodeResult twoForks(std::uint64_t firstKey)
{
    auto simplified = std::make_shared<SimplifiedSkeleton>();
    Skeleton& bones = simplified->skeleton;
    const Index parents[] = {noIndex, 0, 0, 1, 1};
    for (Index i = 0; i < 5; ++i) {
        const glm::dvec3 from = parents[i] == noIndex ? glm::dvec3(0.0) : bones.p1[parents[i]];
        bones.add(parents[i], from, from + glm::dvec3(0.1 * i, 1.0, 0.0), 0.1, 0.09,
                  i == 0 ? 0 : 1 + (i - 1) / 2);
        bones.key[i] = firstKey + i;
    }
    NodeResult result;
    result.tree.simplified = std::move(simplified);
    return result;
}

/// Without the cursor of the screen, which other windows may have.
void moveTo(const SceneTree* view, QPoint at)
{
    QMouseEvent move(QEvent::MouseMove, at, view->viewport()->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     {});
    QCoreApplication::sendEvent(view->viewport(), &move);
}

/// A trunk of one branch with a limb of three.
NodeResult limbOfThree()
{
    auto simplified = std::make_shared<SimplifiedSkeleton>();
    Skeleton& bones = simplified->skeleton;
    for (Index i = 0; i < 4; ++i) {
        const double foot = i;
        bones.add(i == 0 ? noIndex : i - 1, {0.0, foot, 0.0}, {0.0, foot + 1.0, 0.0}, 0.1, 0.09,
                  i == 0 ? 0 : 1);
        bones.key[i] = 500 + i;
    }
    NodeResult result;
    result.tree.simplified = std::move(simplified);
    return result;
}

} // namespace

class TestScenePanel : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ScenePanel> m_panel;

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        test::openNodes(*m_document, {test::treeNode(1, "One"), test::treeNode(2, "Two")});
        m_document->setResult(1, twoForks(10));
        m_panel = std::make_unique<ScenePanel>(m_document.get(), m_preferences.get());
        m_panel->resize(420, 300);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
    }

    void lockedNodesSayWhyTheyKeepTheirName()
    {
        QVERIFY(edit::setNodeLocked(*m_document, {1}, true));
        QSignalSpy said(m_panel.get(), &ScenePanel::messageRaised);
        QVERIFY(
            !m_panel->model()->setData(m_panel->model()->nodeIndex(1), QStringLiteral("X"), Qt::EditRole));
        QCOMPARE(said.count(), 1);
    }

    void anEmptySceneSaysWhatToDo()
    {
        SceneTree* view = m_panel->view();
        view->grab();
        QVERIFY(view->accessibleDescription().isEmpty());
        QVERIFY(edit::removeNodes(*m_document, {1, 2}));
        const QImage empty = view->grab().toImage();
        QCOMPARE(view->accessibleDescription(), emptySceneText());
        view->setEmptyText({});
        QVERIFY(view->grab().toImage() != empty);
        m_document->undo();
        view->grab();
        QVERIFY(view->accessibleDescription().isEmpty());
    }

    void selectionGoesBothWays()
    {
        SceneTree* view = m_panel->view();
        QVERIFY(view->selectionModel()->isRowSelected(0, {}));
        view->selectionModel()->setCurrentIndex(
            m_panel->model()->nodeIndex(2), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{2});
        Selection branches;
        branches.branchNode = 1;
        branches.branches = {1, 3};
        branches.activeBranch = 3;
        m_document->setSelection(branches);
        QCOMPARE(view->selectionModel()->selectedRows().size(), 2);
        QCOMPARE(m_panel->model()->branchesAt(view->currentIndex()).front(), Index(3));
        QVERIFY(view->isExpanded(m_panel->model()->branchIndex(1, 1)));
        m_document->setSelection({});
        QVERIFY(view->selectionModel()->selectedRows().isEmpty());
    }

    /// Its row stands for all branches of a limb; one of them has a row below that.
    void axesStandForTheirBranches()
    {
        m_document->setResult(2, limbOfThree());
        SceneTree* view = m_panel->view();
        SceneModel* model = m_panel->model();
        const QModelIndex limb = model->axisIndex(2, 1);
        const auto choose = [&](const QModelIndex& index, QItemSelectionModel::SelectionFlags how) {
            view->selectionModel()->setCurrentIndex(index, how | QItemSelectionModel::Rows);
        };
        choose(limb, QItemSelectionModel::ClearAndSelect);
        QCOMPARE(m_document->selection().branchNode, NodeId(2));
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{1, 2, 3}));
        QCOMPARE(m_document->selection().activeBranch, Index(1));
        choose(model->branchIndex(2, 2), QItemSelectionModel::Select); // with one of its own
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{1, 2, 3}));
        choose(model->index(0, 0, limb), QItemSelectionModel::ClearAndSelect); // "3 branches"
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{1, 2, 3}));
        Selection wanted;
        wanted.branchNode = 2;
        wanted.branches = {2};
        wanted.activeBranch = 2;
        m_document->setSelection(wanted);
        QCOMPARE(view->currentIndex(), model->branchIndex(2, 2));
        QCOMPARE(view->selectionModel()->selectedRows(), QModelIndexList{model->branchIndex(2, 2)});
        QVERIFY(view->isExpanded(limb) && view->isExpanded(model->index(0, 0, limb)));
        wanted.branches = {0, 1, 2, 3};
        wanted.activeBranch = 3;
        m_document->setSelection(wanted);
        QCOMPARE(view->currentIndex(), limb);
        QCOMPARE(view->selectionModel()->selectedRows().size(), 2); // the trunk and the limb
        QCOMPARE(m_document->selection().activeBranch, Index(3));
        // Unfolded they stay unfolded, the single branches, too.
        m_document->setResult(2, NodeResult());
        m_document->setResult(2, limbOfThree());
        const QModelIndex again = model->axisIndex(2, 1);
        QVERIFY(view->isExpanded(again) && view->isExpanded(model->index(0, 0, again)));
    }

    void wordsFindAxes()
    {
        m_document->setResult(2, limbOfThree());
        m_panel->search()->field()->setText(QStringLiteral("limb trunk"));
        const SceneResults* results = m_panel->results();
        QCOMPARE(results->rowCount(), 3); // two of the one tree, one of the other
        QCOMPARE(results->index(2, 0).data().toString(), m_panel->model()->axisIndex(2, 1).data().toString());
        SceneTree* list = m_panel->resultView();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(results->index(2, 0)).center());
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{1, 2, 3}));
        QCOMPARE(list->selectionModel()->selectedRows(), QModelIndexList{results->index(2, 0)});
        // With a condition single branches, each by its whole name.
        m_panel->search()->field()->setText(QStringLiteral("limb trunk number = 2"));
        QCOMPARE(results->rowCount(), 2);
        QCOMPARE(results->index(1, 0).data().toString(),
                 QStringLiteral("Limb 1 of the trunk, 1.0 m up, branch 2 of 3"));
        QCOMPARE(results->index(1, SceneModel::ChildrenColumn).data().toString(), QStringLiteral("1"));
    }

    void pointingGoesBothWays()
    {
        m_document->setResult(2, limbOfThree());
        SceneTree* view = m_panel->view();
        SceneModel* model = m_panel->model();
        std::vector<Index> pointed{noIndex};
        NodeId node = noNode;
        const QObject here; // the panel lives longer than the two
        connect(m_panel.get(), &ScenePanel::pointedAt, &here,
                [&](NodeId of, const std::vector<Index>& branches) {
                    node = of;
                    pointed = branches;
                });
        const auto hover = [view](const QModelIndex& index) {
            moveTo(view, view->visualRect(index).center());
        };
        model->fetchBranches(2); // unfolding fetches nothing
        view->expandRecursively(model->nodeIndex(2));
        QTRY_VERIFY(view->visualRect(model->axisIndex(2, 1)).isValid()); // the rows are laid out
        hover(model->axisIndex(2, 1));
        QCOMPARE(pointed, (std::vector<Index>{1, 2, 3}));
        QCOMPARE(node, NodeId(2));
        hover(model->branchIndex(2, 3));
        QCOMPARE(pointed, std::vector<Index>{3});
        hover(model->nodeIndex(1));
        QCOMPARE(node, NodeId(1));
        QVERIFY(pointed.empty());
        moveTo(view, view->viewport()->rect().bottomRight() - QPoint(3, 3));
        QCOMPARE(node, noNode);
        // From the view: the row, or the one that hides it. Nothing unfolds.
        m_panel->showPointed(2, 3);
        QCOMPARE(view->pointedRow(), model->branchIndex(2, 3));
        view->collapse(model->axisIndex(2, 1));
        m_panel->showPointed(2, 3);
        QCOMPARE(view->pointedRow(), model->axisIndex(2, 1));
        view->collapseAll();
        m_panel->showPointed(2, 3);
        QCOMPARE(view->pointedRow(), model->nodeIndex(2));
        m_panel->showPointed(noNode, noIndex);
        QVERIFY(!view->pointedRow().isValid());
    }

    void keysWalkThroughBranches()
    {
        SceneTree* view = m_panel->view();
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Right); // unfolds the tree
        QTest::keyClick(view, Qt::Key_Right); // goes to its first branch
        QCOMPARE(m_document->selection().branchNode, NodeId(1));
        QCOMPARE(m_document->selection().activeBranch, Index(0));
        QVERIFY(m_document->selection().nodes.empty());
    }

    void unfoldedBranchesStayUnfoldedInTheNextTree()
    {
        SceneModel* model = m_panel->model();
        m_panel->view()->expand(model->nodeIndex(1));
        m_panel->view()->expand(model->branchIndex(1, 0));
        m_panel->view()->expand(model->branchIndex(1, 1));
        m_document->setResult(1, NodeResult());
        m_document->setResult(1, twoForks(10));
        QVERIFY(m_panel->view()->isExpanded(model->branchIndex(1, 0)));
        QVERIFY(m_panel->view()->isExpanded(model->branchIndex(1, 1)));
        m_document->setResult(1, twoForks(900)); // other branches
        QVERIFY(!m_panel->view()->isExpanded(model->branchIndex(1, 0)));
    }

    void eyesAndLocksSwitchWithoutSelecting()
    {
        SceneTree* view = m_panel->view();
        const auto click = [&](NodeId node, SceneModel::Column column) {
            const QRect cell = view->visualRect(m_panel->model()->nodeIndex(node, column));
            QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, cell.center());
        };
        click(2, SceneModel::VisibleColumn);
        QVERIFY(!m_document->scene().find(2)->visible);
        QVERIFY(m_document->scene().find(1)->visible);
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{1});
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        click(2, SceneModel::LockedColumn);
        QVERIFY(m_document->scene().find(1)->locked && m_document->scene().find(2)->locked);
        m_document->undo();
        QVERIFY(!m_document->scene().find(1)->locked && !m_document->scene().find(2)->locked);
    }

    void deletingKeepsTheSelectionOfTheDocument()
    {
        QSignalSpy changed(m_document.get(), &Document::changed);
        QVERIFY(edit::removeNodes(*m_document, {1}));
        const Selection after = m_document->selection();
        QCOMPARE(m_panel->model()->rowCount(), 1);
        m_document->undo();
        QCOMPARE(m_panel->model()->rowCount(), 2);
        for (const NodeId node : after.nodes)
            QVERIFY(m_document->scene().find(node));
    }

    void searchesListAndSelectWhatTheyFind()
    {
        const QAbstractItemModelTester tester(m_panel->results(),
                                              QAbstractItemModelTester::FailureReportingMode::QtTest);
        QLineEdit* field = m_panel->search()->field();
        m_panel->focusSearch();
        QTest::keyClicks(field, "two");
        QVERIFY(m_panel->resultView()->isVisible());
        QCOMPARE(m_panel->results()->nodeCount(), 1);
        QCOMPARE(m_panel->results()->branchCount(), 0);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{2});
        field->setText(QStringLiteral("length >")); // no question yet: the last answer stays
        QCOMPARE(m_panel->results()->rowCount(), 1);
        field->setText(QStringLiteral("terminal"));
        QCOMPARE(m_panel->results()->rowCount(), 3);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->selection().branchNode, NodeId(1));
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{2, 3, 4}));
        QCOMPARE(m_panel->resultView()->selectionModel()->selectedRows().size(), 3);
        m_panel->resultView()->selectionModel()->setCurrentIndex(
            m_panel->results()->index(1, 0), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        QCOMPARE(m_document->selection().branches, std::vector<Index>{3});
        m_document->setResult(1, NodeResult());
        QCOMPARE(m_panel->results()->rowCount(), 0);
        m_document->setResult(1, twoForks(10));
        QCOMPARE(m_panel->results()->rowCount(), 3);
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(m_panel->view()->isVisible());
        QCOMPARE(m_panel->results()->rowCount(), 0);
    }

    void ctrlClicksInResultsKeepWhatIsNotListed()
    {
        Selection before;
        before.nodes = {2};
        before.branchNode = 1;
        before.branches = {0, 2};
        before.activeBranch = 2;
        m_document->setSelection(before);
        m_panel->search()->field()->setText(QStringLiteral("terminal")); // 2, 3, 4
        SceneTree* list = m_panel->resultView();
        const auto click = [&](Index branch, Qt::KeyboardModifiers modifiers) {
            const QModelIndex index = m_panel->results()->branchIndex(1, branch);
            QTest::mouseClick(list->viewport(), Qt::LeftButton, modifiers, list->visualRect(index).center());
        };
        click(3, Qt::ControlModifier);
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{0, 2, 3}));
        QCOMPARE(m_document->selection().activeBranch, Index(3));
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{2});
        click(3, Qt::ControlModifier);
        QCOMPARE(m_document->selection().branches, (std::vector<Index>{0, 2}));
        click(4, {}); // a plain click begins anew
        QCOMPARE(m_document->selection().branches, std::vector<Index>{4});
        QVERIFY(m_document->selection().nodes.empty());
        m_document->setSelection(before);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down, Qt::ControlModifier);
        QTest::keyClick(list, Qt::Key_Space, Qt::ControlModifier);
        QVERIFY(std::ranges::count(m_document->selection().branches, Index(0)) == 1);
    }

    /// What a search does not list is not touched by a command given in its list.
    void commandsInResultsActOnWhatIsListed()
    {
        Selection both;
        both.nodes = {1, 2};
        const auto selectFirst = [this] {
            Selection one;
            one.nodes = {1};
            m_document->setSelection(one);
        };
        QLineEdit* field = m_panel->search()->field();
        SceneTree* list = m_panel->resultView();
        field->setText(QStringLiteral("two"));
        m_document->setSelection(both);
        const QModelIndex eye = m_panel->results()->nodeIndex(2).siblingAtColumn(SceneModel::VisibleColumn);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(eye).center());
        QVERIFY(!m_document->scene().find(2)->visible);
        QVERIFY(m_document->scene().find(1)->visible);
        // Down from the field: the selection is what is seen.
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Down);
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{2});
        selectFirst();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Down);
        QCOMPARE(m_document->selection().nodes, std::vector<NodeId>{2});
        // A click beside the rows selects nothing, also nothing that is not listed.
        selectFirst();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->viewport()->rect().bottomLeft());
        QVERIFY(m_document->selection().nodes.empty());
    }

    void chosenColumnsAreRemembered()
    {
        const auto shown = [](const SceneTree* view) {
            QList<int> columns;
            for (int column = 0; column < SceneModel::columns; ++column)
                if (!view->isColumnHidden(column))
                    columns += column;
            return columns;
        };
        const QList<int> usual{SceneModel::NameColumn, SceneModel::VisibleColumn, SceneModel::LockedColumn,
                               SceneModel::LengthColumn, SceneModel::ChildrenColumn};
        QCOMPARE(shown(m_panel->view()), usual);
        m_panel->chooseColumn(SceneModel::LengthColumn, false);
        m_panel->chooseColumn(SceneModel::OrderColumn, true);
        const QList<int> chosen{SceneModel::NameColumn, SceneModel::VisibleColumn, SceneModel::LockedColumn,
                                SceneModel::ChildrenColumn, SceneModel::OrderColumn};
        for (const SceneTree* view : {m_panel->view(), m_panel->resultView()})
            QCOMPARE(shown(view), chosen);
        const Preferences later;
        ScenePanel another(m_document.get(), m_preferences.get());
        QCOMPARE(shown(another.view()), chosen);
        for (int column = SceneModel::VisibleColumn; column < SceneModel::columns; ++column)
            another.chooseColumn(static_cast<SceneModel::Column>(column), false);
        QCOMPARE(shown(another.view()), QList<int>{SceneModel::NameColumn});
        ScenePanel last(m_document.get(), m_preferences.get());
        QCOMPARE(shown(last.view()), QList<int>{SceneModel::NameColumn});
        QSettings().setValue(QStringLiteral("scene/columns"), QStringLiteral("level,no such column"));
        ScenePanel odd(m_document.get(), m_preferences.get());
        QCOMPARE(shown(odd.view()), QList<int>{SceneModel::NameColumn});
    }

    void thousandsOfBranchesAreSelectedAtOnce()
    {
        auto simplified = std::make_shared<SimplifiedSkeleton>();
        Skeleton& bones = simplified->skeleton;
        for (Index i = 0; i < 20'000; ++i)
            bones.add(i == 0 ? noIndex : (i - 1) / 3, {}, {0.0, 1.0, 0.0}, 0.1, 0.09, i % 5);
        for (Index i = 0; i < bones.size(); ++i)
            bones.key[i] = i + 1;
        NodeResult result;
        result.tree.simplified = std::move(simplified);
        m_document->setResult(2, std::move(result));
        const auto rows = [this] {
            std::size_t count = 0; // of branches: rows may stand for several
            const SceneModel* model = m_panel->model();
            for (const QItemSelectionRange& range : m_panel->view()->selectionModel()->selection())
                for (int row = range.top(); row <= range.bottom(); ++row)
                    count += model->branchesAt(model->index(row, 0, range.parent())).size();
            return count;
        };
        Selection all;
        all.branchNode = 2;
        for (Index i = 0; i < 20'000; ++i)
            all.branches.push_back(i);
        all.activeBranch = 7;
        m_document->setSelection(all);
        QCOMPARE(rows(), std::size_t{20'000});
        QCOMPARE(m_document->selection().branches.size(), std::size_t{20'000});
        all.branches.resize(10'000);
        m_document->setSelection(all);
        QCOMPARE(rows(), std::size_t{10'000});
    }

    void namesAreNeverSqueezedAway()
    {
        m_panel->resize(200, 200);
        m_panel->view()->expandAll();
        SceneTree* view = m_panel->view();
        for (Index branch = 0; branch < 5; ++branch) {
            const QModelIndex index = m_panel->model()->branchIndex(1, branch);
            const int needed =
                view->fontMetrics().horizontalAdvance(index.data().toString()) + view->iconSize().width();
            QTRY_VERIFY2(view->visualRect(index).width() >= needed, qPrintable(index.data().toString()));
        }
    }

    void renamingStartsByAction()
    {
        m_panel->renameActive();
        auto* editor = m_panel->view()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, "Oak");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(m_document->scene().find(1)->name, std::string("Oak"));
    }
};

RAMURE_SUITE(TestScenePanel)

} // namespace tst_scene_panel

#include "tst_scene_panel.moc"
