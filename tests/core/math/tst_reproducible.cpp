#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include "tests/support/suite.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tst_reproducible {

using namespace ramure;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

using OfTwo = double (*)(double x, double y);

/// A function, that of the C library in whose place it stands, and the hash of what it gives.
struct Function
{
    const char* name;
    OfTwo ours, theirs;
    double from, to; ///< of x; y is from -10 to 10
    std::uint64_t hash;
};
constexpr Function functions[] = {
    {"sin", [](double x, double) { return maths::sin(x); }, [](double x, double) { return std::sin(x); },
     -100.0, 100.0, 0xADA73E7EFEDC4B72},
    {"cos", [](double x, double) { return maths::cos(x); }, [](double x, double) { return std::cos(x); },
     -100.0, 100.0, 0xED3A19A925C42A4E},
    {"sine of both", [](double x, double) { return maths::sincos(x).sin; },
     [](double x, double) { return std::sin(x); }, -100.0, 100.0, 0xB4207BCB13BC0007},
    {"cosine of both", [](double x, double) { return maths::sincos(x).cos; },
     [](double x, double) { return std::cos(x); }, -100.0, 100.0, 0x11E481E09FA7E6C7},
    {"tan", [](double x, double) { return maths::tan(x); }, [](double x, double) { return std::tan(x); },
     -100.0, 100.0, 0xDDE7C776FE2044D7},
    {"asin", [](double x, double) { return maths::asin(x); }, [](double x, double) { return std::asin(x); },
     -1.0, 1.0, 0xF389214D77FBE995},
    {"acos", [](double x, double) { return maths::acos(x); }, [](double x, double) { return std::acos(x); },
     -1.0, 1.0, 0x0B89DFCC51793D2B},
    {"exp", [](double x, double) { return maths::exp(x); }, [](double x, double) { return std::exp(x); },
     -700.0, 700.0, 0xA3F5D277F13EE3EE},
    {"exp2", [](double x, double) { return maths::exp2(x); }, [](double x, double) { return std::exp2(x); },
     -1000.0, 1000.0, 0xC8558C0856C6C96D},
    {"log", [](double x, double) { return maths::log(x); }, [](double x, double) { return std::log(x); }, 0.0,
     1000.0, 0xE4BEC2B97E37924D},
    {"atan2", [](double x, double y) { return maths::atan2(x, y); },
     [](double x, double y) { return std::atan2(x, y); }, -10.0, 10.0, 0x6CB6EC8CBF190B41},
    {"pow", [](double x, double y) { return maths::pow(x, y); },
     [](double x, double y) { return std::pow(x, y); }, 0.0, 1000.0, 0xF61A2047A35EAACE},
    {"hypot", [](double x, double y) { return maths::hypot(x, y); },
     [](double x, double y) { return std::hypot(x, y); }, -10.0, 10.0, 0x5895FFF32B1FF226},
};

constexpr double special[] = {
    notANumber, infinity, -infinity, -0.0,   0.0,    1.0,    -1.0, 0.5,
    2.0,        -2.0,     1e300,     -1e300, 5e-324, 1e-310, 1e22, 0.5 * std::numbers::pi};

/// Both not a number, or at most two numbers apart: each may round one unit to its side. Zeros have signs.
bool isNear(double ours, double theirs)
{
    if (std::isnan(ours) || std::isnan(theirs))
        return std::isnan(ours) && std::isnan(theirs);
    if (ours == theirs)
        return std::signbit(ours) == std::signbit(theirs);
    const double next = std::nextafter(theirs, ours);
    return ours == next || ours == std::nextafter(next, ours);
}

QByteArray difference(const Function& f, double x, double y)
{
    const auto text = [](double number) { return QByteArray::number(number, 'g', 17); };
    return "of " + text(x) + ", " + text(y) + ": " + text(f.ours(x, y)) + ", not " + text(f.theirs(x, y));
}

constexpr int many = 100'000;

} // namespace

class TestReproducible : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void specialArguments_data() { rows(); }
    void specialArguments();
    void accuracy_data() { rows(); }
    void accuracy();
    void sameOnEveryProcessor_data() { rows(); }
    void sameOnEveryProcessor();
    void wholePowersOfTwoAreExact();
    void rotations();

private:
    static void rows();
};

void TestReproducible::rows()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(std::size(functions)); ++i)
        QTest::newRow(functions[i].name) << i;
}

void TestReproducible::specialArguments()
{
    QFETCH(int, number);
    const Function& f = functions[number];
    for (const double x : special)
        for (const double y : special)
            QVERIFY2(isNear(f.ours(x, y), f.theirs(x, y)), difference(f, x, y));
}

void TestReproducible::accuracy()
{
    QFETCH(int, number);
    const Function& f = functions[number];
    Random random(1, RandomStream::Test);
    for (int i = 0; i < many; ++i) {
        const double x = random.range(f.from, f.to), y = random.range(-10.0, 10.0);
        QVERIFY2(isNear(f.ours(x, y), f.theirs(x, y)), difference(f, x, y));
    }
}

/// If this fails, files of the same seed differ from those of yesterday, or of another machine.
void TestReproducible::sameOnEveryProcessor()
{
    QFETCH(int, number);
    const Function& f = functions[number];
    Random random(2, RandomStream::Test);
    StageHash hash(0);
    for (int i = 0; i < many; ++i) {
        const double x = random.range(f.from, f.to), y = random.range(-10.0, 10.0);
        hash.add(f.ours(x, y));
    }
    QCOMPARE(hash.value(), f.hash);
}

void TestReproducible::wholePowersOfTwoAreExact()
{
    for (int i = -1074; i < 1024; ++i)
        QCOMPARE(maths::exp2(i), std::ldexp(1.0, i));
}

void TestReproducible::rotations()
{
    QVERIFY(std::isnan(maths::angleAxis(notANumber, {0.0, 1.0, 0.0}).w));
    QCOMPARE(maths::angleAxis(0.0, {0.0, 1.0, 0.0}), glm::dquat(1.0, 0.0, 0.0, 0.0));
    const glm::dvec3 turned = maths::angleAxis(0.5 * std::numbers::pi, {0.0, 0.0, 1.0}) * glm::dvec3(1, 0, 0);
    QVERIFY(glm::length(turned - glm::dvec3(0.0, 1.0, 0.0)) < 1e-15);
}

RAMURE_SUITE(TestReproducible)

} // namespace tst_reproducible

#include "tst_reproducible.moc"
