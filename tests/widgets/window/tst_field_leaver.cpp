#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

namespace tst_field_leaver {

using namespace ramure;

/// Whose the keys are, after something was searched for in a panel.
class TestFieldLeaver : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    Preferences m_preferences;
    test::FakeChooser m_chooser;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] bool viewHasFocus() const
    {
        const auto* host = m_window->findChild<ViewportHost*>();
        const QWidget* focus = QApplication::focusWidget();
        return focus && (focus == host || host->isAncestorOf(focus));
    }
    /// The search fields of all docked panels.
    [[nodiscard]] QList<QLineEdit*> panelSearches() const
    {
        QList<QLineEdit*> fields = m_window->findChildren<QLineEdit*>();
        fields.removeIf([this](const QLineEdit* field) {
            const QWidget* around = field->parentWidget();
            while (around && !qobject_cast<const QDockWidget*>(around))
                around = around->parentWidget();
            return !field->isClearButtonEnabled() || !around || field->window() != m_window.get() ||
                   !field->parentWidget()->isEnabled();
        });
        return fields;
    }
    void enter(QLineEdit* field)
    {
        for (QWidget* around = field; around; around = around->parentWidget())
            if (auto* dock = qobject_cast<QDockWidget*>(around)) {
                dock->show();
                dock->raise();
            }
        QTRY_VERIFY(field->isVisible());
        field->setFocus(Qt::MouseFocusReason);
        QTRY_VERIFY(field->hasFocus());
    }
    static QToolButton* crossOf(const QLineEdit* field)
    {
        for (auto* button : field->findChildren<QToolButton*>())
            if (button->defaultAction()->objectName().contains(QStringLiteral("clear")))
                return button;
        return nullptr;
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window =
            std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), &m_preferences, &m_chooser);
        test::openNodes(*m_document, {test::treeNode(1, "oak")});
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
    }

    void theCrossGivesTheKeysBack()
    {
        int panels = 0;
        for (QLineEdit* field : panelSearches()) {
            ++panels;
            enter(field);
            QTest::keyClicks(field, "oak");
            QToolButton* cross = crossOf(field);
            QVERIFY2(cross, qPrintable(field->objectName()));
            QTRY_VERIFY(cross->isVisible());
            QTest::mouseClick(cross, Qt::LeftButton);
            QVERIFY2(field->text().isEmpty(), qPrintable(field->objectName()));
            QTRY_VERIFY2(viewHasFocus(), qPrintable(field->objectName()));
        }
        QVERIFY(panels >= 3); // scene, gallery, properties
    }

    void escapeGivesTheSearchUp()
    {
        for (QLineEdit* field : panelSearches()) {
            enter(field);
            QTest::keyClicks(field, "oak");
            QTest::keyClick(field, Qt::Key_Escape);
            QTRY_VERIFY2(viewHasFocus(), qPrintable(field->objectName()));
            QVERIFY2(field->text().isEmpty(), qPrintable(field->objectName()));
        }
    }

    /// Only Esc gives up: Return is the beginning of work on what was found.
    void returnKeepsTheSearch()
    {
        auto* search = m_window->properties()->findChild<QLineEdit*>();
        enter(search);
        QTest::keyClicks(search, "no such thing");
        QTest::keyClick(search, Qt::Key_Return);
        QTRY_VERIFY(viewHasFocus());
        QCOMPARE(search->text(), QStringLiteral("no such thing"));
    }

    void theButtonThatClearsGivesTheKeysBack()
    {
        auto* search = m_window->properties()->findChild<QLineEdit*>();
        enter(search);
        QTest::keyClicks(search, "no such thing");
        auto* clear = m_window->findChild<QPushButton*>(QStringLiteral("clearSearch"));
        QTRY_VERIFY(clear->isVisible());
        QTest::mouseClick(clear, Qt::LeftButton);
        QVERIFY(search->text().isEmpty());
        QTRY_VERIFY(viewHasFocus());
    }

    /// What is typed is the field's, wherever the pointer is.
    void lettersStayInTheField()
    {
        auto* search = m_window->properties()->findChild<QLineEdit*>();
        enter(search);
        QTest::keyClicks(search, "gr"); // two keys of tools
        QTest::mouseMove(m_window->findChild<ViewportHost*>());
        QTest::keyClicks(QApplication::focusWidget(), "ammar");
        QCOMPARE(search->text(), QStringLiteral("grammar"));
    }

    void undoIsTheDocumentsUnlessSomethingWasTyped()
    {
        const ParamDef& def = *findParam("turtle.alpha");
        const auto edit = [&] { return edit::setParam(*m_document, {1}, def, ParamValue(0.7)); };
        QVERIFY(edit());
        auto* search = m_window->properties()->findChild<QLineEdit*>();
        enter(search);
        QTest::keyClicks(search, "turn");
        QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_document->undoStack()->index(), 1);
        QVERIFY(search->text() != QStringLiteral("turn"));
        search->setText({}); // as a new search begins
        QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_document->undoStack()->index(), 0);
    }
};

RAMURE_SUITE(TestFieldLeaver)

} // namespace tst_field_leaver

#include "tst_field_leaver.moc"
