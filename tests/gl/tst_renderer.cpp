#include "tests/support/cannot_run.h"
#include "tests/support/sample_tree.h"
#include "tests/support/suite.h"
#include "widgets/view/render/outline.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/renderer.h"
#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <glm/gtc/matrix_transform.hpp>

namespace tst_renderer {

using namespace ramure;

namespace {

const QSize pictureSize(320, 240);

/// From the front, slightly from above, the whole scene in the picture.
Camera frontCamera(const RenderScene& scene)
{
    Camera camera;
    camera.yawRad = 0.0;
    camera.pitchRad = 0.18;
    camera.frame(scene.box, double(pictureSize.width()) / pictureSize.height(), 1.3);
    return camera;
}

QColor pixelAt(const QImage& image, const Camera& camera, const glm::dvec3& point)
{
    const glm::dvec2 ndc = *camera.project(point, double(image.width()) / image.height());
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
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            count += wanted(image.pixelColor(x, y)) ? 1 : 0;
    }
    return count;
}

int differingPixels(const QImage& a, const QImage& b, int tolerance = 8)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x)
            count += isNear(a.pixelColor(x, y), b.pixelColor(x, y), tolerance) ? 0 : 1;
    }
    return count;
}

bool isBark(const QColor& c)
{
    return c.red() > c.green() + 15 && c.green() > c.blue();
}

bool isLeaf(const QColor& c)
{
    return c.green() > c.red() + 8 && c.green() > 3 * c.blue();
}

QImage picture(const RenderScene& scene, const Camera& camera, const RenderOptions& options = {})
{
    auto image = renderImage(scene, camera, pictureSize, options);
    if (!image)
        qWarning("%s", image.error().message().c_str());
    return image ? *image : QImage();
}

/// A context with its own renderer, to look at what is uploaded.
struct Bench
{
    QOffscreenSurface surface;
    QOpenGLContext context;
    std::unique_ptr<QOpenGLFramebufferObject> target;
    std::unique_ptr<Renderer> renderer;

    Bench()
    {
        context.create();
        surface.setFormat(context.format());
        surface.create();
        context.makeCurrent(&surface);
        target = std::make_unique<QOpenGLFramebufferObject>(pictureSize,
                                                            QOpenGLFramebufferObject::CombinedDepthStencil);
        renderer = std::move(*Renderer::make());
    }
    ~Bench()
    {
        context.makeCurrent(&surface); // another bench's may be
        renderer.reset();
        target.reset();
    }
    RenderStats draw(const RenderScene& scene, const RenderOptions& options = {})
    {
        renderer->draw(scene, frontCamera(scene), pictureSize, target->handle(), options);
        return renderer->stats();
    }
};

} // namespace

class TestRenderer : public QObject
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

    void sizesThatCannotBe()
    {
        for (const QSize size : {QSize(0, 10), QSize(10, -1), QSize(20'000, 10), QSize()}) {
            const auto image = renderImage(RenderScene(), Camera(), size);
            QVERIFY(!image);
            QCOMPARE(image.error().code, ErrorCode::Invalid);
        }
        QCOMPARE(renderImage(RenderScene(), Camera(), QSize(1, 1))->size(), QSize(1, 1));
    }
    void noContextNoRenderer()
    {
        QVERIFY(!QOpenGLContext::currentContext());
        const auto made = Renderer::make();
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::Unknown);
    }
    void emptySceneIsSkyAndGround()
    {
        Camera camera;
        camera.pitchRad = 0.18;
        const QImage image = picture(RenderScene(), camera);
        QCOMPARE(image.format(), QImage::Format_ARGB32);
        const QColor ground = image.pixelColor(160, 235);
        QVERIFY2(isNear(ground, QColor(0x56, 0x7D, 0x46), 12), qPrintable(ground.name()));
        camera.pitchRad = -0.5;
        const QColor sky = picture(RenderScene(), camera).pixelColor(160, 2);
        QVERIFY2(isNear(sky, QColor(0x87, 0xCE, 0xEB), 3), qPrintable(sky.name()));
    }
    void treeHasItsColours()
    {
        const RenderScene scene = test::sampleScene(4, 8);
        const Camera camera = frontCamera(scene);
        const QImage image = picture(scene, camera);
        QVERIFY(isBark(pixelAt(image, camera, {0.0, 0.5, 0.0})));
        QVERIFY(countWhere(image, isBark) > 150);
        QVERIFY(countWhere(image, isLeaf) > 400);
        QCOMPARE(countWhere(image, [](const QColor& c) { return c.alpha() != 255; }), 0);
    }
    void shadowIsDarkerThanLitGround()
    {
        const RenderScene scene = test::sampleScene(4, 40);
        Camera camera = frontCamera(scene);
        camera.pitchRad = 0.7;
        RenderOptions options;
        // Straight below the crown, away from the trunk: the sun comes from the front right.
        const glm::dvec3 shadowed(-1.0, 0.0, -1.1);
        const QColor dark = pixelAt(picture(scene, camera, options), camera, shadowed);
        options.shadows = false;
        const QColor lit = pixelAt(picture(scene, camera, options), camera, shadowed);
        QVERIFY2(dark.lightness() < 0.8 * lit.lightness(), qPrintable(dark.name() + " " + lit.name()));
        QVERIFY(dark.lightness() > 10);
    }
    void shadowsFitEverySize_data()
    {
        QTest::addColumn<double>("scale");
        for (const double scale : {0.03, 1.0, 30.0})
            QTest::addRow("%g", scale) << scale;
    }
    void shadowsFitEverySize()
    {
        QFETCH(double, scale);
        const auto shadowShare = [](double size) {
            RenderScene scene = test::sampleScene(3, 20);
            for (MeshItem& item : scene.meshes)
                item.world = glm::scale(glm::dmat4(1.0), glm::dvec3(size));
            scene.updateBoxes();
            Camera camera = frontCamera(scene);
            RenderOptions options;
            const QImage with = picture(scene, camera, options);
            options.shadows = false;
            return differingPixels(with, picture(scene, camera, options), 20);
        };
        const int reference = shadowShare(1.0);
        const int share = shadowShare(scale);
        QVERIFY(reference > 300);
        QVERIFY2(std::abs(share - reference) < reference / 8,
                 qPrintable(QString("%1 %2").arg(share).arg(reference)));
    }
    void unlitSideHasNoSpeckles()
    {
        // A closed ball without anything around it: all of its sunny side must be lit evenly.
        RenderScene scene;
        Skeleton one;
        one.add(noIndex, glm::dvec3(0.0), glm::dvec3(0.0, 2.0, 0.0), 0.5, 0.5);
        scene.meshes.push_back(test::sampleItem(test::sampleBranches(one, 48), "bark"));
        scene.updateBoxes();
        const Camera camera = frontCamera(scene);
        RenderOptions options;
        const QImage with = picture(scene, camera, options);
        options.shadows = false;
        const QImage without = picture(scene, camera, options);
        int darker = 0;
        for (double height = 0.3; height < 1.7; height += 0.02) {
            for (double x = 0.0; x < 0.4; x += 0.02) {
                const glm::dvec3 point(x, height, std::sqrt(0.25 - x * x));
                darker += pixelAt(with, camera, point).lightness() + 4 <
                          pixelAt(without, camera, point).lightness();
            }
        }
        QCOMPARE(darker, 0);
    }
    void wireframeDrawsLinesOnly()
    {
        const RenderScene scene = test::sampleScene(2, 0);
        const Camera camera = frontCamera(scene);
        RenderOptions options;
        const int solid = countWhere(picture(scene, camera, options), isBark);
        options.shading = ShadingMode::Wire;
        const QImage wire = picture(scene, camera, options);
        const QImage empty = picture(RenderScene(), camera, options);
        const int lines = differingPixels(wire, empty, 20);
        QVERIFY2(lines > 40, qPrintable(QString::number(lines)));
        options.shading = ShadingMode::SolidWire;
        const QImage both = picture(scene, camera, options);
        QVERIFY(differingPixels(both, wire, 30) > 20);
        QVERIFY(differingPixels(both, empty, 20) > solid / 2);
    }
    void gridCanBeSwitched()
    {
        Camera camera;
        RenderOptions options;
        const QImage plain = picture(RenderScene(), camera, options);
        options.grid = true;
        QVERIFY(differingPixels(plain, picture(RenderScene(), camera, options)) > 300);
    }
    void withoutTheWorldTheBackgroundIsClear()
    {
        const RenderScene scene = test::sampleScene(3, 4);
        RenderOptions options;
        options.world = false;
        const QImage image = picture(scene, frontCamera(scene), options);
        QCOMPARE(image.pixelColor(2, 2).alpha(), 0);
        QVERIFY(countWhere(image, [](const QColor& c) { return c.alpha() == 255; }) > 500);
    }
    void linesAndMarksAppear()
    {
        auto lines = std::make_shared<LineSet>();
        lines->segments.push_back({{-1, 1, 0}, {1, 1, 0}, 4.0f, 4.0f, {255, 0, 0, 255}, noIndex});
        lines->box.add(glm::dvec3(-1, 0, -1));
        lines->box.add(glm::dvec3(1, 2, 1));
        auto points = std::make_shared<PointSet>();
        points->points.push_back({{0, 1.5f, 0}, 12.0f, {0, 0, 255, 255}, noIndex});
        points->box = lines->box;
        RenderScene scene;
        scene.lines.push_back({lines, glm::dmat4(1.0), 1, false, true});
        scene.points.push_back({points, glm::dmat4(1.0), 1, false});
        scene.updateBoxes();
        for (const bool orthographic : {false, true}) {
            Camera camera = frontCamera(scene);
            camera.orthographic = orthographic;
            const QImage image = picture(scene, camera);
            QVERIFY(isNear(pixelAt(image, camera, {0.4, 1.0, 0.0}), Qt::red, 12));
            QVERIFY(isNear(pixelAt(image, camera, {0.0, 1.5, 0.0}), Qt::blue, 12));
        }
    }
    void linesThroughTheEyeAreCut()
    {
        auto lines = std::make_shared<LineSet>();
        lines->segments.push_back({{0, 1, -50}, {0, 1, 50}, 6.0f, 6.0f, {255, 0, 0, 255}, noIndex});
        lines->box.add(glm::dvec3(-1, 0, -50));
        lines->box.add(glm::dvec3(1, 2, 50));
        RenderScene scene;
        scene.lines.push_back({lines, glm::dmat4(1.0), 1, false, true});
        scene.updateBoxes();
        Camera camera;
        camera.yawRad = camera.pitchRad = 0.0;
        camera.target = {0.0, 1.5, 0.0};
        camera.distance = 3.0;
        const int red =
            countWhere(picture(scene, camera), [](const QColor& c) { return isNear(c, Qt::red, 12); });
        QVERIFY2(red > 20 && red < 10'000, qPrintable(QString::number(red)));
    }
    void highlightColoursOneBranch()
    {
        RenderScene scene = test::sampleScene(2, 0);
        const Camera camera = frontCamera(scene);
        const QColor before = pixelAt(picture(scene, camera), camera, {0.0, 0.5, 0.0});
        BranchStates states(test::sampleSkeleton(2).size(), BranchState::Plain);
        states[0] = BranchState::Selected;
        scene.highlights.push_back({1, std::make_shared<const BranchStates>(states)});
        const QImage image = picture(scene, camera);
        const QColor after = pixelAt(image, camera, {0.0, 0.5, 0.0});
        QVERIFY(after.red() > before.red() + 20);
        const Skeleton skeleton = test::sampleSkeleton(2);
        const glm::dvec3 other = 0.5 * (skeleton.p0[1] + skeleton.p1[1]);
        RenderScene plain = test::sampleScene(2, 0);
        QVERIFY(isNear(pixelAt(image, camera, other), pixelAt(picture(plain, camera), camera, other), 3));
    }
    void mirroredItemsShowTheirOutside()
    {
        RenderScene scene = test::sampleScene(0, 0);
        scene.meshes[0].material.twoSided = false;
        const Camera camera = frontCamera(scene);
        const QColor before = pixelAt(picture(scene, camera), camera, {0.0, 0.5, 0.0});
        scene.meshes[0].world = glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
        const QColor after = pixelAt(picture(scene, camera), camera, {0.0, 0.5, 0.0});
        QVERIFY2(isNear(before, after, 25), qPrintable(before.name() + after.name()));
        QVERIFY(isBark(after));
    }
    void meshWithoutNormalsIsShaded()
    {
        RenderScene scene = test::sampleScene(0, 0);
        TriangleMesh bare = *scene.meshes[0].mesh;
        bare.normals.clear();
        bare.branch.clear();
        scene.meshes[0].mesh = std::make_shared<const TriangleMesh>(bare);
        const Camera camera = frontCamera(scene);
        QVERIFY(isBark(pixelAt(picture(scene, camera), camera, {0.0, 0.5, 0.0})));
    }
    void smoothingKeepsThePicture()
    {
        const RenderScene scene = test::sampleScene(4, 8);
        const Camera camera = frontCamera(scene);
        RenderOptions options;
        options.samples = 0;
        const QImage hard = picture(scene, camera, options);
        options.smoothing = true;
        const QImage smooth = picture(scene, camera, options);
        const int changed = differingPixels(hard, smooth, 8);
        QVERIFY2(changed > 100 && changed < 20'000, qPrintable(QString::number(changed)));
        QCOMPARE(smooth.pixelColor(5, 5), hard.pixelColor(5, 5));
    }
    void everyPictureIsTheSame()
    {
        const RenderScene scene = test::sampleScene(4, 8);
        const Camera camera = frontCamera(scene);
        QCOMPARE(picture(scene, camera), picture(scene, camera));
    }
    void onlyWhatIsNewIsUploaded()
    {
        Bench bench;
        RenderScene scene = test::sampleScene(3, 4);
        QCOMPARE(bench.draw(scene).uploads.uploads, 2u);
        RenderStats stats = bench.draw(scene);
        QCOMPARE(stats.uploads.uploads, 2u);
        QCOMPARE(stats.shadowRedraws, 1u);

        scene.highlights.push_back({1, std::make_shared<const BranchStates>(40, BranchState::Selected)});
        const std::uint64_t before = stats.uploads.bytes;
        stats = bench.draw(scene);
        QCOMPARE(stats.uploads.uploads, 3u);
        QVERIFY2(stats.uploads.bytes - before <= 2048, "one small texture, no mesh");
        QCOMPARE(stats.shadowRedraws, 1u);

        scene.meshes[1] = test::sampleItem(test::sampleLeaves(test::sampleSkeleton(3), 2), "leaves");
        scene.updateBoxes();
        stats = bench.draw(scene);
        QCOMPARE(stats.uploads.uploads, 4u);
        QCOMPARE(stats.uploads.freed, 1u);
        QCOMPARE(stats.uploads.alive, 3u);
        QCOMPARE(stats.shadowRedraws, 2u);

        stats = bench.draw(RenderScene());
        QCOMPARE(stats.uploads.alive, 0u);
    }
    void emptyScenesAreReadyAtOnce()
    {
        Bench bench;
        QVERIFY(bench.renderer->prepare(RenderScene(), 0));
        QVERIFY(!bench.renderer->prepare(test::sampleScene(3, 4), 0)); // nothing may be copied
    }
    void scenesAreUploadedInSlices()
    {
        Bench bench;
        const RenderScene shown = test::sampleScene(2, 4);
        const RenderScene next = test::sampleScene(4, 8);
        bench.draw(shown);
        const std::uint64_t before = bench.renderer->stats().uploads.bytes;
        constexpr std::size_t slice = 10'000;
        int turns = 1;
        std::uint64_t last = before;
        while (!bench.renderer->prepare(next, slice)) {
            ++turns;
            const std::uint64_t now = bench.renderer->stats().uploads.bytes;
            QVERIFY(now - last <= slice);
            last = now;
            bench.draw(shown); // pictures between keep what is prepared
        }
        QVERIFY(turns > 3);
        const RenderStats ready = bench.renderer->stats();
        const RenderStats drawn = bench.draw(next);
        QCOMPARE(drawn.uploads.bytes, ready.uploads.bytes);
        QCOMPARE(drawn.uploads.alive, next.meshes.size());
        const QImage image = bench.target->toImage();
        Bench atOnce;
        atOnce.draw(next);
        QCOMPARE(image, atOnce.target->toImage());
        QCOMPARE(bench.renderer->takeReleased().size(), shown.meshes.size());
        QVERIFY(bench.renderer->takeReleased().empty());
    }
    void whatIsNotDrawnAfterAllIsFreed()
    {
        Bench bench;
        const RenderScene shown = test::sampleScene(2, 4);
        const RenderScene given = test::sampleScene(4, 8);
        (void)bench.renderer->prepare(given, 1000);
        QVERIFY(bench.renderer->prepare(shown, std::size_t(1) << 30)); // another one instead
        QCOMPARE(bench.draw(shown).uploads.alive, shown.meshes.size());
    }
    void movedItemsUploadNothing()
    {
        Bench bench;
        RenderScene scene = test::sampleScene(3, 4);
        bench.draw(scene);
        scene.meshes[0].world = glm::translate(glm::dmat4(1.0), {1.0, 0.0, 0.0});
        scene.updateBoxes();
        const RenderStats stats = bench.draw(scene);
        QCOMPARE(stats.uploads.uploads, 2u);
        QCOMPARE(stats.shadowRedraws, 2u);
    }
    void rebuiltAfterALostContext()
    {
        const RenderScene scene = test::sampleScene(3, 4);
        QImage first;
        {
            Bench bench;
            bench.draw(scene);
            first = bench.target->toImage();
        }
        Bench again;
        again.draw(scene);
        QCOMPARE(again.target->toImage(), first);
    }
    void leavesNoErrorAndNoState()
    {
        Bench bench;
        RenderScene scene = test::sampleScene(2, 2);
        scene.highlights.push_back({1, std::make_shared<const BranchStates>(9, BranchState::Hovered)});
        for (const ShadingMode mode : {ShadingMode::Solid, ShadingMode::SolidWire, ShadingMode::Wire}) {
            RenderOptions options;
            options.shading = mode;
            options.smoothing = mode == ShadingMode::Solid;
            bench.draw(scene, options);
        }
        auto* gl = bench.context.functions();
        QCOMPARE(gl->glGetError(), GLenum(GL_NO_ERROR));
        GLint program = -1;
        gl->glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        QCOMPARE(program, 0);
        QVERIFY(!gl->glIsEnabled(GL_DEPTH_TEST));
        QVERIFY(!gl->glIsEnabled(GL_BLEND));
    }
    /// Also behind a wall, and no more than a line.
    void outlinesAreSeenThroughEverything()
    {
        const auto ink = [](const QColor& c) { return isNear(c, QColor(255, 128, 15), 40); };
        RenderScene scene = test::sampleScene(4, 30);
        const Camera camera = frontCamera(scene);
        QCOMPARE(countWhere(picture(scene, camera), ink), 0);
        const MeshItem plain = scene.meshes[0];
        std::vector<bool> one(5, false);
        one[4] = true;
        scene.meshes[0].outlined = std::make_shared<const OutlinedFaces>(outlinedBranches(*plain.mesh, one));
        const int around = countWhere(picture(scene, camera), ink);
        QVERIFY2(around > 40 && around < 2000, qPrintable(QString::number(around)));
        TriangleMesh wall;
        const glm::vec3 at(camera.target + 0.7 * camera.distance * camera.backward());
        for (const glm::vec2& corner : {glm::vec2(-9, -9), glm::vec2(9, -9), glm::vec2(0, 20)})
            wall.positions.emplace_back(at + glm::vec3(corner, 0.0f));
        wall.normals.assign(3, {0, 0, 1});
        wall.triangles = {{0, 1, 2}};
        scene.meshes.push_back(test::sampleItem(std::move(wall), "wall", 2));
        const int behind = countWhere(picture(scene, camera), ink);
        QVERIFY2(std::abs(behind - around) < around / 5, qPrintable(QString::number(behind)));
        scene.meshes.pop_back();
        scene.meshes[0] = plain;
        for (MeshItem& item : scene.meshes)
            item.outlined = std::make_shared<const OutlinedFaces>(outlinedWhole(item.mesh, item.box, 0));
        const int whole = countWhere(picture(scene, camera), ink);
        QVERIFY2(whole > around / 2, qPrintable(QString::number(whole)));
    }
    /// However many there are, one over the other.
    void fadedLeavesHideLittle()
    {
        RenderScene scene = test::sampleScene(4, 40);
        const Camera camera = frontCamera(scene);
        RenderScene bare = scene;
        bare.meshes.pop_back();
        const QImage without = picture(bare, camera);
        scene.meshes[1].castsShadow = false;
        const int opaque = differingPixels(picture(scene, camera), without, 45);
        scene.meshes[1].opacity = 0.1f;
        const int faded = differingPixels(picture(scene, camera), without, 45);
        QVERIFY2(faded * 20 < opaque, qPrintable(QStringLiteral("%1 of %2").arg(faded).arg(opaque)));
        QVERIFY(differingPixels(picture(scene, camera), without, 2) > 0); // they are still there
    }
};

RAMURE_SUITE(TestRenderer)

} // namespace tst_renderer

#include "tst_renderer.moc"
