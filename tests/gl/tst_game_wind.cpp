#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/scene/preset_scene.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "tests/support/wind_preview.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/scene_builder.h"
#include "widgets/view/screenshot.h"
#include <glm/gtc/constants.hpp>

namespace tst_game_wind {

using namespace ramure;

namespace {

constexpr double direction = 0.7; ///< rad
constexpr WindMoment moments[] = {{1.0, 1.37}, {0.6, 12.9}};

Node treeNode(const char* preset)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "Tree";
    node.params = *presetParams(preset);
    node.params.physics.windDirection = direction;
    return node;
}

/// What the processor knows of a tree in the wind.
struct Known
{
    TreeResult result;
    WindTree tree;
    WindElements elements;
    struct Part
    {
        std::shared_ptr<const TriangleMesh> mesh;
        std::vector<WindVertex> vertices;
    };
    std::vector<Part> parts;
    WindSettings settings;

    explicit Known(const NodeParams& params)
        : result(*TreePipeline().evaluate(params))
        , tree(windTree(*result.skeleton, *result.simplified))
        , elements(*windElements(tree, windLeaves(*result.leaves, result.foliage->leaves)))
    {
        const std::shared_ptr<const TriangleMesh> bark(result.branches, &result.branches->mesh);
        parts.push_back({bark, windOfBark(tree, *bark)});
        parts.push_back({result.leaves, windOfItems(tree, *result.leaves, result.foliage->leaves, true)});
        if (result.apples && !result.apples->empty())
            parts.push_back(
                {result.apples, windOfItems(tree, *result.apples, result.foliage->apples, false)});
        for (Part& part : parts)
            for (std::size_t v = 0; v < part.vertices.size(); ++v)
                part.vertices[v].element =
                    part.mesh == result.leaves
                        ? elements.ofLeaf[v / (part.vertices.size() / result.foliage->leaves.size())]
                        : elements.ofStem[tree.stemOf[part.mesh->branch[v]]];
        settings = windSettings(tree, {});
    }
    /// The meshes where the formula has them.
    [[nodiscard]] RenderScene moved(WindProfile profile, const WindMoment& moment,
                                    const glm::dmat4& world) const
    {
        RenderScene scene;
        const WindNow now{{std::cos(direction), 0.0, -std::sin(direction)}, moment.strength, moment.seconds};
        for (const Part& part : parts) {
            TriangleMesh mesh = *part.mesh;
            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                mesh.positions[v] = glm::vec3(
                    windPreview(profile, {glm::dvec3(mesh.positions[v]), glm::dvec3(mesh.normals[v])},
                                part.vertices[v], settings, elements, now));
            MeshItem item;
            item.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
            item.box = meshBox(*item.mesh);
            item.material.twoSided = true;
            item.world = world;
            scene.meshes.push_back(std::move(item));
        }
        scene.updateBoxes();
        return scene;
    }
};

RenderScene sceneOf(const Known& known, const Node& node, WindProfile profile)
{
    SceneBuilder builder;
    SceneView view;
    view.wind = profile;
    const auto scene = Scene::fromNodes({node});
    return builder.build(
        *scene, [&](NodeId) { return &known.result; }, view);
}

QImage picture(OffscreenRenderer& renderer, const RenderScene& scene, const Camera& camera,
               const WindMoment& wind)
{
    RenderOptions options;
    options.world = options.shadows = options.outline = false;
    options.quality = Quality::Best; // which draws all triangles of leaves
    options.samples = 0;
    options.wind = wind;
    const auto image = renderer.draw(scene, camera, {600, 600}, options);
    if (!image)
        qFatal("%s", test::why(image).constData());
    return *image;
}

/// Of the pixels that either covers, the share that only one does.
double unlike(const QImage& a, const QImage& b)
{
    double either = 0.0, one = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const bool inA = qAlpha(a.pixel(x, y)) > 127, inB = qAlpha(b.pixel(x, y)) > 127;
            either += inA || inB;
            one += inA != inB;
        }
    return either > 0.0 ? one / either : 1.0;
}

} // namespace

/// Trees in the wind of a game as the view shows them.
class TestGameWind : public QObject
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

    void cardMovesAsTheFormulas_data()
    {
        QTest::addColumn<QString>("preset");
        for (const char* preset : {"SmallTree", "FanPalm"})
            QTest::newRow(preset) << QString::fromLatin1(preset);
    }
    /// Seen from so near that a pixel is a millimetre, too.
    void cardMovesAsTheFormulas()
    {
        QFETCH(const QString, preset);
        const Node node = treeNode(preset.toLatin1().constData());
        const Known known(node.params);
        OffscreenRenderer renderer;
        QVERIFY(renderer.begin());
        for (const WindProfileFacts& facts : windProfiles())
            for (const WindMoment& moment : moments) {
                const RenderScene shown = sceneOf(known, node, facts.profile);
                const glm::dmat4& world = shown.meshes.front().world;
                const RenderScene meant = known.moved(facts.profile, moment, world);
                Camera camera;
                camera.orthographic = true;
                camera.yawRad = -0.4;
                camera.frame(meant.box, 1.0, 1.0);
                const QImage whole = picture(renderer, shown, camera, moment);
                const double off = unlike(whole, picture(renderer, meant, camera, {})),
                             moved = unlike(whole, picture(renderer, shown, camera, {0.0, 0.0}));
                const glm::vec3 top = *std::ranges::max_element(meant.meshes[1].mesh->positions, {},
                                                                [](const glm::vec3& p) { return p.y; });
                camera.target = glm::dvec3(world * glm::dvec4(glm::dvec3(top), 1.0));
                camera.distance *= 0.6 / camera.heightAtTarget();
                const double close =
                    unlike(picture(renderer, shown, camera, moment), picture(renderer, meant, camera, {}));
                qInfo("%s, %s: %.4f of the picture differ, %.4f from near; moved %.2f", qPrintable(preset),
                      facts.name, off, close, moved);
                QVERIFY2(off < 0.01, facts.name);
                QVERIFY2(close < 0.01, facts.name);
                QVERIFY2(moved > 0.1, facts.name);
            }
    }

    void whatBonesMoveDoesNotStandInIt()
    {
        const Node node = treeNode("SmallTree");
        const Known known(node.params);
        const RenderScene shown = sceneOf(known, node, WindProfile::Plain);
        QVERIFY(std::ranges::all_of(
            shown.meshes, [](const MeshItem& item) { return item.motion.wind && !item.motion.isStill(); }));
        MotionFrame frame;
        NodeMotion& motion = frame.nodes[1];
        motion.step = 1;
        motion.bones = std::make_shared<const std::vector<RigidTransform>>(
            known.result.simplified->skeleton.size() + known.result.foliage->apples.size());
        MovingScene moving;
        const RenderScene moved = moving.moved(shown, frame);
        QVERIFY(std::ranges::none_of(moved.meshes,
                                     [](const MeshItem& item) { return item.motion.wind != nullptr; }));
        const RenderScene still = sceneOf(known, node, WindProfile::None);
        QVERIFY(
            std::ranges::all_of(still.meshes, [](const MeshItem& item) { return item.motion.isStill(); }));
    }

    /// Picture follows picture while it blows, each another one; then the view is as it was.
    void viewMovesAndComesToRest()
    {
        test::ViewWindow window;
        window.document.reset(*presetScene("TinyTree"), {});
        NodeResult result;
        result.tree = *TreePipeline().evaluate(*presetParams("TinyTree"));
        window.document.setResult(window.document.scene().nodes().front().id, std::move(result));
        window.show({500, 400});
        const QImage rest = screenshot(*window.view);
        ViewSettings* settings = window.host.settings();
        QSignalSpy messages(window.view, &Viewport::messageRaised);
        settings->gameWindStrength.set(1.0);
        settings->gameWind.set(WindProfile::Unity);
        window.waitForPicture();
        QSignalSpy drawn(window.view, &Viewport::frameDrawn);
        QTRY_VERIFY_WITH_TIMEOUT(drawn.size() > 3, test::patience(60'000));
        const QImage blown = screenshot(*window.view);
        window.keep("game_wind");
        QVERIFY(test::differing(blown, rest) > 500);
        QTRY_VERIFY_WITH_TIMEOUT(test::differing(screenshot(*window.view), blown) > 500,
                                 test::patience(60'000));
        settings->gameWind.set(WindProfile::None);
        window.waitForPicture();
        QVERIFY(screenshot(*window.view) == rest);
        QVERIFY(messages.isEmpty());
    }

    void withoutATreeItIsSaidWhy()
    {
        test::ViewWindow window;
        window.show({300, 200});
        QSignalSpy messages(window.view, &Viewport::messageRaised);
        window.host.settings()->gameWind.set(WindProfile::Plain);
        QCOMPARE(messages.size(), 1);
        QVERIFY(messages.front().front().toString().contains(QLatin1String("no tree")));
    }
};

RAMURE_SUITE(TestGameWind)

} // namespace tst_game_wind

#include "tst_game_wind.moc"
