#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/window/menu_search.h"
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>

namespace tst_menu_search {

using namespace ramure;

/// Letters in an open menu.
class TestMenuSearch : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QMenu> m_menu;
    MenuSearch* m_search = nullptr;
    QAction *m_sag = nullptr, *m_oak = nullptr;

    [[nodiscard]] QStringList shown() const
    {
        QStringList texts;
        for (const QAction* action : m_menu->actions())
            if (action->isVisible() && !action->isSeparator() && !action->text().isEmpty())
                texts += action->text();
        return texts;
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_menu = std::make_unique<QMenu>();
        m_search = new MenuSearch(m_menu.get());
        m_menu->addSection(QStringLiteral("Modifiers"));
        m_sag = m_menu->addAction(QStringLiteral("&Sag"));
        m_menu->addAction(QStringLiteral("&Gnarl"))->setToolTip(QStringLiteral("Limbs wander"));
        m_menu->addAction(QStringLiteral("Secret"))->setVisible(false);
        QMenu* below =
            m_menu->addMenu(QStringLiteral("Source &like a preset"))->addMenu(QStringLiteral("Trees"));
        m_oak = below->addAction(QStringLiteral("English oak"));
        below->addAction(QStringLiteral("Scots pine"));
        m_menu->popup({});
        QVERIFY(QTest::qWaitForWindowExposed(m_menu.get()));
    }
    void cleanup() { m_menu.reset(); }

    void whatIsNotThereIsSaid()
    {
        QTest::keyClicks(m_menu.get(), QStringLiteral("xyz"));
        QCOMPARE(shown().size(), 1);
        QVERIFY(!m_menu->actions().back()->isEnabled());
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(m_menu.get(), Qt::Key_Backspace);
        QCOMPARE(shown(), QStringList({"&Sag", "&Gnarl", "Source &like a preset"}));
        QTest::keyClick(m_menu.get(), Qt::Key_Space); // begins no word
        QVERIFY(m_search->field()->text().isEmpty());
    }

    void lettersFindWhatIsBelow()
    {
        QSignalSpy oak(m_oak, &QAction::triggered);
        QTest::keyClicks(m_menu.get(), QStringLiteral("oa"));
        QCOMPARE(shown(), QStringList({"English oak\tSource like a preset › Trees"}));
        QTest::keyClick(m_menu.get(), Qt::Key_Return);
        QCOMPARE(oak.size(), 1);
        QVERIFY(!m_menu->isVisible());
        QTRY_VERIFY(m_search->field()->text().isEmpty()); // and all is as before
        QCOMPARE(shown(), QStringList({"&Sag", "&Gnarl", "Source &like a preset"}));
    }

    void keysOfTheFieldAreTheMenus()
    {
        QSignalSpy sag(m_sag, &QAction::triggered);
        m_search->field()->setFocus();
        QTest::keyClicks(m_search->field(), QStringLiteral("s"));
        QVERIFY(shown().size() > 1);
        QCOMPARE(shown().front(), QStringLiteral("&Sag")); // a title that begins so
        QTest::keyClick(m_search->field(), Qt::Key_Down);
        QTest::keyClick(m_search->field(), Qt::Key_Up);
        QTest::keyClick(m_search->field(), Qt::Key_Return);
        QCOMPARE(sag.size(), 1);
        m_menu->popup({});
        QTest::keyClick(m_search->field(), Qt::Key_Escape);
        QVERIFY(!m_menu->isVisible());
    }

    void textsAreTranslated()
    {
        const test::InStars stars;
        QMenu menu;
        QVERIFY((new MenuSearch(&menu))->field()->placeholderText().startsWith(u'★'));
    }
};

RAMURE_SUITE(TestMenuSearch)

} // namespace tst_menu_search

#include "tst_menu_search.moc"
