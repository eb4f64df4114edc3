#include "core/qt/session/jobs/planting.h"

#include "core/params/source_facts.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"

namespace tst_planting {

using namespace ramure;

class TestPlanting : public QObject
{
    Q_OBJECT

    static Node node(NodeId id, NodeKind kind, const glm::dvec3& place)
    {
        Node made;
        made.id = id;
        made.kind = kind;
        made.params.tree.translation = place;
        return made;
    }
    static Expected<NodeId> plantTree(Document& document, const char* preset, NodeId parent = noNode,
                                      const std::optional<glm::dvec3>& place = {})
    {
        return presetTree(preset).and_then(
            [&](Node&& tree) { return edit::plantNode(document, std::move(tree), parent, place); });
    }
    static glm::dvec3 placeOf(const Document& document, NodeId id)
    {
        return glm::dvec3(worldMatrix(document.scene(), id)[3]);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatHasRoomIsNotMoved()
    {
        Document document;
        QCOMPARE(*edit::moveBeside(document, {}), 0.0);
        const NodeId first = *edit::insertNodes(document, {node(1, NodeKind::Primitive, {})}, noNode, 0);
        const NodeId far = *edit::insertNodes(document, {node(1, NodeKind::Primitive, {9, 0, 0})}, noNode, 1);
        const int steps = document.undoStack()->count();
        QCOMPARE(*edit::moveBeside(document, {far}), 0.0);
        QCOMPARE(*edit::moveBeside(document, {first, far}), 0.0); // all there is
        QCOMPARE(document.undoStack()->count(), steps);
        QVERIFY(edit::setParam(document, {far}, *findParam("tree.translation"), glm::dvec3(0.0)));
        QVERIFY(edit::setNodeLocked(document, {far}, true));
        QVERIFY(!edit::moveBeside(document, {far}));
        QCOMPARE(placeOf(document, far), glm::dvec3(0.0));
    }
    /// As imports do; one step of undo gives them their place back.
    void whatOverlapsIsPutBeside()
    {
        Document document;
        QVERIFY(edit::insertNodes(document, {node(1, NodeKind::Primitive, {4, 0, 0})}, noNode, 0));
        const NodeId group = *edit::insertNodes(document, {node(1, NodeKind::Group, {3.7, 0, 0})}, noNode, 1);
        const NodeId inside = *edit::insertNodes(document, {node(1, NodeKind::Primitive, {})}, group, 0);
        const auto moved = edit::moveBeside(document, {group});
        QVERIFY2(moved && *moved > 0.3, test::why(moved));
        QVERIFY(std::abs(placeOf(document, inside).x - 3.7 - *moved) < 1e-9);
        QCOMPARE(placeOf(document, inside).z, 0.0);
        QCOMPARE(*edit::moveBeside(document, {group}), 0.0); // now there is room
        document.undo();
        QVERIFY(std::abs(placeOf(document, inside).x - 3.7) < 1e-9);
    }
    /// In one step; where they stand and what holds them stays.
    void treesBecomeOthersWhereTheyStand()
    {
        Document document;
        const NodeId tree = *plantTree(document, "TinyTree", noNode, glm::dvec3(3, 0, 1));
        QVERIFY(edit::setParam(document, {tree}, *findParam("physics.seed"), std::int64_t(7)));
        const NodeParams before = document.scene().find(tree)->params;
        const int steps = document.undoStack()->count();
        const Node like = *presetTree("NorwaySpruce1995");
        QVERIFY(edit::makeTreesLike(document, {tree}, like, QStringLiteral("Make it")));
        QCOMPARE(document.undoStack()->count(), steps + 1);
        NodeParams expected = like.params;
        expected.tree = before.tree;
        expected.physics = before.physics;
        QVERIFY(document.scene().find(tree)->params == expected);
        QCOMPARE(document.scene().find(tree)->preset, like.preset); // what its arrows go back to
        QCOMPARE(document.scene().find(tree)->name, like.name);
        document.undo();
        QCOMPARE(document.scene().find(tree)->name, presetTree("TinyTree")->name);
        QCOMPARE(document.scene().find(tree)->preset, std::string("TinyTree"));
        QVERIFY(document.scene().find(tree)->params == before);
        QVERIFY(edit::setNodeLocked(document, {tree}, true));
        const int refused = document.undoStack()->count();
        QVERIFY(!edit::makeTreesLike(document, {tree}, like, QStringLiteral("Make it")));
        QCOMPARE(document.undoStack()->count(), refused);
    }
    void aNameOfOnesOwnStays()
    {
        Document document;
        const NodeId tree = *plantTree(document, "TinyTree");
        const Node like = *presetTree("NorwaySpruce1995");
        for (const char* name : {"Grandfather's", "TinyTree of mine"}) {
            QVERIFY(edit::setNodeName(document, tree, QString::fromLatin1(name)));
            QVERIFY(edit::makeTreesLike(document, {tree}, like, QStringLiteral("Make it")));
            QCOMPARE(document.scene().find(tree)->name, std::string(name));
            document.undo();
        }
        const std::string usual = presetTree("TinyTree")->name + " 2";
        QVERIFY(edit::setNodeName(document, tree, QString::fromStdString(usual)));
        QVERIFY(edit::makeTreesLike(document, {tree}, like, QStringLiteral("Make it")));
        QCOMPARE(document.scene().find(tree)->name, like.name);
    }
    void theFirstStandsInTheOrigin()
    {
        Document document;
        document.reset(
            *Scene::fromNodes({node(1, NodeKind::Group, {9, 0, 0}), node(2, NodeKind::Camera, {8, 1, 0}),
                               node(3, NodeKind::Terrain, {7, 0, 0})}),
            {});
        QVERIFY(freePlace(document, 3.0) == glm::dvec3(0.0));
        const auto planted = plantTree(document, "TinyTree");
        QVERIFY2(planted, test::why(planted));
        QVERIFY(placeOf(document, *planted) == glm::dvec3(0.0));
        QCOMPARE(document.selection().activeNode(), *planted);
    }
    void theNextStandsBesideWhatIsThere()
    {
        Document document;
        const auto first = plantTree(document, "TinyTree");
        QVERIFY(first);
        NodeResult result;
        result.tree = *TreePipeline().evaluate(document.scene().find(*first)->params);
        double right = 0.0;
        for (const glm::dvec3& p : result.tree.simplified->skeleton.p1)
            right = std::max(right, p.x);
        document.setResult(*first, std::move(result));
        for (const char* preset : {"ParkTree", "SilverBirch1995", "SmallTree"}) { // of each generator
            const auto second = plantTree(document, preset);
            QVERIFY2(second, test::why(second));
            const NodeParams& tree = document.scene().find(*second)->params;
            const double reach = sourceFacts(tree).reach(tree);
            QVERIFY(reach > 0.5);
            QVERIFY(std::abs(placeOf(document, *second).x - (right + reach)) < 1e-9);
            document.undo();
            QVERIFY(!document.scene().find(*second));
        }
    }
    void hiddenOnesTakeNoRoomAndShapesDo()
    {
        Document document;
        Node hidden = node(1, NodeKind::Primitive, {50, 0, 0});
        hidden.visible = false;
        Node box = node(2, NodeKind::Primitive, {4, 0, 0});
        box.params.primitive.shape = PrimitiveShape::Box;
        box.params.primitive.size = {2, 2, 2};
        document.reset(*Scene::fromNodes({hidden, box}), {});
        QVERIFY(glm::length(freePlace(document, 3.0) - glm::dvec3(8, 0, 0)) < 1e-6);
    }
    /// As wide as it is itself, with some air.
    void shapesAndArmsStandBesideWhatIsThere()
    {
        Document document;
        Node box = node(noNode, NodeKind::Primitive, {});
        box.params.primitive.shape = PrimitiveShape::Box;
        box.params.primitive.size = {2, 2, 2};
        const auto first = edit::plantNode(document, box);
        QVERIFY2(first, test::why(first));
        QVERIFY(placeOf(document, *first) == glm::dvec3(0.0));
        const auto second = edit::plantNode(document, box);
        QVERIFY(second && glm::length(placeOf(document, *second) - glm::dvec3(2.4, 0, 0)) < 1e-6);
        const auto arm = edit::plantNode(document, node(noNode, NodeKind::Arm, {}));
        QVERIFY(arm && placeOf(document, *arm).x > 3.5);
        QCOMPARE(document.undoStack()->count(), 3);
    }
    void aGivenPlaceIsTakenWhateverStandsAbove()
    {
        Document document;
        Node group = node(1, NodeKind::Group, {5, 1, 0});
        group.params.tree.rotation = {0.1, 0.8, 0.0};
        group.params.tree.scale = {2, 2, 2};
        document.reset(*Scene::fromNodes({group}), {});
        const auto planted = plantTree(document, "TinyTree", 1, glm::dvec3(-3, 0, 2));
        QVERIFY2(planted, test::why(planted));
        QVERIFY(glm::length(placeOf(document, *planted) - glm::dvec3(-3, 0, 2)) < 1e-9);
    }
};

RAMURE_SUITE(TestPlanting)

} // namespace tst_planting

#include "tst_planting.moc"
