#include "tests/widgets/base/fixture.h"
#include "widgets/base/hint_source.h"
#include "widgets/window/hint_line.h"
#include <QEnterEvent>
#include <QSignalSpy>

namespace tst_hint_line {

using namespace ramure;

/// The line of the status bar that says what mouse and keys do.
class TestHintLine : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWidgetWarning(); }
    void theWidgetUnderTheCursorSpeaks();
    void aGestureSpeaksWhereverTheCursorIs();
    void whatHasNoRoomIsInTheToolTip();
};

namespace {

void send(QWidget* widget, QEvent::Type type)
{
    QEvent event(type);
    QCoreApplication::sendEvent(widget, &event);
}

} // namespace

void TestHintLine::theWidgetUnderTheCursorSpeaks()
{
    HintLine line;
    QWidget left, right;
    HintSource of, other;
    line.addSource(&left, &of);
    line.addSource(&right, &other);
    of.say(QStringLiteral("left"));
    other.say(QStringLiteral("right"));
    QVERIFY(line.hint().isEmpty());
    QEnterEvent enter({}, {}, {});
    QCoreApplication::sendEvent(&left, &enter);
    QCOMPARE(line.hint(), QStringLiteral("left"));
    of.say(QStringLiteral("now this"));
    QCOMPARE(line.hint(), QStringLiteral("now this"));
    QCoreApplication::sendEvent(&right, &enter); // before the other is left
    QCOMPARE(line.hint(), QStringLiteral("right"));
    send(&left, QEvent::Leave);
    QCOMPARE(line.hint(), QStringLiteral("right"));
    send(&right, QEvent::Leave);
    QVERIFY(line.hint().isEmpty());
}

void TestHintLine::aGestureSpeaksWhereverTheCursorIs()
{
    HintLine line;
    QWidget widget;
    auto source = std::make_unique<HintSource>();
    line.addSource(&widget, source.get());
    QSignalSpy began(&line, &HintLine::gestureBegan);
    source->say(QStringLiteral("Move tree"));
    source->setGesture(true);
    QCOMPARE(line.hint(), QStringLiteral("Move tree"));
    QCOMPARE(began.count(), 1);
    source->setGesture(false);
    QVERIFY(line.hint().isEmpty());
    source.reset(); // goes before the line
    send(&widget, QEvent::Leave);
    QVERIFY(line.hint().isEmpty());
}

void TestHintLine::whatHasNoRoomIsInTheToolTip()
{
    HintLine line;
    QWidget widget;
    HintSource source;
    line.addSource(&widget, &source);
    const QString text = QStringLiteral("Click: branch and tree · drag: box · right: menu");
    source.say(text);
    source.setGesture(true);
    line.resize(2000, 24);
    line.show();
    QCOMPARE(line.text(), text);
    QVERIFY(line.toolTip().isEmpty());
    line.resize(100, 24);
    QVERIFY(line.text().endsWith(u'…'));
    QCOMPARE(line.toolTip(), text);
    QVERIFY(line.minimumSizeHint().width() < 20); // nothing else in the bar has to give way
}

RAMURE_SUITE(TestHintLine)

} // namespace tst_hint_line

#include "tst_hint_line.moc"
