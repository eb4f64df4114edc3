#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/document.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QOpenGLContext>
#include <QSignalSpy>

namespace tst_context_loss {

using namespace ramure;

/// Contexts are not shared here: then Qt destroys the viewport's context whenever its window changes, and
/// everything on the graphics card with it.
class TestContextLoss : public QObject
{
    Q_OBJECT
public:
    static void initMain()
    {
        prepareOpenGl();
        QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts, false);
    }
private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void pictureComesBack()
    {
        Document document;
        Scene scene;
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Tree;
        node.params = *presetParams("TinyTree");
        const NodeId id = node.id;
        QVERIFY(scene.insert({node}, noNode, 0));
        document.reset(scene, {});
        NodeResult result;
        result.tree = *TreePipeline().evaluate(node.params);
        document.setResult(id, result);

        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* host = new ViewportHost(&document, dock);
        host->setFixedSize(300, 240);
        dock->setWidget(host);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        Viewport* view = host->viewport();
        const auto draw = [view] {
            QSignalSpy drawn(view, &Viewport::frameDrawn);
            view->update();
            return !drawn.isEmpty() || drawn.wait(test::patience(20'000));
        };
        QVERIFY(draw());
        QTRY_VERIFY_WITH_TIMEOUT(!view->work().picture && !view->work().settling,
                                 test::patience(20'000)); // bark comes later
        QVERIFY(draw());
        const QImage before = view->grabFramebuffer();
        int losses = 0;
        QPointer<QOpenGLContext> context = view->context();
        for (const bool floating : {true, false, true, false}) {
            dock->setFloating(floating);
            QVERIFY(draw());
            QTRY_VERIFY_WITH_TIMEOUT(!view->work().settling, test::patience(20'000));
            QVERIFY(draw());
            losses += context != view->context() ? 1 : 0;
            context = view->context();
            QCOMPARE(view->grabFramebuffer(), before);
        }
        QVERIFY2(losses > 0, "the test must lose a context");
    }
};

RAMURE_SUITE(TestContextLoss)

} // namespace tst_context_loss

#include "tst_context_loss.moc"
