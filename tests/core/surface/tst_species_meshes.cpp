#include "core/generators/variety.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesh/near_positions.h"
#include "core/surface/proof/validate.h"
#include "tests/support/fork_judge.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace tst_species_meshes {

using namespace ramure;

namespace {

constexpr int usualSeeds = test::runs(2), everyNth = test::isSanitized ? 8 : 1;
/// Of a mesh's triangles, pairs that run through each other around its forks. Stalks of palms, close
/// together, still do so; no tree of any seed may be worse than the worst is now.
constexpr double mostCrossings = 0.013;
constexpr double mergeDistance = 1e-4; ///< m: Blender's
constexpr double leastEdge = 0.12e-3;  ///< m

/// As programs do that merge vertices by distance: what is near becomes one, triangles without an area go.
TriangleMesh merged(const TriangleMesh& mesh, double distance)
{
    std::vector<Index> into(mesh.positions.size());
    std::iota(into.begin(), into.end(), Index(0));
    for (const NearPair& pair : findNearPositions(mesh.positions, distance)) // by ascending vertex
        into[pair.vertex] = std::min(into[pair.vertex], into[pair.earlier]);
    TriangleMesh out;
    std::vector<Index> place(mesh.positions.size(), noIndex);
    const auto kept = [&](Index vertex) {
        Index& at = place[into[vertex]];
        if (at == noIndex) {
            at = out.vertexCount();
            out.positions.push_back(mesh.positions[into[vertex]]);
        }
        return at;
    };
    for (const glm::uvec3& t : mesh.triangles)
        if (into[t.x] != into[t.y] && into[t.y] != into[t.z] && into[t.z] != into[t.x])
            out.triangles.emplace_back(kept(t.x), kept(t.y), kept(t.z));
    return out;
}

double shortestEdge(const TriangleMesh& mesh)
{
    double shortest = std::numeric_limits<double>::max();
    for (const glm::uvec3& t : mesh.triangles)
        for (const auto& [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
            shortest = std::min(shortest,
                                glm::length(glm::dvec3(mesh.positions[a]) - glm::dvec3(mesh.positions[b])));
    return shortest;
}

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
            QVERIFY(shortestEdge(tree->branches->mesh) >= leastEdge);
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
    /// All presets but those of the coursework, whose sections are what it says, each with a seed of its own.
    void mergingLeavesThemClosed_data()
    {
        QTest::addColumn<int>("number");
        const auto all = presets();
        for (int i = 0; i < int(all.size()); i += everyNth)
            if (all[std::size_t(i)].params.mesh.leastRadius > 0.0)
                QTest::newRow(all[std::size_t(i)].name) << i;
    }
    void mergingLeavesThemClosed()
    {
        QFETCH(int, number);
        const Preset& preset = presets()[std::size_t(number)];
        const auto tree = TreePipeline().evaluate(reseeded(preset.params, 3 + number % 7), Stage::Mesh);
        QVERIFY2(tree, test::why(tree));
        const TriangleMesh& mesh = tree->branches->mesh;
        QVERIFY(shortestEdge(mesh) >= leastEdge);
        const TriangleMesh left = merged(mesh, mergeDistance);
        const auto report = validateMesh(left);
        QVERIFY2(report, test::why(report));
        QVERIFY(report->valid);
        QCOMPARE(report->components, tree->branches->roots);
        QCOMPARE(report->eulerCharacteristic, 2 * std::int64_t(report->components));
        QCOMPARE(left.triangles.size(), mesh.triangles.size()); // nothing was near
    }
};

RAMURE_SUITE(TestSpeciesMeshes)

} // namespace tst_species_meshes

#include "tst_species_meshes.moc"
