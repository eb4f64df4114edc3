// Cameras of the scene in a real viewport: looked through, moved, left.
#include "core/qt/document/commands.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/actions/camera_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QApplication>
#include <QMenu>
#include <utility>

namespace tst_camera_actions {

using namespace ramure;

class TestCameraActions : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }

    static Node node(NodeId id, NodeKind kind, const glm::dvec3& place)
    {
        Node made;
        made.id = id;
        made.kind = kind;
        made.name = "Node " + std::to_string(id);
        made.params.tree.translation = place;
        return made;
    }

private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void withoutACameraItIsSaid()
    {
        test::ViewWindow window;
        window.show({320, 240});
        ActionSet set;
        CameraActions actions(&window.document, &window.host, &set, nullptr);
        QMenu menu;
        actions.fillMenu(&menu);
        QSignalSpy told(&actions, &CameraActions::messageRaised);
        QAction* through = set.find(QStringLiteral("view.throughCamera"));
        through->trigger();
        QCOMPARE(told.count(), 1);
        QVERIFY(!through->isChecked());
        set.find(QStringLiteral("view.cameraHere"))->trigger();
        QCOMPARE(told.count(), 2);
    }
    void theViewIsTheCamerasUntilItIsMoved()
    {
        test::ViewWindow window;
        window.document.reset(*Scene::fromNodes({node(1, NodeKind::Primitive, {0, 0, 0}),
                                                 node(2, NodeKind::Camera, {0, 1, 8})}),
                              {});
        window.show({320, 240});
        ActionSet set;
        CameraActions actions(&window.document, &window.host, &set, nullptr);
        QAction* through = set.find(QStringLiteral("view.throughCamera"));
        const QImage outside = window.view->grabFramebuffer();
        through->trigger();
        QVERIFY(through->isChecked());
        QCOMPARE(window.view->seenThrough(), NodeId(2));
        window.waitForPicture();
        QVERIFY(glm::length(window.view->camera().eye() - glm::dvec3(0, 1, 8)) < 1e-12);
        window.keep("through_camera");
        QVERIFY(window.view->grabFramebuffer() != outside);

        // It follows what is done to the camera, and undo.
        QVERIFY(edit::setParam(window.document, {2}, *findParam("tree.translation"), glm::dvec3(2, 1, 8)));
        window.waitForPicture();
        QVERIFY(glm::length(window.view->camera().eye() - glm::dvec3(2, 1, 8)) < 1e-12);
        window.document.undo();
        window.waitForPicture();
        QVERIFY(glm::length(window.view->camera().eye() - glm::dvec3(0, 1, 8)) < 1e-12);

        window.view->steer([](Camera& to) { to.orbit(0.3, 0.0); });
        QCOMPARE(window.view->seenThrough(), noNode);
        QVERIFY(!through->isChecked());
        QVERIFY(glm::length(glm::dvec3(worldMatrix(window.document.scene(), 2)[3]) - glm::dvec3(0, 1, 8)) <
                1e-12);
        through->trigger();
        through->trigger(); // once more: back to the artist's
        QCOMPARE(window.view->seenThrough(), noNode);
        through->trigger();
        QVERIFY(edit::removeNodes(window.document, {2}));
        QCOMPARE(window.view->seenThrough(), noNode);
    }
    void anOpenLensBlursTheViewAtRest()
    {
        test::ViewWindow window;
        Node camera = node(2, NodeKind::Camera, {0, 1, 4});
        camera.params.camera.focus = 4.0;
        window.document.reset(*Scene::fromNodes({node(1, NodeKind::Primitive, {0, 0, 0}),
                                                 node(3, NodeKind::Primitive, {3, 0, -9}), camera}),
                              {});
        window.show({320, 240});
        window.view->lookThrough(2);
        window.waitForPicture();
        QTRY_VERIFY(!window.view->work().settling);
        window.waitForPicture();
        const QImage sharp = window.view->grabFramebuffer();
        QVERIFY(edit::setParam(window.document, {2}, *findParam("camera.fStop"), 0.1));
        window.waitForPicture();
        QTRY_VERIFY(!window.view->work().settling);
        // As good as it gets: the next picture is the same.
        QImage last;
        QTRY_VERIFY(std::exchange(last, window.view->grabFramebuffer()) == window.view->grabFramebuffer());
        window.keep("open_lens");
        const auto contrastAt = [&](const QImage& image, const glm::dvec3& place) {
            const QPoint at = window.pixelOf(place);
            int most = 0;
            for (int x = at.x() - 12; x < at.x() + 12; ++x)
                most = std::max(most,
                                std::abs(qGray(image.pixel(x, at.y())) - qGray(image.pixel(x + 1, at.y()))));
            return most;
        };
        const glm::dvec3 nearEdge(0.5, 0.5, 0.0), farEdge(2.5, 0.5, -9.0);
        QVERIFY(contrastAt(last, farEdge) < 0.5 * contrastAt(sharp, farEdge));
        QVERIFY(contrastAt(last, nearEdge) > 0.5 * contrastAt(sharp, nearEdge));
        window.view->steer([](Camera& to) { to.orbit(0.2, 0.0); }); // left: everything is sharp
        QTRY_VERIFY(!window.view->work().settling);
        window.waitForPicture();
    }
    void theCameraComesToTheView()
    {
        test::ViewWindow window;
        Node group = node(3, NodeKind::Group, {1, 0, 0});
        group.params.tree.rotation = {0.2, 0.7, 0.1};
        Node camera = node(2, NodeKind::Camera, {0, 1, 8});
        camera.parent = 3;
        window.document.reset(*Scene::fromNodes({group, camera}), {});
        window.show({320, 240});
        ActionSet set;
        CameraActions actions(&window.document, &window.host, &set, nullptr);
        Camera wanted;
        wanted.target = {1.0, 2.0, 3.0};
        wanted.yawRad = 2.4;
        wanted.pitchRad = 0.5;
        window.view->setCamera(wanted);
        const Scene before = window.document.scene();
        set.find(QStringLiteral("view.cameraHere"))->trigger();
        QCOMPARE(window.document.undoStack()->count(), 1);
        const Camera now = cameraAt(worldMatrix(window.document.scene(), 2), {});
        QVERIFY(glm::length(now.eye() - wanted.eye()) < 1e-9);
        QVERIFY(glm::length(now.backward() - wanted.backward()) < 1e-9);
        QVERIFY(glm::length(now.up() - wanted.up()) < 1e-9);
        window.document.undo();
        QVERIFY(window.document.scene() == before);
    }
};

RAMURE_SUITE(TestCameraActions)

} // namespace tst_camera_actions

#include "tst_camera_actions.moc"
