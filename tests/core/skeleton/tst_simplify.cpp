#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/math/random.h"
#include "core/presets/presets.h"
#include "core/skeleton/simplify.h"
#include "tests/support/suite.h"

#include <QFile>
#include <cmath>
#include <numbers>

namespace tst_simplify {

using namespace ramure;

namespace {

/// A chain in the plane, each branch turned by the given angle against the one before.
Skeleton chain(const std::vector<double>& turns)
{
    Skeleton skeleton;
    glm::dvec3 from(0.0);
    double angle = 0.0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        angle += turns[i];
        const glm::dvec3 to = from + glm::dvec3(std::sin(angle), std::cos(angle), 0.0);
        skeleton.add(i == 0 ? noIndex : Index(i - 1), from, to, 1.0 / double(i + 1), 1.0 / double(i + 2));
        from = to;
    }
    return skeleton;
}

/// Any tree: short and long runs, forks, straight and turning branches, some without length.
Skeleton randomTree(std::uint64_t seed, Index count)
{
    Random random(seed, RandomStream::Test);
    Skeleton skeleton;
    skeleton.add(noIndex, glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0), 0.3, 0.3);
    while (skeleton.size() < count) {
        const Index last = skeleton.size() - 1;
        const Index parent = random.unit() < 0.7 ? last : random.below(skeleton.size());
        const glm::dvec3 along = skeleton.p1[parent] - skeleton.p0[parent];
        glm::dvec3 step = along * random.range(0.5, 1.5);
        if (random.unit() < 0.4)
            step += glm::dvec3(random.range(-1, 1), random.range(-1, 1), random.range(-1, 1));
        if (random.unit() < 0.05)
            step = glm::dvec3(0.0);
        skeleton.add(parent, skeleton.p1[parent], skeleton.p1[parent] + step, 0.1, 0.1);
    }
    return skeleton;
}

void checkInvariants(const Skeleton& in, const SimplifiedSkeleton& out)
{
    const Skeleton& s = out.skeleton;
    QCOMPARE(out.mergedInto.size(), std::size_t(in.size()));
    std::vector<Index> last(s.size(), noIndex);
    for (Index i = 0; i < in.size(); ++i) {
        QVERIFY(out.mergedInto[i] < s.size());
        last[out.mergedInto[i]] = i;
    }
    for (Index i = 0; i < s.size(); ++i) {
        const Index first = s.source[i];
        QCOMPARE(out.mergedInto[first], i);
        QVERIFY(s.parent[i] == noIndex || s.parent[i] < i);
        QVERIFY(s.p0[i] == in.p0[first] && s.a0[i] == in.a0[first]);
        QVERIFY(s.p1[i] == in.p1[last[i]] && s.a1[i] == in.a1[last[i]]);
        QVERIFY(s.key[i] == in.key[first] && s.level[i] == in.level[first]);
        if (s.parent[i] != noIndex)
            QVERIFY(s.p0[i] == s.p1[s.parent[i]]);
    }
}

/// The definition, word for word and with an inverse function, as the judge of the fast test.
Index slowCount(const Skeleton& in, double threshold)
{
    const ChildLists children = childLists(in);
    Index count = in.size();
    std::vector<glm::dvec3> start = in.p0;
    for (Index i = 0; i < in.size(); ++i) {
        const Index parent = in.parent[i];
        if (parent == noIndex || children.count(parent) != 1)
            continue;
        const glm::dvec3 merged = in.p1[parent] - start[parent];
        const glm::dvec3 own = in.p1[i] - in.p0[i];
        // + 0.0: a branch without length must not become a half turn by the sign of a zero.
        const double along = glm::dot(merged, own) + 0.0;
        if (std::atan2(glm::length(glm::cross(merged, own)), along) < threshold) {
            start[i] = start[parent];
            --count;
        }
    }
    return count;
}

} // namespace

class TestSimplify : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void emptyStaysEmpty();
    void nothingBelowZeroOrNan();
    void straightChainBecomesOne();
    void smallAnglesAreToldApart();
    void angleIsMeasuredAgainstTheMergedBranch();
    void forksAreKept();
    void rootsAreKept();
    void branchWithoutLengthIsStraight();
    void footsThatFlareStay();
    void largeThresholds();
    void randomTrees();
    void golden_data();
    void golden();
};

void TestSimplify::emptyStaysEmpty()
{
    const SimplifiedSkeleton out = simplify(Skeleton(), 1.0);
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled = simplify(chain({0.3, 0.1}), 1.0, {stop.get_token(), {}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    QVERIFY(simplify(chain({0.3, 0.1}), 1.0, {})->skeleton == simplify(chain({0.3, 0.1}), 1.0).skeleton);
    QVERIFY(out.skeleton.empty() && out.mergedInto.empty());
}

void TestSimplify::nothingBelowZeroOrNan()
{
    const Skeleton straight = chain({0, 0, 0});
    for (const double threshold : {0.0, -1.0, std::nan("")})
        QVERIFY(simplify(straight, threshold).skeleton == straight);
}

void TestSimplify::straightChainBecomesOne()
{
    const Skeleton in = chain(std::vector<double>(1000, 0.0));
    const SimplifiedSkeleton out = simplify(in, 1e-4);
    QCOMPARE(out.skeleton.size(), Index(1));
    QCOMPARE(out.skeleton.length(0), 1000.0);
    QCOMPARE(out.skeleton.a1[0], in.a1.back());
    checkInvariants(in, out);
}

void TestSimplify::smallAnglesAreToldApart()
{
    for (const double threshold : {1e-9, 1e-6, 1e-4, 0.01, 0.5, 1.5, std::numbers::pi / 2, 1.6, 3.0}) {
        QCOMPARE(simplify(chain({0.3, threshold * (1 - 1e-6)}), threshold).skeleton.size(), Index(1));
        QCOMPARE(simplify(chain({0.3, threshold * (1 + 1e-6)}), threshold).skeleton.size(), Index(2));
    }
}

void TestSimplify::angleIsMeasuredAgainstTheMergedBranch()
{
    // Each turns by 0.9 of the threshold against its predecessor, but the third by more against the merged
    // first two.
    QCOMPARE(simplify(chain({0, 0.09, 0.09, 0.09}), 0.1).skeleton.size(), Index(2));
    // Turns back and forth cancel.
    QCOMPARE(simplify(chain({0, 0.09, -0.09, 0.09, -0.09}), 0.1).skeleton.size(), Index(1));
}

void TestSimplify::forksAreKept()
{
    Skeleton in = chain({0, 0, 0});
    in.add(1, in.p1[1], in.p1[1] + glm::dvec3(1, 0, 0), 0.1, 0.1);
    const SimplifiedSkeleton out = simplify(in, 1e-4);
    QCOMPARE(out.skeleton.size(), Index(3));
    checkInvariants(in, out);
}

void TestSimplify::rootsAreKept()
{
    Skeleton in = chain({0, 0});
    in.add(noIndex, glm::dvec3(0.0), glm::dvec3(0, 2, 0), 0.1, 0.1);
    in.add(2, in.p1[2], in.p1[2] + glm::dvec3(0, 1, 0), 0.1, 0.1);
    const SimplifiedSkeleton out = simplify(in, 1e-4);
    QCOMPARE(out.skeleton.size(), Index(2));
    QCOMPARE(skeletonStats(out.skeleton).roots, Index(2));
    checkInvariants(in, out);
}

void TestSimplify::branchWithoutLengthIsStraight()
{
    Skeleton in;
    in.add(noIndex, glm::dvec3(1.0), glm::dvec3(1.0), 0.1, 0.1);
    in.add(0, glm::dvec3(1.0), glm::dvec3(1, 2, 1), 0.1, 0.1);
    in.add(1, glm::dvec3(1, 2, 1), glm::dvec3(1, 2, 1), 0.1, 0.1);
    QCOMPARE(simplify(in, 1e-4).skeleton.size(), Index(1));
}

void TestSimplify::footsThatFlareStay()
{
    Skeleton stem; // 0.5 m per m, then 0.1, then 0.02 all the way
    const std::vector<double> heights{0, 1, 2, 3, 4, 5}, radii{1.0, 0.5, 0.4, 0.38, 0.36, 0.34};
    for (std::size_t i = 0; i + 1 < heights.size(); ++i)
        stem.add(i == 0 ? noIndex : Index(i - 1), glm::dvec3(0.0, heights[i], 0.0),
                 glm::dvec3(0.0, heights[i + 1], 0.0), radii[i], radii[i + 1]);
    const auto branches = [&](double taper) { return simplify(stem, 0.1, {}, {taper})->skeleton.size(); };
    QCOMPARE(simplify(stem, 0.1).skeleton.size(), Index(1));
    QCOMPARE(branches(0.5), Index(1));
    QCOMPARE(branches(0.3), Index(2));
    QCOMPARE(branches(0.05), Index(3));
    const auto three = simplify(stem, 0.1, {}, {0.05});
    QCOMPARE(three->skeleton.a1, (std::vector<double>{0.5, 0.4, 0.34}));
    checkInvariants(stem, *three);
}

void TestSimplify::largeThresholds()
{
    const Skeleton there = chain({0, std::numbers::pi - 0.01});
    QCOMPARE(simplify(there, 3.0).skeleton.size(), Index(2));
    QCOMPARE(simplify(there, std::numbers::pi).skeleton.size(), Index(1));
    QCOMPARE(simplify(there, 100.0).skeleton.size(), Index(1));
}

void TestSimplify::randomTrees()
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Skeleton in = randomTree(seed, 200);
        Index before = in.size();
        for (const double threshold : {1e-4, 0.1, 0.7, 1.2, 2.0, 3.1}) {
            const SimplifiedSkeleton out = simplify(in, threshold);
            checkInvariants(in, out);
            QCOMPARE(out.skeleton.size(), slowCount(in, threshold));
            const SkeletonStats a = skeletonStats(in), b = skeletonStats(out.skeleton);
            QCOMPARE(b.terminals, a.terminals);
            QCOMPARE(b.roots, a.roots);
            QVERIFY(b.totalLength <= a.totalLength * (1 + 1e-12));
            if (threshold < 1e-3)
                QVERIFY(b.totalLength > a.totalLength * (1 - 1e-8));
            QVERIFY(out.skeleton.size() <= before || threshold > 1e-3);
            before = out.skeleton.size();
        }
    }
}

void TestSimplify::golden_data()
{
    QTest::addColumn<QStringList>("row");
    QFile file(QStringLiteral(RAMURE_TEST_DATA "/skeletons.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QStringList lines = QString::fromLatin1(file.readAll()).split('\n', Qt::SkipEmptyParts);
    QVERIFY(lines.takeFirst().startsWith(QLatin1String("preset,iterations,symbols")));
    QCOMPARE(lines.size(), 30);
    for (const QString& line : lines)
        QTest::newRow(line.section(',', 0, 1).toLatin1().constData()) << line.trimmed().split(',');
}

void TestSimplify::golden()
{
    QFETCH(QStringList, row);
    const auto params = presetParams(row[0].toStdString());
    QVERIFY(params);
    const auto grammar = parseGrammar(params->grammar.axiom, params->grammar.rules);
    QVERIFY2(grammar, test::why(grammar));
    const auto symbols = rewrite(*grammar, {row[1].toInt(), false, 1});
    QVERIFY2(symbols, test::why(symbols));
    const auto skeleton = runTurtle(*symbols, params->turtle);
    QVERIFY2(skeleton, test::why(skeleton));
    const SkeletonStats stats = skeletonStats(*skeleton);
    const SkeletonStats simplified = skeletonStats(simplify(*skeleton, 1e-4).skeleton);
    QCOMPARE(symbols->size(), row[2].toULongLong());
    const std::vector<std::pair<Index, int>> counts{{stats.branches, 3},        {stats.terminals, 4},
                                                    {stats.maxChildren, 5},     {simplified.branches, 14},
                                                    {simplified.terminals, 15}, {simplified.maxChildren, 16}};
    for (const auto& [count, column] : counts)
        QCOMPARE(count, Index(row[column].toUInt()));
    const std::vector<std::pair<double, int>> measures{
        {stats.totalLength, 6}, {stats.sumA1, 7},  {stats.min.x, 8},
        {stats.min.y, 9},       {stats.min.z, 10}, {stats.max.x, 11},
        {stats.max.y, 12},      {stats.max.z, 13}, {simplified.totalLength, 17},
        {simplified.sumA1, 18}};
    for (const auto& [measure, column] : measures)
        QVERIFY2(std::abs(measure - row[column].toDouble()) < 1e-4, qPrintable(row[column]));
}

RAMURE_SUITE(TestSimplify)

} // namespace tst_simplify

#include "tst_simplify.moc"
