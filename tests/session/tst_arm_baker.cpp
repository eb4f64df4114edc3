#include "core/qt/document/project/project_file.h"
#include "core/qt/session/arm/arm_baker.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include <QSignalSpy>

namespace tst_arm_baker {

using namespace ramure;

/// Keys of arms in documents: baked, saved, moved with their joints.
class TestArmBaker : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void badBakesAreErrors();
    void theKeysAreOneStep();
    void changedMeanwhileIsAnError();
    void cancelledLeavesNothing();
    void thePlayedArmIsTheSame();
    void keysMoveWithTheirJoints();
    void keysGoIntoTheProject();
};

namespace {

struct Desk
{
    Document document;
    ArmBaker baker{&document};

    Desk() { document.reset(armDemo(), {}); }
    [[nodiscard]] const Node& arm() const { return *document.scene().find(1); }
    /// \return why it failed
    std::optional<Error> bake(const ArmBakeOptions& options = {})
    {
        QSignalSpy finished(&baker, &ArmBaker::finished);
        std::optional<Error> told;
        const auto hear = QObject::connect(&baker, &ArmBaker::finished, &baker,
                                           [&told](const std::optional<Error>& error) { told = error; });
        if (const auto started = baker.start(1, options); !started)
            told = started.error();
        else if (!finished.wait(test::patience(20'000)))
            told = fail(ErrorCode::Limit, "no end").value();
        QObject::disconnect(hear);
        return told;
    }
};

Channel angleOf(int joint, bool phi)
{
    return {ChannelPart::Joint, static_cast<std::uint8_t>(joint),
            static_cast<ParamId>(jointAngleNumber(phi))};
}

} // namespace

void TestArmBaker::badBakesAreErrors()
{
    Desk desk;
    QVERIFY(!desk.baker.start(99, {}));
    QVERIFY(!desk.baker.start(2, {})); // a terrain
    QVERIFY(desk.bake({-1.0, true}));
    QVERIFY(edit::setParam(desk.document, {1}, *findParam("arm.follows"), false));
    QVERIFY(!desk.baker.start(1, {}));
    QVERIFY(edit::setParam(desk.document, {1}, *findParam("arm.follows"), true));
    QVERIFY(edit::setNodeLocked(desk.document, {1}, true));
    QVERIFY(!desk.baker.start(1, {}));
    QVERIFY(desk.arm().animation.empty());
}

void TestArmBaker::theKeysAreOneStep()
{
    Desk desk;
    const Scene before = desk.document.scene();
    QVERIFY(!desk.bake());
    QCOMPARE(desk.document.undoStack()->count(), 1);
    QVERIFY(!desk.arm().params.arm.follows);
    QCOMPARE(desk.arm().animation.tracks().size(), std::size_t(6 + 3));
    QVERIFY(keyCount(*desk.arm().animation.find(angleOf(0, true))) > 10);
    desk.document.undo();
    QVERIFY(desk.document.scene() == before);
    desk.document.redo();
    QVERIFY(!desk.arm().animation.empty());
}

void TestArmBaker::changedMeanwhileIsAnError()
{
    Desk desk;
    QVERIFY(desk.baker.start(1, {}));
    QVERIFY(edit::setParam(desk.document, {1}, *findParam("arm.target"), glm::dvec3(1.0)));
    QSignalSpy finished(&desk.baker, &ArmBaker::finished);
    std::optional<Error> told;
    connect(&desk.baker, &ArmBaker::finished, this,
            [&told](const std::optional<Error>& error) { told = error; });
    QVERIFY(finished.wait(test::patience(20'000)));
    QVERIFY(told);
    QVERIFY(desk.arm().animation.empty());
}

void TestArmBaker::cancelledLeavesNothing()
{
    Desk desk;
    QVERIFY(edit::setTimeline(desk.document, {24.0, 0, 500'000, PlayLoop::Loop}));
    QVERIFY(desk.baker.start(1, {}));
    desk.baker.job()->cancel();
    QSignalSpy finished(&desk.baker, &ArmBaker::finished);
    QVERIFY(finished.wait(test::patience(20'000)));
    QVERIFY(desk.arm().animation.empty());
}

/// The solver while playing and seeking, the keys afterwards: the same at every frame.
void TestArmBaker::thePlayedArmIsTheSame()
{
    Desk desk;
    Player player(&desk.document);
    std::map<int, std::vector<double>> solved;
    for (const int frame : {40, 3, 90, 17}) {
        player.seek(frame);
        QVERIFY(player.waitForIdle(20'000));
        solved[frame] = player.motion()->of(1)->arm->angles;
        QVERIFY(!player.motion()->of(1)->arm->residuals.empty());
    }
    QVERIFY(!desk.bake());
    for (const int frame : {17, 40, 3, 90}) {
        player.seek(frame);
        QVERIFY(player.waitForIdle(20'000));
        const NodeMotion* motion = player.motion()->of(1);
        QVERIFY(motion && motion->moves());
        for (std::size_t i = 0; i < solved[frame].size(); ++i)
            QVERIFY(std::abs(wrappedAngle(motion->arm->angles[i] - solved[frame][i])) < 1e-12);
    }
}

void TestArmBaker::keysMoveWithTheirJoints()
{
    Desk desk;
    QVERIFY(!edit::addJoint(desk.document, 1, 3));
    QVERIFY(!edit::removeJoint(desk.document, 1, 3));
    QVERIFY(!edit::addJoint(desk.document, 2, 0)); // a terrain
    QVERIFY(!desk.bake());
    const auto second = desk.arm().animation.find(angleOf(1, false));
    const Scene baked = desk.document.scene();
    QVERIFY(edit::addJoint(desk.document, 1, 0));
    QCOMPARE(desk.arm().params.joints.size(), std::size_t(4));
    QVERIFY(!desk.arm().animation.find(angleOf(1, false)));
    QCOMPARE(desk.arm().animation.find(angleOf(2, false)), second);
    QVERIFY(edit::removeJoint(desk.document, 1, 1));
    QVERIFY(desk.document.scene() == baked);
    QVERIFY(edit::removeJoint(desk.document, 1, 0));
    QCOMPARE(desk.arm().animation.find(angleOf(0, false)), second);
    QVERIFY(!desk.arm().animation.find(angleOf(2, false)));
    desk.document.history().goToStep(1);
    QVERIFY(desk.document.scene() == baked);
    for (int i = 0; i < 100; ++i)
        (void)edit::addJoint(desk.document, 1, 0);
    QCOMPARE(desk.arm().params.joints.size(), mostArmJoints);
    for (const auto& [channel, track] : desk.arm().animation.tracks())
        QVERIFY(hasChannel(NodeKind::Arm, channel));
}

void TestArmBaker::keysGoIntoTheProject()
{
    Desk desk;
    QVERIFY(!desk.bake({0.01, true}));
    const QByteArray file = writeProject(desk.document.project());
    QVERIFY(file.contains("joints[1].theta.angle"));
    const auto back = readProject(file);
    QVERIFY2(back, test::why(back).constData());
    QVERIFY(back->scene == desk.document.scene());
}

RAMURE_SUITE(TestArmBaker)

} // namespace tst_arm_baker

#include "tst_arm_baker.moc"
