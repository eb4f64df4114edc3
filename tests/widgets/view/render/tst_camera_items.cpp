#include "widgets/view/render/camera_items.h"

#include "core/math/random.h"
#include "tests/support/suite.h"
#include "widgets/view/render/scene_builder.h"
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace tst_camera_items {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double worst = 0.0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            worst = std::max(worst, std::abs(a[c][r] - b[c][r]));
    return worst;
}

Node cameraNode()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Camera;
    node.name = "Camera";
    node.params.tree.translation = {1.0, 2.0, 3.0};
    return node;
}

RenderScene built(const Node& node, const SceneView& view)
{
    return SceneBuilder().build(
        *Scene::fromNodes({node}), [](NodeId) { return nullptr; }, view);
}

} // namespace

class TestCameraItems : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void flatPlacesStillSeeSomething()
    {
        for (const Camera& camera :
             {cameraAt(glm::dmat4(0.0), {}),
              cameraAt(glm::scale(glm::dmat4(1.0), {1.0, 0.0, 0.0}), {0.5, 1.0, 0.0})}) {
            QVERIFY(std::isfinite(camera.yawRad) && std::isfinite(camera.rollRad));
            QVERIFY(camera.distance > 0.0);
        }
    }
    void itSeesFromWhereTheNodeStands()
    {
        Random random(11, RandomStream::Test);
        for (int i = 0; i < 300; ++i) {
            // Straight up and down among them, and turned about the line of sight.
            const double pitch = i % 3 == 0 ? (i % 2 == 0 ? 0.5 : -0.5) * pi : random.range(-1.5, 1.5);
            glm::dmat4 world = glm::translate(
                glm::dmat4(1.0), glm::dvec3(random.range(-9, 9), random.range(-9, 9), random.range(-9, 9)));
            world = glm::rotate(world, random.range(-pi, pi), glm::dvec3(0.0, 1.0, 0.0));
            world = glm::rotate(world, pitch, glm::dvec3(1.0, 0.0, 0.0));
            world = glm::rotate(world, random.range(-pi, pi), glm::dvec3(0.0, 0.0, 1.0));
            const glm::dmat4 scaled = glm::scale(world, glm::dvec3(random.range(0.1, 4.0)));
            const CameraParams params{random.range(0.1, 2.0), 0.0, random.range(0.1, 30.0)};
            const Camera camera = cameraAt(scaled, params);
            QVERIFY(difference(standingOf(camera), world) < 1e-9);
            QCOMPARE(camera.fovRad, params.angleRad);
            QVERIFY(glm::length(camera.target - glm::dvec3(world * glm::dvec4(0, 0, -params.focus, 1))) <
                    1e-8);
            QVERIFY(difference(camera.viewMatrix() * world, glm::dmat4(1.0)) < 1e-8);
        }
    }
    void theLensIsTheNodes()
    {
        QCOMPARE(lensOf({}).diameter, 0.0);
        const Lens lens = lensOf({0.471, 2.0, 7.0});
        QCOMPARE(lens.focus, 7.0);
        QVERIFY(std::abs(lens.diameter - 0.025) < 1e-4); // 50 mm, f/2
    }
    void otherNodesAreNotSeenThrough()
    {
        Node node = cameraNode();
        const Scene cameras = *Scene::fromNodes({node});
        EvaluatedScene now(cameras);
        QVERIFY(!viewThrough(now, noNode));
        QVERIFY(!viewThrough(now, 9));
        const auto seen = viewThrough(now, 1);
        QVERIFY(seen);
        QVERIFY(glm::length(seen->camera.eye() - glm::dvec3(1.0, 2.0, 3.0)) < 1e-12);
        node.kind = NodeKind::Group;
        const Scene groups = *Scene::fromNodes({node});
        EvaluatedScene other(groups);
        QVERIFY(!viewThrough(other, 1));
    }
    void nobodyFramesACamera()
    {
        SceneView view;
        QVERIFY(built(cameraNode(), view).meshes.empty()); // pictures have none
        view.cameras = true;
        const RenderScene scene = built(cameraNode(), view);
        QCOMPARE(scene.meshes.size(), std::size_t(1));
        QCOMPARE(scene.meshes.front().node, NodeId(1));
        QVERIFY(scene.meshes.front().pickable);
        QVERIFY(scene.box.empty());
        QVERIFY(scene.casters.empty());
        QVERIFY(scene.framePoints().empty());
        QVERIFY(!scene.trailBox.empty()); // but it is drawn
        Node locked = cameraNode();
        locked.locked = true;
        QVERIFY(!built(locked, view).meshes.front().pickable);
        view.seenThrough = 1;
        QVERIFY(built(cameraNode(), view).meshes.empty());
    }
    void itsLinesShowWhatItSees()
    {
        SceneView view;
        view.cameras = true;
        Node node = cameraNode();
        const std::size_t sharp = built(node, view).lines.front().lines->segments.size();
        node.params.camera.fStop = 2.0;
        const RenderScene scene = built(node, view);
        QCOMPARE(scene.lines.front().lines->segments.size(), sharp + 4); // and where it is sharp
        const Camera camera = cameraAt(scene.lines.front().world, node.params.camera);
        double highest = 0.0;
        for (const LineSegment& line : scene.lines.front().lines->segments) {
            const auto at = camera.project(
                glm::dvec3(scene.lines.front().world * glm::dvec4(glm::dvec3(line.b), 1.0)), 16.0 / 9.0);
            if (at && std::abs(std::abs(at->x) - 1.0) < 1e-6)
                highest = std::max(highest, at->y);
        }
        QVERIFY(std::abs(highest - 1.0) < 1e-6);
    }
};

RAMURE_SUITE(TestCameraItems)

} // namespace tst_camera_items

#include "tst_camera_items.moc"
