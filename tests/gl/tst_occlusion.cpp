#include "widgets/view/render/passes/occlusion.h"

#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include <QApplication>

namespace tst_occlusion {

using namespace ramure;

namespace {

constexpr int side = 240;

/// A parallelogram that reaches from a corner along two ways.
MeshItem plate(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = {corner, corner + a, corner + a + b, corner + b};
    mesh->normals.assign(4, glm::normalize(glm::cross(a, b)));
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    MeshItem item;
    item.box = meshBox(*mesh);
    item.mesh = std::move(mesh);
    item.material.twoSided = true;
    return item;
}

/// A level floor and a wall on it, 1.5 m high, that the sun in the north (-Z) shines on from behind.
RenderScene corner(bool withFloor)
{
    RenderScene scene;
    scene.meshes.push_back(plate({1.0f, 0.0f, -6.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f})); // far away
    if (withFloor)
        scene.meshes.push_back(plate({-2.0f, 0.05f, 3.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.0f}));
    scene.meshes.push_back(plate({-0.5f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.5f, 0.0f}));
    scene.updateBoxes();
    return scene;
}

struct View
{
    QImage image;
    Camera camera;
    [[nodiscard]] int lightAt(const glm::dvec3& place) const
    {
        const glm::dvec2 ndc = *camera.project(place, 1.0);
        return image.pixelColor(int(0.5 * (ndc.x + 1.0) * side), int(0.5 * (1.0 - ndc.y) * side)).lightness();
    }
};

View view(const RenderScene& scene, Quality quality, bool parallel = false)
{
    View made;
    made.camera.target = {0.0, 0.2, 0.2};
    made.camera.yawRad = 0.0;
    made.camera.pitchRad = 0.6;
    made.camera.distance = 2.0;
    made.camera.orthographic = parallel;
    RenderOptions options;
    options.quality = quality;
    options.light = {0.0, 30.0, Backdrop::Landscape};
    auto image = renderImage(scene, made.camera, {side, side}, options);
    if (!image)
        qWarning("%s", image.error().message().c_str());
    made.image = image ? *image : QImage();
    return made;
}

} // namespace

class TestOcclusion : public QObject
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

    void whatStandsCloseByHidesSomeOfTheSky_data()
    {
        QTest::addColumn<bool>("parallel");
        QTest::addColumn<bool>("withFloor");
        QTest::newRow("on a surface") << false << true;
        QTest::newRow("on the ground") << false << false;
        QTest::newRow("in an orthographic view") << true << true;
    }
    void whatStandsCloseByHidesSomeOfTheSky()
    {
        QFETCH(const bool, parallel);
        QFETCH(const bool, withFloor);
        const RenderScene scene = corner(withFloor);
        const double floor = withFloor ? 0.05 : 0.0;
        for (const Quality quality : {Quality::Good, Quality::Best}) {
            const View seen = view(scene, quality, parallel);
            const int open = seen.lightAt({0.2, floor, 0.5});
            QVERIFY2(seen.lightAt({0.2, floor, 0.02}) + 2 < open, qPrintable(QString::number(open)));
            QVERIFY(seen.lightAt({0.2, floor + 0.02, 0.0}) + 2 <
                    seen.lightAt({0.2, 0.6, 0.0})); // the wall, too
        }
        const View draft = view(scene, Quality::Draft, parallel);
        QVERIFY(std::abs(draft.lightAt({0.2, floor, 0.02}) - draft.lightAt({0.2, floor, 0.5})) <= 2);
    }
};

RAMURE_SUITE(TestOcclusion)

} // namespace tst_occlusion

#include "tst_occlusion.moc"
