// What a scene takes up while it plays: once framed, nothing leaves the picture at any frame.
#include "core/scene/demo_scenes.h"
#include "tests/support/suite.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/framing_points.h"
#include "widgets/view/render/scene_builder.h"
#include <algorithm>
#include <cmath>

namespace tst_framing_points {

using namespace ramure;

namespace {

RenderScene builtAt(const Scene& scene, double seconds)
{
    SceneBuilder builder;
    SceneView view;
    view.timeSeconds = seconds;
    return builder.build(
        scene, [](NodeId) { return nullptr; }, view);
}

/// How far the points go out of the picture: 1 = its edge.
double furthest(const Camera& camera, const std::vector<glm::dvec3>& points, double aspect)
{
    double most = 0.0;
    for (const glm::dvec3& point : points) {
        const auto at = camera.project(point, aspect);
        most = std::max(most, at ? std::max(std::abs(at->x), std::abs(at->y)) : 1e9);
    }
    return most;
}

} // namespace

class TestFramingPoints : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void anEmptySceneReachesNothing()
    {
        QVERIFY(framingPoints(Scene(), RenderScene()).empty());
        QVERIFY(!momentsOf(Scene()).empty());
    }
    void momentsGoFromTheFirstFrameToTheLast()
    {
        Scene scene;
        TimelineSettings timeline;
        timeline.firstFrame = 12;
        timeline.lastFrame = 48;
        timeline.framesPerSecond = 24.0;
        scene.setTimeline(timeline);
        const std::vector<double> moments = momentsOf(scene);
        QCOMPARE(moments.front(), 0.5);
        QCOMPARE(moments.back(), 2.0);
        QVERIFY(std::is_sorted(moments.begin(), moments.end()));
    }
    void whatStandsStillReachesWhatIsSeen()
    {
        Scene scene = *demoScene("MovingCylinder");
        for (Node& node : std::vector<Node>(scene.nodes()))
            scene.find(node.id)->animation = {};
        const RenderScene built = builtAt(scene, 0.0);
        QVERIFY(framingPoints(scene, built) == built.framePoints());
    }
    void nothingLeavesTheViewWhileItPlays_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("MovingCylinder") << "MovingCylinder";
        QTest::newRow("MovingTree") << "MovingTree";
    }
    void nothingLeavesTheViewWhileItPlays()
    {
        QFETCH(const QString, name);
        const Scene scene = *demoScene(name.toStdString());
        const TimelineSettings& timeline = scene.timeline();
        for (const double opened : {0.0, 2.5}) { // whatever frame is on show
            const std::vector<glm::dvec3> reach = framingPoints(scene, builtAt(scene, opened));
            for (const double aspect : {0.7, 1.6}) {
                Camera camera;
                camera.frame(reach, aspect);
                double most = 0.0;
                for (qint64 frame = timeline.firstFrame; frame <= timeline.lastFrame; frame += 5)
                    most = std::max(
                        most, furthest(camera,
                                       builtAt(scene, double(frame) / timeline.framesPerSecond).framePoints(),
                                       aspect));
                QVERIFY2(most <= 1.0, qPrintable(QString::number(most)));
                QVERIFY2(most > 0.75, "and it is not farther away than it need be");
            }
        }
    }
};

RAMURE_SUITE(TestFramingPoints)

} // namespace tst_framing_points

#include "tst_framing_points.moc"
