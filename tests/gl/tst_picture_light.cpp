#include "core/surface/foliage/place_foliage.h"
#include "tests/support/cannot_run.h"
#include "tests/support/preset_trees.h"
#include "tests/support/sample_tree.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/picture_light.h"
#include <QApplication>
#include <cmath>
#include <functional>

namespace tst_picture_light {

using namespace ramure;

namespace {

const QSize pictureSize(320, 240);
constexpr double aspect = 320.0 / 240.0;

QImage picture(const RenderScene& scene, const Camera& camera, const RenderOptions& options = {})
{
    auto image = renderImage(scene, camera, pictureSize, options);
    if (!image)
        qWarning("%s", image.error().message().c_str());
    return image ? *image : QImage();
}

QColor pixelAt(const QImage& image, const Camera& camera, const glm::dvec3& point)
{
    const glm::dvec2 ndc = *camera.project(point, aspect);
    return image.pixelColor(int(0.5 * (ndc.x + 1.0) * image.width()),
                            int(0.5 * (1.0 - ndc.y) * image.height()));
}

bool isNear(const QColor& a, const QColor& b, int tolerance)
{
    return std::abs(a.red() - b.red()) <= tolerance && std::abs(a.green() - b.green()) <= tolerance &&
           std::abs(a.blue() - b.blue()) <= tolerance;
}

int countWhere(const QImage& image, const std::function<bool(const QColor&)>& wanted)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += wanted(image.pixelColor(x, y)) ? 1 : 0;
    return count;
}

int srgb(double linear)
{
    const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return int(std::lround(255.0 * std::clamp(s, 0.0, 1.0)));
}

/// How much colours change from a pixel to the next, in a square about the middle.
double contrast(const QImage& image, int half)
{
    double sum = 0.0;
    for (int y = image.height() / 2 - half; y < image.height() / 2 + half; ++y)
        for (int x = image.width() / 2 - half; x < image.width() / 2 + half; ++x)
            sum += std::abs(image.pixelColor(x, y).lightnessF() - image.pixelColor(x + 1, y).lightnessF());
    return sum;
}

/// In front of the sample, its middle in the middle of the picture.
Camera before(const RenderScene& scene)
{
    Camera camera;
    camera.yawRad = 0.0;
    camera.frame(scene.box, aspect, 1.3);
    return camera;
}

/// A crown alone, its leaves drawn as copies.
Expected<RenderScene> crownScene()
{
    LeafParams leaf;
    leaf.shape = LeafShape::Linden;
    auto skeleton = test::presetSkeleton({.name = "SmallTree", .iterations = 8});
    if (!skeleton)
        return fail(std::move(skeleton.error()));
    auto foliage = placeFoliage(*skeleton, {}, leaf, {}, 0.5);
    if (!foliage)
        return fail(std::move(foliage.error()));
    MeshItem item;
    auto mesh = std::make_shared<TriangleMesh>(buildLeaves(*skeleton, *foliage, 0.5, FoliageModel::Fine));
    for (const glm::vec3& position : mesh->positions)
        item.box.add(glm::dvec3(position));
    item.mesh = std::move(mesh);
    item.copies = std::make_shared<MeshCopies>(leafCopies(*foliage, 0.5, FoliageModel::Fine));
    item.material.twoSided = true;
    item.material.through = 0.5f;
    item.material.colour = {90, 140, 60};
    RenderScene scene;
    scene.box = item.box;
    scene.meshes.push_back(std::move(item));
    return scene;
}

/// The mean of what is there, and how much of the picture that is.
std::pair<glm::dvec3, double> crownOf(const QImage& image)
{
    glm::dvec3 sum(0.0);
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, y);
            if (colour.alpha() < 128)
                continue;
            sum += glm::dvec3(colour.red(), colour.green(), colour.blue());
            ++count;
        }
    }
    return {sum / std::max(1.0, double(count)), double(count) / double(image.width() * image.height())};
}

} // namespace

class TestPictureLight : public QObject
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

    void aStudioIsOneColourThatTakesShadows_data()
    {
        QTest::addColumn<Backdrop>("backdrop");
        QTest::addColumn<double>("height");
        for (const double height : {60.0, 5.0}) {
            QTest::addRow("light, sun at %g degrees", height) << Backdrop::LightStudio << height;
            QTest::addRow("dark, sun at %g degrees", height) << Backdrop::DarkStudio << height;
        }
    }
    void aStudioIsOneColourThatTakesShadows()
    {
        QFETCH(const Backdrop, backdrop);
        QFETCH(const double, height);
        RenderOptions options;
        options.light = {136.0, height, backdrop};
        Camera camera;
        camera.pitchRad = 0.3;
        const QImage empty = picture(RenderScene(), camera, options);
        const QColor colour = empty.pixelColor(0, 0);
        QVERIFY((colour.lightness() > 128) == (backdrop == Backdrop::LightStudio));
        QCOMPARE(countWhere(empty, [&](const QColor& c) { return !isNear(c, colour, 2); }), 0); // no horizon
        const RenderScene scene = test::sampleScene(4, 40);
        camera = before(scene);
        camera.pitchRad = 0.7;
        options.light.heightDeg = 46.0;
        const QColor shadowed = pixelAt(picture(scene, camera, options), camera, {-1.0, 0.0, -1.1});
        QVERIFY2(shadowed.lightness() < 0.85 * colour.lightness(), qPrintable(shadowed.name()));
    }
    void aLowSunIsWarm()
    {
        const auto redness = [](const QImage& image) {
            double red = 0.0, blue = 0.0;
            for (int y = 180; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    red += image.pixelColor(x, y).redF();
                    blue += image.pixelColor(x, y).blueF();
                }
            return red / blue;
        };
        Camera camera;
        camera.pitchRad = 0.5;
        RenderOptions options;
        const double usual = redness(picture(RenderScene(), camera, options));
        options.light.heightDeg = 12.0;
        QVERIFY(redness(picture(RenderScene(), camera, options)) > 1.1 * usual);
    }
    /// The shader and sky.cpp say the same.
    void theSkyIsThatOfTheFormula()
    {
        RenderOptions options;
        options.light = {90.0, 25.0, Backdrop::Sky, 4.0};
        const PictureLight light = lightOf(options.light);
        for (const double yaw : {0.3, 2.0, -2.4}) {
            Camera camera;
            camera.yawRad = yaw;
            camera.pitchRad = -0.6;
            const QImage image = picture(RenderScene(), camera, options);
            for (const glm::dvec2 ndc : {glm::dvec2(0.0), glm::dvec2(-0.8, 0.7), glm::dvec2(0.6, -0.5)}) {
                const ViewRay ray = camera.ray(ndc, aspect);
                const glm::dvec3 linear = light.radiance(ray.direction);
                const QColor expected(srgb(linear.r), srgb(linear.g), srgb(linear.b));
                const QColor seen = image.pixelColor(int(0.5 * (ndc.x + 1.0) * image.width()),
                                                     int(0.5 * (1.0 - ndc.y) * image.height()));
                QVERIFY2(isNear(seen, expected, 3), qPrintable(seen.name() + " " + expected.name()));
            }
        }
    }
    void aStopMoreIsTwiceTheLight()
    {
        Camera camera;
        camera.pitchRad = 0.5;
        RenderOptions options;
        options.light.exposure = -1.0;
        const QColor dark = picture(RenderScene(), camera, options).pixelColor(160, 200);
        options.light.exposure = 0.0;
        const QColor usual = picture(RenderScene(), camera, options).pixelColor(160, 200);
        const auto linear = [](int byte) { return std::pow((byte / 255.0 + 0.055) / 1.055, 2.4); };
        QVERIFY(std::abs(linear(usual.green()) / linear(dark.green()) - 2.0) < 0.1);
    }
    void simplerLeavesKeepTheCrown()
    {
        const auto scene = crownScene();
        QVERIFY(scene);
        const Camera camera = before(*scene);
        RenderOptions options;
        options.world = false;
        const QImage whole = picture(*scene, camera, options);
        const auto [fine, room] = crownOf(whole);
        options.sparing = true;
        const QImage sparing = picture(*scene, camera, options);
        QVERIFY(sparing != whole);
        const auto [plain, simpler] = crownOf(sparing);
        QVERIFY(room > 0.1);
        QVERIFY2(std::abs(simpler - room) < 0.06 * room, qPrintable(QString::number(simpler / room)));
        for (int c = 0; c < 3; ++c)
            QVERIFY2(std::abs(plain[c] - fine[c]) < 6.0,
                     qPrintable(QStringLiteral("%1: %2, %3").arg(c).arg(plain[c]).arg(fine[c])));
    }
    void aLensShowsSharpWhatItIsSetTo()
    {
        const RenderScene scene = test::sampleScene(4, 40);
        const Camera camera = before(scene);
        RenderOptions options;
        const QImage plain = picture(scene, camera, options);
        options.lens = {0.3 * camera.distance, 0.0};
        const double focused = contrast(picture(scene, camera, options), 60);
        options.lens.focus = 0.5 * camera.distance;
        const double blurred = contrast(picture(scene, camera, options), 60);
        QVERIFY2(blurred < 0.6 * focused, qPrintable(QStringLiteral("%1 %2").arg(blurred).arg(focused)));
        options.lens = {1e-9, 0.0}; // a hole sees everything sharp: the same picture, but for its edges
        const QImage hole = picture(scene, camera, options);
        int differing = 0;
        for (int y = 0; y < plain.height(); ++y)
            for (int x = 0; x < plain.width(); ++x)
                differing += isNear(plain.pixelColor(x, y), hole.pixelColor(x, y), 40) ? 0 : 1;
        QVERIFY2(differing < plain.width() * plain.height() / 50, qPrintable(QString::number(differing)));
        options.world = false;
        QCOMPARE(picture(scene, camera, options).pixelColor(1, 1).alpha(), 0);
    }
};

RAMURE_SUITE(TestPictureLight)

} // namespace tst_picture_light

#include "tst_picture_light.moc"
