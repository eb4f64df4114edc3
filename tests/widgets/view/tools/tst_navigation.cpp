#include "tests/support/suite.h"
#include "widgets/view/tools/navigation.h"
#include "widgets/view/tools/navigation_cube.h"
#include <QImage>
#include <set>

using namespace ramure;

Q_DECLARE_METATYPE(ramure::Gesture)

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
        QTest::addColumn<Gesture>("expected");
        const auto row = [](const char* name, bool maya, Qt::MouseButton button, int modifiers,
                            Gesture gesture) {
            QTest::newRow(name) << maya << int(button) << modifiers << gesture;
        };
        row("unknown button", false, Qt::BackButton, 0, Gesture::None);
        row("unknown button with Alt", true, Qt::BackButton, Qt::AltModifier, Gesture::None);
        row("Blender left", false, Qt::LeftButton, 0, Gesture::Select);
        row("Blender Shift left", false, Qt::LeftButton, Qt::ShiftModifier, Gesture::Select);
        row("Blender middle", false, Qt::MiddleButton, 0, Gesture::Orbit);
        row("Blender Shift middle", false, Qt::MiddleButton, Qt::ShiftModifier, Gesture::Pan);
        row("Blender Ctrl middle", false, Qt::MiddleButton, Qt::ControlModifier, Gesture::Zoom);
        row("Blender right", false, Qt::RightButton, 0, Gesture::None);
        row("Blender Alt left", false, Qt::LeftButton, Qt::AltModifier, Gesture::Orbit);
        row("Blender Alt Shift left", false, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier,
            Gesture::Pan);
        row("Blender Alt Ctrl left", false, Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier,
            Gesture::Zoom);
        row("Maya left", true, Qt::LeftButton, 0, Gesture::Select);
        row("Maya middle", true, Qt::MiddleButton, 0, Gesture::None);
        row("Maya Alt left", true, Qt::LeftButton, Qt::AltModifier, Gesture::Orbit);
        row("Maya Alt middle", true, Qt::MiddleButton, Qt::AltModifier, Gesture::Pan);
        row("Maya Alt right", true, Qt::RightButton, Qt::AltModifier, Gesture::Zoom);
    }
    void gestures()
    {
        QFETCH(bool, maya);
        QFETCH(int, button);
        QFETCH(int, modifiers);
        QFETCH(Gesture, expected);
        QCOMPARE(gestureFor(maya ? NavigationStyle::Maya : NavigationStyle::Blender, Qt::MouseButton(button),
                            Qt::KeyboardModifiers(modifiers)),
                 expected);
    }
    void dragsMoveTheCamera()
    {
        Camera camera;
        const Camera before = camera;
        applyDrag(camera, Gesture::Select, {50, 50}, {400, 300});
        applyDrag(camera, Gesture::None, {50, 50}, {400, 300});
        QCOMPARE(camera, before);
        applyDrag(camera, Gesture::Orbit, {0, 0}, {0, 0});
        QVERIFY(std::isfinite(camera.yawRad));
        applyDrag(camera, Gesture::Orbit, {30, 0}, {400, 300});
        QVERIFY(camera.yawRad < before.yawRad);
        camera = before;
        applyDrag(camera, Gesture::Zoom, {0, 30}, {400, 300});
        QVERIFY(camera.distance > before.distance);
        camera = before;
        applyDrag(camera, Gesture::Pan, {30, -20}, {400, 300});
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

QTEST_MAIN(TestNavigation)
#include "tst_navigation.moc"
