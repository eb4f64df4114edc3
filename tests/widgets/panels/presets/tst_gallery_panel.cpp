#include "core/presets/presets.h"
#include "core/qt/document/project/own_presets.h"
#include "core/scene/preset_scene.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/presets/gallery_panel.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QAction>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <set>

namespace tst_gallery_panel {

using namespace ramure;

class TestGalleryPanel : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_data; ///< of the user
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<GalleryPanel> m_panel;

    PictureButton* picture(const char* preset)
    {
        return m_panel->findChild<PictureButton*>(QStringLiteral("preset.") + QLatin1String(preset));
    }
    QStringList shown()
    {
        QStringList names;
        for (const PictureButton* each : m_panel->findChildren<PictureButton*>())
            if (!each->isHidden())
                names += each->preset();
        return names;
    }
    /// Answers the question for a name.
    void answer(const QString& name)
    {
        auto* dialog = m_panel->findChild<QInputDialog*>();
        QVERIFY(dialog);
        dialog->setTextValue(name);
        dialog->accept();
        QTRY_VERIFY(!m_panel->findChild<QInputDialog*>());
    }
    bool complains() { return !m_panel->findChild<QLabel*>(QStringLiteral("problem"))->isHidden(); }
    /// As by its menu.
    void give(const char* preset)
    {
        emit picture(preset)->customContextMenuRequested({});
        m_panel->giveAction()->trigger();
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_data = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", m_data->path().toUtf8());
        m_document = std::make_unique<Document>();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->favouritePresets.set({});
        m_panel = std::make_unique<GalleryPanel>(m_document.get(), m_preferences.get());
        m_panel->resize(420, 500);
        m_panel->show();
    }
    void cleanup()
    {
        m_panel.reset();
        m_preferences.reset();
    }

    void lockedTreesStayAsTheyAre()
    {
        picture("TinyTree")->click();
        const NodeId tree = m_document->scene().nodes().front().id;
        QVERIFY(edit::setNodeLocked(*m_document, {tree}, true));
        const int steps = m_document->undoStack()->count();
        give("SilverBirch");
        QCOMPARE(m_document->undoStack()->count(), steps);
        QVERIFY(m_document->scene().find(tree)->params == presetParams("TinyTree"));
    }

    /// A click adds; the menu has a new scene, too.
    void tipsSayWhatAClickDoes()
    {
        QVERIFY(picture("TinyTree")->toolTip().contains(QStringLiteral("add to the scene")));
        const QSignalSpy wishes(m_panel.get(), &GalleryPanel::sceneRequested);
        emit picture("TinyTree")->customContextMenuRequested({});
        m_panel->newAction()->trigger();
        QCOMPARE(wishes.count(), 1);
        QCOMPARE(wishes.front().front().toString(), QStringLiteral("TinyTree"));
        QVERIFY(m_document->scene().nodes().empty());
    }
    static bool isOld(const QString& name) { return name.endsWith(QStringLiteral("1995")); }
    /// A species that grows by years is found with its tree of before.
    static QStringList withoutTheOld(QStringList names)
    {
        names.removeIf(&isOld);
        return names;
    }
    void searchFindsEveryName_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("found");
        QTest::newRow("as written") << "silverbirch"
                                    << "SilverBirch";
        QTest::newRow("words") << "birch silver"
                               << "SilverBirch";
        QTest::newRow("Latin") << "Picea abies"
                               << "NorwaySpruce";
        QTest::newRow("description") << "weeps curtains hanging"
                                     << "";
        QTest::newRow("nothing") << "qqq"
                                 << "";
    }
    void searchFindsEveryName()
    {
        QFETCH(const QString, typed);
        QFETCH(const QString, found);
        QCOMPARE(shown().size(), qsizetype(presets().size()));
        m_panel->gallery()->search()->setText(typed);
        QCOMPARE(withoutTheOld(shown()), found.isEmpty() ? QStringList() : QStringList{found});
        QCOMPARE(m_panel->gallery()->first() != nullptr, !found.isEmpty());
        m_panel->gallery()->search()->clear();
        QCOMPARE(shown().size(), qsizetype(presets().size()));
    }

    /// Each has a text of its own for those who translate.
    void everyPresetHasATitle()
    {
        QVERIFY(presetTitle(QStringLiteral("NoSuchTree")) == QStringLiteral("No Such Tree"));
        QFile list(QStringLiteral(RAMURE_SOURCE_DIR "/widgets/base/texts/preset_title.cpp"));
        QVERIFY(list.open(QIODevice::ReadOnly));
        const QByteArray text = list.readAll();
        qsizetype titles = 0;
        qsizetype old = 0; // those have the title of the species, and the year
        for (const Preset& preset : presets()) {
            old += isOld(QLatin1String(preset.name)) ? 1 : 0;
            titles += text.count("\"presets\", \"" + spacedName(QLatin1String(preset.name)).toUtf8() + '"');
        }
        QCOMPARE(titles, qsizetype(presets().size()) - old);
        QCOMPARE(presetTitle(QStringLiteral("EnglishOak1995")), QStringLiteral("English Oak 1995"));
        QCOMPARE(text.count("QT_TRANSLATE_NOOP"), titles);
    }

    void frenchNamesAreShownAndFound_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("found");
        QTest::newRow("no such") << "bouleaux verts"
                                 << "";
        QTest::newRow("French") << "bouleau verruqueux"
                                << "SilverBirch";
        QTest::newRow("without accents") << "chene rouge"
                                         << "RedOak";
        QTest::newRow("English") << "silver birch"
                                 << "SilverBirch";
        QTest::newRow("Latin") << "betula pendula"
                               << "SilverBirch";
    }
    void frenchNamesAreShownAndFound()
    {
        QFETCH(const QString, typed);
        QFETCH(const QString, found);
        cleanup();
        Preferences().language.set(QStringLiteral("fr"));
        auto language = std::make_unique<Language>(Preferences());
        init();
        QCOMPARE(picture("EnglishOak")->text(), QStringLiteral("Chêne pédonculé"));
        m_panel->gallery()->search()->setText(typed);
        QCOMPARE(withoutTheOld(shown()), found.isEmpty() ? QStringList() : QStringList{found});
        picture("SilverBirch")->click();
        QCOMPARE(m_document->scene().nodes().back().name, std::string("Bouleau verruqueux"));
        cleanup();
        Preferences().language.set(QStringLiteral("en"));
        language.reset();
        language = std::make_unique<Language>(Preferences());
        init();
        QCOMPARE(picture("EnglishOak")->text(), QStringLiteral("English Oak"));
        m_panel->gallery()->search()->setText(typed);
        QVERIFY(withoutTheOld(shown()).size() <= 1);
        picture("SilverBirch")->click();
        QCOMPARE(m_document->scene().nodes().back().name, std::string("SilverBirch"));
    }

    void speciesStandBeforeTheExamples()
    {
        const QStringList all = shown();
        const auto isSpecies = [](const QString& name) {
            const EditOperation generator = presetParams(name.toStdString())->generator.kind;
            return generator == EditOperation::WeberPenn || generator == EditOperation::Growth;
        };
        QVERIFY(isSpecies(all.front()));
        const auto examples = std::ranges::find(all, QStringLiteral("SmallTree"));
        for (auto name = examples; name != all.end(); ++name)
            QVERIFY2(!isSpecies(*name), qPrintable(*name));
        for (const char* first : {"FanTree", "HondaTree", "ParkTree"})
            QVERIFY(all.indexOf(QLatin1String(first)) > all.indexOf(QStringLiteral("Sapling")));
        for (const PictureButton* each : m_panel->findChildren<PictureButton*>())
            QVERIFY2(!each->picture().isNull(), qPrintable(each->preset()));
    }

    void clicksAddTrees()
    {
        for (const Preset& preset : presets()) {
            QVERIFY2(picture(preset.name) && !picture(preset.name)->toolTip().isEmpty(), preset.name);
            picture(preset.name)->click();
            QCOMPARE(m_document->scene().nodes().back().name, std::string(preset.name));
        }
        QCOMPARE(m_document->scene().nodes().size(), presets().size());
        while (m_document->undoStack()->canUndo())
            m_document->undo();
        QVERIFY(m_document->scene().nodes().empty());
    }

    void keptTreesStandFirst()
    {
        QVERIFY(!m_panel->keepButton()->isEnabled());
        picture("TinyTree")->click();
        const NodeId tree = m_document->scene().nodes().front().id;
        QVERIFY(edit::setParam(*m_document, {tree}, *findParam("foliage.seed"), std::int64_t(5)));
        const NodeParams kept = m_document->scene().find(tree)->params;
        m_panel->keepButton()->click();
        answer(QStringLiteral("My tree"));
        QVERIFY(!complains());
        QCOMPARE(m_panel->gallery()->first(), picture("own:My tree"));
        QCOMPARE(m_panel->gallery()->search()->nextInFocusChain(), picture("own:My tree"));
        m_panel->gallery()->search()->setText(QStringLiteral("tree my"));
        QCOMPARE(shown(), QStringList{QStringLiteral("own:My tree")});
        m_panel->gallery()->search()->clear();

        picture("own:My tree")->click();
        QCOMPARE(m_document->scene().nodes().back().name, std::string("My tree"));
        QCOMPARE(m_document->scene().nodes().back().params.foliage.seed, kept.foliage.seed);
        give("own:My tree");
        QVERIFY(!complains());

        m_panel->keepButton()->click();
        answer(QStringLiteral("My tree")); // taken
        QVERIFY(complains());
        m_panel->keepButton()->click();
        answer(QStringLiteral("a/b"));
        QVERIFY(complains());
        QCOMPARE(OwnPresets().names(), QStringList{QStringLiteral("My tree")});
    }
    void ownMenusRenameAndRemove()
    {
        QVERIFY(OwnPresets().save(QStringLiteral("Old"), *presetTree("TinyTree")));
        m_panel->hide();
        m_panel->show(); // what lies in the folder is found then
        emit picture("own:Old")->customContextMenuRequested({});
        m_panel->renameAction()->trigger();
        answer(QStringLiteral("New"));
        QVERIFY(picture("own:New") && !complains());
        QFile::remove(OwnPresets().folder() + QStringLiteral("/New.ramure")); // behind our back
        picture("own:New")->click();
        QVERIFY(complains());
        emit picture("own:New")->customContextMenuRequested({});
        m_panel->removeAction()->trigger();
        QVERIFY(complains());
        QCOMPARE(shown().size(), qsizetype(presets().size()));
        QVERIFY(OwnPresets().save(QStringLiteral("Other"), *presetTree("TinyTree")));
        m_panel->hide();
        m_panel->show();
        emit picture("own:Other")->customContextMenuRequested({});
        m_panel->removeAction()->trigger();
        QVERIFY(!complains());
        QVERIFY(OwnPresets().names().isEmpty());
    }

    /// In one step; the tree stays where it is.
    void givingMakesTheSelectedTreeAnother()
    {
        QVERIFY(!m_panel->giveAction()->isEnabled());
        picture("TinyTree")->click();
        const NodeId tree = m_document->scene().nodes().front().id;
        QVERIFY(edit::setParam(*m_document, {tree}, *findParam("tree.translation"), glm::dvec3(3, 0, 1)));
        const NodeParams before = m_document->scene().find(tree)->params;
        QVERIFY(m_panel->giveAction()->isEnabled());
        const int steps = m_document->undoStack()->count();
        give("NorwaySpruce");
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        NodeParams expected = *presetParams("NorwaySpruce");
        expected.tree = before.tree;
        expected.physics = before.physics;
        QVERIFY(m_document->scene().find(tree)->params == expected);
        m_document->undo();
        QVERIFY(m_document->scene().find(tree)->params == before);
    }

    void favouritesStandFirst()
    {
        const auto favourites = [this] {
            QStringList names;
            for (const PictureButton* each : m_panel->findChildren<PictureButton*>())
                if (!each->isHidden() && each->objectName().startsWith(QStringLiteral("favourite.")))
                    names += each->preset();
            return names;
        };
        const auto clickStar = [](PictureButton* on) {
            QTest::mouseClick(on, Qt::LeftButton, {}, on->starPlace().center());
        };
        // Of what is no longer there nothing is shown.
        m_preferences->favouritePresets.set({QStringLiteral("own:Gone"), QStringLiteral("FanTree")});
        QCOMPARE(favourites(), QStringList{QStringLiteral("FanTree")});
        clickStar(picture("SilverBirch"));
        QCOMPARE(favourites(), (QStringList{QStringLiteral("FanTree"), QStringLiteral("SilverBirch")}));
        QCOMPARE(m_preferences->favouritePresets().size(), qsizetype(3));
        QVERIFY(m_document->scene().nodes().empty()); // the star alone was clicked
        auto* first = qobject_cast<PictureButton*>(m_panel->gallery()->first());
        QVERIFY(first && first->preset() == QLatin1String("FanTree") && first->hasPicture());
        first->click();
        QCOMPARE(m_document->scene().nodes().back().name, std::string("FanTree"));
        m_panel->gallery()->search()->setText(QStringLiteral("birch"));
        QCOMPARE(favourites(), QStringList{QStringLiteral("SilverBirch")});
        m_panel->gallery()->search()->clear();
        clickStar(first); // which is gone with it
        QCOMPARE(favourites(), QStringList{QStringLiteral("SilverBirch")});

        QVERIFY(OwnPresets().save(QStringLiteral("Mine"), *presetTree("TinyTree")));
        m_panel->hide();
        m_panel->show();
        clickStar(picture("own:Mine"));
        QCOMPARE(favourites(), (QStringList{QStringLiteral("SilverBirch"), QStringLiteral("own:Mine")}));
        emit picture("own:Mine")->customContextMenuRequested({});
        m_panel->renameAction()->trigger();
        answer(QStringLiteral("Ours"));
        QCOMPARE(favourites(), (QStringList{QStringLiteral("SilverBirch"), QStringLiteral("own:Ours")}));
    }

    void narrowPanelsHaveOneColumn()
    {
        const auto columns = [this] {
            std::set<int> left;
            for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
                left.insert(picture(name)->mapTo(m_panel.get(), QPoint()).x());
            return left.size();
        };
        QTRY_COMPARE(columns(), std::size_t(3));
        m_panel->resize(200, 500);
        QTRY_COMPARE(columns(), std::size_t(1));
    }
};

RAMURE_SUITE(TestGalleryPanel)

} // namespace tst_gallery_panel

#include "tst_gallery_panel.moc"
