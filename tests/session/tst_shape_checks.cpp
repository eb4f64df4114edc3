#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/shape_checks.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include <QSignalSpy>
#include <QThread>
#include <atomic>

namespace tst_shape_checks {

using namespace ramure;
using State = ShapeChecks::State;

/// The check of the one shape that is looked at.
class TestShapeChecks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingToLookAt();
    void armsAndTerrainsAreChecked();
    void onlyShapesThatChangeAreCheckedAgain();
    void errorsAreTold();
    void cancelAndStartAgain();
    void editsStopWhatRuns();
    void destroyedWhileItRuns();
};

namespace {

struct Desk
{
    Document document;
    Desk()
    {
        Scene scene = armDemo();
        scene.find(2)->params.terrain.depth = 0.0; // a sheet
        document.reset(std::move(scene), {});
    }
    void set(NodeId node, const char* key, const ParamValue& value)
    {
        QVERIFY(edit::setParam(document, {node}, *findParam(key), value));
    }
};

/// Runs until it may end or is told to.
struct Slow
{
    std::atomic<bool> wait{true};
    std::atomic<int> started{0}, stopped{0};
    ShapeChecks::Function function()
    {
        return [this](const Node& node, const Progress& progress) -> Expected<ShapeCheck> {
            ++started;
            progress.report(0.5);
            while (wait) {
                test::work(1);
                if (progress.cancelled()) {
                    ++stopped;
                    return fail(ErrorCode::Cancelled, "cancelled");
                }
            }
            return checkShape(node, node.params, false);
        };
    }
};

} // namespace

void TestShapeChecks::nothingToLookAt()
{
    Desk desk;
    ShapeChecks checks(&desk.document);
    checks.setRest(0);
    for (const NodeId none : {noNode, NodeId(99)}) {
        checks.lookAt(none);
        QCOMPARE(checks.state(), State::None);
        QVERIFY(!checks.outcome());
    }
    checks.lookAt(1);
    QCOMPARE(checks.state(), State::Waiting);
    QVERIFY(edit::removeNodes(desk.document, {1}));
    QCOMPARE(checks.state(), State::None);
    checks.start();
    checks.cancel();
    QCOMPARE(checks.state(), State::None);
}

void TestShapeChecks::armsAndTerrainsAreChecked()
{
    Desk desk;
    ShapeChecks checks(&desk.document);
    checks.setRest(0);
    checks.lookAt(1);
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    QVERIFY(checks.outcome() && !checks.outcome()->isOpen);
    const NodeResult& arm = checks.outcome()->result;
    QVERIFY(arm.tree.report->valid && arm.tree.report->openMeshAgrees);
    QCOMPARE(arm.tree.branches->roots, arm.tree.report->components);
    QVERIFY(arm.tree.branches->mesh.branch.empty()); // segments are no branches to select
    checks.lookAt(2);
    QVERIFY(!checks.outcome());
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    QVERIFY(checks.outcome()->isOpen);
    QVERIFY(checks.outcome()->result.tree.report->valid);
    QCOMPARE(checks.outcome()->result.tree.report->boundaryEdges, Index(0)); // no defect of a terrain
    QVERIFY(checks.outcome()->analysis);
    desk.set(2, "terrain.depth", 0.5); // a block
    QTRY_VERIFY_WITH_TIMEOUT(checks.state() == State::Done && checks.outcome() && !checks.outcome()->isOpen,
                             20'000);
    QVERIFY(checks.outcome()->result.tree.report->valid);
    QCOMPARE(checks.outcome()->result.tree.report->eulerCharacteristic, std::int64_t(2));
}

void TestShapeChecks::onlyShapesThatChangeAreCheckedAgain()
{
    Desk desk;
    ShapeChecks checks(&desk.document);
    checks.setRest(0);
    checks.lookAt(2);
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    const auto before = checks.outcome();
    desk.set(2, "surface.color", glm::dvec3(0.1, 0.2, 0.3));
    desk.set(2, "tree.translation", glm::dvec3(1.0, 0.0, 0.0));
    desk.set(1, "armSkin.radius", 0.2);
    checks.lookAt(2);
    QCOMPARE(checks.state(), State::Done);
    desk.set(2, "terrain.height", 0.7);
    QCOMPARE(checks.state(), State::Waiting);
    QCOMPARE(checks.outcome(), before); // until there is another one
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    QVERIFY(checks.outcome() != before);
    QVERIFY(checks.outcome()->analysis->hash != before->analysis->hash);
}

void TestShapeChecks::errorsAreTold()
{
    Desk desk;
    ShapeChecks checks(&desk.document, [](const Node&, const Progress&) -> Expected<ShapeCheck> {
        return fail(ErrorCode::Invalid, "broken");
    });
    checks.setRest(0);
    checks.lookAt(1);
    QTRY_COMPARE(checks.state(), State::Done);
    QVERIFY(checks.outcome()->result.error && !checks.outcome()->analysis);
}

void TestShapeChecks::cancelAndStartAgain()
{
    Desk desk;
    Slow slow;
    ShapeChecks checks(&desk.document, slow.function());
    checks.setRest(0);
    QSignalSpy progress(&checks, &ShapeChecks::progress);
    checks.lookAt(2);
    QTRY_COMPARE(checks.state(), State::Running);
    QTRY_VERIFY(progress.count() > 0);
    QCOMPARE(checks.fraction(), 0.5);
    checks.cancel();
    QCOMPARE(checks.state(), State::Cancelled);
    QTRY_COMPARE(slow.stopped.load(), 1);
    QCOMPARE(checks.state(), State::Cancelled);
    slow.wait = false;
    checks.start();
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    QVERIFY(checks.outcome() && checks.outcome()->isOpen);
}

/// What is told in the end is of the latest shape.
void TestShapeChecks::editsStopWhatRuns()
{
    Desk desk;
    Slow slow;
    ShapeChecks checks(&desk.document, slow.function());
    checks.setRest(0);
    checks.lookAt(2);
    QTRY_COMPARE(slow.started.load(), 1);
    desk.set(2, "terrain.divisions", std::int64_t(10));
    slow.wait = false;
    QTRY_COMPARE_WITH_TIMEOUT(checks.state(), State::Done, test::patience(20'000));
    QCOMPARE(checks.outcome()->result.tree.report->faces, Index(200));
}

void TestShapeChecks::destroyedWhileItRuns()
{
    Desk desk;
    Slow slow;
    {
        ShapeChecks checks(&desk.document, slow.function());
        checks.setRest(0);
        checks.lookAt(1);
        QTRY_COMPARE(slow.started.load(), 1);
    }
    QCOMPARE(slow.stopped.load(), 1);
}

RAMURE_SUITE(TestShapeChecks)

} // namespace tst_shape_checks

#include "tst_shape_checks.moc"
