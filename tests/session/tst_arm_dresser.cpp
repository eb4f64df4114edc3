#include "core/qt/session/arm/arm_dresser.h"

#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include <QSignalSpy>
#include <cmath>

namespace tst_arm_dresser {

using namespace ramure;

namespace {

/// A tube of so many vertices along Y, 1 m long.
TriangleMesh tube(Index vertices)
{
    constexpr Index round = 100;
    const Index rows = vertices / round;
    TriangleMesh mesh;
    for (Index row = 0; row < rows; ++row)
        for (Index i = 0; i < round; ++i) {
            const double turn = 2.0 * 3.141592653589793 * i / round;
            mesh.positions.emplace_back(0.1 * std::cos(turn), double(row) / (rows - 1), 0.1 * std::sin(turn));
        }
    for (Index row = 0; row + 1 < rows; ++row)
        for (Index i = 0; i < round; ++i) {
            const Index a = row * round + i, b = row * round + (i + 1) % round;
            mesh.triangles.emplace_back(a, a + round, b);
            mesh.triangles.emplace_back(b, a + round, b + round);
        }
    return mesh;
}

/// The demo's arm, and meshes to wear: 3 is small, 4 is large.
struct Desk
{
    Document document;
    ArmDresser dresser{&document};
    QSignalSpy finished{&dresser, &ArmDresser::finished};

    Desk()
    {
        Scene scene = armDemo();
        for (const NodeId id : {3U, 4U}) {
            Node node;
            node.id = id;
            node.kind = NodeKind::Mesh;
            node.name = id == 3 ? "Small" : "Large";
            node.mesh = SharedValue<TriangleMesh>(tube(id == 3 ? 1000 : 2 * ArmDresser::fewVertices));
            if (!scene.insert({node}, noNode, 9))
                qWarning("no mesh");
        }
        document.reset(scene, {});
    }
    [[nodiscard]] const Node& arm() const { return *document.scene().find(1); }
    [[nodiscard]] float top() const
    {
        float most = 0.0F;
        for (const glm::vec3& p : arm().mesh->positions)
            most = std::max(most, p.z);
        return most;
    }
    [[nodiscard]] std::optional<Error> outcome() const
    {
        return finished.last().at(0).value<std::optional<Error>>();
    }
};

} // namespace

/// Meshes that are put on in the background.
class TestArmDresser : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeWornIsRefused()
    {
        Desk desk;
        QVERIFY(!desk.dresser.wear(77, 4, true));
        QVERIFY(!desk.dresser.wear(2, 4, true)); // a terrain is no arm
        QVERIFY(!desk.dresser.wear(1, 77, true));
        QVERIFY(!desk.dresser.wear(1, 2, true));
        QVERIFY(!desk.dresser.fitAgain(77));
        QVERIFY(!desk.dresser.fitAgain(1)); // it wears none
        QVERIFY(edit::setNodeLocked(desk.document, {1}, true));
        QVERIFY(!desk.dresser.wear(1, 4, true));
        QVERIFY(!desk.dresser.fitAgain(1));
        QVERIFY(edit::setNodeLocked(desk.document, {1}, false));
        const int steps = desk.document.undoStack()->count();
        QCOMPARE(desk.finished.count(), 0);
        QCOMPARE(desk.document.undoStack()->count(), steps);
    }

    void smallMeshesAreWornAtOnce()
    {
        Desk desk;
        QVERIFY(desk.dresser.wear(1, 3, true));
        QVERIFY(desk.arm().mesh && !desk.dresser.job()->isRunning());
        QCOMPARE(desk.finished.count(), 1);
        QVERIFY(!desk.outcome());
    }

    void largeMeshesComeLater()
    {
        Desk desk;
        QVERIFY(desk.dresser.wear(1, 3, true));
        const auto before = desk.arm().mesh.pointer();
        QVERIFY(desk.dresser.wear(1, 4, true));
        QVERIFY(!desk.dresser.wear(1, 4, true)); // one after the other
        QCOMPARE(desk.arm().mesh.pointer(), before);
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 2, test::patience(20'000));
        QVERIFY(!desk.outcome());
        QCOMPARE(desk.arm().mesh->vertexCount(), 2 * ArmDresser::fewVertices);
        QVERIFY(std::abs(desk.top() - 4.4F) < 1e-5F);
        QVERIFY(!desk.document.scene().find(4)->visible);
        // The same as at once, in one step.
        const TriangleMesh worn = *desk.arm().mesh;
        desk.document.undo();
        QCOMPARE(desk.arm().mesh.pointer(), before);
        QVERIFY(desk.document.scene().find(4)->visible);
        QVERIFY(edit::wearMesh(desk.document, 1, 4, true));
        QVERIFY(*desk.arm().mesh == worn);
    }

    void changesMeanwhileAreKept()
    {
        Desk desk;
        QVERIFY(desk.dresser.wear(1, 4, true));
        QVERIFY(edit::addJoint(desk.document, 1, 0));
        const Scene edited = desk.document.scene();
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 1, test::patience(20'000));
        QCOMPARE(desk.outcome()->code, ErrorCode::Invalid);
        QVERIFY(desk.document.scene() == edited);
        QVERIFY(desk.dresser.wear(1, 4, false));
        desk.document.reset({}, {});
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 2, test::patience(20'000));
        QVERIFY(desk.outcome().has_value() && desk.document.scene().empty());
    }

    void cancellingChangesNothing()
    {
        Desk desk;
        QVERIFY(desk.dresser.wear(1, 4, true));
        desk.dresser.job()->cancel();
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 1, test::patience(20'000));
        QCOMPARE(desk.outcome()->code, ErrorCode::Cancelled);
        QVERIFY(!desk.arm().mesh);
        QCOMPARE(desk.document.undoStack()->count(), 0);
    }

    void wornMeshesAreFittedAgain_data()
    {
        QTest::addColumn<int>("mesh");
        QTest::newRow("small") << 3;
        QTest::newRow("large") << 4;
    }
    void wornMeshesAreFittedAgain()
    {
        QFETCH(int, mesh);
        Desk desk;
        QVERIFY(desk.dresser.wear(1, NodeId(mesh), true));
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 1, test::patience(20'000));
        auto joints = desk.arm().params.joints;
        joints[1].length += 1.5;
        QVERIFY(edit::setJoints(desk.document, 1, joints, QStringLiteral("longer")));
        QVERIFY(std::abs(desk.top() - 4.4F) < 1e-5F); // lengths do not stretch it
        const int steps = desk.document.undoStack()->count();
        QVERIFY(desk.dresser.fitAgain(1));
        QTRY_COMPARE_WITH_TIMEOUT(desk.finished.count(), 2, test::patience(20'000));
        QVERIFY(std::abs(desk.top() - 5.9F) < 1e-5F);
        QCOMPARE(desk.document.undoStack()->count(), steps + 1);
        desk.document.undo();
        QVERIFY(std::abs(desk.top() - 4.4F) < 1e-5F);
    }

    void destroyedWhileItRuns()
    {
        Document document;
        document.reset(Desk().document.scene(), {});
        auto dresser = std::make_unique<ArmDresser>(&document);
        QVERIFY(dresser->wear(1, 4, true));
        dresser.reset();
        QVERIFY(!document.scene().find(1)->mesh);
    }
};

RAMURE_SUITE(TestArmDresser)

} // namespace tst_arm_dresser

#include "tst_arm_dresser.moc"
