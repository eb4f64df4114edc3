#include "core/surface/foliage/fruit_shapes.h"

#include "core/rig/physics/tree_body.h"
#include "core/skeleton/sections.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>

namespace tst_fruit_shapes {

using namespace ramure;

namespace {

constexpr double alpha = 0.2;

FruitKind kindOf(int i)
{
    return static_cast<FruitKind>(i);
}

/// A twig that bends, level and thin enough to carry fruit.
Skeleton bough()
{
    Skeleton skeleton;
    skeleton.add(noIndex, {0, 2, 0}, {0.8, 2.2, 0.1}, 0.015, 0.012);
    skeleton.add(0, {0.8, 2.2, 0.1}, {1.5, 2.1, 0.4}, 0.012, 0.008);
    return skeleton;
}

Foliage hung(const Skeleton& skeleton, const FruitParams& fruit, double probability = 1.0,
             std::int64_t seed = 1)
{
    auto foliage = placeFoliage(skeleton, {0.1, 0, probability, seed}, {}, fruit, alpha);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return *foliage;
}

} // namespace

class TestFruitShapes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void noneOfSizeZero()
    {
        const Skeleton skeleton = bough();
        const Foliage none = hung(skeleton, {FruitKind::Pear, 0.0, 1.0});
        QVERIFY(none.apples.empty());
        QVERIFY(buildApples(skeleton, none, alpha, FoliageModel::Fine).empty());
        QVERIFY(hung(skeleton, {FruitKind::Pear}, 0.0).apples.empty());
    }
    void tooManyAreAnError()
    {
        Skeleton skeleton;
        for (int i = 0; i < 12000; ++i)
            skeleton.add(noIndex, {i, 0, 0}, {i, 1, 0}, 0.01, 0.01);
        const auto foliage = placeFoliage(skeleton, {0.1, 0, 1.0, 1}, {}, {FruitKind::Berries}, alpha);
        QVERIFY(!foliage);
        QCOMPARE(foliage.error().code, ErrorCode::Limit);
        QCOMPARE(foliage.error().path, std::string("foliage.applesProbability"));
    }
    /// Every kind, with its stalk and without: closed, manifold, one piece, outward, as wide as it says.
    void everyKindIsOneClosedBody()
    {
        for (int i = 0; i < fruitKindCount; ++i)
            for (const double stalk : {0.0, 1e-3, 1.0, 20.0}) {
                const FruitForm form{kindOf(i), 1.0, stalk};
                const TriangleMesh mesh = fruitMesh(form);
                const test::CheckedMesh checked = test::checkMesh(mesh);
                QVERIFY2(checked.closedManifold(), checked.summary().c_str());
                QCOMPARE(checked.components.size(), std::size_t(1));
                QCOMPARE(checked.components[0].euler, std::int64_t(2));
                QVERIFY(checked.volume() > 0.0);
                QCOMPARE(mesh.normals.size(), mesh.positions.size());
                QCOMPARE(mesh.colours.size(), i == 0 ? 0 : mesh.triangles.size());
                double widest = 0.0, highest = 0.0;
                for (const glm::vec3& at : mesh.positions) {
                    if (at.y < 0.9 * fruitReach(form) || i == 0)
                        widest = std::max(widest, std::hypot(double(at.x), double(at.z)));
                    highest = std::max(highest, double(at.y));
                }
                QVERIFY2(std::abs(widest - 1.0) < 0.15, qPrintable(QString::number(i)));
                if (form.kind != FruitKind::Faithful && stalk >= 1.0)
                    QVERIFY(std::abs(highest - fruitReach(form)) < 0.15);
                for (const glm::vec3& corner : fruitCube({kindOf(i)}).positions)
                    QCOMPARE(glm::abs(corner), glm::vec3(1.0f));
            }
    }
    /// Heads of flowers: each flower and each stalk is closed, and all stalks begin at one foot. They are
    /// many: together they have fewer triangles than one flower alone.
    void headsOfFlowersHaveOneFoot()
    {
        const FruitForm one{FruitKind::Blossom};
        for (const int count : {2, 5, 12}) {
            FruitForm form = one;
            form.stalk = 2.4;
            form.head = count;
            const TriangleMesh mesh = fruitMesh(form);
            const test::CheckedMesh checked = test::checkMesh(mesh);
            QVERIFY2(checked.closedManifold(), checked.summary().c_str());
            QCOMPARE(checked.components.size(), std::size_t(2 * count));
            QVERIFY(checked.volume() > 0.0);
            QCOMPARE(mesh.colours.size(), mesh.triangles.size());
            int feet = 0;
            const glm::vec3 foot(0.0F, float(fruitReach(form)), 0.0F);
            for (const glm::vec3& at : mesh.positions) {
                feet += glm::distance(at, foot) < 0.03F ? 1 : 0;
                QVERIFY(glm::distance(at, foot) < fruitReach(form) + 1.0);
            }
            QCOMPARE(feet, count);
            QVERIFY(count > 5 || mesh.faceCount() < fruitMesh(one).faceCount());
        }
    }
    /// Stalks begin on the bark, fruit hang below them.
    void theyHangFromTheBark()
    {
        const Skeleton skeleton = bough();
        for (int i = 1; i < fruitKindCount; ++i)
            for (std::int64_t seed = 1; seed < 20; ++seed) {
                const Foliage foliage = hung(skeleton, {kindOf(i)}, 1.0, seed);
                QCOMPARE(foliage.apples.size(), 2 * std::size_t(fruitCluster(kindOf(i))));
                for (const FoliageItem& fruit : foliage.apples) {
                    const glm::dvec3 up = fruit.orientation * glm::dvec3(0, 1, 0);
                    const double reach = fruitRadius(foliage.fruit, alpha) * fruitReach(foliage.fruit);
                    const glm::dvec3 foot = fruit.position + fruit.size * reach * up;
                    const BranchCurve curve = branchCurve(skeleton, fruit.branch);
                    double nearest = 1e9, radius = 0.0;
                    for (int k = 0; k <= 2000; ++k) {
                        const double t = k / 2000.0;
                        const double away =
                            glm::length(hermite(curve.h0, curve.h1, curve.v0, curve.v1, t).point - foot);
                        if (away < nearest) {
                            nearest = away;
                            radius = (1 - t) * skeleton.a0[fruit.branch] + t * skeleton.a1[fruit.branch];
                        }
                    }
                    QVERIFY(std::abs(nearest - 0.95 * radius) < 0.02 * radius);
                    if (hangs(kindOf(i)))
                        QVERIFY(up.y > 0.8); // the stalk is above
                    else
                        QVERIFY(up.y < 0.2); // the flower's face is away from its stalk
                }
            }
    }
    void bodiesOfThePhysicsAreAsLarge()
    {
        const Skeleton skeleton = bough();
        const Foliage foliage = hung(skeleton, {FruitKind::Apple, 1.5});
        QCOMPARE(makeTreeBody(skeleton, &foliage, alpha)->appleRadius,
                 1.5 * fruitRadius({FruitKind::Apple}, 0.2));
        QCOMPARE(makeTreeBody(skeleton, nullptr, alpha)->appleRadius, 0.1);
    }
    /// A diameter in metres is that of the fruit, however thick the trunk is.
    void diametersAreMetres()
    {
        const Skeleton skeleton = bough();
        FruitParams apple{FruitKind::Apple};
        apple.diameter = 0.07;
        for (const double trunk : {0.001, 0.2, 30.0}) {
            QCOMPARE(fruitRadius(fruitForm(apple), trunk), 0.035);
            const auto foliage = placeFoliage(skeleton, {0.1, 0, 1.0, 1}, {}, apple, trunk);
            QVERIFY(foliage);
            const TriangleMesh one = oneApple(foliage->fruit, trunk, FoliageModel::Fine);
            double widest = 0.0;
            for (const glm::vec3& at : one.positions)
                widest = std::max(widest, std::hypot(double(at.x), double(at.z)));
            QVERIFY(std::abs(widest - 0.035) < 0.005);
        }
    }
    void clustersHaveAsManyAsTheySay()
    {
        const Skeleton skeleton = bough();
        for (const std::int64_t count : {1, 5, 60}) {
            FruitParams berries{FruitKind::Berries};
            berries.cluster = count;
            const auto foliage = placeFoliage(skeleton, {0.1, 0, 1.0, 1}, {}, berries, alpha);
            QVERIFY(foliage);
            QCOMPARE(foliage->apples.size(), 2 * std::size_t(count));
        }
    }
    /// None is ripe at 0, all at 1, as many as said between; who is ripe stays ripe. Flowers do not ripen.
    void fruitRipenOneAfterTheOther()
    {
        Skeleton many;
        for (int i = 0; i < 600; ++i)
            many.add(noIndex, {0.1 * i, 0, 0}, {0.1 * i, 0.05, 0}, 0.01, 0.01);
        const auto ripe = [&](FruitKind kind, double share) {
            FruitParams fruit{kind};
            fruit.ripeness = share;
            const auto foliage = placeFoliage(many, {0.1, 0, 1.0, 1}, {}, fruit, alpha);
            std::vector<bool> out;
            for (const FoliageItem& item : foliage->apples)
                out.push_back(!foliage->fruit.ripens || item.tint == ripenedTint(kind, 1.0));
            return out;
        };
        std::size_t before = 0;
        std::vector<bool> last(600, false);
        for (const double share : {0.0, 0.3, 0.6, 0.9, 1.0}) {
            const std::vector<bool> now = ripe(FruitKind::Apple, share);
            QCOMPARE(now.size(), std::size_t(600));
            for (std::size_t i = 0; i < now.size(); ++i)
                QVERIFY(now[i] || !last[i]);
            const auto count = std::size_t(std::ranges::count(now, true));
            QVERIFY(count >= before && (share > 0.0 || count == 0) && (share < 1.0 || count == 600));
            before = count;
            last = now;
        }
        QCOMPARE(std::ranges::count(ripe(FruitKind::Blossom, 0.2), false), 0);
        for (int i = 1; i < fruitKindCount; ++i)
            for (const double share : {0.0, 0.5, 1.0}) {
                const glm::vec3 tint = ripenedTint(kindOf(i), share);
                QVERIFY(glm::all(glm::greaterThanEqual(tint, glm::vec3(0.0f))) &&
                        glm::all(glm::lessThanEqual(tint, glm::vec3(1.0f))));
            }
    }
    void texturesCoverThem()
    {
        const Skeleton skeleton = bough();
        for (int i = 1; i < fruitKindCount; ++i) {
            const Foliage foliage = hung(skeleton, {kindOf(i)});
            TriangleMesh mesh = buildApples(skeleton, foliage, alpha, FoliageModel::Fine);
            addAppleTexture(mesh, foliage.fruit);
            QCOMPARE(mesh.uvTriangles.size(), mesh.triangles.size());
            for (const glm::vec2& at : mesh.uv)
                QVERIFY(at.x >= 0.0f && at.x <= 2.0f && at.y >= 0.0f && at.y <= 1.0f);
        }
    }
};

RAMURE_SUITE(TestFruitShapes)

} // namespace tst_fruit_shapes

#include "tst_fruit_shapes.moc"
