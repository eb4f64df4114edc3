#include "core/qt/session/jobs/recompute.h"
#include "tests/support/kind_with.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/palette/palette.h"
#include "widgets/dialogs/palette/palette_model.h"
#include "widgets/help/handbook_window.h"
#include "widgets/help/page_browser.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/window/main_window.h"
#include <QListView>
#include <QStatusBar>

namespace tst_palette {

using namespace ramure;

class TestPalette : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    Palette* palette() { return m_window->help()->palette(); }
    PaletteModel* model() { return palette()->findChild<PaletteModel*>(); }
    QLineEdit* field() { return palette()->findChild<QLineEdit*>(QStringLiteral("paletteField")); }
    void type(const QString& text)
    {
        action("help.find")->trigger();
        QVERIFY(palette()->isVisible());
        QTest::keyClicks(field(), text);
    }
    /// The row with this id, -1 where there is none.
    int rowOf(const QString& id)
    {
        for (int row = 0; row < model()->rowCount(); ++row)
            if (model()->item(row)->id == id)
                return row;
        return -1;
    }

private slots:
    void init() { open("en"); }
    void open(const char* language)
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->language.set(QLatin1String(language));
        m_language = std::make_unique<Language>(*m_preferences);
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        test::openNodes(*m_document, {test::treeNode(1, "oak"), test::treeNode(2, "elm")});
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_language.reset();
    }

    void everyCommandParameterAndPageIsThere()
    {
        action("help.find")->trigger();
        for (const QAction* each : m_window->actionSet()->actions())
            QVERIFY2(rowOf(each->objectName()) >= 0 || !each->isVisible(), qPrintable(each->objectName()));
        for (const ParamDef& def : paramTable())
            QVERIFY2(rowOf(QString::fromLatin1(def.key)) >= 0, def.key);
        for (const HandbookPage& page : readHandbook())
            QVERIFY2(rowOf(page.id) >= 0, qPrintable(page.id));
    }

    void rowsShowKeyPlaceAndReason()
    {
        m_document->setSelection({});
        action("edit.delete")->setEnabled(false);
        action("help.find")->trigger();
        const PaletteItem* save = model()->item(rowOf(QStringLiteral("file.save")));
        QCOMPARE(save->keys, QStringLiteral("Ctrl+S"));
        QCOMPARE(save->place, QStringLiteral("File"));
        QVERIFY(save->enabled);
        QVERIFY(!model()->item(rowOf(QStringLiteral("edit.delete")))->enabled);
        const PaletteItem* joint = model()->item(rowOf(QStringLiteral("arm.target")));
        QVERIFY(!joint->enabled && !joint->reason.isEmpty()); // there is no arm
        const PaletteItem* level = model()->item(rowOf(QStringLiteral("weberPenn.level1.rotate")));
        QVERIFY(!level->enabled); // both trees are made by a grammar
        QCOMPARE(level->reason, QStringLiteral("no effect while “Generator” is “Grammar”"));
        const PaletteItem* sides = model()->item(rowOf(QStringLiteral("variation.angle")));
        QCOMPARE(sides->reason, QStringLiteral("no effect while “Random” is off"));
    }

    /// The row that is seen, not the one that stood there before the list was filtered.
    void returnRunsTheRowThatIsSeen()
    {
        QSignalSpy welcome(action("file.welcome"), &QAction::triggered);
        QList<QString> others;
        for (QAction* each : m_window->actionSet()->actions())
            if (each != action("file.welcome") && each != action("help.find"))
                connect(each, &QAction::triggered, this, [&others, each] { others += each->objectName(); });
        type(QStringLiteral("page"));
        auto* list = palette()->findChild<QListView*>();
        const int row = rowOf(QStringLiteral("file.welcome"));
        QVERIFY(row >= 0);
        for (int i = 0; i < row; ++i)
            QTest::keyClick(field(), Qt::Key_Down);
        QCOMPARE(list->currentIndex().row(), row);
        QTest::keyClick(field(), Qt::Key_Return);
        QTRY_COMPARE(welcome.size(), 1);
        QVERIFY(!palette()->isVisible());
        QVERIFY2(others.isEmpty(), qPrintable(others.join(u' ')));
        // The next time it is the first.
        action("help.find")->trigger();
        QCOMPARE(model()->item(0)->id, QStringLiteral("file.welcome"));
        QTest::keyClick(field(), Qt::Key_Escape);
        QTRY_VERIFY(!palette()->isVisible());
        QCOMPARE(welcome.size(), 1);
    }

    void theMouseRunsTheRowUnderIt()
    {
        QSignalSpy welcome(action("file.welcome"), &QAction::triggered);
        type(QStringLiteral("page"));
        auto* list = palette()->findChild<QListView*>();
        const QModelIndex row = model()->index(rowOf(QStringLiteral("file.welcome")), 0);
        list->scrollTo(row);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
        QTRY_COMPARE(welcome.size(), 1);
    }

    void whatIsDisabledIsNotRun()
    {
        action("file.welcome")->setEnabled(false);
        QSignalSpy welcome(action("file.welcome"), &QAction::triggered);
        type(QStringLiteral("page"));
        auto* list = palette()->findChild<QListView*>();
        list->setCurrentIndex(model()->index(rowOf(QStringLiteral("file.welcome")), 0));
        QTest::keyClick(field(), Qt::Key_Return);
        QVERIFY(palette()->isVisible());
        QCOMPARE(welcome.size(), 0);
    }

    void aParameterIsShownWhereANodeHasIt()
    {
        m_document->setSelection({});
        QVERIFY(m_window->properties()->nodes().empty());
        type(QStringLiteral("sections.radialDivisions"));
        QTest::keyClick(field(), Qt::Key_Return);
        const ParamRow* row = m_window->properties()->row(*findParam("sections.radialDivisions"));
        QTRY_VERIFY(row->isVisible());
        QCOMPARE(m_document->selection().nodes, (std::vector<NodeId>{1}));
        QTRY_VERIFY(row->isAncestorOf(m_window->focusWidget()));
        // The selection stays where it has the parameter.
        m_document->setSelection({{2}, noNode, {}, noIndex});
        m_window->showParam(QStringLiteral("turtle.theta"));
        QCOMPARE(m_document->selection().nodes, (std::vector<NodeId>{2}));
    }

    /// Each in a document of its own, whose choices use it.
    void everyParameterOfATreeComesToSight()
    {
        for (const ParamDef& def : paramTable()) {
            if (!hasParam(NodeKind::Tree, def))
                continue;
            Node oak = test::treeNode(1, "oak");
            test::makeRelevant(oak.params, def);
            test::openNodes(*m_document, {oak, test::treeNode(2, "elm")});
            m_window->showParam(QString::fromLatin1(def.key));
            QVERIFY2(m_window->properties()->row(def)->isVisible(), def.key);
        }
    }

    void aParameterThatCannotActIsNotShown()
    {
        m_window->showParam(QStringLiteral("weberPenn.level1.rotate"));
        QVERIFY(!m_window->properties()->row(*findParam("weberPenn.level1.rotate"))->isVisible());
        QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("no effect while")));
    }

    void aHeadingOpensTheHandbook()
    {
        type(QStringLiteral("the turtle"));
        QTest::keyClick(field(), Qt::Key_Return);
        QTRY_VERIFY(m_window->help()->handbook() && m_window->help()->handbook()->isVisible());
        QCOMPARE(m_window->help()->handbook()->browser()->page(), QStringLiteral("grammar"));
    }

    void itFindsInFrench()
    {
        cleanup();
        open("fr");
        QCOMPARE(action("file.save")->text(), QStringLiteral("&Enregistrer"));
        type(QStringLiteral("enregis"));
        QCOMPARE(model()->item(0)->id, QStringLiteral("file.save"));
        QCOMPARE(model()->item(0)->place, QStringLiteral("Fichier"));
        field()->clear();
        QTest::keyClicks(field(), QStringLiteral("cotes")); // Côtés
        QCOMPARE(model()->item(0)->id, QStringLiteral("primitive.sides"));
    }
};

RAMURE_SUITE(TestPalette)

} // namespace tst_palette

#include "tst_palette.moc"
