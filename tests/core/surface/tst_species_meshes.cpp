#include "core/generators/variety.h"
#include "core/params/presets.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/surface/check/self_intersections.h"
#include "tests/support/fork_judge.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_species_meshes {

using namespace ramure;

namespace {

constexpr int usualSeeds = test::runs(2), everyNth = test::isSanitized ? 8 : 1;
/// Of a mesh's triangles, pairs that run through each other around its forks. Stalks of palms, close
/// together, still do so; no tree of any seed may be worse than the worst is now.
constexpr double mostCrossings = 0.013;

} // namespace

/// Every species, by the program's own check and by a judge of the tests that shares no code with it.
/// RAMURE_SPECIES_SEEDS raises the number of trees of each for long runs.
class TestSpeciesMeshes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void treesAreOnePieceEach_data()
    {
        QTest::addColumn<int>("number");
        const auto all = presets();
        for (int i = 0; i < int(all.size()); i += everyNth)
            if (*all[std::size_t(i)].latin)
                QTest::newRow(all[std::size_t(i)].name) << i;
    }
    void treesAreOnePieceEach()
    {
        QFETCH(int, number);
        const Preset& preset = presets()[std::size_t(number)];
        const int seeds = std::max(usualSeeds, qEnvironmentVariableIntValue("RAMURE_SPECIES_SEEDS"));
        TreePipeline pipeline;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto tree = pipeline.evaluate(reseeded(preset.params, seed), Stage::Mesh);
            QVERIFY2(tree, test::why(tree));
            const Skeleton& skeleton = tree->simplified->skeleton;
            QCOMPARE(std::ranges::count(skeleton.parent, noIndex), 1);
            QCOMPARE(test::branchMeshFaults(skeleton, *tree->branches), std::string());
            if (seed > 1 && seeds == usualSeeds)
                continue;
            const TriangleMesh& mesh = tree->branches->mesh;
            const auto crossings =
                findSelfIntersections(mesh, repairedParents(skeleton, tree->branches->repairs));
            QVERIFY2(crossings, test::why(crossings));
            const double share = double(crossings->aroundForks()) / double(mesh.triangles.size());
            if (seeds > usualSeeds)
                qInfo("%s, seed %d: %.4f", preset.name, seed, share);
            QVERIFY2(share <= mostCrossings, qPrintable(QString::number(share)));
        }
    }
};

RAMURE_SUITE(TestSpeciesMeshes)

} // namespace tst_species_meshes

#include "tst_species_meshes.moc"
