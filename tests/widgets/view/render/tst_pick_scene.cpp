#include "tests/support/sample_tree.h"
#include "tests/support/suite.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <QElapsedTimer>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

namespace tst_pick_scene {

using namespace ramure;

namespace {

RenderScene lineScene(const Skeleton& skeleton, const glm::dmat4& world = glm::dmat4(1.0))
{
    auto lines = std::make_shared<LineSet>();
    for (Index i = 0; i < skeleton.size(); ++i) {
        lines->segments.push_back({glm::vec3(skeleton.p0[i]), glm::vec3(skeleton.p1[i]), 1.5f, 1.5f, {}, i});
        lines->box.add(skeleton.p0[i]);
        lines->box.add(skeleton.p1[i]);
    }
    RenderScene scene;
    scene.lines.push_back({lines, world, 3, false, true});
    scene.updateBoxes();
    return scene;
}

PickView viewOf(const RenderScene& scene, bool orthographic)
{
    PickView view;
    view.size = {800.0, 600.0};
    view.camera.orthographic = orthographic;
    view.camera.frame(scene.box, view.aspect());
    return view;
}

glm::dvec2 pixelOf(const PickView& view, const glm::dvec3& point)
{
    const glm::dvec2 ndc = *view.camera.project(point, view.aspect());
    return 0.5 * glm::dvec2(ndc.x + 1.0, 1.0 - ndc.y) * view.size;
}

double pixelDistance(const PickView& view, const glm::dvec2& pixel, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec2 from = pixelOf(view, a);
    const glm::dvec2 way = pixelOf(view, b) - from;
    const double share = std::clamp(glm::dot(pixel - from, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(from + share * way - pixel);
}

} // namespace

class TestPickScene : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingInAnEmptyScene()
    {
        const PickScene picker(RenderScene(), nullptr);
        QVERIFY(!picker.pick(PickView(), {0.0, 0.0}));
        QVERIFY(picker.inRectangle(PickView(), {0.0, 0.0}, {1.0, 1.0}).empty());
    }
    void flattenedNodesCannotBePicked()
    {
        RenderScene scene = test::sampleScene(2, 0);
        scene.meshes[0].world = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 1.0));
        scene.updateBoxes();
        QVERIFY(!PickScene(scene, nullptr).pick(viewOf(scene, false), {400.0, 300.0}));
    }
    void lockedNodesCannotBePicked()
    {
        RenderScene scene = test::sampleScene(2, 0);
        const PickView view = viewOf(scene, false);
        const glm::dvec2 trunk = pixelOf(view, {0.0, 0.5, 0.0});
        QVERIFY(PickScene(scene, nullptr).pick(view, trunk));
        scene.meshes[0].pickable = false;
        QVERIFY(!PickScene(scene, nullptr).pick(view, trunk));
    }
    void trunkUnderTheCursor_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("perspective") << false;
        QTest::newRow("orthographic") << true;
    }
    void trunkUnderTheCursor()
    {
        QFETCH(bool, orthographic);
        const RenderScene scene = test::sampleScene(4, 4);
        const PickView view = viewOf(scene, orthographic);
        const auto hit = PickScene(scene, nullptr).pick(view, pixelOf(view, {0.0, 0.4, 0.0}));
        QVERIFY(hit);
        QCOMPARE(hit->branch, 0u);
        QCOMPARE(hit->node, NodeId(1));
        QVERIFY(glm::length(hit->point - glm::dvec3(0.0, 0.4, 0.0)) < 0.12);
        QVERIFY(!PickScene(scene, nullptr).pick(view, {2.0, 2.0}));
    }
    void orthographicViewsReachBehindTheEye()
    {
        const RenderScene scene = test::sampleScene(2, 0);
        PickView view = viewOf(scene, true);
        view.camera.target -= 50.0 * view.camera.backward();
        QVERIFY(PickScene(scene, nullptr).pick(view, pixelOf(view, {0.0, 0.4, 0.0})));
        const RenderScene lines = lineScene(test::sampleSkeleton(3));
        QVERIFY(PickScene(lines, nullptr).pick(view, pixelOf(view, {0.0, 0.4, 0.0})));
    }
    void linesAgreeWithBruteForce_data() { trunkUnderTheCursor_data(); }
    void linesAgreeWithBruteForce()
    {
        QFETCH(bool, orthographic);
        const Skeleton skeleton = test::sampleSkeleton(6);
        const glm::dmat4 world = glm::rotate(glm::translate(glm::dmat4(1.0), {3.0, 1.0, -2.0}), 0.7,
                                             glm::normalize(glm::dvec3(1, 2, 3))) *
                                 glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 2.0, 1.5));
        const RenderScene scene = lineScene(skeleton, world);
        const PickScene picker(scene, nullptr);
        const PickView view = viewOf(scene, orthographic);
        const auto moved = [&](const glm::dvec3& p) {
            return glm::dvec3(world * glm::dvec4(glm::dvec3(glm::vec3(p)), 1.0));
        };
        Random random(1, RandomStream::Test);
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            const Index near = random.below(skeleton.size());
            const glm::dvec2 pixel =
                pixelOf(view, moved(glm::mix(skeleton.p0[near], skeleton.p1[near], random.unit()))) +
                glm::dvec2(random.range(-15.0, 15.0), random.range(-15.0, 15.0));
            double least = 6.0;
            for (Index k = 0; k < skeleton.size(); ++k)
                least =
                    std::min(least, pixelDistance(view, pixel, moved(skeleton.p0[k]), moved(skeleton.p1[k])));
            const auto hit = picker.pick(view, pixel);
            QCOMPARE(bool(hit), least < 6.0);
            if (!hit)
                continue;
            ++hits;
            const double found =
                pixelDistance(view, pixel, moved(skeleton.p0[hit->branch]), moved(skeleton.p1[hit->branch]));
            QVERIFY2(found <= std::max(least, 1.5) + 1e-6,
                     qPrintable(QString("%1 %2").arg(found).arg(least)));
            QVERIFY(glm::length(pixelOf(view, hit->point) - pixel) < found + 1e-6);
        }
        QVERIFY(hits > 50);
    }
    void frontLineWins()
    {
        auto lines = std::make_shared<LineSet>();
        lines->segments.push_back({{-1, 0, 0}, {1, 0, 0}, 1.5f, 1.5f, {}, 0});
        lines->segments.push_back({{-1, 0, 1}, {1, 0, 1}, 1.5f, 1.5f, {}, 1});
        lines->segments.push_back({{-1, 0, 2}, {1, 0, 2}, 1.5f, 1.5f, {}, noIndex});
        lines->box.add(glm::dvec3(-1.0));
        lines->box.add(glm::dvec3(2.0));
        RenderScene scene;
        scene.lines.push_back({lines, glm::dmat4(1.0), 3, false, true});
        scene.updateBoxes();
        PickView view = viewOf(scene, true);
        view.camera.target = {};
        view.camera.setAxisView(AxisView::Front);
        QCOMPARE(PickScene(scene, nullptr).pick(view, pixelOf(view, {0.3, 0.0, 0.0}))->branch, 1u);
        view.camera.setAxisView(AxisView::Back);
        QCOMPARE(PickScene(scene, nullptr).pick(view, pixelOf(view, {0.3, 0.0, 0.0}))->branch, 0u);
    }
    void linesBehindTheEyeAreNotPicked()
    {
        const RenderScene scene = lineScene(test::sampleSkeleton(4));
        PickView view = viewOf(scene, false);
        view.camera.target += 100.0 * view.camera.backward();
        const PickScene picker(scene, nullptr);
        view.camera.orbit(3.14159265, 0.0); // the tree is now far behind
        view.camera.target += 100.0 * view.camera.backward();
        view.camera.orbit(3.14159265, 0.0);
        view.camera.target -= 1000.0 * view.camera.backward();
        for (int i = 0; i < 20; ++i)
            QVERIFY(!picker.pick(view, {40.0 * i, 300.0}));
    }
    void rectangleTakesWhatItTouches_data() { trunkUnderTheCursor_data(); }
    void rectangleTakesWhatItTouches()
    {
        QFETCH(bool, orthographic);
        const Skeleton skeleton = test::sampleSkeleton(5);
        const RenderScene scene = lineScene(skeleton);
        const PickScene picker(scene, nullptr);
        const PickView view = viewOf(scene, orthographic);
        Random random(2, RandomStream::Test);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec2 a(random.range(0.0, 800.0), random.range(0.0, 600.0));
            const glm::dvec2 b(random.range(0.0, 800.0), random.range(0.0, 600.0));
            std::set<Index> sampled; // certain: a point of the line lies well inside
            for (Index k = 0; k < skeleton.size(); ++k) {
                for (int s = 0; s <= 40; ++s) {
                    const glm::dvec2 at = pixelOf(view, glm::mix(skeleton.p0[k], skeleton.p1[k], s / 40.0));
                    if (glm::all(glm::greaterThan(at, glm::min(a, b) + 0.01)) &&
                        glm::all(glm::lessThan(at, glm::max(a, b) - 0.01)))
                        sampled.insert(k);
                }
            }
            const auto picked = picker.inRectangle(view, a, b);
            std::set<Index> found;
            if (!picked.empty())
                found.insert(picked[0].branches.begin(), picked[0].branches.end());
            QVERIFY(std::includes(found.begin(), found.end(), sampled.begin(), sampled.end()));
            for (const Index k : found) {
                if (sampled.contains(k))
                    continue; // touched between two samples: near the rectangle at least
                double least = 1e9;
                for (int s = 0; s <= 400; ++s) {
                    const glm::dvec2 at = pixelOf(view, glm::mix(skeleton.p0[k], skeleton.p1[k], s / 400.0));
                    least = std::min(least, glm::length(at - glm::clamp(at, glm::min(a, b), glm::max(a, b))));
                }
                QVERIFY2(least < 1.0, qPrintable(QString::number(least)));
            }
        }
    }
    void rectangleInsideOneFace()
    {
        const RenderScene scene = test::sampleScene(3, 0);
        const PickView view = viewOf(scene, false);
        const glm::dvec2 trunk = pixelOf(view, {0.0, 0.5, 0.0});
        const auto picked = PickScene(scene, nullptr).inRectangle(view, trunk - 0.5, trunk + 0.5);
        QCOMPARE(picked.size(), std::size_t(1));
        QCOMPARE(picked[0].branches, std::vector<Index>{0});
        const auto all = PickScene(scene, nullptr).inRectangle(view, {0.0, 0.0}, {800.0, 600.0});
        QCOMPARE(all[0].branches.size(), std::size_t(test::sampleSkeleton(3).size()));
    }
    void hierarchiesAreTakenOver()
    {
        RenderScene scene = test::sampleScene(4, 4);
        const PickScene first(scene, nullptr);
        scene.meshes[0].world = glm::translate(glm::dmat4(1.0), {1.0, 0.0, 0.0});
        scene.updateBoxes();
        std::stop_source source;
        source.request_stop();
        const PickView view = viewOf(scene, false);
        const glm::dvec2 trunk = pixelOf(view, {1.0, 0.3, 0.0});
        QVERIFY(!PickScene(scene, &first, source.get_token()).pick(view, trunk));
        QCOMPARE(PickScene(scene, &first).pick(view, trunk)->branch, 0u);
    }
};

RAMURE_SUITE(TestPickScene)

} // namespace tst_pick_scene

#include "tst_pick_scene.moc"
