#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"

namespace tst_viewport_marks {

using namespace ramure;

/// What is marked in the view: by the selection, and by panels that point at it.
class TestViewportMarks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// Without waiting for the next scene, which comes late while trees move.
    void theTintGoesWithTheSelectionAtOnce()
    {
        test::ViewWindow window;
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = *presetParams("TinyTree");
        window.document.reset(*Scene::fromNodes({node}), {});
        NodeResult result;
        result.revision = window.document.revision();
        result.tree = *TreePipeline().evaluate(node.params);
        window.document.setResult(1, std::move(result));
        window.host.settings()->displayMode.set(DisplayMode::Skeleton);
        window.host.settings()->outlineVisible.set(false);
        window.document.setSelection({{1}, noNode, {}, noIndex});
        window.show({480, 360});
        const QImage plain = window.view->grabFramebuffer();
        window.document.setSelection({{1}, 1, {0, 1}, 0});
        const QImage selected = window.view->grabFramebuffer();
        QVERIFY(test::differing(plain, selected) > 10);
        window.waitForPicture();
        QCOMPARE(test::differing(selected, window.view->grabFramebuffer()), 0);
        window.document.setSelection({{1}, noNode, {}, noIndex});
        QCOMPARE(test::differing(plain, window.view->grabFramebuffer()), 0);
    }
};

RAMURE_SUITE(TestViewportMarks)

} // namespace tst_viewport_marks

#include "tst_viewport_marks.moc"
