#include "core/surface/check/self_intersections.h"
#include "core/surface/mesh/bark_relief.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tst_bark_relief {

using namespace ramure;

namespace {

constexpr double trunkRadius = 0.3; // m

/// A trunk of three pieces with two limbs.
Skeleton stem()
{
    Skeleton out;
    const Index low = out.add(noIndex, {0, 0, 0}, {0, 2, 0}, trunkRadius, 0.28);
    const Index high = out.add(low, {0, 2, 0}, {0.1, 4, 0}, 0.28, 0.25);
    out.add(high, {0.1, 4, 0}, {0.1, 6, 0.2}, 0.2, 0.15);
    out.add(high, {0.1, 4, 0}, {1.5, 5, 0}, 0.12, 0.08, 1);
    return out;
}

struct Marked
{
    BranchMesh mesh;
    std::vector<Index> first;
};

BranchMesh bare(const Skeleton& skeleton = stem())
{
    BranchMeshOptions options;
    options.radialDivisions = 12;
    options.lengthDivisions = 8;
    options.withNormals = false;
    return buildBranchMesh(skeleton, options).value_or(BranchMesh());
}

Relief relief(Relief::Form form, float height, float turn, float radius, float healed = 0.0F)
{
    return {form, 0, {0.0F, height, 0.0F}, {std::cos(turn), 0.0F, std::sin(turn)}, radius, healed};
}

Marked drawn(const std::vector<Relief>& reliefs)
{
    Marked out{bare(), {}};
    out.mesh.mesh.level.clear();
    std::vector<ReliefHold> held(out.mesh.mesh.positions.size(), ReliefHold::None);
    for (const ForkVertex& fork : out.mesh.forkVertices)
        held[fork.vertex] = ReliefHold::Place;
    out.first = drawReliefs(out.mesh.mesh, reliefs, held);
    return out;
}

/// How far the surface stands out of the trunk at a height, at most and at least, near a direction.
std::pair<double, double> outline(const TriangleMesh& mesh, double height, double turn)
{
    double most = 0.0, least = std::numeric_limits<double>::max();
    for (const glm::vec3& p : mesh.positions) {
        const double aside = double(p.x) * std::cos(turn) + double(p.z) * std::sin(turn);
        const double across = -double(p.x) * std::sin(turn) + double(p.z) * std::cos(turn);
        if (std::abs(double(p.y) - height) > 0.2 || std::abs(across) > 0.2 || aside <= 0.0)
            continue;
        most = std::max(most, aside);
        least = std::min(least, std::hypot(aside, across));
    }
    return {most, least};
}

constexpr std::array forms{Relief::Form::Scar, Relief::Form::Hollow, Relief::Form::Burr};

} // namespace

class TestBarkRelief : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsWrongIsLeftOut()
    {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        TriangleMesh nothing;
        QVERIFY(drawReliefs(nothing, std::array{relief(forms[0], 1, 0, 0.1F)}, {}).empty());
        const BranchMesh before = bare();
        std::vector<Relief> wrong;
        for (const float radius : {0.0F, -0.1F, nan, 1e30F, std::numeric_limits<float>::infinity()})
            wrong.push_back(relief(Relief::Form::Scar, 1.0F, 0.0F, radius));
        wrong.push_back(relief(Relief::Form::Scar, nan, 0.0F, 0.1F));
        wrong.push_back(relief(Relief::Form::Scar, 1.0F, 0.0F, 0.1F, nan));
        wrong.push_back(relief(Relief::Form::Scar, 50.0F, 0.0F, 0.1F)); // beside the tree
        wrong.push_back({Relief::Form::Burr, 0, {0, 1, 0}, {0, 0, 0}, 0.1F, 0.0F});
        wrong.push_back({Relief::Form::Burr, 0, {0, 1, 0}, {3, 0, 0}, 0.1F, 0.0F});
        wrong.push_back({Relief::Form::Burr, 77, {0, 1, 0}, {1, 0, 0}, 0.1F, 0.0F});
        wrong.push_back({Relief::Form::Burr, noIndex, {0, 1, 0}, {1, 0, 0}, 0.1F, 0.0F});
        wrong.push_back(relief(Relief::Form::Burr, 1.0F, 0.0F, 0.29F)); // wider than the wood allows
        const Marked marked = drawn(wrong);
        QVERIFY(marked.first.empty());
        QVERIFY(marked.mesh.mesh.positions == before.mesh.positions);
        QVERIFY(marked.mesh.mesh.triangles == before.mesh.triangles);
    }

    void surfacesStayClosedAndWhole_data()
    {
        QTest::addColumn<int>("form");
        QTest::newRow("scar") << 0;
        QTest::newRow("hollow") << 1;
        QTest::newRow("burr") << 2;
    }
    void surfacesStayClosedAndWhole()
    {
        QFETCH(const int, form);
        std::vector<Relief> reliefs;
        for (int k = 0; k < 24; ++k)
            reliefs.push_back(relief(forms[std::size_t(form)], 0.25F + 0.14F * float(k % 12), 2.1F * float(k),
                                     0.02F + 0.006F * float(k % 20), 0.25F * float(k % 13)));
        const TriangleMesh before = bare().mesh;
        const Marked marked = drawn(reliefs);
        QVERIFY(marked.first.size() == before.triangles.size() + 1);
        QVERIFY(marked.mesh.mesh.triangles.size() > 2 * before.triangles.size());
        auto report = validateMesh(marked.mesh.mesh);
        QVERIFY(report);
        QVERIFY(confirmWithOpenMesh(marked.mesh.mesh, *report));
        QVERIFY2(report->valid && report->openMeshAgrees && report->components == 1, "broken");
        const auto crossings = findSelfIntersections(marked.mesh.mesh, {});
        QVERIFY(crossings && crossings->total() == 0);
        // The same again, and the triangles stay in the order of their tubes.
        const Marked again = drawn(reliefs);
        QVERIFY(again.mesh.mesh == marked.mesh.mesh);
        QVERIFY(std::ranges::is_sorted(marked.first));
        QCOMPARE(marked.first.back(), Index(marked.mesh.mesh.triangles.size()));
    }

    /// A hollow goes in, a burr comes out, and a scar does both until it has healed.
    void formsAreSeen()
    {
        constexpr float turn = 0.3F, radius = 0.1F;
        const auto shape = [&](Relief::Form form, float healed) {
            const Marked marked = drawn({relief(form, 1.0F, turn, radius, healed)});
            return outline(marked.mesh.mesh, 1.0, double(turn));
        };
        const auto [most, least] = shape(Relief::Form::Scar, 3.0F); // nothing is left of it
        const auto hollow = shape(Relief::Form::Hollow, 0.0F), burr = shape(Relief::Form::Burr, 0.0F);
        QVERIFY(hollow.second < least - 0.1 && hollow.second > 0.0);
        QVERIFY(burr.first > most + 0.03 && burr.second > 0.9 * least);
        const auto scar = [](float healed) {
            return drawn({relief(Relief::Form::Scar, 1.0F, turn, radius, healed)}).mesh.mesh.positions;
        };
        const std::vector<glm::vec3> gone = scar(3.0F);
        float before = radius;
        for (const float healed : {0.0F, 0.5F, 1.0F, 2.0F, 2.9F}) {
            const std::vector<glm::vec3> now = scar(healed);
            QCOMPARE(now.size(), gone.size());
            float farthest = 0.0F;
            for (std::size_t v = 0; v < now.size(); ++v)
                farthest = std::max(farthest, glm::distance(now[v], gone[v]));
            QVERIFY(farthest > 0.0F && farthest < before);
            before = farthest;
        }
        QVERIFY(before < 0.03F * radius);
    }

    /// Where a limb leaves the trunk there is no scar; nor are there two in one place.
    void whereThereIsNoRoomThereIsNone()
    {
        Relief atFork{Relief::Form::Scar, 1, {0.1F, 3.95F, 0.0F}, {1, 0, 0}, 0.08F, 0.0F};
        QVERIFY(drawn({atFork}).first.empty());
        const Relief one = relief(Relief::Form::Scar, 1.0F, 0.0F, 0.08F);
        QVERIFY(drawn({one, one}).mesh.mesh == drawn({one}).mesh.mesh);
    }
};

RAMURE_SUITE(TestBarkRelief)

} // namespace tst_bark_relief

#include "tst_bark_relief.moc"
