// Kept views by their actions, in a real viewport.
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/actions/bookmark_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QApplication>
#include <QMenu>

namespace tst_bookmarks {

using namespace ramure;

class TestBookmarks : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }
private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void viewsComeBack()
    {
        test::ViewWindow window;
        window.show({320, 240});
        ActionSet set;
        BookmarkActions actions(&window.document, &window.host, &set, nullptr);
        QMenu menu;
        actions.fillMenu(&menu);
        QSignalSpy told(&actions, &BookmarkActions::messageRaised);

        Camera kept;
        kept.target = {1.0, 2.0, 3.0};
        kept.distance = 7.5;
        kept.yawRad = -1.4;
        kept.pitchRad = 0.4;
        kept.orthographic = true;
        window.view->setCamera(kept);
        set.find(QStringLiteral("view.keepBookmark.3"))->trigger();
        QCOMPARE(told.count(), 1);
        QCOMPARE(window.document.undoStack()->count(), 1);
        Camera other;
        other.yawRad = 2.0;
        window.view->setCamera(other);
        set.find(QStringLiteral("view.bookmark.3"))->trigger();
        QTRY_COMPARE(window.view->camera(), kept);
        QVERIFY(window.host.settings()->orthographic());
        QVERIFY(set.find(QStringLiteral("view.bookmark.3"))->text().contains(QLatin1String("left")));

        window.document.undo();
        set.find(QStringLiteral("view.bookmark.3"))->trigger(); // gone: it is said
        QCOMPARE(told.count(), 2);
        QVERIFY(set.find(QStringLiteral("view.bookmark.3"))->text().contains(QLatin1String("empty")));
        QCOMPARE(window.view->camera(), kept);
    }
    void theMenuSaysWhatIsThere()
    {
        test::ViewWindow window;
        window.show({320, 240});
        ActionSet set;
        BookmarkActions actions(&window.document, &window.host, &set, nullptr);
        QMenu menu;
        actions.fillMenu(&menu);
        auto* forget = menu.actions().front()->menu()->actions().back()->menu();
        QVERIFY(forget && !forget->isEnabled());
        set.find(QStringLiteral("view.keepBookmark.9"))->trigger();
        QVERIFY(forget->isEnabled());
        QVERIFY(set.find(QStringLiteral("view.forgetBookmark.9"))->isVisible());
        QVERIFY(!set.find(QStringLiteral("view.forgetBookmark.8"))->isVisible());
        set.find(QStringLiteral("view.forgetBookmark.9"))->trigger();
        QVERIFY(!forget->isEnabled());
    }
    void theOppositeSide()
    {
        test::ViewWindow window;
        window.show({320, 240});
        window.view->steer([](Camera& to) { to.setAxisView(AxisView::Front); });
        QTRY_COMPARE(window.view->camera().yawRad, 0.0);
        window.view->steer(std::mem_fn(&Camera::turnOpposite));
        QTRY_VERIFY(std::abs(std::abs(window.view->camera().yawRad) - 3.14159265358979) < 1e-9);
        window.view->steer([](Camera& to) { to.setAxisView(AxisView::Top); });
        QTRY_VERIFY(window.view->camera().pitchRad > 1.57);
        window.view->steer(std::mem_fn(&Camera::turnOpposite));
        QTRY_VERIFY(window.view->camera().pitchRad < -1.57);
    }
};

RAMURE_SUITE(TestBookmarks)

} // namespace tst_bookmarks

#include "tst_bookmarks.moc"
