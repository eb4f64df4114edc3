#include "core/qt/document/project/project_file.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/window/welcome_panel.h"
#include <QAction>
#include <QSignalSpy>

namespace tst_welcome_panel {

using namespace ramure;

class TestWelcomePanel : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    test::FakeChooser m_chooser;
    std::unique_ptr<ActionSet> m_set;
    std::unique_ptr<FileActions> m_files;
    std::unique_ptr<WelcomePanel> m_panel;

    QList<QAbstractButton*> recent()
    {
        QList<QAbstractButton*> found;
        for (auto* button : m_panel->findChildren<QAbstractButton*>(QStringLiteral("welcomeFile")))
            if (!button->isHidden())
                found += button;
        return found;
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_chooser = {};
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_set = std::make_unique<ActionSet>();
        m_files = std::make_unique<FileActions>(m_document.get(), m_preferences.get(), &m_chooser,
                                                m_set.get(), nullptr);
        m_panel = std::make_unique<WelcomePanel>(m_files.get(), m_set.get(), m_preferences.get());
    }
    void cleanup()
    {
        m_panel.reset();
        m_files.reset();
    }

    void filesThatAreGoneAreToldAndForgotten()
    {
        m_preferences->addRecentFile(QStringLiteral("/no/such/tree.ramure"));
        m_panel->open();
        QCOMPARE(recent().size(), 1);
        recent().front()->click();
        QCOMPARE(m_chooser.reports.size(), 1);
        QVERIFY(m_panel->isVisible());
        QVERIFY(m_preferences->recentFiles().isEmpty());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(recent().isEmpty());
    }

    void everyPresetHasAPictureAndOpens()
    {
        for (const Preset& preset : presets()) {
            const QString name = QString::fromLatin1(preset.name);
            QVERIFY2(!QImage(QStringLiteral(":/welcome/%1.png").arg(name)).isNull(), preset.name);
            m_panel->open();
            auto* button = m_panel->findChild<QAbstractButton*>(QStringLiteral("preset.") + name);
            QVERIFY2(button, preset.name);
            QVERIFY(!button->toolTip().isEmpty());
            button->click();
            QCOMPARE(QString::fromStdString(m_document->scene().nodes().front().name), name);
            QVERIFY(m_panel->isVisible()); // to try the next one
        }
        QCOMPARE(m_chooser.questions, 0);
    }

    /// A click begins a new scene; the menu adds to the one that is there, too.
    void tipsSayWhatAClickDoes()
    {
        m_panel->open();
        auto* button = m_panel->findChild<QAbstractButton*>(QStringLiteral("preset.TinyTree"));
        QVERIFY(button->toolTip().contains(QStringLiteral("new scene")));
        const QSignalSpy wishes(m_panel.get(), &WelcomePanel::addRequested);
        emit button->customContextMenuRequested({});
        m_panel->addAction()->trigger();
        QCOMPARE(wishes.count(), 1);
        QCOMPARE(wishes.front().front().toString(), QStringLiteral("TinyTree"));
    }

    void savedAndUndoneTreesAreNotAskedAbout()
    {
        QTemporaryDir folder;
        m_panel->open();
        const auto pick = [this](const char* name) {
            m_panel->findChild<QAbstractButton*>(QStringLiteral("preset.") + QLatin1String(name))->click();
        };
        const auto change = [this] {
            const NodeId tree = m_document->scene().nodes().front().id;
            QVERIFY(edit::setParam(*m_document, {tree}, *findParam("turtle.alpha"), 0.11));
        };
        pick("TinyTree");
        change();
        m_document->undo();
        pick("FanTree");
        change();
        m_chooser.answer = folder.filePath(QStringLiteral("fan.ramure"));
        QVERIFY(m_files->save());
        pick("Fern2D");
        QCOMPARE(m_chooser.questions, 0);
        QVERIFY(m_document->filePath().isEmpty()); // the file is that of the tree before
        change();
        pick("TinyTree");
        QCOMPARE(m_chooser.questions, 1);
        QCOMPARE(m_document->scene().nodes().front().name, std::string("Fern2D"));
        QVERIFY(m_panel->isVisible());
    }

    void unsavedChangesKeepThePage()
    {
        m_panel->open();
        m_files->newFromPreset(QStringLiteral("TinyTree"));
        m_document->markModified();
        m_chooser.unsaved = Chooser::Unsaved::Cancel;
        m_panel->findChild<QAbstractButton*>(QStringLiteral("preset.FanTree"))->click();
        QCOMPARE(m_chooser.questions, 1);
        QVERIFY(m_panel->isVisible());
        QCOMPARE(m_document->scene().nodes().front().name, std::string("TinyTree"));
    }

    void recentFilesOpen()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("old & new.ramure"));
        QVERIFY(m_files->newFromPreset(QStringLiteral("Fern2D")));
        QVERIFY(saveProjectFile(m_document->project(), path));
        m_preferences->addRecentFile(path);
        m_panel->open();
        QCOMPARE(recent().size(), 1);
        QVERIFY(recent().front()->text().contains(QStringLiteral("old && new")));
        recent().front()->click();
        QCOMPARE(m_document->filePath(), path);
        QVERIFY(!m_panel->isVisible());
    }

    void keysAndSwitches()
    {
        m_panel->open();
        QSignalSpy closed(m_panel.get(), &WelcomePanel::closed);
        QTest::keyClick(m_panel.get(), Qt::Key_Escape);
        QVERIFY(!m_panel->isVisible());
        QCOMPARE(closed.count(), 1);
        auto* box = m_panel->findChild<QCheckBox*>(QStringLiteral("welcomeAtStart"));
        QVERIFY(box->isChecked());
        box->setChecked(false);
        QVERIFY(!Preferences().welcomeAtStart());
        m_preferences->welcomeAtStart.set(true);
        QVERIFY(box->isChecked());
    }

    void textsFitInEitherLanguage()
    {
        for (const char* code : {"en", "fr"}) {
            cleanup();
            Preferences().language.set(QString::fromLatin1(code));
            const Language language{Preferences()};
            init();
            m_panel->resize(m_panel->width(), 700);
            m_panel->open();
            QCoreApplication::processEvents();
            for (const QLabel* label : m_panel->findChildren<QLabel*>()) {
                if (label->isVisible() && !label->wordWrap())
                    QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
            }
            QVERIFY(m_panel->width() < 480); // the tree keeps its place
            m_panel->hide();
        }
    }
};

RAMURE_SUITE(TestWelcomePanel)

} // namespace tst_welcome_panel

#include "tst_welcome_panel.moc"
