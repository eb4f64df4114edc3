#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/mesher/fork_spread.h"

#include "tests/support/fork_judge.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_fork_parting {

using namespace ramure;
using namespace ramure::test;

namespace {

/// A trunk of 20 cm that forks into two, and a twig that leaves the fork between them, to the side.
Skeleton twinsWithTwig(double twig = 0.03)
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 0, 0}, {0, 2, 0}, 0.2, 0.2);
    out.add(trunk, {0, 2, 0}, {1.2, 4.5, 0}, 0.14, 0.1);
    out.add(trunk, {0, 2, 0}, {-1.2, 4.5, 0}, 0.14, 0.1);
    out.add(trunk, {0, 2, 0}, {0.1, 2.6, 1.2}, twig, 0.5 * twig);
    return out;
}

BranchMeshOptions usual()
{
    BranchMeshOptions options;
    options.radialDivisions = 12;
    options.lengthDivisions = 6;
    options.collar = 0.5;
    return options;
}

NormalSkeleton normalised(const Skeleton& skeleton, const BranchMeshOptions& options = usual())
{
    return normaliseSkeleton(skeleton, options, {}).value_or(NormalSkeleton());
}

std::ptrdiff_t pieces(const NormalSkeleton& skeleton)
{
    return std::ranges::count_if(skeleton.branches, &MeshBranch::isPiece);
}

/// Forks that nobody would grow.
std::vector<std::pair<const char*, Skeleton>> badForks()
{
    std::vector<std::pair<const char*, Skeleton>> out;
    const auto trunk = [&](const char* name, double radius = 0.2) -> Skeleton& {
        out.emplace_back(name, Skeleton());
        out.back().second.add(noIndex, {0, 0, 0}, {0, 2, 0}, radius, radius);
        return out.back().second;
    };
    Skeleton& many = trunk("thirty limbs at a fork");
    many.add(0, {0, 2, 0}, {0, 4, 0}, 0.19, 0.15);
    for (int i = 0; i < 30; ++i)
        many.add(0, {0, 2, 0}, {1.1 * std::cos(0.7 * i), 2.0 + 0.03 * i, 1.1 * std::sin(0.7 * i)}, 0.04,
                 0.01);
    Skeleton& thick = trunk("a limb thicker than it is long");
    thick.add(0, {0, 2, 0}, {0, 4, 0}, 0.2, 0.15);
    thick.add(0, {0, 2, 0}, {0.12, 2.05, 0}, 0.18, 0.18);
    Skeleton& same = trunk("three limbs at one place");
    same.add(0, {0, 2, 0}, {0, 4, 0}, 0.2, 0.15);
    for (int i = 0; i < 3; ++i)
        same.add(0, {0, 2, 0}, {1.0, 2.5 + 0.01 * i, 0.02 * i}, 0.06, 0.02);
    out.emplace_back("a fork at the ground", Skeleton());
    Skeleton& low = out.back().second;
    low.add(noIndex, {0, 0, 0}, {0, 0.05, 0}, 0.2, 0.2);
    low.add(0, {0, 0.05, 0}, {0.8, 3, 0}, 0.14, 0.1);
    low.add(0, {0, 0.05, 0}, {-0.8, 3, 0}, 0.14, 0.1);
    low.add(0, {0, 0.05, 0}, {0, 0.6, 1}, 0.03, 0.01);
    Skeleton& thin = trunk("0.1 mm beside 1 m", 1.0);
    thin.add(0, {0, 2, 0}, {1.5, 7, 0}, 0.8, 0.5);
    thin.add(0, {0, 2, 0}, {-1.5, 7, 0}, 0.8, 0.5);
    thin.add(0, {0, 2, 0}, {0, 2.4, 2}, 1e-4, 1e-4);
    Skeleton cut = twinsWithTwig();
    cut.sawn = {2, 3};
    out.emplace_back("a cut beside a fork", cut);
    return out;
}

} // namespace

class TestForkParting : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }

    void aTwigLeavesBelowTheFork()
    {
        const NormalSkeleton parted = normalised(twinsWithTwig());
        QCOMPARE(pieces(parted), 1);
        const auto twig = std::ranges::find(parted.branches, 3U, &MeshBranch::source);
        QVERIFY(twig->isLimb);
        const MeshBranch& trunk = parted.branches[twig->parent];
        QVERIFY(!trunk.isPiece && trunk.source == 0 && trunk.p1.y < 2.0 && trunk.p1.y > 1.5);
        const MeshBranch& piece = parted.branches[parted.childrenOf(twig->parent).back()];
        QVERIFY(piece.isPiece && piece.source == 0 && piece.p1.y == 2.0 && piece.childCount == 2);
        for (Index i = 0; i < parted.branches.size(); ++i)
            QVERIFY(parted.branches[i].parent == noIndex || parted.branches[i].parent < i);
    }
    void allStaysWithoutAForkLength()
    {
        BranchMeshOptions options = usual();
        options.forkLength = 0.0;
        QCOMPARE(pieces(normalised(twinsWithTwig(), options)), 0);
    }
    void whatIsThickStays() { QCOMPARE(pieces(normalised(twinsWithTwig(0.1))), 0); }
    /// The twig's tube begins with its own width: no part of the trunk's end is its.
    void noFunnelIsLeft()
    {
        const Skeleton skeleton = twinsWithTwig();
        QCOMPARE(branchMeshFaults(skeleton, usual()), std::string());
        const auto mesh = buildBranchMesh(skeleton, usual());
        QVERIFY(mesh);
        const auto tube = std::ranges::find(mesh->tubes, 3U, &TubeRange::branch);
        const BranchCurve& curve = mesh->axes[std::size_t(tube - mesh->tubes.begin())].curve;
        const glm::dvec3 axis = glm::normalize(curve.h1 - curve.h0);
        double widest = 0.0;
        for (std::size_t v = 0; v < mesh->mesh.positions.size(); ++v)
            if (mesh->mesh.branch[v] == 3) {
                const glm::dvec3 away = glm::dvec3(mesh->mesh.positions[v]) - curve.h0;
                widest = std::max(widest, glm::length(away - glm::dot(away, axis) * axis));
            }
        QVERIFY2(widest < 0.06, qPrintable(QString::number(widest)));
    }

    void badForksAreClosed_data()
    {
        QTest::addColumn<int>("which");
        int which = 0;
        for (const auto& [name, skeleton] : badForks())
            QTest::newRow(name) << which++;
    }
    void badForksAreClosed()
    {
        QFETCH(int, which);
        const Skeleton skeleton = badForks()[std::size_t(which)].second;
        for (const int sides : {3, 5, 8, 16})
            for (const double collar : {0.0, 0.5, 2.0})
                for (const int roots : {0, 5}) {
                    BranchMeshOptions options = usual();
                    options.radialDivisions = sides;
                    options.collar = collar;
                    options.roots = roots;
                    QCOMPARE(branchMeshFaults(skeleton, options), std::string());
                }
        BranchMeshOptions budget = usual();
        budget.targetTriangles = 4000;
        QCOMPARE(branchMeshFaults(skeleton, budget), std::string());
    }

    /// A hundred grammars drawn at random, as species are meshed.
    void grammarsAreClosed()
    {
        for (std::uint64_t seed = 0; seed < std::uint64_t(runs(100)); ++seed) {
            const Skeleton skeleton = zooSkeleton(ZooFamily::Grammar, seed);
            BranchMeshOptions options = usual();
            options.radialDivisions = 8;
            options.lengthDivisions = 4;
            options.clampOvershoot = true;
            options.roots = 5;
            const std::string faults = branchMeshFaults(skeleton, options);
            QVERIFY2(faults.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(faults.c_str())));
        }
    }
};

RAMURE_SUITE(TestForkParting)

} // namespace tst_fork_parting

#include "tst_fork_parting.moc"
