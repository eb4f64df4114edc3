#include "tests/widgets/base/fixture.h"
#include "widgets/base/fields/number_drag.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/theme/ramure_style.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <numbers>

namespace tst_number_drag {

using namespace ramure;

namespace {

void send(QWidget* widget, QEvent::Type type, double x, Qt::KeyboardModifiers modifiers = {})
{
    const QPointF at(x, 0.5 * widget->height());
    const bool press = type == QEvent::MouseButtonPress, release = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, widget->mapToGlobal(at), press || release ? Qt::LeftButton : Qt::NoButton,
                      release ? Qt::NoButton : Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(widget, &event);
}

} // namespace

class TestNumberDrag : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QWidget> m_window;
    NumberField* m_field = nullptr;
    QLineEdit* m_text = nullptr;

    void dragBy(QWidget* widget, double pixels, Qt::KeyboardModifiers modifiers = {})
    {
        send(widget, QEvent::MouseButtonPress, 20, modifiers);
        send(widget, QEvent::MouseMove, 20 + 0.5 * pixels, modifiers);
        send(widget, QEvent::MouseMove, 20 + pixels, modifiers);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QLocale::setDefault(QLocale::c());
        m_window = std::make_unique<QWidget>();
        m_field = new NumberField(m_window.get());
        m_field->setGeometry(0, 40, 80, 24);
        m_field->setRange(-5.0, 5.0);
        m_field->setScale(NumberScale(0.0, 3.0, 0.1, false));
        m_field->setValue(1.0);
        m_text = m_field->findChild<QLineEdit*>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_field->clearFocus();
    }
    void cleanup() { m_window.reset(); }

    void draggingChangesTheNumber_data()
    {
        QTest::addColumn<double>("pixels");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<double>("expected");
        QTest::newRow("right") << 50.0 << int(Qt::NoModifier) << 1.5;
        QTest::newRow("left") << -50.0 << int(Qt::NoModifier) << 0.5;
        QTest::newRow("beyond the slider") << -150.0 << int(Qt::NoModifier) << -0.5;
        QTest::newRow("to the end") << 5000.0 << int(Qt::NoModifier) << 5.0;
        QTest::newRow("fine") << 50.0 << int(Qt::ShiftModifier) << 1.05;
        QTest::newRow("coarse") << 10.0 << int(Qt::ControlModifier) << 2.0;
    }
    void draggingChangesTheNumber()
    {
        QFETCH(const double, pixels);
        QFETCH(const int, modifiers);
        QFETCH(const double, expected);
        QSignalSpy began(m_field, &NumberField::gestureBegan), ended(m_field, &NumberField::gestureEnded);
        dragBy(m_text, pixels, static_cast<Qt::KeyboardModifiers>(modifiers));
        QCOMPARE(m_field->value().value_or(99.0), expected);
        QCOMPARE(ended.count(), 0);
        send(m_text, QEvent::MouseButtonRelease, 16 + pixels);
        QCOMPARE(began.count(), 1);
        QCOMPARE(ended.count(), 1);
        QVERIFY(!m_field->hasFocus()); // the next press drags again
    }

    void aKeyPressedOnTheWayMakesNoJump()
    {
        dragBy(m_text, 50.0);
        QCOMPARE(m_field->value(), std::optional(1.5));
        send(m_text, QEvent::MouseMove, 70, Qt::ShiftModifier);
        QCOMPARE(m_field->value(), std::optional(1.5));
        send(m_text, QEvent::MouseMove, 80, Qt::ShiftModifier);
        QCOMPARE(m_field->value(), std::optional(1.51));
        send(m_text, QEvent::MouseButtonRelease, 76);
    }

    void escapeGivesUp()
    {
        m_field->setValue(1.23456);
        QSignalSpy ended(m_field, &NumberField::gestureEnded);
        dragBy(m_text, 50.0);
        QVERIFY(m_field->value() != std::optional(1.23456));
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QCOMPARE(m_field->value(), std::optional(1.23456));
        QCOMPARE(ended.count(), 1);
        send(m_text, QEvent::MouseMove, 200);
        send(m_text, QEvent::MouseButtonRelease, 200);
        QCOMPARE(m_field->value(), std::optional(1.23456));
        QVERIFY(!m_field->hasFocus());
    }

    /// Undone under the mouse, a number is not dragged away again.
    void undoEndsTheDrag()
    {
        QSignalSpy edited(m_field, &NumberField::valueEdited), ended(m_field, &NumberField::gestureEnded);
        for (const Qt::KeyboardModifiers also : {Qt::NoModifier, Qt::ShiftModifier}) { // undo, redo
            m_field->setValue(1.0);
            dragBy(m_text, 50.0);
            edited.clear();
            ended.clear();
            QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | also);
            QCOMPARE(ended.count(), 1);
            send(m_text, QEvent::MouseMove, 200);
            send(m_text, QEvent::MouseButtonRelease, 200);
            QCOMPARE(edited.count(), 0);
            QCOMPARE(ended.count(), 1);
            m_field->clearFocus();
        }
    }

    void aClickEdits()
    {
        QSignalSpy edited(m_field, &NumberField::valueEdited);
        send(m_text, QEvent::MouseButtonPress, 20);
        send(m_text, QEvent::MouseMove, 21);
        send(m_text, QEvent::MouseButtonRelease, 21);
        QVERIFY(m_field->hasFocus());
        QCOMPARE(m_text->selectedText(), m_text->text());
        // Now the mouse marks text.
        send(m_text, QEvent::MouseButtonPress, 5);
        send(m_text, QEvent::MouseMove, 60);
        send(m_text, QEvent::MouseButtonRelease, 60);
        QCOMPARE(edited.count(), 0);
    }

    void theCursorTells()
    {
        QCOMPARE(m_text->cursor().shape(), Qt::SizeHorCursor);
        m_field->setFocus();
        QCOMPARE(m_text->cursor().shape(), Qt::IBeamCursor);
        m_field->clearFocus();
        QCOMPARE(m_text->cursor().shape(), Qt::SizeHorCursor);
        m_field->setValue(std::nullopt); // several values: there is nothing to start from
        QCOMPARE(m_text->cursor().shape(), Qt::IBeamCursor);
        dragBy(m_text, 50.0);
        send(m_text, QEvent::MouseButtonRelease, 66);
        QVERIFY(!m_field->value());
    }

    void aLabelIsAHandle()
    {
        auto* label = new QLabel(QStringLiteral("Length of a step"), m_window.get());
        label->setGeometry(0, 0, 100, 24);
        label->show();
        m_field->addHandle(label);
        QCOMPARE(label->cursor().shape(), Qt::SizeHorCursor);
        m_field->setFocus();
        QTest::keyClicks(m_field, "2"); // typed, and not yet entered: it is what the drag starts from
        m_text->selectAll();
        QTest::keyClicks(m_field, "2");
        dragBy(label, 50.0);
        send(label, QEvent::MouseButtonRelease, 66);
        QCOMPARE(m_field->value(), std::optional(2.5));
        m_field->clearFocus();
        QTest::mouseClick(label, Qt::LeftButton);
        QVERIFY(m_field->hasFocus());
    }

    void whatIsTypedElsewhereIsEntered()
    {
        auto* other = new NumberField(m_window.get());
        other->show();
        other->setFocus();
        QTest::keyClicks(other, "3");
        QSignalSpy edited(other, &NumberField::valueEdited);
        dragBy(m_text, 50.0);
        QCOMPARE(edited.count(), 1);
        send(m_text, QEvent::MouseButtonRelease, 66);
    }

    /// Also back from beyond the ends; Shift is for what is finer than a pixel.
    void theHandleStaysUnderTheMouse()
    {
        const ParamDef& def = *findParam("turtle.theta");
        NumberSlider slider;
        slider.resize(90, 24);
        slider.setSoftRange(def.softMin, def.softMax, def.step, false);
        slider.setNumber(0.15);
        slider.show();
        const double knob = 8.0 + 0.15 / def.softMax * (90 - 16);
        QSignalSpy edited(&slider, &NumberSlider::numberEdited);
        QSignalSpy ended(&slider, &NumberSlider::gestureEnded);
        const auto degrees = [&] { return edited.back()[0].toDouble() * 180.0 / std::numbers::pi; };
        send(&slider, QEvent::MouseButtonPress, knob);
        QCOMPARE(edited.count(), 0); // taken where it is
        send(&slider, QEvent::MouseMove, knob + 30);
        const double most = def.softMax * 180.0 / std::numbers::pi, perPixel = most / (90 - 16);
        const double before = 0.15 * 180.0 / std::numbers::pi;
        QVERIFY(std::abs(degrees() - before - 30 * perPixel) < perPixel);
        send(&slider, QEvent::MouseMove, 150); // beyond the end
        QVERIFY(std::abs(degrees() - most) < 1e-9);
        send(&slider, QEvent::MouseMove, knob + 10);
        QVERIFY(std::abs(degrees() - before - 10 * perPixel) < perPixel);
        send(&slider, QEvent::MouseMove, knob + 40, Qt::ShiftModifier); // ten times as fine
        QVERIFY(std::abs(degrees() - before - 13 * perPixel) < perPixel);
        QTest::keyClick(&slider, Qt::Key_Escape);
        QCOMPARE(edited.back()[0].toDouble(), 0.15);
        QCOMPARE(ended.count(), 1);
        send(&slider, QEvent::MouseButtonPress, 60); // a press beside it brings it there
        QVERIFY(degrees() > 40.0);
        QTest::keyClick(&slider, Qt::Key_Escape);
        QCOMPARE(edited.back()[0].toDouble(), 0.15);
    }

    void scalesFitTheirRange_data()
    {
        QTest::addColumn<double>("minimum");
        QTest::addColumn<double>("maximum");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("middle");
        QTest::newRow("linear") << -10.0 << 10.0 << 0.1 << 0.0;
        QTest::newRow("logarithm") << 0.01 << 1.0 << 0.01 << 0.1;
        QTest::newRow("cube") << 0.0 << 5000.0 << 10.0 << 625.0;
        QTest::newRow("few steps from 0") << 0.0 << 1.0 << 0.01 << 0.5;
    }
    void scalesFitTheirRange()
    {
        QFETCH(const double, minimum);
        QFETCH(const double, maximum);
        QFETCH(const double, step);
        QFETCH(const double, middle);
        const NumberScale scale(minimum, maximum, step, false);
        const double fine = 1e-9;
        QVERIFY(std::abs(scale.numberAt(0.5, fine) - middle) < 1e-6 * maximum);
        double before = scale.numberAt(-0.5, fine);
        for (int i = -9; i <= 30; ++i) { // beyond both ends too
            const double position = 0.05 * i, number = scale.numberAt(position, fine);
            QVERIFY(number > before);
            QVERIFY(std::abs(scale.positionOf(number) - position) < 1e-3);
            before = number;
        }
        QCOMPARE(scale.positionOf(minimum), 0.0);
        QVERIFY(std::abs(scale.positionOf(maximum) - 1.0) < 1e-12);
    }

    void draggedNumbersAreRound()
    {
        const NumberScale turn(0.0, std::numbers::pi / 3, 0.01, false);
        const double degrees = 180.0 / std::numbers::pi;
        for (int i = 0; i <= 300; ++i) {
            const double tenths = turn.numberAt(i / 300.0, 1.0 / 300.0, degrees) * degrees * 10.0;
            QVERIFY(std::abs(tenths - std::round(tenths)) < 1e-9);
        }
        QCOMPARE(NumberScale(0.0, 1.0, 0.01, false).numberAt(0.3, 1.0 / 300.0), 0.3); // as it is read
        QCOMPARE(NumberScale(3.0, 64.0, 1.0, true).numberAt(0.1, 1.0 / 300.0), 9.0);
    }

    void theWheelNeedsTheFocus()
    {
        RamureStyle style;
        QDoubleSpinBox number;
        QComboBox choice;
        choice.addItems({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")});
        choice.setCurrentIndex(1);
        for (QWidget* widget : std::initializer_list<QWidget*>{&number, &choice}) {
            widget->setParent(m_window.get());
            widget->setStyle(&style);
            widget->show();
            QVERIFY(widget->focusPolicy() == Qt::StrongFocus); // the wheel gives none
            m_window->setFocus();
            for (const bool focus : {false, true}) {
                if (focus)
                    widget->setFocus();
                QWheelEvent event(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, {0, 120},
                                  Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
                QCoreApplication::sendEvent(widget, &event);
                QCOMPARE(number.value() != 0.0 || choice.currentIndex() != 1, focus);
            }
            number.setValue(0.0);
            choice.setCurrentIndex(1);
        }
        number.setParent(nullptr);
        choice.setParent(nullptr);
    }
};

RAMURE_SUITE(TestNumberDrag)

} // namespace tst_number_drag

#include "tst_number_drag.moc"
