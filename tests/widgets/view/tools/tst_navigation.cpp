#include "tests/support/suite.h"
#include "widgets/view/tools/navigation.h"
#include "widgets/view/tools/navigation_cube.h"
#include <QImage>
#include <set>

Q_DECLARE_METATYPE(ramure::CameraDrag)

namespace tst_navigation {

using namespace ramure;

class TestNavigation : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void gestures_data()
    {
        QTest::addColumn<bool>("maya");
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<CameraDrag>("expected");
        const auto row = [](const char* name, bool maya, Qt::MouseButton button, int modifiers,
                            CameraDrag drag) {
            QTest::newRow(name) << maya << int(button) << modifiers << drag;
        };
        row("unknown button", false, Qt::BackButton, 0, CameraDrag::None);
        row("unknown button with Alt", true, Qt::BackButton, Qt::AltModifier, CameraDrag::None);
        row("Blender left", false, Qt::LeftButton, 0, CameraDrag::None);
        row("Blender Shift left", false, Qt::LeftButton, Qt::ShiftModifier, CameraDrag::None);
        row("Blender middle", false, Qt::MiddleButton, 0, CameraDrag::Orbit);
        row("Blender Shift middle", false, Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Pan);
        row("Blender Ctrl middle", false, Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Zoom);
        row("Blender right", false, Qt::RightButton, 0, CameraDrag::None);
        row("Blender Alt left", false, Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit);
        row("Blender Alt Shift left", false, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier,
            CameraDrag::Pan);
        row("Blender Alt Ctrl left", false, Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier,
            CameraDrag::Zoom);
        row("Maya left", true, Qt::LeftButton, 0, CameraDrag::None);
        row("Maya middle", true, Qt::MiddleButton, 0, CameraDrag::None);
        row("Maya Alt left", true, Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit);
        row("Maya Alt middle", true, Qt::MiddleButton, Qt::AltModifier, CameraDrag::Pan);
        row("Maya Alt right", true, Qt::RightButton, Qt::AltModifier, CameraDrag::Zoom);
    }
    void gestures()
    {
        QFETCH(bool, maya);
        QFETCH(int, button);
        QFETCH(int, modifiers);
        QFETCH(CameraDrag, expected);
        QCOMPARE(cameraDragFor(maya ? NavigationStyle::Maya : NavigationStyle::Blender,
                               Qt::MouseButton(button), Qt::KeyboardModifiers(modifiers)),
                 expected);
    }
    void dragsMoveTheCamera()
    {
        Camera camera;
        const Camera before = camera;
        applyDrag(camera, CameraDrag::None, {50, 50}, {400, 300});
        QCOMPARE(camera, before);
        applyDrag(camera, CameraDrag::Orbit, {0, 0}, {0, 0});
        QVERIFY(std::isfinite(camera.yawRad));
        applyDrag(camera, CameraDrag::Orbit, {30, 0}, {400, 300});
        QVERIFY(camera.yawRad < before.yawRad);
        camera = before;
        applyDrag(camera, CameraDrag::Zoom, {0, 30}, {400, 300});
        QVERIFY(camera.distance > before.distance);
        camera = before;
        applyDrag(camera, CameraDrag::Pan, {30, -20}, {400, 300});
        const glm::dvec2 moved = *camera.project(before.target, 400.0 / 300.0);
        QVERIFY(std::abs(moved.x * 200.0 - 30.0) < 1e-9 && std::abs(moved.y * 150.0 - 20.0) < 1e-9);
    }
    void wheelIsBoundedAndSymmetric()
    {
        QVERIFY(wheelFactor(120.0) < 1.0);
        QVERIFY(std::abs(wheelFactor(120.0) * wheelFactor(-120.0) - 1.0) < 1e-12);
        QVERIFY(wheelFactor(1e9) > 0.1);
    }
    void cubeShowsTheSidesThatFaceTheEye()
    {
        const QSize picture(600, 400);
        const QRectF place = NavigationCube::place(picture);
        QVERIFY(QRectF({0, 0}, QSizeF(picture)).contains(place));
        Camera camera;
        for (const AxisView view : {AxisView::Front, AxisView::Back, AxisView::Right, AxisView::Left,
                                    AxisView::Top, AxisView::Bottom}) {
            camera.setAxisView(view);
            QCOMPARE(NavigationCube::sideAt(camera, picture, place.center()), std::optional(view));
            QVERIFY(!NavigationCube::sideAt(camera, picture, place.topLeft()));
        }
        camera.yawRad = 0.7;
        camera.pitchRad = 0.5;
        std::set<AxisView> seen;
        for (double y = place.top(); y < place.bottom(); ++y) {
            for (double x = place.left(); x < place.right(); ++x) {
                if (const auto side = NavigationCube::sideAt(camera, picture, {x, y}))
                    seen.insert(*side);
            }
        }
        QCOMPARE(seen, (std::set{AxisView::Front, AxisView::Right, AxisView::Top}));
    }
    void cubeIsPainted()
    {
        const QSize size(300, 200);
        QImage image(size, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        Camera camera;
        camera.pitchRad = 0.4;
        NavigationCube::paint(painter, camera, size, AxisView::Front);
        painter.end();
        const QPoint centre = NavigationCube::place(size).center().toPoint();
        QVERIFY(image.pixelColor(centre + QPoint(0, 20)).alpha() > 200);
        QCOMPARE(image.pixelColor(5, 195).alpha(), 0);
    }
};

RAMURE_SUITE(TestNavigation)

} // namespace tst_navigation

#include "tst_navigation.moc"
