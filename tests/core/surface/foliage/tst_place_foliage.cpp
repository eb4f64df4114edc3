#include "core/lod/level_leaves.h"
#include "core/math/random.h"
#include "core/surface/foliage/foliage_shapes.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/suite.h"

#include <cmath>
#include <numbers>

namespace tst_place_foliage {

using namespace ramure;

namespace {

constexpr double alpha = 0.2;

/// Branches of many lengths; the later ones are thin. Every third hangs on the root.
Skeleton randomTree(std::uint64_t seed, Index count = 300)
{
    Random random(seed, RandomStream::Test);
    Skeleton skeleton;
    for (Index i = 0; i < count; ++i) {
        const Index parent = i == 0 ? noIndex : (i % 3 == 0 ? 0 : i - 1);
        const glm::dvec3 from = parent == noIndex ? glm::dvec3(0.0) : skeleton.p1[parent];
        const glm::dvec3 step{random.range(-1, 1), random.range(-1, 1), random.range(-1, 1)};
        const double radius = i < count / 2 ? 0.1 : 0.01;
        skeleton.add(parent, from, from + random.range(0, 2) * step, radius, radius, i % 4);
    }
    return skeleton;
}

/// Place along and away from the branch's axis.
struct Place
{
    double along, across;
};
Place placeOf(const Skeleton& skeleton, const FoliageItem& item)
{
    const Index b = item.branch;
    const glm::dvec3 axis = glm::normalize(skeleton.p1[b] - skeleton.p0[b]);
    const glm::dvec3 away = item.position - skeleton.p0[b];
    const double along = glm::dot(away, axis);
    return {along, glm::length(away - along * axis)};
}

Foliage placed(const Skeleton& skeleton, const FoliageParams& params)
{
    const auto foliage = placeFoliage(skeleton, params, alpha);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return *foliage;
}

/// Inside a closed surface, whether or not its faces share vertices.
double volumeOf(const TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

bool same(const FoliageItem& a, const FoliageItem& b)
{
    return a.branch == b.branch && a.position == b.position && a.orientation == b.orientation;
}

bool same(const std::vector<FoliageItem>& a, const std::vector<FoliageItem>& b)
{
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return same(x, y); });
}

} // namespace

class TestPlaceFoliage : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void tooManyIsAnError();
    void cancelStops();
    void nothingOnBareTrees();
    void onlyThinBranchesCarry();
    void leavesStandAroundTheirBranch();
    void wholeReachIsUsed();
    void applesFollowTheProbability();
    void orientationsAreUniform();
    void seedAloneRerolls();
    void changesElsewhereMoveNothing();
    void branchWithoutLength();
    void shapes();
    void roughModel();
    void fineModel();
};

void TestPlaceFoliage::tooManyIsAnError()
{
    Skeleton skeleton;
    for (Index i = 0; i < 150'000; ++i)
        skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.001, 0.001);
    const auto leaves = placeFoliage(skeleton, {0.1, 1000, 0.0, 1}, alpha);
    QVERIFY(!leaves);
    QCOMPARE(leaves.error().code, ErrorCode::Limit);
    QCOMPARE(leaves.error().path, std::string("foliage.leavesDensity"));
    const auto apples = placeFoliage(skeleton, {0.1, 0, 1.0, 1}, alpha);
    QVERIFY(!apples);
    QCOMPARE(apples.error().code, ErrorCode::Limit);
    QCOMPARE(apples.error().path, std::string("foliage.applesProbability"));
}

void TestPlaceFoliage::cancelStops()
{
    std::stop_source source;
    source.request_stop();
    const auto foliage = placeFoliage(randomTree(1), FoliageParams(), alpha, {source.get_token(), {}});
    QVERIFY(!foliage);
    QCOMPARE(foliage.error().code, ErrorCode::Cancelled);
    const Progress stopped{source.get_token(), {}};
    const Foliage whole = placed(randomTree(1), {1.0, 10, 1.0, 1});
    QVERIFY(!whole.leaves.empty() && !whole.apples.empty());
    QVERIFY(buildLeaves(randomTree(1), whole, alpha, FoliageModel::Fine, stopped).empty());
    QVERIFY(buildApples(randomTree(1), whole, alpha, FoliageModel::Fine, stopped).empty());
}

void TestPlaceFoliage::nothingOnBareTrees()
{
    for (const FoliageParams& params : {FoliageParams{0.0, 10, 1.0, 1}, FoliageParams{0.1, 0, 0.0, 1},
                                        FoliageParams{0.1, -3, 0.0, 1}, FoliageParams{-1.0, 10, 1.0, 1}}) {
        const Foliage foliage = placed(randomTree(1), params);
        QVERIFY(foliage.leaves.empty() && foliage.apples.empty());
        QVERIFY(buildLeaves(randomTree(1), foliage, alpha, FoliageModel::Fine).empty());
    }
    const Foliage none = placed(Skeleton(), FoliageParams());
    QVERIFY(none.leaves.empty() && none.apples.empty());
}

void TestPlaceFoliage::onlyThinBranchesCarry()
{
    const Skeleton tree = randomTree(2);
    const Foliage foliage = placed(tree, {0.1, 7, 1.0, 1});
    std::vector<Index> leaves(tree.size(), 0), apples(tree.size(), 0);
    for (const FoliageItem& leaf : foliage.leaves)
        ++leaves[leaf.branch];
    for (const FoliageItem& apple : foliage.apples)
        ++apples[apple.branch];
    for (Index i = 0; i < tree.size(); ++i) {
        const bool thin = tree.a0[i] < alpha * 0.1;
        QCOMPARE(leaves[i], thin ? Index(7) : Index(0));
        QCOMPARE(apples[i], thin ? Index(1) : Index(0));
    }
    // The test is "smaller", not "smaller or equal".
    QCOMPARE(placed(tree, {0.5, 7, 1.0, 1}).leaves.size(), foliage.leaves.size());
}

void TestPlaceFoliage::leavesStandAroundTheirBranch()
{
    const Skeleton tree = randomTree(3);
    const ChildLists children = childLists(tree);
    const Foliage foliage = placed(tree, {0.1, 20, 1.0, 5});
    for (const auto* items : {&foliage.leaves, &foliage.apples})
        for (const FoliageItem& item : *items) {
            const Place place = placeOf(tree, item);
            const double reach = tree.length(item.branch) + (children.count(item.branch) == 0 ? alpha : 0.0);
            QVERIFY(place.along > -1e-12 && place.along < reach + 1e-12);
            QVERIFY(place.across < alpha / 2 + 1e-12);
            QVERIFY(std::abs(glm::length(item.orientation) - 1.0) < 1e-12);
        }
}

void TestPlaceFoliage::wholeReachIsUsed()
{
    // One long thin branch: its own length counts, not alpha; the disc across is filled evenly.
    Skeleton skeleton;
    skeleton.add(noIndex, {0, 0, 0}, {3, 0, 0}, 0.001, 0.001);
    const Foliage foliage = placed(skeleton, {0.1, 20'000, 0.0, 1});
    double sum = 0.0, beyond = 0.0, inner = 0.0;
    for (const FoliageItem& leaf : foliage.leaves) {
        const Place place = placeOf(skeleton, leaf);
        sum += place.along;
        beyond += place.along > 3.0 ? 1 : 0;
        inner += place.across < alpha / 4 ? 1 : 0;
    }
    const auto count = static_cast<double>(foliage.leaves.size());
    QVERIFY(std::abs(sum / count - 1.6) < 0.035);
    QVERIFY(std::abs(beyond / count - 0.2 / 3.2) < 0.01);
    QVERIFY(std::abs(inner / count - 0.25) < 0.02);
}

void TestPlaceFoliage::applesFollowTheProbability()
{
    const Skeleton tree = randomTree(4, 20'000);
    const double share = double(placed(tree, {0.1, 0, 0.3, 1}).apples.size()) / 10'000;
    QVERIFY(std::abs(share - 0.3) < 0.025);
    // More apples keep those there were.
    const Foliage few = placed(tree, {0.1, 0, 0.1, 1}), many = placed(tree, {0.1, 0, 0.2, 1});
    for (const FoliageItem& apple : few.apples)
        QVERIFY(
            std::ranges::any_of(many.apples, [&](const FoliageItem& other) { return same(apple, other); }));
}

void TestPlaceFoliage::orientationsAreUniform()
{
    const Foliage foliage = placed(randomTree(5, 2'000), {0.1, 20, 0.0, 1});
    glm::dvec3 mean(0.0), squares(0.0);
    for (const FoliageItem& leaf : foliage.leaves) {
        const glm::dvec3 normal = leaf.orientation * glm::dvec3(0, 0, 1);
        mean += normal;
        squares += normal * normal;
    }
    const auto count = static_cast<double>(foliage.leaves.size());
    for (int i = 0; i < 3; ++i) {
        QVERIFY(std::abs(mean[i] / count) < 0.02);
        QVERIFY(std::abs(squares[i] / count - 1.0 / 3.0) < 0.02);
    }
}

void TestPlaceFoliage::seedAloneRerolls()
{
    const Skeleton tree = randomTree(6);
    const Foliage a = placed(tree, {0.1, 10, 0.5, 1});
    QVERIFY(same(a.leaves, placed(tree, {0.1, 10, 0.5, 1}).leaves));
    QVERIFY(!same(a.leaves, placed(tree, {0.1, 10, 0.5, 2}).leaves));
    // The apples never move with the leaves' number, nor the leaves with the apples' probability.
    QVERIFY(same(a.apples, placed(tree, {0.1, 3, 0.5, 1}).apples));
    QVERIFY(same(a.leaves, placed(tree, {0.1, 10, 0.9, 1}).leaves));
    // More leaves keep the first ones.
    const Foliage more = placed(tree, {0.1, 11, 0.5, 1});
    QVERIFY(same(a.leaves[0], more.leaves[0]) && same(a.leaves[9], more.leaves[9]));
    QVERIFY(same(a.leaves[10], more.leaves[11]));
}

void TestPlaceFoliage::changesElsewhereMoveNothing()
{
    const Skeleton tree = randomTree(7);
    Skeleton other = tree;
    other.key[200] = 12345;
    const Foliage a = placed(tree, FoliageParams()), b = placed(other, FoliageParams());
    QCOMPARE(a.leaves.size(), b.leaves.size());
    for (std::size_t i = 0; i < a.leaves.size(); ++i)
        QCOMPARE(same(a.leaves[i], b.leaves[i]), a.leaves[i].branch != 200);
}

void TestPlaceFoliage::branchWithoutLength()
{
    Skeleton skeleton;
    skeleton.add(noIndex, {1, 2, 3}, {1, 2, 3}, 0.001, 0.001);
    for (const FoliageItem& leaf : placed(skeleton, {0.1, 100, 0.0, 1}).leaves)
        QVERIFY(glm::length(leaf.position - glm::dvec3(1, 2, 3)) < 1.2 * alpha);
}

void TestPlaceFoliage::shapes()
{
    const test::CheckedMesh sphere = test::checkMesh(unitSphere());
    QVERIFY2(sphere.closedManifold(), sphere.summary().c_str());
    QCOMPARE(sphere.components.size(), std::size_t(1));
    QCOMPARE(sphere.components[0].euler, std::int64_t(2));
    QVERIFY(sphere.volume() > 0.9 * 4.0 / 3.0 * std::numbers::pi);
    QVERIFY(std::abs(volumeOf(unitCube()) - 1.0) < 1e-6);
    for (const TriangleMesh& shape : {unitSquare(), unitTriangle(), unitCube(), unitSphere()})
        for (const glm::uvec3& t : shape.triangles) {
            const glm::vec3 a = shape.positions[t.x], b = shape.positions[t.y], c = shape.positions[t.z];
            QVERIFY(glm::dot(glm::cross(b - a, c - a), shape.normals[t.x]) > 0.0f);
        }
}

void TestPlaceFoliage::roughModel()
{
    const Skeleton tree = randomTree(8);
    const Foliage foliage = placed(tree, {0.1, 10, 0.5, 1});
    const TriangleMesh leaves = buildLeaves(tree, foliage, alpha, FoliageModel::Rough);
    QCOMPARE(leaves.faceCount(), Index(2 * foliage.leaves.size()));
    for (Index i = 0; i < leaves.vertexCount(); i += 4)
        for (Index k = 0; k < 4; ++k) {
            const float side = glm::length(leaves.positions[i + k] - leaves.positions[i + (k + 1) % 4]);
            QVERIFY(std::abs(side - float(alpha)) < 1e-5f);
        }
    const TriangleMesh square = oneLeaf({}, alpha, FoliageModel::Rough);
    const TriangleMesh rhomb = oneLeaf({}, alpha, FoliageModel::Rhomb);
    QCOMPARE(rhomb.triangles, square.triangles);
    for (Index i = 0; i < 4; ++i)
        QCOMPARE(rhomb.positions[i], 0.5F * (square.positions[i] + square.positions[(i + 1) % 4]));
    LeafParams plant;
    plant.shape = LeafShape::Beech;
    const TriangleMesh card = oneLeaf(leafForm(plant), alpha, FoliageModel::Rough);
    const TriangleMesh half = oneLeaf(leafForm(plant), alpha, FoliageModel::Rhomb);
    QCOMPARE(half.faceCount(), Index(2));
    QCOMPARE(half.uv[0], glm::vec2(0.5F, 0.0F));
    QCOMPARE(half.uv[2], glm::vec2(0.5F, 1.0F));
    QVERIFY(std::abs(areaOf(half) - 0.5 * areaOf(card)) < 1e-6);
    const TriangleMesh apples = buildApples(tree, foliage, alpha, FoliageModel::Rough);
    QCOMPARE(apples.faceCount(), Index(12 * foliage.apples.size()));
    const double volume = volumeOf(apples);
    QVERIFY(std::abs(volume / double(foliage.apples.size()) - alpha * alpha * alpha) < 1e-6);
}

void TestPlaceFoliage::fineModel()
{
    const Skeleton tree = randomTree(9);
    const Foliage foliage = placed(tree, {0.1, 10, 0.5, 1});
    const TriangleMesh leaves = buildLeaves(tree, foliage, alpha, FoliageModel::Fine);
    QCOMPARE(leaves.faceCount(), Index(foliage.leaves.size()));
    for (Index i = 0; i < leaves.faceCount(); ++i) {
        glm::vec3 centre(0.0f);
        for (Index k = 0; k < 3; ++k) {
            const float side =
                glm::length(leaves.positions[3 * i + k] - leaves.positions[3 * i + (k + 1) % 3]);
            QVERIFY(std::abs(side - float(alpha)) < 1e-5f);
            centre += leaves.positions[3 * i + k] / 3.0f;
            QCOMPARE(leaves.branch[3 * i + k], foliage.leaves[i].branch);
            QCOMPARE(leaves.level[3 * i + k], tree.level[foliage.leaves[i].branch]);
        }
        QVERIFY(glm::length(glm::dvec3(centre) - foliage.leaves[i].position) < 1e-4);
    }
    const TriangleMesh apples = buildApples(tree, foliage, alpha, FoliageModel::Fine);
    const Index each = unitSphere().vertexCount();
    for (Index i = 0; i < apples.vertexCount(); ++i) {
        const double radius =
            glm::length(glm::dvec3(apples.positions[i]) - foliage.apples[i / each].position);
        QVERIFY(std::abs(radius - alpha / 2) < 1e-5);
    }
    const test::CheckedMesh checked = test::checkMesh(apples);
    QVERIFY2(checked.closedManifold(), checked.summary().c_str());
    QCOMPARE(checked.components.size(), foliage.apples.size());
}

RAMURE_SUITE(TestPlaceFoliage)

} // namespace tst_place_foliage

#include "tst_place_foliage.moc"
