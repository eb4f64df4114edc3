#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/arm_demo.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/window/main_window.h"
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <algorithm>
#include <map>

namespace tst_still_layouts {

using namespace ramure;

namespace {

/// Where each widget in sight stands in \p window, but for those in \p aside.
std::map<const QWidget*, QRect> placesIn(const QWidget* window, const QWidget* aside = nullptr)
{
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents();
    std::map<const QWidget*, QRect> places;
    for (const QWidget* widget : window->findChildren<QWidget*>())
        if (widget->isVisible() && widget != aside && !(aside && aside->isAncestorOf(widget)))
            places[widget] = QRect(widget->mapTo(window, QPoint()), widget->size());
    return places;
}

/// The widget that went elsewhere; empty: none did.
QByteArray moved(const std::map<const QWidget*, QRect>& before, const std::map<const QWidget*, QRect>& after)
{
    for (const auto& [widget, place] : before)
        if (const auto now = after.find(widget); now != after.end() && now->second != place)
            return QByteArray(widget->metaObject()->className()) + ' ' + widget->objectName().toUtf8();
    return {};
}

} // namespace

/// Nothing moves away under the pointer.
class TestStillLayouts : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    Preferences m_preferences;
    test::FakeChooser m_chooser;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;

    void addLanguages()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("French") << QStringLiteral("fr");
    }
    void setLanguage()
    {
        const auto* language = static_cast<QString*>(QTest::qData("language", qMetaTypeId<QString>()));
        m_preferences.language.set(*language);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
    }
    void cleanup()
    {
        m_recompute.reset();
        m_document.reset();
    }

    void messagesMoveNothing_data() { addLanguages(); }
    void messagesMoveNothing()
    {
        setLanguage();
        const Language language(m_preferences);
        MainWindow window(m_document.get(), m_recompute.get(), &m_preferences, &m_chooser);
        test::openNodes(*m_document, {test::treeNode(1, "oak")});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        MessageBanner* banner = window.banner();
        const auto places = [&] {
            auto found = placesIn(&window, banner);
            std::erase_if(found, [&](const auto& place) { // panels follow the checks of the tree
                return !qobject_cast<const QDockWidget*>(place.first) &&
                       !window.centralWidget()->isAncestorOf(place.first);
            });
            return found;
        };
        const auto before = places();
        for (const QString& text :
             {QStringLiteral("Short."), QStringLiteral("A message of many words. ").repeated(30)}) {
            banner->showMessage(Severity::Error, text);
            const QByteArray what = moved(before, places());
            QVERIFY2(what.isEmpty(), what.constData());
            QVERIFY(banner->isVisible() &&
                    banner->height() >= banner->layout()->heightForWidth(banner->width()));
        }
        banner->hide();
        window.hide();
    }

    /// Whatever tab comes to the front, the view and the places of the panels stay as they are.
    void panelsThatShareAPlaceMoveNothing_data() { addLanguages(); }
    void panelsThatShareAPlaceMoveNothing()
    {
        setLanguage();
        const Language language(m_preferences);
        MainWindow window(m_document.get(), m_recompute.get(), &m_preferences, &m_chooser);
        test::openNodes(*m_document, {test::treeNode(1, "oak")});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (const QSize size : {QSize(1280, 800), QSize(1280, 948), QSize(1900, 1000)}) {
            window.resize(size);
            QCoreApplication::processEvents();
            const QRect before = window.centralWidget()->geometry();
            for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
                QRect place = dock->geometry();
                for (const QDockWidget* tab : window.tabifiedDockWidgets(dock))
                    if (tab->x() >= 0) // the others lie beside the window
                        place = tab->geometry();
                dock->raise();
                QTRY_VERIFY(dock->x() >= 0);
                QCoreApplication::processEvents();
                QCOMPARE(window.centralWidget()->geometry(), before);
                QCOMPARE(dock->geometry(), place);
            }
        }
    }

    void exportPagesKeepTheirPlaces_data() { addLanguages(); }
    /// From page to page, whatever is chosen there, and when it says something.
    void exportPagesKeepTheirPlaces()
    {
        setLanguage();
        const Language language(m_preferences);
        test::openNodes(*m_document, {test::treeNode(1, "oak")});
        QVERIFY(m_recompute->waitForFull(test::patience(20'000)));
        ExportDialog dialog(m_document.get(), m_recompute.get(), &m_preferences, &m_chooser);
        dialog.setPictureLook({});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto* scroll = dialog.findChild<QScrollArea*>();
        const auto places = [&] { // of all but the page itself
            auto found = placesIn(&dialog, scroll->widget());
            std::erase_if(found, [&](const auto& place) { return scroll->isAncestorOf(place.first); });
            found.erase(scroll); // gives room to a message
            found[&dialog] = QRect(QPoint(), dialog.size());
            return found;
        };
        const auto before = places();
        QVERIFY(before.contains(dialog.findChild<QTabBar*>(QStringLiteral("exportUses"))));
        QVERIFY(std::ranges::count_if(before, [](const auto& place) {
                    return qobject_cast<const QPushButton*>(place.first) != nullptr;
                }) >= 2);
        const auto* format = dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"));
        const int column = format->x();
        const int highest = dialog.screen()->availableSize().height() * 19 / 20;
        for (const ExportUse use : exportUses) {
            dialog.setUse(use);
            for (const ExportMoment moment : {ExportMoment::Rest, ExportMoment::Sequence}) {
                dialog.moments()->setMoment(moment);
                for (const bool isRefused : {false, true}) {
                    dialog.setPath(isRefused ? QStringLiteral("tree.unknown") : QStringLiteral("tree.glb"));
                    if (isRefused)
                        dialog.startExport();
                    const QByteArray what = moved(before, places());
                    QVERIFY2(what.isEmpty(), what.constData());
                    QVERIFY2(scroll->verticalScrollBar()->maximum() == 0 || dialog.height() >= highest,
                             qPrintable(titleOf(use)));
                    QCOMPARE_GE(scroll->viewport()->width(), scroll->widget()->minimumSizeHint().width());
                    QCOMPARE(format->x(), column);
                }
            }
        }
    }

    void theArmPanelStaysWhileTheArmReaches_data() { addLanguages(); }
    void theArmPanelStaysWhileTheArmReaches()
    {
        setLanguage();
        const Language language(m_preferences);
        ArmReach reach(m_document.get());
        ArmPanel panel(m_document.get());
        panel.setReach(&reach);
        m_document->reset(armDemo(), {});
        panel.resize(330, 420);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto before = placesIn(&panel);
        const NodeId arm = m_document->scene().nodes().front().id;
        for (const glm::dvec3 target : {glm::dvec3(0.4, 0.8, 0.3), glm::dvec3(900.0, 0.0, 0.0)}) {
            reach.reachFor(arm, target, 0);
            QTRY_VERIFY(reach.progress() && !reach.progress()->moves);
            const QByteArray what = moved(before, placesIn(&panel));
            QVERIFY2(what.isEmpty(), what.constData());
        }
    }
};

RAMURE_SUITE(TestStillLayouts)

} // namespace tst_still_layouts

#include "tst_still_layouts.moc"
