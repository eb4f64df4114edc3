#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/panels/arm/bake_keys_dialog.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <functional>
#include <glm/geometric.hpp>

namespace tst_arm_panel {

using namespace ramure;

class TestArmPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutAnArmThereIsNothingToEdit();
    void jointsAreAddedAndRemoved();
    void numbersChangeTheChosenJoint();
    void limitsHoldTheAngle();
    void everythingHasATooltip();
    void theWayIsSteered();
    void numbersHaveKeys();
    void thePoseIsKeyed();
    void theMotionIsBaked();
    void aTypedTargetSendsTheArm();
};

namespace {

struct Desk
{
    Document document;
    ArmReach reach{&document};
    ArmPanel panel{&document};

    Desk()
    {
        panel.setReach(&reach);
        document.reset(armDemo(), {});
        panel.show();
    }
    [[nodiscard]] const std::vector<ArmJoint>& joints() const
    {
        return document.scene().find(1)->params.joints;
    }
    [[nodiscard]] NumberField* field(int i) const { return panel.findChildren<NumberField*>()[i]; }
};

} // namespace

void TestArmPanel::withoutAnArmThereIsNothingToEdit()
{
    Document document;
    ArmPanel panel(&document);
    QCOMPARE(panel.arm(), noNode);
    panel.addJoint();
    panel.removeJoint();
    QCOMPARE(document.undoStack()->count(), 0);
}

void TestArmPanel::jointsAreAddedAndRemoved()
{
    Desk desk;
    QCOMPARE(desk.panel.arm(), NodeId(1));
    desk.panel.chooseJoint(0);
    desk.panel.addJoint();
    QCOMPARE(desk.joints().size(), std::size_t(4));
    QVERIFY(desk.joints()[0] == desk.joints()[1]);
    QCOMPARE(desk.panel.joint(), 1);
    for (int i = 0; i < 100; ++i)
        desk.panel.addJoint();
    QCOMPARE(desk.joints().size(), mostArmJoints);
    for (int i = 0; i < 100; ++i)
        desk.panel.removeJoint();
    QCOMPARE(desk.joints().size(), leastArmJoints);
    desk.document.history().goToStep(0);
    QVERIFY(desk.joints()[2].length == 1.2);
    QCOMPARE(desk.panel.findChild<QListWidget*>()->count(), 3);
}

void TestArmPanel::numbersChangeTheChosenJoint()
{
    Desk desk;
    desk.panel.chooseJoint(2);
    QCOMPARE(desk.field(0)->value().value_or(0.0), 1.2);
    emit desk.field(0)->valueEdited(2.5);
    QCOMPARE(desk.joints()[2].length, 2.5);
    QCOMPARE(desk.joints()[1].length, 1.5);
    emit desk.field(1)->gestureBegan();
    for (int i = 0; i < 5; ++i)
        emit desk.field(1)->valueEdited(0.1 * i);
    emit desk.field(1)->gestureEnded();
    QCOMPARE(desk.joints()[2].phi.angleRad, 0.4);
    QCOMPARE(desk.document.undoStack()->count(), 2);
}

void TestArmPanel::limitsHoldTheAngle()
{
    Desk desk;
    desk.panel.chooseJoint(0);
    emit desk.field(3)->valueEdited(0.5); // the upper limit of phi, which is at 45 degrees
    QVERIFY(!desk.joints()[0].phi.limited);
    QVERIFY(!desk.field(3)->isEnabled());
    auto* limited = desk.panel.findChildren<QCheckBox*>()[0];
    limited->click();
    QVERIFY(desk.joints()[0].phi.limited);
    QCOMPARE(desk.joints()[0].phi.angleRad, 0.5);
    QVERIFY(desk.field(3)->isEnabled());
    emit desk.field(2)->valueEdited(0.7); // the lower one takes the upper one along
    QCOMPARE(desk.joints()[0].phi.maxRad, 0.7);
    QCOMPARE(desk.joints()[0].phi.angleRad, 0.7);
}

void TestArmPanel::everythingHasATooltip()
{
    Desk desk;
    for (const QWidget* field : desk.panel.findChildren<NumberField*>()) {
        QVERIFY(!field->toolTip().isEmpty());
        QVERIFY(!field->accessibleName().isEmpty());
    }
    for (const QWidget* button : desk.panel.findChildren<QPushButton*>())
        QVERIFY(!button->toolTip().isEmpty());
}

void TestArmPanel::theWayIsSteered()
{
    Desk desk;
    const auto buttons = desk.panel.findChildren<QPushButton*>();
    QPushButton *go = buttons[2], *pause = buttons[3], *step = buttons[4];
    pause->click();
    go->click();
    QVERIFY(desk.reach.progress() && desk.reach.progress()->moves && desk.reach.isPaused());
    const auto before = desk.reach.progress()->angles;
    for (int i = 0; i < 10; ++i) // the solver's first steps may find nothing better
        step->click();
    QVERIFY(desk.reach.progress()->angles != before);
    pause->click();
    QTRY_VERIFY_WITH_TIMEOUT(!desk.reach.progress()->moves, test::patience(20000));
    QVERIFY(!step->isEnabled());
}

void TestArmPanel::numbersHaveKeys()
{
    Desk desk;
    Player player(&desk.document);
    AutoKey keys(&desk.document, &player);
    desk.panel.setKeys(&keys);
    desk.panel.chooseJoint(1);
    const auto buttons = desk.panel.findChildren<QToolButton*>(QStringLiteral("keyButton"));
    QCOMPARE(buttons.size(), qsizetype(jointTable().size()));
    for (const QToolButton* button : buttons)
        QVERIFY(button->isVisibleTo(&desk.panel) && !button->toolTip().isEmpty());
    const auto tracks = [&] { return desk.document.scene().find(1)->animation.tracks().size(); };
    QSignalSpy told(&desk.panel, &ArmPanel::messageRaised);
    buttons[0]->click(); // the length
    QVERIFY(told.back().front().toString().contains(QStringLiteral("has a key at frame 0 now")));
    QCOMPARE(tracks(), std::size_t(1));
    player.seek(24);
    QVERIFY(player.waitForIdle(20'000));
    auto* message = desk.panel.findChild<QLabel*>(QStringLiteral("problem"));
    emit desk.field(0)->valueEdited(2.5); // another key
    QVERIFY(!message->isVisibleTo(&desk.panel));
    keys.setOn(true);
    emit desk.field(1)->valueEdited(0.7); // phi gets its first key
    QCOMPARE(tracks(), std::size_t(2));
    QCOMPARE(desk.joints()[1].length, 1.5);
    player.seek(12);
    QVERIFY(player.waitForIdle(20'000));
    const double half = desk.field(0)->value().value_or(0.0);
    QVERIFY(half > 1.5 && half < 2.5);
    QVERIFY(player.motion()->of(1)->reshapes);
    QCOMPARE(player.motion()->of(1)->arm->angles[2], 0.7); // held by its key
    buttons[0]->click();
    QCOMPARE(keyCount(*desk.document.scene().find(1)->animation.tracks().begin()->second), std::size_t(3));
}

/// As it is seen: where the solver has it now.
void TestArmPanel::thePoseIsKeyed()
{
    Desk desk;
    Player player(&desk.document);
    AutoKey keys(&desk.document, &player);
    desk.panel.setKeys(&keys);
    player.seek(12);
    QVERIFY(player.waitForIdle(20'000));
    const std::vector<double> seen = player.motion()->of(1)->arm->angles;
    QVERIFY(seen != armAngles(desk.joints()));
    desk.panel.findChild<QPushButton*>(QStringLiteral("keyPose"))->click();
    QCOMPARE(desk.document.undoStack()->count(), 1);
    QCOMPARE(desk.document.scene().find(1)->animation.tracks().size(), std::size_t(6));
    QVERIFY(player.waitForIdle(20'000));
    QCOMPARE(player.motion()->of(1)->arm->angles, seen);
}

void TestArmPanel::theMotionIsBaked()
{
    Desk desk;
    QPushButton* bake = desk.panel.findChild<QPushButton*>(QStringLiteral("bakeToKeys"));
    QSignalSpy told(&desk.panel, &ArmPanel::messageRaised);
    bake->click();
    auto* dialog = desk.panel.findChild<BakeKeysDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    const auto box = [&dialog](const char* name) {
        return dialog->findChild<QSpinBox*>(QLatin1String(name));
    };
    auto* go = dialog->findChild<QPushButton*>(QStringLiteral("bake"));
    QCOMPARE(box("firstFrame")->value(), 0); // the timeline's
    QCOMPARE(box("lastFrame")->value(), 250);
    box("lastFrame")->setValue(-1);
    QVERIFY(!go->isEnabled());
    QVERIFY(!dialog->findChild<QLabel*>(QStringLiteral("bakeNote"))->text().isEmpty());
    dialog->findChild<QPushButton*>(QStringLiteral("wholeTimeline"))->click();
    QCOMPARE(box("lastFrame")->value(), 250);
    box("firstFrame")->setValue(10);
    box("lastFrame")->setValue(40);
    box("everyFrame")->setValue(7);
    for (const QSpinBox* field : dialog->findChildren<QSpinBox*>())
        QVERIFY(!field->toolTip().isEmpty() && !field->accessibleName().isEmpty());
    QVERIFY(go->isEnabled());
    go->click();
    QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, test::patience(20'000));
    const Channel phi{ChannelPart::Joint, 0, static_cast<ParamId>(jointAngleNumber(true))};
    const auto track = desk.document.scene().find(1)->animation.find(phi);
    QVERIFY(track);
    QVERIFY(keyCount(*track) == 1 || keyCount(*track) == 6); // 10, 17, 24, 31, 38 and 40
    QCOMPARE(desk.document.scene().find(1)->animation.tracks().size(), std::size_t(9));
    QVERIFY(!bake->isEnabled()); // it follows no target any more
    QCOMPARE(desk.document.undoStack()->count(), 1);
    desk.document.undo();
    QVERIFY(bake->isEnabled());
    QTRY_VERIFY(!desk.panel.findChild<BakeKeysDialog*>());
    bake->click();
    dialog = desk.panel.findChild<BakeKeysDialog*>();
    QCOMPARE(box("everyFrame")->value(), 7); // as it was given last
    dialog->reject();
    QCOMPARE(desk.document.undoStack()->count(), 1);
}

/// In the properties: one step, and the approach is seen.
void TestArmPanel::aTypedTargetSendsTheArm()
{
    Desk desk;
    Preferences preferences;
    PropertiesPanel properties(&desk.document, &preferences);
    properties.setOwnEdit(*findParam("arm.target"), std::bind_front(&ArmReach::editTarget, &desk.reach));
    Selection selection;
    selection.nodes = {1};
    desk.document.setSelection(selection);
    desk.reach.setPaused(true);
    const std::vector<ArmJoint> before = desk.joints();
    ParamRow* row = properties.row(*findParam("arm.target"));
    emit row->editor()->componentEdited(0, -1.0, 7);
    emit row->editor()->componentEdited(1, 1.5, 7);
    QVERIFY(desk.reach.progress() && desk.reach.progress()->moves);
    desk.reach.step();
    QVERIFY(desk.joints() == before);
    desk.reach.finish();
    QVERIFY(desk.joints() != before);
    QVERIFY(glm::distance(ArmChain(desk.joints()).tip(), desk.document.scene().find(1)->params.arm.target) <
            1e-3);
    QCOMPARE(desk.document.undoStack()->count(), 1);
    desk.document.undo();
    QVERIFY(desk.joints() == before);
    emit row->editor()->valueEdited(glm::dvec3(1.0, 1.0, 1.0), 0);
    QVERIFY(desk.reach.progress()->moves);
}

RAMURE_SUITE(TestArmPanel)

} // namespace tst_arm_panel

#include "tst_arm_panel.moc"
