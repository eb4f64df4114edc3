#include "tests/support/suite.h"
#include "widgets/base/texts/time_text.h"
#include <QLocale>

namespace tst_time_text {

using namespace ramure;

class TestTimeText : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        test::failOnAnyWarning();
        QLocale::setDefault(QLocale::c());
    }
    void badTextsAreNoTimes_data();
    void badTextsAreNoTimes();
    void texts_data();
    void texts();
    void everyTextIsReadBack();
    void otherFormsAreUnderstood();
    void localeDecides();
};

void TestTimeText::badTextsAreNoTimes_data()
{
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"", " ", "abc", "1:2:3:4:5", "1:x", "1:-2", ":", "nan", "inf", "1e999", "--3", "3 m", "s"})
        QTest::newRow(text) << QString(text);
}

void TestTimeText::badTextsAreNoTimes()
{
    QFETCH(QString, text);
    for (const TimeDisplay display : {TimeDisplay::Frames, TimeDisplay::Seconds, TimeDisplay::Timecode})
        QVERIFY(!frameFromText(text, 24.0, display));
}

void TestTimeText::texts_data()
{
    QTest::addColumn<qint64>("frame");
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("display");
    QTest::addColumn<QString>("text");
    const int frames = int(TimeDisplay::Frames), seconds = int(TimeDisplay::Seconds),
              code = int(TimeDisplay::Timecode);
    QTest::newRow("frames") << qint64(48) << 24.0 << frames << "48";
    QTest::newRow("negative") << qint64(-3) << 24.0 << frames << "-3";
    QTest::newRow("seconds") << qint64(36) << 24.0 << seconds << "1.50 s";
    QTest::newRow("timecode") << qint64(24 * 3661 + 5) << 24.0 << code << "01:01:01:05";
    QTest::newRow("before zero") << qint64(-25) << 24.0 << code << "-00:00:01:01";
    QTest::newRow("a rate that is not whole") << qint64(30) << 29.97 << code << "00:00:01:00";
}

void TestTimeText::texts()
{
    QFETCH(qint64, frame);
    QFETCH(double, rate);
    QFETCH(int, display);
    QFETCH(QString, text);
    QCOMPARE(timeText(frame, rate, TimeDisplay(display)), text);
}

void TestTimeText::everyTextIsReadBack()
{
    for (const double rate : {24.0, 25.0, 29.97, 60.0})
        for (const TimeDisplay display : {TimeDisplay::Frames, TimeDisplay::Seconds, TimeDisplay::Timecode})
            for (const std::int64_t frame :
                 {-1000000L, -61L, -1L, 0L, 1L, 23L, 24L, 999L, 86399L, 1000000L}) {
                const auto read = frameFromText(timeText(frame, rate, display), rate, display);
                QVERIFY(read);
                QVERIFY(std::abs(*read - frame) <= (display == TimeDisplay::Seconds ? 1 : 0));
            }
}

void TestTimeText::otherFormsAreUnderstood()
{
    QCOMPARE(*frameFromText("2 s", 25.0, TimeDisplay::Frames), std::int64_t(50));
    QCOMPARE(*frameFromText("50 f", 25.0, TimeDisplay::Seconds), std::int64_t(50));
    QCOMPARE(*frameFromText("2:00", 25.0, TimeDisplay::Frames), std::int64_t(50));
    QCOMPARE(*frameFromText("1:00:00", 25.0, TimeDisplay::Seconds), std::int64_t(1500));
    QCOMPARE(*frameFromText(" 7 ", 25.0, TimeDisplay::Timecode), std::int64_t(7));
    QCOMPARE(*frameFromText("1e12", 25.0, TimeDisplay::Frames), mostFrame);
}

void TestTimeText::localeDecides()
{
    QLocale::setDefault(QLocale(QLocale::French));
    QCOMPARE(timeText(36, 24.0, TimeDisplay::Seconds), QStringLiteral("1,50 s"));
    QCOMPARE(*frameFromText("1,5", 24.0, TimeDisplay::Seconds), std::int64_t(36));
    QCOMPARE(*frameFromText("1.5", 24.0, TimeDisplay::Seconds), std::int64_t(36));
}

RAMURE_SUITE(TestTimeText)

} // namespace tst_time_text

#include "tst_time_text.moc"
