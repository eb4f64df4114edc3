#include "core/params/presets.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/panels/presets/gallery_panel.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <set>

using namespace ramure;

class TestGalleryPanel : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;
    std::unique_ptr<Document> m_document;
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
        m_document = std::make_unique<Document>();
        m_panel = std::make_unique<GalleryPanel>(m_document.get());
        m_panel->resize(420, 500);
        m_panel->show();
    }
    void cleanup() { m_panel.reset(); }

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
        QCOMPARE(shown(), found.isEmpty() ? QStringList() : QStringList{found});
        QCOMPARE(m_panel->gallery()->first() != nullptr, !found.isEmpty());
        m_panel->gallery()->search()->clear();
        QCOMPARE(shown().size(), qsizetype(presets().size()));
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
            m_document->undoStack()->undo();
        QVERIFY(m_document->scene().nodes().empty());
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
        m_document->undoStack()->undo();
        QVERIFY(m_document->scene().find(tree)->params == before);
    }

    void narrowPanelsHaveOneColumn()
    {
        const auto columns = [this] {
            std::set<int> left;
            for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
                left.insert(picture(name)->mapTo(m_panel.get(), QPoint()).x());
            return left.size();
        };
        QTRY_COMPARE(columns(), std::size_t(2));
        m_panel->resize(240, 500);
        QTRY_COMPARE(columns(), std::size_t(1));
    }
};

QTEST_MAIN(TestGalleryPanel)
#include "tst_gallery_panel.moc"
