#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/preferences_dialog.h"
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

namespace tst_preferences_dialog {

using namespace ramure;

class TestPreferencesDialog : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
    }

    void nonsenseInTheSettingsGivesDefaults()
    {
        QSettings settings;
        settings.setValue(QStringLiteral("view/navigation"), QStringLiteral("sideways"));
        settings.setValue(QStringLiteral("files/autosaveMinutes"), QStringLiteral("often"));
        settings.setValue(QStringLiteral("shortcuts"), 7);
        settings.setValue(QStringLiteral("view/language"), QStringLiteral("xx"));
        Preferences preferences;
        QCOMPARE(preferences.navigationStyle(), NavigationStyle::Blender);
        QCOMPARE(preferences.autosaveMinutes(), Preferences::defaultAutosaveMinutes);
        QVERIFY(preferences.shortcuts().isEmpty());
        PreferencesDialog dialog(&preferences);
        QCOMPARE(dialog.findChild<QComboBox*>(QStringLiteral("language"))->currentIndex(), 0);
        settings.setValue(QStringLiteral("files/autosaveMinutes"), -4);
        QCOMPARE(preferences.autosaveMinutes(), 0);
        settings.setValue(QStringLiteral("files/autosaveMinutes"), 1'000'000);
        QCOMPARE(preferences.autosaveMinutes(), Preferences::maxAutosaveMinutes);
        settings.setValue(QStringLiteral("units/time"), QStringLiteral("moons"));
        QCOMPARE(preferences.timeDisplay(), TimeDisplay::Frames);
        for (const auto& [text, megabytes] :
             {std::pair{"much", Preferences::defaultMotionMb}, std::pair{"-1", Preferences::leastMotionMb},
              std::pair{"2000000000", Preferences::mostMotionMb}}) {
            settings.setValue(QStringLiteral("motion/memoryMb"), QString::fromLatin1(text));
            QCOMPARE(preferences.motionMemoryMb(), megabytes);
        }
    }

    void noMoreThanAMinuteIsLostUnlessAskedFor()
    {
        QSettings settings;
        settings.remove(QStringLiteral("files/autosaveMinutes"));
        Preferences preferences;
        QCOMPARE(preferences.autosaveMs(), 60'000);
        settings.setValue(QStringLiteral("files/autosaveMinutes"), QStringLiteral("0.005")); // by hand
        QCOMPARE(preferences.autosaveMs(), 300);
        QCOMPARE(preferences.autosaveMinutes(), 1);
        for (const char* nonsense : {"nan", "inf", "", "soon"}) {
            settings.setValue(QStringLiteral("files/autosaveMinutes"), QString::fromLatin1(nonsense));
            QCOMPARE(preferences.autosaveMs(), 60'000);
        }
        preferences.setAutosaveMinutes(3);
        QCOMPARE(preferences.autosaveMs(), 180'000);
    }

    void everyChangeAppliesAtOnceAndIsStored()
    {
        {
            Preferences preferences;
            QSignalSpy changes(&preferences, &Preferences::changed);
            PreferencesDialog dialog(&preferences);
            QCOMPARE(changes.count(), 0); // showing changes nothing
            dialog.findChild<QComboBox*>(QStringLiteral("navigation"))->setCurrentIndex(1);
            dialog.findChild<QComboBox*>(QStringLiteral("units"))->setCurrentIndex(1);
            dialog.findChild<QComboBox*>(QStringLiteral("theme"))->setCurrentIndex(2);
            dialog.findChild<QComboBox*>(QStringLiteral("language"))->setCurrentIndex(2);
            dialog.findChild<QSpinBox*>(QStringLiteral("autosave"))->setValue(0);
            dialog.findChild<QCheckBox*>(QStringLiteral("welcome"))->setChecked(false);
            dialog.findChild<QComboBox*>(QStringLiteral("times"))->setCurrentIndex(2);
            dialog.findChild<QSpinBox*>(QStringLiteral("motionMemory"))->setValue(300);
            QCOMPARE(changes.count(), 8);
        }
        const Preferences later;
        QCOMPARE(later.navigationStyle(), NavigationStyle::Maya);
        QCOMPARE(later.angleUnit(), AngleUnit::Radians);
        QCOMPARE(later.theme(), ThemeChoice::Dark);
        QCOMPARE(later.language(), QStringLiteral("fr"));
        QCOMPARE(later.autosaveMinutes(), 0);
        QVERIFY(!later.welcomeAtStart());
        QCOMPARE(later.timeDisplay(), TimeDisplay::Timecode);
        QCOMPARE(later.motionMemoryMb(), 300);
    }

    void restoringDefaultsLeavesFilesAndShortcuts()
    {
        Preferences preferences;
        PreferencesDialog dialog(&preferences);
        preferences.navigationStyle.set(NavigationStyle::Maya);
        preferences.setAutosaveMinutes(9);
        preferences.theme.set(ThemeChoice::Light);
        preferences.addRecentFile(QStringLiteral("/a/b.ramure"));
        preferences.setShortcut(QStringLiteral("x"), QKeySequence(Qt::Key_X));
        auto* minutes = dialog.findChild<QSpinBox*>(QStringLiteral("autosave"));
        QCOMPARE(minutes->value(), 9); // the dialog follows what others change
        dialog.findChild<QPushButton*>(QStringLiteral("defaults"))->click();
        QCOMPARE(minutes->value(), Preferences::defaultAutosaveMinutes);
        QCOMPARE(preferences.navigationStyle(), NavigationStyle::Blender);
        QCOMPARE(preferences.theme(), ThemeChoice::System);
        QVERIFY(preferences.welcomeAtStart());
        QCOMPARE(preferences.recentFiles().size(), 1);
        QCOMPARE(preferences.shortcuts().size(), 1);
    }

    void theLanguageChangesAtTheNextStart()
    {
        Preferences preferences;
        preferences.language.set(QStringLiteral("en"));
        {
            const Language language(preferences);
            PreferencesDialog dialog(&preferences);
            auto* box = dialog.findChild<QComboBox*>(QStringLiteral("language"));
            box->setCurrentIndex(box->findData(QStringLiteral("fr")));
            QCOMPARE(preferences.language(), QStringLiteral("fr"));
            QCOMPARE(dialog.windowTitle(), QStringLiteral("Preferences"));
            const auto hints = dialog.findChildren<QLabel*>(QStringLiteral("hint"));
            QVERIFY(std::ranges::any_of(hints, [](const QLabel* each) {
                return each->text() == QLatin1String("The language changes when Ramure is started again.");
            }));
        }
        const Language language(preferences);
        const PreferencesDialog dialog(&preferences);
        QCOMPARE(dialog.windowTitle(), QStringLiteral("Préférences"));
        const auto* box = dialog.findChild<QComboBox*>(QStringLiteral("language"));
        QCOMPARE(box->currentData().toString(), QStringLiteral("fr"));
        // Numbers, too, are written as in the new language.
        const auto* memory = dialog.findChild<QSpinBox*>(QStringLiteral("motionMemory"));
        QVERIFY(memory->value() >= 1000);
        QVERIFY2(memory->text().startsWith(QLocale(QStringLiteral("fr")).toString(memory->value())),
                 qPrintable(memory->text()));
    }

    void nothingIsCutOffInEitherLanguage()
    {
        Preferences preferences;
        for (const char* code : {"en", "fr"}) {
            preferences.language.set(QString::fromLatin1(code));
            const Language language(preferences);
            PreferencesDialog dialog(&preferences);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            for (const QLabel* label : dialog.findChildren<QLabel*>()) {
                const int needed =
                    label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
                QVERIFY2(label->height() >= needed, qPrintable(label->text()));
            }
            for (const QAbstractButton* button : dialog.findChildren<QAbstractButton*>())
                if (!button->text().isEmpty())
                    QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
        }
    }
};

RAMURE_SUITE(TestPreferencesDialog)

} // namespace tst_preferences_dialog

#include "tst_preferences_dialog.moc"
