#include "core/rig/physics/wind.h"
#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"

namespace tst_wind {

using namespace ramure;

namespace {

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12)
{
    return glm::length(a - b) < tolerance;
}

} // namespace

class TestWind : public QObject
{
    Q_OBJECT
private:
    std::shared_ptr<const TreeBody> m_body = test::presetTree("SmallTree").body();

private slots:
    void init() { test::failOnAnyWarning(); }

    void aTreeWithoutBranchesHasNoWind()
    {
        const WindField wind(*makeTreeBody(Skeleton(), nullptr, 0.2), {});
        QVERIFY(isNear(wind.at(1.0).mean, {robustWindSpeed, 0.0, 0.0}));
    }

    void faithfulWindIsThatOfTheSpecification()
    {
        const PhysicsParams params;
        for (int k = 0; k < 2000; ++k) {
            const double t = 0.037 * k, s = t + 56485, s2 = 2.5 * t + 56485, s5 = 5 * t + 56485;
            const double u = 4 * std::sin(t) + 2 * std::sin(2.5 * t) + 0.4 * std::sin(5 * t);
            const double v = 4 * std::cos(s) + 2 * std::cos(s2) + 0.4 * std::cos(s5);
            QVERIFY(isNear(faithfulWind(params, t), {u, 0.0, v}));
            PhysicsParams turned;
            turned.windStrength = 3.0;
            turned.windDirection = 1.5707963267948966;
            QVERIFY(isNear(faithfulWind(turned, t), {3.0 * v, 0.0, -3.0 * u}, 1e-10));
        }
    }

    void noStrengthIsNoWind()
    {
        PhysicsParams params;
        params.windStrength = 0.0;
        const WindField wind(*m_body, params);
        for (Index slot = 0; slot < m_body->size(); ++slot)
            QVERIFY(isNear(wind.velocity(wind.at(0.7), slot), glm::dvec3(0.0)));
    }

    void blowsOnAverageAsStronglyAsSaid()
    {
        PhysicsParams params;
        params.windStrength = 2.0;
        params.windDirection = 0.5;
        const WindField wind(*m_body, params);
        glm::dvec3 sum(0.0);
        double fastest = 0.0, slowest = 1e9;
        constexpr int samples = 200'000;
        for (int k = 0; k < samples; ++k) {
            const glm::dvec3 v = wind.velocity(wind.at(0.01 * k), 5);
            sum += v / double(samples);
            fastest = std::max(fastest, glm::length(v));
            slowest = std::min(slowest, glm::length(v));
        }
        const glm::dvec3 mean = 2.0 * robustWindSpeed * glm::dvec3(std::cos(0.5), 0.0, -std::sin(0.5));
        QVERIFY2(isNear(sum, mean, 0.1), QByteArray::number(glm::length(sum - mean)));
        QVERIFY(fastest > 1.3 * glm::length(mean) && slowest < 0.7 * glm::length(mean));
    }

    void turbulenceDiffersFromPlaceToPlace()
    {
        PhysicsParams params;
        params.windGust = 0.0;
        const auto spread = [&] {
            const WindField wind(*m_body, params);
            const WindField::Moment now = wind.at(3.0);
            double worst = 0.0;
            for (Index slot = 0; slot < m_body->size(); ++slot)
                worst = std::max(worst, glm::length(wind.velocity(now, slot) - now.mean));
            return worst;
        };
        QVERIFY(spread() > 0.5);
        params.windTurbulence = 0.0;
        QVERIFY(spread() < 1e-12);
    }

    void seedsCountAndNothingIsRemembered()
    {
        PhysicsParams one, two;
        two.seed = 2;
        two.windStrength = 3.0;
        two.windDirection = 1.0;
        WindField wind(*m_body, one);
        const auto look = [&](const WindField& field) { return field.velocity(field.at(1.5), 7); };
        const glm::dvec3 first = look(wind);
        wind.setParams(*m_body, two);
        QVERIFY(!isNear(look(wind), first));
        QVERIFY(look(wind) == look(WindField(*m_body, two)));
        two.windGust = 0.1; // seed and direction stay
        wind.setParams(*m_body, two);
        QVERIFY(look(wind) == look(WindField(*m_body, two)));
        wind.setParams(*m_body, one);
        QVERIFY(look(wind) == first);
    }
};

RAMURE_SUITE(TestWind)

} // namespace tst_wind

#include "tst_wind.moc"
