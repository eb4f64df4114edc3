#include "core/generators/grammar/turtle.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tst_turtle {

using namespace ramure;

namespace {

const TurtleParams quarter{std::numbers::pi / 2, 1.0, 0.5};

bool near(const glm::dvec3& a, const glm::dvec3& b, double within = 1e-12)
{
    return glm::length(a - b) < within;
}

std::string randomBalanced(std::uint64_t seed, std::size_t length)
{
    static constexpr std::string_view alphabet = "F+-/\\^_[]";
    Random random(seed, RandomStream::Test);
    std::string text;
    int open = 0;
    while (text.size() < length) {
        const char symbol = alphabet[random.below(std::uint32_t(alphabet.size()))];
        if (symbol == ']' && open == 0)
            continue;
        open += (symbol == '[') - (symbol == ']');
        text += symbol;
    }
    return text + std::string(std::size_t(open), ']');
}

} // namespace

class TestTurtle : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void unbalancedBrackets_data();
    void unbalancedBrackets();
    void noBranchIsAnError();
    void badNumbersAreRefused();
    void limits();
    void cancelStops();
    void growsUp();
    void turns_data();
    void turns();
    void turnsArePostMultiplied();
    void bracketsRestoreEverything();
    void severalRoots();
    void levelsAndSources();
    void keysNameTheWay();
    void randomStrings();
    void randomBytesNeverCrash();
    void longRunsStayOrthonormal();
    void chanceWithoutVariationChangesNothing();
    void chanceStaysWithinItsShares();
    void branchesDrawByTheirKey();
    void badSharesAreRefused();
};

void TestTurtle::unbalancedBrackets_data()
{
    QTest::addColumn<QByteArray>("symbols");
    QTest::addColumn<int>("column");
    QTest::newRow("extra") << QByteArray("]") << 1;
    QTest::newRow("extra later") << QByteArray("F[+F]]F") << 6;
    QTest::newRow("open") << QByteArray("[") << 1;
    QTest::newRow("open inside") << QByteArray("F[+F[-F]") << 2;
    QTest::newRow("two open") << QByteArray("F[+F[-F") << 5;
    QTest::newRow("swapped") << QByteArray("F][F") << 2;
    QTest::newRow("far") << QByteArray(3'000'000, '+') + "]" << 3'000'001;
}

void TestTurtle::unbalancedBrackets()
{
    QFETCH(QByteArray, symbols);
    QFETCH(int, column);
    const auto skeleton = runTurtle(symbols.toStdString(), quarter);
    QVERIFY(!skeleton);
    QCOMPARE(skeleton.error().code, ErrorCode::Invalid);
    QCOMPARE(skeleton.error().column, column);
}

void TestTurtle::noBranchIsAnError()
{
    for (const char* symbols : {"", "+", "[]", "[+-/\\^_]"}) {
        const auto skeleton = runTurtle(symbols, quarter);
        QVERIFY(!skeleton);
        QCOMPARE(skeleton.error().code, ErrorCode::Invalid);
    }
}

void TestTurtle::badNumbersAreRefused()
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const TurtleParams& params :
         {TurtleParams{nan, 1, 1}, TurtleParams{1, nan, 1}, TurtleParams{1, 1, nan}, TurtleParams{inf, 1, 1},
          TurtleParams{1, inf, 1}, TurtleParams{1, 1, -inf}, TurtleParams{1, -1, 1},
          TurtleParams{1, 1, -0.5}}) {
        const auto skeleton = runTurtle("F", params);
        QVERIFY(!skeleton);
        QCOMPARE(skeleton.error().code, ErrorCode::Invalid);
    }
    QVERIFY(runTurtle("FF", {0.1, 0.0, 0.0}));
}

void TestTurtle::limits()
{
    const auto many = runTurtle(std::string(maxBranches + 1, 'F'), quarter);
    QVERIFY(!many);
    QCOMPARE(many.error().code, ErrorCode::Limit);
    const std::string deep =
        std::string(maxBracketDepth + 1, '[') + "F" + std::string(maxBracketDepth + 1, ']');
    const auto nested = runTurtle(deep, quarter);
    QVERIFY(!nested);
    QCOMPARE(nested.error().code, ErrorCode::Limit);
    QVERIFY(runTurtle(std::string_view(deep).substr(1, deep.size() - 2), quarter));
}

void TestTurtle::cancelStops()
{
    std::stop_source source;
    source.request_stop();
    const auto skeleton = runTurtle("F", quarter, {source.get_token(), {}});
    QVERIFY(!skeleton);
    QCOMPARE(skeleton.error().code, ErrorCode::Cancelled);
}

void TestTurtle::growsUp()
{
    const auto s = runTurtle("AB!", {0.3, 0.2, 0.9});
    QVERIFY2(s, test::why(s));
    QCOMPARE(s->size(), Index(3));
    QVERIFY(s->parent == std::vector<Index>({noIndex, 0, 1}));
    QVERIFY(s->p0[0] == glm::dvec3(0.0));
    QVERIFY(near(s->p1[2], {0, 0.6, 0}));
    QCOMPARE(s->a0[0], 0.2);
    QCOMPARE(s->a1[0], 0.2 * 0.9);
    QCOMPARE(s->a0[1], s->a1[0]);
    QCOMPARE(s->a1[2], 0.2 * 0.9 * 0.9 * 0.9);
}

void TestTurtle::turns_data()
{
    QTest::addColumn<QByteArray>("symbols");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    const auto row = [](const char* symbols, double x, double y, double z) {
        QTest::newRow(symbols) << QByteArray(symbols) << x << y << z;
    };
    // A right-handed quarter turn: about X it takes +Y to +Z, about Z to -X; about Y it leaves it.
    row("+F", 0, 0, 1);
    row("-F", 0, 0, -1);
    row("^F", -1, 0, 0);
    row("_F", 1, 0, 0);
    row("/F", 0, 1, 0);
    row("\\F", 0, 1, 0);
    row("/+F", 1, 0, 0);
    row("\\+F", -1, 0, 0);
    row("++F", 0, -1, 0);
    row("+-F", 0, 1, 0);
}

void TestTurtle::turns()
{
    QFETCH(QByteArray, symbols);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    const auto s = runTurtle(symbols.toStdString(), quarter);
    QVERIFY2(s, test::why(s));
    QVERIFY(near(s->p1[0], {x, y, z}));
}

void TestTurtle::turnsArePostMultiplied()
{
    // After +, the turtle's Z points down; a turn about its own Z goes to the side.
    const auto s = runTurtle("+^F", quarter);
    QVERIFY(near(s->p1[0], {-1, 0, 0}));
    const auto t = runTurtle("^+F", quarter);
    QVERIFY(near(t->p1[0], {0, 0, 1}));
}

void TestTurtle::bracketsRestoreEverything()
{
    const auto s = runTurtle("F[+FF]F", quarter);
    QVERIFY(s->parent == std::vector<Index>({noIndex, 0, 1, 0}));
    QVERIFY(near(s->p1[3], {0, 2, 0}));
    QCOMPARE(s->a0[3], 0.5);
    QCOMPARE(s->a0[1], 0.5);
}

void TestTurtle::severalRoots()
{
    const auto s = runTurtle("[F][+FF]-F", quarter);
    QVERIFY(s->parent == std::vector<Index>({noIndex, noIndex, 1, noIndex}));
    for (const Index root : {0u, 1u, 3u})
        QVERIFY(s->p0[root] == glm::dvec3(0.0) && s->a0[root] == 1.0);
    QCOMPARE(skeletonStats(*s).roots, Index(3));
}

void TestTurtle::levelsAndSources()
{
    const auto s = runTurtle("F[F[F]F]F", quarter);
    QVERIFY(s->level == std::vector<Index>({0, 1, 2, 1, 0}));
    QVERIFY(s->source == std::vector<Index>({0, 1, 2, 3, 4}));
}

void TestTurtle::keysNameTheWay()
{
    const auto s = runTurtle("F[+F[-F]F][F]F", quarter);
    const std::set<std::uint64_t> unique(s->key.begin(), s->key.end());
    QCOMPARE(unique.size(), std::size_t(s->size()));
    // A change beside a branch, or another angle, leaves its key as it is.
    const auto longer = runTurtle("F[+F[-FFF[F]]F][F]F", {0.1, 1.0, 0.9});
    QCOMPARE(longer->key[0], s->key[0]);
    QCOMPARE(longer->key[2], s->key[2]);
    QCOMPARE(longer->key.back(), s->key.back());
    // Files name branches by key: these numbers stay.
    QCOMPARE(s->key[0], mixBits(0x52616D757265ull + 0x9E3779B97F4A7C15ull));
    QCOMPARE(s->key[1], mixBits(s->key[0] + 0x9E3779B97F4A7C15ull));
    QCOMPARE(s->key[4], mixBits(s->key[0] + 2 * 0x9E3779B97F4A7C15ull));
}

void TestTurtle::randomStrings()
{
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const std::string symbols = randomBalanced(seed, 300);
        const auto branches = std::ranges::count(symbols, 'F');
        const auto s = runTurtle(symbols, {0.3, 0.2, 0.9});
        QVERIFY2(s, test::why(s));
        QCOMPARE(qsizetype(s->size()), qsizetype(branches));
        for (Index i = 0; i < s->size(); ++i) {
            const Index parent = s->parent[i];
            QVERIFY(parent == noIndex || parent < i);
            QVERIFY(s->p0[i] == (parent == noIndex ? glm::dvec3(0.0) : s->p1[parent]));
            QCOMPARE(s->a0[i], parent == noIndex ? 0.2 : s->a1[parent]);
            QVERIFY(std::abs(s->length(i) - 0.2) < 1e-12);
        }
    }
}

void TestTurtle::randomBytesNeverCrash()
{
    Random random(9, RandomStream::Test);
    for (int i = 0; i < 20'000; ++i) {
        std::string symbols(random.below(40), ' ');
        for (char& c : symbols)
            c = random.unit() < 0.4 ? "[]"[random.below(2)] : static_cast<char>(random.below(256));
        const auto s = runTurtle(symbols, quarter);
        QVERIFY(s || (s.error().code == ErrorCode::Invalid && s.error().column <= int(symbols.size())));
    }
}

void TestTurtle::longRunsStayOrthonormal()
{
    std::string symbols;
    for (int i = 0; i < 200'000; ++i)
        symbols += "+/^";
    const auto s = runTurtle(symbols + "F", {0.3142, 1.0, 1.0});
    QVERIFY(std::abs(s->length(0) - 1.0) < 1e-9);
}

void TestTurtle::chanceWithoutVariationChangesNothing()
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const std::string symbols = randomBalanced(seed, 300);
        QVERIFY(*runTurtle(symbols, {0.3, 0.2, 0.9}, {{0, 0, 0}, seed}) ==
                *runTurtle(symbols, {0.3, 0.2, 0.9}));
    }
}

void TestTurtle::chanceStaysWithinItsShares()
{
    const TurtleParams params{0.3, 0.2, 0.98};
    std::string symbols = "F";
    for (int i = 0; i < 500; ++i)
        symbols += "[+F]F";
    std::set<double> lengths, tapers, angles;
    const auto s = runTurtle(symbols, params, {{0.1, 0.2, 0.05}, 7});
    for (Index i = 0; i < s->size(); ++i) {
        const Index parent = s->parent[i];
        const double length = s->length(i), taper = s->a1[i] / s->a0[i];
        QVERIFY(std::abs(length - 0.2) <= 0.2 * 0.2 + 1e-12);
        QVERIFY(taper >= 0.98 * 0.95 - 1e-12 && taper <= 1.0); // no branch gets thicker towards its tip
        QVERIFY(parent == noIndex || (s->p0[i] == s->p1[parent] && s->a0[i] == s->a1[parent]));
        lengths.insert(length);
        tapers.insert(taper);
        if (s->level[i] == 0)
            continue;
        const glm::dvec3 along = (s->p1[i] - s->p0[i]) / length;
        const double angle = std::acos(along.y); // the trunk goes straight up: it makes no turn
        QVERIFY(std::abs(angle - 0.3) <= 0.3 * 0.1 + 1e-9);
        angles.insert(angle);
    }
    QVERIFY(lengths.size() > 900 && tapers.size() > 500 && angles.size() > 450);
    QVERIFY(*runTurtle(symbols, params, {{0.1, 0.2, 0.05}, 7}) == *s);
    QVERIFY(!(*runTurtle(symbols, params, {{0.1, 0.2, 0.05}, 8}) == *s));
}

void TestTurtle::branchesDrawByTheirKey()
{
    // More branches elsewhere, and more turns, leave the others as they are.
    const TurtleParams params{0.3, 0.2, 0.9};
    const TurtleChance chance{{0.2, 0.2, 0.2}, 3};
    const auto few = runTurtle("F[+F][-F]^F", params, chance);
    const auto many = runTurtle("F[+F[+F/F]F][-F]^F++F", params, chance);
    const auto sameKey = [&](Index i) {
        return Index(std::ranges::find(many->key, few->key[i]) - many->key.begin());
    };
    for (Index i = 0; i < few->size(); ++i) {
        const Index j = sameKey(i);
        QVERIFY(j < many->size());
        QVERIFY(few->p1[i] == many->p1[j] && few->a1[i] == many->a1[j]);
    }
    // Two turns in a row, and the same turn of two branches, are drawn apart.
    const auto turns = runTurtle("F[+F][+F]++F", params, chance);
    const auto tip = [&](Index i) { return turns->p1[i] - turns->p0[i]; };
    QVERIFY(!near(glm::normalize(tip(1)), glm::normalize(tip(2)), 1e-3));
}

void TestTurtle::badSharesAreRefused()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const VariationParams& shares :
         {VariationParams{-0.1, 0, 0}, VariationParams{0, 1.1, 0}, VariationParams{0, 0, nan}}) {
        const auto s = runTurtle("F", quarter, {shares, 1});
        QVERIFY(!s);
        QCOMPARE(s.error().code, ErrorCode::Invalid);
    }
}

RAMURE_SUITE(TestTurtle)

} // namespace tst_turtle

#include "tst_turtle.moc"
