#include "tests/support/suite.h"
#include "widgets/view/tools/typed_number.h"
#include <QLocale>

namespace tst_typed_number {

using namespace ramure;

class TestTypedNumber : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    /// Both keys are taken everywhere; what is shown is what the language writes.
    void thePointIsThatOfTheLanguage_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<QString>("shown");
        QTest::newRow("English") << QLocale(QLocale::English) << QStringLiteral("−0.25");
        QTest::newRow("French") << QLocale(QLocale::French) << QStringLiteral("−0,25");
    }
    void thePointIsThatOfTheLanguage()
    {
        QFETCH(QLocale, locale);
        QFETCH(QString, shown);
        QLocale::setDefault(locale);
        for (const QString& keys : {QStringLiteral("-0.25"), QStringLiteral("-0,25")}) {
            TypedNumber number;
            for (const QChar key : keys)
                QVERIFY(number.type(key));
            QCOMPARE(number.text(), shown);
            QCOMPARE(number.value().value_or(0.0), -0.25);
        }
    }
};

RAMURE_SUITE(TestTypedNumber)

} // namespace tst_typed_number

#include "tst_typed_number.moc"
