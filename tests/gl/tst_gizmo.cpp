#include "core/qt/document/commands.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include "widgets/base/hint_source.h"
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>

namespace tst_gizmo {

using namespace ramure;

/// The gizmo, the motion path and the ghosts in a real window, with a mouse and keys. With RAMURE_PICTURES
/// set to a folder, its pictures are left there.
class TestGizmo : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void handlesAreSeen_data();
    void handlesAreSeen();
    void handlesHighlightUnderTheCursor();
    void draggingAHandleMovesInOneStep();
    void rightClickAndEscapeTakeItBack();
    void keysAloneAreEnough();
    void shortcutsWaitForTheEnd();
    void whoeverTakesTheNodeEndsIt();
    void besideTheHandlesOneSelects();
    void keysAreMadeWithAutoKey();
    void pathsAndGhostsAreSeen();
    void playingShowsNoGhosts();
};

namespace {

struct Window
{
    Document document;
    ViewportHost host{&document};
    Viewport* view = host.viewport();
    Player player{&document};
    GizmoSettings* gizmo = host.settings()->gizmo();

    explicit Window(const Scene& scene = boxes())
    {
        document.reset(scene, {});
        view->setPlayer(&player);
        host.resize(800, 600);
        host.show();
        if (!QTest::qWaitForWindowExposed(&host))
            qWarning("the window does not appear");
        view->setFocus();
        waitForPicture();
    }
    static Scene boxes()
    {
        std::vector<Node> nodes(2);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].id = NodeId(i + 1);
            nodes[i].kind = NodeKind::Primitive;
            nodes[i].name = i == 0 ? "box" : "other";
            nodes[i].params.tree.translation = {3.0 * double(i), 0.5, 0.0};
            nodes[i].params.primitive.shape = PrimitiveShape::Box;
        }
        return Scene::fromNodes(nodes).value_or(Scene());
    }
    void select(std::vector<NodeId> nodes) { document.setSelection({std::move(nodes), noNode, {}, noIndex}); }
    void waitForPicture()
    {
        QSignalSpy drawn(view, &Viewport::frameDrawn);
        view->update();
        if (!QTest::qWaitFor([&] { return !drawn.isEmpty() && !view->work().picture; },
                             test::patience(20'000)))
            qWarning("no picture of now comes");
    }
    [[nodiscard]] PickView pick() const
    {
        return {view->camera(), glm::dvec2(view->width(), view->height())};
    }
    [[nodiscard]] QPoint grip(const GizmoHandle& handle) const
    {
        const auto starts =
            transformStarts(document.scene(), document.selection().nodes, player.timeSeconds(), false);
        const GizmoPlace place{pivotOf(starts), transformAxes(starts, gizmo->space())};
        return gizmoGrip(pick(), place, gizmo->tool(), handle).value_or(QPointF()).toPoint();
    }
    [[nodiscard]] glm::dvec3 origin(NodeId id) const
    {
        return glm::dvec3(worldTransformAt(document.scene(), id, player.timeSeconds()).world[3]);
    }
    void keep(const char* name) const
    {
        const QString folder = qEnvironmentVariable("RAMURE_PICTURES");
        if (!folder.isEmpty())
            view->grabFramebuffer().save(folder + u'/' + QLatin1String(name) + QLatin1String(".png"));
    }
    void move(QPoint to, Qt::MouseButton held, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QMouseEvent event(QEvent::MouseMove, to, view->mapToGlobal(QPointF(to)), Qt::NoButton, held,
                          modifiers);
        QApplication::sendEvent(view, &event);
    }
    void drag(QPoint from, QPoint by, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QTest::mousePress(view, Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 5; ++i)
            move(from + by * i / 5, Qt::LeftButton, modifiers);
    }
    void release(QPoint at) const { QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, at); }
};

int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

constexpr GizmoHandle xAxis{GizmoPart::Axis, 0}, yAxis{GizmoPart::Axis, 1};

} // namespace

void TestGizmo::handlesAreSeen_data()
{
    QTest::addColumn<int>("tool");
    QTest::newRow("move") << 1;
    QTest::newRow("rotate") << 2;
    QTest::newRow("scale") << 3;
}

void TestGizmo::handlesAreSeen()
{
    QFETCH(int, tool);
    Window window;
    window.select({1});
    window.waitForPicture();
    const QImage without = window.view->grabFramebuffer();
    window.gizmo->tool.set(static_cast<TransformTool>(tool));
    window.waitForPicture();
    QVERIFY(differing(without, window.view->grabFramebuffer()) > 500);
    window.keep(QTest::currentDataTag());
    window.select({});
    window.gizmo->tool.set(TransformTool::Select);
}

void TestGizmo::handlesHighlightUnderTheCursor()
{
    Window window;
    window.select({1});
    window.gizmo->tool.set(TransformTool::Move);
    window.waitForPicture();
    const QImage rest = window.view->grabFramebuffer();
    window.move(window.grip(yAxis), Qt::NoButton);
    window.waitForPicture();
    QVERIFY(differing(rest, window.view->grabFramebuffer()) > 50);
    QCOMPARE(window.view->cursor().shape(), Qt::SizeAllCursor);
    window.keep("hover");
    window.move({10, 590}, Qt::NoButton);
    QCOMPARE(window.view->cursor().shape(), Qt::ArrowCursor);
}

void TestGizmo::draggingAHandleMovesInOneStep()
{
    for (const int tool : {1, 2, 3}) {
        Window window;
        window.select({1});
        window.gizmo->tool.set(static_cast<TransformTool>(tool));
        const PlacementParams before = window.document.scene().find(1)->params.tree;
        const QPoint from = window.grip(yAxis);
        window.drag(from, {24, -40});
        QVERIFY(window.view->work().transforming);
        window.waitForPicture();
        window.keep(qPrintable(QStringLiteral("dragging-%1").arg(tool)));
        window.release(from + QPoint(24, -40));
        QVERIFY(!window.view->work().transforming);
        QVERIFY(window.document.scene().find(1)->params.tree != before);
        QCOMPARE(window.document.undoStack()->count(), 1);
        window.document.undo();
        QCOMPARE(window.document.scene().find(1)->params.tree, before);
    }
}

void TestGizmo::rightClickAndEscapeTakeItBack()
{
    Window window;
    window.select({1, 2});
    window.gizmo->tool.set(TransformTool::Move);
    const Scene before = window.document.scene();
    const QPoint from = window.grip(xAxis);
    window.drag(from, {50, 10});
    QVERIFY(window.document.scene() != before);
    QTest::mousePress(window.view, Qt::RightButton, Qt::NoModifier, from);
    QVERIFY(!window.view->work().transforming);
    QCOMPARE(window.document.scene(), before);
    window.release(from + QPoint(50, 10));
    window.drag(from, {50, 10});
    QTest::keyClick(window.view, Qt::Key_Escape);
    QCOMPARE(window.document.scene(), before);
    QCOMPARE(window.document.undoStack()->count(), 0);
    window.release(from + QPoint(50, 10));
    QCOMPARE(window.document.selection().nodes.size(), std::size_t(2)); // Esc cleared no selection
}

void TestGizmo::keysAloneAreEnough()
{
    Window window;
    const HintSource* hint = window.view->hints();
    window.view->beginTransform(TransformTool::Move);
    QVERIFY(!window.view->work().transforming); // nothing is selected
    window.select({1});
    window.view->beginTransform(TransformTool::Move);
    QVERIFY(window.view->work().transforming);
    QVERIFY(hint->isGesture());
    QVERIFY2(hint->hint().startsWith(QStringLiteral("Move primitive: ")), qPrintable(hint->hint()));
    QTest::keyClicks(window.view, QStringLiteral("x-1.5"));
    window.waitForPicture();
    window.keep("typed");
    QTest::keyClick(window.view, Qt::Key_Return);
    QVERIFY(!window.view->work().transforming);
    QVERIFY(!hint->isGesture());
    QCOMPARE(window.origin(1), glm::dvec3(-1.5, 0.5, 0.0));
    window.view->beginTransform(TransformTool::Move);
    QTest::keyClicks(window.view, QStringLiteral("1"));
    QTest::keyClick(window.view, Qt::Key_Tab); // goes to no other widget
    QVERIFY(window.view->work().transforming);
    QTest::keyClicks(window.view, QStringLiteral("2"));
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::NoModifier, {400, 300});
    QVERIFY(glm::distance(window.origin(1), {-0.5, 2.5, 0.0}) < 1e-12);
    QCOMPARE(window.document.undoStack()->count(), 2);
    window.view->beginTransform(TransformTool::Rotate);
    window.move({500, 200}, Qt::NoButton);
    window.move({300, 150}, Qt::NoButton); // the mouse, no button
    QVERIFY(window.document.scene().find(1)->params.tree.rotation != glm::dvec3(0.0));
    QTest::mouseClick(window.view, Qt::RightButton, Qt::NoModifier, {300, 150});
    QCOMPARE(window.document.scene().find(1)->params.tree.rotation, glm::dvec3(0.0));
}

void TestGizmo::shortcutsWaitForTheEnd()
{
    Window window;
    const auto taken = [&window] { // what Qt asks before it looks for shortcuts
        QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_1, Qt::NoModifier, QStringLiteral("1"));
        event.ignore();
        QApplication::sendEvent(window.view, &event);
        return event.isAccepted();
    };
    window.select({1});
    QVERIFY(!taken());
    window.view->beginTransform(TransformTool::Scale);
    QVERIFY(taken());
    QTest::keyClick(window.view, Qt::Key_Enter);
    QVERIFY(!taken());
}

void TestGizmo::whoeverTakesTheNodeEndsIt()
{
    Window window;
    window.select({1});
    window.view->beginTransform(TransformTool::Move);
    QTest::keyClicks(window.view, QStringLiteral("3"));
    window.document.reset(Window::boxes(), {});
    QVERIFY(!window.view->work().transforming);
    window.select({1});
    window.view->beginTransform(TransformTool::Move);
    QVERIFY(edit::removeNodes(window.document, {1}));
    QVERIFY(!window.view->work().transforming);
    QTest::keyClicks(window.view, QStringLiteral("3"));
    QCOMPARE(window.document.undoStack()->count(), 1);
}

void TestGizmo::besideTheHandlesOneSelects()
{
    Window window;
    window.select({1});
    window.gizmo->tool.set(TransformTool::Move);
    const auto at = gizmoPixel(window.pick(), window.origin(2) + glm::dvec3(0, 0.2, 0));
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::NoModifier, at->toPoint());
    QTRY_COMPARE(window.document.selection().activeNode(), NodeId(2));
    QCOMPARE(window.document.undoStack()->count(), 0);
}

void TestGizmo::keysAreMadeWithAutoKey()
{
    Window window(demoScene("MovingCylinder").value_or(Scene()));
    NodeId moving = noNode;
    for (const Node& node : window.document.scene().nodes())
        if (node.animation.movesNode())
            moving = node.id;
    window.player.seek(30);
    QVERIFY(window.player.waitForIdle(20'000));
    window.select({moving});
    AutoKey keys(&window.document, &window.player);
    keys.setOn(true);
    window.view->setKeys(&keys);
    window.view->beginTransform(TransformTool::Move);
    const glm::dvec3 from = window.origin(moving);
    QTest::keyClicks(window.view, QStringLiteral("y2"));
    QTest::keyClick(window.view, Qt::Key_Return);
    QVERIFY(glm::distance(window.origin(moving), from + glm::dvec3(0, 2, 0)) < 1e-9);
    QVERIFY(window.document.scene().find(moving)->animation.find(globalChannel(1)));
    QCOMPARE(window.document.scene().find(moving)->params.tree.translation, glm::dvec3(0.0));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(window.player.waitForIdle(20'000));
    window.waitForPicture();
}

void TestGizmo::pathsAndGhostsAreSeen()
{
    Scene scene = Window::boxes();
    Key a, b, c;
    a.time = 0;
    b.time = ticksPerSecond;
    b.value = 3.0;
    c.time = 2 * ticksPerSecond;
    scene.find(1)->animation.set(globalChannel(1), AnyTrack(*Track::fromKeys({a, b, c})));
    b.value = 1.5;
    c.value = 4.0;
    scene.find(1)->animation.set(globalChannel(2), AnyTrack(*Track::fromKeys({a, b, c})));
    TimelineSettings timeline;
    timeline.lastFrame = 48;
    scene.setTimeline(timeline);
    Window window(scene);
    Box box;
    box.add(glm::dvec3(-1, 0, -1));
    box.add(glm::dvec3(4, 5, 5));
    Camera camera = window.view->camera();
    camera.frame(box, window.pick().aspect());
    window.view->setCamera(camera);
    window.player.seek(20);
    QVERIFY(window.player.waitForIdle(20'000));
    window.select({1});
    window.waitForPicture();
    const QImage plain = window.view->grabFramebuffer();
    window.gizmo->showsPath.set(true);
    QTRY_VERIFY(differing(plain, window.view->grabFramebuffer()) > 300);
    window.waitForPicture();
    const QImage path = window.view->grabFramebuffer();
    window.keep("path");
    window.gizmo->showsGhosts.set(true);
    window.waitForPicture();
    window.keep("ghosts");
    QVERIFY(differing(path, window.view->grabFramebuffer()) > 2000);
    window.select({2}); // it does not move: nothing is drawn
    window.waitForPicture();
    window.gizmo->showsGhosts.set(false);
    window.gizmo->showsPath.set(false);
    window.waitForPicture();
    const QImage none = window.view->grabFramebuffer();
    window.gizmo->showsGhosts.set(true);
    window.gizmo->showsPath.set(true);
    window.waitForPicture();
    QCOMPARE(differing(none, window.view->grabFramebuffer()), 0);
}

void TestGizmo::playingShowsNoGhosts()
{
    Window window(demoScene("MovingCylinder").value_or(Scene()));
    window.select({window.document.scene().nodes().front().id});
    window.gizmo->tool.set(TransformTool::Move);
    window.gizmo->showsGhosts.set(true);
    window.player.play();
    QTRY_VERIFY(window.player.frame() > 2);
    QVERIFY(window.player.isPlaying());
    window.view->beginTransform(TransformTool::Move); // stops it
    QVERIFY(!window.player.isPlaying());
    QTest::keyClick(window.view, Qt::Key_Escape);
}

RAMURE_SUITE(TestGizmo)

} // namespace tst_gizmo

#include "tst_gizmo.moc"
