#include "core/qt/document/commands.h"
#include "core/qt/session/motion/auto_key.h"
#include "tests/widgets/panels/animation/key_fixture.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/animation/key_curves.h"
#include "widgets/panels/animation/key_texts.h"
#include "widgets/panels/animation/key_values.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QSignalSpy>
#include <QToolButton>
#include <array>

namespace tst_key_values {

using namespace ramure;
using test::KeyDock;

/// Values of keys: the fields, the curves, and the properties with auto-key.
class TestKeyValues : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    static std::vector<double> values(const KeyDock& dock, std::size_t track)
    {
        std::vector<double> result;
        const auto held = keys::find(dock.document.scene(), dock.model.tracks()[track]);
        for (const Key& key : std::get<Track>(*held).keys())
            result.push_back(key.value);
        return result;
    }
    static void drag(QWidget* widget, QPointF from, QPointF to, Qt::KeyboardModifiers held = {})
    {
        const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButton button,
                              Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, widget->mapToGlobal(at), button, buttons, held);
            QCoreApplication::sendEvent(widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 5; ++i)
            send(QEvent::MouseMove, from + (to - from) * i / 5.0, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }

private slots:
    void init() { test::failOnWidgetWarning(); }

    void parametersWithKeysGetKeysWhereTheyAreEdited()
    {
        KeyDock dock(test::keyScene(1, 1));
        AutoKey keys(&dock.document, &dock.player);
        const NodeId node = dock.document.scene().nodes().front().id;
        const ParamDef& radius = *findParam("primitive.radius");
        QVERIFY(!keys.takes({node}, radius));
        QVERIFY(keys.toggle({node}, radius));
        QVERIFY(keys.state({node}, radius) == KeyState::Here);
        dock.player.seek(20);
        QVERIFY(keys.state({node}, radius) == KeyState::Animated);
        const QByteArray before = dock.bytes();
        QVERIFY(keys.takes({node}, radius) && !keys.isOn());
        QVERIFY(!keys.set({node}, radius, ParamValue(-1.0), std::nullopt, 0)); // out of range
        QCOMPARE(dock.bytes(), before);
        QVERIFY(keys.set({node}, radius, ParamValue(2.0), std::nullopt, 0));
        QCOMPARE(std::get<double>(keys.value(node, radius)), 2.0);
        dock.player.seek(0);
        QVERIFY(std::get<double>(keys.value(node, radius)) != 2.0);
        dock.player.seek(20);
        dock.document.undo();
        QCOMPARE(dock.bytes(), before);
        dock.document.redo();
        QVERIFY(keys.toggle({node}, radius));
        QVERIFY(keys.state({node}, radius) == KeyState::Animated);
    }

    void propertiesMakeKeys()
    {
        KeyDock dock(test::keyScene(1, 1));
        const NodeId node = dock.document.scene().nodes().front().id;
        QVERIFY(edit::setParam(dock.document, {node}, *findParam("primitive.shape"), EnumValue{"box"}));
        Preferences preferences;
        PropertiesPanel panel(&dock.document, &preferences);
        AutoKey keys(&dock.document, &dock.player);
        panel.setKeys(&keys);
        panel.show();
        ParamRow* row = panel.row(*findParam("primitive.size"));
        QVERIFY(row->keyButton());
        const auto tip = [row] { return row->keyButton()->toolTip(); };
        QVERIFY(tip().contains(QStringLiteral("sets the first one")));
        QSignalSpy told(&panel, &PropertiesPanel::messageRaised);
        QVERIFY(!panel.row(*findParam("primitive.shape"))->keyButton());
        const QByteArray before = dock.bytes();
        row->keyButton()->click();
        QCOMPARE(dock.document.scene().find(node)->animation.tracks().size(), std::size_t(1 + 3));
        QVERIFY(told.back().front().toString().contains(QStringLiteral("has a key at frame 0 now: Undo")));
        QVERIFY(tip().contains(QStringLiteral("a click removes it")));
        dock.player.seek(24);
        QVERIFY(tip().contains(QStringLiteral("sets one at this frame")));
        const GestureId gesture = newGesture();
        for (int i = 0; i < 5; ++i)
            emit row->editor()->componentEdited(1, 2.0 + i, gesture);
        QCOMPARE(dock.steps(), 3); // the shape, the button, and all of the drag
        QCOMPARE(std::get<glm::dvec3>(keys.value(node, row->def())).y, 6.0);
        row->keyButton()->click(); // the two components that were not dragged
        row->keyButton()->click();
        QVERIFY(told.back().front().toString().contains(QStringLiteral("at frame 24 is gone: Undo brings")));
        QCOMPARE(told.size(), 3);
        dock.document.undo();
        dock.document.undo();
        dock.document.undo();
        dock.document.undo();
        QCOMPARE(dock.bytes(), before);
    }

    void valuesOfManyKeysAreTyped()
    {
        KeyDock dock(test::keyScene(2, 3, 10));
        dock.commands.selectAll();
        auto* field = dock.panel.findChild<NumberField*>(QStringLiteral("keyValue0"));
        QVERIFY(!field->value()); // they differ
        emit field->valueEdited(1.5);
        QCOMPARE(values(dock, 1), (std::vector<double>{1.5, 1.5, 1.5}));
        QCOMPARE(field->value().value_or(0.0), 1.5);
        QCOMPARE(dock.steps(), 1);
    }

    void anglesAreTyped()
    {
        KeyDock dock(test::keyScene(4, 3, 10));
        const TrackRef ref = dock.model.tracks()[3];
        QVERIFY(ref.channel.isOrientation());
        dock.model.setSelection({{ref, {0}}});
        auto* field = dock.panel.findChild<NumberField*>(QStringLiteral("keyValue2"));
        for (const char* name : {"keyValue0", "keyValue1", "keyValue2"})
            emit dock.panel.findChild<NumberField*>(QLatin1String(name))->valueEdited(0.0);
        emit field->valueEdited(0.5);
        const auto q = std::get<OrientationTrack>(*keys::find(dock.document.scene(), ref)).keys()[0].value;
        QVERIFY(std::abs(std::abs(glm::dot(q, glm::dquat(std::cos(0.25), 0.0, 0.0, std::sin(0.25)))) - 1.0) <
                1e-12);
        QVERIFY(std::abs(field->value().value_or(0.0) - 0.5) < 1e-12);
    }

    void placementsGetKeysWithTheValuesOfTheirFields()
    {
        Scene scene;
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Primitive;
        node.params.tree.translation = {1.0, 2.0, 3.0};
        node.params.tree.rotation = {0.0, 0.5, 0.0};
        QVERIFY(scene.insert({node}, noNode, 0));
        KeyDock dock(std::move(scene));
        AutoKey keys(&dock.document, &dock.player);
        const QByteArray before = dock.bytes();
        const ParamDef& place = *findParam("tree.translation");
        const ParamDef& turn = *findParam("tree.rotation");
        const ParamDef& size = *findParam("tree.scale");
        QVERIFY(isKeyable(place) && isKeyable(turn) && isKeyable(size));
        QVERIFY(keys.state({node.id}, place) == KeyState::None);
        QVERIFY(keys.toggle({node.id}, place));
        QCOMPARE(dock.steps(), 1);
        QVERIFY(keys.state({node.id}, place) == KeyState::Here);
        QCOMPARE(values(dock, 1), std::vector<double>{2.0});
        dock.document.undo();
        QCOMPARE(dock.bytes(), before);
        dock.document.redo();

        dock.player.seek(20);
        QVERIFY(keys.state({node.id}, place) == KeyState::Animated);
        const GestureId gesture = newGesture();
        for (const double y : {3.0, 4.0, 5.0})
            QVERIFY(keys.set({node.id}, place, ParamValue(glm::dvec3(0.0, y, 0.0)), 1, gesture));
        QCOMPARE(dock.steps(), 2);
        QCOMPARE(std::get<glm::dvec3>(keys.value(node.id, place)), glm::dvec3(1.0, 5.0, 3.0));
        QVERIFY(!keys.takes({node.id}, turn)); // it has no keys
        keys.setOn(true);
        QVERIFY(keys.takes({node.id}, turn));
        QVERIFY(keys.set({node.id}, turn, ParamValue(glm::dvec3(0.1, 0.2, 0.3)), std::nullopt, 0));
        QVERIFY(keys.set({node.id}, size, ParamValue(glm::dvec3(2.0)), std::nullopt, 0));
        QCOMPARE(dock.steps(), 4);
        const auto angles = std::get<glm::dvec3>(keys.value(node.id, turn));
        QVERIFY(glm::length(angles - glm::dvec3(0.1, 0.2, 0.3)) < 1e-9);
        QCOMPARE(std::get<glm::dvec3>(keys.value(node.id, place)), glm::dvec3(1.0, 5.0, 3.0));
        dock.player.seek(0);
        QCOMPARE(std::get<glm::dvec3>(keys.value(node.id, place)), glm::dvec3(1.0, 2.0, 3.0));
        while (dock.document.undoStack()->canUndo())
            dock.document.undo();
        QCOMPARE(dock.bytes(), before);
    }

    void theAxisSaysWhichUnitsShareIt()
    {
        for (const auto& [tracks, several] : {std::pair{3, false}, std::pair{4, true}, std::pair{7, true}}) {
            KeyDock dock(test::keyScene(tracks, 3, 10)); // location, then rotation, then scale
            dock.panel.setCurvesShown(true);
            KeyCurves* curves = dock.panel.curves();
            QCOMPARE(curves->axisUnits().isEmpty(), !several);
            QCOMPARE(curves->axisUnits().contains(QStringLiteral("m · °")), several);
            QCOMPARE(curves->axisUnits().contains(QLatin1String("without unit")), tracks == 7);
            QVERIFY(!curves->grab().isNull());
            curves->setNormalised(true); // no values on the axis then
            QVERIFY(curves->axisUnits().isEmpty());
        }
    }

    void aCurveTellsItsValueAndUnitAnywhere()
    {
        KeyDock dock(test::keyScene(4, 3, 10));
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        QVERIFY(curves->tipAt({-500.0, -500.0}).isEmpty());
        for (const KeyCurve& curve : curves->curves()) {
            const Ticks key = curve.timeOf(1), between = key + ticksPerSecond / 16;
            for (const Ticks time : {key, between}) {
                const double value = KeyCurve::Reader(curve).at(secondsOf(time));
                const QString tip = curves->tipAt(curves->placeOf(curve.ref(), time, value));
                QVERIFY2(tip.contains(curve.isAngle() ? QStringLiteral("°") : QStringLiteral(" m")),
                         qPrintable(tip));
            }
        }
    }

    void curvesOpenWithAllKeysInSight()
    {
        KeyDock dock(test::keyScene(7, 5, 40));
        const TrackRef first = dock.model.tracks()[0];
        // As after a key was inserted, and the dope sheet shows another time.
        dock.model.setSelection({{first, {keys::ticksOfFrame(dock.model.timeline(), 40)}}});
        dock.panel.resize(dock.panel.minimumSizeHint().width(), 260); // the least that the window gives it
        const auto allAreSeen = [&] {
            const KeyCurves* curves = dock.panel.curves();
            for (const KeyCurve& curve : curves->curves())
                for (std::size_t i = 0; i < curve.size(); ++i) {
                    const QPointF at = curves->placeOf(curve.ref(), curve.timeOf(i), curve.valueOf(i));
                    if (!QRectF(curves->rect()).contains(at))
                        return false;
                }
            return !curves->curves().empty();
        };
        dock.panel.ruler()->showFrames(500.0, 600.0);
        dock.panel.setCurvesShown(true);
        QTRY_VERIFY(allAreSeen());
        QCOMPARE_GE(dock.panel.curves()->height(), 120);
        dock.panel.setCurvesShown(false);
        dock.panel.ruler()->showFrames(500.0, 600.0);
        dock.panel.setCurvesShown(true);
        QTRY_VERIFY(allAreSeen());
    }

    void curvesAreDraggedAsOneStep()
    {
        KeyDock dock(test::keyScene(1, 3, 10));
        const QByteArray before = dock.bytes();
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        const TrackRef ref = dock.model.tracks()[0];
        const double value = values(dock, 0)[1];
        const QPointF place = curves->placeOf(ref, keys::ticksOfFrame(dock.model.timeline(), 10), value);
        drag(curves, place, place + QPointF(0, -30));
        QCOMPARE(dock.steps(), 1);
        QVERIFY(values(dock, 0)[1] > value);
        QCOMPARE(dock.frames(2), (std::vector<double>{0, 10, 20}));
        dock.document.undo();
        QCOMPARE(dock.bytes(), before);
    }

    void handlesAreDraggedAsOneStep()
    {
        KeyDock dock(test::keyScene(1, 3, 10));
        const QByteArray before = dock.bytes();
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        const TrackRef ref = dock.model.tracks()[0];
        const auto key = [&] { return std::get<Track>(*keys::find(dock.document.scene(), ref)).keys()[1]; };
        dock.model.setSelection({{ref, {key().time}}});
        const QPointF end =
            curves->placeOf(ref, key().time + ticksOf(key().out.dt), key().value + key().out.dv);
        drag(curves, end, end + QPointF(10, 40));
        QCOMPARE(dock.steps(), 1);
        QCOMPARE(key().behind, HandleType::Aligned);
        QVERIFY(key().out.dv < 0.0);
        dock.document.undo();
        QCOMPARE(dock.bytes(), before);
    }

    void escapeTakesADraggedHandleBack()
    {
        KeyDock dock(test::keyScene(1, 3, 10));
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        const TrackRef ref = dock.model.tracks()[0];
        const auto key = [&] { return std::get<Track>(*keys::find(dock.document.scene(), ref)).keys()[1]; };
        dock.model.setSelection({{ref, {key().time}}});
        dock.commands.nudge(1);
        dock.document.undo();
        dock.model.setSelection({{ref, {key().time}}});
        const QByteArray before = dock.bytes();
        const QPointF end =
            curves->placeOf(ref, key().time + ticksOf(key().out.dt), key().value + key().out.dv);
        const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButton button) {
            QMouseEvent event(type, at, curves->mapToGlobal(at), button, Qt::LeftButton, {});
            QCoreApplication::sendEvent(curves, &event);
        };
        send(QEvent::MouseButtonPress, end, Qt::LeftButton);
        for (const double way : {10.0, 40.0, -20.0})
            send(QEvent::MouseMove, end + QPointF(way, way), Qt::NoButton);
        QVERIFY(dock.bytes() != before);
        QTest::keyClick(curves, Qt::Key_Escape);
        QCOMPARE(dock.bytes(), before);
        send(QEvent::MouseButtonRelease, end, Qt::LeftButton);
        QCOMPARE(dock.bytes(), before);
        QCOMPARE(dock.steps(), 1);
        QVERIFY(dock.document.undoStack()->canRedo());
    }

    void coloursAreRedGreenAndBlue()
    {
        int colours = 0;
        for (const Channel& channel : channelsOf(NodeKind::Primitive)) {
            const ParamDef* def = channel.def();
            if (!def || (def->flags & paramColor) == 0)
                continue;
            const std::array parts{"red", "green", "blue"};
            QVERIFY(channelText(channel).contains(QLatin1String(parts[channel.component])));
            QVERIFY(!channelText(channel).contains(u'X') && !channelText(channel).contains(u'Z'));
            ++colours;
        }
        QCOMPARE(colours, 3);
        QVERIFY(channelText({ChannelPart::GlobalTranslation, 1, 0}).endsWith(QLatin1String(" Y")));
    }

    void anglesOfAnOrientationAreDraggedOneByOne()
    {
        KeyDock dock(test::keyScene(4, 3, 10));
        const QByteArray before = dock.bytes();
        const TrackRef ref = dock.model.tracks()[3];
        QVERIFY(ref.channel.isOrientation());
        for (std::size_t i = 0; i < 3; ++i)
            dock.model.setHidden(dock.model.tracks()[i], true);
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        QCOMPARE(curves->curves().size(), std::size_t(3));
        const auto anglesDegrees = [&](std::size_t key) {
            return glm::dvec3(curves->curves()[0].valueOf(key), curves->curves()[1].valueOf(key),
                              curves->curves()[2].valueOf(key));
        };
        const Ticks time = curves->curves()[0].timeOf(1);
        for (int c = 0; c < 3; ++c) {
            dock.commands.selectNone();
            const glm::dvec3 old = anglesDegrees(1), first = anglesDegrees(0);
            const QPointF place = curves->placeOf(CurveRef{ref, c}, time, old[c]);
            const QPointF other = curves->placeOf(CurveRef{ref, c}, time, old[c] + 30.0);
            const double way =
                old[c] > 0.0 ? -std::abs(other.y() - place.y()) : std::abs(other.y() - place.y());
            // Several keys may lie under the mouse: the nearest one is taken.
            double nearest = 1e9;
            for (int k = 0; k < 3; ++k)
                if (k != c)
                    nearest = std::min(
                        nearest, std::abs(curves->placeOf(CurveRef{ref, k}, time, old[k]).y() - place.y()));
            if (nearest < 2.0)
                continue;
            drag(curves, place, place + QPointF(0, -way));
            QCOMPARE(dock.document.undoStack()->index(), 1);
            glm::dvec3 wanted = old;
            wanted[c] += old[c] > 0.0 ? -30.0 : 30.0; // far enough for a drag
            // The same orientation may be shown by other angles then.
            const double degree = 0.017453292519943295;
            const glm::dquat turned = orientationOf(anglesDegrees(1) * degree);
            const double same = std::abs(glm::dot(turned, orientationOf(wanted * degree)));
            const double pixel = 30.0 / std::abs(way); // degrees: where a mouse can be
            QVERIFY2(same >= std::cos(0.5 * pixel * degree),
                     qPrintable(QStringLiteral("angle %1: %2").arg(c).arg(same, 0, 'g', 12)));
            QVERIFY(glm::length(anglesDegrees(0) - first) < 1e-9);
            QCOMPARE(dock.frames(2 + 3), (std::vector<double>{0, 10, 20}));
            dock.document.undo();
            QCOMPARE(dock.bytes(), before);
        }
        dock.commands.selectAll(); // all of a turn's keys at once, in time
        dock.commands.nudge(1);
        QCOMPARE(dock.frames(2 + 3), (std::vector<double>{1, 11, 21}));
    }

    void curvesOfVeryManyKeysAreDrawn()
    {
        KeyDock dock(test::keyScene(12, 300));
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        dock.commands.selectAll();
        QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
        curves->render(&image);
        const QRgb accent = curves->palette().color(QPalette::Highlight).rgb();
        int dots = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                dots += image.pixel(x, y) == accent ? 1 : 0;
        QVERIFY(dots > 1000);
    }

    /// Of very many curves, too, each key has its dot, wherever the view stands.
    void everyKeyHasItsDot()
    {
        KeyDock dock(test::keyScene(60, 50));
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        dock.commands.selectAll();
        const QRgb accent = curves->palette().color(QPalette::Highlight).rgb();
        for (const bool normalised : {false, true})
            for (const double from : {-3.0, 11.3, 60.0}) {
                curves->setNormalised(normalised);
                dock.panel.ruler()->showFrames(from, from + 40.0);
                QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
                curves->render(&image);
                int seen = 0;
                for (const KeyCurve& curve : curves->curves())
                    for (std::size_t i = 0; i < curve.size(); ++i) {
                        const QPoint at =
                            curves->placeOf(curve.ref(), curve.timeOf(i), curve.valueOf(i)).toPoint();
                        if (!image.rect().adjusted(4, 4, -4, -4).contains(at))
                            continue;
                        // The playhead may stand before it.
                        if (std::abs(at.x() - dock.panel.ruler()->xOf(0.0)) < 4.0)
                            continue;
                        QCOMPARE(image.pixel(at), accent);
                        ++seen;
                    }
                QVERIFY(seen > (from < 50.0 ? 1000 : -1));
            }
    }

    /// What is done to "all keys" of the curves is done to those whose curves are seen.
    void keysOfHiddenCurvesAreNotTouched()
    {
        KeyDock dock(test::keyScene(2, 3, 10));
        dock.panel.setCurvesShown(true);
        const TrackRef hidden = dock.model.tracks()[0];
        dock.commands.selectAll();
        dock.model.setHidden(hidden, true);
        QCOMPARE(dock.model.selection().count(hidden), std::size_t(0));
        dock.commands.selectAll();
        dock.commands.remove();
        QVERIFY(keys::find(dock.document.scene(), hidden));
        QCOMPARE(dock.model.tracks().size(), std::size_t(1));
        // In the dope sheet its row is there like any other.
        dock.panel.setCurvesShown(false);
        dock.commands.selectAll();
        QCOMPARE(dock.selected(), std::size_t(3));
    }

    void hiddenAndEmptyCurvesAreLeftAlone()
    {
        KeyDock dock(test::keyScene(5, 3, 10));
        dock.panel.setCurvesShown(true);
        KeyCurves* curves = dock.panel.curves();
        const TrackRef ref = dock.model.tracks()[0];
        dock.model.setHidden(ref, true);
        QCOMPARE(curves->placeOf(ref, 0, 0.0), QPointF());
        dock.panel.findChild<QToolButton*>(QStringLiteral("normaliseButton"))->click();
        drag(curves, {0, 0}, {double(curves->width()), double(curves->height())});
        QVERIFY(dock.selected() >= 9u - 3u);
        dock.commands.remove();
        QTest::keyClick(curves, Qt::Key_Home);
        dock.commands.selectAll();
        dock.commands.remove();
        QTest::keyClick(curves, Qt::Key_Home);
        QTest::keyClick(curves, Qt::Key_Up);
        QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
        curves->render(&image);
    }
};

RAMURE_SUITE(TestKeyValues)

} // namespace tst_key_values

#include "tst_key_values.moc"
