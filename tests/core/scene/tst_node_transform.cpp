#include "core/math/drag_maths.h"
#include "core/math/random.h"
#include "core/scene/node_transform.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tst_node_transform {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

struct Dice
{
    Random random{77, RandomStream::Test};
    double number(double low, double high) { return low + (high - low) * random.unit(); }
    glm::dvec3 point(double far = 5.0) { return {number(-far, far), number(-far, far), number(-far, far)}; }
    glm::dvec3 direction() { return glm::normalize(point() + glm::dvec3(0.0, 0.01, 0.0)); }
    PlacementParams placement(bool even)
    {
        PlacementParams p{point(), point(3.0), glm::dvec3(number(0.2, 3.0))};
        if (!even)
            p.scale = {number(0.2, 3.0), number(0.2, 3.0), number(0.2, 3.0)};
        return p;
    }
};

NodeAnimation::TrackPtr track(double first, double last)
{
    Key a, b;
    a.mode = b.mode = KeyMode::Linear;
    a.value = first;
    b.time = 2 * ticksPerSecond;
    b.value = last;
    return std::make_shared<const AnyTrack>(*Track::fromKeys({a, b}));
}

NodeAnimation::TrackPtr turns(const glm::dvec3& axis, double angle)
{
    OrientationKey a, b;
    a.mode = b.mode = KeyMode::Linear;
    b.time = 2 * ticksPerSecond;
    b.value = glm::angleAxis(angle, axis);
    return std::make_shared<const AnyTrack>(*OrientationTrack::fromKeys({a, b}));
}

Node nodeOf(NodeId id, NodeId parent)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = NodeKind::Primitive;
    node.name = std::string("n").append(std::to_string(id));
    return node;
}

/// Three nodes below each other, the uppermost and the last with tracks.
Scene animated(Dice& dice, bool even)
{
    std::vector<Node> nodes{nodeOf(1, noNode), nodeOf(2, 1), nodeOf(3, 2)};
    for (Node& node : nodes)
        node.params.tree = dice.placement(even);
    for (const std::size_t at : {std::size_t(0), std::size_t(2)}) {
        NodeAnimation& animation = nodes[at].animation;
        animation.set(globalChannel(0), track(dice.number(-2, 2), dice.number(-2, 2)));
        animation.set(globalChannel(3), turns(dice.direction(), dice.number(-3, 3)));
        for (std::size_t c = 4; c < 7 && !even; ++c)
            animation.set(globalChannel(c), track(dice.number(0.5, 2), dice.number(0.5, 2)));
    }
    return *Scene::fromNodes(nodes);
}

void put(Scene& scene, NodeId id, const NodeTransform& values)
{
    Node& node = *scene.find(id);
    node.params.tree = values.placement;
    for (std::size_t i = 0; i < values.tracks.size(); ++i)
        node.animation.set(globalChannel(i), values.tracks[i]);
}

double worst(const glm::dmat4& a, const glm::dmat4& b)
{
    double most = 0.0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            most = std::max(most, std::abs(a[c][r] - b[c][r]));
    return most;
}

glm::dmat4 asMatrix(const glm::dmat3& axes, const glm::dvec3& pivot)
{
    glm::dmat4 matrix(axes);
    matrix[3] = glm::dvec4(pivot - axes * pivot, 1.0);
    return matrix;
}

} // namespace

class TestNodeTransform : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenNumbersAreRefused()
    {
        Scene scene = *Scene::fromNodes({nodeOf(1, noNode)});
        const auto starts = transformStarts(scene, {1}, 0.0, false);
        WorldTransform broken;
        broken.move.x = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!transformed(starts.front(), broken));
        broken = {};
        broken.factors.y = std::numeric_limits<double>::infinity();
        QVERIFY(!transformed(starts.front(), broken));
    }
    void onlyFreeTopNodesStart()
    {
        std::vector<Node> nodes{nodeOf(1, noNode), nodeOf(2, 1),      nodeOf(3, 2),     nodeOf(4, noNode),
                                nodeOf(5, 4),      nodeOf(6, noNode), nodeOf(7, noNode)};
        nodes[3].visible = false;
        nodes[5].locked = true;
        Scene scene = *Scene::fromNodes(nodes);
        const auto starts = transformStarts(scene, {7, 3, 5, 6, 1, 99, 2, 7}, 0.0, false);
        QCOMPARE(starts.size(), std::size_t(2));
        QCOMPARE(starts[0].node, NodeId(7)); // in the order of selecting
        QCOMPARE(starts[1].node, NodeId(1));
        QVERIFY(transformStarts(scene, {}, 0.0, false).empty());
    }
    void belowSomethingFlatNothingStarts()
    {
        std::vector<Node> nodes{nodeOf(1, noNode), nodeOf(2, 1)};
        nodes[0].animation.set(globalChannel(5), track(0.0, 1.0));
        Scene scene = *Scene::fromNodes(nodes);
        QVERIFY(transformStarts(scene, {2}, 0.0, false).empty());
        QCOMPARE(transformStarts(scene, {2}, 1.0, false).size(), std::size_t(1));
    }
    void nothingChangesNothing()
    {
        Dice dice;
        for (int i = 0; i < 100; ++i) {
            Scene scene = animated(dice, false);
            const auto start = transformStarts(scene, {3}, 0.7, i % 2 == 0).front();
            const auto same = transformed(start, {});
            QVERIFY(same);
            QCOMPARE(same->placement, start.values.placement);
            QCOMPARE(same->tracks, start.values.tracks); // the very same ones
        }
    }
    /// Whatever stands above, sheared by uneven scales too: the node goes by exactly what was said.
    void movesAreExact()
    {
        Dice dice;
        for (int i = 0; i < 400; ++i) {
            Scene scene = animated(dice, i % 3 == 0);
            const double seconds = dice.number(0.0, 2.0);
            const auto start = transformStarts(scene, {3}, seconds, i % 2 == 0).front();
            QCOMPARE(start.keys, i % 2 == 0);
            WorldTransform by;
            by.pivot = dice.point();
            by.move = dice.point();
            const auto values = transformed(start, by);
            QVERIFY(values);
            put(scene, 3, *values);
            const double at = start.keys ? secondsOf(ticksOf(seconds)) : seconds;
            glm::dmat4 wanted = start.world;
            wanted[3] += glm::dvec4(by.move, 0.0);
            QVERIFY(worst(worldTransformAt(scene, 3, at).world, wanted) < 1e-6);
            QCOMPARE(values->placement.rotation, start.values.placement.rotation);
            QCOMPARE(values->placement.scale, start.values.placement.scale);
        }
    }
    void turnsBelowEvenScalesAreExact()
    {
        Dice dice;
        for (int i = 0; i < 400; ++i) {
            Scene scene = animated(dice, true);
            const double seconds = secondsOf(ticksOf(dice.number(0.0, 2.0)));
            const auto start = transformStarts(scene, {3}, seconds, i % 2 == 0).front();
            WorldTransform by;
            by.pivot = dice.point();
            by.axis = dice.direction();
            by.angleRad = dice.number(-4.0, 4.0);
            const auto values = transformed(start, by);
            QVERIFY(values);
            put(scene, 3, *values);
            const glm::dmat4 wanted = asMatrix(turnAbout(by.axis, by.angleRad), by.pivot) * start.world;
            QVERIFY(worst(worldTransformAt(scene, 3, seconds).world, wanted) < 1e-6);
        }
    }
    void evenScalesAreExact()
    {
        Dice dice;
        for (int i = 0; i < 300; ++i) {
            Scene scene = animated(dice, false);
            const double seconds = secondsOf(ticksOf(dice.number(0.0, 2.0)));
            const auto start = transformStarts(scene, {2}, seconds, true).front();
            QVERIFY(!start.keys); // it has no track itself
            WorldTransform by;
            by.pivot = dice.point();
            by.factors = glm::dvec3(dice.number(0.3, 3.0));
            by.frame = turnAbout(dice.direction(), 1.0);
            const auto values = transformed(start, by);
            QVERIFY(values);
            put(scene, 2, *values);
            const glm::dmat4 wanted = asMatrix(glm::dmat3(by.factors.x), by.pivot) * start.world;
            QVERIFY(worst(worldTransformAt(scene, 2, seconds).world, wanted) < 1e-6);
            QCOMPARE(values->placement.rotation, start.values.placement.rotation);
        }
    }
    void scalesAlongOwnAxesTouchOneComponent()
    {
        Node node = nodeOf(1, noNode);
        node.params.tree = {{1, 2, 3}, {0.3, -0.4, 0.5}, {1.0, 2.0, 0.5}};
        Scene scene = *Scene::fromNodes({node});
        const auto starts = transformStarts(scene, {1}, 0.0, false);
        WorldTransform by;
        by.pivot = pivotOf(starts);
        by.frame = transformAxes(starts, TransformSpace::Local);
        by.factors.y = 1.5;
        const auto values = transformed(starts.front(), by);
        QCOMPARE(values->placement.scale.x, 1.0);
        QVERIFY(std::abs(values->placement.scale.y - 3.0) < 1e-12);
        QCOMPARE(values->placement.scale.z, 0.5);
        QCOMPARE(values->placement.translation, node.params.tree.translation);
        by.factors.y = 0.0; // flat, or a mirror image, is not in the range: as small as may be
        QCOMPARE(transformed(starts.front(), by)->placement.scale.y, 1e-4);
    }
    void anglesStayNear()
    {
        Node node = nodeOf(1, noNode);
        node.params.tree.rotation = {0.0, 0.0, 3.0};
        Scene scene = *Scene::fromNodes({node});
        WorldTransform by;
        by.axis = {0, 0, 1};
        by.angleRad = 0.5 * pi;
        auto start = transformStarts(scene, {1}, 0.0, false).front();
        by.pivot = start.origin();
        const auto values = transformed(start, by);
        QVERIFY(std::abs(values->placement.rotation.z - (3.0 + 0.5 * pi)) < 1e-12); // beyond 180 degrees
        QCOMPARE(values->placement.rotation.x, 0.0);
        QCOMPARE(values->placement.translation, glm::dvec3(0.0));
        // Through the pole of the angles: still a turn, Z stays.
        scene.find(1)->params.tree.rotation = {0.2, 0.0, 0.4};
        start = transformStarts(scene, {1}, 0.0, false).front();
        by.axis = glm::dvec3(start.world[1]);
        Dice dice;
        for (int i = 0; i < 200; ++i) {
            by.angleRad = i == 0 ? 0.5 * pi : dice.number(-7.0, 7.0);
            const auto turned = transformed(start, by);
            PlacementParams now = turned->placement;
            QVERIFY(worst(placementMatrix(now), glm::dmat4(turnAbout(by.axis, by.angleRad)) * start.world) <
                    1e-9);
        }
    }
    void keysAreMadeOnlyWhereSomethingChanges()
    {
        Node node = nodeOf(1, noNode);
        node.animation.set(globalChannel(0), track(1.0, 3.0));
        Scene scene = *Scene::fromNodes({node});
        const auto start = transformStarts(scene, {1}, 1.0, true).front();
        QVERIFY(start.keys);
        WorldTransform by;
        by.move = {0.0, 2.0, 0.0};
        const auto values = transformed(start, by);
        QCOMPARE(values->placement, start.values.placement);
        const Track& x = std::get<Track>(*values->tracks[0]);
        QCOMPARE(x.size(), std::size_t(3)); // keyed already: it takes part
        QCOMPARE(x.keys()[1].value, 2.0);
        QCOMPARE(x.keys()[1].mode, KeyMode::Linear); // as the key before it
        QCOMPARE(std::get<Track>(*values->tracks[1]).keys().front().value, 2.0);
        QVERIFY(!values->tracks[2]);
        QVERIFY(!values->tracks[3]);
        QVERIFY(!values->tracks[4]);
    }
    void manyGoAboutTheirMiddle()
    {
        std::vector<Node> nodes{nodeOf(1, noNode), nodeOf(2, noNode)};
        nodes[0].params.tree.translation = {1, 0, 0};
        nodes[1].params.tree.translation = {3, 0, 0};
        Scene scene = *Scene::fromNodes(nodes);
        const auto starts = transformStarts(scene, {1, 2}, 0.0, false);
        WorldTransform by;
        by.pivot = pivotOf(starts);
        QCOMPARE(by.pivot, glm::dvec3(2, 0, 0));
        by.axis = {0, 1, 0};
        by.angleRad = 0.5 * pi;
        QVERIFY(glm::distance(transformed(starts[0], by)->placement.translation, {2, 0, 1}) < 1e-12);
        QVERIFY(glm::distance(transformed(starts[1], by)->placement.translation, {2, 0, -1}) < 1e-12);
        by.angleRad = 0.0;
        by.factors = glm::dvec3(2.0);
        QVERIFY(glm::distance(transformed(starts[0], by)->placement.translation, {0, 0, 0}) < 1e-12);
        by.factors = glm::dvec3(1.0);
        by.move = {0, 1, 0};
        QCOMPARE(transformed(starts[1], by)->placement.translation, glm::dvec3(3, 1, 0));
    }
};

RAMURE_SUITE(TestNodeTransform)

} // namespace tst_node_transform

#include "tst_node_transform.moc"
