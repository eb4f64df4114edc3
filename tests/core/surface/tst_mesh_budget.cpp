#include "core/surface/check/self_intersections.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/mesher/mesh_divisions.h"
#include "tests/support/fork_judge.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_mesh_budget {

using namespace ramure;
using namespace ramure::test;

/// A mesh of about so many triangles: near the number wanted, divided where it matters, and still one closed
/// manifold.
class TestMeshBudget : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void absurdBudgetsAreErrors();
    void budgetsAreKept_data();
    void budgetsAreKept();
    void forksStayClean_data();
    void forksStayClean();
    void whatCannotBeIsTold();
    void theSmallestMeshIsTheSameForAllSmallBudgets();
    void withoutABudgetTheDivisionsRule();
    void thickBranchesGetMore();
    void bentBranchesGetMore();
    void aTaperingBranchLosesSides();
    void roundingSpreads();
    void zoo();

private:
    static Expected<BranchMesh> meshOf(const Skeleton& skeleton, Index triangles);
};

namespace {

constexpr std::uint64_t slowness = test::isSanitized ? 20 : 1;

/// Vertices that a branch owns.
Index verticesOf(const BranchMesh& built, Index branch)
{
    const auto& owners = built.mesh.branch;
    return static_cast<Index>(std::count(owners.begin(), owners.end(), branch));
}

} // namespace

Expected<BranchMesh> TestMeshBudget::meshOf(const Skeleton& skeleton, Index triangles)
{
    BranchMeshOptions options;
    options.targetTriangles = triangles;
    return buildBranchMesh(skeleton, options);
}

void TestMeshBudget::absurdBudgetsAreErrors()
{
    const Expected<Skeleton> tree = presetSkeleton({"TinyTree"});
    const Expected<BranchMesh> built = meshOf(*tree, 4'000'000'000U);
    QVERIFY(!built);
    QCOMPARE(built.error().code, ErrorCode::Limit);
    QVERIFY(!meshOf(Skeleton(), 1000));
    std::stop_source source;
    source.request_stop();
    BranchMeshOptions options;
    options.targetTriangles = 50'000;
    const Expected<BranchMesh> stopped = buildBranchMesh(*tree, options, {source.get_token(), {}});
    QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
}

void TestMeshBudget::budgetsAreKept_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("seed");
    QTest::addColumn<unsigned>("budget");
    const auto rows = [](const char* preset, unsigned least, unsigned most) {
        for (const unsigned budget : {500U, 2000U, 5000U, 15'000U, 25'000U, 50'000U, 200'000U, 1'000'000U})
            for (const int seed : {0, 3})
                if (budget >= least && budget <= most && budget < 500'000 / slowness)
                    QTest::addRow("%s seed %d, %u", preset, seed, budget)
                        << QString(preset) << seed << budget;
    };
    rows("TinyTree", 2000, 400'000);
    rows("Fern2D", 15'000, 1'000'000);
    rows("SmallTree", 25'000, 1'000'000);
    rows("FanTree", 50'000, 1'000'000);
    if (slowness == 1)
        QTest::newRow("Fern2D, five million") << "Fern2D" << 0 << 5'000'000U;
}

void TestMeshBudget::budgetsAreKept()
{
    QFETCH(QString, preset);
    QFETCH(int, seed);
    QFETCH(unsigned, budget);
    const std::string name = preset.toStdString();
    PresetTree wanted{name};
    if (seed != 0)
        wanted.stochastic = static_cast<std::uint64_t>(seed);
    const Expected<Skeleton> skeleton = presetSkeleton(wanted);
    QVERIFY2(skeleton, why(skeleton));
    const Expected<BranchMesh> built = meshOf(*skeleton, budget);
    QVERIFY2(built, why(built));
    const double miss = std::abs(built->mesh.faceCount() / double(budget) - 1.0);
    QVERIFY2(miss <= budgetSlack, QByteArray::number(built->mesh.faceCount()));
    QCOMPARE(built->budget, BudgetFit::Within);
    QVERIFY(*budgetText(built->budget) == '\0');
    const std::string faults = branchMeshFaults(*skeleton, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestMeshBudget::forksStayClean_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<unsigned>("budget");
    for (const char* preset : {"SmallTree", "TinyTree", "Fern2D"})
        for (const unsigned budget : {1U, 30'000U, 90'000U})
            QTest::newRow(qPrintable(QString("%1 %2").arg(preset).arg(budget))) << QString(preset) << budget;
}

/// Rings of different counts and branches of few sections do not make a fork cut through itself.
void TestMeshBudget::forksStayClean()
{
    QFETCH(QString, preset);
    QFETCH(unsigned, budget);
    const std::string name = preset.toStdString();
    const Expected<Skeleton> skeleton = presetSkeleton({name});
    QVERIFY2(skeleton, why(skeleton));
    const Expected<BranchMesh> built = meshOf(*skeleton, budget);
    QVERIFY2(built, why(built));
    const auto crossings =
        ramure::findSelfIntersections(built->mesh, ramure::repairedParents(*skeleton, built->repairs));
    QVERIFY2(crossings, why(crossings));
    QVERIFY2(crossings->aroundForks() == 0, qPrintable(QString::number(crossings->aroundForks())));
}

void TestMeshBudget::whatCannotBeIsTold()
{
    const Expected<Skeleton> tree = presetSkeleton({"SmallTree"});
    const Expected<BranchMesh> small = meshOf(*tree, 500);
    QVERIFY(small);
    QCOMPARE(small->budget, BudgetFit::Smallest);
    QVERIFY(*budgetText(small->budget) != '\0');
    QVERIFY(small->mesh.faceCount() > 500);
    Skeleton stem;
    stem.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.01, 0.01);
    const Expected<BranchMesh> large = meshOf(stem, 100'000);
    QVERIFY(large);
    QCOMPARE(large->budget, BudgetFit::Largest);
    QVERIFY(*budgetText(large->budget) != '\0');
    QCOMPARE(large->mesh.faceCount(), Index(2 * mostSides * mostSections));
}

void TestMeshBudget::theSmallestMeshIsTheSameForAllSmallBudgets()
{
    const Expected<Skeleton> tree = presetSkeleton({"FanTree"});
    const Expected<BranchMesh> one = meshOf(*tree, 1), many = meshOf(*tree, 5000);
    QVERIFY(one && many);
    QVERIFY(one->mesh == many->mesh);
    const std::string faults = branchMeshFaults(*tree, *one);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestMeshBudget::withoutABudgetTheDivisionsRule()
{
    const Expected<Skeleton> tree = presetSkeleton({"TinyTree"});
    BranchMeshOptions fine;
    fine.radialDivisions = 16;
    const Expected<BranchMesh> usual = buildBranchMesh(*tree, {}), finer = buildBranchMesh(*tree, fine);
    QVERIFY(usual && finer);
    QCOMPARE(usual->budget, BudgetFit::NotAsked);
    QVERIFY(finer->mesh.faceCount() > usual->mesh.faceCount());
    fine.targetTriangles = 5000;
    const Expected<BranchMesh> same = meshOf(*tree, 5000), asked = buildBranchMesh(*tree, fine);
    QVERIFY(same && asked && same->mesh == asked->mesh);
}

void TestMeshBudget::thickBranchesGetMore()
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.2, 0.2);
    s.add(noIndex, {3, 0, 0}, {3, 1, 0}, 0.002, 0.002);
    const Expected<BranchMesh> built = meshOf(s, 400);
    QVERIFY2(built, why(built));
    QVERIFY(verticesOf(*built, 0) > 10 * verticesOf(*built, 1));
    QCOMPARE(verticesOf(*built, 1), Index(leastSides * leastSections + 2));
}

void TestMeshBudget::bentBranchesGetMore()
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.05, 0.05);
    s.add(0, {0, 1, 0}, {1, 1, 0}, 0.05, 0.05); // around a corner
    s.add(noIndex, {5, 0, 0}, {5, 1, 0}, 0.05, 0.05);
    s.add(2, {5, 1, 0}, {5, 2, 0}, 0.05, 0.05); // straight on
    const Expected<BranchMesh> built = meshOf(s, 1000);
    QVERIFY2(built, why(built));
    QVERIFY(verticesOf(*built, 1) > 2 * verticesOf(*built, 3));
}

/// One branch from thick to thin: its first ring has more points than its last, and the mesh is closed.
void TestMeshBudget::aTaperingBranchLosesSides()
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.5, 0.005);
    const Expected<BranchMesh> built = meshOf(s, 1500);
    QVERIFY2(built, why(built));
    QCOMPARE(built->budget, BudgetFit::Within);
    const auto& positions = built->mesh.positions;
    const auto at = [&](float low, float high) {
        return std::count_if(positions.begin(), positions.end(),
                             [&](const glm::vec3& p) { return p.y >= low && p.y <= high; });
    };
    QVERIFY(at(-0.001F, 0.001F) > 2 * at(1.999F, 2.0001F));
    const std::string faults = branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

/// Many equal branches: whole numbers of sides for all would leave gaps of a third between possible meshes.
void TestMeshBudget::roundingSpreads()
{
    Skeleton s;
    for (int i = 0; i < 300; ++i)
        s.add(noIndex, {0.5 * i, 0, 0}, {0.5 * i, 1, 0}, 0.05, 0.05);
    for (Index budget = 6000; budget < 20'000; budget += 1711) {
        const Expected<BranchMesh> built = meshOf(s, budget);
        QVERIFY2(built, why(built));
        QCOMPARE(built->budget, BudgetFit::Within);
    }
}

void TestMeshBudget::zoo()
{
    const std::uint64_t count = fuzzCount(800 / slowness);
    QByteArray text;
    for (std::uint64_t number = 0; number < count; ++number) {
        const Specimen animal = specimen(number);
        BranchMeshOptions options = animal.meshOptions();
        options.targetTriangles = static_cast<Index>(animal.skeleton.size() * (1 + number % 97) + 1);
        const std::string faults = branchMeshFaults(animal.skeleton, options);
        if (!faults.empty() && text.size() < 5000)
            text += "\n" + QByteArray::fromStdString(animal.name) + " budget " +
                    QByteArray::number(options.targetTriangles) + "\n" + QByteArray::fromStdString(faults);
    }
    QVERIFY2(text.isEmpty(), text);
}

RAMURE_SUITE(TestMeshBudget)

} // namespace tst_mesh_budget

#include "tst_mesh_budget.moc"
