#include "core/base/plain_text.h"
#include "tests/support/suite.h"

namespace tst_plain_text {

using namespace ramure;

namespace {

std::string utf16(std::u16string_view text, bool isBig)
{
    std::string out = isBig ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t unit : text) {
        const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
        out += {isBig ? high : low, isBig ? low : high};
    }
    return out;
}

std::string plain(const std::string& bytes)
{
    return std::string(PlainText(bytes).view());
}

} // namespace

class TestPlainText : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void emptyAndCutOff()
    {
        for (const char* bytes : {"", "\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF", "\xFF\xFE\x41", "\x1A"})
            QCOMPARE(plain(bytes), std::string());
        QVERIFY(!TextLines("").next());
        QCOMPARE(PlainText(std::string_view("\0\0\x1A\0", 4)).padding(), std::size_t(4));
    }
    void halvesOfPairsBecomeTheReplacementCharacter()
    {
        const char16_t high = 0xD83C, low = 0xDF33;
        QCOMPARE(plain(utf16(std::u16string{high, low}, false)), std::string("\xF0\x9F\x8C\xB3"));
        QCOMPARE(plain(utf16(std::u16string{high, u'a'}, true)), std::string("\xEF\xBF\xBD"
                                                                             "a"));
        QCOMPARE(plain(utf16(std::u16string{low}, true)), std::string("\xEF\xBF\xBD"));
        QCOMPARE(plain(utf16(std::u16string{high}, false)), std::string("\xEF\xBF\xBD"));
    }
    void whatIsTorn()
    {
        const auto isWhole = [](const std::string& bytes) { return PlainText(bytes).isWhole(); };
        QVERIFY(isWhole("") && isWhole("\xC3") && isWhole(utf16(u"a\U0001F333", true)));
        QVERIFY(!isWhole(utf16(u"a", false) + 'b'));
        QVERIFY(!isWhole(utf16(std::u16string{0xDF33}, true)));
        QVERIFY(!isWhole(utf16(std::u16string{u'a', 0xD83C}, false)));
    }
    void utf16WithoutMark()
    {
        QVERIFY(isUtf16(std::string("a\0,\0", 4)) && isUtf16(std::string("\0a\0,", 4)));
        QVERIFY(isUtf16(std::string("a\0\x33\xD8", 4)));
        // Padding, and bytes that are no text.
        for (const std::size_t length : {0, 1, 2, 3, 4})
            QVERIFY(!isUtf16({"a\0\0\0", length}) && !isUtf16({"\0\0\0a", length}));
    }
    /// One text, as systems and programs write it.
    void everyFormOfTheSameText_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* name, const std::string& bytes) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes);
        };
        row("plain", "one\n\ntwo \xC3\xA9\nthree");
        row("ended", "one\n\ntwo \xC3\xA9\nthree\n");
        row("DOS", "one\r\n\r\ntwo \xC3\xA9\r\nthree\r\n\x1A");
        row("Macintosh", "one\r\rtwo \xC3\xA9\rthree\r");
        row("mixed", "one\r\n\rtwo \xC3\xA9\nthree");
        row("mark", "\xEF\xBB\xBFone\n\ntwo \xC3\xA9\nthree");
        row("padded", std::string("one\n\ntwo \xC3\xA9\nthree\n\0\0\0\0", 22));
        row("UTF-16", utf16(u"one\n\ntwo \u00E9\nthree", false));
        row("UTF-16 without a mark", utf16(u"one\n\ntwo \u00E9\nthree", false).substr(2));
        row("UTF-16, big, without a mark", utf16(u"one\n\ntwo \u00E9\nthree", true).substr(2));
        row("UTF-16, big", utf16(u"one\r\n\r\ntwo \u00E9\r\nthree\r\n", true));
    }
    void everyFormOfTheSameText()
    {
        QFETCH(const QByteArray, bytes);
        const PlainText text({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        QStringList found;
        for (TextLines lines(text.view()); lines.next();) {
            QCOMPARE(lines.number(), int(found.size()) + 1);
            found << QString::fromUtf8(lines.line().data(), qsizetype(lines.line().size()));
        }
        QCOMPARE(found, QStringList({"one", "", QString::fromUtf8("two \xC3\xA9"), "three"}));
    }
    void whatIsPlainIsNotCopied()
    {
        const std::string text = "a\r\nb\n";
        QCOMPARE(static_cast<const void*>(PlainText(text).view().data()),
                 static_cast<const void*>(text.data()));
    }
    void capitals()
    {
        QCOMPARE(lowered("Newmtl_1 \xC3\x89"), std::string("newmtl_1 \xC3\x89"));
        QVERIFY(isWord("KD", "kd") && isWord("kd", "kd"));
        QVERIFY(!isWord("kdd", "kd") && !isWord("k", "kd") && !isWord("k[", "k{"));
    }
};

RAMURE_SUITE(TestPlainText)

} // namespace tst_plain_text

#include "tst_plain_text.moc"
