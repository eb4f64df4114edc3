#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/dialogs/export/print_view.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QApplication>

namespace tst_print_view {

using namespace ramure;

/// Pictures of prints, as the export dialog shows them.
class TestPrintView : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }
    static constexpr int patienceMs = test::patience(60'000);

    /// Pixels of overhangs: much more red than blue.
    static int orange(const QImage& picture)
    {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                count += colour.red() > colour.blue() + 60 ? 1 : 0;
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

    void overhangsHaveTheirColour()
    {
        const NodeParams params = *presetParams("TinyTree");
        const auto grown = TreePipeline().evaluate(params, Stage::Simplified);
        QVERIFY(grown);
        PrintOptions options;
        options.height = 0.06;
        const auto print = printTree(grown->simplified->skeleton, params, options);
        QVERIFY(print);
        PrintView view;
        view.resize(240, 240);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        view.setPrint(std::make_shared<const PrintedTree>(*print));
        const auto settled = [&] { return !view.isBusy() && !view.picture().isNull(); };
        QTRY_VERIFY_WITH_TIMEOUT(settled(), patienceMs);
        const QImage front = view.picture();
        QVERIFY2(orange(front) > 30, qPrintable(QString::number(orange(front))));
        QTest::keyClick(&view, Qt::Key_Left);
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.picture() != front, patienceMs);
        for (int i = 0; i < 10; ++i)
            QTest::keyClick(&view, Qt::Key_Up);
        QTRY_VERIFY_WITH_TIMEOUT(settled(), patienceMs);
        QVERIFY(orange(view.picture()) < orange(front)); // from above they are hidden
        view.showThinnest();
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.camera() == view.goal(), patienceMs);
        QVERIFY(view.camera().target == print->report.thinnestAt);
        view.setPrint(nullptr);
        QVERIFY(view.picture().isNull());
    }
};

RAMURE_SUITE(TestPrintView)

} // namespace tst_print_view

#include "tst_print_view.moc"
