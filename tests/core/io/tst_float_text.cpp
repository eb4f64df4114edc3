#include "core/io/float_text.h"
#include "tests/core/io/io_support.h"
#include <charconv>

namespace tst_float_text {

using namespace ramure;

namespace {

std::string written(float value)
{
    char buffer[maxFloatText];
    return {buffer, appendFloat(buffer, value)};
}

struct Scanned
{
    FloatScan result;
    float value = 0.0f;
    std::size_t length = 0;
};

Scanned scanned(const std::string& text)
{
    const char* at = text.data();
    Scanned out{};
    out.result = scanFloat(at, at + text.size(), out.value);
    out.length = static_cast<std::size_t>(at - text.data());
    return out;
}

/// What the standard library says: the same bits, no longer than its shortest text.
bool isRight(float value)
{
    char reference[64];
    const auto length =
        static_cast<std::size_t>(std::to_chars(reference, reference + 64, value).ptr - reference);
    const std::string text = written(value);
    float back = 0.0f;
    std::from_chars(text.data(), text.data() + text.size(), back);
    const Scanned own = scanned(text);
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return text.size() <= length && std::bit_cast<std::uint32_t>(back) == bits &&
           own.result == FloatScan::Ok && own.length == text.size() &&
           std::bit_cast<std::uint32_t>(own.value) == bits;
}

} // namespace

class TestFloatText : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoNumber()
    {
        for (const char* text : {"", "-", "+", ".", "-.", "e5", "x", "/", "--1", "-+1", "+-1", "++1"}) {
            const Scanned result = scanned(text);
            QVERIFY2(result.result == FloatScan::NoNumber, text);
            QCOMPARE(result.length, std::size_t(0));
        }
        for (const char* text : {"nan", "NaN", "-nan", "inf", "-INF", "Infinity", "1e39", "-3.5e38",
                                 "1e999999999", "340282356779733661637539395458142568448"})
            QVERIFY2(scanned(text).result == FloatScan::NotFinite, text);
    }
    void oddForms()
    {
        const auto is = [](const char* text, float value, std::size_t length) {
            const Scanned result = scanned(text);
            return result.result == FloatScan::Ok && result.value == value && result.length == length;
        };
        QVERIFY(is("+1", 1.0f, 2));
        QVERIFY(is("1.", 1.0f, 2));
        QVERIFY(is(".5", 0.5f, 2));
        QVERIFY(is("-.5e1", -5.0f, 5));
        QVERIFY(is("1E+2", 100.0f, 4));
        QVERIFY(is("1e", 1.0f, 1));
        QVERIFY(is("1e+", 1.0f, 1));
        QVERIFY(is("1.5.5", 1.5f, 3));
        QVERIFY(is("1e-50", 0.0f, 5));
        QVERIFY(is("0e999999999999", 0.0f, 14));
        QVERIFY(is("1e-999999999999", 0.0f, 15));
        QVERIFY(is("0.00000000000000000000000000000000000000000000000001", 0.0f, 52));
        QVERIFY(is("123456789012345678901234567890e-29", 1.23456789f, 34));
        QVERIFY(is("0.30000001192092895507812500000000000000000000001", 0.30000004f, 49) ||
                is("0.30000001192092895507812500000000000000000000001", 0.3f, 49));
    }
    /// Decimals that lie just beside the middle of two floats: the detour through double must not decide.
    void halfwayCases()
    {
        std::mt19937 random(3);
        for (int i = 0; i < 20'000; ++i) {
            const auto bits = static_cast<std::uint32_t>(random()) & 0x7FFFFFFFu;
            const float low = std::bit_cast<float>(bits);
            const float high = std::nextafter(low, HUGE_VALF);
            if (!std::isfinite(high))
                continue;
            const double middle = (double(low) + double(high)) / 2.0;
            char text[1200];
            const auto end = std::to_chars(text, text + 1100, middle, std::chars_format::fixed, 200).ptr;
            for (const char* extra : {"", "1"}) {
                std::string full(text, end);
                full += extra;
                float expected = 0.0f;
                const auto outcome = std::from_chars(full.data(), full.data() + full.size(), expected);
                if (outcome.ec != std::errc())
                    continue;
                QCOMPARE(scanned(full).value, expected);
            }
            const auto shortEnd = std::to_chars(text, text + 64, middle).ptr;
            float expected = 0.0f;
            if (std::from_chars(text, shortEnd, expected).ec == std::errc())
                QCOMPARE(scanned(std::string(text, shortEnd)).value, expected);
        }
    }
    void knownTexts()
    {
        QCOMPARE(written(0.0f), std::string("0"));
        QCOMPARE(written(-0.0f), std::string("-0"));
        QCOMPARE(written(1.0f), std::string("1"));
        QCOMPARE(written(-0.5f), std::string("-0.5"));
        QCOMPARE(written(0.1f), std::string("0.1"));
        QCOMPARE(written(3.1415927f), std::string("3.1415927"));
        QCOMPARE(written(123.25f), std::string("123.25"));
        QCOMPARE(written(0.001f), std::string("0.001"));
    }
    void everyExponentAndManyFractions()
    {
        std::mt19937 random(1);
        for (std::uint32_t exponent = 0; exponent < 255; ++exponent)
            for (int i = 0; i < 1500; ++i) {
                std::uint32_t fraction = static_cast<std::uint32_t>(random()) & 0x7FFFFFu;
                if (i < 6)
                    fraction =
                        i < 3 ? static_cast<std::uint32_t>(i) : 0x7FFFFFu - static_cast<std::uint32_t>(i - 3);
                const float value = std::bit_cast<float>(exponent << 23 | fraction);
                QVERIFY2(isRight(value), QByteArray::number(double(value), 'g', 12));
                QVERIFY(isRight(-value));
            }
    }
    void decimalsPeopleWrite()
    {
        for (int i = 0; i < 200'000; ++i) {
            const float value = static_cast<float>(i) / 1000.0f;
            if (!isRight(value))
                QFAIL(QByteArray::number(double(value)).constData());
        }
    }
    void indices()
    {
        const auto text = [](Index value) {
            char buffer[maxIndexText];
            return std::string(buffer, appendIndex(buffer, value));
        };
        for (Index value = 0; value < 200'000; value += 7)
            QCOMPARE(text(value), std::to_string(value));
        for (Index power = 1; power <= 1'000'000'000; power *= 10) {
            QCOMPARE(text(power - 1), std::to_string(power - 1));
            QCOMPARE(text(power), std::to_string(power));
            if (power == 1'000'000'000)
                break;
        }
        QCOMPARE(text(noIndex), std::string("4294967295"));
    }
    void wholeNumbers()
    {
        const auto is = [](const std::string& text, std::int64_t value, std::size_t length) {
            const char* at = text.data();
            std::int64_t read = 0;
            return scanWhole(at, at + text.size(), read) && read == value && at == text.data() + length;
        };
        QVERIFY(is("0", 0, 1) && is("-12/", -12, 3) && is("+7.5", 7, 2));
        QVERIFY(is("9999999999999999", largestScanned, 16) &&
                is("-99999999999999999999", -largestScanned, 21));
        for (const std::string text : {"", "-", "+", "+-1", "-+1", "x", ".5"}) {
            const char* at = text.data();
            std::int64_t read = 0;
            QVERIFY(!scanWhole(at, at + text.size(), read) && at == text.data());
        }
    }
};

RAMURE_SUITE(TestFloatText)

} // namespace tst_float_text

#include "tst_float_text.moc"
