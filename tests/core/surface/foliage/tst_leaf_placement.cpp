#include "core/surface/foliage/leaf_placement.h"

#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"

#include <cmath>
#include <numbers>

namespace tst_leaf_placement {

using namespace ramure;

namespace {

constexpr double alpha = 0.2, pi = std::numbers::pi;

LeafParams birch()
{
    LeafParams params;
    params.shape = LeafShape::Birch;
    return params;
}

/// One straight twig.
Skeleton twig(const glm::dvec3& to, double radius = 0.01)
{
    Skeleton skeleton;
    skeleton.add(noIndex, {0, 0, 0}, to, radius, radius);
    return skeleton;
}

std::vector<FoliageItem> leavesOn(const Skeleton& skeleton, const LeafParams& params, double applesToo = 0.0)
{
    const auto foliage = placeFoliage(skeleton, {0.1, 10, applesToo, 1}, params, {}, alpha);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return foliage->leaves;
}

/// The angle about +Y where a foot is, 0 along +Z.
double around(const FoliageItem& leaf)
{
    return std::atan2(leaf.position.x, leaf.position.z);
}

double between(double a, double b)
{
    return std::abs(std::remainder(a - b, 2.0 * pi));
}

/// How far the foot of a leaf is from the surface of its branch, as a share of the radius there.
double offTheBark(const Skeleton& skeleton, const FoliageItem& leaf)
{
    const BranchCurve curve = branchCurve(skeleton, leaf.branch);
    const auto away = [&](double t) {
        return glm::length(hermite(curve.h0, curve.h1, curve.v0, curve.v1, t).point - leaf.position);
    };
    constexpr int steps = 4000;
    int nearest = 0;
    for (int i = 1; i <= steps; ++i)
        if (away(double(i) / steps) < away(double(nearest) / steps))
            nearest = i;
    // The thinnest twigs are thinner than a step is long.
    double low = std::max(nearest - 1.0, 0.0) / steps, high = std::min(nearest + 1.0, double(steps)) / steps;
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3.0;
        if (away(low + third) < away(high - third))
            high -= third;
        else
            low += third;
    }
    const double radius = (1.0 - low) * skeleton.a0[leaf.branch] + low * skeleton.a1[leaf.branch];
    return std::abs(away(low) - radius) / radius;
}

} // namespace

class TestLeafPlacement : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void noLeavesAreNone()
    {
        LeafParams oak;
        oak.shape = LeafShape::Oak;
        QVERIFY(!leavesOn(twig({0, 1, 0}), oak).empty());
        const auto bare = placeFoliage(twig({0, 1, 0}), {0.1, 0, 0.0, 1}, oak, {}, alpha);
        QVERIFY(bare && bare->leaves.empty());
    }

    void tooManyIsAnError()
    {
        LeafParams params = birch();
        params.internode = 0.01;
        // A million on one twig is too many triangles; so are as many on a thousand.
        Skeleton many;
        for (int i = 0; i < 1000; ++i)
            many.add(noIndex, {i, 0, 0}, {i, 2, 0}, 0.001, 0.001);
        for (const Skeleton& skeleton : {twig({0, 3000, 0}), many}) {
            const auto foliage = placeFoliage(skeleton, {0.1, 10, 0.0, 1}, params, {}, alpha);
            QVERIFY(!foliage);
            QCOMPARE(foliage.error().code, ErrorCode::Limit);
            QCOMPARE(foliage.error().path, std::string("foliage.internode"));
        }
    }

    void cancelStops()
    {
        std::stop_source source;
        source.request_stop();
        const auto foliage =
            placeFoliage(twig({0, 3, 0}), {0.1, 10, 0.0, 1}, birch(), {}, alpha, {source.get_token(), {}});
        QVERIFY(!foliage);
        QCOMPARE(foliage.error().code, ErrorCode::Cancelled);
    }

    void nothingOnBareTrees()
    {
        LeafParams params = birch();
        QVERIFY(leavesOn(Skeleton(), params).empty());
        QVERIFY(leavesOn(twig({0, 3, 0}, 0.5), params).empty()); // thicker than twigs are
        params.size = 0.0;
        QVERIFY(leavesOn(twig({0, 3, 0}), params).empty());
        params.size = 1.0;
        params.width = 0.0;
        QVERIFY(leavesOn(twig({0, 3, 0}), params).empty());
    }

    void twigsWithoutLengthHaveOneLeaf()
    {
        for (const LeafShape shape : {LeafShape::Birch, LeafShape::Maple, LeafShape::Fir}) {
            LeafParams params = birch();
            params.shape = shape;
            const auto leaves = leavesOn(twig({0, 0, 0}), params);
            QCOMPARE(leaves.size(), std::size_t(1));
            QVERIFY(std::isfinite(glm::length(leaves[0].position)));
            QVERIFY(std::abs(glm::length(leaves[0].orientation) - 1.0) < 1e-9);
        }
    }

    void feetStandOnTheBark_data()
    {
        QTest::addColumn<QString>("name");
        for (const Preset& preset : courseworkPresets())
            QTest::newRow(preset.name) << preset.name;
    }
    void feetStandOnTheBark()
    {
        QFETCH(QString, name);
        const NodeParams params = *presetParams(name.toStdString());
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(params, Stage::Simplified);
        QVERIFY(tree);
        const Skeleton& skeleton = tree->simplified->skeleton;
        const auto foliage = placeFoliage(skeleton, params.foliage, birch(), {}, params.turtle.alpha);
        QVERIFY(foliage && foliage->leaves.size() > 100);
        double worst = 0.0;
        const std::size_t step = foliage->leaves.size() / 400 + 1;
        for (std::size_t i = 0; i < foliage->leaves.size(); i += step)
            worst = std::max(worst, offTheBark(skeleton, foliage->leaves[i]));
        QVERIFY2(worst <= 0.02, qPrintable(QString::number(worst)));
    }

    void internodesAreKept()
    {
        const double internode = alpha * leafRow(LeafShape::Birch).internode;
        auto leaves = leavesOn(twig({0, 3, 0}), birch());
        QVERIFY(leaves.size() > 80);
        QVERIFY(std::abs(leaves.back().position.y - 3.0) < 1e-9); // the one at the tip
        leaves.pop_back();
        for (std::size_t i = 1; i < leaves.size(); ++i) {
            const double way = leaves[i].position.y - leaves[i - 1].position.y;
            QVERIFY(way > 0.6 * internode && way < 1.4 * internode);
        }
    }

    void arrangements_data()
    {
        QTest::addColumn<int>("arrangement");
        QTest::addColumn<int>("perNode");
        QTest::addColumn<double>("turn");
        QTest::newRow("alternate") << int(LeafArrangement::Alternate) << 1 << 0.8 * pi;
        QTest::newRow("distichous") << int(LeafArrangement::Distichous) << 1 << pi;
        QTest::newRow("spiral") << int(LeafArrangement::Spiral) << 1 << 137.508 / 180.0 * pi;
        QTest::newRow("opposite") << int(LeafArrangement::Opposite) << 2 << 0.0;
        QTest::newRow("decussate") << int(LeafArrangement::Decussate) << 2 << 0.5 * pi;
        QTest::newRow("whorled") << int(LeafArrangement::Whorled) << 5 << 0.2 * pi;
    }
    void arrangements()
    {
        QFETCH(int, arrangement);
        QFETCH(int, perNode);
        QFETCH(double, turn);
        LeafParams params = birch();
        params.arrangement = static_cast<LeafArrangement>(arrangement);
        params.whorl = 5;
        auto leaves = leavesOn(twig({0, 2, 0}), params);
        leaves.pop_back();
        const auto each = static_cast<std::size_t>(perNode);
        QCOMPARE(leaves.size() % each, std::size_t(0));
        for (std::size_t i = 0; i + each < leaves.size(); ++i) {
            QVERIFY(between(std::abs(std::remainder(around(leaves[i + each]) - around(leaves[i]), 2.0 * pi)),
                            turn) < 0.41);
            if (i % each + 1 < each)
                QVERIFY(between(between(around(leaves[i + 1]), around(leaves[i])), 2.0 * pi / perNode) <
                        0.41);
        }
    }

    /// Two rows lie left and right of a level twig.
    void rowsLieLevel()
    {
        LeafParams params = birch();
        params.arrangement = LeafArrangement::Distichous;
        for (const FoliageItem& leaf : leavesOn(twig({2, 0, 0}), params))
            QVERIFY(leaf.position.x > 1.99 || std::abs(leaf.position.y) < 0.25 * 0.01);
    }

    void lightTurnsTheUpperSide()
    {
        const auto meanUp = [](double light) {
            LeafParams params = birch();
            params.light = light;
            params.droop = 0.0;
            double sum = 0.0, count = 0.0;
            for (const FoliageItem& leaf : leavesOn(twig({2, 0.2, 0}), params)) {
                sum += (leaf.orientation * glm::dvec3(0, 0, 1)).y;
                ++count;
            }
            return sum / count;
        };
        QVERIFY(meanUp(1.0) > 0.6);
        QVERIFY(meanUp(1.0) > meanUp(0.0) + 0.3);
    }

    void droopPullsDown()
    {
        LeafParams params = birch();
        params.droop = 1.0;
        const Skeleton level = twig({2, 0, 0});
        for (const FoliageItem& leaf : leavesOn(level, params)) {
            const glm::dvec3 way = leaf.orientation * glm::dvec3(0, 1, 0);
            const glm::dvec3 out = glm::dvec3(0, leaf.position.y, leaf.position.z) / 0.01;
            QVERIFY(glm::dot(way, out) > 0.1); // never into the bark
            if (out.y < 0.1)
                QVERIFY(way.y < -0.8);
        }
    }

    void otherTwigsChangeNothing()
    {
        Skeleton one = twig({0, 2, 0});
        one.add(noIndex, {3, 0, 0}, {3, 2, 0}, 0.01, 0.01);
        Skeleton other = one;
        other.key[1] = 12345;
        const auto before = leavesOn(one, birch()), after = leavesOn(other, birch(), 0.7);
        QCOMPARE(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(before[i].orientation == after[i].orientation, before[i].branch == 0);
    }

    void meshesAreThePlants()
    {
        const Skeleton skeleton = twig({0, 2, 0});
        const auto foliage = placeFoliage(skeleton, {0.1, 10, 0.0, 1}, birch(), {}, alpha);
        QVERIFY(foliage);
        const TriangleMesh one = leafMesh(foliage->form);
        const TriangleMesh leaves = buildLeaves(skeleton, *foliage, alpha, FoliageModel::Fine);
        QCOMPARE(leaves.vertexCount(), Index(one.positions.size() * foliage->leaves.size()));
        QCOMPARE(leaves.colours.size(), leaves.triangles.size());
        const double scale = alpha * leafRow(LeafShape::Birch).length;
        for (std::size_t i = 0; i < foliage->leaves.size(); ++i) {
            const FoliageItem& item = foliage->leaves[i];
            QVERIFY(item.size > 0.4F && item.size < 1.3F && item.tone > 0.6F && item.tone <= 1.0F);
            // The foot of the petiole surrounds the item's place.
            const glm::dvec3 foot(leaves.positions[i * one.positions.size()]);
            QVERIFY(glm::length(foot - item.position) < 0.05 * scale * double(item.size));
        }
        QCOMPARE(buildLeaves(skeleton, *foliage, alpha, FoliageModel::Rough).faceCount(),
                 Index(2 * foliage->leaves.size()));
    }
};

RAMURE_SUITE(TestLeafPlacement)

} // namespace tst_leaf_placement

#include "tst_leaf_placement.moc"
