#include "core/lod/tree_levels.h"
#include "core/presets/presets.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include <QApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace tst_level_silhouettes {

using namespace ramure;

namespace {

/// Pixels of the picture a side for one of the silhouette: the leaves of the level before are smaller than
/// one of the silhouette, and samples between them would be noise.
constexpr int finer = 8;
constexpr double views[] = {0.3, 2.4, -1.8};
const std::vector<std::int64_t> game{20'000, 5'000, 1'250};

RenderScene sceneOf(const TreeLevel& level)
{
    RenderScene scene;
    for (const auto& mesh : {level.bark, level.leaves, level.apples}) {
        if (!mesh)
            continue;
        MeshItem item;
        for (const glm::vec3& position : mesh->positions)
            item.box.add(glm::dvec3(position));
        item.mesh = mesh;
        item.material.twoSided = true;
        scene.box.add(item.box.min);
        scene.box.add(item.box.max);
        scene.meshes.push_back(std::move(item));
    }
    return scene;
}

/// How much of each pixel the tree covers, when it is \p pixels high.
std::vector<double> silhouette(OffscreenRenderer& renderer, const RenderScene& scene, const Box& box,
                               double yaw, int pixels)
{
    Camera camera;
    camera.orthographic = true;
    camera.yawRad = yaw;
    camera.pitchRad = 0.1;
    camera.frame(box, 1.0, 1.0);
    const double side = camera.heightAtTarget() / box.size().y * pixels;
    const int size = std::max(1, int(std::lround(side)));
    RenderOptions options;
    options.world = options.ground = options.shadows = options.outline = false;
    options.samples = 8;
    const auto image = renderer.draw(scene, camera, {finer * size, finer * size}, options);
    if (!image)
        qFatal("%s", test::why(image).constData());
    std::vector<double> cover(std::size_t(size) * std::size_t(size), 0.0);
    for (int y = 0; y < image->height(); ++y)
        for (int x = 0; x < image->width(); ++x)
            cover[std::size_t(y / finer) * std::size_t(size) + std::size_t(x / finer)] +=
                qAlpha(image->pixel(x, y)) / (255.0 * finer * finer);
    return cover;
}

/// What two share of what either covers.
double overlap(const std::vector<double>& a, const std::vector<double>& b)
{
    double both = 0.0, either = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += std::min(a[i], b[i]);
        either += std::max(a[i], b[i]);
    }
    return both / either;
}

} // namespace

class TestLevelSilhouettes : public QObject
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

    /// Where the details in which they differ are a pixel, a level looks about like the one before: as much
    /// of the picture is covered, mostly the same places. The figures go to the log.
    void neighboursAreAlikeWhereTheySwitch_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("isWhole");
        QTest::addColumn<double>("bar");
        const auto add = [](const char* name, bool isWhole, double bar) {
            QTest::addRow("%s%s", name, isWhole ? ", whole" : "")
                << QString::fromLatin1(name) << isWhole << bar;
        };
        add("SmallTree", false, 0.865);
        add("EnglishOak1995", false, 0.91);
        add("SilverBirch1995", false, 0.86);
        add("ScotsPine1995", false, 0.87);
        add("CoconutPalmRules", false, 0.92);
        add("WeepingWillow1995", false, 0.865);
        add("CommonAsh1995", false, 0.865);
        add("OrchardApple1995", false, 0.835);
        add("FanTree", false, 0.865);
        add("EuropeanBeech1995", false, 0.87);
        add("NorwaySpruce1995", false, 0.835);
        add("CoconutPalmRules", true, 0.91); // its trunk's lean is its outline
        add("CommonAsh1995", true, 0.925);
        add("EnglishOak1995", true, 0.945);
    }
    void neighboursAreAlikeWhereTheySwitch()
    {
        QFETCH(QString, name);
        QFETCH(bool, isWhole);
        QFETCH(double, bar);
        OffscreenRenderer renderer;
        QVERIFY(renderer.begin());
        const NodeParams params = *presetParams(name.toLatin1().constData());
        TreePipeline pipeline;
        const LevelOptions options{3, isWhole ? std::vector<std::int64_t>() : game};
        const auto tree = pipeline.evaluate(params, stageOfLevels(options));
        QVERIFY2(tree, test::why(tree));
        const auto levels = treeLevels(*tree, params, options);
        QVERIFY2(levels, test::why(levels));
        const Box box = sceneOf(levels->front()).box;
        for (std::size_t i = 1; i < levels->size(); ++i) {
            const int pixels = std::max(8, int(std::lround(box.size().y / (*levels)[i].detail)));
            double least = 1.0, before = 0.0, after = 0.0;
            for (const double yaw : views) {
                const auto fine = silhouette(renderer, sceneOf((*levels)[i - 1]), box, yaw, pixels);
                const auto coarse = silhouette(renderer, sceneOf((*levels)[i]), box, yaw, pixels);
                least = std::min(least, overlap(fine, coarse));
                before += std::accumulate(fine.begin(), fine.end(), 0.0);
                after += std::accumulate(coarse.begin(), coarse.end(), 0.0);
            }
            qInfo("%s, level %d at %d pixels: overlap %.3f, cover %.2f of the one before", qPrintable(name),
                  int(i), pixels, least, after / before);
            QVERIFY2(least > bar, QByteArray::number(least));
            QVERIFY2(std::abs(after / before - 1.0) < 0.07, QByteArray::number(after / before));
        }
    }
};

RAMURE_SUITE(TestLevelSilhouettes)

} // namespace tst_level_silhouettes

#include "tst_level_silhouettes.moc"
