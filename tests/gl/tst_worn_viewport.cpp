#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/arm_demo.h"
#include "core/scene/world_transforms.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QSignalSpy>
#include <cmath>

namespace tst_worn_viewport {

using namespace ramure;

/// Imported meshes and the arm in a real window: as terrain, and as its skin. With RAMURE_PICTURES set to a
/// folder, pictures are left there.
class TestWornViewport : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void controlClickMeetsAnImportedMesh();
    void aMovedMeshIsMetWhereItIs();
    void aWornMeshIsSeenBentAndColoured();
};

namespace {

/// The demo, and a ring (node 3) that is scaled and moved by keys, 2 m along X in the first second.
Scene sceneWithRing()
{
    Scene scene = armDemo();
    scene.remove(2);
    Node ring;
    ring.id = 3;
    ring.kind = NodeKind::Mesh;
    ring.name = "Ring";
    ring.mesh = SharedValue<TriangleMesh>(test::torus(96, 48));
    ring.params.tree.scale = {1.0, 0.5, 1.0};
    Key from, to;
    to.time = ticksPerSecond;
    to.value = 2.0;
    ring.animation.set({ChannelPart::GlobalTranslation, 0, 0},
                       std::make_shared<const AnyTrack>(*Track::fromKeys({from, to})));
    return scene.insert({ring}, noNode, 1) ? scene : Scene();
}

struct Window
{
    Document document;
    ViewportHost host{&document};
    Viewport* view = host.viewport();

    explicit Window(const Scene& scene)
    {
        document.reset(scene, {});
        host.resize(800, 600);
        host.show();
        if (!QTest::qWaitForWindowExposed(&host))
            qWarning("the window does not appear");
        waitForPicture();
    }
    void waitForPicture()
    {
        QSignalSpy drawn(view, &Viewport::frameDrawn);
        view->update();
        if (!QTest::qWaitFor([&] { return !drawn.isEmpty() && !view->work().picture; },
                             test::patience(20'000)))
            qWarning("no picture of now comes");
    }
    [[nodiscard]] QPoint pixelOf(const glm::dvec3& world) const
    {
        const glm::dvec2 ndc = *view->camera().project(world, double(view->width()) / view->height());
        return {qRound(0.5 * (ndc.x + 1.0) * view->width()), qRound(0.5 * (1.0 - ndc.y) * view->height())};
    }
    /// Of the arm, world.
    [[nodiscard]] glm::dvec3 target() const
    {
        const glm::dvec3 own = document.scene().find(1)->params.arm.target;
        return {own.x, own.z, -own.y};
    }
    QImage picture(const char* name)
    {
        waitForPicture();
        const QImage image = view->grabFramebuffer();
        const QString folder = qEnvironmentVariable("RAMURE_PICTURES");
        if (!folder.isEmpty())
            image.save(folder + u'/' + QLatin1String(name) + QLatin1String(".png"));
        return image;
    }
};

int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

/// How far a place is from the surface of a ring of radii 2 and 0.5 about Y that is scaled to half its
/// height.
double fromRing(const glm::dvec3& p)
{
    const double ring = std::hypot(std::hypot(p.x, p.z) - 2.0, 2.0 * p.y);
    return std::abs(ring - 0.5);
}

} // namespace

void TestWornViewport::controlClickMeetsAnImportedMesh()
{
    Window window(sceneWithRing());
    const QPoint at = window.pixelOf({0.0, 0.25, 2.0}); // on top of the ring, in front of the arm
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::ControlModifier, at);
    QVERIFY(fromRing(window.target()) < 0.01);
    QVERIFY((window.pixelOf(window.target()) - at).manhattanLength() <= 2);
    QVERIFY(window.view->armReach()->progress());
    // Once more while the arm is on its way, and everything is being made anew.
    const QPoint next = window.pixelOf({1.0, 0.2, 1.9});
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::ControlModifier, next);
    QVERIFY(fromRing(window.target()) < 0.01);
    QVERIFY((window.pixelOf(window.target()) - next).manhattanLength() <= 2);
    window.view->armReach()->finish();
    window.picture("mesh-as-terrain");
}

void TestWornViewport::aMovedMeshIsMetWhereItIs()
{
    Window window(sceneWithRing());
    Player player(&window.document);
    window.view->setPlayer(&player);
    player.seek(24); // one second: 2 m along X
    QVERIFY(player.waitForIdle(20000));
    window.waitForPicture();
    const QPoint at = window.pixelOf({2.0, 0.25, 2.0});
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::ControlModifier, at);
    QVERIFY(fromRing(window.target() - glm::dvec3(2.0, 0.0, 0.0)) < 0.01);
    QVERIFY((window.pixelOf(window.target()) - at).manhattanLength() <= 2);
    QVERIFY(player.waitForIdle(20000));
}

void TestWornViewport::aWornMeshIsSeenBentAndColoured()
{
    Window window(sceneWithRing());
    std::vector<ArmJoint> joints = window.document.scene().find(1)->params.joints;
    joints[1].theta.angleRad = 2.0;
    QVERIFY(edit::setJoints(window.document, 1, joints, QStringLiteral("bend")));
    const QImage cylinder = window.picture("worn-cylinder");
    QVERIFY(edit::wearMesh(window.document, 1, 3, true));
    const QImage worn = window.picture("worn-ring");
    QVERIFY(differing(cylinder, worn) > 1000);
    QVERIFY(edit::setParam(window.document, {1}, *findParam("armSkin.weights"), true));
    QVERIFY(differing(worn, window.picture("worn-weights")) > 1000);
    QVERIFY(edit::setParam(window.document, {1}, *findParam("skin.method"), EnumValue{"linear"}));
    window.picture("worn-linear");
    while (window.document.undoStack()->canUndo())
        window.document.undo();
    QVERIFY(!window.document.scene().find(1)->mesh);
}

RAMURE_SUITE(TestWornViewport)

} // namespace tst_worn_viewport

#include "tst_worn_viewport.moc"
