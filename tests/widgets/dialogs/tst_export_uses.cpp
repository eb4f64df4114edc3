#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>

namespace tst_export_uses {

using namespace ramure;

/// The pages of the export dialog, one a use, and the settings that it keeps.
class TestExportUses : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    test::FakeChooser m_chooser;
    std::unique_ptr<ExportDialog> m_dialog;

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }
    template <class T> [[nodiscard]] T* child(const char* name) const
    {
        return m_dialog->findChild<T*>(QString::fromLatin1(name));
    }
    void reopen()
    {
        m_dialog = std::make_unique<ExportDialog>(&m_document, &m_recompute, &m_preferences, &m_chooser);
        m_dialog->setPictureLook({});
        m_dialog->show();
    }
    [[nodiscard]] QStringList formats() const
    {
        QStringList ids;
        const auto* list = child<QComboBox>("exportFormat");
        for (int row = 0; row < list->count(); ++row) {
            ids += list->itemData(row).toString();
            if (list->itemText(row).isEmpty())
                ids += QStringLiteral("without a name");
        }
        return ids;
    }
    [[nodiscard]] QString message(const char* kind) const
    {
        const auto* label = m_dialog->findChild<QLabel*>(QString::fromLatin1(kind));
        return label && label->isVisible() ? label->text() : QString();
    }
    bool exportTo(const QString& file)
    {
        QSignalSpy exported(m_dialog.get(), &ExportDialog::exported);
        m_dialog->setPath(file);
        m_dialog->startExport();
        return QTest::qWaitFor([&] { return exported.count() == 1; }, test::patience(60'000));
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences.setExportSettings({});
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
        reopen();
    }
    void cleanup() { m_dialog.reset(); }

    void levelsComeFromElsewhere()
    {
        const LevelOptions wanted{2, {900, 300}, {}, {0.25}};
        m_dialog->setLevels(wanted);
        QCOMPARE(m_dialog->use(), ExportUse::Game);
        QVERIFY(m_dialog->options().levels == wanted);
        m_dialog->setLevels({1, {}}); // the tree as it is
        QVERIFY(!m_dialog->options().levels.isWanted());
    }
    void thePageForGamesBeginsWithLevels()
    {
        m_dialog->setUse(ExportUse::Game);
        QVERIFY(m_dialog->options().levels == gameLevels());
        child<QSpinBox>("exportLevels")->setValue(5);
        QVERIFY((m_dialog->options().levels.budgets ==
                 std::vector<std::int64_t>{80'000, 20'000, 5'000, 1'250, 312}));
        child<QSpinBox>("exportLevels")->setValue(2);
        QVERIFY((m_dialog->options().levels.budgets == std::vector<std::int64_t>{80'000, 20'000}));
    }
    void windIsShownWhileItsButtonIsDown()
    {
        m_dialog->setUse(ExportUse::Game);
        auto* show = child<QPushButton>("exportShowWind");
        QVERIFY(!show->isVisible());
        m_dialog->offerWind();
        QVERIFY(show->isVisible() && !show->isEnabled());
        QSignalSpy shown(m_dialog.get(), &ExportDialog::windShown);
        const auto last = [&shown] { return shown.takeLast().front().value<WindProfile>(); };
        auto* wind = child<QComboBox>("exportWind");
        wind->setCurrentIndex(int(WindProfile::Unity));
        QVERIFY(shown.isEmpty() && show->isEnabled());
        show->click();
        QCOMPARE(last(), WindProfile::Unity);
        wind->setCurrentIndex(int(WindProfile::Crysis));
        QCOMPARE(last(), WindProfile::Crysis);
        wind->setCurrentIndex(0);
        QVERIFY(!show->isEnabled() && !show->isChecked());
        QCOMPARE(last(), WindProfile::None);
        wind->setCurrentIndex(1);
        show->click();
        QCOMPARE(last(), WindProfile::Plain);
        m_dialog->setUse(ExportUse::Blender);
        QCOMPARE(last(), WindProfile::None);
    }
    void thePageForGamesHasThoseOfThePanel()
    {
        const LevelOptions wanted{2, {900, 300}, {}, {0.25}};
        m_dialog->setUse(ExportUse::Blender);
        m_dialog->offerLevels(wanted);
        QCOMPARE(m_dialog->use(), ExportUse::Blender);
        m_dialog->setUse(ExportUse::Game);
        QVERIFY(m_dialog->options().levels == wanted);
    }
    void badBudgetsAreTold_data()
    {
        QTest::addColumn<int>("levels");
        QTest::addColumn<QString>("budgets");
        QTest::addColumn<QString>("about");
        QTest::newRow("zero") << 2 << "1000, 0"
                              << "least";
        QTest::newRow("rising") << 2 << "1000, 2000"
                                << "must fall";
        QTest::newRow("words") << 2 << "many, few"
                               << "numbers of triangles";
        QTest::newRow("too few") << 3 << "1000, 500"
                                 << "as many budgets";
        QTest::newRow("more than a mesh can be") << 1 << "90000000"
                                                 << "the most";
    }
    void badBudgetsAreTold()
    {
        QFETCH(int, levels);
        QFETCH(QString, budgets);
        QFETCH(QString, about);
        m_dialog->setUse(ExportUse::Game);
        child<QSpinBox>("exportLevels")->setValue(levels);
        child<QLineEdit>("exportBudgets")->setText(budgets);
        m_dialog->setPath(path("bad.glb"));
        m_dialog->startExport();
        QTRY_VERIFY_WITH_TIMEOUT(!message("problem").isEmpty(), test::patience(30'000));
        QVERIFY2(message("problem").contains(about), qPrintable(message("problem")));
        QVERIFY(m_dialog->isVisible() && !QFile::exists(path("bad.glb")));
    }
    void settingsOfNobodyAreBroughtIntoRange()
    {
        m_dialog->setSettings(
            {{"use", "none"}, {"format", "dae"}, {"model", 99}, {"moment", -3}, {"process", 40}});
        QCOMPARE(m_dialog->use(), ExportUse::Blender);
        QVERIFY(m_dialog->isVisible());
        m_dialog->setSettings({});
        QCOMPARE(m_dialog->use(), ExportUse::Blender);
    }

    void settingsOfAPageThatNobodyKnows()
    {
        m_dialog.reset();
        m_preferences.setExportSettings(
            {{"page/game", QVariantMap{{"format", "dae"}, {"levels", -4}, {"moment", 77}, {"first", 900}}},
             {"page/web", 7}});
        reopen();
        m_dialog->setUse(ExportUse::Game);
        QCOMPARE(formats().front(), QStringLiteral("glb"));
        QVERIFY(!m_dialog->options().levels.isWanted());
        m_dialog->setUse(ExportUse::Web);
        QVERIFY(m_dialog->isVisible() && m_dialog->path().endsWith(QStringLiteral(".glb")));
    }

    /// What was chosen for one use says nothing about another, and is there again on coming back.
    void eachPageKeepsItsOwn()
    {
        reopen();
        m_dialog->setUse(ExportUse::Game);
        child<QSpinBox>("exportLevels")->setValue(3);
        child<QLineEdit>("exportBudgets")->setText(QStringLiteral("900, 300, 100"));
        const LevelOptions wanted = m_dialog->options().levels;
        m_dialog->setUse(ExportUse::Pictures);
        m_dialog->moments()->setMoment(ExportMoment::Shown);
        m_dialog->pictures()->setPictureSize({800, 600});
        m_dialog->setUse(ExportUse::Game);
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Rest);
        QVERIFY(m_dialog->options().levels == wanted);
        m_dialog->moments()->setMoment(ExportMoment::WindLoop);
        m_dialog->setUse(ExportUse::Print);
        m_dialog->setUse(ExportUse::Web);
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Rest);
        m_dialog->setUse(ExportUse::Pictures);
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Shown);
        m_dialog->reject();
        reopen(); // another time
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Rest);
        m_dialog->setUse(ExportUse::Game);
        QVERIFY(m_dialog->options().levels == wanted);
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::WindLoop);
        m_dialog->setUse(ExportUse::Pictures);
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Shown);
        QCOMPARE(m_dialog->pictures()->pictureSize(), QSize(800, 600));
        m_dialog->moments()->setMoment(ExportMoment::Sequence); // that of the document, not of a page
        QCOMPARE(m_dialog->moments()->frames().first, std::int64_t(TimelineSettings().firstFrame));
        QCOMPARE(m_dialog->moments()->frames().last, std::int64_t(TimelineSettings().lastFrame));
    }

    void eachPageHasTheFormatsOfItsUse()
    {
        const auto* tabs = child<QTabBar>("exportUses");
        QCOMPARE(tabs->count(), int(exportUses.size()));
        const QList<QStringList> wanted{{"glb", "obj", "ply", "ply-text", "usda", "usdz", "pc2", "fbx"},
                                        {"glb", "usda", "usdz", "obj"},
                                        {"3mf", "stl"},
                                        {"glb"},
                                        {"png", "mp4", "webm"}};
        for (int tab = 0; tab < tabs->count(); ++tab) {
            QVERIFY(!tabs->tabText(tab).isEmpty() && !tabs->tabToolTip(tab).isEmpty());
            m_dialog->setUse(exportUses[std::size_t(tab)]);
            QCOMPARE(formats(), wanted[tab]);
            QVERIFY(m_dialog->path().endsWith(u'.' +
                                              QString(wanted[tab].front()).remove(QStringLiteral("-text"))));
        }
    }
    void eachPageAsksForWhatItNeeds()
    {
        const auto shown = [this](const char* name) { return child<QWidget>(name)->isVisible(); };
        QVERIFY(shown("exportInstances") && !shown("exportLevels") && !shown("printWanted"));
        m_dialog->setUse(ExportUse::Game);
        QVERIFY(shown("exportLevels") && shown("exportMaps") && !shown("exportInstances") &&
                !shown("exportUp"));
        m_dialog->setUse(ExportUse::Print);
        QVERIFY(shown("exportProcess") && m_dialog->printing()->isWanted() && !shown("exportLevels"));
        m_dialog->setUse(ExportUse::Web);
        QVERIFY(shown("exportMaps") && shown("exportInstances") && !shown("printWanted"));
        m_dialog->setUse(ExportUse::Pictures);
        QVERIFY(shown("pictureWidth") && !shown("exportMaps"));
    }
    /// What stands on another page has no say.
    void otherPagesHaveNoSay()
    {
        child<QComboBox>("exportModel")->setCurrentIndex(int(ExportModel::Rough));
        QCOMPARE(m_dialog->options().model, ExportModel::Rough);
        m_dialog->setUse(ExportUse::Game);
        QCOMPARE(m_dialog->options().model, ExportModel::Mesh);
        child<QSpinBox>("exportLevels")->setValue(3);
        QCOMPARE(m_dialog->options().levels.count, std::int64_t(3));
        m_dialog->setUse(ExportUse::Web);
        QVERIFY(!m_dialog->options().levels.isWanted());
    }
    void picturesNeedAView()
    {
        const ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        const auto* tabs = dialog.findChild<QTabBar*>(QStringLiteral("exportUses"));
        QVERIFY(!tabs->isTabEnabled(int(ExportUse::Pictures)));
        QVERIFY(tabs->tabToolTip(int(ExportUse::Pictures)).contains(QStringLiteral("view")));
        QVERIFY(child<QTabBar>("exportUses")->isTabEnabled(int(ExportUse::Pictures)));
    }

    void levelsAreWritten()
    {
        m_dialog->setUse(ExportUse::Game);
        child<QSpinBox>("exportLevels")->setValue(2);
        child<QLineEdit>("exportBudgets")->setText(QStringLiteral("2 000, 500"));
        child<QComboBox>("exportMaps")->setCurrentIndex(0);
        QVERIFY(exportTo(path("levels.glb")));
        QFile file(path("levels.glb"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.contains("branches_LOD1") && bytes.contains("MSFT_lod"));
        reopen();
        m_dialog->setUse(ExportUse::Game);
        m_dialog->setFormat(QStringLiteral("obj"));
        child<QSpinBox>("exportLevels")->setValue(2);
        m_dialog->setPath(path("levels.obj"));
        bool isSaid = false; // what will be there
        for (const QLabel* label : m_dialog->findChildren<QLabel*>(QStringLiteral("dim")))
            isSaid = isSaid || label->text().contains(QStringLiteral("levels_LOD0.obj … levels_LOD1.obj"));
        QVERIFY(isSaid);
        QVERIFY(exportTo(path("levels.obj")));
        QVERIFY(QFile::exists(path("levels_LOD1.obj")) && !QFile::exists(path("levels.obj")));
        // Their files are asked about as any others.
        reopen();
        m_dialog->setUse(ExportUse::Game);
        m_dialog->setFormat(QStringLiteral("obj"));
        child<QSpinBox>("exportLevels")->setValue(2);
        m_dialog->setPath(path("levels.obj"));
        m_dialog->startExport();
        QVERIFY2(message("problem").contains(QStringLiteral("levels_LOD0.obj")),
                 qPrintable(message("problem")));
    }
    void compressedFilesAreSmaller()
    {
        m_dialog->setFormat(QStringLiteral("obj"));
        auto* box = child<QCheckBox>("exportCompressed");
        box->setChecked(true);
        QVERIFY(!box->isVisible() && !m_dialog->options().write.compressed); // of a GLB alone
        m_dialog->setUse(ExportUse::Web);
        QVERIFY(box->isChecked()); // there alone to begin with
        child<QComboBox>("exportMaps")->setCurrentIndex(0);
        QVERIFY(box->isVisible() && m_dialog->options().write.compressed);
        QVERIFY(m_dialog->settings().value(QStringLiteral("compressed")).toBool());
        QVERIFY(exportTo(path("small.glb")));
        reopen();
        m_dialog->setUse(ExportUse::Web);
        child<QCheckBox>("exportCompressed")->setChecked(false);
        QVERIFY(exportTo(path("plain.glb")));
        QVERIFY(QFileInfo(path("small.glb")).size() * 3 < QFileInfo(path("plain.glb")).size());
    }
    void jointsAreAskedForWhereSomethingMoves()
    {
        auto* joints = child<QComboBox>("exportJoints");
        m_dialog->setUse(ExportUse::Game);
        QVERIFY(!joints->isVisible());
        QCOMPARE(m_dialog->options().write.joints, 256);
        m_dialog->findChild<MomentForm*>()->setMoment(ExportMoment::WindLoop);
        QVERIFY(joints->isVisible() && !joints->toolTip().isEmpty());
        joints->setCurrentIndex(0);
        QCOMPARE(m_dialog->options().write.joints, 64);
        QCOMPARE(m_dialog->settings().value(QStringLiteral("joints")).toInt(), 64);
        joints->setCurrentIndex(joints->count() - 1);
        QCOMPARE(m_dialog->options().write.joints, 0);
        m_dialog->setFormat(QStringLiteral("obj"));
        QVERIFY(!joints->isVisible());
    }
    void windLoopsAreWritten()
    {
        m_dialog->setUse(ExportUse::Web);
        child<QComboBox>("exportMaps")->setCurrentIndex(0);
        m_dialog->moments()->setMoment(ExportMoment::WindLoop);
        m_dialog->moments()->setLoopSeconds(1.0);
        const auto frames = m_dialog->moments()->frames();
        const auto loop = m_dialog->moments()->loop();
        QVERIFY(loop && loop->firstFrame == frames.first && loop->lastFrame + 1 == frames.last);
        QVERIFY(exportTo(path("loop.glb")));
        QFile file(path("loop.glb"));
        QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().contains("animations"));
        // A format that cannot move has none.
        reopen();
        m_dialog->setUse(ExportUse::Web);
        m_dialog->moments()->setMoment(ExportMoment::WindLoop);
        m_dialog->setUse(ExportUse::Blender);
        m_dialog->setFormat(QStringLiteral("obj"));
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Rest);
    }

    void settingsAreKeptUnderNames()
    {
        QVERIFY(!child<QPushButton>("exportKeep")->isEnabled() &&
                !child<QPushButton>("exportForget")->isEnabled());
        QVERIFY(!child<QPushButton>("exportKeep")->toolTip().isEmpty());
        m_dialog->setUse(ExportUse::Game);
        child<QSpinBox>("exportLevels")->setValue(3);
        child<QLineEdit>("exportBudgets")->setText(QStringLiteral("9000, 3000, 500"));
        m_dialog->setFormat(QStringLiteral("obj"));
        auto* kept = child<QComboBox>("exportKept");
        kept->lineEdit()->selectAll();
        QTest::keyClicks(kept->lineEdit(), QStringLiteral("Far trees"));
        child<QPushButton>("exportKeep")->click();
        const QVariantMap wanted = m_dialog->settings();
        reopen();
        m_dialog->setUse(ExportUse::Web); // each page has its own
        kept = child<QComboBox>("exportKept");
        QCOMPARE(kept->findText(QStringLiteral("Far trees")), -1);
        m_dialog->setUse(ExportUse::Game);
        const int row = kept->findText(QStringLiteral("Far trees"));
        QVERIFY(row > 0);
        kept->setCurrentIndex(row);
        emit kept->activated(row);
        QCOMPARE(m_dialog->settings(), wanted);
        QVERIFY(child<QPushButton>("exportForget")->isEnabled());
        child<QPushButton>("exportForget")->click();
        reopen();
        m_dialog->setUse(ExportUse::Game);
        QCOMPARE(child<QComboBox>("exportKept")->findText(QStringLiteral("Far trees")), -1);
    }
    void theLastExportIsKept()
    {
        auto* kept = child<QComboBox>("exportKept");
        emit kept->activated(1);
        QVERIFY(!message("hint").isEmpty()); // nothing yet
        m_dialog->setFormat(QStringLiteral("ply"));
        child<QCheckBox>("exportTexture")->setChecked(false);
        const QVariantMap wanted = m_dialog->settings();
        QVERIFY(exportTo(path("last.ply")));
        reopen();
        QCOMPARE(m_dialog->settings(), wanted); // as each page is left
        m_dialog->setFormat(QStringLiteral("obj"));
        emit child<QComboBox>("exportKept")->activated(1);
        QCOMPARE(m_dialog->settings(), wanted);
    }
    void anExportIsRepeatedOverItsFiles()
    {
        m_dialog->setFormat(QStringLiteral("ply"));
        const QVariantMap settings = m_dialog->settings();
        QVERIFY(exportTo(path("again.ply")));
        const qint64 size = QFileInfo(path("again.ply")).size();
        QFile cut(path("again.ply"));
        QVERIFY(cut.open(QIODevice::WriteOnly) && cut.write("old") == 3);
        cut.close();
        reopen();
        QSignalSpy exported(m_dialog.get(), &ExportDialog::exported);
        m_dialog->repeat(settings, path("again.ply"));
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, test::patience(20'000));
        QCOMPARE(QFileInfo(path("again.ply")).size(), size);
        QVERIFY(!m_dialog->isVisible());
    }
};

RAMURE_SUITE(TestExportUses)

} // namespace tst_export_uses

#include "tst_export_uses.moc"
