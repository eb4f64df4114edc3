#include "core/base/utf8.h"

#include "tests/support/suite.h"

namespace tst_utf8 {

using namespace ramure;

class TestUtf8 : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badBytes()
    {
        for (const char* text :
             {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3\x28", "\xE0\x80\x80", "\xE0\x9F\xBF",
              "\xE2\x82", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x80\x80\x80", "\xF0\x8F\xBF\xBF",
              "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE9t"}) {
            QCOMPARE(utf8Length(text), std::size_t(0));
            QVERIFY(!isUtf8(text));
            QVERIFY(!isUtf8(std::string("a").append(text)));
        }
        QCOMPARE(utf8Length(""), std::size_t(0));
        QVERIFY(isUtf8(""));
        QVERIFY(isUtf8(std::string("a\0b", 3)));
    }

    /// Every character is written as Qt does, and is one.
    void everyCharacter()
    {
        std::string all;
        for (char32_t character = 0; character <= 0x10FFFF; ++character) {
            if (character >= 0xD800 && character < 0xE000)
                continue;
            std::string bytes;
            appendUtf8(bytes, character);
            const bool isWhole = utf8Length(bytes) == bytes.size() && utf8Length(bytes + "x") == bytes.size();
            // Behind a letter: at the beginning of a text Qt takes U+FEFF for a byte order mark.
            if (!isWhole || QString::fromStdString("x" + bytes).toUcs4() != QList<uint>{'x', uint(character)})
                QFAIL(qPrintable(QString::number(character, 16)));
            all += bytes;
        }
        QVERIFY(isUtf8(all));
    }
};

RAMURE_SUITE(TestUtf8)

} // namespace tst_utf8

#include "tst_utf8.moc"
