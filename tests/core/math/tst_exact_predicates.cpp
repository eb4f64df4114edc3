#include "core/math/box_pairs.h"
#include "core/math/exact_predicates.h"
#include "core/math/random.h"
#include "core/math/triangle_pairs.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>
#include <set>

namespace tst_exact_predicates {

using namespace ramure;
using namespace ramure::test;

/// Signs of determinants where doubles alone lie, pairs of triangles in every position, overlapping boxes.
class TestExactPredicates : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void signsOfPlainCases();
    void signsOfWholeNumbersAreExact();
    void signsSurviveHugeAndTinyNumbers();
    void nearlyFlatPointsKeepTheirSide();
    void viewsShowWhatHasAnArea();
    void trianglesApart();
    void trianglesThatMeet_data();
    void trianglesThatMeet();
    void beyondACommonVertex();
    void beyondACommonEdge();
    void boxPairsAreThoseOfAllBoxes_data();
    void boxPairsAreThoseOfAllBoxes();
};

namespace {

__extension__ using Wide = __int128;

/// Of whole numbers below 2^24: no rounding anywhere.
int wholeSign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    const auto to = [&a](const glm::vec3& p, int axis) {
        return Wide(std::int64_t(p[axis])) - std::int64_t(a[axis]);
    };
    Wide sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += to(d, i) * (to(b, j) * to(c, k) - to(b, k) * to(c, j));
    }
    return (sum > 0) - (sum < 0);
}

const Corners3 floorTriangle{glm::vec3(0, 0, 0), glm::vec3(4, 0, 0), glm::vec3(0, 4, 0)};

} // namespace

void TestExactPredicates::signsOfPlainCases()
{
    const auto& [a, b, c] = floorTriangle;
    QCOMPARE(orientation(a, b, c, {1, 1, 1}), 1);
    QCOMPARE(orientation(a, b, c, {1, 1, -1}), -1);
    QCOMPARE(orientation(a, b, c, {9, -3, 0}), 0);
    QCOMPARE(orientation(a, c, b, {1, 1, 1}), -1);
    QCOMPARE(orientation(a, a, c, {1, 1, 1}), 0);
    QCOMPARE(orientation(2, a, b, c), 1);
    QCOMPARE(orientation(2, a, c, b), -1);
    QCOMPARE(orientation(0, a, b, c), 0);
    QCOMPARE(orientation(0, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    QCOMPARE(orientation(1, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}), 1);
}

void TestExactPredicates::signsOfWholeNumbersAreExact()
{
    Random random(1, RandomStream::Test);
    int flat = 0;
    for (int round = 0; round < 20'000; ++round) {
        // Small ranges often give points in one plane, wide ones determinants of 72 bits.
        const std::uint32_t range = round % 3 == 0 ? 5 : round % 3 == 1 ? 1000 : 16'000'000;
        glm::vec3 p[4];
        for (glm::vec3& point : p)
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = float(random.below(range)) - float(range / 2);
        if (round % 6 == 5) // a point in the plane, up to the rounding to whole numbers
            p[3] = glm::round(p[0] + 0.25f * (p[1] - p[0]) + 0.5f * (p[2] - p[0]));
        const int expected = wholeSign(p[0], p[1], p[2], p[3]);
        flat += expected == 0 ? 1 : 0;
        QCOMPARE(orientation(p[0], p[1], p[2], p[3]), expected);
        QCOMPARE(orientation(p[1], p[0], p[2], p[3]), -expected);
        QCOMPARE(orientation(p[2], p[3], p[0], p[1]), expected);
    }
    QVERIFY(flat > 300);
}

void TestExactPredicates::signsSurviveHugeAndTinyNumbers()
{
    const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
    const glm::vec3 a(-huge, -huge, 0), b(huge, -huge, 0), c(0, huge, 0);
    QCOMPARE(orientation(a, b, c, {1, 1, 0}), 0);
    QCOMPARE(orientation(a, b, c, {1, 1, tiny}), 1);
    QCOMPARE(orientation(a, b, c, {1, 1, -tiny}), -1);
    QCOMPARE(orientation({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {huge, huge, tiny}), 1);
    QCOMPARE(orientation({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {huge, huge, 0}), 0);
    QCOMPARE(orientation(2, {-huge, 0, 0}, {huge, 0, 0}, {1, tiny, 0}), 1);
    QCOMPARE(orientation(2, {-huge, 0, 0}, {huge, 0, 0}, {1, -tiny, 0}), -1);
}

/// One step of a float beside a tilted plane: plain doubles give either sign there.
void TestExactPredicates::nearlyFlatPointsKeepTheirSide()
{
    const glm::vec3 a(0.1f, 0.2f, 0.3f), b(1.1f, 7.7f, 3.3f);
    for (int i = 0; i < 2000; ++i) {
        const float t = float(i) * 0.37f;
        // On the line through a and b nothing has a side, whatever the third corner: doubled coordinates are
        // exact.
        const glm::vec3 twice = a * 2.0f, four = a * 4.0f;
        QCOMPARE(orientation(a, twice, glm::vec3(t, 1, -t), four), 0);
        glm::vec3 beside = four;
        beside.x = std::nextafter(beside.x, 1e9f);
        const int side = orientation(a, twice, b, beside);
        QVERIFY(side != 0);
        QCOMPARE(orientation(twice, a, b, beside), -side);
        QCOMPARE(orientation(beside, b, twice, a), side); // even permutation
    }
}

void TestExactPredicates::viewsShowWhatHasAnArea()
{
    QCOMPARE(viewOf({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 2);
    QCOMPARE(viewOf({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
    QCOMPARE(viewOf({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), 1);
    QCOMPARE(viewOf({1, 2, 3}, {1, 2, 3}, {0, 0, 1}), -1);
    QCOMPARE(viewOf({0.1f, 0.2f, 0.3f}, {0.2f, 0.4f, 0.6f}, {0.4f, 0.8f, 1.2f}), -1);
}

void TestExactPredicates::trianglesApart()
{
    const Corners3 above{glm::vec3(0, 0, 1), glm::vec3(4, 0, 1), glm::vec3(0, 4, 2)};
    const Corners3 beside{glm::vec3(5, 5, -1), glm::vec3(5, 6, 1), glm::vec3(6, 5, 1)};
    const Corners3 inPlane{glm::vec3(3, 3, 0), glm::vec3(5, 3, 0), glm::vec3(3, 5, 0)};
    for (const Corners3& other : {above, beside, inPlane}) {
        QVERIFY(!trianglesMeet(floorTriangle, other));
        QVERIFY(!trianglesMeet(other, floorTriangle));
    }
}

void TestExactPredicates::trianglesThatMeet_data()
{
    QTest::addColumn<QList<float>>("numbers");
    QTest::newRow("through the middle") << QList<float>{1, 1, -1, 1, 1, 1, 9, 9, 1};
    QTest::newRow("its border through the other's") << QList<float>{-1, 1, -1, -1, 1, 1, 9, 1, 1};
    QTest::newRow("touches with a corner") << QList<float>{1, 1, 0, 1, 1, 1, 2, 1, 1};
    QTest::newRow("corner on corner") << QList<float>{4, 0, 0, 5, 0, 1, 5, 1, 1};
    QTest::newRow("corner on a side") << QList<float>{2, 2, 0, 5, 5, 1, 5, 5, 2};
    QTest::newRow("side on side") << QList<float>{1, 0, 0, 2, 0, 0, 1, -1, 1};
    QTest::newRow("side in the plane, inside") << QList<float>{1, 1, 0, 2, 1, 0, 1, 1, 1};
    QTest::newRow("side in the plane, across") << QList<float>{-1, 1, 0, 9, 1, 0, 1, 1, 1};
    QTest::newRow("in the plane, inside") << QList<float>{1, 1, 0, 2, 1, 0, 1, 2, 0};
    QTest::newRow("in the plane, around") << QList<float>{-9, -9, 0, 99, -9, 0, -9, 99, 0};
    QTest::newRow("in the plane, a star") << QList<float>{-1, 1, 0, 3, 1, 0, 1, -1, 0};
    QTest::newRow("in the plane, corner on a side") << QList<float>{2, 2, 0, 5, 2, 0, 2, 5, 0};
    QTest::newRow("the same") << QList<float>{0, 0, 0, 4, 0, 0, 0, 4, 0};
}

void TestExactPredicates::trianglesThatMeet()
{
    QFETCH(QList<float>, numbers);
    Corners3 other;
    for (int i = 0; i < 9; ++i)
        other[std::size_t(i / 3)][i % 3] = numbers[i];
    Corners3 mine = floorTriangle;
    for (int turn = 0; turn < 6; ++turn) {
        QVERIFY(trianglesMeet(mine, other));
        QVERIFY(trianglesMeet(other, mine));
        std::rotate(other.begin(), other.begin() + 1, other.end());
        if (turn == 2)
            std::swap(mine[0], mine[1]);
    }
}

void TestExactPredicates::beyondACommonVertex()
{
    const glm::vec3 v(0, 0, 0);
    const auto meets = [&](const glm::vec3& a, const glm::vec3& b) {
        const Corners3 other{v, a, b};
        const bool found = trianglesMeetBeyondVertex(floorTriangle, other);
        return found == trianglesMeetBeyondVertex(other, floorTriangle) ? int(found) : -1;
    };
    QCOMPARE(meets({1, 1, 1}, {1, 1, 2}), 0); // only the vertex
    QCOMPARE(meets({-1, -1, 1}, {-1, -1, -1}), 0);
    QCOMPARE(meets({1, 1, 1}, {1, 1, -1}), 1);   // cuts along a line from the vertex
    QCOMPARE(meets({1, 1, 0}, {1, 1, -1}), 1);   // a side lies in it
    QCOMPARE(meets({-1, 1, 0}, {-1, 1, -1}), 0); // a side in its plane, beside it
    QCOMPARE(meets({2, 0, 0}, {1, -1, 1}), 1);   // along its side
    QCOMPARE(meets({1, 2, 0}, {2, 1, 0}), 1);    // flat, inside
    QCOMPARE(meets({9, 1, 0}, {1, 9, 0}), 1);    // flat, further out
    QCOMPARE(meets({-1, 1, 0}, {-1, -1, 0}), 0); // flat, beside
    QCOMPARE(meets({0, 1, 0}, {-1, 1, 0}), 1);   // flat, along a side
}

void TestExactPredicates::beyondACommonEdge()
{
    const glm::vec3 a(0, 0, 0), b(4, 0, 0), p(1, 2, 0);
    QVERIFY(trianglesMeetBeyondEdge(a, b, p, {2, 1, 0}));
    QVERIFY(!trianglesMeetBeyondEdge(a, b, p, {2, -1, 0}));
    QVERIFY(!trianglesMeetBeyondEdge(a, b, p, {2, 1, 1e-30f}));
    QVERIFY(!trianglesMeetBeyondEdge(a, b, p, {2, -1, 1e-30f}));
}

void TestExactPredicates::boxPairsAreThoseOfAllBoxes_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("size");
    for (const int count : {0, 1, 2, 7, 8, 9, 64, 65, 513, 3000})
        for (const double size : {0.0, 0.05, 0.5})
            QTest::addRow("%d of %g", count, size) << count << size;
}

void TestExactPredicates::boxPairsAreThoseOfAllBoxes()
{
    QFETCH(int, count);
    QFETCH(double, size);
    Random random(7, RandomStream::Test, std::uint64_t(count));
    std::vector<PrimitiveBounds> boxes;
    for (int i = 0; i < count; ++i) {
        // On a lattice where they have no size, so that some still touch.
        const auto place = [&] { return size > 0.0 ? float(random.unit()) : float(random.below(9)); };
        const glm::vec3 low(place(), place(), place());
        boxes.push_back({low, low + glm::vec3(float(size * random.unit())), Index(i)});
    }
    std::set<std::pair<Index, Index>> expected, found;
    for (Index i = 0; i < boxes.size(); ++i)
        for (Index j = i + 1; j < boxes.size(); ++j)
            if (glm::all(glm::lessThanEqual(boxes[i].min, boxes[j].max)) &&
                glm::all(glm::lessThanEqual(boxes[j].min, boxes[i].max)))
                expected.emplace(i, j);
    const BoxPairs pairs(boxes);
    std::size_t calls = 0;
    for (std::size_t chunk = 0; chunk < pairs.chunkCount(); ++chunk)
        pairs.inChunk(chunk, [&](Index a, Index b) {
            ++calls;
            found.emplace(std::min(a, b), std::max(a, b));
        });
    QCOMPARE(calls, found.size()); // each once
    QVERIFY(found == expected);
}

RAMURE_SUITE(TestExactPredicates)

} // namespace tst_exact_predicates

#include "tst_exact_predicates.moc"
