#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"

namespace tst_faithful_step {

using namespace ramure;

namespace {

/// SPEC A7 word by word: positions, matrices and recursion, nothing shared with the program.
class Reference
{
public:
    Reference(const Skeleton& skeleton, const Foliage& foliage)
        : m_branches(skeleton.size())
    {
        for (Index i = 0; i < skeleton.size(); ++i) {
            Branch& b = m_branches[i];
            b.p0 = skeleton.p0[i];
            b.p1 = skeleton.p1[i];
            b.rest = glm::normalize(b.p1 - b.p0);
            b.a0 = skeleton.a0[i];
            b.mass = skeleton.a1[i];
            if (skeleton.parent[i] == noIndex)
                m_roots.push_back(i);
            else
                m_branches[skeleton.parent[i]].children.push_back(i);
        }
        for (const FoliageItem& apple : foliage.apples)
            m_branches[apple.branch].mass += 0.075;
        for (const Index root : m_roots)
            weigh(root);
    }
    void step()
    {
        for (const Index root : m_roots)
            move(root, glm::dmat3(1.0), glm::dvec3(0.0));
        ++m_step;
    }
    [[nodiscard]] const glm::dvec3& p0(Index branch) const { return m_branches[branch].p0; }
    [[nodiscard]] const glm::dvec3& p1(Index branch) const { return m_branches[branch].p1; }
    [[nodiscard]] const glm::dvec3& velocity(Index branch) const { return m_branches[branch].velocity; }
    [[nodiscard]] double mass(Index branch) const { return m_branches[branch].mass; }

private:
    struct Branch
    {
        glm::dvec3 p0{0.0}, p1{0.0}, rest{0.0}, velocity{0.0};
        double a0 = 0.0, mass = 0.0;
        std::vector<Index> children;
    };

    double weigh(Index branch)
    {
        for (const Index child : m_branches[branch].children)
            m_branches[branch].mass += weigh(child);
        return m_branches[branch].mass;
    }
    /// Rodrigues' formula.
    static glm::dmat3 rotation(const glm::dvec3& from, const glm::dvec3& to)
    {
        const glm::dvec3 across = glm::cross(from, to);
        const double sine = glm::length(across), cosine = glm::dot(from, to);
        if (sine == 0.0)
            return glm::dmat3(1.0);
        const glm::dvec3 k = across / sine;
        const glm::dmat3 turn(0.0, k.z, -k.y, -k.z, 0.0, k.x, k.y, -k.x, 0.0);
        const double angle = std::atan2(sine, cosine);
        return glm::dmat3(1.0) + std::sin(angle) * turn + (1.0 - std::cos(angle)) * (turn * turn);
    }
    void move(Index index, const glm::dmat3& turn, const glm::dvec3& shift)
    {
        Branch& b = m_branches[index];
        const double dt = 0.01, t = static_cast<double>(m_step) * dt;
        b.p0 = turn * b.p0 + shift;
        b.p1 = turn * b.p1 + shift;
        const double u = 4 * std::sin(t) + 2 * std::sin(2.5 * t) + 0.4 * std::sin(5 * t);
        const double v =
            4 * std::cos(t + 56485) + 2 * std::cos(2.5 * t + 56485) + 0.4 * std::cos(5 * t + 56485);
        b.velocity += dt * glm::dvec3(u / std::sqrt(b.mass), 0.0, v / std::sqrt(b.mass));
        b.velocity += dt * glm::dvec3(0.0, -b.mass, 0.0);
        const glm::dvec3 q = b.p1 + dt * b.velocity;
        const glm::dmat3 r = rotation(glm::normalize(b.p1 - b.p0), glm::normalize(q - b.p0));
        const glm::dvec3 p1 = b.p0 + r * (b.p1 - b.p0);
        b.velocity = (p1 - b.p1) / dt;
        b.p1 = p1;
        const glm::dvec3 now = glm::normalize(b.p1 - b.p0);
        const double angle = std::atan2(glm::length(glm::cross(now, b.rest)), glm::dot(now, b.rest));
        const glm::dvec3 towards = b.rest - glm::dot(b.rest, now) * now;
        if (glm::length(towards) > 0.0)
            b.velocity += 1000.0 * b.a0 * angle * angle * glm::normalize(towards);
        b.velocity *= 0.7;
        for (const Index child : b.children)
            move(child, r * turn, r * shift + b.p0 - r * b.p0);
    }

    std::vector<Branch> m_branches;
    std::vector<Index> m_roots;
    int m_step = 0;
};

double degrees(double rad)
{
    return rad * 57.29577951308232;
}

} // namespace

class TestFaithfulStep : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void agreesWithTheReference_data() { test::addPresetRows(); }
    void agreesWithTheReference()
    {
        QFETCH(QByteArray, name);
        const test::MovingTree tree = test::presetTree(name.constData());
        const auto body = tree.body();
        TreePhysics physics(body, test::faithful());
        PhysicsState state = physics.restState();
        Reference reference(tree.skeleton, tree.foliage);
        Pose pose;
        double worst = 0.0, worstVelocity = 0.0;
        for (int k = 1; k <= 1000; ++k) {
            physics.step(state);
            reference.step();
            physics.pose(state, pose);
            for (Index i = 0; i < tree.skeleton.size(); ++i) {
                const RigidTransform& bone = pose.bones[i];
                worst = std::max({worst, glm::length(bone.point(tree.skeleton.p0[i]) - reference.p0(i)),
                                  glm::length(bone.point(tree.skeleton.p1[i]) - reference.p1(i))});
                const Index slot = body->slotOf[i];
                const glm::dvec3 velocity(state.channel(PhysicsState::VelX)[slot],
                                          state.channel(PhysicsState::VelY)[slot],
                                          state.channel(PhysicsState::VelZ)[slot]);
                worstVelocity = std::max(worstVelocity, glm::length(velocity - reference.velocity(i)));
            }
        }
        QVERIFY2(worst < 1e-9, QByteArray::number(worst));
        QVERIFY2(worstVelocity < 1e-9, QByteArray::number(worstVelocity));
        double energy = 0.0;
        for (Index i = 0; i < tree.skeleton.size(); ++i)
            energy += 0.5 * reference.mass(i) * glm::dot(reference.velocity(i), reference.velocity(i));
        const PhysicsFigures figures = physics.figures(state);
        QVERIFY(std::abs(figures.kineticEnergy - energy) < 1e-9 * (1.0 + energy));
        QCOMPARE(state.step, 1000);
        QCOMPARE(state.timeSeconds, 1000 * 0.01);
    }

    /// SPEC A7's figures: full wind, 10,000 steps, no apples.
    void leansAsTheSpecificationSays_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("SmallTree") << QByteArray("SmallTree") << 33.0 << 35.0;
        QTest::newRow("FanTree") << QByteArray("FanTree") << 12.5 << 15.0;
        QTest::newRow("TinyTree") << QByteArray("TinyTree") << 36.5 << 37.5;
        QTest::newRow("Fern2D") << QByteArray("Fern2D") << 166.0 << 168.0;
    }
    void leansAsTheSpecificationSays()
    {
        QFETCH(QByteArray, name);
        QFETCH(double, least);
        QFETCH(double, most);
        const auto body = test::presetTree(name.constData()).body(false);
        TreePhysics physics(body, test::faithful());
        PhysicsState state = physics.restState();
        double lean = 0.0, lengthError = 0.0;
        for (int k = 1; k <= 10'000; ++k) {
            physics.step(state);
            if (k % 25 != 0)
                continue;
            const PhysicsFigures figures = physics.figures(state);
            lean = std::max(lean, degrees(figures.largestTurnRad));
            lengthError = std::max(lengthError, figures.lengthError);
        }
        QVERIFY2(lean >= least && lean <= most, QByteArray::number(lean));
        QVERIFY2(lengthError < 1e-6, QByteArray::number(lengthError));
        QVERIFY(test::allFinite(state));
    }

    void settlesWithoutWind_data() { test::addPresetRows(); }
    void settlesWithoutWind()
    {
        QFETCH(QByteArray, name);
        PhysicsParams params = test::faithful();
        params.windStrength = 0.0;
        TreePhysics physics(test::presetTree(name.constData()).body(false), params);
        PhysicsState state = physics.restState();
        for (int k = 1; k <= 10'000; ++k)
            physics.step(state);
        const PhysicsFigures figures = physics.figures(state);
        QVERIFY2(degrees(figures.largestTurnRad) < 2.2, QByteArray::number(degrees(figures.largestTurnRad)));
        for (int k = 1; k <= 100; ++k)
            physics.step(state);
        QVERIFY(std::abs(physics.figures(state).largestTurnRad - figures.largestTurnRad) < 1e-3);
    }

    void parametersOfTheRobustModeDoNothing()
    {
        const auto body = test::presetTree("TinyTree").body();
        const auto after = [&](const PhysicsParams& params) {
            TreePhysics physics(body, params);
            PhysicsState state = physics.restState();
            for (int k = 0; k < 100; ++k)
                physics.step(state);
            return state;
        };
        PhysicsParams params = test::faithful();
        params.restFrame = RestFrame::World;
        params.substeps = 7;
        params.windGust = params.windTurbulence = 3.0;
        params.seed = 99;
        QVERIFY(test::sameBits(after(params), after(test::faithful())));
        params.windDirection = 0.1;
        QVERIFY(!test::sameBits(after(params), after(test::faithful())));
    }

    void wildParametersStayFinite()
    {
        Random random(3, RandomStream::Test);
        for (int run = 0; run < 200; ++run) {
            const test::MovingTree tree = test::randomTree(random, 30);
            PhysicsParams params = test::randomPhysics(random);
            params.mode = PhysicsMode::Faithful;
            TreePhysics physics(tree.body(), params);
            PhysicsState state = physics.restState();
            for (int k = 0; k < 200; ++k)
                physics.step(state);
            QVERIFY(test::allFinite(state));
            QVERIFY(physics.figures(state).lengthError < 1e-6);
        }
    }
};

RAMURE_SUITE(TestFaithfulStep)

} // namespace tst_faithful_step

#include "tst_faithful_step.moc"
