#include "tests/support/suite.h"
#include "widgets/dialogs/lens_form.h"
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

namespace tst_lens_form {

using namespace ramure;

class TestLensForm : public QObject
{
    Q_OBJECT

    static QDoubleSpinBox* number(const LensForm& form, const char* name)
    {
        return form.findChild<QDoubleSpinBox*>(QLatin1String(name));
    }

private slots:
    void init() { test::failOnAnyWarning(); }
    void whatWasKeptMayBeNonsense()
    {
        const LensForm form({}, {{"samples", "many"}, {"fStop", -3}, {"lens", QVariantList()}});
        QCOMPARE(form.samples(), 1);
        QCOMPARE(form.lens(), Lens());
        QCOMPARE(number(form, "pictureFStop")->value(), 0.1);
        const LensForm large({}, {{"samples", 100'000}, {"fStop", 1e9}});
        QCOMPARE(large.samples(), 256);
        QCOMPARE(number(large, "pictureFStop")->value(), 64.0);
    }
    void aParallelViewHasNoDepthOfField()
    {
        NodeView view;
        view.camera.orthographic = true;
        const LensForm form(view, {{"lens", true}});
        QCOMPARE(form.lens(), Lens());
        QVERIFY(!form.findChild<QCheckBox*>()->isEnabled());
        QVERIFY(form.findChild<QCheckBox*>()->toolTip().contains("parallel"));
        QVERIFY(!form.findChild<QPushButton*>()->isEnabled());
    }
    void theLensIsThatOfTheFields()
    {
        NodeView view;
        view.camera.fovRad = 0.7;
        LensForm form(view, {});
        QCOMPARE(form.lens(), Lens());
        auto* on = form.findChild<QCheckBox*>();
        on->setChecked(true);
        number(form, "pictureFStop")->setValue(4.0);
        QCOMPARE(form.lens(), (Lens{Lens::diameterOf(4.0, 0.7), 0.0})); // what the camera looks at
        form.setFocus(-2.0);                                            // behind the eye
        QVERIFY(form.lens().focus > 0.0);
        on->setChecked(false);
        form.setFocus(12.5);
        QCOMPARE(form.lens().focus, 12.5);
        QSignalSpy wanted(&form, &LensForm::pickWanted);
        form.findChild<QPushButton*>()->click();
        QCOMPARE(wanted.size(), 1);
    }
    void itIsKeptButForTheFocus()
    {
        LensForm form({}, {});
        form.findChild<QSpinBox*>("pictureSamples")->setValue(16);
        number(form, "pictureFStop")->setValue(1.4);
        form.setFocus(3.0);
        const LensForm next({}, form.settings());
        QCOMPARE(next.samples(), 16);
        QCOMPARE(next.lens().diameter, form.lens().diameter);
        QCOMPARE(next.lens().focus, 0.0);
    }
    void aCameraOfTheSceneComesWithItsLens()
    {
        NodeView view;
        view.lens = {Lens::diameterOf(2.0, view.camera.fovRad), 7.0};
        const LensForm form(view, {{"lens", false}, {"fStop", 16.0}});
        QVERIFY(std::abs(form.lens().diameter - view.lens.diameter) < 1e-9);
        QCOMPARE(form.lens().focus, 7.0);
    }
};

RAMURE_SUITE(TestLensForm)

} // namespace tst_lens_form

#include "tst_lens_form.moc"
