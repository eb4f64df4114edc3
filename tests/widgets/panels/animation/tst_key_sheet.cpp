#include "tests/widgets/panels/animation/key_fixture.h"
#include "widgets/base/empty_page.h"
#include <QAbstractButton>
#include <QComboBox>

namespace tst_key_sheet {

using namespace ramure;
using test::KeyDock;
using Frames = std::vector<double>;

/// The dope sheet by mouse and keyboard. Rows of keyScene(2, ...): 0 all, 1 node, 2 location X, 3 location Y.
class TestKeySheet : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }
    void nothingThereIsSaid();
    void lockedNodesRefuse();
    void timesBeyondTheRangeAreRefused();
    void emptyCommandsMakeNoStep();
    void clicksSelect();
    void boxesAndColumnsSelect();
    void aDragIsOneStepAtItsEnd();
    void escapeGivesUp();
    void dragsSnapToFramesAndSeconds();
    void controlDragCopies();
    void edgesScale();
    void scalingBeyondTheOtherEndMirrors();
    void keysTakeThePlaceOfOthers();
    void copiesArePastedAtThePlayheadAndInPlace();
    void copiesOfOneNodeGoToOthers();
    void mirroringTwiceChangesNothing();
    void modesOfManyKeys();
    void keysAreInsertedAndFound();
    void rowsFollowTheSelection();
    void theCurrentRowStaysTheSame();
    void everythingByKeys();
    void randomGesturesAreUndone();
    void everythingHasAToolTip();
};

void TestKeySheet::nothingThereIsSaid()
{
    KeyDock dock{Scene()};
    QVERIFY(dock.panel.findChild<EmptyPage*>() == nullptr || !dock.sheet()->isVisible());
    QSignalSpy said(&dock.commands, &KeyCommands::messageRaised);
    dock.commands.insert(KeyParts::Transform); // no node
    dock.commands.remove();
    dock.commands.paste(false);
    dock.commands.seekKey(true);
    dock.commands.removeAtPlayhead();
    QCOMPARE(said.count(), 5);
    QCOMPARE(dock.steps(), 0);
    QTest::keyClick(dock.sheet(), Qt::Key_Right);
    QTest::keyClick(dock.sheet(), Qt::Key_Down);
    dock.dragMouse({10, 30}, {200, 80});
    dock.sheet()->fit();
}

void TestKeySheet::lockedNodesRefuse()
{
    Scene scene = test::keyScene(2, 5);
    scene.find(scene.nodes().front().id)->locked = true;
    KeyDock dock(scene);
    const QByteArray before = dock.bytes();
    QSignalSpy said(&dock.commands, &KeyCommands::messageRaised);
    dock.commands.selectAll();
    dock.commands.remove();
    dock.commands.setMode(KeyMode::Linear);
    dock.commands.nudge(1);
    dock.commands.insert(KeyParts::Scale);
    QCOMPARE(said.count(), 4);
    QCOMPARE(dock.bytes(), before);
    QCOMPARE(dock.steps(), 0);
}

void TestKeySheet::timesBeyondTheRangeAreRefused()
{
    KeyDock dock(test::keyScene(2, 5));
    const QByteArray before = dock.bytes();
    QSignalSpy said(&dock.commands, &KeyCommands::messageRaised);
    dock.commands.selectAll();
    dock.commands.retime({0, 1.0, mostTicks}, false);
    dock.commands.retime({0, 1e12, 0}, false);
    dock.commands.retime({0, -1e300, 0}, true);
    QCOMPARE(said.count(), 3);
    QCOMPARE(dock.bytes(), before);
}

void TestKeySheet::emptyCommandsMakeNoStep()
{
    KeyDock dock(test::keyScene(2, 5));
    dock.commands.selectAll();
    dock.commands.setMode(KeyMode::Bezier);
    dock.commands.setEasing(Easing::Auto);
    dock.commands.snap(KeySnap::Frame);
    dock.dragMouse(dock.at(2, 1), dock.at(2, 1));
    QCOMPARE(dock.steps(), 0);
}

void TestKeySheet::clicksSelect()
{
    KeyDock dock(test::keyScene(2, 5, 10));
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, {}, dock.at(2, 10));
    QCOMPARE(dock.selected(), 1u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, Qt::ShiftModifier, dock.at(3, 20));
    QCOMPARE(dock.selected(), 2u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, Qt::ShiftModifier, dock.at(3, 20));
    QCOMPARE(dock.selected(), 1u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, {}, dock.at(0, 30)); // all keys of the summary
    QCOMPARE(dock.selected(), 2u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, {}, dock.at(2, 30)); // one of them
    QCOMPARE(dock.selected(), 1u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, {}, dock.at(2, 15)); // none
    QCOMPARE(dock.selected(), 0u);
    QTest::mouseClick(dock.panel.names(), Qt::LeftButton, {}, {100, dock.at(3, 0).y()});
    QCOMPARE(dock.selected(), 5u);
    QCOMPARE(dock.steps(), 0);
}

void TestKeySheet::boxesAndColumnsSelect()
{
    KeyDock dock(test::keyScene(2, 5, 10));
    dock.dragMouse(dock.at(2, 5), dock.at(2, 25));
    QCOMPARE(dock.selected(), 2u);
    dock.dragMouse(dock.at(3, 45), dock.at(3, 25), Qt::ShiftModifier);
    QCOMPARE(dock.selected(), 4u);
    QTest::mouseClick(dock.sheet(), Qt::LeftButton, Qt::AltModifier, dock.at(2, 40));
    QCOMPARE(dock.selected(), 2u);
    dock.player.seek(20);
    dock.commands.selectBefore();
    QCOMPARE(dock.selected(), 6u);
    dock.commands.selectBehind();
    QCOMPARE(dock.selected(), 6u);
    dock.commands.selectColumn();
    QCOMPARE(dock.selected(), 2u);
}

void TestKeySheet::aDragIsOneStepAtItsEnd()
{
    KeyDock dock(test::keyScene(2, 5, 10));
    const QByteArray before = dock.bytes();
    dock.dragMouse(dock.at(1, 20), dock.at(1, 27), {}, false);
    QCOMPARE(dock.bytes(), before); // a preview only
    QTest::mouseRelease(dock.sheet(), Qt::LeftButton, {}, dock.at(1, 27));
    QCOMPARE(dock.steps(), 1);
    QCOMPARE(dock.frames(2), (Frames{0, 10, 27, 30, 40}));
    QCOMPARE(dock.frames(3), (Frames{0, 10, 27, 30, 40}));
    QCOMPARE(dock.selected(), 2u); // still the dragged ones
    dock.document.undo();
    QCOMPARE(dock.bytes(), before);
}

void TestKeySheet::escapeGivesUp()
{
    KeyDock dock(test::keyScene(2, 5, 10));
    const QByteArray before = dock.bytes();
    dock.dragMouse(dock.at(1, 20), dock.at(1, 27), {}, false);
    QTest::keyClick(dock.sheet(), Qt::Key_Escape);
    QTest::mouseRelease(dock.sheet(), Qt::LeftButton, {}, dock.at(1, 27));
    QCOMPARE(dock.bytes(), before);
    QCOMPARE(dock.steps(), 0);
}

void TestKeySheet::dragsSnapToFramesAndSeconds()
{
    KeyDock dock(test::keyScene(1, 3, 10));
    dock.commands.setSnapping(KeySnap::Second);
    dock.dragMouse(dock.at(2, 10), dock.at(2, 21));
    QCOMPARE(dock.frames(2), (Frames{0, 20, 24}));
    dock.dragMouse(dock.at(2, 24), dock.at(2, 24) + QPoint(4, 0), Qt::ShiftModifier); // Shift toggles a key
    QCOMPARE(dock.selected(), 0u);
    dock.commands.setSnapping(KeySnap::None);
    dock.dragMouse(dock.at(2, 24), dock.at(2, 24) + QPoint(20, 0));
    QVERIFY(dock.frames(2).back() != std::round(dock.frames(2).back()));
    dock.commands.snap(KeySnap::Frame);
    QCOMPARE(dock.frames(2).back(), std::round(dock.frames(2).back()));
}

void TestKeySheet::controlDragCopies()
{
    KeyDock dock(test::keyScene(1, 3, 10));
    dock.dragMouse(dock.at(2, 10), dock.at(2, 35), Qt::ControlModifier);
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20, 35}));
    QCOMPARE(dock.steps(), 1);
    QCOMPARE(dock.selected(), 1u);
    dock.commands.duplicate();
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20, 35, 36}));
}

void TestKeySheet::edgesScale()
{
    KeyDock dock(test::keyScene(1, 3, 10));
    dock.commands.selectAll();
    const auto edge = [&](double frame) { return QPoint(dock.at(0, frame).x(), KeySheet::strip / 2); };
    dock.dragMouse(edge(20), edge(40));
    QCOMPARE(dock.frames(2), (Frames{0, 20, 40}));
    QCOMPARE(dock.steps(), 1);
    dock.dragMouse(edge(0), edge(20));
    QCOMPARE(dock.frames(2), (Frames{20, 30, 40}));
    dock.dragMouse(edge(20), edge(40)); // onto the other end: never to one time, never NaN
    QCOMPARE(dock.frames(2).size(), std::size_t(3));
}

void TestKeySheet::scalingBeyondTheOtherEndMirrors()
{
    KeyDock dock(test::keyScene(1, 3, 10));
    dock.commands.selectAll();
    const auto edge = [&](double frame) { return QPoint(dock.at(0, frame).x(), KeySheet::strip / 2); };
    dock.panel.ruler()->showFrames(-60.0, 60.0);
    const auto values = [&] {
        std::vector<double> result;
        for (const Key& key :
             std::get<Track>(*keys::find(dock.document.scene(), dock.model.tracks()[0])).keys())
            result.push_back(key.value);
        return result;
    };
    std::vector<double> before = values();
    dock.dragMouse(edge(20), edge(-20));
    QCOMPARE(dock.frames(2), (Frames{-20, -10, 0}));
    std::reverse(before.begin(), before.end());
    QCOMPARE(values(), before);
}

void TestKeySheet::keysTakeThePlaceOfOthers()
{
    KeyDock dock(test::keyScene(1, 3, 10));
    dock.dragMouse(dock.at(2, 10), dock.at(2, 20));
    QCOMPARE(dock.frames(2), (Frames{0, 20}));
    dock.document.undo();
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20}));
}

void TestKeySheet::copiesArePastedAtThePlayheadAndInPlace()
{
    KeyDock dock(test::keyScene(2, 3, 10));
    dock.player.seek(10);
    dock.commands.selectBehind();
    dock.commands.copy();
    dock.player.seek(50);
    dock.commands.paste(false);
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20, 50, 60}));
    QCOMPARE(dock.selected(), 4u);
    dock.commands.selectAll();
    dock.commands.remove();
    QVERIFY(dock.model.rows().empty());
    dock.commands.paste(true);
    QCOMPARE(dock.frames(3), (Frames{10, 20}));
    QCOMPARE(dock.steps(), 3);
}

void TestKeySheet::copiesOfOneNodeGoToOthers()
{
    KeyDock dock(test::keyScene(20, 3, 10));
    const NodeId first = dock.document.scene().nodes()[0].id, second = dock.document.scene().nodes()[1].id;
    dock.document.setSelection({{first}, noNode, {}, noIndex});
    dock.commands.selectAll();
    dock.commands.copy();
    dock.document.setSelection({{second}, noNode, {}, noIndex});
    dock.player.seek(30);
    dock.commands.paste(false);
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20, 30, 40, 50}));
    dock.document.setSelection({{first}, noNode, {}, noIndex});
    QCOMPARE(dock.frames(2), (Frames{0, 10, 20}));
}

void TestKeySheet::mirroringTwiceChangesNothing()
{
    KeyDock dock(test::keyScene(9, 5, 10));
    dock.commands.selectAll();
    dock.commands.setMode(KeyMode::Quad);
    dock.commands.setEasing(Easing::In);
    const auto channel = dock.model.tracks()[0];
    const auto at = [&](double frame) {
        return valueAt(std::get<Track>(*keys::find(dock.document.scene(), channel)), frame / 24.0);
    };
    std::vector<double> before;
    for (int i = 0; i <= 40; ++i)
        before.push_back(at(i));
    dock.player.seek(20);
    dock.commands.mirror();
    for (int i = 0; i <= 40; ++i)
        QVERIFY(std::abs(at(40 - i) - before[std::size_t(i)]) < 1e-12);
    dock.commands.mirror();
    for (int i = 0; i <= 40; ++i)
        QVERIFY(std::abs(at(i) - before[std::size_t(i)]) < 1e-12);
}

void TestKeySheet::modesOfManyKeys()
{
    KeyDock dock(test::keyScene(100, 10));
    dock.commands.selectAll();
    QCOMPARE(dock.selected(), 1000u);
    for (int i = 0; i < keyModeCount; ++i) {
        dock.commands.setMode(static_cast<KeyMode>(i));
        for (const KeyRow& row : dock.model.rows())
            for (const KeyMode mode : row.modes)
                QCOMPARE(mode, static_cast<KeyMode>(i));
    }
    dock.commands.setHandles(HandleType::Vector);
    dock.commands.extrapolate(true, true, Extrapolation::Mirror);
    const QByteArray after = dock.bytes();
    const int steps = dock.steps();
    QCOMPARE(steps, keyModeCount + 2);
    for (int i = 0; i < steps; ++i)
        dock.document.undo();
    for (int i = 0; i < steps; ++i)
        dock.document.redo();
    QCOMPARE(dock.bytes(), after);
}

void TestKeySheet::keysAreInsertedAndFound()
{
    KeyDock dock(test::keyScene(2, 3, 10));
    dock.player.seek(15);
    dock.set.find(QStringLiteral("keys.insertAnimated"))->trigger();
    QCOMPARE(dock.frames(2), (Frames{0, 10, 15, 20}));
    dock.set.find(QStringLiteral("keys.insert"))->trigger();
    QCOMPARE(dock.model.rows().size(), std::size_t(2 + 7)); // location, rotation, scale
    QCOMPARE(dock.selected(), 7u);
    dock.player.seek(0);
    dock.set.find(QStringLiteral("keys.next"))->trigger();
    QCOMPARE(dock.player.frame(), std::int64_t(10));
    dock.set.find(QStringLiteral("keys.next"))->trigger();
    QCOMPARE(dock.player.frame(), std::int64_t(15));
    dock.set.find(QStringLiteral("keys.previous"))->trigger();
    QCOMPARE(dock.player.frame(), std::int64_t(10));
    dock.set.find(QStringLiteral("keys.removeHere"))->trigger();
    QCOMPARE(dock.frames(2), (Frames{0, 15, 20}));
    QCOMPARE(dock.steps(), 3);
}

void TestKeySheet::rowsFollowTheSelection()
{
    KeyDock dock(test::keyScene(30, 3, 10));
    QCOMPARE(dock.model.rows().size(), std::size_t(1 + 3 + 30));
    const NodeId node = dock.document.scene().nodes()[1].id;
    dock.document.setSelection({{node}, noNode, {}, noIndex});
    QCOMPARE(dock.model.rows().size(), std::size_t(1 + 1 + 10));
    dock.commands.selectAll();
    QCOMPARE(dock.selected(), 30u);
    QTest::mouseDClick(dock.panel.names(), Qt::LeftButton, {}, {100, dock.at(1, 0).y()});
    QCOMPARE(dock.model.rows().size(), std::size_t(2));
    QCOMPARE(dock.selected(), 30u); // folded, not gone
    dock.panel.findChild<QAbstractButton*>(QStringLiteral("allNodesButton"))->click();
    QCOMPARE(dock.model.rows().size(), std::size_t(1 + 3 + 20));
}

/// Other rows come and go above it: its number changes, the row does not.
void TestKeySheet::theCurrentRowStaysTheSame()
{
    KeyDock dock(test::keyScene(15, 3, 10));
    const auto last = dock.model.rows().size() - 1;
    const Channel channel = dock.model.rows()[last].channel;
    dock.sheet()->setCurrentRow(last);
    dock.model.setFolded(dock.document.scene().nodes().front().id, true);
    QVERIFY(dock.model.rows().size() <= last);
    QTest::keyClick(dock.sheet(), Qt::Key_Right);
    QCOMPARE(dock.selected(), std::size_t(1));
    const TrackRef& chosen = dock.model.selection().begin()->first;
    QCOMPARE(chosen.node, dock.document.scene().nodes().back().id);
    QVERIFY(chosen.channel == channel);
}

void TestKeySheet::everythingByKeys()
{
    KeyDock dock(test::keyScene(2, 3, 10));
    KeySheet* sheet = dock.sheet();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers held = {}) {
        QTest::keyClick(sheet, key, held);
    };
    sheet->setFocus();
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    QCOMPARE(sheet->currentRow(), std::size_t(2));
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    press(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(dock.selected(), 2u);
    press(Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(dock.frames(2), (Frames{0, 11, 21}));
    press(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(dock.frames(2), (Frames{0, 11, 21, 22, 32}));
    press(Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(dock.frames(2), (Frames{0, 11, 21}));
    press(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(dock.frames(2), (Frames{0, 11, 21, 22, 32}));
    press(Qt::Key_A, Qt::ControlModifier);
    press(Qt::Key_M, Qt::ControlModifier);
    QCOMPARE(dock.frames(2), (Frames{-32, -22, -21, -11, 0}));
    press(Qt::Key_K);
    QCOMPARE(dock.selected(), 2u);
    press(Qt::Key_Escape);
    QCOMPARE(dock.selected(), 0u);
    press(Qt::Key_BracketLeft);
    press(Qt::Key_Delete);
    QVERIFY(dock.model.rows().empty());
    press(Qt::Key_Home);
    press(Qt::Key_Plus);
}

/// Whatever is done: undone, every byte is as before, and each gesture was one step at most.
void TestKeySheet::randomGesturesAreUndone()
{
    Random random(11, RandomStream::Test);
    KeyDock dock(test::keyScene(12, 8, 7));
    const QByteArray before = dock.bytes();
    const auto place = [&] {
        return QPoint(int(random.below(std::uint32_t(dock.sheet()->width()))),
                      int(random.below(std::uint32_t(dock.sheet()->height()))));
    };
    KeyCommands& c = dock.commands;
    const std::vector<std::function<void()>> gestures{
        [&] { dock.dragMouse(place(), place()); },
        [&] { dock.dragMouse(place(), place(), Qt::ControlModifier); },
        [&] {
            dock.dragMouse({place().x(), 5}, {place().x(), 5});
        },
        [&] { QTest::mouseClick(dock.sheet(), Qt::LeftButton, Qt::ShiftModifier, place()); },
        [&] { c.selectAll(), c.nudge(int(random.below(9)) - 4); },
        [&] { dock.player.seek(random.below(60)), c.mirror(); },
        [&] { c.copy(), c.paste(false); },
        [&] { c.insert(static_cast<KeyParts>(random.below(6))); },
        [&] { c.setMode(static_cast<KeyMode>(random.below(keyModeCount))); },
        [&] { c.setEasing(static_cast<Easing>(random.below(easingCount))); },
        [&] { c.setHandles(static_cast<HandleType>(random.below(handleTypeCount))); },
        [&] {
            c.retime({0, random.range(-2.0, 2.0), 0}, false);
        },
        [&] { c.selectColumn(), c.remove(); },
        [&] { c.snap(KeySnap::Second); },
    };
    const std::vector<NodeId> nodes{dock.document.scene().nodes()[0].id, dock.document.scene().nodes()[1].id};
    for (int i = 0; i < 400; ++i) {
        if (random.below(10) == 0)
            dock.document.setSelection({{nodes[random.below(2)]}, noNode, {}, noIndex});
        const int steps = dock.document.undoStack()->index();
        gestures[random.below(std::uint32_t(gestures.size()))]();
        QVERIFY(dock.document.undoStack()->index() <= steps + 1);
        if (random.below(5) == 0)
            dock.document.undo();
    }
    QVERIFY(dock.document.undoStack()->index() > 10);
    while (dock.document.undoStack()->canUndo())
        dock.document.undo();
    QCOMPARE(dock.bytes(), before);
}

void TestKeySheet::everythingHasAToolTip()
{
    KeyDock dock(test::keyScene(2, 3, 10));
    for (const QAbstractButton* button : dock.panel.findChildren<QAbstractButton*>())
        if (!button->inherits("QMenu") && !button->objectName().startsWith(QStringLiteral("qt_")))
            QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->text()));
    for (const QComboBox* box : dock.panel.findChildren<QComboBox*>())
        QVERIFY(!box->toolTip().isEmpty());
}

RAMURE_SUITE(TestKeySheet)

} // namespace tst_key_sheet

#include "tst_key_sheet.moc"
