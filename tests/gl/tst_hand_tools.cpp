// The tools that shape trees in the real window: bar, strip, keys, Escape, a pen, menus.
#include "core/qt/session/jobs/recompute.h"
#include "tests/gl/desk.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/hand_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/panels/recipe/recipe_model.h"
#include "widgets/panels/recipe/recipe_panel.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include "widgets/window/tool_box.h"
#include "widgets/window/tool_strip.h"
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QToolButton>

namespace tst_hand_tools {

using namespace ramure;

class TestHandTools : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = test::patience(60'000);
    std::unique_ptr<test::Desk> m_desk;
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    test::FakeChooser m_chooser;
    std::unique_ptr<MainWindow> m_window;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    Viewport* view() { return m_window->viewportHost()->viewport(); }
    HandSettings* hand() { return m_window->viewportHost()->settings()->hand(); }
    ToolBox* bar() { return m_window->findChild<ToolBox*>(); }
    QToolButton* buttonOf(const char* id)
    {
        const QList<QToolButton*> buttons = bar()->buttons();
        const auto found = std::ranges::find(buttons, action(id), &QToolButton::defaultAction);
        return found == buttons.end() ? nullptr : *found;
    }
    ToolStrip* strip() { return m_window->findChild<ToolStrip*>(); }
    NodeId tree() { return m_document->scene().nodes().front().id; }
    const std::vector<TreeEdit>& edits() { return m_document->scene().nodes().front().params.edits; }
    const Skeleton& skeleton() { return m_document->result(tree())->tree.simplified->skeleton; }
    bool isSettled()
    {
        return m_document->isCurrent(tree()) && !view()->work().picture && !view()->work().pick;
    }
    QPoint pixelOf(Index branch, double share)
    {
        const glm::dvec3 at = glm::mix(skeleton().p0[branch], skeleton().p1[branch], share);
        const QSize size = view()->size();
        const auto ndc = view()->camera().project(at, double(size.width()) / size.height());
        return {int(0.5 * (ndc->x + 1.0) * size.width()), int(0.5 * (1.0 - ndc->y) * size.height())};
    }
    /// Not of the trunk.
    Index lastOfALimb()
    {
        LimbFinder finder;
        const TreeAxes& axes = *finder.axes(*m_document, tree());
        Index branch = skeleton().size() - 1;
        while (axes.axes[finder.startOf(*m_document, tree(), branch)->axis].parent == noIndex)
            --branch;
        return branch;
    }
    void key(QKeyCombination key)
    {
        view()->setFocus();
        QTest::keyClick(view(), key.key(), key.keyboardModifiers());
    }

private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
        if (!test::Desk::missing().isEmpty())
            RAMURE_CANNOT_RUN(qPrintable(test::Desk::missing()));
        m_desk = std::make_unique<test::Desk>(); // shortcuts need an active window
    }
    void cleanupTestCase() { m_desk.reset(); }
    void init() { open("en"); }
    void open(const char* language)
    {
        test::failOnAnyWarning();
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
        QVERIFY(m_recompute->waitForFull(patienceMs));
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
    }
    void cleanup()
    {
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_language.reset();
    }

    void oneToolIsChosen()
    {
        QVERIFY(action("tool.select")->isChecked());
        for (const HandToolRow& row : handTools()) {
            const QToolButton* button = buttonOf(row.id);
            QVERIFY2(button, row.id);
            QVERIFY2(!button->toolTip().isEmpty(), row.id);
            for (const char* theme : {"light", "dark"})
                QVERIFY2(QFile::exists(QStringLiteral(":/icons/ramure-%1/scalable/actions/ramure-%2.svg")
                                           .arg(QLatin1String(theme), QLatin1String(row.icon))),
                         row.icon);
            key(row.key);
            QVERIFY2(action(row.id)->isChecked(), row.id);
            QCOMPARE(hand()->tool(), row.tool);
            QVERIFY(!action("tool.select")->isChecked());
            QCOMPARE(strip()->findChild<QLabel*>(QStringLiteral("partTitle"))->text(),
                     action(row.id)->text().remove(u'&'));
        }
        key(Qt::Key_W);
        QVERIFY(action("tool.move")->isChecked());
        QCOMPARE(hand()->tool(), HandTool::None);
        key(Qt::Key_C);
        QVERIFY(!action("tool.move")->isChecked());
        key(Qt::Key_Q);
        QVERIFY(action("tool.select")->isChecked() && hand()->tool() == HandTool::None);
    }
    void allToolsAreSeen()
    {
        QCOMPARE(bar()->buttons().size(), 5 + qsizetype(handTools().size()));
        for (const QToolButton* button : bar()->buttons()) {
            const QString name = button->defaultAction()->objectName();
            QVERIFY2(button->isVisible(), qPrintable(name));
            QVERIFY2(bar()->rect().contains(button->geometry()), qPrintable(name));
        }
        QVERIFY(bar()->geometry().right() < view()->mapTo(m_window->centralWidget(), QPoint()).x());
    }
    void escapeLaysTheToolDown()
    {
        m_document->setSelection({{tree()}, tree(), {1}, 1});
        key(Qt::Key_C);
        key(Qt::Key_Escape);
        QCOMPARE(hand()->tool(), HandTool::None);
        QCOMPARE(m_document->selection().branches.size(), std::size_t(1));
        key(Qt::Key_Escape);
        QVERIFY(m_document->selection().branches.empty());
    }
    void theStripHasTheOptionsOfTheTool()
    {
        auto* below = strip()->findChild<QCheckBox*>(QStringLiteral("withBelow"));
        auto* shape = strip()->findChild<QComboBox*>(QStringLiteral("pruneShape"));
        auto* axes = strip()->findChild<QComboBox*>(QStringLiteral("transformSpace"));
        QVERIFY(axes->isVisible() && !below->isVisible() && !shape->isVisible());
        const int height = view()->height();
        key(Qt::Key_L);
        QVERIFY(!axes->isVisible() && below->isVisible());
        QCOMPARE(view()->height(), height); // the picture stays where it is
        below->click();
        QVERIFY(!hand()->options().withBelow);
        key(Qt::Key_P);
        QVERIFY(shape->isVisible() && !below->isVisible());
        shape->setCurrentIndex(1);
        emit shape->activated(1);
        QCOMPARE(hand()->options().shape, EditShapeKind::Box);
        m_window->resize(1280, 800);
        for (const HandToolRow& row : handTools()) {
            hand()->setTool(row.tool);
            for (const QWidget* option : strip()->findChildren<QWidget*>())
                if (option->isVisible() && !option->objectName().isEmpty())
                    QVERIFY2(strip()->width() >= option->mapTo(strip(), option->rect().bottomRight()).x(),
                             row.id);
        }
    }
    void whatHasNoRoomOpensAtTheEnd()
    {
        auto* more = strip()->findChild<QToolButton*>(QStringLiteral("moreOptions"));
        auto* mirrored = strip()->findChild<QCheckBox*>(QStringLiteral("mirrored"));
        key(Qt::Key_X);
        QVERIFY(!more->isVisible());
        m_window->resize(m_window->minimumSizeHint().width(), 800);
        key(Qt::Key_D);
        QTRY_VERIFY(more->isVisible() && !mirrored->isVisible());
        QVERIFY(strip()->rect().contains(more->mapTo(strip(), more->rect().bottomRight())));
        more->click();
        QTRY_VERIFY(mirrored->isVisible());
        mirrored->click();
        QVERIFY(hand()->options().mirrored);
        mirrored->window()->close();
    }
    void aClickCutsAndIsListed()
    {
        key(Qt::Key_C);
        QTest::mouseClick(view(), Qt::LeftButton, {}, pixelOf(0, 0.6));
        QTRY_COMPARE_WITH_TIMEOUT(edits().size(), std::size_t(1), patienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
        auto* panel = m_window->findChild<RecipePanel*>();
        QCOMPARE(panel->model()->rowCount(), 2); // behind the source
        m_document->undo();
        QCOMPARE(panel->model()->rowCount(), 1);
    }
    /// On the trunk, which stands: what hangs from it stays on its side.
    void aLeafGrowsOnTheSideThatIsClicked()
    {
        const auto leavesNow = [&] { return m_document->result(tree())->tree.foliage->leaves; };
        const auto own = leavesNow();
        key(Qt::SHIFT | Qt::Key_V);
        QTest::mouseClick(view(), Qt::LeftButton, {}, pixelOf(0, 0.6));
        QTRY_COMPARE_WITH_TIMEOUT(edits().size(), std::size_t(1), patienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
        const auto leaves = leavesNow();
        QCOMPARE(leaves.size(), own.size() + 1);
        const auto placed = std::ranges::find_if(leaves, [&own](const auto& leaf) {
            return std::ranges::find(own, leaf.position, &std::decay_t<decltype(leaf)>::position) ==
                   own.end();
        });
        QVERIFY(placed != leaves.end());
        const auto level = [](const glm::dvec3& v) { return glm::normalize(glm::dvec2(v.x, v.z)); };
        const glm::dvec3 trunk = glm::mix(skeleton().p0[0], skeleton().p1[0], 0.6);
        QVERIFY(glm::dot(level(placed->position - trunk), level(view()->camera().eye() - trunk)) > 0.9);
    }
    void aPenDrawsByPressure()
    {
        key(Qt::Key_D);
        const QPoint foot = pixelOf(0, 0.5);
        const QPointingDevice pen(QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus,
                                  QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1,
                                  2);
        const auto send = [&](QEvent::Type type, QPoint at, double pressure, Qt::MouseButton button) {
            const QPointF global = view()->mapToGlobal(QPointF(at));
            QTabletEvent event(type, &pen, at, global, pressure, 0, 0, 0, 0, 0, {}, button,
                               type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
            QCoreApplication::sendEvent(view(), &event);
            QVERIFY(!event.isAccepted()); // the mouse event that Qt makes of it follows
        };
        send(QEvent::TabletPress, foot, 0.2, Qt::LeftButton);
        QTest::mousePress(view(), Qt::LeftButton, {}, foot);
        for (int i = 1; i <= 10; ++i) {
            const QPoint at = foot + QPoint(12 * i, -6 * i);
            send(QEvent::TabletMove, at, 0.2, Qt::NoButton);
            QMouseEvent move(QEvent::MouseMove, at, view()->mapToGlobal(QPointF(at)), Qt::NoButton,
                             Qt::LeftButton, {});
            QCoreApplication::sendEvent(view(), &move);
        }
        send(QEvent::TabletRelease, foot + QPoint(120, -60), 0.0, Qt::LeftButton);
        QTest::mouseRelease(view(), Qt::LeftButton, {}, foot + QPoint(120, -60));
        QCOMPARE(edits().size(), std::size_t(1));
        QCOMPARE(edits().front().operation, EditOperation::Draw);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
    }
    void deleteRemovesSelectedBranches()
    {
        const Index last = lastOfALimb();
        m_document->setSelection({{tree()}, tree(), {last}, last});
        key(Qt::Key_Delete);
        QCOMPARE(edits().size(), std::size_t(1));
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
    }
    void theMenuKeepsOnlyALimb()
    {
        QVERIFY(!action("hand.keepSelected")->isEnabled());
        const Index last = lastOfALimb();
        m_document->setSelection({{tree()}, tree(), {last}, last});
        action("hand.toggleLeaves")->trigger();
        QCOMPARE(edits().back().operation, EditOperation::Leaves);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
        action("hand.keepSelected")->trigger();
        QCOMPARE(edits().back().operation, EditOperation::Keep);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patienceMs);
    }
    void theMenusOfABranchHaveTheTools()
    {
        const QList<QAction*> offered = m_window->findChild<HandActions*>()->branchActions();
        QVERIFY(offered.contains(action("hand.keepSelected")) && offered.back()->menu());
        for (const HandToolRow& row : handTools())
            QVERIFY2(offered.back()->menu()->actions().contains(action(row.id)), row.id);
    }
    void textsAndIconsFollow()
    {
        QCOMPARE(action("hand.cut")->text(), QStringLiteral("&Cut"));
        cleanup();
        open("fr");
        key(Qt::Key_P);
        QTRY_COMPARE(strip()->findChild<QLabel*>(QStringLiteral("partTitle"))->text(),
                     QStringLiteral("Tailler en forme"));
        QCOMPARE(strip()->findChild<QComboBox*>(QStringLiteral("pruneShape"))->itemText(1),
                 QStringLiteral("Boîte"));
    }
};

RAMURE_SUITE(TestHandTools)

} // namespace tst_hand_tools

#include "tst_hand_tools.moc"
