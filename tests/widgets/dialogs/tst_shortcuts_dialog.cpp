#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/gesture_keys.h"
#include "widgets/dialogs/shortcuts_dialog.h"
#include "widgets/window/main_window.h"
#include <QTreeWidget>
#include <algorithm>

namespace tst_shortcuts_dialog {

using namespace ramure;

class TestShortcutsDialog : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    test::FakeChooser m_chooser;
    std::unique_ptr<MainWindow> m_window;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    QList<QMenu*> menus()
    {
        QList<QMenu*> found;
        for (const QAction* top : m_window->menuBar()->actions())
            found += top->menu();
        return found;
    }
    std::unique_ptr<ShortcutsDialog> dialog()
    {
        return std::make_unique<ShortcutsDialog>(m_window->actionSet(), menus(), m_preferences.get());
    }
    void openWindow()
    {
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        openWindow();
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
    }

    void everyActionIsInAMenuAndSaysWhatItIs()
    {
        const QList<ListedAction> listed = listedActions(*m_window->actionSet(), menus());
        QSet<const QAction*> inMenus;
        for (const ListedAction& each : listed)
            inMenus += each.action;
        for (const QAction* each : m_window->actionSet()->actions()) {
            const QByteArray id = each->objectName().toUtf8();
            QVERIFY2(!id.isEmpty(), qPrintable(each->text()));
            QVERIFY2(!each->text().isEmpty(), id);
            QVERIFY2(!each->toolTip().isEmpty() || !each->statusTip().isEmpty(), id);
            QVERIFY2(inMenus.contains(each), id); // Alt and arrow keys lead to it
        }
        // No entry of a menu is left out, but for those made anew each time (recent files).
        for (QMenu* menu : menus())
            for (const QAction* each : menu->actions())
                if (!each->isSeparator() && !each->menu())
                    QVERIFY2(inMenus.contains(each), qPrintable(each->text()));
    }

    /// The long lists of trees, which have no keys, come last: what is seen first has some.
    void itBeginsWithActionsThatHaveKeys()
    {
        auto shown = dialog();
        shown->show();
        auto* tree = shown->findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
        QCOMPARE(tree->currentItem(), tree->topLevelItem(0)->child(0));
        QVERIFY(!tree->currentItem()->text(1).isEmpty());
        QVERIFY(tree->viewport()->rect().contains(tree->visualItemRect(tree->topLevelItem(0))));
        bool hadNone = false;
        for (int i = 0; i < tree->topLevelItemCount(); ++i) {
            const QTreeWidgetItem* group = tree->topLevelItem(i);
            bool hasKeys = false;
            for (int j = 0; j < group->childCount(); ++j)
                hasKeys = hasKeys || !group->child(j)->text(1).isEmpty();
            QVERIFY2(!hasKeys || !hadNone, qPrintable(group->text(0)));
            hadNone = hadNone || !hasKeys;
        }
        QVERIFY(hadNone);
    }

    /// Keys of gestures are found there too; they cannot be changed.
    void keysOfGesturesAreListed()
    {
        for (const char* code : {"en", "fr"}) {
            m_preferences->language.set(QString::fromLatin1(code));
            const Language language(*m_preferences);
            openWindow();
            auto shown = dialog();
            auto* tree = shown->findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
            auto* edit = shown->findChild<QWidget*>(QStringLiteral("keys"));
            int rows = 0;
            for (const GestureKeys& group : gestureKeys()) {
                QVERIFY(!group.title.isEmpty());
                for (const GestureKey& key : group.keys) {
                    QVERIFY2(!key.text.isEmpty() && !key.keys.isEmpty(), qPrintable(group.title));
                    const auto found = tree->findItems(key.text, Qt::MatchExactly | Qt::MatchRecursive);
                    QVERIFY2(!found.isEmpty(), qPrintable(key.text));
                    QVERIFY(std::any_of(found.begin(), found.end(), [&](const QTreeWidgetItem* item) {
                        return item->text(1) == key.keys && item->parent()->text(0) == group.title;
                    }));
                    tree->setCurrentItem(found.front());
                    QVERIFY(!edit->isEnabled());
                    QVERIFY(!shown->assign(QKeySequence(Qt::Key_X)));
                    ++rows;
                }
            }
            QVERIFY(rows > 20);
            QVERIFY(gestureKeys().front().keys.front().keys.contains(u'Y'));
        }
    }

    void noTwoActionsShareKeys()
    {
        QMap<QString, QString> owners;
        for (const QAction* each : m_window->actionSet()->actions()) {
            for (const QKeySequence& keys : each->shortcuts()) {
                const QString text = keys.toString();
                QVERIFY2(!owners.contains(text),
                         qPrintable(text + u' ' + each->objectName() + u' ' + owners.value(text)));
                owners.insert(text, each->objectName());
            }
        }
        QVERIFY(owners.size() > 20);
    }

    void everyMenuHasAKeyOfItsOwn()
    {
        for (const char* code : {"en", "fr"}) {
            m_preferences->language.set(QString::fromLatin1(code));
            const Language language(*m_preferences);
            openWindow();
            QSet<QString> keys;
            for (const QAction* top : m_window->menuBar()->actions()) {
                const QString key = QKeySequence::mnemonic(top->text()).toString();
                QVERIFY2(!key.isEmpty() && !keys.contains(key), qPrintable(top->text()));
                keys += key;
            }
            // Of two owners of a key neither is called.
            for (const QAction* each : m_window->actionSet()->actions())
                for (const QKeySequence& own : each->shortcuts())
                    QVERIFY2(!keys.contains(own.toString()), qPrintable(each->objectName()));
        }
    }

    void keysAreChangedStoredAndRestored()
    {
        const QKeySequence keys(Qt::CTRL | Qt::ALT | Qt::Key_G);
        const QKeySequence before = action("view.grid")->shortcut();
        auto shown = dialog();
        shown->select(QStringLiteral("view.grid"));
        QVERIFY(shown->assign(keys));
        QCOMPARE(action("view.grid")->shortcut(), keys);
        QVERIFY(action("view.grid")->toolTip().contains(keys.toString(QKeySequence::NativeText)));
        shown.reset();
        openWindow(); // as at the next start
        QCOMPARE(action("view.grid")->shortcut(), keys);
        QCOMPARE(m_window->actionSet()->defaultShortcut(action("view.grid")), before);
        shown = dialog();
        shown->select(QStringLiteral("view.grid"));
        shown->resetSelected();
        QCOMPARE(action("view.grid")->shortcut(), before);
        QVERIFY(m_preferences->shortcuts().isEmpty());
    }

    void keysOfOthersAreRefused()
    {
        auto shown = dialog();
        shown->select(QStringLiteral("view.grid"));
        const QKeySequence before = action("view.grid")->shortcut();
        QVERIFY(!shown->assign(action("file.save")->shortcut()));
        QVERIFY(shown->conflict().contains(QStringLiteral("Save")));
        QCOMPARE(action("view.grid")->shortcut(), before);
        // Also where one is the beginning of the other.
        QVERIFY(!shown->assign(QKeySequence(QStringLiteral("Ctrl+S, A"))));
        // Taken away there, they are free; and the reset of the old owner is then refused.
        const QKeySequence save = action("file.save")->shortcut();
        shown->select(QStringLiteral("file.save"));
        QVERIFY(shown->assign({}));
        QVERIFY(action("file.save")->shortcut().isEmpty());
        shown->select(QStringLiteral("view.grid"));
        QVERIFY(shown->assign(save));
        shown->select(QStringLiteral("file.save"));
        shown->resetSelected();
        QVERIFY(action("file.save")->shortcut().isEmpty());
        QVERIFY(!shown->conflict().isEmpty());
        shown->resetAll();
        QCOMPARE(action("file.save")->shortcut(), save);
        QCOMPARE(action("view.grid")->shortcut(), before);
    }

    void keysAreTyped()
    {
        auto shown = dialog();
        shown->show();
        QVERIFY(QTest::qWaitForWindowActive(shown.get()));
        shown->select(QStringLiteral("view.mesh"));
        auto* edit = shown->findChild<QKeySequenceEdit*>(QStringLiteral("keys"));
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_J, Qt::ControlModifier);
        QTRY_COMPARE(action("view.mesh")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
    }

    void searchingHidesTheRest()
    {
        auto shown = dialog();
        auto* tree = shown->findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
        const auto visible = [tree] {
            QStringList texts;
            for (QTreeWidgetItemIterator it(tree, QTreeWidgetItemIterator::NotHidden); *it; ++it)
                if ((*it)->parent())
                    texts += (*it)->text(0);
            return texts;
        };
        const auto all = visible().size();
        QVERIFY(all > 40);
        auto* search = shown->findChild<QLineEdit*>();
        search->setText(QStringLiteral("ctrl+s"));
        QVERIFY(visible().contains(QStringLiteral("Save")));
        QVERIFY(visible().size() < all / 4);
        search->setText(QStringLiteral("nothing like this"));
        QVERIFY(visible().isEmpty());
        search->clear();
        QCOMPARE(visible().size(), all);
    }

    /// Keys go to a row that is seen, or to none.
    void hiddenRowsGetNoKeys()
    {
        auto shown = dialog();
        shown->show();
        QVERIFY(QTest::qWaitForWindowActive(shown.get()));
        auto* tree = shown->findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
        auto* search = shown->findChild<QLineEdit*>();
        auto* edit = shown->findChild<QKeySequenceEdit*>(QStringLiteral("keys"));
        shown->select(QStringLiteral("file.save"));
        QTest::keyClicks(search, "grid");
        QVERIFY(tree->currentItem() && !tree->currentItem()->isHidden());
        const auto* seen = tree->currentItem()->data(0, Qt::UserRole).value<QAction*>();
        QVERIFY(seen && seen != action("file.save"));
        const QKeySequence save = action("file.save")->shortcut();
        const QPoint place = tree->visualItemRect(tree->currentItem()).center();
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, place);
        QVERIFY(edit->hasFocus());
        QTest::keyClick(edit, Qt::Key_J, Qt::ControlModifier);
        QTRY_COMPARE(seen->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
        QCOMPARE(action("file.save")->shortcut(), save);
        // Gestures alone: nothing can be changed.
        search->setText(gestureKeys().front().keys.front().text);
        QVERIFY(!edit->isEnabled());
        QVERIFY(!shown->assign(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_J)));
        shown->resetSelected();
        QCOMPARE(seen->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
        // Asked for by name, a row comes into sight.
        shown->select(QStringLiteral("file.save"));
        QVERIFY(search->text().isEmpty());
        QVERIFY(!tree->currentItem()->isHidden());
    }
};

RAMURE_SUITE(TestShortcutsDialog)

} // namespace tst_shortcuts_dialog

#include "tst_shortcuts_dialog.moc"
