#include "core/rig/physics/physics_cache.h"
#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"

namespace tst_physics_cache {

using namespace ramure;

namespace {

PhysicsParams withWind(double strength)
{
    PhysicsParams params;
    params.windStrength = strength;
    return params;
}

/// All states of straight play under a script.
std::vector<PhysicsState> straight(const std::shared_ptr<const TreeBody>& body, const PhysicsScript& script,
                                   int steps)
{
    TreePhysics physics(body, script.paramsAt(0));
    std::vector<PhysicsState> out{physics.restState()};
    PhysicsState state = out.front();
    for (int k = 0; k < steps; ++k) {
        physics.setParams(script.paramsAt(k));
        for (const Index apple : script.applesAt(k))
            physics.shakeOff(state, apple);
        physics.step(state, script.pullAt(k));
        out.push_back(state);
    }
    return out;
}

std::vector<StepRange> expectedRanges(const PhysicsCache& cache, std::int64_t last)
{
    std::vector<StepRange> out;
    for (std::int64_t k = 0; k <= last; ++k) {
        const StepState state = cache.stateOf(k);
        if (!out.empty() && out.back().state == state)
            out.back().last = k;
        else
            out.push_back({k, k, state});
    }
    return out;
}

} // namespace

class TestPhysicsCache : public QObject
{
    Q_OBJECT
private:
    std::shared_ptr<const TreeBody> m_body = test::presetTree("TinyTree").body();

private slots:
    void init() { test::failOnAnyWarning(); }

    void stepsOutsideAreRefused()
    {
        PhysicsCache cache(m_body, {});
        QCOMPARE(cache.seek(-1).error().code, ErrorCode::Invalid);
        QCOMPARE(cache.seek(maxPhysicsSteps + 1).error().code, ErrorCode::Invalid);
        QCOMPARE(cache.step(), 0);
        QCOMPARE(cache.stepAt(std::nan("")), 0);
        QCOMPARE(cache.stepAt(-3.0), 0);
        QCOMPARE(cache.stepAt(HUGE_VAL), maxPhysicsSteps);
    }

    void cancellingKeepsWhatIsThere()
    {
        PhysicsCache cache(m_body, {});
        std::stop_source stop;
        const Progress progress{stop.get_token(), [&](double fraction) {
                                    if (fraction > 0.5)
                                        stop.request_stop();
                                }};
        const auto done = cache.seek(cache.stepAt(10.0), progress);
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::Cancelled);
        QVERIFY(cache.step() > 400 && cache.step() < 700);
        QVERIFY(cache.seek(1000));
        QVERIFY(test::sameBits(cache.state(), straight(m_body, PhysicsScript(PhysicsParams()), 1000).back()));
    }

    void anyOrderGivesTheSameBits_data()
    {
        QTest::addColumn<int>("checkpointSteps");
        QTest::addColumn<int>("ringStates");
        QTest::addColumn<int>("kilobytes");
        QTest::newRow("usual") << 0 << 64 << 500'000;
        QTest::newRow("ten") << 10 << 64 << 500'000;
        QTest::newRow("every step") << 1 << 1 << 500'000;
        QTest::newRow("no sense") << -3 << -3 << 500'000;
        QTest::newRow("little memory") << 10 << 64 << 300;
        QTest::newRow("no memory") << 10 << 64 << 0;
    }
    void anyOrderGivesTheSameBits()
    {
        QFETCH(int, checkpointSteps);
        QFETCH(int, ringStates);
        QFETCH(int, kilobytes);
        for (const PhysicsMode mode : {PhysicsMode::Faithful, PhysicsMode::Robust}) {
            PhysicsParams params;
            params.mode = mode;
            PhysicsCache cache(m_body, params, {checkpointSteps, ringStates, std::size_t(kilobytes) * 1000});
            cache.setParams(withWind(2.0), 120);
            cache.setPull(Pull{5, 0.5, {1.0, 1.0, 1.0}, 2.0}, 200);
            cache.setPull(std::nullopt, 230);
            cache.shakeOff(2, 250);
            const auto states = straight(m_body, cache.script(), 500);
            Random random(9, RandomStream::Test);
            for (int i = 0; i < 200; ++i) {
                const int step =
                    i % 5 == 4 ? int(std::max<std::int64_t>(cache.step() - 1, 0)) : int(random.below(501));
                QVERIFY(cache.seek(step));
                QCOMPARE(cache.step(), step);
                QVERIFY(test::sameBits(cache.state(), states[std::size_t(step)]));
                QVERIFY(kilobytes == 0 || cache.bytes() <= std::size_t(kilobytes) * 1000);
            }
        }
    }

    void editsMakeStaleWhatComesAfter()
    {
        PhysicsCache cache(m_body, withWind(1.0), {10, 20, std::size_t(1) << 30});
        QCOMPARE(cache.ranges(0, 1000),
                 (std::vector<StepRange>{{0, 0, StepState::Cached}, {1, 1000, StepState::Missing}}));
        QVERIFY(cache.seek(500));
        QCOMPARE(cache.ranges(0, 1000),
                 (std::vector<StepRange>{{0, 500, StepState::Cached}, {501, 1000, StepState::Missing}}));
        QCOMPARE(cache.ranges(495, 505),
                 (std::vector<StepRange>{{495, 500, StepState::Cached}, {501, 505, StepState::Missing}}));
        cache.setParams(withWind(2.0), 200);
        QCOMPARE(cache.step(), 200);
        const std::vector<StepRange> edited{
            {0, 200, StepState::Cached}, {201, 500, StepState::Stale}, {501, 1000, StepState::Missing}};
        QCOMPARE(cache.ranges(0, 1000), edited);
        cache.setParams(withWind(1.0), 200); // undone
        QCOMPARE(cache.ranges(0, 1000),
                 (std::vector<StepRange>{{0, 500, StepState::Cached}, {501, 1000, StepState::Missing}}));
        cache.setParams(withWind(2.0), 200);
        QVERIFY(cache.seek(300));
        QCOMPARE(cache.ranges(0, 1000), (std::vector<StepRange>{{0, 300, StepState::Cached},
                                                                {301, 500, StepState::Stale},
                                                                {501, 1000, StepState::Missing}}));
        QVERIFY(cache.seek(50));
        QCOMPARE(cache.stateOf(300), StepState::Cached);
        cache.clearStates();
        QCOMPARE(cache.bytes(), std::size_t(0));
        QCOMPARE(cache.stateOf(300), StepState::Missing);
        QCOMPARE(cache.step(), 50);
    }

    void rangesAreWhatTheStepsSay()
    {
        Random random(4, RandomStream::Test);
        for (int run = 0; run < 30; ++run) {
            PhysicsCache cache(m_body, {},
                               {int(random.below(12)) + 1, int(random.below(30)) + 1,
                                std::size_t(random.below(2)) * 100'000'000 + 200'000});
            for (int i = 0; i < 6; ++i) {
                if (random.below(2) == 0)
                    cache.setParams(withWind(double(random.below(3))), random.below(200));
                else
                    QVERIFY(cache.seek(random.below(200)));
                QCOMPARE(cache.ranges(0, 220), expectedRanges(cache, 220));
                QCOMPARE(cache.stateOf(cache.step()), StepState::Cached);
            }
        }
    }

    void editsAtTheBeginningStartAnew()
    {
        PhysicsCache cache(m_body, withWind(1.0));
        QVERIFY(cache.seek(100));
        PhysicsParams faithful = test::faithful();
        cache.setParams(faithful, 0);
        QCOMPARE(cache.step(), 0);
        QCOMPARE(cache.state().mode, PhysicsMode::Faithful);
        QVERIFY(cache.seek(100));
        QVERIFY(test::sameBits(cache.state(), straight(m_body, PhysicsScript(faithful), 100).back()));
        QCOMPARE(cache.params(), faithful);
    }

    void editsWhilePlayingGoOnFromHere()
    {
        PhysicsCache cache(m_body, withWind(1.0));
        for (int k = 0; k < 100; ++k) {
            QVERIFY(cache.seek(cache.step() + 1));
            if (k % 10 == 0)
                cache.setParams(withWind(0.1 * k), cache.step());
            if (k % 7 == 0)
                cache.setPull(k % 2 == 0 ? std::optional<Pull>(Pull{3, 1.0, {0.1 * k, 1.0, 0.0}, 1.0})
                                         : std::nullopt,
                              cache.step());
            QCOMPARE(cache.step(), k + 1);
        }
        cache.shakeOff(1, cache.step());
        QVERIFY(cache.seek(150));
        const auto states = straight(m_body, cache.script(), 150);
        QVERIFY(test::sameBits(cache.state(), states.back()));
        for (const int step : {10, 77, 3, 149})
            QVERIFY(cache.seek(step) && test::sameBits(cache.state(), states[std::size_t(step)]));
    }

    void anotherTreeForgetsAll()
    {
        PhysicsCache cache(m_body, withWind(2.0));
        cache.setPull(Pull{}, 10);
        QVERIFY(cache.seek(100));
        const auto other = test::presetTree("Fern2D").body();
        cache.setBody(other);
        QCOMPARE(cache.physics().body().size(), other->size());
        QCOMPARE(cache.bytes(), std::size_t(0));
        QVERIFY(cache.script() == PhysicsScript(withWind(2.0)));
        QVERIFY(cache.seek(20));
        QVERIFY(test::sameBits(cache.state(), straight(other, cache.script(), 20).back()));
    }

    void posesComeInAnyOrder()
    {
        PhysicsCache cache(m_body, {});
        const auto poseAt = [&cache](double seconds) {
            Pose pose;
            [&] { QVERIFY(cache.seek(cache.stepAt(seconds))); }();
            cache.pose(pose);
            return pose;
        };
        const Pose late = poseAt(2.0), early = poseAt(1.004);
        QVERIFY(poseAt(2.0) == late);
        QCOMPARE(early.timeSeconds, 1.0);
        QCOMPARE(cache.stepAt(1e300), maxPhysicsSteps);
    }
};

RAMURE_SUITE(TestPhysicsCache)

} // namespace tst_physics_cache

#include "tst_physics_cache.moc"
