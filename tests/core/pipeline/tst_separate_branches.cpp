#include "core/math/random.h"
#include "core/pipeline/separate_branches.h"
#include "core/presets/presets.h"
#include "core/skeleton/bend.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include "tests/support/turned_branches.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tst_separate_branches {

using namespace ramure;
using namespace ramure::test;

/// Branches turned about their starts, and the treatment of collisions that turns them.
class TestSeparateBranches : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void vectorsAreRotations();
    void bendsKeepLengthsAndKeys();
    void whatIsNotBentKeepsItsBytes();
    void bendsAreParametersOfTheTree();
    void treesWithoutCollisionsStay();
    void errorsAndCancelAreHandedOn();
    void presetsGetBetter_data();
    void presetsGetBetter();
    void theSameOnAnyNumberOfThreads();
};

namespace {

NodeParams small(const char* preset, std::int64_t iterations)
{
    NodeParams params = *presetParams(preset);
    if (iterations > 0)
        params.grammar.iterations = iterations;
    return params;
}

std::vector<glm::dvec3> randomBends(Random& random, std::size_t count)
{
    std::vector<glm::dvec3> bends(count, glm::dvec3(0.0));
    for (glm::dvec3& bend : bends)
        if (random.below(3) == 0)
            bend = {random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0)};
    return bends;
}

/// Worst relative change of a branch's length.
double worstStretch(const Skeleton& before, const Skeleton& after)
{
    double worst = 0.0;
    for (Index i = 0; i < before.size(); ++i)
        worst = std::max(worst, std::abs(after.length(i) / before.length(i) - 1.0));
    return worst;
}

} // namespace

void TestSeparateBranches::vectorsAreRotations()
{
    QVERIFY(bendRotation(glm::dvec3(0.0)) == glm::dquat(1.0, 0.0, 0.0, 0.0));
    QVERIFY(bendVector(glm::dquat(1.0, 0.0, 0.0, 0.0)) == glm::dvec3(0.0));
    const glm::dvec3 turned = bendRotation({0.0, 0.0, std::numbers::pi / 2}) * glm::dvec3(1, 0, 0);
    QVERIFY(glm::distance(turned, glm::dvec3(0, 1, 0)) < 1e-15);
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 bend(random.range(-1.7, 1.7), random.range(-1.7, 1.7), random.range(-1.7, 1.7));
        QVERIFY(glm::distance(bendVector(bendRotation(bend)), bend) < 1e-12);
        QVERIFY(glm::distance(bendVector(-bendRotation(bend)), bend) < 1e-12);
    }
}

void TestSeparateBranches::bendsKeepLengthsAndKeys()
{
    for (const char* preset : {"SmallTree", "TinyTree", "FanTree"}) {
        const auto skeleton = presetSkeleton({preset});
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Random random(seed, RandomStream::Test);
            Skeleton bent = *skeleton;
            const std::vector<glm::dvec3> bends = randomBends(random, bent.size());
            bendBranches(bent, bends);
            QVERIFY(worstStretch(*skeleton, bent) < 1e-12);
            QVERIFY(bent.key == skeleton->key && bent.parent == skeleton->parent && bent.a0 == skeleton->a0);
            const std::vector<glm::dquat> turned = bendRotations(*skeleton, bends);
            for (Index i = 0; i < bent.size(); ++i) {
                if (bent.parent[i] != noIndex)
                    QVERIFY(bent.p0[i] == bent.p1[bent.parent[i]] || bent.p0[i] == skeleton->p0[i]);
                const glm::dvec3 way = turned[i] * (skeleton->p1[i] - skeleton->p0[i]);
                QVERIFY(glm::distance(bent.p1[i] - bent.p0[i], way) < 1e-12);
            }
        }
    }
}

void TestSeparateBranches::whatIsNotBentKeepsItsBytes()
{
    const auto skeleton = presetSkeleton({"SmallTree"});
    Skeleton bent = *skeleton;
    std::vector<glm::dvec3> bends(bent.size(), glm::dvec3(0.0));
    bendBranches(bent, bends);
    QVERIFY(bent == *skeleton);
    const Index branch = bent.size() / 2;
    bends[branch] = {0.1, 0.2, -0.1};
    bendBranches(bent, bends);
    for (Index i = 0; i < bent.size(); ++i) {
        bool below = false;
        for (Index at = i; at != noIndex; at = bent.parent[at])
            below = below || at == branch;
        QCOMPARE(bent.p1[i] != skeleton->p1[i], below);
    }
}

void TestSeparateBranches::bendsAreParametersOfTheTree()
{
    TreePipeline pipeline;
    NodeParams params = small("SmallTree", 4);
    const auto plain = pipeline.evaluate(params);
    QVERIFY2(plain, why(plain));
    const auto bent =
        pipeline.evaluate(withSteps(params, test::bends(*plain, params, {{5, {0.3, 0.0, 0.1}}})));
    QVERIFY2(bent, why(bent));
    QVERIFY(bent->report->valid);
    QVERIFY(bent->grown == plain->grown); // as the turtle drew it
    std::vector<glm::dvec3> bends(plain->simplified->skeleton.size(), glm::dvec3(0.0));
    bends[5] = {0.3, 0.0, 0.1};
    Skeleton expected = plain->simplified->skeleton;
    bendBranches(expected, bends);
    for (Index i = 0; i < expected.size(); ++i)
        QVERIFY(glm::distance(expected.p1[i], bent->simplified->skeleton.p1[i]) < 1e-9);
    QVERIFY(bent->simplified->skeleton.p1[5] != plain->simplified->skeleton.p1[5]);
    QVERIFY(bent->branches->mesh.positions != plain->branches->mesh.positions);
    const auto back = pipeline.evaluate(params);
    QVERIFY(back->branches == plain->branches); // out of the cache
}

void TestSeparateBranches::treesWithoutCollisionsStay()
{
    TreePipeline pipeline;
    const NodeParams params = small("SmallTree", 3);
    const auto done = separateBranches(pipeline, params);
    QVERIFY2(done, why(done));
    QCOMPARE(done->before, std::size_t(0));
    QVERIFY(done->rest.empty() && done->steps.empty());
}

void TestSeparateBranches::errorsAndCancelAreHandedOn()
{
    TreePipeline pipeline;
    NodeParams params = small("TinyTree", 0);
    params.grammar.axiom = std::string("[");
    const auto bad = separateBranches(pipeline, params);
    QVERIFY(!bad && bad.error().path == "grammar.axiom");
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled =
        separateBranches(pipeline, small("TinyTree", 0), {}, Progress{stop.get_token(), {}});
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
}

void TestSeparateBranches::presetsGetBetter_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("iterations");
    QTest::addColumn<int>("most");
    QTest::newRow("TinyTree") << "TinyTree" << 0 << 0;
    QTest::newRow("SmallTree") << "SmallTree" << 8 << 0;
    QTest::newRow("FanTree 6") << "FanTree" << 6 << 0;
    // Flat, so that everything lies in one plane: only the promises count.
    QTest::newRow("Fern2D 3") << "Fern2D" << 3 << 1'000'000;
}

/// Lengths are kept, there are never more pairs than before, and the mesh is as good as it was.
void TestSeparateBranches::presetsGetBetter()
{
    QFETCH(QString, preset);
    QFETCH(int, iterations);
    QFETCH(int, most);
    TreePipeline pipeline;
    const NodeParams params = small(qPrintable(preset), iterations);
    double last = 0.0;
    const auto done = separateBranches(pipeline, params, {}, Progress{{}, [&](double f) {
                                                                          QVERIFY(f >= last && f <= 1.0);
                                                                          last = f;
                                                                      }});
    QVERIFY2(done, why(done));
    const auto before = pipeline.evaluate(params), after = pipeline.evaluate(withSteps(params, done->steps));
    QVERIFY(before && after);
    const auto foundBefore = analyseMesh(*before->branches, before->simplified->skeleton);
    const auto foundAfter = analyseMesh(*after->branches, after->simplified->skeleton);
    QVERIFY(foundBefore && foundAfter);
    QCOMPARE(foundBefore->collisions.size(), done->before);
    QVERIFY(foundAfter->collisions == done->rest);
    QVERIFY(done->rest.size() <= done->before);
    QVERIFY2(done->rest.size() <= std::size_t(most), qPrintable(QString::number(done->rest.size())));
    QVERIFY(foundAfter->crossings.aroundForks() <= foundBefore->crossings.aroundForks());
    QVERIFY(after->report->valid);
    QVERIFY(worstStretch(before->simplified->skeleton, after->simplified->skeleton) < 1e-12);
    QVERIFY(after->simplified->skeleton.key == before->simplified->skeleton.key);
    // A second treatment starts from the first.
    const auto again = separateBranches(pipeline, withSteps(params, done->steps));
    QVERIFY(again && again->rest.size() <= done->rest.size());
    if (done->rest.empty())
        QVERIFY(again->steps.empty());
}

void TestSeparateBranches::theSameOnAnyNumberOfThreads()
{
    TreePipeline pipeline;
    const NodeParams params = small("SmallTree", 8);
    SeparateOptions options;
    options.threads = 1;
    const auto one = separateBranches(pipeline, params, options);
    options.threads = 3;
    const auto three = separateBranches(pipeline, params, options);
    QVERIFY(one && three);
    QVERIFY(one->steps == three->steps);
    QVERIFY(one->rest == three->rest);
}

RAMURE_SUITE(TestSeparateBranches)

} // namespace tst_separate_branches

#include "tst_separate_branches.moc"
