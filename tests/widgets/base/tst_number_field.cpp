#include "tests/widgets/base/fixture.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include <QLineEdit>
#include <numbers>
#include <vector>

namespace tst_number_field {

using namespace ramure;

namespace {

NumberFormat lengthFormat()
{
    NumberFormat format;
    format.unit = ParamUnit::Metre;
    format.suffix = QStringLiteral(" m");
    return format;
}

} // namespace

class TestNumberField : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QLocale::setDefault(QLocale::c());
    }

    void textsOfNumbers_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("zero") << 0.0 << "0.00 m";
        QTest::newRow("usual") << 0.2 << "0.20 m";
        QTest::newRow("three digits at least") << 0.0001234 << "0.000123 m";
        QTest::newRow("no rest") << 0.0035 << "0.0035 m";
        QTest::newRow("least") << 1.5e-6 << "0.000002 m";
        QTest::newRow("rest of arithmetic") << 1.5e-12 << "0.00 m";
        QTest::newRow("rest below zero") << -1.94e-15 << "0.00 m";
        QTest::newRow("minus zero") << -0.0 << "0.00 m";
        QTest::newRow("rounds up") << 0.99996 << "1.00 m";
        QTest::newRow("large") << 12345.678 << "12345.68 m";
        QTest::newRow("huge") << 1e12 << "1e+12 m";
        QTest::newRow("negative") << -1.5 << "-1.50 m";
    }
    void textsOfNumbers()
    {
        QFETCH(const double, value);
        QFETCH(const QString, text);
        QCOMPARE(lengthFormat().text(value), text);
        const auto back = lengthFormat().parse(text);
        QVERIFY2(back, test::why(back).constData());
    }

    /// Rotations come from matrices, which leave rests.
    void restsOfRotationsAreZeroAndStay()
    {
        const ParamDef& def = *findParam("tree.rotation");
        const NumberFormat degrees = numberFormat(def, AngleUnit::Degrees);
        const double rest = 3.386e-17; // 1.94e-15 degrees
        QCOMPARE(degrees.text(rest), QStringLiteral("0.00°"));
        QCOMPARE(degrees.text(-rest), QStringLiteral("0.00°"));
        QCOMPARE(numberFormat(def, AngleUnit::Radians).text(-rest), QStringLiteral("0.00 rad"));
        QCOMPARE(degrees.text(1e-3 / degrees.factor), QStringLiteral("0.001°"));
        NumberField field;
        field.setFormat(degrees);
        field.setValue(-rest);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        for (const char* same : {"0", "0.00", "-0", "0.00 deg"}) {
            field.selectAll();
            QTest::keyClicks(&field, QLatin1String(same));
            QTest::keyClick(&field, Qt::Key_Return);
        }
        QCOMPARE(edited.count(), 0);
        QCOMPARE(field.value(), std::optional(-rest)); // exact all the same
    }

    void sharesAreShownInPerCent()
    {
        const NumberFormat format = numberFormat(*findParam("variation.angle"), AngleUnit::Degrees);
        QCOMPARE(format.text(0.05), QStringLiteral("5.0 %"));
        for (const char* text : {"5", "5 %", "2 % + 3", "10/2"})
            QCOMPARE(format.parse(QLatin1String(text)).value_or(-1.0), 0.05);
    }

    void badTextStaysUntilTheFocusGoes()
    {
        NumberField field;
        field.setFormat(lengthFormat());
        field.setValue(2.0);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        QSignalSpy refused(&field, &NumberField::refused);
        field.selectAll();
        QTest::keyClicks(&field, "2 cats");
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(refused.count(), 1);
        QVERIFY(!refused.back()[0].toString().isEmpty());
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.text(), QStringLiteral("2.00 m"));
        QVERIFY(refused.back()[0].toString().isEmpty());
    }

    void typingIsOneEdit()
    {
        NumberField field;
        field.setFormat(lengthFormat());
        field.setRange(0.0, 10.0);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        field.selectAll();
        QTest::keyClicks(&field, "20cm + 5mm");
        QCOMPARE(edited.count(), 0);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited.count(), 1);
        QVERIFY(std::abs(edited[0][0].toDouble() - 0.205) < 1e-12);
        QTest::keyClick(&field, Qt::Key_Return); // the same again is no edit
        QCOMPARE(edited.count(), 1);
    }

    void valuesAreHeldToTheRange()
    {
        NumberField field;
        field.setRange(-1.0, 3.0);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        field.selectAll();
        QTest::keyClicks(&field, "1000");
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited[0][0].toDouble(), 3.0);
        QCOMPARE(field.value(), std::optional(3.0));
    }

    void whatIsHeldBackIsSaid()
    {
        NumberField field;
        field.setFormat(lengthFormat());
        field.setRange(0.5, 3.0);
        field.setValue(1.0);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        QSignalSpy held(&field, &NumberField::held);
        const auto type = [&field](const char* text) {
            field.selectAll();
            QTest::keyClicks(&field, QLatin1String(text));
            QTest::keyClick(&field, Qt::Key_Return);
        };
        type("1000");
        QCOMPARE(edited.back()[0].toDouble(), 3.0);
        QCOMPARE(held.back()[0].toString(), QStringLiteral("the largest is 3.00 m"));
        type("1000"); // no other value, but it must be said again
        QCOMPARE(edited.count(), 1);
        QCOMPARE(held.count(), 2);
        type("-1");
        QCOMPARE(edited.back()[0].toDouble(), 0.5);
        QCOMPARE(held.back()[0].toString(), QStringLiteral("the smallest is 0.50 m"));
        type("2");
        QVERIFY(held.back()[0].toString().isEmpty());
        QCOMPARE(held.count(), 4);
        type("1");
        QCOMPARE(held.count(), 4); // nothing to take back
    }

    void typingWhatIsShownMeansThatValue()
    {
        NumberFormat degrees;
        degrees.unit = ParamUnit::Radian;
        degrees.factor = 180.0 / std::numbers::pi;
        degrees.suffix = QStringLiteral("°");
        NumberField field;
        field.setFormat(degrees);
        field.setDefault(0.3142); // shown as 18.00°, though 18° is 0.31415926...
        field.setValue(1.0);
        const auto type = [&field](const char* text) {
            field.selectAll();
            QTest::keyClicks(&field, QLatin1String(text));
            QTest::keyClick(&field, Qt::Key_Return);
            return field.value().value_or(0.0);
        };
        for (const char* text : {"18", "18 deg", "18.00", "9*2", "36/2 deg"}) {
            QCOMPARE(type(text), 0.3142);
            type("20");
        }
        QCOMPARE(type("18.0001"), 18.0001 / degrees.factor); // who writes more digits means them
        QVERIFY(type("20") != 0.3142);
        field.setValue(0.31415);
        QCOMPARE(type("18"), 0.31415); // what was shown already stays
        field.setValue(1.0);
        field.setDefault(std::nullopt);
        QCOMPARE(type("18"), 18.0 / degrees.factor);
    }

    void roundedDisplayNeverChangesTheValue()
    {
        NumberField field;
        field.setFormat(lengthFormat());
        field.setValue(0.31421234);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        field.show();
        QTest::keyClick(&field, Qt::Key_Return);
        field.clearFocus();
        QCOMPARE(edited.count(), 0);
        QCOMPARE(field.value(), std::optional(0.31421234));
    }

    void keysStep_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<double>("expected");
        QTest::newRow("up") << int(Qt::Key_Up) << int(Qt::NoModifier) << 5.5;
        QTest::newRow("down") << int(Qt::Key_Down) << int(Qt::NoModifier) << 4.5;
        QTest::newRow("fine") << int(Qt::Key_Up) << int(Qt::ShiftModifier) << 5.05;
        QTest::newRow("coarse") << int(Qt::Key_Up) << int(Qt::ControlModifier) << 10.0;
        QTest::newRow("page") << int(Qt::Key_PageDown) << int(Qt::NoModifier) << 0.0;
    }
    void keysStep()
    {
        QFETCH(const int, key);
        QFETCH(const int, modifiers);
        QFETCH(const double, expected);
        NumberField field;
        field.setStep(0.5);
        field.setValue(5.0);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        QTest::keyClick(&field, static_cast<Qt::Key>(key), static_cast<Qt::KeyboardModifiers>(modifiers));
        QCOMPARE(edited.count(), 1);
        QVERIFY(std::abs(edited[0][0].toDouble() - expected) < 1e-12);
    }

    /// The edits up to each end of a gesture, which is a step that can be undone.
    void whatIsTypedAndConfirmedIsAGestureOfItsOwn()
    {
        NumberField field;
        field.setFormat(lengthFormat());
        field.setRange(0.0, 100.0);
        field.setStep(1.0);
        field.setValue(2.0);
        std::vector<std::vector<double>> gestures(1);
        connect(&field, &NumberField::valueEdited, this,
                [&](double value) { gestures.back().push_back(value); });
        connect(&field, &NumberField::gestureEnded, this, [&] { gestures.emplace_back(); });
        QSignalSpy began(&field, &NumberField::gestureBegan);
        const auto type = [&field](const char* text) {
            field.selectAll();
            QTest::keyClicks(&field, QLatin1String(text));
            QTest::keyClick(&field, Qt::Key_Return);
        };
        type("x"); // refused: nothing to undo
        QTest::keyClick(&field, Qt::Key_Escape);
        QTest::keyClick(&field, Qt::Key_Return); // nothing typed
        QCOMPARE(gestures.size(), std::size_t(1));
        type("5");
        type("7");
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&field, Qt::Key_Up);
        QVERIFY((gestures == std::vector<std::vector<double>>{{5.0}, {7.0}, {8.0, 9.0, 10.0}}));
        QCOMPARE(began.size(), 2); // it goes on after each
    }

    void theWheelNeedsTheFocus()
    {
        QWidget window;
        auto* other = new QLineEdit(&window);
        auto* field = new NumberField(&window);
        field->setStep(1.0);
        field->move(0, 40);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        other->setFocus();
        QSignalSpy edited(field, &NumberField::valueEdited);
        const auto wheel = [&] {
            QWheelEvent event(QPointF(5, 5), field->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(field, &event);
            return event.isAccepted();
        };
        QVERIFY(!wheel());
        QCOMPARE(edited.count(), 0);
        field->setFocus();
        QVERIFY(wheel());
        QCOMPARE(edited.count(), 1);
    }

    void mixedValuesShowADash()
    {
        NumberField field;
        field.setValue(std::nullopt);
        QVERIFY(field.text().isEmpty());
        QCOMPARE(field.findChild<QLineEdit*>()->placeholderText(), QStringLiteral("—"));
        QSignalSpy edited(&field, &NumberField::valueEdited);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited.count(), 0);
        QTest::keyClicks(&field, "4");
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited[0][0].toDouble(), 4.0);
    }

    void sliderKeepsValuesItCannotShow()
    {
        NumberSlider slider;
        slider.setSoftRange(0.0, 1.0, 0.01, false);
        QSignalSpy edited(&slider, &NumberSlider::numberEdited);
        slider.setNumber(0.3142);
        slider.setNumber(17.0);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(slider.value(), slider.maximum());
        QTest::keyClick(&slider, Qt::Key_Left);
        QCOMPARE(edited.count(), 1);
        QVERIFY(std::abs(edited[0][0].toDouble() - 16.99) < 1e-9);
    }

    void sliderOfWholeNumbersStepsByOne()
    {
        NumberSlider slider;
        slider.setSoftRange(3, 32, 1, true);
        slider.setNumber(8.0);
        QSignalSpy edited(&slider, &NumberSlider::numberEdited);
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(edited.back()[0].toDouble(), 9.0);
        QTest::keyClick(&slider, Qt::Key_Home);
        QCOMPARE(edited.back()[0].toDouble(), 3.0);
        slider.setValue(slider.maximum() / 2);
        const double number = edited.back()[0].toDouble();
        QCOMPARE(number, std::round(number));
    }

    void wideSlidersAreLogarithmic()
    {
        NumberSlider slider;
        slider.setSoftRange(1e-4, 1e2, 0.01, false);
        slider.setNumber(0.1);
        QCOMPARE(slider.value(), slider.maximum() / 2);
    }
};

RAMURE_SUITE(TestNumberField)

} // namespace tst_number_field

#include "tst_number_field.moc"
