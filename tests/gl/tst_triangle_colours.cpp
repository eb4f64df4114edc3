#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/scene_builder.h"
#include <QApplication>

namespace tst_triangle_colours {

using namespace ramure;

namespace {

/// Two squares side by side that share an edge, seen from the front: red on the left, blue on the right.
TriangleMesh flag()
{
    TriangleMesh mesh;
    mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.colours = {{220, 20, 20}, {220, 20, 20}, {20, 20, 220}, {20, 20, 220}};
    return mesh;
}

} // namespace

/// Meshes whose triangles have colours of their own, in pictures.
class TestTriangleColours : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        if (const OpenGlProbe probe = probeOpenGl(); !probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void eachTriangleHasItsOwn_data()
    {
        QTest::addColumn<int>("shading");
        QTest::newRow("solid") << int(ShadingMode::Solid);
        QTest::newRow("with wires") << int(ShadingMode::SolidWire);
    }
    void eachTriangleHasItsOwn()
    {
        QFETCH(const int, shading);
        const RenderScene scene = sceneOfMesh(flag());
        const QSize size(320, 240);
        Camera camera;
        camera.yawRad = camera.pitchRad = 0.0;
        camera.frame(scene.box, double(size.width()) / size.height(), 1.3);
        RenderOptions options;
        options.shading = static_cast<ShadingMode>(shading);
        const auto image = renderImage(scene, camera, size, options);
        QVERIFY2(image, test::why(image));
        const auto at = [&](double x, double y) {
            const glm::dvec2 ndc = *camera.project({x, y, 0.0}, double(size.width()) / size.height());
            return image->pixelColor(int(0.5 * (ndc.x + 1.0) * size.width()),
                                     int(0.5 * (1.0 - ndc.y) * size.height()));
        };
        // Up to the edge that they share, in both triangles of each.
        for (const glm::dvec2& place : {glm::dvec2(0.15, 0.4), glm::dvec2(0.6, 0.3), glm::dvec2(0.3, 0.7)}) {
            const QColor left = at(-place.x, place.y), right = at(place.x, place.y);
            QVERIFY2(left.red() > 2 * left.blue(), qPrintable(left.name()));
            QVERIFY2(right.blue() > 2 * right.red(), qPrintable(right.name()));
        }
    }
};

RAMURE_SUITE(TestTriangleColours)

} // namespace tst_triangle_colours

#include "tst_triangle_colours.moc"
