#include "core/math/random.h"
#include "core/rig/arm/arm_bake.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace tst_arm_bake {

using namespace ramure;
using namespace ramure::test;

/// Arms whose joints and target have tracks, and inverse kinematics as tracks.
class TestArmBake : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void badBakesAreErrors();
    void cancellingIsAnError();
    void channelsOfJointsHaveKeys();
    void jointsFollowTheirTracks();
    void limitsOfTracksHold();
    void aKeyedTargetIsFollowed_data() { solvers(); }
    void aKeyedTargetIsFollowed();
    void keyedAnglesAreLeftAlone();
    void anyOrderGivesTheSame_data() { solvers(); }
    void anyOrderGivesTheSame();
    void longRunsTooGiveTheSame();
    void theBakedArmMovesTheSame_data();
    void theBakedArmMovesTheSame();
    void rangesAreTheArtists_data();
    void rangesAreTheArtists();
    void thinnedKeysStayWithinTheTolerance();
    void neededPointsPassAllOthers();

private:
    static void solvers();
};

namespace {

constexpr double pi = std::numbers::pi;

Channel jointChannel(int joint, const char* key)
{
    return {ChannelPart::Joint, static_cast<std::uint8_t>(joint),
            static_cast<ParamId>(jointNumber(key).value())};
}

Channel targetChannel(int axis)
{
    return {ChannelPart::Parameter, static_cast<std::uint8_t>(axis), paramId(*findParam("arm.target"))};
}

AnyTrack trackOf(std::initializer_list<std::pair<double, double>> keys)
{
    std::vector<Key> made;
    for (const auto& [seconds, value] : keys) {
        Key key;
        key.time = ticksOf(seconds);
        key.mode = KeyMode::Linear;
        key.value = value;
        made.push_back(key);
    }
    return Track::fromKeys(made).value();
}

/// A target that goes round the arm.
NodeAnimation circlingTarget()
{
    NodeAnimation animation;
    animation.set(targetChannel(0), trackOf({{0, 2}, {1, 0}, {2, -2}, {3, 0}, {4, 2}}));
    animation.set(targetChannel(1), trackOf({{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 0}}));
    animation.set(targetChannel(2), trackOf({{0, 1}, {4, 2}}));
    return animation;
}

NodeParams armParams(bool transpose = false, double mostSpeed = 0.0)
{
    NodeParams params;
    params.ik.kind = transpose ? ArmSolverKind::Transpose : ArmSolverKind::LeastSquares;
    params.ik.stepsPerTick = 20;
    for (ArmJoint& joint : params.joints)
        joint.phi.mostSpeed = joint.theta.mostSpeed = mostSpeed;
    return params;
}

constexpr TimelineSettings frames{24.0, 0, 96, PlayLoop::Loop};

/// The keyed arm without inverse kinematics.
std::vector<double> keyedAngles(const NodeParams& params, const NodeAnimation& animation, double seconds)
{
    return armAngles(paramsAt(params, animation, seconds).joints);
}

} // namespace

void TestArmBake::solvers()
{
    QTest::addColumn<bool>("transpose");
    QTest::newRow("least squares") << false;
    QTest::newRow("transpose") << true;
}

void TestArmBake::badBakesAreErrors()
{
    NodeParams params = armParams();
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()})
        QVERIFY(!bakeArm(params, {}, frames, {bad, true}));
    for (const ArmBakeRange& bad : {ArmBakeRange{5, 4, 1}, ArmBakeRange{0, 4, 0}, ArmBakeRange{0, 4, -1},
                                    ArmBakeRange{leastFrame - 1, 4, 1}, ArmBakeRange{0, mostFrame + 1, 1}})
        QVERIFY(!bakeArm(params, {}, frames, {0.0, true, bad}));
    params.arm.follows = false;
    QVERIFY(!bakeArm(params, {}, frames, {}));
    params.arm.follows = true;
    params.joints.clear();
    QVERIFY(!bakeArm(params, {}, frames, {}));
}

void TestArmBake::cancellingIsAnError()
{
    std::stop_source stop;
    stop.request_stop();
    const auto baked = bakeArm(armParams(), {}, frames, {}, Progress{stop.get_token(), {}});
    QVERIFY(!baked);
    QCOMPARE(baked.error().code, ErrorCode::Cancelled);
}

void TestArmBake::channelsOfJointsHaveKeys()
{
    for (const char* wrong : {"joints[0].phi", "joints[64].length", "joints[-1].length", "joints[00].length",
                              "joints[].length", "joints[1]length", "joints[0].phi.angle.x", "joints"})
        QVERIFY2(!channelFromKey(wrong, NodeKind::Arm), wrong);
    QVERIFY(!channelFromKey("joints[0].length", NodeKind::Tree));
    for (const std::size_t joint : {0, 7, 63})
        for (const Channel& channel : jointChannels(joint)) {
            QVERIFY(hasChannel(NodeKind::Arm, channel));
            QVERIFY(!hasChannel(NodeKind::Terrain, channel));
            const auto back = channelFromKey(channelKey(channel), NodeKind::Arm);
            QVERIFY(back && *back == channel);
        }
    QCOMPARE(QByteArray::fromStdString(channelKey(jointChannel(2, "phi.angle"))),
             QByteArray("joints[2].phi.angle"));
    QCOMPARE(restValue(armParams(), jointChannel(1, "length")), 1.5);
    QCOMPARE(restValue(armParams(), jointChannel(60, "length")), 0.0);
}

void TestArmBake::jointsFollowTheirTracks()
{
    NodeParams params = armParams();
    params.arm.follows = false;
    NodeAnimation animation;
    QVERIFY(!animation.movesParams());
    animation.set(jointChannel(0, "length"), trackOf({{0, 1}, {2, 3}}));
    animation.set(jointChannel(1, "theta.angle"), trackOf({{0, 0}, {2, 1}}));
    animation.set(jointChannel(9, "theta.angle"), trackOf({{0, 0}, {2, 1}})); // there is no such joint
    QVERIFY(animation.movesParams() && !animation.movesNode());
    ArmDriver driver = armDriver(params, animation);
    for (const double seconds : {0.0, 0.3, 1.0, 5.0}) {
        const auto moment = driver.momentAt(seconds, {});
        QVERIFY(moment);
        const double part = std::min(seconds, 2.0) / 2.0;
        QVERIFY(std::abs(moment->joints[0].length - (1.0 + 2.0 * part)) < 1e-12);
        QVERIFY(std::abs(moment->angles[3] - part) < 1e-12);
        QCOMPARE(moment->angles[0], params.joints[0].phi.angleRad);
    }
    params.arm.follows = true; // the solver has to do with the lengths of each time
    ArmDriver solved = armDriver(params, animation);
    const auto moment = solved.momentAt(2.0, {});
    QVERIFY(moment && moment->residual <= params.ik.tolerance);
    QCOMPARE(moment->joints[0].length, 3.0);
    QVERIFY(glm::distance(ArmChain(moment->joints).tip(), params.arm.target) <= params.ik.tolerance);
}

/// Also where a lower limit rises over the upper one.
void TestArmBake::limitsOfTracksHold()
{
    for (const bool transpose : {false, true}) {
        NodeParams params = armParams(transpose, 2.0);
        for (ArmJoint& joint : params.joints)
            joint.theta = {0.3, true, -1.0, 1.0, 0.7};
        NodeAnimation animation = circlingTarget();
        animation.set(jointChannel(1, "theta.min"), trackOf({{0, -1}, {2, 1.5}, {4, -0.5}}));
        animation.set(jointChannel(2, "theta.max"), trackOf({{0, 1}, {2, 0.1}, {4, 1}}));
        ArmDriver driver = armDriver(params, animation);
        for (int i = 0; i <= 200; ++i) {
            const auto moment = driver.momentAt(0.0217 * i, {});
            QVERIFY(moment);
            for (const ArmJoint& joint : moment->joints) {
                QVERIFY(joint.theta.minRad <= joint.theta.maxRad);
                QVERIFY(joint.theta.angleRad >= joint.theta.minRad - 1e-9);
                QVERIFY(joint.theta.angleRad <= joint.theta.maxRad + 1e-9);
            }
        }
    }
}

void TestArmBake::aKeyedTargetIsFollowed()
{
    QFETCH(bool, transpose);
    ArmDriver driver = armDriver(armParams(transpose), circlingTarget());
    double worst = 0.0;
    for (int frame = 24; frame <= 96; ++frame) {
        const auto moment = driver.momentAt(frame / 24.0, {});
        QVERIFY(moment && moment->target);
        QCOMPARE(moment->residual, glm::distance(ArmChain(moment->joints).tip(), *moment->target));
        worst = std::max(worst, moment->residual);
        QCOMPARE(moment->residuals.size(), std::size_t(std::ceil(60.0 * frame / 24.0 - 1e-9)));
    }
    qInfo("%.6f m at most", worst);
    QVERIFY(worst < (transpose ? 0.2 : 2e-3));
}

/// They go their own way exactly; the others reach the target all the same.
void TestArmBake::keyedAnglesAreLeftAlone()
{
    NodeAnimation animation = circlingTarget();
    animation.set(jointChannel(2, "theta.angle"), trackOf({{0, 0.2}, {4, 0.9}}));
    for (const bool transpose : {false, true}) {
        ArmDriver driver = armDriver(armParams(transpose, 20.0), animation);
        for (int i = 0; i <= 96; ++i) {
            const auto moment = driver.momentAt(i / 24.0, {});
            QVERIFY(moment);
            QVERIFY(std::abs(moment->angles[5] - (0.2 + 0.7 * i / 96.0)) < 1e-9);
            QVERIFY(i < 48 || moment->residual < 0.3);
        }
    }
}

void TestArmBake::anyOrderGivesTheSame()
{
    QFETCH(bool, transpose);
    NodeAnimation animation = circlingTarget();
    animation.set(jointChannel(1, "length"), trackOf({{0, 1.5}, {3, 1}}));
    const NodeParams params = armParams(transpose, 3.0);
    ArmDriver forwards = armDriver(params, animation), anyhow = armDriver(params, animation);
    std::vector<ArmMoment> moments;
    for (int i = 0; i <= 60; ++i)
        moments.push_back(forwards.momentAt(0.11 * i, {}).value());
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 150; ++i) {
        const std::uint32_t which = random.below(61);
        const ArmMoment moment = anyhow.momentAt(0.11 * which, {}).value();
        QCOMPARE(moment.angles, moments[which].angles);
        QCOMPARE(moment.residuals, moments[which].residuals);
    }
}

/// Some twenty minutes: more than a run keeps snapshots of.
void TestArmBake::longRunsTooGiveTheSame()
{
    NodeAnimation animation;
    Track track = std::get<Track>(trackOf({{0, -1}, {3, 1}}));
    track.behind = Extrapolation::Mirror;
    animation.set(targetChannel(0), AnyTrack(track));
    ArmDriver run = armDriver(armParams(), animation), fresh = armDriver(armParams(), animation);
    const double late = 1100.7;
    const std::vector<double> before = fresh.momentAt(40.3, {})->angles;
    const std::vector<double> end = run.momentAt(late, {})->angles;
    QCOMPARE(run.momentAt(40.3, {})->angles, before);
    QCOMPARE(run.momentAt(late, {})->angles, end);
    QCOMPARE(fresh.momentAt(late, {})->angles, end);
}

void TestArmBake::theBakedArmMovesTheSame_data()
{
    QTest::addColumn<bool>("transpose");
    QTest::addColumn<double>("mostSpeed");
    QTest::newRow("least squares") << false << 0.0;
    QTest::newRow("least squares, slow") << false << 1.0;
    QTest::newRow("transpose") << true << 0.0;
}

void TestArmBake::theBakedArmMovesTheSame()
{
    QFETCH(bool, transpose);
    QFETCH(double, mostSpeed);
    NodeParams params = armParams(transpose, mostSpeed);
    const NodeAnimation animation = circlingTarget();
    const auto baked = bakeArm(params, animation, frames, {});
    QVERIFY2(baked, why(baked).constData());
    QCOMPARE(baked->find(targetChannel(0)), animation.find(targetChannel(0)));
    ArmDriver driver = armDriver(params, animation);
    params.arm.follows = false;
    std::vector<double> last;
    for (std::int64_t frame = 0; frame <= frames.lastFrame; ++frame) {
        const double seconds = frames.timeOf(frame);
        const auto moment = driver.momentAt(seconds, {});
        const std::vector<double> keyed = keyedAngles(params, *baked, seconds);
        for (std::size_t i = 0; i < keyed.size(); ++i) {
            QVERIFY(std::abs(wrappedAngle(keyed[i] - moment->angles[i])) < 1e-12);
            QVERIFY(last.empty() || std::abs(keyed[i] - last[i]) <= pi); // no jump from pi to -pi
        }
        last = keyed;
    }
    ArmDriver after = armDriver(params, *baked);
    QVERIFY(glm::distance(ArmChain(after.momentAt(3.0, {})->joints).tip(),
                          ArmChain(driver.momentAt(3.0, {})->joints).tip()) < 1e-9);
}

void TestArmBake::rangesAreTheArtists_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("every");
    QTest::newRow("inside") << 10 << 40 << 1;
    QTest::newRow("thirds") << 0 << 30 << 3;
    QTest::newRow("the last one too") << 5 << 25 << 8;
    QTest::newRow("beyond the timeline") << 90 << 120 << 10;
    QTest::newRow("one frame") << 7 << 7 << 4;
    QTest::newRow("wider than the range") << 3 << 9 << 100;
}

/// Keys at the frames that were asked for, and there what baking all frames gives.
void TestArmBake::rangesAreTheArtists()
{
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(int, every);
    const NodeParams params = armParams();
    const NodeAnimation target = circlingTarget();
    const auto baked = bakeArm(params, target, frames, {0.0, true, ArmBakeRange{first, last, every}});
    TimelineSettings wide = frames;
    wide.firstFrame = first;
    wide.lastFrame = last;
    const auto all = bakeArm(params, target, wide, {});
    QVERIFY(baked && all);
    for (std::size_t joint = 0; joint < params.joints.size(); ++joint)
        for (const char* key : {"phi.angle", "theta.angle"}) {
            const auto held = baked->find(jointChannel(static_cast<int>(joint), key));
            QVERIFY(held);
            const Track& track = std::get<Track>(*held);
            std::vector<Ticks> meant;
            for (int frame = first; frame < last; frame += every)
                meant.push_back(ticksOf(frames.timeOf(frame)));
            meant.push_back(ticksOf(frames.timeOf(last)));
            QCOMPARE(track.size(), meant.size());
            const Track& whole = std::get<Track>(*all->find(jointChannel(static_cast<int>(joint), key)));
            for (std::size_t i = 0; i < meant.size(); ++i) {
                QCOMPARE(track.keys()[i].time, meant[i]);
                const double away = track.keys()[i].value - whole.keys()[*whole.find(meant[i])].value;
                QVERIFY(std::abs(std::remainder(away, 2.0 * pi)) < 1e-12);
            }
        }
}

void TestArmBake::thinnedKeysStayWithinTheTolerance()
{
    NodeParams params = armParams();
    const NodeAnimation animation = circlingTarget();
    const auto all = bakeArm(params, animation, frames, {0.0, false});
    const double tolerance = 0.2 * pi / 180.0;
    const auto thinned = bakeArm(params, animation, frames, {tolerance, false});
    QVERIFY(all && thinned);
    std::size_t keysOfAll = 0, keysOfThinned = 0;
    for (std::uint8_t i = 0; i < 6; ++i) {
        const Channel channel = jointChannel(i / 2, i % 2 == 0 ? "phi.angle" : "theta.angle");
        keysOfAll += keyCount(*all->find(channel));
        keysOfThinned += keyCount(*thinned->find(channel));
    }
    qInfo("%zu keys, thinned %zu", keysOfAll, keysOfThinned);
    QVERIFY(2 * keysOfThinned < keysOfAll);
    for (std::int64_t frame = 0; frame <= frames.lastFrame; ++frame) {
        const auto a = keyedAngles(params, *all, frames.timeOf(frame));
        const auto b = keyedAngles(params, *thinned, frames.timeOf(frame));
        for (std::size_t i = 0; i < a.size(); ++i)
            QVERIFY(std::abs(a[i] - b[i]) <= tolerance * (1.0 + 1e-9));
    }
    params.arm.target = {0.5, 0.5, 2.0}; // still, without tracks: a key each
    const auto still = bakeArm(params, {}, frames, {0.0, true});
    QVERIFY(still);
    for (int axis = 0; axis < 3; ++axis)
        QCOMPARE(keyCount(*still->find(targetChannel(axis))), std::size_t(1));
}

void TestArmBake::neededPointsPassAllOthers()
{
    QVERIFY(neededPoints({}, {}, 0.1).empty());
    const std::vector<double> times{0.0, 1.0, 2.0, 3.0};
    QCOMPARE(neededPoints(times, std::vector<double>(4, 0.7), 0.0), std::vector<std::size_t>{0});
    QCOMPARE(neededPoints(times, std::vector<double>{0.0, 1.0, 2.0, 3.0}, 1e-9),
             (std::vector<std::size_t>{0, 3}));
    QCOMPARE(neededPoints(times, std::vector<double>{0.0, 1.0, 2.0, 3.0}, 0.0).size(), std::size_t(4));
    QCOMPARE(neededPoints(times, std::vector<double>{0.0, 0.0, 5.0, 5.0}, 1.0),
             (std::vector<std::size_t>{0, 1, 2, 3}));
    Random random(3, RandomStream::Test);
    for (int t = 0; t < 50; ++t) {
        std::vector<double> at, values;
        for (int i = 0; i < 200; ++i) {
            at.push_back(i);
            values.push_back((values.empty() ? 0.0 : values.back()) + random.range(-1.0, 1.0));
        }
        const double tolerance = random.range(0.1, 5.0);
        const auto needed = neededPoints(at, values, tolerance);
        QVERIFY(std::ranges::is_sorted(needed) && needed.front() == 0 && needed.back() == 199);
        for (std::size_t k = 0; k + 1 < needed.size(); ++k)
            for (std::size_t i = needed[k]; i <= needed[k + 1]; ++i) {
                const double part = double(i - needed[k]) / double(needed[k + 1] - needed[k]);
                const double line = values[needed[k]] + part * (values[needed[k + 1]] - values[needed[k]]);
                QVERIFY(std::abs(line - values[i]) <= tolerance * (1.0 + 1e-9));
            }
    }
}

RAMURE_SUITE(TestArmBake)

} // namespace tst_arm_bake

#include "tst_arm_bake.moc"
