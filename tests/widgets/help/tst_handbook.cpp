#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/help_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/preferences_dialog.h"
#include "widgets/help/handbook_window.h"
#include "widgets/help/help_places.h"
#include "widgets/help/page_browser.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/window/main_window.h"
#include "widgets/window/panels.h"
#include <QDir>
#include <QScrollBar>
#include <QTextBlock>
#include <QTreeWidget>

namespace tst_handbook {

using namespace ramure;

class TestHandbook : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;

    QSet<QString> allPlaces()
    {
        QSet<QString> places;
        for (const HandbookPage& page : readHandbook()) {
            places += page.id;
            for (const HandbookHeading& heading : page.headings)
                places += page.id + u'#' + heading.anchor;
        }
        for (const ParamDef& def : paramTable())
            places += QStringLiteral("parameters#") + QString::fromLatin1(def.key);
        return places;
    }
    /// Where the document has this anchor; -1: nowhere.
    static int placeOf(const QTextDocument& document, const QString& anchor)
    {
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (part.fragment().charFormat().anchorNames().contains(anchor))
                    return block.position();
        return -1;
    }

    /// For all that is made from now on.
    void speak(const char* language)
    {
        m_preferences->language.set(QLatin1String(language));
        m_language = std::make_unique<Language>(*m_preferences);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        speak("en");
    }
    void cleanup() { m_language.reset(); }

    /// Each page is there in each language, with the same headings: places have the same names.
    void bothLanguagesSayTheSame()
    {
        const auto english = readHandbook();
        speak("fr");
        const auto french = readHandbook();
        QCOMPARE(french.size(), english.size());
        for (std::size_t i = 0; i < english.size(); ++i) {
            const QByteArray id = english[i].id.toUtf8();
            QVERIFY2(!english[i].markdown.isEmpty() && english[i].headings.size() > 0, id);
            QVERIFY2(french[i].headings.size() == english[i].headings.size(), id);
            for (std::size_t k = 0; k < english[i].headings.size(); ++k) {
                QVERIFY2(french[i].headings[k].level == english[i].headings[k].level, id);
                QCOMPARE(french[i].headings[k].anchor, english[i].headings[k].anchor);
            }
            QVERIFY2(french[i].markdown != english[i].markdown, id);
            // Headings of one word may be names: of commands, formats and programs.
            for (std::size_t k = 0; k < english[i].headings.size(); ++k)
                if (const QString text = english[i].headings[k].text; text.contains(u' '))
                    QVERIFY2(french[i].headings[k].text != text, (id + ' ' + text.toUtf8()).constData());
        }
    }

    /// In the folders there is no page that the program does not show.
    void everyFileIsAPage()
    {
        QSet<QString> ids;
        for (const HandbookPage& page : readHandbook())
            ids += page.id;
        for (const char* folder : {"", "/fr"}) {
            const QDir dir(QStringLiteral(RAMURE_SOURCE_DIR "/resources/handbook") + QLatin1String(folder));
            for (const QString& file : dir.entryList({QStringLiteral("*.md")}))
                QVERIFY2(ids.contains(file.chopped(3)), qPrintable(file));
        }
    }

    void everyLinkAndPictureLeadsSomewhere()
    {
        static const QRegularExpression link(QStringLiteral("\\]\\(([^)]+)\\)"));
        const QSet<QString> places = allPlaces();
        for (const char* code : {"en", "fr"}) {
            speak(code);
            for (const HandbookPage& page : readHandbook()) {
                for (auto it = link.globalMatch(page.markdown); it.hasNext();) {
                    const QString target = it.next().captured(1);
                    const QByteArray where = (page.id + u' ' + target).toUtf8();
                    if (target.startsWith(QLatin1String("https://")))
                        continue;
                    if (target.endsWith(QLatin1String(".png")))
                        QVERIFY2(QFile::exists(
                                     QStringLiteral(":/handbook/%1/%2").arg(QLatin1String(code), target)),
                                 where);
                    else
                        QVERIFY2(target.contains(QLatin1String(".md")) &&
                                     places.contains(QString(target).remove(QStringLiteral(".md"))),
                                 where);
                }
            }
        }
    }

    void whatF1OpensIsThere()
    {
        const QSet<QString> places = allPlaces();
        for (const QString& place : helpPlaces())
            QVERIFY2(places.contains(place), qPrintable(place));
        for (const PanelRow& panel : panels())
            QVERIFY2(places.contains(QString::fromLatin1(panel.help)), panel.help);
    }

    void placesAreFoundOnThePages()
    {
        for (const char* code : {"en", "fr"}) {
            speak(code);
            HandbookWindow window;
            window.showPlace(QStringLiteral("grammar#the-turtle"));
            QVERIFY(placeOf(*window.browser()->document(), QStringLiteral("the-turtle")) > 0);
            window.showPlace(QStringLiteral("parameters#turtle.theta"));
            for (const ParamDef& def : paramTable())
                QVERIFY2(placeOf(*window.browser()->document(), QString::fromLatin1(def.key)) > 0, def.key);
            QCOMPARE(window.browser()->source().fragment(), QStringLiteral("turtle.theta"));
            QTRY_VERIFY(window.browser()->verticalScrollBar()->value() > 0);
        }
    }

    void picturesFitIntoThePage()
    {
        HandbookWindow window;
        window.showPlace(QStringLiteral("window"));
        QTRY_VERIFY(window.browser()->verticalScrollBar()->maximum() > 0);
        QCOMPARE(window.browser()->horizontalScrollBar()->maximum(), 0);
    }

    void backAndForward()
    {
        HandbookWindow window;
        window.showPlace({});
        QCOMPARE(window.browser()->page(), QStringLiteral("index"));
        window.showPlace(QStringLiteral("motion"));
        window.showPlace(QStringLiteral("keys#curves"));
        QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(window.browser()->page(), QStringLiteral("motion"));
        QVERIFY(placeOf(*window.browser()->document(), QStringLiteral("the-timeline")) > 0);
        QTest::keyClick(&window, Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(window.browser()->page(), QStringLiteral("keys"));
        // A link, as a click on it opens it.
        window.browser()->setSource(QUrl(QStringLiteral("grammar.md#errors")));
        QCOMPARE(window.browser()->page(), QStringLiteral("grammar"));
        QVERIFY(window.windowTitle().contains(QStringLiteral("Grammars")));
    }

    void searchingMarksWhatItFinds()
    {
        HandbookWindow window;
        window.showPlace({});
        const auto* found = window.findChild<QTreeWidget*>(QStringLiteral("handbookFound"));
        auto* search = window.findChild<QLineEdit*>(QStringLiteral("handbookSearch"));
        search->setText(QStringLiteral("backquote"));
        QTRY_VERIFY(found->isVisible());
        QVERIFY(found->topLevelItemCount() > 0);
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(window.browser()->page(), QStringLiteral("grammar"));
        const auto marks = window.browser()->extraSelections();
        QVERIFY(marks.size() > 1);
        for (const auto& mark : marks)
            QCOMPARE(mark.cursor.selectedText().toLower(), QStringLiteral("backquote"));
        search->setText(QStringLiteral("nothing like this"));
        QCOMPARE(found->topLevelItemCount(), 1); // which says so
        search->clear();
        QVERIFY(window.browser()->extraSelections().isEmpty());
    }

    /// Without accents; a parameter is a place of its own.
    void searchingFindsInFrench()
    {
        speak("fr");
        HandbookWindow window;
        window.showPlace({});
        const auto* found = window.findChild<QTreeWidget*>(QStringLiteral("handbookFound"));
        auto* search = window.findChild<QLineEdit*>(QStringLiteral("handbookSearch"));
        search->setText(QStringLiteral("cotes primitive.sides"));
        QCOMPARE(found->topLevelItemCount(), 1);
        QTest::keyClick(search, Qt::Key_Down);
        QCOMPARE(window.browser()->source().fragment(), QStringLiteral("primitive.sides"));
    }

    void f1OpensThePlaceOfWhatHasTheFocus()
    {
        Document document;
        Recompute recompute(&document);
        MainWindow window(&document, &recompute, m_preferences.get(), &m_chooser);
        test::openNodes(document, {test::treeNode(1, "oak")});
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const auto shown = [&window] {
            const QUrl source = window.help()->handbook()->browser()->source();
            return source.fileName().section(u'.', 0, 0) + u'#' + source.fragment();
        };
        const QAction* help = window.actionSet()->find(QStringLiteral("help.handbook"));
        QCOMPARE(help->shortcut(), QKeySequence(Qt::Key_F1));
        window.showParam(QStringLiteral("turtle.decay"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
        QVERIFY(window.help()->handbook());
        QCOMPARE(shown(), QStringLiteral("parameters#turtle.decay"));
        // What is typed next is searched for, while other keys move the page.
        HandbookWindow* handbook = window.help()->handbook();
        QTRY_COMPARE(QApplication::focusWidget(),
                     handbook->findChild<QWidget*>(QStringLiteral("handbookSearch")));
        const QScrollBar* bar = handbook->browser()->verticalScrollBar();
        const int before = bar->value();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageUp);
        QVERIFY(bar->value() < before);
        QCOMPARE(helpPlace(window.findChild<QWidget*>(QStringLiteral("timelineDock"))),
                 QStringLiteral("motion#the-timeline"));
        QCOMPARE(helpPlace(window.findChild<QWidget*>(QStringLiteral("sceneDock"))),
                 QStringLiteral("window#scene"));
        // Dialogs have no part in the window's shortcuts.
        PreferencesDialog dialog(m_preferences.get(), &window);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QTest::keyClick(&dialog, Qt::Key_F1);
        QCOMPARE(shown(), QStringLiteral("window#preferences"));
    }
};

RAMURE_SUITE(TestHandbook)

} // namespace tst_handbook

#include "tst_handbook.moc"
