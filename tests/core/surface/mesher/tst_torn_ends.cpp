#include "core/surface/check/self_intersections.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "core/surface/texture/cut_wood.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <limits>

namespace tst_torn_ends {

using namespace ramure;

namespace {

/// A trunk with one limb, which is dead and broken.
Skeleton broken(double radius = 0.08)
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.2, 0.2);
    out.add(trunk, {0, 2, 0}, {0.1, 4, 0}, 0.18, 0.1);
    out.add(trunk, {0, 2, 0}, {1, 2.6, 0}, radius, 0.8 * radius, 1);
    for (Index i = 0; i < out.size(); ++i)
        out.key[i] = 1000 + i;
    out.sawn = out.bare = {2};
    return out;
}

BranchMesh meshOf(const Skeleton& skeleton, double splinters = 1.0, std::int64_t sides = 12)
{
    BranchMeshOptions options;
    options.radialDivisions = sides;
    options.lengthDivisions = 5;
    options.splinters = splinters;
    return buildBranchMesh(skeleton, options).value_or(BranchMesh());
}

/// m, how far it reaches beyond the end of the limb.
double reach(const TriangleMesh& mesh, const Skeleton& skeleton)
{
    const glm::dvec3 way = glm::normalize(skeleton.p1[2] - skeleton.p0[2]);
    double most = -1.0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.branch[v] == 2)
            most = std::max(most, glm::dot(glm::dvec3(mesh.positions[v]) - skeleton.p1[2], way));
    return most;
}

} // namespace

/// The ends of dead wood that broke.
class TestTornEnds : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongNumbersAreErrors()
    {
        for (const double wrong : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
            BranchMeshOptions options;
            options.splinters = wrong;
            QVERIFY(!buildBranchMesh(broken(), options));
        }
    }

    /// Living wood that was cut is flat, and so is what is asked to be, or too thin for splinters.
    void onlyDeadWoodHasSplinters()
    {
        Skeleton sawn = broken();
        sawn.bare.clear();
        QVERIFY(meshOf(sawn).mesh == meshOf(sawn, 0.0).mesh);
        QVERIFY(meshOf(broken(), 0.0).mesh == meshOf(sawn, 0.0).mesh);
        QVERIFY(meshOf(broken(0.003)).mesh == meshOf(broken(0.003), 0.0).mesh);
        QVERIFY(reach(meshOf(sawn).mesh, sawn) < 0.05 * 0.064);
        Skeleton whole = broken();
        whole.sawn.clear(); // dead, and not broken
        QVERIFY(meshOf(whole).mesh == meshOf(whole, 0.0).mesh);
    }

    void splintersAreClosed()
    {
        for (const double radius : {0.006, 0.03, 0.08})
            for (const double splinters : {0.05, 1.0, 4.0})
                for (const std::int64_t sides : {3, 4, 7, 12, 32}) {
                    Skeleton tree = broken(radius);
                    for (std::uint64_t key = 1; key <= 3; ++key) {
                        tree.key[2] = key * 77;
                        const BranchMesh mesh = meshOf(tree, splinters, sides);
                        auto report = validateMesh(mesh.mesh);
                        QVERIFY(report);
                        QVERIFY(confirmWithOpenMesh(mesh.mesh, *report));
                        QVERIFY(report->valid && report->openMeshAgrees && report->components == 1);
                        const auto crossings = findSelfIntersections(mesh.mesh, {});
                        QVERIFY(crossings && crossings->total() == 0);
                        QVERIFY(meshOf(tree, splinters, sides).mesh == mesh.mesh);
                        const double longest = 2.0 * 0.8 * radius * splinters;
                        QVERIFY(reach(mesh.mesh, tree) > 0.2 * longest);
                        QVERIFY(reach(mesh.mesh, tree) < 1.2 * longest + 0.5 * radius);
                    }
                }
    }

    /// The wood that broke is seen: it lies close above all of the splinters, seen from outside.
    void woodLiesOnTheSplinters()
    {
        const Skeleton tree = broken();
        const BranchMesh mesh = meshOf(tree);
        const TriangleMesh wood = cutWood(mesh, tree);
        QCOMPARE(wood.faceCount(), Index(3 * 2 * 12));
        QCOMPARE(wood.colours.size(), wood.triangles.size());
        for (std::size_t v = 0; v < wood.positions.size(); ++v) {
            QCOMPARE(wood.branch[v], Index(2));
            float nearest = std::numeric_limits<float>::max();
            for (const glm::vec3& p : mesh.mesh.positions)
                nearest = std::min(nearest, glm::distance(p, wood.positions[v]));
            QVERIFY(nearest > 0.0F && nearest < 0.02F * 0.08F);
        }
        Skeleton other = tree; // another break for another limb
        other.key[2] = 5;
        QVERIFY(cutWood(meshOf(other), other).positions != wood.positions);
    }
};

RAMURE_SUITE(TestTornEnds)

} // namespace tst_torn_ends

#include "tst_torn_ends.moc"
