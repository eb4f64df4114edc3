// Home and the first picture: what is visible fills the view.
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/demo_scenes.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/scene_builder.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/view_settings.h"
#include <QApplication>
#include <QScopeGuard>
#include <atomic>

namespace tst_framing {

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(60'000);

/// How much of the picture's width or height, whichever is more, everything visible takes up; over 1 where
/// something is cut off.
double filled(const test::ViewWindow& window)
{
    SceneBuilder builder;
    const RenderScene scene = posed(builder.build(
        window.document.scene(),
        [&](NodeId id) {
            const NodeResult* result = window.document.result(id);
            return result ? &result->tree : nullptr;
        },
        SceneView()));
    const double aspect = double(window.view->width()) / window.view->height();
    glm::dvec2 low(1e9), high(-1e9);
    for (const MeshItem& item : scene.meshes)
        for (const glm::vec3& p : item.mesh->positions) {
            const auto at = window.view->camera().project(
                glm::dvec3(item.world * glm::dvec4(glm::dvec3(p), 1.0)), aspect);
            if (!at)
                return 1e9;
            low = glm::min(low, *at);
            high = glm::max(high, *at);
        }
    if (std::max({-low.x, -low.y, high.x, high.y}) > 1.0)
        return 1e9;
    return 0.5 * std::max(high.x - low.x, high.y - low.y);
}

/// The scene becomes the one tree.
NodeId openPreset(test::ViewWindow& window, const std::string& name)
{
    Scene scene;
    Node node;
    node.id = scene.newId();
    node.kind = NodeKind::Tree;
    node.params = presetParams(name).value();
    (void)scene.insert({node}, noNode, 0);
    window.document.reset(std::move(scene), {});
    return node.id;
}

} // namespace

class TestFraming : public QObject
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

    void whatIsVisibleFillsTheView_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QSize>("size");
        for (const Preset& preset : courseworkPresets())
            for (const QSize size : {QSize(640, 360), QSize(320, 480)})
                QTest::addRow("%s in %dx%d", preset.name, size.width(), size.height())
                    << QString::fromLatin1(preset.name) << size;
        QTest::addRow("an arm") << QStringLiteral("Arm") << QSize(640, 360);
    }
    void whatIsVisibleFillsTheView()
    {
        QFETCH(const QString, name);
        QFETCH(const QSize, size);
        test::ViewWindow window;
        Recompute recompute(&window.document);
        if (const auto demo = demoScene(name.toStdString()))
            window.document.reset(*demo, {});
        else
            openPreset(window, name.toStdString());
        QVERIFY(recompute.waitForFull(patienceMs));
        window.show(size);
        const double atStart = filled(window);
        QVERIFY2(atStart > 0.85 && atStart <= 1.0, qPrintable(QString::number(atStart)));
        Camera far = window.view->camera();
        far.distance *= 20.0;
        far.target.x += 3.0;
        window.view->setCamera(far);
        window.view->frameAll();
        QTRY_VERIFY2(filled(window) > 0.85 && filled(window) <= 1.0,
                     qPrintable(QString::number(filled(window))));
        window.keep(qPrintable(name));
    }

    void anOldPictureSaysSo()
    {
        test::ViewWindow window;
        std::atomic<bool> mayGrow = true;
        const auto pipeline = std::make_shared<TreePipeline>();
        const auto grow = [&mayGrow, pipeline](const NodeParams& params, const Progress& progress) {
            mayGrow.wait(false);
            return pipeline->evaluate(params, Stage::Foliage, progress);
        };
        Recompute recompute(&window.document, {grow, grow, {}, {}});
        const auto goOn = qScopeGuard([&mayGrow] {
            mayGrow = true;
            mayGrow.notify_all();
        });
        const NodeId tree = openPreset(window, "TinyTree");
        QVERIFY(recompute.waitForFull(patienceMs));
        window.show(QSize(640, 360));
        const auto says = [&window] { return !window.view->accessibleDescription().isEmpty(); };
        QTRY_VERIFY(!says());
        mayGrow = false;
        QVERIFY(edit::setParam(window.document, {tree}, *findParam("turtle.theta"), 0.3));
        QTRY_VERIFY(says());
        window.keep("out-of-date");
        mayGrow = true;
        mayGrow.notify_all();
        QVERIFY(recompute.waitForFull(patienceMs));
        QTRY_VERIFY(!says() && !window.view->work().picture);
        window.keep("of-now");
    }

    /// As long as nobody moves the camera and no hand tool is chosen; it returns with the tree, to the last
    /// bit.
    void treesThatGrowAreFollowed()
    {
        test::ViewWindow window;
        Recompute recompute(&window.document);
        const NodeId tree = openPreset(window, "TinyTree");
        QVERIFY(recompute.waitForFull(patienceMs));
        window.show(QSize(640, 360));
        const Viewport& view = *window.view;
        const auto waitForAll = [&] {
            QVERIFY(recompute.waitForFull(patienceMs));
            QTRY_VERIFY(!view.work().picture);
        };
        const auto grow = [&](double factor) {
            const double now = window.document.scene().find(tree)->params.turtle.alpha;
            QVERIFY(edit::setParam(window.document, {tree}, *findParam("turtle.alpha"), factor * now));
            waitForAll();
        };
        const auto fills = [&] { return filled(window) > 0.8 && filled(window) <= 1.0; };
        const Camera first = view.camera();
        for (const bool turned : {false, true}) {
            Camera own = first;
            own.orbit(turned ? 0.7 : 0.0, 0.0);
            own.zoom(turned ? 2.0 : 1.0, own.target);
            window.view->setCamera(own);
            grow(0.5); // still in the view
            QVERIFY(view.camera() == own);
            grow(12.0);
            QVERIFY(view.camera() != own && fills());
            QCOMPARE(view.camera().yawRad, own.yawRad);
            grow(2.0);
            QVERIFY(fills());
            window.keep(turned ? "followed-turned" : "followed");
            for (int i = 0; i < 3; ++i)
                window.document.undo();
            waitForAll();
            QVERIFY(view.camera() == own);
        }
        grow(6.0);
        Camera near = view.camera();
        near.zoom(0.5, near.target);
        window.view->setCamera(near); // what sticks out of the view does so on purpose
        grow(2.0);
        QVERIFY(view.camera() == near);
        window.view->setCamera(first);
        window.document.undo();
        window.document.undo();
        waitForAll();
        window.host.settings()->hand()->setTool(HandTool::Length);
        grow(6.0);
        QVERIFY(view.camera() == first);
    }
};

RAMURE_SUITE(TestFraming)

} // namespace tst_framing

#include "tst_framing.moc"
