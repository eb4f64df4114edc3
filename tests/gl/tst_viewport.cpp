#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "tests/support/waits.h"
#include "widgets/base/defect_place.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/scene_builder.h"
#include "widgets/view/screenshot.h"
#include "widgets/view/tools/limb_finder.h"
#include "widgets/view/tools/navigation_cube.h"
#include "widgets/view/view_marks.h"
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWheelEvent>

namespace tst_viewport {

using namespace ramure;

namespace {

/// Trees beside each other, their results already there.
Scene rowOfTrees(int count)
{
    Scene scene;
    for (int i = 0; i < count; ++i) {
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = *presetParams("TinyTree");
        node.params.bark = {}; // brown
        node.params.tree.translation.x = 3.0 * i;
        (void)scene.insert({node}, noNode, i);
    }
    return scene;
}

void compute(Document& document)
{
    TreePipeline pipeline;
    for (const Node& node : document.scene().nodes()) {
        NodeResult result;
        result.revision = document.revision();
        result.tree = *pipeline.evaluate(node.params);
        document.setResult(node.id, std::move(result));
    }
}

struct Window : test::ViewWindow
{
    explicit Window(int trees = 1)
    {
        document.reset(rowOfTrees(trees), {});
        compute(document);
        show({480, 360});
    }
    [[nodiscard]] NodeId tree(std::size_t i) const { return document.scene().nodes()[i].id; }
    [[nodiscard]] const Skeleton& skeleton(std::size_t i = 0) const
    {
        return document.result(tree(i))->tree.simplified->skeleton;
    }
    [[nodiscard]] std::vector<Index> limb(Index branch) const
    {
        return LimbFinder().limbOf(document, tree(0), branch);
    }
    [[nodiscard]] QColor colourAt(const glm::dvec3& world) const
    {
        return view->grabFramebuffer().pixelColor(pixelOf(world) * view->devicePixelRatioF());
    }
    void click(QPoint at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QTest::mouseClick(view, Qt::LeftButton, modifiers, at);
        if (!QTest::qWaitFor([this] { return !view->work().pick; }))
            qWarning("the click has no effect");
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QTest::mousePress(view, button, modifiers, from);
        for (int i = 1; i <= 4; ++i)
            move(QPointF(from) + QPointF(to - from) * i / 4.0, button, modifiers);
        QTest::mouseRelease(view, button, modifiers, to);
        if (!QTest::qWaitFor([this] { return !view->work().pick; }))
            qWarning("the box has no effect");
    }
};

/// Middle of a branch.
glm::dvec3 middle(const Skeleton& skeleton, Index branch)
{
    return 0.5 * (skeleton.p0[branch] + skeleton.p1[branch]);
}

} // namespace

class TestViewport : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }
private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void emptyDocument()
    {
        Document document;
        ViewportHost host(&document);
        host.resize(300, 200);
        host.show();
        QVERIFY(QTest::qWaitForWindowExposed(&host));
        Viewport* view = host.viewport();
        QVERIFY(view);
        const Camera before = view->camera();
        view->frameAll();
        view->frameSelection();
        view->selectAllBranches();
        view->clearSelection();
        QTest::mouseClick(view, Qt::LeftButton, {}, {150, 100});
        QCOMPARE(view->camera(), before);
        QCOMPARE(document.selection(), Selection());
    }
    void treeIsFramedWhenItAppears()
    {
        Window window;
        const glm::dvec3 trunk = middle(window.skeleton(), 0);
        QVERIFY(window.view->rect().contains(window.pixelOf(trunk)));
        const QColor colour = window.colourAt(trunk);
        QVERIFY2(colour.red() > colour.blue() + 20, qPrintable(colour.name()));
        QVERIFY(window.view->frameTimes().frame > 0);
    }
    void cameraStaysWhenParametersChange()
    {
        Window window;
        const Camera before = window.view->camera();
        compute(window.document);
        window.waitForPicture();
        QCOMPARE(window.view->camera(), before);
    }
    void clickSelectsTheBranchUnderIt()
    {
        Window window;
        window.host.settings()->leavesVisible.set(false);
        window.host.settings()->applesVisible.set(false);
        window.waitForPicture();
        window.click(window.pixelOf(middle(window.skeleton(), 0)));
        Selection expected;
        expected.nodes = {window.tree(0)};
        expected.branchNode = window.tree(0);
        expected.branches = window.limb(0);
        expected.activeBranch = 0;
        QCOMPARE(window.document.selection(), expected);
        window.click(window.pixelOf(middle(window.skeleton(), 0))); // the limb first, then the branch
        expected.branches = {0};
        QCOMPARE(window.document.selection(), expected);
        window.click({3, 3});
        QVERIFY(window.document.selection().branches.empty());
        QCOMPARE(window.document.selection().nodes, expected.nodes);
    }
    void everyDisplayModeCanBePicked()
    {
        Window window;
        window.host.settings()->leavesVisible.set(false);
        window.host.settings()->applesVisible.set(false);
        for (const DisplayModeRow& row : displayModes()) {
            window.host.settings()->displayMode.set(row.mode);
            window.waitForPicture();
            window.document.setSelection({});
            window.click(window.pixelOf(middle(window.skeleton(), 0)));
            QVERIFY2(window.document.selection().branches == window.limb(0), row.name());
        }
    }
    void theLineAroundTheSelectionFades()
    {
        Window window;
        const auto ink = [&window](bool again) {
            window.host.settings()->outlineVisible.set(window.host.settings()->outlineVisible() != again);
            window.host.settings()->outlineVisible.set(true);
            const QImage image = window.view->grabFramebuffer();
            int count = 0;
            for (int y = 60; y < image.height(); ++y) // below the words
                for (int x = 0; x < image.width(); ++x)
                    count += image.pixelColor(x, y).red() > 235 && image.pixelColor(x, y).blue() < 60;
            return count;
        };
        QCOMPARE(ink(true), 0);
        window.document.setSelection({{window.tree(0)}, noNode, {}, noIndex});
        QTRY_VERIFY(ink(true) > 40);
        QTRY_COMPARE(ink(false), 0);
    }
    void shiftAddsAndTakesOut()
    {
        Window window;
        window.host.settings()->displayMode.set(DisplayMode::Simplified);
        window.waitForPicture();
        const QPoint first = window.pixelOf(glm::mix(window.skeleton().p0[0], window.skeleton().p1[0], 0.3));
        Index other = 1; // of another limb
        while (std::ranges::count(window.limb(0), other) > 0)
            ++other;
        window.click(first);
        window.click(window.pixelOf(middle(window.skeleton(), other)), Qt::ShiftModifier);
        QCOMPARE(window.document.selection().branches.size(),
                 window.limb(0).size() + window.limb(other).size());
        window.click(first, Qt::ShiftModifier);
        QCOMPARE(window.document.selection().branches, window.limb(other));
    }
    void controlDragBendsTheLimb()
    {
        Window window;
        window.host.settings()->displayMode.set(DisplayMode::Simplified);
        window.waitForPicture();
        const Index tip = window.skeleton().size() - 1;
        const glm::dvec3 end = glm::mix(window.skeleton().p0[tip], window.skeleton().p1[tip], 0.8);
        const QPoint at = window.pixelOf(end);
        window.click(at); // then what is picked in is ready
        window.waitForPicture();
        // With Shift what is thick follows, too: the limb reaches the hand.
        window.drag(at, at + QPoint(25, -10), Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier);
        const QUndoStack* undo = window.document.undoStack();
        QCOMPARE(undo->count(), 1);
        compute(window.document);
        const glm::dvec3 now = glm::mix(window.skeleton().p0[tip], window.skeleton().p1[tip], 0.8);
        const QPoint moved = window.pixelOf(now) - at;
        QVERIFY2((moved - QPoint(25, -10)).manhattanLength() < 12, qPrintable(QString::number(moved.x())));
        window.document.undo();
        compute(window.document);
        window.waitForPicture();
        QCOMPARE(window.document.selection().branches, window.limb(tip));
        window.click(at, Qt::ControlModifier); // again: the branch alone
        QCOMPARE(undo->index(), 0);
        QCOMPARE(window.document.selection().branches, std::vector<Index>{tip});
    }
    void boxSelects()
    {
        Window window;
        window.host.settings()->displayMode.set(DisplayMode::Simplified);
        window.waitForPicture();
        window.drag({1, 1}, {478, 358}, Qt::LeftButton);
        QCOMPARE(window.document.selection().branches.size(), std::size_t(window.skeleton().size()));
        window.drag({1, 1}, {12, 12}, Qt::LeftButton);
        QVERIFY(window.document.selection().branches.empty());
    }
    void hoverIsHeardAndHighlighted()
    {
        Window window;
        window.host.settings()->displayMode.set(DisplayMode::Skeleton);
        window.waitForPicture();
        const QPoint trunk = window.pixelOf(glm::mix(window.skeleton().p0[0], window.skeleton().p1[0], 0.2));
        const QImage before = window.view->grabFramebuffer();
        QSignalSpy hovered(window.view, &Viewport::hovered);
        QTest::mouseMove(window.view, trunk + QPoint(40, 0));
        QTest::mouseMove(window.view, trunk);
        QTRY_VERIFY(!hovered.isEmpty());
        QCOMPARE(hovered.last().at(1).value<Index>(), 0u);
        window.waitForPicture();
        QVERIFY(window.view->grabFramebuffer() != before);
        QVERIFY(!window.view->frameTimes().rebuilt);
    }
    void navigationMovesTheCameraOnly_data()
    {
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("modifiers");
        QTest::newRow("orbit") << int(Qt::MiddleButton) << int(Qt::NoModifier);
        QTest::newRow("pan") << int(Qt::MiddleButton) << int(Qt::ShiftModifier);
        QTest::newRow("zoom") << int(Qt::MiddleButton) << int(Qt::ControlModifier);
        QTest::newRow("trackpad orbit") << int(Qt::LeftButton) << int(Qt::AltModifier);
    }
    void navigationMovesTheCameraOnly()
    {
        QFETCH(int, button);
        QFETCH(int, modifiers);
        Window window;
        const Camera before = window.view->camera();
        QSignalSpy changed(&window.document, &Document::changed);
        window.drag({200, 200}, {260, 170}, Qt::MouseButton(button), Qt::KeyboardModifiers(modifiers));
        QVERIFY(!(window.view->camera() == before));
        QVERIFY(changed.isEmpty());
    }
    void wheelZoomsToTheCursor()
    {
        Window window;
        const QPointF at(120.0, 90.0);
        const double before = window.view->camera().distance;
        const auto turn = [&](int eighths) {
            QWheelEvent event(at, window.view->mapToGlobal(at), {}, {0, eighths}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(window.view, &event);
        };
        turn(240);
        QVERIFY(window.view->camera().distance < before);
        turn(-240);
        QVERIFY(std::abs(window.view->camera().distance - before) < 1e-9);
    }
    void axisViewsAndFraming()
    {
        Window window;
        window.view->steer([](Camera& to) { to.setAxisView(AxisView::Top); });
        QTRY_VERIFY(glm::length(window.view->camera().backward() - glm::dvec3(0, 1, 0)) < 1e-12);
        const double far = window.view->camera().distance;
        Selection selection;
        selection.nodes = {window.tree(0)};
        selection.branchNode = window.tree(0);
        selection.branches = {window.skeleton().size() - 1};
        window.document.setSelection(selection);
        window.view->frameSelection();
        QTRY_VERIFY(window.view->camera().distance < 0.6 * far);
        window.view->frameAll();
        QTRY_VERIFY(window.view->camera().distance > 0.6 * far);
    }
    void cubeTurnsTheView()
    {
        Window window;
        Camera camera = window.view->camera();
        camera.yawRad = 0.3;
        camera.pitchRad = 0.3;
        window.view->setCamera(camera);
        const QRectF place = NavigationCube::place(window.view->size());
        const auto side = NavigationCube::sideAt(camera, window.view->size(), place.center());
        QVERIFY(side);
        window.click(place.center().toPoint());
        camera.setAxisView(*side);
        QTRY_VERIFY(std::abs(window.view->camera().yawRad - camera.yawRad) < 1e-12);
        QVERIFY(window.document.selection().branches.empty());
    }
    void settingsChangeThePicture()
    {
        Window window;
        ViewSettings* settings = window.host.settings();
        const auto shot = [&] {
            window.waitForPicture();
            return window.view->grabFramebuffer();
        };
        QImage last = shot();
        const auto differs = [&](const char* what) {
            const QImage now = shot();
            QVERIFY2(now != last, what);
            last = now;
        };
        settings->leavesVisible.set(false);
        differs("leaves");
        settings->applesVisible.set(false);
        differs("apples");
        settings->gridVisible.set(false);
        differs("grid");
        settings->shadingMode.set(ShadingMode::SolidWire);
        differs("wireframe over solid");
        settings->shadingMode.set(ShadingMode::Wire);
        differs("wireframe");
        settings->displayMode.set(DisplayMode::Skeleton);
        differs("skeleton");
        settings->displayMode.set(DisplayMode::Simplified);
        differs("simplified");
        settings->displayMode.set(DisplayMode::Sections);
        differs("sections");
        settings->frameDisplay.set(FrameDisplay::All);
        differs("frames");
        settings->displayMode.set(DisplayMode::Rough);
        differs("rough");
        settings->orthographic.set(true);
        differs("orthographic");
        QVERIFY(window.view->camera().orthographic);
    }
    void inspectedSectionAndDefectAreMarked()
    {
        Window window;
        const QImage plain = window.pictureAtRest();
        window.view->marks()->inspect(window.tree(0), 0, 1);
        window.waitForPicture();
        QVERIFY(window.view->grabFramebuffer() != plain);
        window.view->marks()->inspect(window.tree(0), 9999, 1);
        window.view->marks()->inspect(noNode, 0, 0);
        QCOMPARE(window.pictureAtRest(), plain);

        DefectPlace place;
        place.points = {middle(window.skeleton(), 0)};
        place.edges = {{window.skeleton().p0[0], window.skeleton().p1[0]}};
        place.box.add(window.skeleton().p0[0]);
        place.box.add(window.skeleton().p1[0]);
        window.view->showDefect(window.tree(0), place);
        QTRY_VERIFY(glm::length(window.view->camera().target - place.box.centre()) < 0.2);
        window.waitForPicture();
        const QColor mark = window.colourAt(place.points[0]);
        QVERIFY2(mark.red() > 150 && mark.green() < 90 && mark.blue() > 90, qPrintable(mark.name()));
        window.click({3, window.view->height() - 3}); // nothing there
        QTRY_VERIFY(window.colourAt(place.points[0]) != mark);
    }
    void lockedAndHiddenTreesCannotBePicked()
    {
        Window window;
        const QPoint trunk = window.pixelOf(middle(window.skeleton(), 0));
        const NodeId id = window.tree(0);
        Change change;
        change.kinds = changeNodeState;
        change.nodes = {id};
        window.document.applyChange(change, [id](Scene& scene) { scene.find(id)->locked = true; });
        window.click(trunk);
        QVERIFY(window.document.selection().branches.empty());
        window.document.applyChange(change, [id](Scene& scene) {
            scene.find(id)->locked = false;
            scene.find(id)->visible = false;
        });
        window.click(trunk);
        QVERIFY(window.document.selection().branches.empty());
    }
    /// Where a tree of the gallery would be let go.
    void whatIsUnderAPlaceIsKnown()
    {
        Window window(2);
        const auto over = [&window](std::size_t i) {
            return window.pixelOf(middle(window.skeleton(i), 0) + glm::dvec3(3.0 * double(i), 0, 0));
        };
        QTRY_VERIFY(window.view->hitAt(over(1)) && window.view->hitAt(over(1))->node == window.tree(1));
        QCOMPARE(window.view->hitAt(over(0)).value().node, window.tree(0));
        QVERIFY(!window.view->hitAt({3, 3}));
    }
    void placementMovesWithoutUploading()
    {
        Window window(2);
        const NodeId id = window.tree(1);
        const QPoint before = window.pixelOf(middle(window.skeleton(1), 0) + glm::dvec3(3.0, 0.0, 0.0));
        Change change;
        change.kinds = changeParams;
        change.nodes = {id};
        window.document.applyChange(change,
                                    [id](Scene& scene) { scene.find(id)->params.tree.translation.x = 30.0; });
        window.waitForPicture(); // until then it is picked where it is seen
        window.click(before);
        QVERIFY(window.document.selection().branches.empty());
    }
    void screenshots()
    {
        Window window;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("tree.png"));
        const auto saved = saveScreenshot(*window.view, path);
        QVERIFY2(saved, test::why(saved));
        QCOMPARE(QImage(path).size(), window.view->size() * window.view->devicePixelRatioF());
        QCOMPARE(saveScreenshot(*window.view, folder.filePath(QStringLiteral("tree.nothing"))).error().code,
                 ErrorCode::Unknown);
        QCOMPARE(
            saveScreenshot(*window.view, folder.filePath(QStringLiteral("no/such/tree.png"))).error().code,
            ErrorCode::Io);
        QCOMPARE(saveScreenshot(*window.view, QStringLiteral("tree")).error().code, ErrorCode::Unknown);
        copyScreenshot(*window.view);
        QCOMPARE(QApplication::clipboard()->image().size(), QImage(path).size());
    }
    void survivesContextLoss()
    {
        // Floating a dock gives the widget another window, and where contexts are not shared another context.
        Document document;
        document.reset(rowOfTrees(1), {});
        compute(document);
        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* host = new ViewportHost(&document, dock);
        dock->setWidget(host);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.resize(500, 400);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QSignalSpy drawn(host->viewport(), &Viewport::frameDrawn);
        host->viewport()->update();
        QTRY_VERIFY(!drawn.isEmpty());
        for (const bool floating : {true, false, true}) {
            dock->setFloating(floating);
            drawn.clear();
            host->viewport()->update();
            QTRY_VERIFY(!drawn.isEmpty());
        }
        const QImage image = host->viewport()->grabFramebuffer();
        QVERIFY(image.pixelColor(image.width() / 2, 2).blue() > 180);
    }
    void edgesOfTheKeyboard()
    {
        Window window;
        const Camera before = window.view->camera();
        window.view->steer([](Camera& to) { to.zoom(0.0, to.target); });
        window.view->steer([](Camera& to) { to.zoom(-1.0, to.target); });
        QTest::keyClick(window.view, Qt::Key_Left, Qt::ControlModifier); // not its own
        QCOMPARE(window.view->camera(), before);
    }
    void arrowKeysOrbit()
    {
        Window window;
        const Camera before = window.view->camera();
        const auto settled = [&](double yaw, double pitch) {
            return QTest::qWaitFor([&] {
                const Camera& now = window.view->camera();
                return std::abs(now.yawRad - before.yawRad - yaw) < 1e-9 &&
                       std::abs(now.pitchRad - before.pitchRad - pitch) < 1e-9;
            });
        };
        QTest::keyClick(window.view, Qt::Key_Right);
        QVERIFY(settled(Viewport::orbitStepRad, 0.0));
        QTest::keyClick(window.view, Qt::Key_Right);
        QTest::keyClick(window.view, Qt::Key_Up); // while the view still turns
        QVERIFY(settled(2.0 * Viewport::orbitStepRad, Viewport::orbitStepRad));
        QTest::keyClick(window.view, Qt::Key_Down);
        QTest::keyClick(window.view, Qt::Key_Left);
        QVERIFY(settled(Viewport::orbitStepRad, 0.0));
    }
    void aFramedViewStaysFramed()
    {
        Window window;
        const auto fresh = [&] {
            Camera camera = window.view->camera();
            const double aspect = double(window.view->width()) / window.view->height();
            const TreeResult& tree = window.document.result(window.tree(0))->tree;
            RenderScene scene = sceneOfMesh(tree.branches->mesh);
            camera.frame(scene.box, aspect);
            return camera.distance;
        };
        const double before = window.view->camera().distance / fresh();
        window.host.resize(300, 600); // as when a panel opens beside it
        window.waitForPicture();
        QVERIFY(std::abs(window.view->camera().distance / fresh() - before) < 0.2 * before);
        const double yaw = window.view->camera().yawRad;
        window.view->steer([](Camera& to) { to.orbit(0.5, 0.0); }); // from now on it is the user's
        QTRY_VERIFY(std::abs(window.view->camera().yawRad - yaw - 0.5) < 1e-9);
        const Camera chosen = window.view->camera();
        window.host.resize(600, 300);
        window.waitForPicture();
        QCOMPARE(window.view->camera(), chosen);
    }
    void onlyWhatIsSeenIsDrawnAgain()
    {
        Window window;
        QTRY_VERIFY(!window.view->work().settling);
        test::letHappen(50); // the picture that follows is painted
        const quint64 before = window.view->frameTimes().frame;
        // A new shape comes with its result; a second opinion on the mesh changes no picture.
        QVERIFY(edit::setParam(window.document, {window.tree(0)}, *findParam("turtle.theta"), 0.5));
        NodeResult same = *window.document.result(window.tree(0));
        same.tree.report = std::make_shared<MeshReport>(*same.tree.report);
        window.document.setResult(window.tree(0), same);
        QVERIFY(!window.view->work().picture);
        test::letHappen(50);
        QCOMPARE(window.view->frameTimes().frame, before);
        compute(window.document);
        QVERIFY(window.view->work().picture);
        QTRY_VERIFY(!window.view->work().picture);
        QVERIFY(window.view->frameTimes().frame > before);
        QVERIFY(
            edit::setParam(window.document, {window.tree(0)}, *findParam("tree.rotation"), glm::dvec3(1.0)));
        QVERIFY(window.view->work().picture); // where it stands needs no result
    }
    void draftsAreShown()
    {
        Window window;
        const QImage full = window.pictureAtRest();
        NodeResult draft;
        draft.draft = true;
        draft.tree = *TreePipeline().evaluateDraft(window.document.scene().nodes().front().params);
        QVERIFY(draft.tree.draftTubes);
        window.document.setResult(window.tree(0), draft);
        window.waitForPicture();
        const QImage tubes = window.view->grabFramebuffer();
        QVERIFY(tubes != full);
        compute(window.document);
        QCOMPARE(window.pictureAtRest(), full);
    }
    void resetFramesAgain()
    {
        Window window;
        Camera camera = window.view->camera();
        camera.target.x += 100.0;
        camera.yawRad = -2.0;
        camera.pitchRad = -0.9;
        window.view->setCamera(camera);
        window.document.reset(rowOfTrees(1), {});
        compute(window.document);
        window.waitForPicture();
        QVERIFY(std::abs(window.view->camera().target.x) < 2.0);
        QCOMPARE(window.view->camera().yawRad, Camera().yawRad);
        QCOMPARE(window.view->camera().pitchRad, Camera().pitchRad);
    }
};

RAMURE_SUITE(TestViewport)

} // namespace tst_viewport

#include "tst_viewport.moc"
