#include "core/scene/demo_scenes.h"
#include "core/scene/motion_path.h"
#include "core/scene/node_transform.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

namespace tst_motion_path {

using namespace ramure;

namespace {

Scene cylinder()
{
    return demoScene("MovingCylinder").value_or(Scene());
}

NodeId moving(const Scene& scene)
{
    for (const Node& node : scene.nodes())
        if (node.animation.movesNode())
            return node.id;
    return noNode;
}

} // namespace

class TestMotionPath : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingMovesNowhere()
    {
        const Scene scene = cylinder();
        QVERIFY(motionChain(scene, 999).links.empty());
        QVERIFY(!motionChain(scene, 999).moves());
        QCOMPARE(motionChain(scene, 999).worldAt(1.0), glm::dmat4(1.0));
    }
    void stoppedIsSaid()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto path = motionPath({}, TimelineSettings{}, {stop.get_token(), {}});
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::Cancelled);
    }
    void everyFrameIsWhereTheSceneIs()
    {
        Scene scene = cylinder();
        Node child;
        child.id = 77;
        child.parent = moving(scene);
        child.name = "child";
        child.params.tree.translation = {1.0, 2.0, 3.0};
        Key a, b;
        b.time = ticksPerSecond / 3; // between two frames
        b.value = 5.0;
        child.animation.set(globalChannel(0), AnyTrack(*Track::fromKeys({a, b})));
        QVERIFY(scene.insert({child}, child.parent, 0));
        TimelineSettings timeline = scene.timeline();
        timeline.firstFrame = -10;
        timeline.lastFrame = 60;
        const MotionChain chain = motionChain(scene, 77);
        QVERIFY(chain.moves());
        const auto path = motionPath(chain, timeline);
        QVERIFY(path);
        QCOMPARE(path->points.size(), std::size_t(71));
        for (std::size_t i = 0; i < path->points.size(); ++i) {
            const double seconds = timeline.timeOf(-10 + std::int64_t(i));
            QVERIFY(glm::distance(path->points[i],
                                  glm::dvec3(worldTransformAt(scene, 77, seconds).world[3])) < 1e-12);
        }
        QVERIFY(path->keys.size() >= 2);
        bool between = false;
        for (const glm::dvec3& key : path->keys)
            between = between ||
                      glm::distance(key, glm::dvec3(worldTransformAt(scene, 77, 1.0 / 3.0).world[3])) < 1e-9;
        QVERIFY(between);
    }
    void tracksOfParametersDoNotCount()
    {
        Scene scene = cylinder();
        Node& node = *scene.find(moving(scene));
        const MotionChain before = motionChain(scene, node.id);
        Key key;
        const ParamId radius = paramId(*findParam("primitive.radius"));
        node.animation.set(Channel{ChannelPart::Parameter, 0, radius}, AnyTrack(*Track::fromKeys({key})));
        QCOMPARE(motionChain(scene, node.id), before); // nothing to compute anew
        node.params.tree.translation.x += 1.0;
        QVERIFY(motionChain(scene, node.id) != before);
    }
    /// The cylinder of the demo stands 5 m from its node, which only turns.
    void whatIsShownIsFollowed()
    {
        const Scene scene = cylinder();
        const NodeId node = moving(scene);
        const auto path = motionPath(motionChain(scene, node), scene.timeline());
        QVERIFY(path);
        for (std::size_t i = 0; i < path->points.size(); ++i) {
            const double seconds = scene.timeline().timeOf(scene.timeline().firstFrame + std::int64_t(i));
            const glm::dvec3 shown(worldTransformAt(scene, node, seconds).geometry[3]);
            QVERIFY(glm::distance(path->points[i], shown) < 1e-12);
        }
        QVERIFY(glm::distance(path->points.front(), path->points.back()) > 1.0);
    }
    void longRangesEndSomewhere()
    {
        Scene scene = cylinder();
        TimelineSettings timeline;
        timeline.firstFrame = 0;
        timeline.lastFrame = 900'000;
        const auto path = motionPath({}, timeline);
        QCOMPARE(std::int64_t(path->points.size()), mostPathFrames);
    }
};

RAMURE_SUITE(TestMotionPath)

} // namespace tst_motion_path

#include "tst_motion_path.moc"
