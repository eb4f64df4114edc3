#include "core/generators/colonisation/crown_shape.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/panels/properties/profile_curve.h"
#include "widgets/panels/properties/profile_editor.h"
#include <QLineEdit>
#include <QSignalSpy>

namespace tst_profile_editor {

using namespace ramure;

namespace {

const ParamDef& profile()
{
    return *findParam("colonisation.profile");
}

/// An editor that takes what it says, as the properties do.
struct Bench
{
    ProfileEditor editor{profile(), nullptr};
    ProfileCurve* curve = editor.curve();
    QLineEdit* text = editor.findChild<QLineEdit*>();
    std::string value = "0 0.2, 0.5 1, 1 0";
    std::vector<GestureId> gestures;

    Bench()
    {
        show(value);
        QObject::connect(&editor, &ParamEditor::valueEdited, &editor,
                         [this](const ParamValue& taken, GestureId gesture) {
                             value = std::get<std::string>(taken);
                             gestures.push_back(gesture);
                             show(value);
                         });
        editor.resize(260, 240);
        editor.show();
    }
    void show(const std::string& now)
    {
        const ParamValue values[] = {now};
        editor.showValues(values);
    }
    [[nodiscard]] QPoint at(double height, double radius) const
    {
        return curve->handleAt({height, radius}).toPoint();
    }
    [[nodiscard]] std::vector<glm::dvec2> pairs() const { return *parseProfile(value); }
};

} // namespace

class TestProfileEditor : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }

    void wrongTextsAreRefused()
    {
        Bench bench;
        QSignalSpy refused(&bench.editor, &ParamEditor::refused);
        bench.text->setFocus();
        bench.text->selectAll();
        QTest::keyClicks(bench.text, QStringLiteral("0 1, 1"));
        QTest::keyClick(bench.text, Qt::Key_Return);
        QCOMPARE(refused.count(), 1);
        QVERIFY(!refused.first().first().toString().isEmpty());
        QVERIFY(bench.gestures.empty());
        bench.text->selectAll();
        QTest::keyClicks(bench.text, QStringLiteral("0 1, 1 0.5"));
        QTest::keyClick(bench.text, Qt::Key_Return);
        QVERIFY(refused.last().first().toString().isEmpty());
        QCOMPARE(bench.value, std::string("0 1, 1 0.5"));
        QCOMPARE(bench.curve->pairs().size(), std::size_t(2));
    }

    void treesThatDifferShowNoCurve()
    {
        Bench bench;
        const ParamValue values[] = {std::string("0 1, 1 0"), std::string("0 1, 1 1")};
        bench.editor.showValues(values);
        QVERIFY(bench.curve->pairs().empty());
        QTest::mouseDClick(bench.curve, Qt::LeftButton, {}, bench.at(0.3, 0.4));
        QTest::keyClick(bench.curve, Qt::Key_Delete);
        QVERIFY(bench.gestures.empty());
    }

    /// One gesture, whatever the way; heights stay between those of the neighbours.
    void aDragIsOneGesture()
    {
        Bench bench;
        QTest::mousePress(bench.curve, Qt::LeftButton, {}, bench.at(0.5, 1.0));
        QTest::mouseMove(bench.curve, bench.at(0.6, 0.7));
        QTest::mouseMove(bench.curve, bench.at(1.3, 0.5));
        QTest::mouseRelease(bench.curve, Qt::LeftButton, {}, bench.at(1.3, 0.5));
        QVERIFY(bench.gestures.size() >= 2);
        QVERIFY(std::ranges::count(bench.gestures, bench.gestures.front()) ==
                std::ptrdiff_t(bench.gestures.size()));
        QCOMPARE(bench.pairs()[1].x, 0.99);
        QVERIFY(std::abs(bench.pairs()[1].y - 0.5) < 0.02);
        const auto before = bench.gestures.size();
        QTest::mouseMove(bench.curve, bench.at(0.2, 0.2));
        QCOMPARE(bench.gestures.size(), before);
    }

    void pointsComeAndGo()
    {
        Bench bench;
        QTest::mouseDClick(bench.curve, Qt::LeftButton, {}, bench.at(0.25, 0.4));
        QCOMPARE(bench.pairs().size(), std::size_t(4));
        QVERIFY(std::abs(bench.pairs()[1].x - 0.25) < 0.02 && std::abs(bench.pairs()[1].y - 0.4) < 0.02);
        QCOMPARE(bench.curve->chosen(), 1);
        QTest::keyClick(bench.curve, Qt::Key_Delete);
        QTest::keyClick(bench.curve, Qt::Key_Delete);
        QCOMPARE(bench.pairs().size(), std::size_t(2));
        QTest::keyClick(bench.curve, Qt::Key_Delete);
        QCOMPARE(bench.pairs().size(), std::size_t(2)); // fewer are no curve
        QTest::keyClick(bench.curve, Qt::Key_PageDown);
        QTest::keyClick(bench.curve, Qt::Key_PageDown);
        QTest::keyClick(bench.curve, Qt::Key_Insert);
        QCOMPARE(bench.pairs().size(), std::size_t(3));
    }

    void keysMoveAPoint()
    {
        Bench bench;
        QTest::keyClick(bench.curve, Qt::Key_PageDown);
        QTest::keyClick(bench.curve, Qt::Key_PageDown);
        QCOMPARE(bench.curve->chosen(), 1);
        QTest::keyClick(bench.curve, Qt::Key_Left);
        QTest::keyClick(bench.curve, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(bench.value, std::string("0 0.2, 0.55 0.99, 1 0"));
    }
};

RAMURE_SUITE(TestProfileEditor)

} // namespace tst_profile_editor

#include "tst_profile_editor.moc"
