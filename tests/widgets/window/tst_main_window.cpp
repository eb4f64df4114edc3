#include "core/qt/session/jobs/recompute.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/support/failing_disk.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include "widgets/window/problem_button.h"
#include "widgets/window/status_panel.h"
#include <QCollator>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

namespace tst_main_window {

using namespace ramure;

class TestMainWindow : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    test::FakeChooser m_chooser;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<Language> m_language; ///< of the functions that ask for one

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    /// Whether branches cross is another question.
    bool isClosed()
    {
        const QStringList closed{QStringLiteral("closed"), QStringLiteral("warning"), QStringLiteral("good")};
        return closed.contains(m_window->status()->badgeState());
    }
    NodeId tree() { return m_document->scene().nodes().front().id; }
    /// The program is started again, in this language.
    void restart(const char* language)
    {
        cleanup();
        Preferences().language.set(QLatin1String(language));
        m_language = std::make_unique<Language>(Preferences());
        init();
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_chooser = {};
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_recompute->setRest(0);
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
    }
    void cleanup()
    {
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_language.reset();
    }

    void whatIsTypedIsDoneWithReturnOrEscape_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Return") << int(Qt::Key_Return);
        QTest::newRow("Enter") << int(Qt::Key_Enter);
        QTest::newRow("Escape") << int(Qt::Key_Escape);
    }
    void whatIsTypedIsDoneWithReturnOrEscape()
    {
        QFETCH(int, key);
        auto* host = m_window->findChild<ViewportHost*>();
        auto* row = m_window->properties()->row(*findParam("grammar.iterations"));
        auto* field = row->findChild<NumberField*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "x"); // no number: it stays where it is typed, and is marked
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
        QCOMPARE(QApplication::focusWidget(), field);
        field->selectAll();
        QTest::keyClicks(field, "4");
        QTest::keyClick(field, Qt::Key(key));
        QTRY_VERIFY(!field->hasFocus());
        QVERIFY(host == QApplication::focusWidget() || host->isAncestorOf(QApplication::focusWidget()));
        auto* lines = m_window->findChild<GrammarEdit*>();
        lines->setFocus();
        QTest::keyClick(lines, Qt::Key(key)); // a text of several lines
        QCoreApplication::processEvents();
        QCOMPARE(QApplication::focusWidget(), lines);
    }

    /// Keys that follow a press elsewhere are for the view.
    void aPressElsewhereLeavesTheField()
    {
        auto* search = m_window->findChild<QLineEdit*>(QStringLiteral("presetSearch"));
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("galleryDock"));
        dock->show();
        dock->raise();
        auto* tile = m_window->findChild<QAbstractButton*>(QStringLiteral("preset.Baobab"));
        QTRY_VERIFY(tile->isVisible() && search->isVisible());
        const QList<QWidget*> places{tile->parentWidget(), tile, m_window->statusBar()};
        for (QWidget* place : places) {
            search->setFocus();
            QTRY_VERIFY(search->hasFocus());
            QTest::mousePress(search, Qt::LeftButton); // within
            QTest::mouseRelease(search, Qt::LeftButton);
            QVERIFY(search->hasFocus());
            QTest::mousePress(place, Qt::LeftButton, {}, {2, 2});
            QVERIFY(!search->hasFocus());
            QTest::mouseRelease(place, Qt::LeftButton, {}, {-5, -5}); // no click: nothing is planted
        }
    }

    void speciesStandFirstInTheMenu()
    {
        const auto menuOf = [this](const char* id) {
            const auto* action = m_window->findChild<QAction*>(QLatin1String(id));
            return qobject_cast<QMenu*>(action->associatedObjects().constFirst());
        };
        QMenu *species = menuOf("file.new.Baobab"), *grammars = menuOf("file.new.SmallTree");
        QVERIFY(species && grammars && species != grammars);
        const QList<QAction*> groups = qobject_cast<QMenu*>(species->parent())->actions();
        QVERIFY(groups.indexOf(species->menuAction()) < groups.indexOf(grammars->menuAction()));
        QCOMPARE(grammars->title(), QStringLiteral("Grammar examples")); // scripts know it as "Coursework"
        restart("fr");
        species = menuOf("file.new.Baobab");
        grammars = menuOf("file.new.SmallTree");
        QCOMPARE(grammars->title(), QStringLiteral("Exemples de grammaires"));
        QStringList names;
        for (const QAction* action : species->actions())
            names += action->text();
        QStringList sorted = names;
        QCollator collator{QLocale(QLocale::French)};
        std::ranges::stable_sort(sorted, [&](const QString& a, const QString& b) { return collator(a, b); });
        QCOMPARE(names, sorted);
        QVERIFY(names.contains(QStringLiteral("Baobab africain")) &&
                names.front() != QStringLiteral("American Elm"));
        Preferences().language.set(QStringLiteral("en"));
    }

    void wrongGrammarsShowWhereAndKeepTheTree()
    {
        const QString counts = m_window->status()->countsText();
        QVERIFY(!counts.isEmpty());
        QVERIFY(m_window->problem()->message().isEmpty());
        const ParamDef& rules = *findParam("grammar.rules");
        QVERIFY(edit::setParam(*m_document, {tree()}, rules, std::string("B -> B\nA -> [[B]")));
        QTRY_VERIFY(!m_window->problem()->message().isEmpty());
        QVERIFY2(m_window->problem()->message().contains(QStringLiteral("line 2, column 6")),
                 qPrintable(m_window->problem()->message()));
        QVERIFY(m_window->properties()->row(rules)->message().contains(QStringLiteral("ine 2, column 6")));
        QCOMPARE(m_window->status()->badgeState(), QStringLiteral("bad"));
        QCOMPARE(m_window->status()->countsText(), counts); // the last good tree
        m_window->problem()->click();
        QTRY_VERIFY(m_window->properties()->row(rules)->isAncestorOf(QApplication::focusWidget()));
        action("edit.undo")->trigger();
        QTRY_VERIFY(m_window->problem()->message().isEmpty());
        QTRY_VERIFY(isClosed());
    }

    void errorsOfBeforeAreNoErrorsOfNow()
    {
        const ParamDef& rules = *findParam("grammar.rules");
        QVERIFY(edit::setParam(*m_document, {tree()}, rules, std::string("A -> [[B]")));
        QTRY_COMPARE(m_window->status()->badgeState(), QStringLiteral("bad"));
        QVERIFY(!m_window->problem()->message().isEmpty());
        QVERIFY(edit::setParam(*m_document, {tree()}, rules, std::string("A -> [B]")));
        QCOMPARE(m_window->status()->badgeState(), QStringLiteral("busy")); // before any result
        QVERIFY(m_window->problem()->message().isEmpty());
        QTRY_VERIFY(isClosed());
    }

    void rulesThatExplodeStopWithAMessage()
    {
        QVERIFY(edit::setParams(*m_document, {tree()},
                                {{findParam("grammar.axiom"), std::string("A")},
                                 {findParam("grammar.rules"), std::string("A -> AAAAAAAA")},
                                 {findParam("grammar.iterations"), std::int64_t{30}}},
                                QStringLiteral("explode")));
        QTRY_VERIFY(!m_window->problem()->message().isEmpty());
    }

    void spaceGrowsAnotherTreeAndUndoBringsItBack()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
        const NodeParams before = m_document->scene().nodes().front().params;
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QVERIFY(m_document->scene().nodes().front().params.grammar.stochastic);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(m_document->scene().nodes().front().params == before);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!(m_document->scene().nodes().front().params == before));
    }

    void newTreeIsOffWhereNothingCanVary()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("Fern2D")));
        const QAction* newTree = action("edit.newTree");
        QVERIFY(newTree->isEnabled());
        const QString usual = newTree->toolTip();
        for (const char* key : {"variation.angle", "variation.length", "variation.radius"}) {
            QVERIFY(newTree->isEnabled());
            QVERIFY(edit::setParam(*m_document, {1}, *findParam(key), 0.0));
        }
        QVERIFY(!newTree->isEnabled());
        QVERIFY(newTree->toolTip().contains(QStringLiteral("nothing can vary")));
        const int steps = m_document->undoStack()->count();
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QCOMPARE(m_document->undoStack()->count(), steps);
        m_document->undo();
        QVERIFY(newTree->isEnabled());
        QCOMPARE(newTree->toolTip(), usual);
    }

    void spaceStillTicksBoxesAndTypes()
    {
        auto* box = m_window->properties()->row(*findParam("simplify.enabled"))->findChild<QCheckBox*>();
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(!m_document->scene().nodes().front().params.simplify.enabled);
        QVERIFY(!m_document->scene().nodes().front().params.grammar.stochastic);
        auto* text = m_window->properties()->row(*findParam("grammar.rules"))->findChild<GrammarEdit*>();
        text->setFocus();
        QTest::keyClicks(text, "A -> B");
        QVERIFY(text->toPlainText().contains(QStringLiteral("A -> B")));
        QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!text->toPlainText().contains(QStringLiteral("A -> B")));
    }

    void nodesAreAddedDuplicatedHiddenAndDeleted()
    {
        m_window->edits()->addTree(QStringLiteral("Fern2D"));
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(2));
        action("edit.duplicate")->trigger();
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(3));
        action("edit.visible")->trigger();
        QVERIFY(!m_document->scene().find(m_document->selection().activeNode())->visible);
        action("edit.locked")->trigger();
        action("edit.delete")->trigger(); // locked: refused
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(3));
        QCOMPARE(m_chooser.reports.size(), 1);
        action("edit.locked")->trigger();
        action("edit.delete")->trigger();
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(2));
        action("edit.addGroup")->trigger();
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(3));
        while (m_document->undoStack()->canUndo())
            action("edit.undo")->trigger();
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(1));
    }

    void theTitleNamesTheFileAndMarksChanges()
    {
        QVERIFY(m_window->windowTitle().contains(QStringLiteral("[*]")));
        QVERIFY(!m_window->isWindowModified());
        m_window->edits()->addKind(kindRow(NodeKind::Group));
        QVERIFY(m_window->isWindowModified());
        QTemporaryDir folder;
        m_chooser.answer = folder.filePath(QStringLiteral("oak.ramure"));
        action("file.save")->trigger();
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("oak.ramure")));
    }

    void messagesGoWhenWhatFailedSucceeds()
    {
        QTemporaryDir folder;
        m_window->banner()->showMessage(Severity::Error, QStringLiteral("could not be saved"));
        m_chooser.answer = folder.filePath(QStringLiteral("missing/oak.ramure"));
        action("file.saveAs")->trigger();
        QCOMPARE(m_chooser.reports.size(), 1);
        QVERIFY(!m_window->banner()->text().isEmpty()); // it failed again
        m_chooser.answer = folder.filePath(QStringLiteral("oak.ramure"));
        action("file.saveAs")->trigger();
        QVERIFY(m_window->banner()->text().isEmpty());
        m_window->banner()->showMessage(Severity::Error, QStringLiteral("cannot be opened"));
        QVERIFY(m_window->files()->openFile(m_chooser.answer));
        QVERIFY(m_window->banner()->text().isEmpty());
        // A file given at the start that cannot be opened: the preset shown instead must not hide why.
        m_window->banner()->showMessage(Severity::Error, QStringLiteral("cannot be opened"));
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("Fern2D")));
        QVERIFY(!m_window->banner()->text().isEmpty());
    }

    void theStatusBarKeepsItsHeightWhileComputing()
    {
        StatusPanel* status = m_window->status();
        const int height = status->sizeHint().height();
        for (auto* widget : status->findChildren<QToolButton*>())
            widget->show();
        for (auto* widget : status->findChildren<QProgressBar*>())
            widget->show();
        QCOMPARE(status->sizeHint().height(), height);
    }

    void theStatusBarSaysThatTheBarkIsBeingMade()
    {
        auto* bark = m_window->status()->findChild<QLabel*>(QStringLiteral("barkMissing"));
        QVERIFY(bark && bark->isHidden() && !bark->text().isEmpty());
        m_window->status()->setMakesBark(true);
        QVERIFY(bark->isHidden()); // it may be quick
        QTRY_VERIFY(!bark->isHidden());
        m_window->status()->setMakesBark(false);
        QVERIFY(bark->isHidden());
    }

    void closingAsksAboutUnsavedChanges()
    {
        m_window->edits()->addKind(kindRow(NodeKind::Group));
        m_chooser.unsaved = Chooser::Unsaved::Cancel;
        QVERIFY(!m_window->close());
        QCOMPARE(m_chooser.questions, 1);
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        QVERIFY(m_window->close());
    }

    void closingWhileSavingFailsKeepsTheDocument()
    {
        QTemporaryDir folder;
        m_chooser.answer = folder.filePath(QStringLiteral("oak.ramure"));
        action("file.save")->trigger();
        const auto before = test::filesIn(folder.path());
        m_window->edits()->addKind(kindRow(NodeKind::Group));
        const Scene scene = m_document->scene();
        m_chooser.unsaved = Chooser::Unsaved::Save;
        for (const bool byMenu : {false, true}) {
            const test::FailingDisk disk(2, ENOSPC); // the first call that is not the opening
            if (byMenu)
                action("file.quit")->trigger();
            else
                QVERIFY(!m_window->close());
            QVERIFY(disk.hasFailed());
            QVERIFY(m_window->isVisible());
            QVERIFY(m_document->isModified());
            QVERIFY(m_document->scene() == scene);
            QVERIFY(m_chooser.reports.last().contains(QStringLiteral("oak.ramure")));
            QVERIFY(m_chooser.reports.last().contains(QStringLiteral("No space left on device")));
            QVERIFY(test::filesIn(folder.path()) == before);
        }
        QCOMPARE(m_chooser.reports.size(), 2);
        QVERIFY(m_window->close()); // there is room again
        QVERIFY(test::filesIn(folder.path()) != before);
    }

    void preferencesThatCannotBeStoredAreTold()
    {
        const test::SmallDisk disk(0);
        m_preferences->theme.set(ThemeChoice::Dark);
        QTRY_COMPARE(m_chooser.reports.size(), 1);
        const QString name = QFileInfo(QSettings().fileName()).fileName();
        QVERIFY2(m_chooser.reports.last().contains(name), qPrintable(m_chooser.reports.last()));
        QCOMPARE(m_preferences->theme(), ThemeChoice::Dark);
    }

    void droppedFilesOpen()
    {
        QTemporaryDir folder;
        m_chooser.answer = folder.filePath(QStringLiteral("oak.ramure"));
        action("file.saveAs")->trigger();
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("Fern2D")));
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(folder.filePath(QStringLiteral("picture.jpg")))});
        QDragEnterEvent wrong({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        wrong.setAccepted(false);
        QCoreApplication::sendEvent(m_window.get(), &wrong);
        QVERIFY(!wrong.isAccepted());
        data.setUrls({QUrl::fromLocalFile(m_chooser.answer)});
        QDragEnterEvent right({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &right);
        QVERIFY(right.isAccepted());
        QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QTRY_COMPARE(m_document->filePath(), m_chooser.answer);
    }

    void droppedObjectsOpenOrAreAdded()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rock.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") > 0);
        file.close();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        const auto drop = [&](Qt::KeyboardModifiers keys) {
            QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, keys);
            QCoreApplication::sendEvent(m_window.get(), &enter);
            QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, keys);
            QCoreApplication::sendEvent(m_window.get(), &event);
        };
        drop(Qt::ShiftModifier); // into this scene
        QTRY_COMPARE(m_document->scene().nodes().size(), std::size_t(2));
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        drop(Qt::NoModifier);
        QTRY_COMPARE(m_document->scene().nodes().size(), std::size_t(1));
        QCOMPARE(m_document->scene().nodes()[0].name, std::string("rock"));
        QVERIFY(m_window->windowTitle().contains(QStringLiteral("Untitled")));
    }

    void sectionsAreSteppedThroughByKeys()
    {
        QVERIFY(!action("inspect.nextSection")->isEnabled());
        Selection one;
        one.branchNode = tree();
        one.branches = {0};
        one.activeBranch = 0;
        m_document->setSelection(one);
        QVERIFY(action("inspect.nextSection")->isEnabled());
        QSignalSpy inspected(m_window->inspector(), &BranchInspector::sectionInspected);
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Right, Qt::ControlModifier); // brings the inspector up
        QTRY_VERIFY(m_window->inspector()->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_Right, Qt::ControlModifier);
        const Index far = inspected.back()[2].value<Index>();
        QVERIFY(far >= 1);
        QTest::keyClick(m_window.get(), Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(inspected.back()[2].value<Index>(), far - 1);
        QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ShiftModifier);
        QWidget* field = QApplication::focusWidget();
        QCOMPARE(field->objectName(), QStringLiteral("rollField"));
        QTest::keyClicks(field, "30");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->scene().nodes().front().params.edits.size(), std::size_t{1});
        // In a field the same keys go from word to word.
        auto* search = m_window->properties()->findChild<QLineEdit*>();
        action("view.search")->trigger();
        search->setText(QStringLiteral("two words"));
        search->setFocus();
        const auto before = inspected.count();
        QTest::keyClick(search, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(inspected.count(), before);
    }

    void countsAreInTheRightNumber()
    {
        const std::pair<const char*, QString> words[] = {{"fr", QStringLiteral("·  1 branche")},
                                                         {"en", QStringLiteral("·  1 branch")}};
        for (const auto& [language, one] : words) {
            restart(language);
            QVERIFY(edit::setParam(*m_document, {tree()}, *findParam("grammar.axiom"), std::string("F")));
            QVERIFY(edit::setParam(*m_document, {tree()}, *findParam("grammar.iterations"), std::int64_t{0}));
            QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
            QTRY_VERIFY2(m_window->status()->countsText().endsWith(one),
                         qPrintable(m_window->status()->countsText()));
        }
        QVERIFY(!StatusPanel::timeText(0.0).contains(u'0'));
        QCOMPARE(StatusPanel::timeText(0.0042), QStringLiteral("4.2 ms"));
    }

    void everyActionHasTextAndNoShortcutTwice()
    {
        QMap<QString, QString> shortcuts;
        for (const QAction* each : m_window->actionSet()->actions()) {
            QVERIFY2(!each->text().isEmpty() && !each->toolTip().isEmpty(), qPrintable(each->objectName()));
            const QString keys = each->shortcut().toString();
            if (keys.isEmpty())
                continue;
            QVERIFY2(!shortcuts.contains(keys),
                     qPrintable(keys + u' ' + each->objectName() + u' ' + shortcuts[keys]));
            shortcuts[keys] = each->objectName();
        }
    }

    void toolTipsSayWhatFor()
    {
        const auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("mainToolBar"));
        for (const QAction* each : bar->actions()) {
            const QString id = each->objectName();
            if (id.isEmpty() || id == QLatin1String("edit.undo") || id == QLatin1String("edit.redo"))
                continue; // no action; or its text names what is undone
            QVERIFY2(!each->statusTip().isEmpty(), qPrintable(id));
            QVERIFY2(each->toolTip().endsWith(u'\n' + each->statusTip()), qPrintable(id));
            const QString name = each->toolTip().section(u'\n', 0, 0);
            QVERIFY2(name.startsWith(each->text().remove(u'&').remove(u'…')), qPrintable(name));
            const QString keys = each->shortcut().toString(QKeySequence::NativeText);
            QVERIFY2(keys.isEmpty() || name.endsWith(u'(' + keys + u')'), qPrintable(id));
        }
    }

    void textsChangeWithTheLanguageAtTheNextStart()
    {
        QCOMPARE(action("file.open")->text(), QStringLiteral("&Open…"));
        QSignalSpy said(m_window->statusBar(), &QStatusBar::messageChanged);
        action("view.language.fr")->trigger();
        QCOMPARE(m_preferences->language(), QStringLiteral("fr"));
        QCOMPARE(action("file.open")->text(), QStringLiteral("&Open…"));
        QVERIFY(said.constLast().constFirst().toString().contains(QStringLiteral("started again")));
        restart("fr");
        QCOMPARE(action("file.open")->text(), QStringLiteral("&Ouvrir…"));
        QVERIFY(m_window->menuBar()->actions().constFirst()->text().contains(QStringLiteral("Fichier")));
        const auto* label = m_window->properties()->row(*findParam("turtle.decay"))->findChild<QLabel*>();
        QCOMPARE(label->text(), QStringLiteral("Effilement"));
        Preferences().language.set(QStringLiteral("en"));
    }

    void theBadgeOpensTheValidationPanel()
    {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("validationDock"));
        auto* badge = m_window->status()->findChild<QLabel*>(QStringLiteral("badge"));
        QVERIFY(dock && badge);
        QTRY_VERIFY(isClosed());
        QVERIFY(badge->toolTip().contains(QStringLiteral("Validation")));
        dock->close();
        QTest::mouseClick(badge, Qt::LeftButton);
        QTRY_VERIFY(dock->isVisible() && !dock->visibleRegion().isEmpty());
    }

    void themesSwitchWhileRunning()
    {
        Theme theme(qApp, m_preferences.get());
        m_preferences->theme.set(ThemeChoice::Dark);
        QVERIFY(isDark(m_window->palette()));
        QVERIFY(!action("file.open")->icon().isNull());
        const QImage dark = action("file.open")->icon().pixmap(16, 16).toImage();
        m_preferences->theme.set(ThemeChoice::Light);
        QVERIFY(!isDark(m_window->palette()));
        QVERIFY(dark != action("file.open")->icon().pixmap(16, 16).toImage());
        m_preferences->theme.set(ThemeChoice::System);
    }
};

RAMURE_SUITE(TestMainWindow)

} // namespace tst_main_window

#include "tst_main_window.moc"
