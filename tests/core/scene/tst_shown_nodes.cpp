#include "core/scene/shown_nodes.h"
#include "tests/support/suite.h"

namespace tst_shown_nodes {

using namespace ramure;

static Node makeNode(NodeId id, NodeId parent, NodeKind kind)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = kind;
    return node;
}

/// A terrain with an oak on it and a hidden group with a birch in it; an elm beside them.
static Scene forest()
{
    Scene scene = *Scene::fromNodes({makeNode(1, noNode, NodeKind::Terrain), makeNode(2, 1, NodeKind::Tree),
                                     makeNode(3, 1, NodeKind::Group), makeNode(4, 3, NodeKind::Tree),
                                     makeNode(5, noNode, NodeKind::Tree)});
    scene.find(3)->visible = false;
    return scene;
}

class TestShownNodes : public QObject
{
    Q_OBJECT
private:
    static std::vector<NodeId> shown(const Scene& scene)
    {
        std::vector<NodeId> out;
        for (const Node& node : scene.nodes())
            if (node.kind != NodeKind::Group && scene.isShown(node.id))
                out.push_back(node.id);
        return out;
    }
    using Ids = std::vector<NodeId>;

private slots:
    void init() { test::failOnAnyWarning(); }

    void unknownNodesLeaveNothing()
    {
        Scene scene = forest();
        showOnly(scene, Ids{99});
        QCOMPARE(shown(scene), Ids());
        QVERIFY(!showsAnything(scene));
    }
    void whatIsChosenIsShownWithWhatIsBelowIt()
    {
        Scene scene = forest();
        showOnly(scene, Ids{5});
        QCOMPARE(shown(scene), Ids{5});
        scene = forest();
        showOnly(scene, Ids{1});
        QCOMPARE(shown(scene), (Ids{1, 2})); // what is hidden below stays so
        scene = forest();
        showOnly(scene, Ids{4, 5}); // the terrain above is a place only
        QCOMPARE(shown(scene), (Ids{4, 5}));
        QCOMPARE(scene.find(1)->kind, NodeKind::Group);
    }
    void groupsAndWhatIsHiddenShowNothing()
    {
        QVERIFY(!showsAnything(Scene()));
        Scene scene = forest();
        QVERIFY(showsAnything(scene));
        for (const NodeId id : {1, 5})
            scene.find(id)->visible = false;
        QVERIFY(!showsAnything(scene));
        QVERIFY(!showsAnything(*Scene::fromNodes({makeNode(1, noNode, NodeKind::Group)})));
        QVERIFY(!showsAnything(*Scene::fromNodes({makeNode(1, noNode, NodeKind::Camera)})));
        QVERIFY(showsAnything(*Scene::fromNodes({makeNode(1, noNode, NodeKind::Terrain)})));
    }
};

RAMURE_SUITE(TestShownNodes)

} // namespace tst_shown_nodes

#include "tst_shown_nodes.moc"
