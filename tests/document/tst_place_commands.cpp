#include "core/math/random.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

namespace tst_place_commands {

using namespace ramure;

namespace {

NodeAnimation::TrackPtr slope()
{
    Key a, b;
    a.mode = b.mode = KeyMode::Linear;
    b.time = ticksPerSecond;
    b.value = 4.0;
    return std::make_shared<const AnyTrack>(*Track::fromKeys({a, b}));
}

/// Group 1 that moves, primitive 2 in it, primitive 3 with keys beside it.
struct Fixture
{
    Fixture()
    {
        std::vector<Node> nodes(3);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].id = NodeId(i + 1);
            nodes[i].kind = i == 0 ? NodeKind::Group : NodeKind::Primitive;
            nodes[i].name = std::string("n").append(std::to_string(i + 1));
        }
        nodes[1].parent = 1;
        nodes[0].animation.set(globalChannel(0), slope());
        nodes[0].params.tree.scale = {2.0, 1.0, 0.5};
        nodes[2].animation.set(globalChannel(1), slope());
        document.reset(*Scene::fromNodes(nodes), {});
    }
    Expected<void> go(const WorldTransform& by, GestureId gesture, double seconds = 0.5)
    {
        std::vector<NodePlacing> places;
        for (const TransformStart& start :
             starts.empty() ? starts = transformStarts(document.scene(), {2, 3}, seconds, true) : starts)
            places.push_back({start.node, *transformed(start, by), start.keys});
        return edit::placeNodes(document, places, QStringLiteral("Move"), gesture);
    }
    QByteArray bytes() const { return writeProject(document.project()); }
    Document document;
    std::vector<TransformStart> starts;
    const QUndoStack& stack = *document.undoStack();
};

} // namespace

class TestPlaceCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badPlacesAreRefused()
    {
        Fixture f;
        NodePlacing place{2, {f.document.scene().find(2)->params.tree, {}}, false};
        place.node = 99;
        QVERIFY(!edit::placeNodes(f.document, {place}, {}));
        place.node = 2;
        place.values.placement.scale.x = 0.0;
        QVERIFY(!edit::placeNodes(f.document, {place}, {}));
        place.values.placement.scale.x = 1.0;
        place.values.tracks[3] = slope(); // no orientation
        QVERIFY(!edit::placeNodes(f.document, {place}, {}));
        place.values.tracks = {};
        QVERIFY(edit::setNodeLocked(f.document, {2}, true));
        QVERIFY(!edit::placeNodes(f.document, {place}, {}));
        QCOMPARE(f.stack.count(), 1);
    }
    /// Placements and keys together, one step; undone, the file is the same to the byte.
    void aGestureIsOneStep()
    {
        Random random(5, RandomStream::Test);
        for (int round = 0; round < 30; ++round) {
            Fixture f;
            const QByteArray before = f.bytes();
            const GestureId gesture = newGesture();
            WorldTransform by;
            for (int i = 0; i < 12; ++i) {
                by.pivot = {random.unit(), 0.0, 1.0};
                by.move = {random.unit(), random.unit(), -random.unit()};
                by.angleRad = round % 3 == 1 ? random.unit() : 0.0;
                by.factors = glm::dvec3(round % 3 == 2 ? 0.5 + random.unit() : 1.0);
                QVERIFY(f.go(by, gesture));
            }
            QCOMPARE(f.stack.count(), 1);
            const QByteArray after = f.bytes();
            QVERIFY(after != before);
            f.document.undo();
            QCOMPARE(f.bytes(), before);
            f.document.redo();
            QCOMPARE(f.bytes(), after);
        }
    }
    void backToTheStartIsNoStep()
    {
        Fixture f;
        const QByteArray before = f.bytes();
        const GestureId gesture = newGesture();
        WorldTransform by;
        by.move = {1, 2, 3};
        QVERIFY(f.go(by, gesture));
        QCOMPARE(f.stack.count(), 1);
        QVERIFY(f.go({}, gesture));
        QCOMPARE(f.stack.count(), 0);
        QCOMPARE(f.bytes(), before);
        QVERIFY(!f.document.isModified());
    }
    void keysAndPlacementsGoAsSaid()
    {
        Fixture f;
        WorldTransform by;
        by.move = {0.25, -1.0, 3.0};
        const glm::dvec3 two(worldTransformAt(f.document.scene(), 2, 0.5).world[3]);
        const glm::dvec3 three(worldTransformAt(f.document.scene(), 3, 0.5).world[3]);
        QVERIFY(f.go(by, 0));
        QVERIFY(glm::distance(glm::dvec3(worldTransformAt(f.document.scene(), 2, 0.5).world[3]),
                              two + by.move) < 1e-12);
        QVERIFY(glm::distance(glm::dvec3(worldTransformAt(f.document.scene(), 3, 0.5).world[3]),
                              three + by.move) < 1e-12);
        QVERIFY(f.document.scene().find(2)->animation.empty());
        QCOMPARE(f.document.scene().find(3)->params.tree, PlacementParams{});
        QCOMPARE(f.document.scene().find(3)->animation.tracks().size(), std::size_t(3));
    }
};

RAMURE_SUITE(TestPlaceCommands)

} // namespace tst_place_commands

#include "tst_place_commands.moc"
