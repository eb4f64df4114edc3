#include "core/qt/document/scatter_commands.h"

#include "core/scatter/scatter.h"
#include "core/scene/world_transforms.h"
#include "tests/document/commands_fixture.h"
#include "tests/support/suite.h"

namespace tst_scatter_commands {

using namespace ramure;
using test::fileOf;
using test::Fixture;

namespace {

Node scatterNode()
{
    Node node;
    node.kind = NodeKind::Scatter;
    node.name = "Scatter";
    node.params.scatter.count = 20;
    node.params.tree.translation = {3, 0, 1};
    node.params.tree.rotation.y = 0.4;
    return node;
}

SharedPlaces placesIn(const Document& document, NodeId scatter)
{
    return scatterPlaces(document.scene(), *document.scene().find(scatter)).value();
}

} // namespace

/// A scatter in hands, and undone.
class TestScatterCommands : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeDoneChangesNothing()
    {
        Fixture f;
        const QByteArray before = fileOf(f.document);
        QVERIFY(!edit::addScatter(f.document, scatterNode(), {99}));
        const auto group = edit::addScatter(f.document, scatterNode(), {4, 1});
        QVERIFY(!group && group.error().code == ErrorCode::Invalid);
        QVERIFY(!edit::makeReal(f.document, 4, 1) && !edit::makeReal(f.document, 99, 1));
        QVERIFY(!edit::removeCopies(f.document, 4, {1}));
        QCOMPARE(fileOf(f.document), before);
        QCOMPARE(f.stack.count(), 0);
        QVERIFY(edit::setNodeLocked(f.document, {3}, true));
        const QByteArray locked = fileOf(f.document);
        QVERIFY(!edit::addScatter(f.document, scatterNode(), {2, 3}));
        QCOMPARE(fileOf(f.document), locked);
    }

    void whatIsSelectedBecomesItsPrototypes()
    {
        Fixture f;
        const QByteArray before = fileOf(f.document);
        const auto scatter = edit::addScatter(f.document, scatterNode(), {3, 4});
        QVERIFY2(scatter, test::why(scatter));
        const Scene& scene = f.document.scene();
        QCOMPARE(scene.find(*scatter)->parent, NodeId(1));
        QCOMPARE(scene.children(*scatter), (std::vector<NodeId>{3, 4}));
        QCOMPARE(f.document.selection().nodes, (std::vector<NodeId>{*scatter}));
        QCOMPARE(prototypesOf(scene, *scatter).size(), std::size_t(2));
        QCOMPARE(f.stack.count(), 1);
        f.document.undo();
        QCOMPARE(fileOf(f.document), before);
        f.document.redo();
        QCOMPARE(scene.children(*scatter).size(), std::size_t(2));
    }

    void anEmptyOneStandsAtTheTop()
    {
        Fixture f;
        const auto scatter = edit::addScatter(f.document, scatterNode(), {});
        QVERIFY(scatter);
        QCOMPARE(f.document.scene().find(*scatter)->parent, noNode);
        QVERIFY(placesIn(f.document, *scatter)->empty());
    }

    void aCopyThatIsMadeRealStaysWhereItWas()
    {
        Fixture f;
        const auto scatter = edit::addScatter(f.document, scatterNode(), {3, 4});
        const QByteArray before = fileOf(f.document);
        const SharedPlaces places = placesIn(f.document, *scatter);
        QCOMPARE(places->size(), std::size_t(20));
        QVERIFY(!edit::makeReal(f.document, *scatter, 0xFFFFFFFF));
        const ScatterPlace& place = (*places)[7];
        const Scene& scene = f.document.scene();
        const Node& prototype = *prototypesOf(scene, *scatter)[place.prototype];
        const glm::dmat4 expected =
            worldMatrix(scene, *scatter) * placeMatrix(place) * prototypeMatrix(prototype);
        const auto real = edit::makeReal(f.document, *scatter, place.key);
        QVERIFY2(real, test::why(real));
        const glm::dmat4 now = geometryMatrix(scene, *scene.find(*real));
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                QVERIFY(std::abs(now[column][row] - expected[column][row]) < 1e-9);
        QVERIFY(!isPrototype(scene, *real));
        QCOMPARE(placesIn(f.document, *scatter)->size(), std::size_t(19));
        QVERIFY(!edit::makeReal(f.document, *scatter, place.key)); // it is gone
        f.document.undo();
        QCOMPARE(fileOf(f.document), before);
    }

    void removedCopiesComeBack()
    {
        Fixture f;
        const auto scatter = edit::addScatter(f.document, scatterNode(), {4});
        const SharedPlaces places = placesIn(f.document, *scatter);
        QVERIFY(edit::removeCopies(f.document, *scatter, {places->front().key, places->back().key}));
        QCOMPARE(placesIn(f.document, *scatter)->size(), std::size_t(18));
        const QByteArray file = fileOf(f.document);
        const auto back = readProject(file, QStringLiteral("f.ramure"));
        QVERIFY(back && back->scene == f.document.scene());
        f.document.undo();
        QCOMPARE(*placesIn(f.document, *scatter), *places);
    }
};

RAMURE_SUITE(TestScatterCommands)

} // namespace tst_scatter_commands

#include "tst_scatter_commands.moc"
