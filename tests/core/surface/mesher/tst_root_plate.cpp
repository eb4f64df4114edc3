#include "core/math/random.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/fork_judge.h"
#include "tests/support/suite.h"

#include <numbers>

namespace tst_root_plate {

using namespace ramure;

/// Stems that start together are one mesh.
class TestRootPlate : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void stemsApartStayApart();
    void fewStems_data();
    void fewStems();
    void stemsByChance();
    void grammarsWithTwoRoots();
};

void TestRootPlate::stemsApartStayApart()
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    s.add(noIndex, {0.3, 0, 0}, {0.3, 1, 0}, 0.1, 0.1);
    const auto built = buildBranchMesh(s, {});
    QVERIFY2(built, test::why(built));
    QCOMPARE(built->roots, Index{2});
    QVERIFY(built->repairs.empty());
}

void TestRootPlate::fewStems_data()
{
    QTest::addColumn<int>("stems");
    QTest::addColumn<double>("lean"); // rad off +Y
    for (const int stems : {2, 3, 5, 8})
        for (const double lean : {0.3, 0.8, 1.5, 2.5})
            QTest::addRow("%d stems, %g", stems, lean) << stems << lean;
}

void TestRootPlate::fewStems()
{
    QFETCH(int, stems);
    QFETCH(double, lean);
    Skeleton s;
    for (int k = 0; k < stems; ++k) {
        const double azimuth = 2.0 * std::numbers::pi * k / stems;
        const glm::dvec3 way(std::sin(lean) * std::cos(azimuth), std::cos(lean),
                             std::sin(lean) * std::sin(azimuth));
        const Index root = s.add(noIndex, 0.04 * way, way, 0.1, 0.07);
        s.add(root, way, way + glm::dvec3(0, 1, 0.2 * k), 0.07, 0.05);
    }
    const auto built = buildBranchMesh(s, {});
    QVERIFY2(built, test::why(built));
    QCOMPARE(built->roots, Index{1});
    const std::string faults = test::branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestRootPlate::stemsByChance()
{
    Random random(5, RandomStream::Test);
    const auto direction = [&random] {
        glm::dvec3 way(0.0);
        while (glm::length(way) < 0.1 || glm::length(way) > 1.0) {
            way.x = random.range(-1.0, 1.0);
            way.y = random.range(-1.0, 1.0);
            way.z = random.range(-1.0, 1.0);
        }
        return glm::normalize(way);
    };
    for (int round = 0; round < 400; ++round) {
        Skeleton s;
        const Index places = 1 + random.below(3);
        const Index stems = 2 + random.below(6);
        for (Index k = 0; k < stems; ++k) {
            const glm::dvec3 foot =
                glm::dvec3(double(random.below(places)), 0.0, 0.0) + random.range(0.0, 0.15) * direction();
            const double radius = random.range(0.02, 0.15);
            const glm::dvec3 tip =
                foot + (random.below(12) == 0 ? 0.0 : random.range(0.2, 1.2)) * direction();
            const Index root = s.add(noIndex, foot, tip, radius, 0.8 * radius);
            for (Index twigs = random.below(4); twigs > 0; --twigs)
                s.add(root, tip, tip + random.range(0.2, 0.7) * direction(), 0.5 * radius, 0.3 * radius, 1);
        }
        const std::string faults = test::branchMeshFaults(s, BranchMeshOptions{});
        QVERIFY2(faults.empty(), qPrintable(QStringLiteral("%1: %2").arg(round).arg(faults.c_str())));
    }
}

void TestRootPlate::grammarsWithTwoRoots()
{
    NodeParams params;
    params.grammar.axiom = "XAF";
    params.grammar.rules = "C -> B[FXBBF[BA]]BX\nX -> [_CC]BA";
    params.grammar.iterations = 1;
    params.turtle.theta = 1.02;
    params.turtle.decay = 0.788;
    params.sections.radialDivisions = 12;
    const auto tree = TreePipeline().evaluate(params);
    QVERIFY2(tree, test::why(tree));
    QCOMPARE(tree->branches->roots, Index{1});
    QVERIFY(tree->report->valid);
    QCOMPARE(tree->report->components, Index{1});
    const auto analysis = analyseMesh(*tree->branches, tree->simplified->skeleton, 1, {});
    QVERIFY2(analysis, test::why(analysis));
    QVERIFY(tree->texture); // the stems have their coordinates too
}

RAMURE_SUITE(TestRootPlate)

} // namespace tst_root_plate

#include "tst_root_plate.moc"
