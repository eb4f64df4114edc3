#include "core/math/random.h"
#include "core/scene/scene.h"
#include "tests/support/suite.h"

namespace tst_scene {

using namespace ramure;

static Node makeNode(NodeId id, NodeId parent = noNode)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.name = std::to_string(id);
    return node;
}

/// 1 (2 (3) 4) 5
static Scene smallScene()
{
    Scene scene;
    [[maybe_unused]] auto a =
        scene.insert({makeNode(1), makeNode(2, 1), makeNode(3, 2), makeNode(4, 1)}, noNode, 0);
    [[maybe_unused]] auto b = scene.insert({makeNode(5)}, noNode, 99);
    return scene;
}

static std::vector<NodeId> ids(const std::vector<Node>& nodes)
{
    std::vector<NodeId> out;
    for (const Node& node : nodes)
        out.push_back(node.id);
    return out;
}
using Ids = std::vector<NodeId>;

/// Depth-first order is the promise on which everything else stands: checked against the parents alone.
static bool isDepthFirst(const Scene& scene)
{
    Ids way;
    for (const Node& node : scene.nodes()) {
        while (!way.empty() && way.back() != node.parent)
            way.pop_back();
        if (way.empty() && node.parent != noNode)
            return false;
        way.push_back(node.id);
    }
    return true;
}

class TestScene : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badInsertsAreRefused()
    {
        const Scene before = smallScene();
        Scene scene = before;
        QVERIFY(!scene.insert({}, noNode, 0));
        QCOMPARE(scene.insert({makeNode(9)}, 77, 0).error().code, ErrorCode::Unknown);
        QVERIFY(!scene.insert({makeNode(3)}, noNode, 0));
        QVERIFY(!scene.insert({makeNode(noNode)}, noNode, 0));
        QVERIFY(!scene.insert({makeNode(8), makeNode(8, 8)}, noNode, 0));
        QVERIFY(!scene.insert({makeNode(8), makeNode(9, 1)}, noNode, 0)); // outside of the block
        QVERIFY(!scene.insert({makeNode(8), makeNode(9, 10), makeNode(10, 9)}, noNode, 0)); // a circle
        QVERIFY(scene == before);
    }
    void badMovesAreRefused()
    {
        const Scene before = smallScene();
        Scene scene = before;
        QVERIFY(!scene.move(1, 1, 0));
        QVERIFY(!scene.move(1, 3, 0));
        QVERIFY(!scene.move(42, noNode, 0));
        QVERIFY(!scene.move(1, 42, 0));
        QVERIFY(!scene.move(noNode, 1, 0));
        QVERIFY(scene == before);
        QVERIFY(scene.remove(42).empty());
        QVERIFY(scene.remove(noNode).empty());
    }
    void badListsAreRefused()
    {
        const auto place = [](const std::vector<Node>& nodes) {
            const auto scene = Scene::fromNodes(nodes);
            return scene ? std::string("no error") : scene.error().path;
        };
        QCOMPARE(place({makeNode(1), makeNode(noNode)}), std::string("[1].id"));
        QCOMPARE(place({makeNode(1), makeNode(2), makeNode(1)}), std::string("[2].id"));
        QCOMPARE(place({makeNode(1, 7)}), std::string("[0].parent"));
        QCOMPARE(place({makeNode(1), makeNode(2, 3), makeNode(3, 2)}), std::string("[1].parent"));
        QCOMPARE(place({makeNode(1, 1)}), std::string("[0].parent"));
    }
    void listsMayHaveChildrenFirst()
    {
        const auto scene =
            Scene::fromNodes({makeNode(3, 2), makeNode(5), makeNode(2, 5), makeNode(4, 5), makeNode(1)});
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(ids(scene->nodes()), (Ids{5, 2, 3, 4, 1}));
        QVERIFY(Scene::fromNodes({})->empty());
    }
    void unknownNodesHaveNothing()
    {
        const Scene scene = smallScene();
        QVERIFY(!scene.find(noNode));
        QVERIFY(!scene.find(42));
        QCOMPARE(scene.row(42), -1);
        QVERIFY(scene.subtree(42).empty());
        QVERIFY(scene.children(42).empty());
        QVERIFY(!scene.isAncestor(1, 42));
        QVERIFY(!scene.isAncestor(42, 1));
        QVERIFY(!scene.isShown(42));
        QVERIFY(!scene.isLocked(42));
    }

    void hierarchy()
    {
        Scene scene = smallScene();
        QCOMPARE(ids(scene.nodes()), (Ids{1, 2, 3, 4, 5}));
        QCOMPARE(scene.children(noNode), (Ids{1, 5}));
        QCOMPARE(scene.children(1), (Ids{2, 4}));
        QCOMPARE(scene.row(4), 1);
        QCOMPARE(scene.row(5), 1);
        QCOMPARE(ids(scene.subtree(2)), (Ids{2, 3}));
        QVERIFY(scene.isAncestor(1, 3));
        QVERIFY(scene.isAncestor(noNode, 3));
        QVERIFY(!scene.isAncestor(3, 3));
        QVERIFY(!scene.isAncestor(3, 1));
    }
    void stateIsInherited()
    {
        Scene scene = smallScene();
        scene.find(1)->visible = false;
        scene.find(2)->locked = true;
        QVERIFY(!scene.isShown(3));
        QVERIFY(scene.isShown(5));
        QVERIFY(scene.isLocked(3));
        QVERIFY(!scene.isLocked(1));
    }
    void insertOrdersDepthFirst()
    {
        Scene scene;
        QVERIFY(scene.insert({makeNode(1), makeNode(2, 1), makeNode(3, 1), makeNode(4, 2), makeNode(5, 3)},
                             noNode, 0));
        QCOMPARE(ids(scene.nodes()), (Ids{1, 2, 4, 3, 5}));
        QVERIFY(scene.insert({makeNode(9)}, 1, 1));
        QCOMPARE(scene.children(1), (Ids{2, 9, 3}));
        QVERIFY(scene.insert({makeNode(10)}, 1, -4));
        QCOMPARE(scene.row(10), 0);
    }
    void moveKeepsTheSubtree()
    {
        Scene scene = smallScene();
        QVERIFY(scene.move(2, noNode, 1));
        QCOMPARE(ids(scene.nodes()), (Ids{1, 4, 2, 3, 5}));
        QVERIFY(scene.move(5, 2, 0));
        QCOMPARE(ids(scene.nodes()), (Ids{1, 4, 2, 5, 3}));
        QVERIFY(scene.move(1, noNode, 1)); // the row counts among the others
        QCOMPARE(scene.children(noNode), (Ids{2, 1}));
    }
    void idsAreNeverUsedTwice()
    {
        Scene scene = smallScene();
        QCOMPARE(scene.newId(), 6u);
        scene.remove(5);
        QCOMPARE(scene.newId(), 7u);
        QVERIFY(scene.insert({makeNode(0xFFFFFFFFu)}, noNode, 0));
        QCOMPARE(scene.newId(), 5u); // all were used: the lowest free one
    }
    void randomOperationsKeepTheOrder()
    {
        Random random(1, RandomStream::Test);
        Scene scene;
        for (int i = 0; i < 3000; ++i) {
            const auto pick = [&]() -> NodeId {
                const auto count = static_cast<std::uint32_t>(scene.nodes().size());
                const std::uint32_t k = random.below(count + 1);
                return k == count ? noNode : scene.nodes()[k].id;
            };
            const int row = static_cast<int>(random.below(6)) - 1;
            const std::size_t before = scene.nodes().size();
            switch (random.below(5)) {
            case 0:
            case 1:
                QVERIFY(scene.insert({makeNode(scene.newId())}, pick(), row));
                break;
            case 2: {
                const NodeId id = pick();
                const std::vector<Node> taken = scene.remove(id);
                QCOMPARE(scene.nodes().size() + taken.size(), before);
                if (!taken.empty() && random.below(2) == 0)
                    QVERIFY(scene.insert(taken, noNode, row));
                break;
            }
            default: {
                const NodeId id = pick(), parent = pick();
                const bool legal = id != noNode && id != parent && !scene.isAncestor(id, parent);
                QCOMPARE(scene.move(id, parent, row).has_value(), legal);
                QCOMPARE(scene.nodes().size(), before);
                if (legal)
                    QCOMPARE(scene.find(id)->parent, parent);
            }
            }
            QVERIFY(isDepthFirst(scene));
        }
    }
    void deepScenesDoNotRecurse()
    {
        std::vector<Node> chain{makeNode(1)};
        for (NodeId id = 2; id <= 20000; ++id)
            chain.push_back(makeNode(id, id - 1));
        Scene scene;
        QVERIFY(scene.insert(chain, noNode, 0));
        QCOMPARE(scene.subtree(2).size(), std::size_t{19999});
    }
};

RAMURE_SUITE(TestScene)

} // namespace tst_scene

#include "tst_scene.moc"
