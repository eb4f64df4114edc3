#include "tests/support/suite.h"
#include "widgets/view/viewport_hint.h"

using namespace ramure;
using Under = ViewportSituation::Under;

/// The line that says what the mouse and Shift, Ctrl, Alt do in the viewport.
class TestViewportHint : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void itSpeaksOfWhatIsUnderTheCursor();
    void itFollowsTheHeldKeys();
    void whatActsOnTheTreeSaysSoFirst();
    void everyGestureSaysHowItEnds();
};

namespace {

bool says(const ViewportSituation& now, const char* what)
{
    return viewportHint(now).contains(QLatin1String(what));
}

} // namespace

void TestViewportHint::itSpeaksOfWhatIsUnderTheCursor()
{
    ViewportSituation now;
    QVERIFY(!says(now, "bend"));
    QVERIFY(says(now, "right: menu"));
    now.under = Under::Branch;
    QVERIFY(says(now, "Ctrl + drag: bend the limb"));
    now.playing = true;
    QVERIFY(says(now, "pull the branch"));
    QVERIFY(!says(now, "bend"));
    now.playing = false;
    now.under = Under::Surface;
    QVERIFY(says(now, "target of the arm"));
    now.under = Under::Ring;
    QVERIFY(says(now, "turn the joint"));
    // A press is no box yet.
    now.under = Under::Branch;
    const QString rest = viewportHint(now);
    now.gesture = Gesture::Select;
    QCOMPARE(viewportHint(now), rest);
    now.dragging = true;
    QVERIFY(says(now, "box"));
}

void TestViewportHint::itFollowsTheHeldKeys()
{
    ViewportSituation now;
    now.under = Under::Branch;
    now.held = Qt::ControlModifier;
    QVERIFY(says(now, "Ctrl: drag bends the limb"));
    QVERIFY(says(now, "Ctrl + middle"));
    now.style = NavigationStyle::Maya;
    QVERIFY(!says(now, "middle"));
    now.held = Qt::AltModifier;
    QVERIFY(says(now, "middle: moves"));
    now.held = Qt::ShiftModifier;
    QVERIFY(says(now, "adds"));
}

void TestViewportHint::whatActsOnTheTreeSaysSoFirst()
{
    ViewportSituation now;
    now.under = Under::Branch;
    now.target = QStringLiteral("tree");
    now.keys = QStringLiteral("G R S");
    QVERIFY(says(now, "G R S: move, rotate, scale tree"));
}

void TestViewportHint::everyGestureSaysHowItEnds()
{
    ViewportSituation now;
    for (const Gesture gesture : {Gesture::Pull, Gesture::Wind, Gesture::Aim, Gesture::Ring}) {
        now.gesture = gesture;
        QVERIFY(says(now, "release"));
    }
    now.gesture = Gesture::Limb;
    QVERIFY(says(now, "wheel") && says(now, "Shift: ") && says(now, "Esc"));
    const QString light = viewportHint(now);
    now.wholeLimb = true;
    QVERIFY(viewportHint(now) != light);
}

QTEST_GUILESS_MAIN(TestViewportHint)
#include "tst_viewport_hint.moc"
