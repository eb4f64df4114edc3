#include "core/qt/session/jobs/scatter_watch.h"

#include "core/qt/document/commands.h"
#include "tests/support/suite.h"

namespace tst_scatter_watch {

using namespace ramure;

namespace {

constexpr std::chrono::seconds patience{60};

Node node(NodeId id, NodeKind kind, NodeId parent = noNode)
{
    Node out;
    out.id = id;
    out.kind = kind;
    out.parent = parent;
    out.name = "node";
    return out;
}

} // namespace

/// Why a scatter makes no copies.
class TestScatterWatch : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void anEmptyOneSaysWhatToDo()
    {
        Document document;
        document.reset(*Scene::fromNodes({node(1, NodeKind::Scatter), node(2, NodeKind::Tree)}), {});
        ScatterWatch watch(&document);
        QVERIFY(watch.wait(patience));
        QVERIFY(document.problem(1) && document.problem(1)->code == ErrorCode::Invalid);
        QVERIFY(!document.problem(2));
        QVERIFY(edit::moveNode(document, 2, 1, 0, false));
        QVERIFY(watch.wait(patience));
        QVERIFY(!document.problem(1));
        QCOMPARE(watch.count(1), std::optional<std::size_t>(200));
        QVERIFY(!watch.count(2) && !watch.count(99));
    }

    void aWrongRuleIsTheProblemOfItsParameter()
    {
        Document document;
        document.reset(*Scene::fromNodes({node(1, NodeKind::Scatter), node(2, NodeKind::Tree, 1)}), {});
        ScatterWatch watch(&document);
        QVERIFY(edit::setParam(document, {1}, *findParam("scatter.ground"), std::string("Hill")));
        QVERIFY(watch.wait(patience));
        QVERIFY(document.problem(1));
        QCOMPARE(document.problem(1)->path, std::string("scatter.ground"));
        QVERIFY(!watch.count(1));
        QVERIFY(!document.isModified() || document.undoStack()->count() == 1); // the problem is no edit
        Node hill = node(3, NodeKind::Terrain);
        hill.name = "Hill";
        hill.params.terrain.size = 200.0;
        QVERIFY(edit::insertNodes(document, {hill}, noNode, 0));
        QVERIFY(watch.wait(patience));
        QVERIFY(!document.problem(1));
        document.undo();
        QVERIFY(watch.wait(patience));
        QVERIFY(document.problem(1));
        document.reset(Scene(), {});
        QVERIFY(watch.wait(patience));
        QVERIFY(!document.result(1));
    }
};

RAMURE_SUITE(TestScatterWatch)

} // namespace tst_scatter_watch

#include "tst_scatter_watch.moc"
