// A picture of the best quality is made in parts where the processor draws: it is the same, and other things
// happen meanwhile.
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/cannot_run.h"
#include "tests/support/preset_trees.h"
#include "tests/support/sample_tree.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/renderer.h"
#include <QDialog>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <limits>

namespace tst_picture_parts {

using namespace ramure;

namespace {

const QSize pictureSize(320, 240);

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
        context.makeCurrent(&surface);
        renderer.reset();
        target.reset();
    }
};

/// All that a picture may hold: a mesh in many triangles, one of few, copies, colours, ghosts, lines, points,
/// what is marked and what is seen through.
RenderScene fullScene()
{
    auto skeleton = *test::presetSkeleton({.name = "SmallTree", .iterations = 7});
    LeafParams leaf;
    leaf.shape = LeafShape::Linden;
    const auto foliage = *placeFoliage(skeleton, {}, leaf, {}, 0.5);
    RenderScene scene = test::sampleScene(5, 8);
    MeshItem crown = test::sampleItem(buildLeaves(skeleton, foliage, 0.5, FoliageModel::Fine), "leaves", 2);
    crown.copies = std::make_shared<MeshCopies>(leafCopies(foliage, 0.5, FoliageModel::Fine));
    scene.meshes.push_back(std::move(crown));
    TriangleMesh coloured = test::sampleBranches(test::sampleSkeleton(2));
    coloured.colours.assign(coloured.faceCount(), {200, 40, 40});
    scene.meshes.push_back(test::sampleItem(std::move(coloured), "branches", 3));
    scene.meshes.back().opacity = 0.5f;
    scene.meshes.back().world[3].x = 1.5;
    scene.meshes.front().outlined = std::make_shared<const OutlinedFaces>();
    scene.highlights.push_back({1, std::make_shared<const BranchStates>(40, BranchState::Selected)});
    scene.updateBoxes();
    return scene;
}

Camera cameraOf(const RenderScene& scene)
{
    Camera camera;
    camera.pitchRad = 0.18;
    camera.frame(scene.box, double(pictureSize.width()) / pictureSize.height(), 1.3);
    return camera;
}

/// A tree at best quality, drawn by the processor.
struct Window : test::ViewWindow
{
    NodeId tree = noNode;

    explicit Window(int iterations)
    {
        Scene scene;
        Node node;
        node.id = tree = scene.newId();
        node.kind = NodeKind::Tree;
        node.params = *presetParams("SmallTree");
        node.params.grammar.iterations = iterations;
        (void)scene.insert({node}, noNode, 0);
        document.reset(std::move(scene), {});
        NodeResult result;
        result.revision = document.revision();
        result.tree = *TreePipeline().evaluate(node.params);
        document.setResult(tree, std::move(result));
        view->setSoftware(true);
        host.settings()->quality.set(Quality::Best);
    }
    [[nodiscard]] bool isWhole() const { return !view->work().settling && !view->work().parts; }
    /// Of orange ink in the picture of now, below the words that say what it is.
    [[nodiscard]] int ink() const
    {
        const QImage image = view->grabFramebuffer();
        int count = 0;
        for (int y = 60; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y).red() > 235 && image.pixelColor(x, y).blue() < 60;
        return count;
    }
};

struct PaintedDialog : QDialog
{
    bool isPainted = false;
    void paintEvent(QPaintEvent* event) override
    {
        QDialog::paintEvent(event);
        isPainted = true;
    }
};

} // namespace

class TestPictureParts : public QObject
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

    void itIsTheSamePicture_data()
    {
        QTest::addColumn<RenderOptions>("options");
        RenderOptions options;
        options.quality = Quality::Best;
        options.smoothing = options.sparing = options.grid = true;
        QTest::newRow("solid") << options;
        options.shading = ShadingMode::SolidWire;
        QTest::newRow("wire over solid") << options;
        options.shading = ShadingMode::Solid;
        options.quality = Quality::Good;
        QTest::newRow("good") << options;
        options.ground = options.shadows = false;
        QTest::newRow("without ground") << options;
    }
    /// Each part as short as can be: one draw.
    void itIsTheSamePicture()
    {
        QFETCH(const RenderOptions, options);
        const RenderScene scene = fullScene();
        const Camera camera = cameraOf(scene);
        Bench bench;
        const GLuint target = bench.target->handle();
        bench.renderer->draw(scene, camera, pictureSize, target, options);
        const QImage atOnce = bench.target->toImage();
        for (const double ms : {0.0, 3.0, std::numeric_limits<double>::infinity()}) {
            RenderOptions quick = options;
            quick.hurried = true;
            bench.renderer->draw(scene, camera, pictureSize, target, quick);
            const QImage meanwhile = bench.target->toImage();
            int parts = 1;
            while (!bench.renderer->drawPart(scene, camera, pictureSize, options, 0, ms)) {
                QVERIFY(++parts < 10'000);
                bench.renderer->show(pictureSize, target);
                QVERIFY(bench.target->toImage() == meanwhile);
            }
            QVERIFY(ms > 0.0 || parts > 30);
            QVERIFY(!std::isinf(ms) || parts == 1);
            bench.renderer->show(pictureSize, target);
            QVERIFY(bench.target->toImage() == atOnce);
        }
    }

    /// Begun with one camera and given up: nothing of it is left.
    void aPictureThatIsGivenUpLeavesNothing()
    {
        const RenderScene scene = fullScene();
        const Camera camera = cameraOf(scene);
        Camera other = camera;
        other.yawRad += 1.0;
        RenderOptions options;
        options.quality = Quality::Best;
        options.smoothing = true;
        Bench bench;
        bench.renderer->draw(scene, camera, pictureSize, bench.target->handle(), options);
        const QImage atOnce = bench.target->toImage();
        for (const int begun : {1, 5, 20, 60, 100}) {
            bench.renderer->restartParts();
            for (int i = 0; i < begun; ++i)
                if (bench.renderer->drawPart(scene, other, pictureSize, options, 0, 0.0))
                    break;
            bench.renderer->restartParts();
            while (!bench.renderer->drawPart(scene, camera, pictureSize, options, 0, 5.0)) {
            }
            bench.renderer->show(pictureSize, bench.target->handle());
            QVERIFY2(bench.target->toImage() == atOnce, QByteArray::number(begun));
        }
    }

    /// A dialog that opens while the picture is being made is painted before that is whole.
    void dialogsArePaintedMeanwhile()
    {
        Window window(9);
        window.show({1200, 900});
        QTRY_VERIFY_WITH_TIMEOUT(window.isWhole(), 120'000);
        const QImage whole = window.view->grabFramebuffer();

        window.host.settings()->gridVisible.set(!window.host.settings()->gridVisible());
        window.waitForPicture();
        QTRY_VERIFY(window.view->work().parts);
        QVERIFY(window.view->grabFramebuffer() != whole);
        PaintedDialog dialog;
        dialog.resize(300, 200);
        dialog.show();
        QTRY_VERIFY(dialog.isPainted);
        QVERIFY(window.view->work().parts);
        dialog.close();
        QTRY_VERIFY_WITH_TIMEOUT(window.isWhole(), 120'000);
        window.host.settings()->gridVisible.set(!window.host.settings()->gridVisible());
        window.waitForPicture();
        QTRY_VERIFY_WITH_TIMEOUT(window.isWhole(), 120'000);
        QVERIFY(window.view->grabFramebuffer() == whole);
    }

    /// The line around the selection lies over the picture, which is not begun anew while that fades.
    void theLineThatFadesLiesOverIt()
    {
        Window window(4);
        window.show({320, 240});
        QTRY_VERIFY_WITH_TIMEOUT(window.isWhole(), 120'000);
        QCOMPARE(window.ink(), 0);
        window.document.setSelection({{window.tree}, noNode, {}, noIndex});
        window.waitForPicture();
        QTRY_VERIFY(window.ink() > 40);
        QTRY_VERIFY_WITH_TIMEOUT(window.isWhole(), 120'000);
        int begun = 0;
        connect(window.view, &Viewport::frameDrawn, this, [&] { begun += window.isWhole() ? 0 : 1; });
        QTRY_COMPARE(window.ink(), 0);
        QCOMPARE(begun, 0);
    }
};

RAMURE_SUITE(TestPictureParts)

} // namespace tst_picture_parts

#include "tst_picture_parts.moc"
