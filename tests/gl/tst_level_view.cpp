#include "core/presets/presets.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/levels/level_view.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QApplication>

namespace tst_level_view {

using namespace ramure;

/// Pictures of levels, as the panel shows them.
class TestLevelView : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }
    static constexpr int patienceMs = test::patience(60'000);

    /// Pixels of leaves: green.
    static int green(const QImage& picture)
    {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                count += colour.green() > colour.blue() + 15 ? 1 : 0;
            }
        return count;
    }

private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void aLevelLooksLikeTheTreeFromItsDistance()
    {
        test::TreeDocument trees;
        QVERIFY(trees.add(*presetParams("TinyTree")) != noNode);
        LevelWatch watch(&trees.document());
        watch.setRest(0);
        watch.setOptions({2, {}});
        watch.setActive(true);
        QTRY_VERIFY_WITH_TIMEOUT(watch.state() == LevelWatch::State::Done, patienceMs);
        const auto levels = watch.levels();

        LevelView level, whole;
        LevelShot shot;
        shot.distance = levels->switches.unseen[1];
        shot.enlarged = true;
        for (LevelView* view : {&level, &whole}) {
            view->resize(160, 160);
            view->setShot(shot);
            view->setLevel(levels, view == &level ? std::optional<std::size_t>(1) : std::nullopt);
            view->show();
            QVERIFY(QTest::qWaitForWindowExposed(view));
        }
        const auto settled = [&] {
            return !level.isBusy() && !whole.isBusy() && !level.picture().isNull() &&
                   !whole.picture().isNull();
        };
        QTRY_VERIFY_WITH_TIMEOUT(settled(), patienceMs);
        const int large = green(level.picture()), all = green(whole.picture());
        QVERIFY2(large > 500 && std::abs(large - all) < all / 4,
                 qPrintable(QStringLiteral("%1, %2").arg(large).arg(all)));

        shot.enlarged = false; // some pixels high
        const QImage before = level.picture();
        level.setShot(shot);
        QTRY_VERIFY_WITH_TIMEOUT(settled() && level.picture() != before, patienceMs);
        QVERIFY2(green(level.picture()) < large / 2, qPrintable(QString::number(green(level.picture()))));
        const QImage front = level.picture();
        QTest::keyClick(&level, Qt::Key_Right);
        QTRY_VERIFY_WITH_TIMEOUT(settled() && level.picture() != front, patienceMs);
        level.setLevel(nullptr, std::nullopt);
        QVERIFY(level.picture().isNull());
    }
};

RAMURE_SUITE(TestLevelView)

} // namespace tst_level_view

#include "tst_level_view.moc"
