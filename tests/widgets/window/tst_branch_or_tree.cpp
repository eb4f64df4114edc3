#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/support/turned_branches.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/window/main_window.h"
#include "widgets/window/view_menu.h"
#include <QStatusBar>
#include <QUndoStack>
#include <algorithm>

namespace tst_branch_or_tree {

using namespace ramure;

/// A click in the view selects a branch and its tree: whatever acts on the tree says so before it does.
class TestBranchOrTree : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language; ///< English, too, has numbers
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    test::FakeChooser m_chooser;
    std::unique_ptr<MainWindow> m_window;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    QString text(const char* id) { return action(id)->text().remove(u'&'); }
    NodeId tree() { return m_document->scene().nodes().front().id; }
    void select(std::vector<NodeId> nodes, std::vector<Index> branches)
    {
        const Index active = branches.empty() ? noIndex : branches.back();
        m_document->setSelection(
            {std::move(nodes), branches.empty() ? noNode : tree(), std::move(branches), active});
    }

private slots:
    void init() { open("en"); }
    void open(const char* language)
    {
        test::failOnWidgetWarning();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->language.set(QLatin1String(language));
        m_language = std::make_unique<Language>(*m_preferences);
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_recompute->setRest(0);
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
    }
    void cleanup()
    {
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_language.reset();
    }

    void deleteOnABranchRemovesIt()
    {
        // As a click in the view selects, and as a row of the Scene panel does.
        for (const auto& nodes : {std::vector{tree()}, std::vector<NodeId>()}) {
            const std::size_t before = m_document->scene().nodes().front().params.edits.size();
            select(nodes, {m_document->result(tree())->tree.simplified->skeleton.size() - 1});
            QVERIFY2(text("edit.delete") == QStringLiteral("Delete 1 branch"),
                     qPrintable(text("edit.delete")));
            m_window->setFocus();
            QTest::keyClick(m_window.get(), Qt::Key_Delete);
            QCOMPARE(m_document->scene().nodes().size(), std::size_t(1));
            QCOMPARE(m_document->scene().nodes().front().params.edits.size(), before + 1);
            QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        }
        while (m_document->undoStack()->canUndo())
            m_document->undo();
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        select({tree()}, {});
        QCOMPARE(text("edit.delete"), QStringLiteral("Delete tree"));
        QTest::keyClick(m_window.get(), Qt::Key_Delete);
        QVERIFY(m_document->scene().nodes().empty());
    }

    void deleteCountsWhatGrowsOnABranchAndTakesNoMore()
    {
        const auto count = [this] { return m_document->result(tree())->tree.simplified->skeleton.size(); };
        const Index all = count();
        // A limb with others on it: those, too, are in the number.
        const auto& parent = m_document->result(tree())->tree.simplified->skeleton.parent;
        const auto child = std::ranges::find_if(parent, [](Index p) { return p != noIndex && p > 0; });
        QVERIFY(child != parent.end());
        const Index limb = *child;
        select({tree()}, {limb});
        const int said = text("edit.delete").section(u' ', 1, 1).toInt();
        QVERIFY2(said > 1 && said < int(all), qPrintable(text("edit.delete")));
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Delete);
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        QVERIFY(count() <= all - Index(said));
        QVERIFY(m_document->selection().nodes.empty() && m_document->selection().branches.empty());
        QTest::keyClick(m_window.get(), Qt::Key_Delete);
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(1));
        m_document->undo();
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        QCOMPARE(count(), all);
        QCOMPARE(m_document->selection().branches, std::vector{limb});
        QCOMPARE(m_document->selection().nodes, std::vector{tree()});
    }
    void whatWasDeletedIsSelectedAgainWhenItIsBack()
    {
        const NodeId node = tree();
        select({node}, {});
        action("edit.delete")->trigger();
        QVERIFY(m_document->selection().nodes.empty());
        m_document->undo();
        QCOMPARE(m_document->selection().nodes, std::vector{node});
        m_document->redo();
        m_document->undo();
        QCOMPARE(m_document->selection().nodes, std::vector{node});
        // Not where another step has taken the place of that one.
        select({}, {});
        QVERIFY(edit::setNodeVisible(*m_document, {node}, false));
        m_document->undo();
        QVERIFY(m_document->selection().nodes.empty());
    }
    void aNewTreeHasNoBranchOfTheOneBefore()
    {
        select({tree()}, {1});
        action("edit.newTree")->trigger();
        QVERIFY(m_document->selection().branches.empty());
        QCOMPARE(m_document->selection().nodes, std::vector{tree()});
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        QVERIFY(m_document->selection().branches.empty());
    }
    void whatActsOnTheTreeSaysTree()
    {
        select({tree()}, {1});
        const std::pair<const char*, const char*> texts[] = {
            {"edit.duplicate", "Duplicate tree"}, {"edit.rename", "Rename tree"},
            {"edit.visible", "Hide tree"},        {"edit.locked", "Lock tree"},
            {"transform.move", "Move tree"},      {"transform.rotate", "Rotate tree"},
            {"transform.scale", "Scale tree"}};
        for (const auto& [id, expected] : texts)
            QCOMPARE(text(id), QLatin1String(expected));
        action("edit.visible")->trigger();
        QCOMPARE(text("edit.visible"), QStringLiteral("Show tree"));
        // New keys keep it, and so does another language.
        m_window->actionSet()->setShortcuts({});
        QCOMPARE(text("transform.move"), QStringLiteral("Move tree"));
        cleanup();
        open("fr");
        select({tree()}, {1});
        QCOMPARE(text("transform.move"), QStringLiteral("Déplacer l’arbre"));
    }

    void theMenuOfTheViewHasWhatIsUnderTheCursor()
    {
        ViewMenuActions actions;
        for (const char* id : {"inspect.show", "inspect.roll", "edit.straighten"})
            actions.branches += action(id);
        actions.gestures += action("transform.move");
        actions.nodes = m_window->edits()->nodeActions();
        actions.steps += action("select.parent");
        actions.isolation += action("select.isolate");
        actions.frameSelection = action("view.frameSelection");
        actions.view += action("view.frameAll");
        actions.add = m_window->edits()->addMenu();
        actions.modes += action("view.mesh");
        actions.switches += action("view.leaves");
        select({tree()}, {1});
        const auto has = [&](const QMenu& menu, const char* id) {
            return menu.actions().contains(action(id));
        };
        const ViewMenu branch(actions, *m_document, tree(), 1, nullptr);
        QVERIFY(has(branch, "inspect.roll") && has(branch, "edit.delete") && has(branch, "transform.move"));
        QVERIFY(!has(branch, "view.leaves"));
        const ViewMenu node(actions, *m_document, tree(), noIndex, nullptr);
        QVERIFY(!has(node, "inspect.roll") && has(node, "edit.rename") && has(node, "view.frameSelection"));
        const ViewMenu nothing(actions, *m_document, noNode, noIndex, nullptr);
        QVERIFY(!has(nothing, "edit.delete") && has(nothing, "view.frameAll") && has(nothing, "view.leaves"));
        QVERIFY(nothing.actions().contains(m_window->edits()->addMenu()->menuAction()));
    }

    void bentBranchesAreStraightenedInOneStep()
    {
        const auto steps =
            test::bends(m_document->result(tree())->tree, m_document->scene().find(tree())->params,
                        {{1, {0.2, 0.0, 0.0}}, {2, {0.0, 0.1, 0.0}}});
        QVERIFY(edit::putTreeEdits(*m_document, tree(), steps));
        QTRY_VERIFY_WITH_TIMEOUT(m_document->isCurrent(tree()), test::patience(20'000));
        select({tree()}, {0});
        QVERIFY(!action("edit.straighten")->isEnabled());
        select({tree()}, {0, 1, 2});
        QVERIFY(action("edit.straighten")->isEnabled());
        action("edit.straighten")->trigger();
        QVERIFY(m_document->scene().nodes().front().params.edits.empty());
        QCOMPARE(m_document->undoStack()->count(), 2);
        QVERIFY(!action("edit.straighten")->isEnabled());
    }

    void otherNodesAreNamedToo()
    {
        m_window->edits()->addKind(kindRow(NodeKind::Group));
        QCOMPARE(text("edit.delete"), QStringLiteral("Delete group"));
        select({tree(), m_document->scene().nodes().back().id}, {});
        QCOMPARE(text("edit.delete"), QStringLiteral("Delete 2 nodes"));
        QCOMPARE(text("edit.rename"), QStringLiteral("Rename")); // only one has a name to edit
        select({}, {});
        QCOMPARE(text("edit.delete"), QStringLiteral("Delete"));
        QVERIFY(!action("edit.delete")->isEnabled());
    }
};

RAMURE_SUITE(TestBranchOrTree)

} // namespace tst_branch_or_tree

#include "tst_branch_or_tree.moc"
