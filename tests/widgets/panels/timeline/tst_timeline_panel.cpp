#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/arm_demo.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/action_set.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/timeline/arm_residuals.h"
#include "widgets/panels/timeline/physics_plot.h"
#include "widgets/panels/timeline/play_actions.h"
#include "widgets/panels/timeline/time_field.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QSignalSpy>
#include <QWheelEvent>

namespace tst_timeline_panel {

using namespace ramure;

/// The timeline by mouse and keyboard. Playing itself is tested with the player.
class TestTimelinePanel : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void refusedNumbersChangeNothing();
    void scrubbingSeeks();
    void scrubbingIsNoStepOfUndo();
    void keysStep();
    void handlesChangeTheRangeAsOneStep();
    void theRulerShowsKeysOfWhatIsSelected();
    void wheelZoomsToTheCursor();
    void fieldsChangeTheTimeline();
    void theFrameFieldSeeks();
    void displaysAgree();
    void actionsDriveThePlayer();
    void loopActionsAreUndoable();
    void pageTurnsWhilePlaying();
    void plotKeepsTheLatestFrames();
    void plotShowsWhatTheSceneHas();
    void plotSaysHowToGetACurve();
    void plotFollowsAnArmThatReaches();
    void curvesLeaveTheirNumbersAlone();
    void droppedFramesHaveTheirRoom();
    void aWideWindowGivesThePlotItsShare();
    void plotKeepsNoiseOut();
    void plotValuesAreCopied();
    void theRulersMenuIsAboutTheFrameClicked();
    void everythingHasAToolTip();

private:
    QPoint at(double frame, int y = 10) const { return {int(std::lround(ruler()->xOf(frame))), y}; }
    TimelineRuler* ruler() const { return m_panel->ruler(); }
    const TimelineSettings& timeline() const { return m_document->scene().timeline(); }
    template <class T> T* child(const char* name) { return m_panel->findChild<T*>(QLatin1String(name)); }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Player> m_player;
    std::unique_ptr<ActionSet> m_set;
    std::unique_ptr<PlayActions> m_actions;
    std::unique_ptr<TimelinePanel> m_panel;
};

void TestTimelinePanel::init()
{
    test::failOnWidgetWarning();
    QLocale::setDefault(QLocale::c());
    m_document = std::make_unique<Document>();
    m_player = std::make_unique<Player>(m_document.get());
    m_set = std::make_unique<ActionSet>();
    m_actions = std::make_unique<PlayActions>(m_document.get(), m_player.get(), m_set.get());
    m_set->setShortcuts({});
    m_panel = std::make_unique<TimelinePanel>(m_document.get(), m_player.get(), m_actions.get());
    m_panel->resize(1200, 110);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
}

void TestTimelinePanel::cleanup()
{
    m_panel.reset();
    m_actions.reset();
    m_set.reset();
    m_player.reset();
    m_document.reset();
}

static void type(QAbstractSpinBox* field, const char* text)
{
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(text));
    QTest::keyClick(field, Qt::Key_Return);
}

void TestTimelinePanel::refusedNumbersChangeNothing()
{
    const TimelineSettings before = timeline();
    type(child<QAbstractSpinBox>("firstFrameField"), "soon");
    type(child<QAbstractSpinBox>("frameRateField"), "fast");
    QVERIFY(timeline() == before);
    QCOMPARE(child<TimeField>("firstFrameField")->text(), QStringLiteral("0"));
    QCOMPARE(m_document->undoStack()->count(), 0);
}

void TestTimelinePanel::scrubbingSeeks()
{
    QTest::mousePress(ruler(), Qt::LeftButton, {}, at(100));
    QCOMPARE(m_player->frame(), std::int64_t(100));
    QTest::mouseMove(ruler(), at(40));
    QCOMPARE(m_player->frame(), std::int64_t(40));
    QTest::mouseMove(ruler(), {-500, 10});
    QVERIFY(m_player->frame() < 0); // before the range there is something to see, too
    QTest::mouseRelease(ruler(), Qt::LeftButton, {}, at(180));
    QTest::mouseMove(ruler(), at(20));
    QVERIFY(m_player->frame() != 20); // let go
}

void TestTimelinePanel::scrubbingIsNoStepOfUndo()
{
    QTest::mouseClick(ruler(), Qt::LeftButton, {}, at(77));
    QCOMPARE(m_document->undoStack()->count(), 0);
    QVERIFY(!m_document->isModified());
}

void TestTimelinePanel::keysStep()
{
    ruler()->setFocus();
    const auto press = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(ruler(), key, modifiers);
        return m_player->frame();
    };
    QCOMPARE(press(Qt::Key_Right), std::int64_t(1));
    QCOMPARE(press(Qt::Key_Right, Qt::ShiftModifier), std::int64_t(11));
    QCOMPARE(press(Qt::Key_Left), std::int64_t(10));
    QCOMPARE(press(Qt::Key_PageDown), std::int64_t(34));
    QCOMPARE(press(Qt::Key_PageUp), std::int64_t(10));
    QCOMPARE(press(Qt::Key_End), std::int64_t(250));
    QCOMPARE(press(Qt::Key_Home), std::int64_t(0));
}

void TestTimelinePanel::handlesChangeTheRangeAsOneStep()
{
    const int low = ruler()->height() - 12;
    QTest::mousePress(ruler(), Qt::LeftButton, {}, at(250, low) + QPoint(3, 0));
    for (const int frame : {230, 200, 150, 120})
        QTest::mouseMove(ruler(), at(frame, low));
    QTest::mouseRelease(ruler(), Qt::LeftButton, {}, at(120, low));
    QCOMPARE(timeline().lastFrame, std::int64_t(120));
    QCOMPARE(m_document->undoStack()->count(), 1);
    QTest::mousePress(ruler(), Qt::LeftButton, {}, at(0, low) - QPoint(3, 0));
    QTest::mouseMove(ruler(), at(500, low)); // no further than the last frame
    QTest::mouseRelease(ruler(), Qt::LeftButton, {}, at(500, low));
    QCOMPARE(timeline().firstFrame, std::int64_t(120));
    m_document->undo();
    m_document->undo();
    QVERIFY(timeline() == TimelineSettings{});
    QCOMPARE(m_player->frame(), std::int64_t(0)); // no scrubbing meanwhile
}

void TestTimelinePanel::theRulerShowsKeysOfWhatIsSelected()
{
    using Frames = std::vector<double>;
    QCOMPARE(ruler()->keys(), Frames());
    const NodeId first = edit::insertNodes(*m_document, {test::groupNode(1, "a")}, noNode, 0).value();
    const NodeId second = edit::insertNodes(*m_document, {test::groupNode(1, "b")}, noNode, 1).value();
    const std::vector<Channel> placed{{ChannelPart::GlobalTranslation, 0}};
    QVERIFY(edit::insertKeys(*m_document, {first}, placed, 0));
    QVERIFY(edit::insertKeys(*m_document, {first, second}, placed, ticksOf(1.0)));
    const double rate = timeline().framesPerSecond;
    m_document->setSelection({});
    QCOMPARE(ruler()->keys(), (Frames{0.0, rate}));
    const auto select = [&](NodeId node) {
        Selection selection;
        selection.nodes = {node};
        m_document->setSelection(std::move(selection));
    };
    select(second);
    QCOMPARE(ruler()->keys(), Frames{rate});
    select(first);
    QCOMPARE(ruler()->keys(), (Frames{0.0, rate}));
    // Where the diamond is, something is drawn that was not.
    const QImage with = ruler()->grab().toImage();
    m_document->undo();
    m_document->undo();
    QCOMPARE(ruler()->keys(), Frames());
    const QRect place(at(0, ruler()->height() - 15), QSize(2, 9));
    QVERIFY(with.copy(place) != ruler()->grab().toImage().copy(place));
}

void TestTimelinePanel::wheelZoomsToTheCursor()
{
    const QPointF cursor(ruler()->xOf(60), 10.0);
    const double before = ruler()->xOf(61) - ruler()->xOf(60);
    QWheelEvent in(cursor, ruler()->mapToGlobal(cursor), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                   Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(ruler(), &in);
    QVERIFY(ruler()->xOf(61) - ruler()->xOf(60) > 1.4 * before);
    QVERIFY(std::abs(ruler()->xOf(60) - cursor.x()) < 0.01);
    QTest::mouseDClick(ruler(), Qt::LeftButton, {}, at(60));
    QVERIFY(std::abs(ruler()->xOf(61) - ruler()->xOf(60) - before) < 1e-6);
}

void TestTimelinePanel::fieldsChangeTheTimeline()
{
    type(child<QAbstractSpinBox>("lastFrameField"), "96");
    QCOMPARE(timeline().lastFrame, std::int64_t(96));
    type(child<QAbstractSpinBox>("firstFrameField"), "120"); // takes the last one along
    QCOMPARE(timeline().firstFrame, std::int64_t(120));
    QCOMPARE(timeline().lastFrame, std::int64_t(120));
    type(child<QAbstractSpinBox>("frameRateField"), "30");
    QCOMPARE(timeline().framesPerSecond, 30.0);
    QCOMPARE(m_document->undoStack()->count(), 3);
    type(child<QAbstractSpinBox>("speedField"), "2.5");
    QCOMPARE(m_player->speed(), 2.5);
    QCOMPARE(m_document->undoStack()->count(), 3);
}

void TestTimelinePanel::theFrameFieldSeeks()
{
    auto* field = child<TimeField>("frameField");
    type(field, "1:00");
    QCOMPARE(m_player->frame(), std::int64_t(24));
    QTest::keyClick(field, Qt::Key_Up);
    QCOMPARE(m_player->frame(), std::int64_t(25));
    m_player->seek(30);
    QCOMPARE(field->frame(), qint64(30));
}

void TestTimelinePanel::displaysAgree()
{
    m_player->seek(36);
    QSignalSpy changed(m_panel.get(), &TimelinePanel::displayChanged);
    m_panel->setDisplay(TimeDisplay::Seconds);
    QCOMPARE(child<TimeField>("frameField")->text(), QStringLiteral("1.50 s"));
    m_panel->setDisplay(TimeDisplay::Timecode);
    QCOMPARE(child<TimeField>("frameField")->text(), QStringLiteral("00:00:01:12"));
    QCOMPARE(changed.size(), 2);
    QCOMPARE(m_player->frame(), std::int64_t(36));
}

void TestTimelinePanel::actionsDriveThePlayer()
{
    m_set->find("play.forward")->trigger();
    QCOMPARE(m_player->frame(), std::int64_t(1));
    m_set->find("play.last")->trigger();
    QCOMPARE(m_player->frame(), std::int64_t(250));
    m_set->find("play.back")->trigger();
    QCOMPARE(m_player->frame(), std::int64_t(249));
    m_set->find("play.first")->trigger();
    QCOMPARE(m_player->frame(), std::int64_t(0));
    const QString play = m_set->find("play.toggle")->text();
    m_set->find("play.toggle")->trigger();
    QVERIFY(m_player->isPlaying());
    QVERIFY(m_set->find("play.toggle")->text() != play);
    QTRY_VERIFY(m_player->frame() > 2);
    m_set->find("play.stop")->trigger();
    QVERIFY(!m_player->isPlaying());
    QCOMPARE(m_player->frame(), std::int64_t(0));
    m_set->find("play.everyFrame")->trigger();
    QCOMPARE(m_player->pace(), PlayPace::EveryFrame);
}

void TestTimelinePanel::loopActionsAreUndoable()
{
    m_set->find("play.pingPong")->trigger();
    QCOMPARE(timeline().loop, PlayLoop::PingPong);
    QVERIFY(m_set->find("play.pingPong")->isChecked());
    m_document->undo();
    QCOMPARE(timeline().loop, PlayLoop::Loop);
    QVERIFY(m_set->find("play.loop")->isChecked());
}

/// Whatever the curves do, beside them nothing changes but the numbers of the last frame.
void TestTimelinePanel::curvesLeaveTheirNumbersAlone()
{
    const auto drawn = [](PhysicsPlot::Content content, int height, bool steep) {
        PhysicsPlot plot;
        plot.setContent(content);
        plot.resize(plot.sizeHint().width(), height);
        const auto value = [steep](std::size_t i) { return steep && i % 2 == 0 ? 0.0 : 1.0; };
        for (std::size_t i = 0; i < PhysicsPlot::length; ++i) {
            MotionFrame frame;
            frame.frame = std::int64_t(i);
            frame.nodes[1].figures.kineticEnergy = frame.nodes[1].figures.lengthError = value(i);
            frame.nodes[1].stepSeconds = value(i);
            plot.add(frame);
        }
        ArmResiduals residuals{1.0, {}};
        for (std::size_t i = 0; i < 100; ++i)
            residuals.way.push_back(value(i));
        if (content == PhysicsPlot::Content::Arms)
            plot.setResiduals(residuals);
        const QRect curves = plot.curvesArea().toAlignedRect();
        const QImage image = plot.grab().toImage();
        return std::tuple(image.copy(0, 0, curves.left(), image.height()), image.copy(curves),
                          image.copy(curves.right() + 1, 0, image.width(), image.height()));
    };
    for (const auto content : {PhysicsPlot::Content::Trees, PhysicsPlot::Content::Arms})
        for (const int height : {PhysicsPlot().sizeHint().height(), 160}) {
            const auto [names, curve, numbers] = drawn(content, height, true);
            const auto [sameNames, otherCurve, sameNumbers] = drawn(content, height, false);
            QCOMPARE(names, sameNames);
            QCOMPARE(numbers, sameNumbers);
            QVERIFY(curve != otherCurve);
            QVERIFY(curve.width() >= 60);
        }
}

void TestTimelinePanel::droppedFramesHaveTheirRoom()
{
    auto* dropped = child<QLabel>("droppedFrames");
    for (const int width : {700, 1200, 1900}) {
        m_panel->resize(width, 150);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QVERIFY(dropped->width() >=
                dropped->fontMetrics().horizontalAdvance(QStringLiteral("8888 frames dropped")));
        if (width >= 1200) // a narrower row is cut at its end as a whole
            QVERIFY(dropped->parentWidget()->rect().contains(dropped->geometry()));
    }
}

void TestTimelinePanel::aWideWindowGivesThePlotItsShare()
{
    test::openNodes(*m_document, {test::treeNode(1, "tree")});
    const auto* plot = m_panel->findChild<PhysicsPlot*>();
    m_panel->resize(1600, 130);
    QTRY_VERIFY(plot->width() > 350);
}

void TestTimelinePanel::plotKeepsNoiseOut()
{
    QCOMPARE(PhysicsPlot::shortNumber(0.0), QStringLiteral("0"));
    QCOMPARE(PhysicsPlot::shortNumber(0.25), QLocale().toString(0.25));
    const QString tiny = PhysicsPlot::shortNumber(4.7e-15);
    QVERIFY2(tiny.startsWith(u'<') && tiny == PhysicsPlot::shortNumber(-1e-18), qPrintable(tiny));
    QVERIFY(!PhysicsPlot::shortNumber(2e-9).startsWith(u'<'));
}

void TestTimelinePanel::plotValuesAreCopied()
{
    PhysicsPlot plot;
    plot.resize(plot.sizeHint());
    MotionFrame frame;
    frame.nodes[1].figures.kineticEnergy = 0.5;
    frame.nodes[1].stepSeconds = 0.002;
    for (frame.frame = 3; frame.frame < 5; ++frame.frame)
        plot.add(frame);
    QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, plot.mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(&plot, &event);
    auto* menu = plot.findChild<QMenu*>();
    QVERIFY(menu->isVisible());
    const QList<QAction*> actions = menu->actions();
    actions[0]->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("frame,energy,length_error,step_ms\n3,0.5,0,2\n4,0.5,0,2\n"));
    const auto shown = std::find_if(actions.begin(), actions.end(),
                                    [](const QAction* action) { return action->isCheckable(); });
    (*shown)->setChecked(false); // the energy
    actions[1]->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("frame\tlength_error\tstep_ms\n3\t0\t2\n4\t0\t2\n"));
    plot.setContent(PhysicsPlot::Content::Arms);
    plot.setResiduals(ArmResiduals{0.25, {1.0, 0.25}});
    QCOMPARE(plot.valuesText(u','), QStringLiteral("tick,residual_m\n0,1\n1,0.25\n"));
}

void TestTimelinePanel::theRulersMenuIsAboutTheFrameClicked()
{
    auto* menu = child<QMenu>("rulerMenu");
    const auto clickAt = [&](double frame) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, at(frame), ruler()->mapToGlobal(at(frame)));
        QCoreApplication::sendEvent(ruler(), &event);
        QVERIFY(menu->isVisible());
    };
    const auto choose = [&](const QString& words) {
        for (QAction* action : menu->actions())
            if (action->text().remove(u'&').startsWith(words)) {
                QVERIFY(action->isEnabled());
                action->trigger();
                return menu->close(), void();
            }
        QFAIL(qPrintable(words));
    };
    clickAt(40.0);
    choose(QStringLiteral("Go to frame 40"));
    QCOMPARE(m_player->frame(), 40);
    clickAt(30.0);
    choose(QStringLiteral("First frame of the range: 30"));
    QCOMPARE(timeline().firstFrame, 30);
    clickAt(90.0);
    choose(QStringLiteral("Last frame of the range: 90"));
    QCOMPARE(timeline().lastFrame, 90);
    QCOMPARE(m_document->undoStack()->count(), 2);
    m_document->undo();
    m_document->undo();
    QVERIFY(timeline() == TimelineSettings());
    clickAt(50.0);
    QMenu* displays = menu->actions().back()->menu();
    QVERIFY(displays);
    displays->actions()[1]->trigger();
    QVERIFY(m_panel->display() == TimeDisplay::Seconds);
    menu->close();
}

void TestTimelinePanel::pageTurnsWhilePlaying()
{
    const QPointF cursor(ruler()->xOf(10), 10.0);
    for (int i = 0; i < 8; ++i) {
        QWheelEvent in(cursor, ruler()->mapToGlobal(cursor), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                       Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(ruler(), &in);
    }
    QVERIFY(ruler()->xOf(200) > ruler()->width());
    m_player->seek(200);
    QVERIFY(ruler()->xOf(200) > 0 && ruler()->xOf(200) < ruler()->width());
}

void TestTimelinePanel::plotShowsWhatTheSceneHas()
{
    auto* plot = child<PhysicsPlot>("physicsPlot");
    m_document->reset(Scene(), {});
    QVERIFY(plot->content() == PhysicsPlot::Content::Nothing && plot->isHidden());
    m_document->reset(armDemo(), {});
    QVERIFY(plot->content() == PhysicsPlot::Content::Arms);
    QVERIFY(!plot->grab().isNull());
    const QString ofArms = plot->toolTip();
    Node tree;
    tree.id = 9;
    tree.kind = NodeKind::Tree;
    Scene both = armDemo();
    QVERIFY(both.insert({tree}, noNode, 9));
    m_document->reset(both, {});
    QVERIFY(plot->content() == PhysicsPlot::Content::Trees && plot->toolTip() != ofArms);
}

void TestTimelinePanel::plotSaysHowToGetACurve()
{
    auto* plot = child<PhysicsPlot>("physicsPlot");
    m_document->reset(armDemo(), {});
    const QString toPlay = plot->hint();
    const auto atRest = armResiduals(m_document->scene(), *m_player, nullptr);
    QVERIFY(!toPlay.isEmpty() && atRest && atRest->now > 0.1 && atRest->way.empty());
    QVERIFY(edit::setParam(*m_document, {1}, *findParam("arm.follows"), ParamValue(false)));
    QVERIFY(!armResiduals(m_document->scene(), *m_player, nullptr));
    QVERIFY(!plot->hint().isEmpty() && plot->hint() != toPlay);
    m_document->undo();
    QCOMPARE(plot->hint(), toPlay);
    m_player->seek(48); // nothing was played, but what lies before is computed
    QVERIFY(m_player->waitForIdle(20'000));
    QTRY_VERIFY(plot->hint().isEmpty());
    const auto moved = armResiduals(m_document->scene(), *m_player, nullptr);
    QVERIFY(moved && moved->now < atRest->now && moved->way.size() > 60);
    QVERIFY(!plot->grab().isNull());
}

void TestTimelinePanel::plotFollowsAnArmThatReaches()
{
    auto* plot = child<PhysicsPlot>("physicsPlot");
    m_document->reset(armDemo(), {});
    ArmReach reach(m_document.get());
    m_panel->setReach(&reach);
    QVERIFY(reach.reachFor(1, {1.5, 1.0, 1.0}, 0));
    reach.finish();
    QVERIFY(plot->hint().isEmpty());
    const auto there = armResiduals(m_document->scene(), *m_player, &reach);
    QVERIFY(there && there->now < 1e-3 && there->way.size() > 10);
    QVERIFY(there->way.front() > there->way.back());
    m_document->undo(); // at rest again
    QVERIFY(!plot->hint().isEmpty());
}

void TestTimelinePanel::plotKeepsTheLatestFrames()
{
    PhysicsPlot plot;
    MotionFrame frame;
    for (frame.frame = 0; frame.frame < 300; ++frame.frame) {
        frame.nodes[1].figures.kineticEnergy = double(frame.frame);
        plot.add(frame);
    }
    QCOMPARE(plot.count(), PhysicsPlot::length);
    QVERIFY(!plot.grab().isNull());
    frame.frame = 5; // back: a new run
    plot.add(frame);
    QCOMPARE(plot.count(), std::size_t(1));
    plot.clear();
    QCOMPARE(plot.count(), std::size_t(0));
    QVERIFY(!plot.hint().isEmpty());
    QVERIFY(!plot.grab().isNull());
}

void TestTimelinePanel::everythingHasAToolTip()
{
    for (const auto* field : m_panel->findChildren<QAbstractSpinBox*>())
        QVERIFY2(!field->toolTip().isEmpty(), qPrintable(field->objectName()));
    for (const auto* button : m_panel->findChildren<QAbstractButton*>())
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->objectName()));
    for (const QAction* action : m_actions->transport())
        QVERIFY(!action->shortcut().isEmpty());
}

RAMURE_SUITE(TestTimelinePanel)

} // namespace tst_timeline_panel

#include "tst_timeline_panel.moc"
