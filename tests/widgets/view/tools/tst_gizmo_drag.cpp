#include "core/math/drag_maths.h"
#include "core/math/random.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/world_transforms.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/view/tools/gizmo/gizmo_drag.h"
#include <numbers>
namespace tst_gizmo_drag {
using namespace ramure;
namespace {

constexpr double pi = std::numbers::pi;
constexpr GizmoHandle xAxis{GizmoPart::Axis, 0}, yAxis{GizmoPart::Axis, 1}, centre{GizmoPart::Centre, 0};

Node box(NodeId id, NodeId parent, const glm::dvec3& at)
{
    Node node = test::groupNode(id, std::string("n").append(std::to_string(id)), parent);
    node.kind = NodeKind::Primitive;
    node.params.tree.translation = at;
    return node;
}

NodeAnimation::TrackPtr slope(double to)
{
    Key a, b;
    a.mode = b.mode = KeyMode::Linear;
    b.time = ticksPerSecond;
    b.value = to;
    return std::make_shared<const AnyTrack>(*Track::fromKeys({a, b}));
}

/// A group that turns and grows, a node in it, two beside it.
struct Desk
{
    Document document;
    GizmoSettings settings;
    PickView view;
    std::unique_ptr<GizmoDrag> drag;
    QByteArray before;

    Desk()
    {
        std::vector<Node> nodes{test::groupNode(1, "g"), box(2, 1, {1, 0.5, 0}), box(3, noNode, {-2, 0, 1}),
                                box(4, noNode, {-2, 2, 1})};
        nodes[0].params.tree = {{0.5, 0.0, 0.0}, {0.0, 0.6, 0.3}, glm::dvec3(2.0)};
        nodes[0].animation.set(globalChannel(0), slope(3.0));
        test::openNodes(document, nodes);
        document.reset(document.scene(), {}); // no steps
        view.size = {800.0, 600.0};
        view.camera.distance = 12.0;
        before = writeProject(document.project());
        select({3});
    }
    void select(std::vector<NodeId> nodes) { document.setSelection({std::move(nodes), noNode, {}, noIndex}); }
    [[nodiscard]] glm::dvec3 origin(NodeId id, double seconds = 0.0) const
    {
        return glm::dvec3(worldTransformAt(document.scene(), id, seconds).world[3]);
    }
    [[nodiscard]] const PlacementParams& placement(NodeId id) const
    {
        return document.scene().find(id)->params.tree;
    }
    [[nodiscard]] glm::dvec2 pixel(const glm::dvec3& world) const
    {
        const auto at = gizmoPixel(view, world);
        return {at->x(), at->y()};
    }
    [[nodiscard]] GizmoPlace place(double seconds = 0.0) const
    {
        const auto starts = transformStarts(document.scene(), document.selection().nodes, seconds, false);
        return {pivotOf(starts), transformAxes(starts, settings.space())};
    }
    void begin(TransformTool tool, std::optional<GizmoHandle> handle, double seconds = 0.0, bool keys = false)
    {
        hand = {500.0, 300.0};
        if (handle) {
            const auto grip = gizmoGrip(view, place(seconds), tool, *handle);
            hand = {grip->x(), grip->y()};
        }
        drag = GizmoDrag::begin(document, settings, tool, handle, seconds, keys, view, hand);
    }
    void by(glm::dvec2 pixels, GizmoModifiers modifiers = {})
    {
        for (int i = 1; i <= 5; ++i)
            drag->moveTo(view, hand + pixels * (i / 5.0), modifiers);
        hand += pixels;
    }
    GizmoDrag::KeyResult type(const char* text)
    {
        auto result = GizmoDrag::KeyResult::Ignored;
        for (const char c : QByteArray(text)) {
            const bool capital = c >= 'A' && c <= 'Z';
            const int other = c == '\b' ? int(Qt::Key_Backspace) : QChar(c).toUpper().unicode();
            const int key = c == '\t' ? int(Qt::Key_Tab) : other;
            result = drag->key(key, QString(QLatin1Char(c)), capital ? Qt::ShiftModifier : Qt::NoModifier);
        }
        return result;
    }
    glm::dvec2 hand{0.0};
};

} // namespace

/// Moving, turning and scaling by hand: without OpenGL.
class TestGizmoDrag : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutAnythingToMoveNothingBegins();
    void handlesAreFoundWhereTheyAreDrawn_data();
    void handlesAreFoundWhereTheyAreDrawn();
    void axesGoWithTheCursor();
    void theMiddleGoesWithTheCursor();
    void planesKeepTheThird();
    void ringsTurnWithTheCursor();
    void ringsFromTheEdgeTurnToo();
    void boxesScale();
    void controlSnaps();
    void shiftIsFine();
    void numbersGoBeforeTheHand();
    void axesAreLockedByLetters();
    void severalNumbersByTab();
    void wrongKeysAreLeftAlone();
    void cancellingRestoresEveryBit_data();
    void cancellingRestoresEveryBit();
    void cancellingLeavesWhatCanBeRedone();
    void whoeverEditsMeanwhileIsNotMixedUp();
    void parentsThatMoveAreRespected();
    void keysAreMadeAtThePlayhead();
    void severalGoTogether();
    void theHandlesStandAtWhatIsShown();
    void theReadoutHasUnits();
};

void TestGizmoDrag::withoutAnythingToMoveNothingBegins()
{
    Desk desk;
    desk.begin(TransformTool::Select, std::nullopt);
    QVERIFY(!desk.drag);
    desk.select({});
    desk.begin(TransformTool::Move, std::nullopt);
    QVERIFY(!desk.drag);
    QVERIFY(edit::setNodeLocked(desk.document, {3}, true));
    desk.select({3});
    desk.begin(TransformTool::Move, std::nullopt);
    QVERIFY(!desk.drag);
}

void TestGizmoDrag::handlesAreFoundWhereTheyAreDrawn_data()
{
    QTest::addColumn<bool>("orthographic");
    QTest::newRow("perspective") << false;
    QTest::newRow("orthographic") << true;
}

void TestGizmoDrag::handlesAreFoundWhereTheyAreDrawn()
{
    QFETCH(bool, orthographic);
    Desk desk;
    desk.view.camera.orthographic = orthographic;
    int found = 0;
    for (const TransformTool tool : {TransformTool::Move, TransformTool::Rotate, TransformTool::Scale})
        for (const GizmoPart part : {GizmoPart::Axis, GizmoPart::Plane, GizmoPart::Centre, GizmoPart::View})
            for (int axis = 0; axis < 3; ++axis) {
                const bool turn = tool == TransformTool::Rotate;
                if (turn ? part == GizmoPart::Plane || part == GizmoPart::Centre : part == GizmoPart::View)
                    continue;
                const GizmoHandle handle{part,
                                         part == GizmoPart::Centre || part == GizmoPart::View ? 0 : axis};
                const auto grip = gizmoGrip(desk.view, desk.place(), tool, handle);
                if (!grip)
                    continue; // seen from its end
                ++found;
                const auto at = gizmoHandleAt(desk.view, {grip->x(), grip->y()}, desk.place(), tool);
                QVERIFY(at);
                if (part != GizmoPart::Plane && tool != TransformTool::Rotate)
                    QCOMPARE(at->part, part);
            }
    QVERIFY(found > 15);
    QVERIFY(!gizmoHandleAt(desk.view, desk.pixel(desk.origin(3)), desk.place(), TransformTool::Select));
    QVERIFY(!gizmoHandleAt(desk.view, {5.0, 5.0}, desk.place(), TransformTool::Move));
    // Of one size, however far the camera.
    const auto reach = [&desk] {
        const auto line = gizmoAxisLine(desk.view, desk.place(), 1);
        return line ? line->length() : 0.0;
    };
    const double near = reach();
    desk.view.camera.distance *= 20.0;
    QVERIFY(std::abs(reach() - near) < 0.25 * near);
}

void TestGizmoDrag::axesGoWithTheCursor()
{
    Desk desk;
    const glm::dvec3 from = desk.origin(3);
    desk.begin(TransformTool::Move, xAxis);
    const glm::dvec2 way = desk.pixel(from + glm::dvec3(1, 0, 0)) - desk.pixel(from);
    desk.by(way);
    const glm::dvec3 by = desk.origin(3) - from;
    QVERIFY(std::abs(by.x - 1.0) < 0.15); // the grip is beside the pivot, the picture in perspective
    QCOMPARE(by.y, 0.0);
    QCOMPARE(by.z, 0.0);
    // The grip stays under the cursor.
    const auto grip = gizmoAxisLine(desk.view, desk.drag->place(), 0);
    QVERIFY(QLineF(grip->pointAt(0.85), QPointF(desk.hand.x, desk.hand.y)).length() < 6.0);
}

void TestGizmoDrag::theMiddleGoesWithTheCursor()
{
    Desk desk;
    desk.begin(TransformTool::Move, centre);
    desk.by({137.0, -61.0});
    QVERIFY(glm::distance(desk.pixel(desk.origin(3)), desk.hand) < 1e-6);
}

void TestGizmoDrag::planesKeepTheThird()
{
    Desk desk;
    desk.view.camera.pitchRad = 0.6;
    const glm::dvec3 from = desk.origin(3);
    desk.begin(TransformTool::Move, GizmoHandle{GizmoPart::Plane, 1});
    desk.by({80.0, 30.0});
    QCOMPARE(desk.origin(3).y, from.y);
    QVERIFY(std::abs(desk.origin(3).x - from.x) > 0.1);
    QVERIFY(std::abs(desk.origin(3).z - from.z) > 0.1);
}

void TestGizmoDrag::ringsTurnWithTheCursor()
{
    Desk desk;
    desk.view.camera.pitchRad = 0.9;
    desk.begin(TransformTool::Rotate, yAxis);
    // Along the ring: from where it was taken by 100 degrees and more.
    const GizmoPlace place = desk.place();
    const double radius = gizmoMetres(desk.view, place, gizmoRingReach);
    const glm::dvec3 zero = glm::normalize(
        *onPlane({desk.view.camera.ray(desk.view.ndc(desk.hand), desk.view.aspect()).origin,
                  desk.view.camera.ray(desk.view.ndc(desk.hand), desk.view.aspect()).direction},
                 place.pivot, {0, 1, 0}) -
        place.pivot);
    for (int i = 0; i <= 40; ++i) {
        const double angle = 1.5 * pi * i / 40.0;
        desk.drag->moveTo(desk.view, desk.pixel(place.pivot + radius * (turnAbout({0, 1, 0}, angle) * zero)),
                          {});
    }
    QVERIFY(std::abs(desk.drag->angleRad() - 1.5 * pi) < 1e-6); // more than half a round
    QVERIFY(std::abs(desk.placement(3).rotation.y) < 2.0 * pi);
    QCOMPARE(desk.placement(3).translation, glm::dvec3(-2, 0, 1));
}

void TestGizmoDrag::ringsFromTheEdgeTurnToo()
{
    Desk desk;
    desk.view.camera.pitchRad = 0.0;
    desk.view.camera.target = desk.origin(3);
    desk.begin(TransformTool::Rotate, yAxis);
    desk.by({gizmoRingReach, 0.0});
    QVERIFY(std::abs(desk.drag->angleRad() - 1.0) < 0.05); // a radius of way: one radian, to the right
}

void TestGizmoDrag::boxesScale()
{
    Desk desk;
    desk.settings.space.set(TransformSpace::Local);
    desk.begin(TransformTool::Scale, yAxis);
    const glm::dvec2 pivot = desk.pixel(desk.origin(3));
    desk.by(desk.hand - pivot); // twice as far
    QVERIFY(std::abs(desk.placement(3).scale.y - 2.0) < 0.1);
    QCOMPARE(desk.placement(3).scale.x, 1.0);
    QCOMPARE(desk.placement(3).scale.z, 1.0);
    desk.begin(TransformTool::Scale, centre);
    desk.by({120.0, 0.0});
    QVERIFY(std::abs(desk.placement(3).scale.x - 2.0) < 1e-9);
    desk.begin(TransformTool::Scale, centre);
    desk.by({-3000.0, 0.0}); // never flat nor mirrored
    QVERIFY(desk.placement(3).scale.x > 0.0);
}

void TestGizmoDrag::controlSnaps()
{
    Desk desk;
    const glm::dvec3 from = desk.origin(3);
    desk.settings.setSteps({0.25, 15.0, 0.5});
    desk.begin(TransformTool::Move, xAxis);
    desk.by({71.0, 3.0}, {true, false});
    const double steps = (desk.origin(3).x - from.x) / 0.25;
    QVERIFY(std::abs(steps - std::nearbyint(steps)) < 1e-9 && steps != 0.0);
    desk.settings.snaps.set(true); // always: then Ctrl is free of steps
    desk.begin(TransformTool::Rotate, GizmoHandle{GizmoPart::View, 0});
    desk.by({-40.0, 90.0});
    const double turns = desk.drag->angleRad() * 180.0 / pi / 15.0;
    QVERIFY(std::abs(turns - std::nearbyint(turns)) < 1e-9 && turns != 0.0);
    desk.by({1.0, 2.0}, {true, false});
    const double free = desk.drag->angleRad() * 180.0 / pi / 15.0;
    QVERIFY(std::abs(free - std::nearbyint(free)) > 1e-6);
}

void TestGizmoDrag::shiftIsFine()
{
    Desk desk;
    const glm::dvec3 from = desk.origin(3);
    desk.begin(TransformTool::Move, centre);
    desk.by({200.0, 0.0}, {false, true});
    const double fine = glm::distance(desk.origin(3), from);
    desk.drag->cancel();
    desk.begin(TransformTool::Move, centre);
    desk.by({200.0, 0.0});
    QVERIFY(std::abs(glm::distance(desk.origin(3), from) / fine - 10.0) < 0.5);
}

void TestGizmoDrag::numbersGoBeforeTheHand()
{
    Desk desk;
    desk.begin(TransformTool::Move, xAxis);
    desk.by({50.0, 0.0});
    QCOMPARE(desk.type("1.5"), GizmoDrag::KeyResult::Taken);
    QCOMPARE(desk.origin(3), glm::dvec3(-0.5, 0, 1));
    desk.by({50.0, 10.0}); // the hand says nothing now
    QCOMPARE(desk.origin(3), glm::dvec3(-0.5, 0, 1));
    desk.type("-");
    QCOMPARE(desk.origin(3), glm::dvec3(-3.5, 0, 1));
    desk.type("\b\b\b\b"); // nothing typed: the hand again
    QVERIFY(std::abs(desk.origin(3).x + 2.0) > 0.1);
    desk.type("2");
    QCOMPARE(desk.drag->key(Qt::Key_Return, {}, {}), GizmoDrag::KeyResult::Confirm);
    QCOMPARE(desk.origin(3), glm::dvec3(0, 0, 1));
    desk.drag->keep();
    QCOMPARE(desk.document.undoStack()->count(), 1);

    desk.begin(TransformTool::Rotate, std::nullopt);
    desk.type("y-90");
    QVERIFY(std::abs(desk.placement(3).rotation.y + 0.5 * pi) < 1e-12);
    QCOMPARE(desk.placement(3).rotation.x, 0.0);
    desk.begin(TransformTool::Scale, std::nullopt);
    desk.type("-2,5"); // no mirror images
    QCOMPARE(desk.placement(3).scale, glm::dvec3(2.5));
    desk.drag->keep();
    QCOMPARE(desk.document.undoStack()->count(), 3);
    desk.settings.radians.set(true);
    desk.begin(TransformTool::Rotate, std::nullopt);
    desk.type("y1.25");
    QVERIFY(std::abs(desk.placement(3).rotation.y - (1.25 - 0.5 * pi)) < 1e-12);
}

void TestGizmoDrag::axesAreLockedByLetters()
{
    Desk desk;
    QVERIFY(edit::setParam(desk.document, {3}, *findParam("tree.rotation"), glm::dvec3(0, 0.5 * pi, 0)));
    desk.begin(TransformTool::Move, std::nullopt);
    desk.type("x2");
    QCOMPARE(desk.origin(3), glm::dvec3(0, 0, 1));
    desk.type("x"); // once more: along its own axis
    QVERIFY(glm::distance(desk.origin(3), {-2, 0, -1}) < 1e-12);
    QCOMPARE(desk.drag->space(), TransformSpace::Local);
    desk.type("x"); // free: the first number is X
    QVERIFY(!desk.drag->handle());
    QCOMPARE(desk.origin(3), glm::dvec3(0, 0, 1));
    desk.type("Y"); // with Shift: the plane across Y
    QCOMPARE(desk.drag->handle(), (std::optional<GizmoHandle>{{GizmoPart::Plane, 1}}));
    desk.by({40.0, 40.0});
    QCOMPARE(desk.origin(3).y, 0.0);
}

void TestGizmoDrag::severalNumbersByTab()
{
    Desk desk;
    desk.begin(TransformTool::Move, std::nullopt);
    desk.type("1\t2\t-3");
    QCOMPARE(desk.origin(3), glm::dvec3(-1, 2, -2));
    desk.type("\b\b\b"); // the last number, and back into the one before
    QCOMPARE(desk.origin(3), glm::dvec3(-1, 2, 1));
    desk.type("Z"); // X and Y only
    desk.type("\t\t7");
    QVERIFY(desk.origin(3).z == 1.0);
}

void TestGizmoDrag::wrongKeysAreLeftAlone()
{
    Desk desk;
    desk.begin(TransformTool::Move, std::nullopt);
    for (const char* text : {"q", "#", "e", "é"})
        QCOMPARE(desk.drag->key(Qt::Key_Q, QString::fromUtf8(text), {}), GizmoDrag::KeyResult::Ignored);
    QCOMPARE(desk.drag->key(Qt::Key_Z, QStringLiteral("z"), Qt::ControlModifier),
             GizmoDrag::KeyResult::Ignored);
    QCOMPARE(desk.drag->key(Qt::Key_Escape, {}, {}), GizmoDrag::KeyResult::Cancel);
    for (int i = 0; i < 100; ++i)
        desk.type("9");
    QVERIFY(std::abs(desk.origin(3).x) <= 1e6); // as far as places go
    desk.drag->cancel();
    desk.type("1..2.");
    QVERIFY(std::abs(desk.origin(3).x - (-2 + 1.2)) < 1e-12);
}

void TestGizmoDrag::cancellingRestoresEveryBit_data()
{
    QTest::addColumn<int>("tool");
    QTest::addColumn<bool>("keys");
    for (int tool = 1; tool <= 3; ++tool)
        for (const bool keys : {false, true})
            QTest::addRow("tool %d%s", tool, keys ? " with keys" : "") << tool << keys;
}

void TestGizmoDrag::cancellingRestoresEveryBit()
{
    QFETCH(int, tool);
    QFETCH(bool, keys);
    Desk desk;
    desk.select({1, 3, 4});
    desk.begin(static_cast<TransformTool>(tool), std::nullopt, 0.4, keys);
    desk.by({123.0, -45.0});
    desk.type("z0.7");
    QVERIFY(writeProject(desk.document.project()) != desk.before);
    desk.drag->cancel();
    QCOMPARE(desk.document.undoStack()->count(), 0);
    QCOMPARE(writeProject(desk.document.project()), desk.before);
    QVERIFY(!desk.document.isModified());
    // And done, then undone.
    desk.begin(static_cast<TransformTool>(tool), std::nullopt, 0.4, keys);
    desk.by({123.0, -45.0});
    desk.drag->keep();
    QCOMPARE(desk.document.undoStack()->count(), 1);
    desk.document.undo();
    QCOMPARE(writeProject(desk.document.project()), desk.before);
}

/// Whatever was done, undone and dragged about before Escape: the stack is as it was, both ways.
void TestGizmoDrag::cancellingLeavesWhatCanBeRedone()
{
    Random random(21, RandomStream::Test);
    for (int round = 0; round < 25; ++round) {
        Desk desk;
        const QUndoStack& stack = *desk.document.undoStack();
        const auto drag = [&](bool keep) {
            std::vector<NodeId> nodes;
            for (NodeId id = 1; id <= 4; ++id)
                if (random.below(2) == 0)
                    nodes.push_back(id);
            desk.select(nodes.empty() ? std::vector<NodeId>{3} : nodes);
            desk.begin(static_cast<TransformTool>(1 + random.below(3)), std::nullopt, random.range(0.0, 1.0),
                       random.below(2) == 0);
            for (std::uint32_t k = 1 + random.below(4); k-- > 0;)
                desk.by({random.range(-80.0, 80.0), random.range(-80.0, 80.0)});
            if (random.below(2) == 0)
                desk.type("x0.5");
            if (keep)
                desk.drag->keep();
            else
                desk.drag->cancel();
        };
        for (int i = 0; i < 4; ++i)
            drag(true);
        std::vector<QByteArray> states(std::size_t(stack.count()) + 1);
        for (int i = 0; i <= stack.count(); ++i) {
            desk.document.history().goToStep(i);
            states[std::size_t(i)] = writeProject(desk.document.project());
        }
        const int count = stack.count(), index = int(random.below(std::uint32_t(count + 1)));
        desk.document.history().goToStep(index);
        for (int i = 0; i < 3; ++i)
            drag(false);
        QCOMPARE(stack.count(), count);
        QCOMPARE(stack.index(), index);
        for (const int i : {index, count, 0, index}) {
            desk.document.history().goToStep(i);
            QCOMPARE(writeProject(desk.document.project()), states[std::size_t(i)]);
        }
    }
}

/// Somebody does something else while the hand drags: the document has kept the drag, and nothing is left of
/// it.
void TestGizmoDrag::whoeverEditsMeanwhileIsNotMixedUp()
{
    Desk desk;
    const QUndoStack& stack = *desk.document.undoStack();
    desk.begin(TransformTool::Move, std::nullopt);
    desk.by({40.0, 0.0});
    QCOMPARE(stack.count(), 0);
    QVERIFY(edit::placeNodes(desk.document, {{4, {{{9, 9, 9}, {}, glm::dvec3(1)}, {}}, false}},
                             QStringLiteral("x")));
    QCOMPARE(stack.count(), 2);
    const QByteArray after = writeProject(desk.document.project());
    desk.drag->cancel();
    QCOMPARE(writeProject(desk.document.project()), after);
    desk.document.history().goToStep(0);
    QCOMPARE(writeProject(desk.document.project()), desk.before);
    desk.document.history().goToStep(2);
    QCOMPARE(writeProject(desk.document.project()), after);
    // Another document is opened under the hand.
    desk.begin(TransformTool::Move, std::nullopt);
    desk.by({40.0, 0.0});
    desk.document.reset(Scene(), {});
    desk.drag->keep();
    desk.drag->cancel();
    QCOMPARE(stack.count(), 0);
    QVERIFY(desk.document.scene().nodes().empty());
    // A drag that nobody ends is kept.
    Desk other;
    other.begin(TransformTool::Move, xAxis);
    other.by({40.0, 0.0});
    other.drag.reset();
    QCOMPARE(other.document.undoStack()->count(), 1);
    other.document.undo();
    QCOMPARE(writeProject(other.document.project()), other.before);
}

/// In a group that turns, grows and moves: the node goes by what is typed, in the world.
void TestGizmoDrag::parentsThatMoveAreRespected()
{
    for (const double seconds : {0.0, 0.37, 1.0, 2.0}) {
        Desk desk;
        desk.select({2});
        const glm::dvec3 from = desk.origin(2, seconds);
        desk.begin(TransformTool::Move, std::nullopt, seconds);
        desk.type("1.25\t-0.5\t2");
        QVERIFY(glm::distance(desk.origin(2, seconds), from + glm::dvec3(1.25, -0.5, 2.0)) < 1e-12);
        QVERIFY(desk.document.scene().find(2)->animation.empty());
    }
}

void TestGizmoDrag::keysAreMadeAtThePlayhead()
{
    Desk desk;
    desk.select({1, 3});
    const glm::dvec3 one = desk.origin(1, 0.5), three = desk.origin(3);
    desk.begin(TransformTool::Move, std::nullopt, 0.5, true);
    QVERIFY(desk.drag->keys());
    desk.by({30.0, 30.0});
    desk.type("1\t2");
    const Node& group = *desk.document.scene().find(1);
    QCOMPARE(std::get<Track>(*group.animation.find(globalChannel(0))).size(), std::size_t(3));
    QCOMPARE(group.params.tree.translation, glm::dvec3(0.5, 0, 0)); // keys, not the placement
    QVERIFY(glm::distance(desk.origin(1, 0.5), one + glm::dvec3(1, 2, 0)) < 1e-12);
    QVERIFY(desk.document.scene().find(3)->animation.empty()); // has no keys: stays so
    QVERIFY(glm::distance(desk.origin(3), three + glm::dvec3(1, 2, 0)) < 1e-12);
    desk.drag->keep();
    QCOMPARE(desk.document.undoStack()->count(), 1); // both in one step
    desk.document.undo();
    QCOMPARE(writeProject(desk.document.project()), desk.before);
}

void TestGizmoDrag::severalGoTogether()
{
    Desk desk;
    desk.select({3, 4});
    desk.begin(TransformTool::Move, std::nullopt);
    desk.type("x3");
    QCOMPARE(desk.origin(3), glm::dvec3(1, 0, 1));
    QCOMPARE(desk.origin(4), glm::dvec3(1, 2, 1));
    desk.begin(TransformTool::Rotate, std::nullopt); // about the middle, (1, 1, 1)
    desk.type("z180");
    QVERIFY(glm::distance(desk.origin(3), {1, 2, 1}) < 1e-12);
    QVERIFY(glm::distance(desk.origin(4), {1, 0, 1}) < 1e-12);
    desk.begin(TransformTool::Scale, std::nullopt);
    desk.type("2");
    QVERIFY(glm::distance(desk.origin(3), {1, 3, 1}) < 1e-12);
    // A node and its parent: the parent only.
    desk.select({2, 1});
    const glm::dvec3 two = desk.origin(2);
    desk.begin(TransformTool::Move, std::nullopt);
    desk.type("y1");
    QVERIFY(glm::distance(desk.origin(2), two + glm::dvec3(0, 1, 0)) < 1e-12);
}

/// What is seen is held, also where a local transform carries it away from its node.
void TestGizmoDrag::theHandlesStandAtWhatIsShown()
{
    Desk desk;
    QVERIFY(edit::setParam(desk.document, {3}, *findParam("local.translation"), glm::dvec3(0, 0, -5)));
    const auto shown = [&desk] {
        return glm::dvec3(worldTransformAt(desk.document.scene(), 3, 0.0).geometry[3]);
    };
    const glm::dvec3 from = shown();
    desk.begin(TransformTool::Rotate, std::nullopt);
    QVERIFY(glm::distance(desk.drag->place().pivot, from) < 1e-12);
    desk.type("y90");
    QVERIFY(glm::distance(shown(), from) < 1e-9); // turns where it stands
    QVERIFY(std::abs(desk.placement(3).rotation.y - 0.5 * pi) < 1e-12);
}

void TestGizmoDrag::theReadoutHasUnits()
{
    Desk desk;
    desk.begin(TransformTool::Move, xAxis);
    desk.type("1.5");
    QVERIFY2(desk.drag->readout().startsWith(QStringLiteral("X 1.5▏ m")), qPrintable(desk.drag->readout()));
    QVERIFY(desk.drag->readout().contains(QStringLiteral("world")));
    desk.begin(TransformTool::Rotate, std::nullopt);
    desk.by({10.0, 60.0});
    QVERIFY(desk.drag->readout().contains(QStringLiteral("°")));
    desk.begin(TransformTool::Scale, std::nullopt);
    QVERIFY2(desk.drag->readout().startsWith(QStringLiteral("× 1.000")), qPrintable(desk.drag->readout()));
}

RAMURE_SUITE(TestGizmoDrag)
} // namespace tst_gizmo_drag
#include "tst_gizmo_drag.moc"
