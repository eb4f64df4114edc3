#include "core/rig/physics/physics_script.h"
#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"

namespace tst_physics_script {

using namespace ramure;

namespace {

PhysicsParams withWind(double strength, double stepSeconds = 0.01)
{
    PhysicsParams params;
    params.windStrength = strength;
    params.stepSeconds = stepSeconds;
    return params;
}

} // namespace

class TestPhysicsScript : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void changesCountFromTheirStepOn()
    {
        PhysicsScript script(withWind(1));
        script.setParams(withWind(2), 10);
        script.setParams(withWind(3), 20);
        QCOMPARE(script.paramsAt(0).windStrength, 1.0);
        QCOMPARE(script.paramsAt(9).windStrength, 1.0);
        QCOMPARE(script.paramsAt(10).windStrength, 2.0);
        QCOMPARE(script.paramsAt(1000).windStrength, 3.0);
        script.setParams(withWind(4), 15); // what was said for later is over
        QCOMPARE(script.paramsAt(1000).windStrength, 4.0);
        script.setParams(withWind(5), 0);
        QCOMPARE(script.paramChanges().size(), std::size_t(1));
        QVERIFY(!script.pullAt(5));
        script.setPull(Pull{1, 1.0, {1, 2, 3}, 1.0}, 5);
        script.setPull(std::nullopt, 8);
        QVERIFY(!script.pullAt(4) && script.pullAt(5) && script.pullAt(7) && !script.pullAt(8));
        script.shakeOff(3, 12);
        script.shakeOff(4, 12);
        script.shakeOff(3, 20); // it is gone already
        QCOMPARE(script.applesAt(12), (std::vector<Index>{3, 4}));
        QVERIFY(script.applesAt(11).empty() && script.applesAt(20).empty());
        script.shakeOff(3, 2);
        QCOMPARE(script.applesAt(12), (std::vector<Index>{4}));
        script.clear();
        QVERIFY(script == PhysicsScript(withWind(5)));
    }

    void keysChangeBehindAnEditOnly()
    {
        PhysicsScript script(withWind(1));
        const std::uint64_t at10 = script.keyAt(10), at11 = script.keyAt(11);
        script.setParams(withWind(2), 10);
        QCOMPARE(script.keyAt(10), at10);
        QVERIFY(script.keyAt(11) != at11);
        script.setParams(withWind(1), 10); // taken back
        QCOMPARE(script.keyAt(11), at11);
        script.setPull(Pull{}, 10);
        QCOMPARE(script.keyAt(10), at10);
        QVERIFY(script.keyAt(11) != at11);
        script.setPull(std::nullopt, 10);
        QCOMPARE(script.keyAt(11), at11);
        script.shakeOff(0, 10);
        QCOMPARE(script.keyAt(10), at10);
        QVERIFY(script.keyAt(11) != at11);
    }

    void everyParameterIsInTheKey()
    {
        Random random(1, RandomStream::Test);
        const PhysicsScript plain{PhysicsParams()};
        for (const ParamDef& def : paramTable()) {
            if (!std::string_view(def.key).starts_with("physics."))
                continue;
            NodeParams node;
            if (def.type == ParamType::Real)
                def.assign(node, 0.5 * std::get<double>(defaultValue(def)) + 0.01);
            else if (def.type == ParamType::Int)
                def.assign(node, std::get<std::int64_t>(defaultValue(def)) + 1);
            else if (def.type == ParamType::Bool)
                def.assign(node, !std::get<bool>(defaultValue(def)));
            else
                def.assign(
                    node,
                    EnumValue{def.items[def.get(node) == ParamValue(EnumValue{def.items[0].name})].name});
            QVERIFY2(PhysicsScript(node.physics).keyAt(1) != plain.keyAt(1), def.key);
            QCOMPARE(PhysicsScript(node.physics).keyAt(0), plain.keyAt(0));
        }
    }

    void timesAndStepsAgree()
    {
        PhysicsScript script(withWind(1, 0.01));
        for (std::int64_t k = 0; k < 2000; ++k) {
            QCOMPARE(script.timeAt(k), double(k) * 0.01);
            QCOMPARE(script.stepAt(double(k) * 0.01), k);
        }
        QCOMPARE(script.stepAt(0.994), 99);
        QCOMPARE(script.stepAt(0.996), 100);
        QCOMPARE(script.stepAt(-5.0), 0);
        QVERIFY(script.stepAt(1e300) >= 1'000'000'000);
        script.setParams(withWind(2, 0.01), 50);
        script.setParams(withWind(2, 0.02), 100);
        script.setParams(withWind(2, 0.005), 200);
        QCOMPARE(script.timeAt(100), 1.0);
        QCOMPARE(script.timeAt(200), 3.0);
        QCOMPARE(script.timeAt(300), 3.5);
        for (std::int64_t k = 0; k < 400; ++k)
            QCOMPARE(script.stepAt(script.timeAt(k)), k);
        // The states say the same.
        TreePhysics physics(test::presetTree("TinyTree").body(), script.paramsAt(0));
        PhysicsState state = physics.restState();
        for (std::int64_t k = 0; k < 400; ++k) {
            QCOMPARE(state.timeSeconds, script.timeAt(k));
            physics.setParams(script.paramsAt(k));
            physics.step(state);
        }
    }
};

RAMURE_SUITE(TestPhysicsScript)

} // namespace tst_physics_script

#include "tst_physics_script.moc"
