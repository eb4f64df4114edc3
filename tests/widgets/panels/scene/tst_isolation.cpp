// Branches shown alone: a way of looking that survives another computation and has its ways out.
#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/scene/isolation.h"
#include "widgets/window/isolation_button.h"
#include "widgets/window/main_window.h"

namespace tst_isolation {

using namespace ramure;

class TestIsolation : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }

    void nothingIsIsolatedWithoutBranches()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(test::smallForks());
        Isolation isolation(&trees.document());
        QSignalSpy changed(&isolation, &Isolation::changed);
        isolation.toggleSelected();
        isolation.clear();
        trees.selectNode(tree);
        isolation.toggleSelected();
        QVERIFY(!isolation.isActive());
        QCOMPARE(changed.count(), 0);
    }

    void theSameAgainShowsEverything()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(test::smallForks());
        Isolation isolation(&trees.document());
        trees.select(tree, {2, 5}, 5);
        const int steps = trees.document().undoStack()->count();
        isolation.toggleSelected();
        QCOMPARE(isolation.node(), tree);
        QCOMPARE(isolation.branches(), (std::vector<Index>{2, 5}));
        trees.select(tree, {5}, 5);
        isolation.toggleSelected(); // others: those
        QCOMPARE(isolation.branches(), std::vector<Index>{5});
        isolation.toggleSelected();
        QVERIFY(!isolation.isActive());
        QCOMPARE(trees.document().undoStack()->count(), steps); // no edit
    }

    void branchesStayTheSameOnesInAnotherTree()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(test::smallForks());
        Isolation isolation(&trees.document());
        trees.select(tree, {3}, 3);
        const std::uint64_t key = trees.skeleton(tree).key[3];
        isolation.toggleSelected();
        const auto setAxiom = [&](const char* axiom) {
            QVERIFY(
                edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), std::string(axiom)));
            QVERIFY(trees.compute(tree));
        };
        setAxiom("F[+F[+F][-F][^F][+F_F]][-F[+F][-F][^F]]_F[+F][-F][^F]");
        QCOMPARE(isolation.branches().size(), std::size_t{1});
        QCOMPARE(trees.skeleton(tree).key[isolation.branches().front()], key);
        setAxiom("F");
        QVERIFY(isolation.branches().empty()); // shown whole meanwhile
        QVERIFY(isolation.isActive());
        trees.document().undo();
        QVERIFY(trees.compute(tree));
        QCOMPARE(isolation.branches().size(), std::size_t{1});
    }

    void itEndsWithItsTree()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(test::smallForks());
        Isolation isolation(&trees.document());
        trees.select(tree, {1}, 1);
        isolation.toggleSelected();
        QVERIFY(edit::removeNodes(trees.document(), {tree}));
        QVERIFY(!isolation.isActive());
        const NodeId other = trees.add(test::smallForks());
        trees.select(other, {1}, 1);
        isolation.toggleSelected();
        trees.document().reset({}, {});
        QVERIFY(!isolation.isActive());
    }

    void theWindowSaysSoAndOffersTheWayOut()
    {
        Preferences preferences;
        Document document;
        Recompute recompute(&document);
        test::FakeChooser chooser;
        MainWindow window(&document, &recompute, &preferences, &chooser);
        QVERIFY(window.files()->newFromPreset(QStringLiteral("TinyTree")));
        window.show();
        QVERIFY(recompute.waitForFull(test::patience(20'000)));
        auto* button = window.findChild<IsolationButton*>();
        QAction* isolate = window.actionSet()->find(QStringLiteral("select.isolate"));
        QAction* showAll = window.actionSet()->find(QStringLiteral("select.showAll"));
        QVERIFY(button->isHidden());
        QVERIFY(!showAll->isEnabled());
        Selection one;
        one.branchNode = document.scene().nodes().front().id;
        one.branches = {1};
        one.activeBranch = 1;
        document.setSelection(one);
        const int height = window.statusBar()->height();
        isolate->trigger();
        QVERIFY(button->isVisible());
        QCOMPARE(window.statusBar()->height(), height);
        QVERIFY(showAll->isEnabled());
        QVERIFY(!document.isModified());
        button->click();
        QVERIFY(button->isHidden());
        isolate->trigger();
        showAll->trigger();
        QVERIFY(button->isHidden());
        isolate->trigger();
        isolate->trigger();
        QVERIFY(button->isHidden());
        isolate->trigger();
        document.setSelection({});
        QVERIFY(isolate->isEnabled()); // the way back does not hang on the selection
        isolate->trigger();
        QVERIFY(button->isHidden());
    }
};

RAMURE_SUITE(TestIsolation)

} // namespace tst_isolation

#include "tst_isolation.moc"
