#include "tests/support/suite.h"
#include "widgets/view/light_dialog.h"
#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/view_settings.h"
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>

namespace tst_light_dialog {

using namespace ramure;

class TestLightDialog : public QObject
{
    Q_OBJECT

    ViewSettings m_settings;

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_settings.light.set({});
    }
    void theSunStandsWhereItIsSaidToStand()
    {
        const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::distance(a, b) < 1e-12;
        };
        QVERIFY(near(SceneLight({0.0, 90.0}).sun(), {0.0, 1.0, 0.0}));
        const double half = std::sqrt(0.5);
        QVERIFY(near(SceneLight({0.0, 45.0}).sun(), {0.0, half, -half}));
        QVERIFY(near(SceneLight({90.0, 45.0}).sun(), {half, half, 0.0}));
        QVERIFY(near(SceneLight({180.0, 45.0}).sun(), {0.0, half, half}));
    }
    void itAppliesAtOnceAndEndsWithTheDocument()
    {
        LightDialog dialog(&m_settings);
        QSignalSpy changed(&m_settings, &ViewSettings::changed);
        dialog.findChild<QSpinBox*>("sunDirection")->setValue(270);
        dialog.findChild<QSpinBox*>("sunHeight")->setValue(8);
        dialog.findChild<QComboBox*>("backdrop")->setCurrentIndex(int(Backdrop::Sky));
        dialog.findChild<QDoubleSpinBox*>("haze")->setValue(5.5);
        dialog.findChild<QDoubleSpinBox*>("exposure")->setValue(-1.5);
        dialog.findChild<QSpinBox*>("whiteBalance")->setValue(5200);
        SceneLight light{270.0, 8.0, Backdrop::Sky, 5.5, -1.5};
        light.whiteKelvin = 5200.0;
        QCOMPARE(m_settings.light(), light);
        QCOMPARE(changed.size(), 6);
        m_settings.quality.set(Quality::Best);
        m_settings.beginDocument();
        QCOMPARE(m_settings.light(), SceneLight());
        QCOMPARE(dialog.findChild<QSpinBox*>("sunDirection")->value(), int(SceneLight().azimuthDeg));
        QCOMPARE(m_settings.quality(), Quality::Best);
    }
    void onlyTheNaturalSkyHasHaze()
    {
        LightDialog dialog(&m_settings);
        auto* haze = dialog.findChild<QDoubleSpinBox*>("haze");
        QVERIFY(!haze->isEnabled());
        m_settings.light.set({10.0, 20.0, Backdrop::Sky});
        QVERIFY(haze->isEnabled());
    }
    void aSkyPictureBringsItsSun()
    {
        LightDialog dialog(&m_settings);
        QSignalSpy wanted(&dialog, &LightDialog::pictureWanted);
        auto* backdrop = dialog.findChild<QComboBox*>("backdrop");
        auto* turn = dialog.findChild<QSpinBox*>("pictureTurn");
        auto* direction = dialog.findChild<QSpinBox*>("sunDirection");
        backdrop->setCurrentIndex(int(Backdrop::Picture)); // there is none yet
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(backdrop->currentIndex(), int(Backdrop::Landscape));
        QCOMPARE(m_settings.light(), SceneLight());
        dialog.findChild<QPushButton*>("chooseSkyPicture")->click();
        QCOMPARE(wanted.size(), 2);
        QVERIFY(!turn->isEnabled() && direction->isEnabled());
        auto sky = std::make_shared<PictureSky>();
        sky->file = "/skies/evening.hdr";
        SceneLight light;
        light.backdrop = Backdrop::Picture;
        light.picture = sky;
        m_settings.light.set(light);
        QCOMPARE(dialog.findChild<QLabel*>("skyPicture")->text(), "evening.hdr");
        QVERIFY(turn->isEnabled() && !direction->isEnabled());
        turn->setValue(45);
        QCOMPARE(m_settings.light().turnDeg, 45.0);
        QCOMPARE(m_settings.light().picture.get(), sky.get());
        backdrop->setCurrentIndex(int(Backdrop::Sky));
        backdrop->setCurrentIndex(int(Backdrop::Picture)); // it is still there
        QCOMPARE(m_settings.light().backdrop, Backdrop::Picture);
        QCOMPARE(wanted.size(), 2);
    }
    void theSunOfADayAndAPlace()
    {
        LightDialog dialog(&m_settings);
        auto* time = dialog.findChild<QDateTimeEdit*>("sunTime");
        auto* button = dialog.findChild<QPushButton*>("takeMoment");
        dialog.findChild<QDoubleSpinBox*>("latitude")->setValue(52.0);
        dialog.findChild<QDoubleSpinBox*>("longitude")->setValue(0.0);
        time->setDateTime(QDateTime({2026, 6, 21}, {0, 0}, Qt::UTC).toLocalTime());
        QVERIFY(!button->isEnabled());
        QVERIFY(dialog.findChild<QLabel*>("momentText")->text().contains("below the horizon"));
        time->setDateTime(QDateTime({2026, 6, 21}, {12, 0}, Qt::UTC).toLocalTime());
        QVERIFY(button->isEnabled());
        button->click();
        QVERIFY(std::abs(m_settings.light().heightDeg - 61.4) < 0.1);
        QVERIFY(std::abs(m_settings.light().azimuthDeg - 180.0) < 1.5);
    }
    void itFollowsTheViewAndGoesBackToTheUsual()
    {
        LightDialog dialog(&m_settings);
        auto* usual = dialog.findChild<QPushButton*>("usualLight");
        QVERIFY(!usual->isEnabled());
        m_settings.light.set({12.4, 30.0, Backdrop::LightStudio});
        QCOMPARE(dialog.findChild<QSpinBox*>("sunDirection")->value(), 12);
        QCOMPARE(dialog.findChildren<QSlider*>()[2]->value(), 30);
        QCOMPARE(m_settings.light().azimuthDeg, 12.4); // being shown changes nothing
        usual->click();
        QCOMPARE(m_settings.light(), SceneLight());
        QVERIFY(!usual->isEnabled());
    }
};

RAMURE_SUITE(TestLightDialog)

} // namespace tst_light_dialog

#include "tst_light_dialog.moc"
