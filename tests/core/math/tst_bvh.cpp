#include "core/math/bvh.h"
#include "core/math/random.h"
#include "tests/support/suite.h"
#include <set>

namespace tst_bvh {

using namespace ramure;

namespace {

using Triangle = std::array<glm::vec3, 3>;

glm::vec3 randomPoint(Random& random, double reach)
{
    return {float(random.range(-reach, reach)), float(random.range(-reach, reach)),
            float(random.range(-reach, reach))};
}

std::vector<Triangle> randomTriangles(Random& random, Index count, double size)
{
    std::vector<Triangle> triangles;
    for (Index i = 0; i < count; ++i) {
        const glm::vec3 at = randomPoint(random, 10.0);
        triangles.push_back(
            {at + randomPoint(random, size), at + randomPoint(random, size), at + randomPoint(random, size)});
    }
    return triangles;
}

std::vector<PrimitiveBounds> boundsOf(const std::vector<Triangle>& triangles)
{
    std::vector<PrimitiveBounds> bounds;
    for (Index i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        bounds.push_back({glm::min(t[0], glm::min(t[1], t[2])), glm::max(t[0], glm::max(t[1], t[2])), i});
    }
    return bounds;
}

std::optional<TriangleHit> hitOf(const Ray& ray, const Triangle& t)
{
    return intersect(ray, glm::dvec3(t[0]), glm::dvec3(t[1]), glm::dvec3(t[2]));
}

/// Nearest t and triangle, or noIndex.
std::pair<double, Index> nearest(const Bvh& bvh, const std::vector<Triangle>& triangles, const Ray& ray)
{
    std::pair<double, Index> best{1e300, noIndex};
    bvh.alongRay(ray, best.first, [&](Index i, double& tMax) {
        const auto hit = hitOf(ray, triangles[i]);
        if (hit && (hit->t < best.first || (hit->t == best.first && i < best.second))) {
            best = {hit->t, i};
            tMax = hit->t;
        }
    });
    return best;
}

std::pair<double, Index> nearestByHand(const std::vector<Triangle>& triangles, const Ray& ray)
{
    std::pair<double, Index> best{1e300, noIndex};
    for (Index i = 0; i < triangles.size(); ++i) {
        const auto hit = hitOf(ray, triangles[i]);
        if (hit && hit->t < best.first)
            best = {hit->t, i};
    }
    return best;
}

Ray randomRay(Random& random, int kind)
{
    Ray ray{glm::dvec3(randomPoint(random, 14.0)), glm::dvec3(randomPoint(random, 1.0))};
    // Along the axes too: a direction of zero is where slab tests go wrong.
    if (kind % 4 == 0)
        ray.direction[kind % 3] = 0.0;
    if (kind % 8 == 0)
        ray.direction[(kind + 1) % 3] = 0.0;
    if (ray.direction == glm::dvec3(0.0))
        ray.direction.y = -1.0;
    return ray;
}

} // namespace

class TestBvh : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingIsHitInAnEmptyOne()
    {
        const Bvh bvh{std::vector<PrimitiveBounds>()};
        QVERIFY(bvh.empty());
        bvh.alongRay({}, 1e9, [](Index, double&) { QFAIL("no primitive"); });
        bvh.nearRay(
            {}, [](auto, auto) { return 1e9; }, [](Index) { QFAIL("no primitive"); });
        bvh.inPlanes({}, [](Index, bool) { QFAIL("no primitive"); });
    }
    void stoppedBuildIsEmpty()
    {
        Random random(1, RandomStream::Test);
        std::stop_source source;
        source.request_stop();
        QVERIFY(Bvh(boundsOf(randomTriangles(random, 20'000, 0.1)), source.get_token()).empty());
    }
    void equalBoxesStayWithinTheDepth()
    {
        std::vector<PrimitiveBounds> bounds;
        for (Index i = 0; i < 50'000; ++i)
            bounds.push_back({glm::vec3(1.0f), glm::vec3(1.0f), i});
        const Bvh bvh(bounds);
        Index seen = 0;
        bvh.alongRay({glm::dvec3(1.0, 1.0, 5.0), glm::dvec3(0.0, 0.0, -1.0)}, 1e9,
                     [&](Index, double&) { ++seen; });
        QCOMPARE(seen, 50'000u);
    }
    void geometricallyShrinkingBoxes()
    {
        // Each bin holds one box and all the rest: the worst case for the depth.
        std::vector<PrimitiveBounds> bounds;
        for (Index i = 0; i < 20'000; ++i) {
            const float at = 1e20f * std::pow(0.98f, float(i));
            bounds.push_back({glm::vec3(at, 0.0f, 0.0f), glm::vec3(at, 0.0f, 0.0f), i});
        }
        Index seen = 0;
        Bvh(bounds).inPlanes({}, [&](Index, bool certain) { seen += certain ? 1 : 0; });
        QCOMPARE(seen, 20'000u);
    }
    void extremeExtents()
    {
        for (const float size : {1e-44f, 1e-38f, 1e30f, 3e38f}) {
            std::vector<PrimitiveBounds> bounds;
            for (Index i = 0; i < 100; ++i) {
                const glm::vec3 at(i % 2 == 0 ? size : -size, 0.0f, 0.0f);
                bounds.push_back({at, at, i});
            }
            Index seen = 0;
            Bvh(bounds).inPlanes({}, [&](Index, bool) { ++seen; });
            QCOMPARE(seen, 100u);
        }
    }
    void raysAgreeWithBruteForce()
    {
        Random random(2, RandomStream::Test);
        for (const double size : {0.3, 3.0, 20.0}) {
            const std::vector<Triangle> triangles = randomTriangles(random, 1500, size);
            const Bvh bvh(boundsOf(triangles));
            int hits = 0;
            for (int i = 0; i < 1000; ++i) {
                const Ray ray = randomRay(random, i);
                const auto expected = nearestByHand(triangles, ray);
                QCOMPARE(nearest(bvh, triangles, ray), expected);
                hits += expected.second != noIndex ? 1 : 0;
            }
            QVERIFY2(hits > 20, "the test must hit something");
        }
    }
    void nearRayFindsAllWithinTheGrowth()
    {
        Random random(3, RandomStream::Test);
        const std::vector<Triangle> triangles = randomTriangles(random, 2000, 0.05);
        const std::vector<PrimitiveBounds> bounds = boundsOf(triangles);
        const Bvh bvh(bounds);
        for (int i = 0; i < 200; ++i) {
            Ray ray = randomRay(random, i);
            ray.direction = glm::normalize(ray.direction);
            const double reach = random.range(0.0, 2.0);
            std::set<Index> found;
            bvh.nearRay(
                ray, [reach](auto, auto) { return reach; }, [&](Index p) { found.insert(p); });
            for (Index p = 0; p < triangles.size(); ++p) {
                const glm::dvec3 offset = glm::dvec3(triangles[p][0]) - ray.origin;
                const double along = std::max(0.0, glm::dot(offset, ray.direction));
                if (glm::length(offset - along * ray.direction) < reach)
                    QVERIFY(found.contains(p));
            }
        }
    }
    void planesAgreeWithBruteForce()
    {
        Random random(4, RandomStream::Test);
        const std::vector<Triangle> triangles = randomTriangles(random, 2000, 1.0);
        const Bvh bvh(boundsOf(triangles));
        for (int i = 0; i < 200; ++i) {
            std::vector<CutPlane> planes;
            for (int k = 0; k < 5; ++k)
                planes.emplace_back(glm::dvec3(randomPoint(random, 1.0)), random.range(0.0, 5.0));
            std::set<Index> found;
            std::set<Index> expected;
            const auto inside = [&](Index p) {
                const Triangle& t = triangles[p];
                return touches(planes, glm::dvec3(t[0]), glm::dvec3(t[1]), glm::dvec3(t[2]));
            };
            bvh.inPlanes(planes, [&](Index p, bool certain) {
                if (certain || inside(p))
                    found.insert(p);
            });
            for (Index p = 0; p < triangles.size(); ++p) {
                if (inside(p))
                    expected.insert(p);
            }
            QCOMPARE(found, expected);
        }
    }
    void sameInputSameTree()
    {
        Random random(5, RandomStream::Test);
        const auto bounds = boundsOf(randomTriangles(random, 3000, 0.5));
        std::vector<Index> first;
        std::vector<Index> second;
        Bvh(bounds).inPlanes({}, [&](Index p, bool) { first.push_back(p); });
        Bvh(bounds).inPlanes({}, [&](Index p, bool) { second.push_back(p); });
        QCOMPARE(first, second);
    }
    void triangleFromBothSides()
    {
        const Triangle t{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
        const auto front = hitOf({{0.2, 0.3, 2.0}, {0.0, 0.0, -1.0}}, t);
        const auto back = hitOf({{0.2, 0.3, -2.0}, {0.0, 0.0, 2.0}}, t);
        QVERIFY(front && back);
        QCOMPARE(front->t, 2.0);
        QCOMPARE(back->t, 1.0);
        QVERIFY(glm::length(front->weights - glm::dvec3(0.5, 0.2, 0.3)) < 1e-15);
        QVERIFY(!hitOf({{0.2, 0.3, 2.0}, {0.0, 0.0, 1.0}}, t));
        QVERIFY(!hitOf({{0.9, 0.9, 2.0}, {0.0, 0.0, -1.0}}, t));
        QVERIFY2(!hitOf({{-1.0, 0.2, 0.0}, {1.0, 0.0, 0.0}}, t), "in its plane");
    }
    void touchingPlanes()
    {
        const std::vector<CutPlane> slab{{1, 0, 0, 0}, {-1, 0, 0, 1}}; // 0 <= x <= 1
        QVERIFY(touches(slab, {-1, 0, 0}, {2, 0, 0}));
        QVERIFY(touches(slab, {0.5, 9, 9}, {0.5, 9, 9}));
        QVERIFY(!touches(slab, {1.1, 0, 0}, {2, 0, 0}));
        QVERIFY2(touches(slab, {-5, 0, 0}, {5, 1, 0}, {5, -1, 0}), "all corners outside, the middle inside");
        QVERIFY(!touches(slab, {-5, 0, 0}, {-5, 1, 0}, {-1, -1, 0}));
        QVERIFY(touches({}, {0, 0, 0}, {1, 0, 0}));
    }
};

RAMURE_SUITE(TestBvh)

} // namespace tst_bvh

#include "tst_bvh.moc"
