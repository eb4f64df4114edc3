// Home and the first picture: what is visible fills the view.
#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/demo_scenes.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/gl_setup.h"
#include "widgets/view/render/scene_builder.h"
#include <QApplication>

namespace tst_framing {

using namespace ramure;

namespace {

constexpr int patienceMs = 60'000;

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
        if (const auto demo = demoScene(name.toStdString())) {
            window.document.reset(*demo, {});
        } else {
            Scene scene;
            Node node;
            node.id = scene.newId();
            node.kind = NodeKind::Tree;
            node.params = *presetParams(name.toStdString());
            QVERIFY(scene.insert({node}, noNode, 0));
            window.document.reset(std::move(scene), {});
        }
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
};

RAMURE_SUITE(TestFraming)

} // namespace tst_framing

#include "tst_framing.moc"
