// Crowds as the renderer draws them: forms in the place of whole trees.
#include "core/math/random.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/crowd_forms.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/renderer.h"
#include "widgets/view/render/scene_builder.h"
#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <glm/gtc/constants.hpp>

namespace tst_crowd_pictures {

using namespace ramure;

namespace {

const QSize pictureSize(320, 240);

QImage picture(const RenderScene& scene, const Camera& camera, const RenderOptions& options = {})
{
    auto image = renderImage(scene, camera, pictureSize, options);
    if (!image)
        qWarning("%s", image.error().message().c_str());
    return image ? *image : QImage();
}

Camera cameraAt(double distance)
{
    Camera camera;
    camera.target = {0.0, 8.0, 0.0};
    camera.distance = distance;
    return camera;
}

/// What a picture without a background shows.
struct Covered
{
    double share = 0.0, light = 0.0; ///< of the picture; mean of its colours
};
Covered coveredOf(const QImage& image)
{
    Covered sum;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            sum.share += qAlpha(pixel) / 255.0;
            sum.light += qAlpha(pixel) / 255.0 * qGreen(pixel);
        }
    return {sum.share / (image.width() * image.height()), sum.light / std::max(sum.share, 1.0)};
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
        context.makeCurrent(&surface); // another one may be
        renderer.reset();
        target.reset();
    }
    RenderStats draw(const RenderScene& scene, const Camera& camera)
    {
        renderer->draw(scene, camera, pictureSize, target->handle(), {});
        return renderer->stats();
    }
};

/// One tree as a prototype, whole and in its forms.
struct Prototype
{
    CrowdPrototype own;
    std::shared_ptr<const std::vector<MeshItem>> whole;
};

Prototype prototypeOf(const NodeParams& params)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = params;
    node.params.tree = node.params.local = {};
    const TreeResult tree = *TreePipeline().evaluate(params);
    SceneView view;
    view.meadow = false;
    const RenderScene alone = SceneBuilder().build(
        *Scene::fromNodes({node}), [&](NodeId) { return &tree; }, view);
    Prototype made;
    made.whole = std::make_shared<const std::vector<MeshItem>>(alone.meshes);
    made.own.box = alone.box;
    made.own.forms = *crowdForms(tree, params);
    for (const MeshItem& item : alone.meshes) {
        made.own.wholeTriangles +=
            item.copies ? 2 * std::int64_t(item.copies->copies.size()) : item.mesh.faceCount();
        made.own.crown = item.crown;
    }
    return made;
}

RenderScene sceneOf(std::vector<ScatterPlace> places, const std::vector<Prototype>& prototypes)
{
    std::vector<CrowdPrototype> own;
    CrowdItem item;
    item.node = 7;
    for (const Prototype& one : prototypes) {
        own.push_back(one.own);
        item.whole.push_back(one.whole);
    }
    item.crowd =
        *Crowd::make(std::make_shared<const std::vector<ScatterPlace>>(std::move(places)), std::move(own));
    RenderScene scene;
    scene.crowds.push_back(std::move(item));
    scene.updateBoxes();
    return scene;
}

std::vector<ScatterPlace> scattered(std::size_t count, double spacing, std::uint32_t prototypes)
{
    std::vector<ScatterPlace> places;
    Random random(3, RandomStream::Test);
    const double side = spacing * std::sqrt(double(count));
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = random.range(0.0, glm::two_pi<double>());
        places.push_back({{side * random.range(-0.5, 0.5), 0.0, side * random.range(-0.5, 0.5)},
                          random.range(0.7, 1.2),
                          {std::cos(0.5 * turn), 0.0, std::sin(0.5 * turn), 0.0},
                          std::uint32_t(i) % prototypes});
    }
    return places;
}

} // namespace

class TestCrowdPictures : public QObject
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
        m_tree = prototypeOf(*presetParams("SilverBirch"));
        QVERIFY(m_tree.own.forms.size() >= 3);
    }
    void init() { test::failOnAnyWarning(); }

    void aCrowdOfNobodyIsTheSceneWithoutIt()
    {
        const RenderScene none = sceneOf({}, {m_tree});
        QVERIFY(none.box.empty());
        QCOMPARE(picture(none, cameraAt(30.0)), picture(RenderScene(), cameraAt(30.0)));
        Camera away = cameraAt(30.0);
        away.target -= 100.0 * away.backward(); // all is behind it
        const RenderScene one = sceneOf({ScatterPlace()}, {m_tree});
        CrowdPictures shown;
        shown.of(one, away, pictureSize, {});
        QCOMPARE(shown.counts().all, std::size_t(1));
        QCOMPARE(shown.counts().seen, std::size_t(0));
    }
    void everyFormHasTheSizeAndColourOfTheTree()
    {
        RenderScene alone;
        alone.meshes = *m_tree.whole;
        alone.updateBoxes();
        const RenderScene crowd = sceneOf({ScatterPlace()}, {m_tree});
        RenderOptions bare;
        bare.world = false;
        const Covered whole = coveredOf(picture(alone, cameraAt(40.0), bare));
        QVERIFY(whole.share > 0.02);
        for (std::size_t form = 0; form < m_tree.own.forms.size(); ++form) {
            Prototype only = m_tree;
            only.own.forms = {m_tree.own.forms[form]};
            only.own.forms.front().leastPixels = 0.0;
            only.own.wholeTriangles = 0;
            const Covered seen = coveredOf(picture(sceneOf({ScatterPlace()}, {only}), cameraAt(40.0), bare));
            const QByteArray told = QByteArray::number(qulonglong(form)) + ": share " +
                                    QByteArray::number(seen.share / whole.share) + ", light " +
                                    QByteArray::number(seen.light / whole.light);
            QVERIFY2(seen.share > 0.5 * whole.share && seen.share < 1.6 * whole.share, told);
            QVERIFY2(seen.light > 0.75 * whole.light && seen.light < 1.35 * whole.light, told);
        }
    }
    void nothingIsUploadedTwice()
    {
        const RenderScene scene = sceneOf(scattered(300, 7.0, 1), {m_tree});
        Bench bench;
        Camera camera = cameraAt(60.0);
        RenderStats before = bench.draw(scene, camera);
        QVERIFY(before.crowd.seen > 20 && before.crowd.triangles > 0);
        RenderStats after = bench.draw(scene, camera);
        QCOMPARE(after.uploads.uploads, before.uploads.uploads);
        QCOMPARE(after.uploads.bytes, before.uploads.bytes);
        QCOMPARE(after.shadowRedraws, before.shadowRedraws);
        camera.yawRad += 0.02;
        after = bench.draw(scene, camera);
        // The lists of places, and forms that were not seen before.
        QVERIFY(after.uploads.uploads > before.uploads.uploads);
        before = bench.draw(scene, cameraAt(60.0));
        camera.yawRad += 0.01;
        after = bench.draw(scene, camera);
        QVERIFY2(after.uploads.bytes - before.uploads.bytes < 200'000,
                 qPrintable(QString::number(after.uploads.bytes - before.uploads.bytes)));
    }
    void aDraftIsCoarser()
    {
        const RenderScene scene = sceneOf(scattered(300, 7.0, 1), {m_tree});
        CrowdPictures shown;
        RenderOptions options;
        options.quality = Quality::Good;
        options.sparing = true;
        shown.of(scene, cameraAt(60.0), pictureSize, options);
        const CrowdCounts good = shown.counts();
        options.hurried = true;
        shown.of(scene, cameraAt(60.0), pictureSize, options);
        QCOMPARE(shown.counts().seen, good.seen);
        QVERIFY(shown.counts().triangles < good.triangles);
        QCOMPARE(shown.counts().whole, std::size_t(0));
    }
    void treesStandInEachOthersShadow()
    {
        RenderOptions options;
        const RenderScene one = sceneOf({ScatterPlace()}, {m_tree});
        options.shadows = false;
        const QImage lit = picture(one, cameraAt(60.0), options);
        options.shadows = true;
        const QImage shaded = picture(one, cameraAt(60.0), options);
        QVERIFY(lit != shaded);
    }

private:
    Prototype m_tree;
};

RAMURE_SUITE(TestCrowdPictures)

} // namespace tst_crowd_pictures

#include "tst_crowd_pictures.moc"
