#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/properties/leaf_dialog.h"
#include "widgets/panels/properties/leaf_scene.h"
#include "widgets/panels/properties/leaf_view.h"
#include <cmath>

namespace tst_leaf_dialog {

using namespace ramure;

/// A leaf and a twig, large.
class TestLeafDialog : public QObject
{
    Q_OBJECT

    /// Share of the pixels that are no background.
    static double covered(const QImage& picture)
    {
        const QRgb background = picture.pixel(2, 2);
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixelColor(x, y).green() > picture.pixelColor(x, y).blue() + 20 &&
                                 picture.pixel(x, y) != background
                             ? 1
                             : 0;
        return double(count) / (picture.width() * picture.height());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void sceneOfAnyLeaf()
    {
        for (int i = 0; i < leafShapeCount; ++i) {
            NodeParams params;
            params.leaf.shape = static_cast<LeafShape>(i);
            const RenderScene scene = leafScene(params);
            QCOMPARE(scene.meshes.size(), std::size_t(2));
            QVERIFY(scene.box.radius() > 0.0 && std::isfinite(scene.box.radius()));
            QVERIFY(scene.meshes[1].copies->copies.size() > 2); // the single one, and those of the twig
        }
        NodeParams none;
        none.leaf.shape = LeafShape::Birch;
        none.leaf.size = none.leaf.width = 0.0;
        QVERIFY(std::isfinite(leafScene(none).box.radius()));
        none.leaf = {};
        none.leaf.shape = LeafShape::Oak;
        none.leaf.season = 1.0; // bare, but for the single leaf
        QCOMPARE(leafScene(none).meshes[1].copies->copies.size(), std::size_t(1));
        none.leaf.internode = 0.001; // more than a tree may have
        QVERIFY(std::isfinite(leafScene(none).box.radius()));
    }
    void itFollowsTheNumbersAndTheMouse()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(*presetParams("TinyTree"));
        LeafDialog dialog(&trees.document(), nullptr);
        dialog.setTree(tree);
        dialog.resize(500, 400);
        dialog.show();
        dialog.activateWindow(); // no window manager does it
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        LeafView& view = *dialog.view();
        const auto settled = [&] { return !view.isBusy() && !view.picture().isNull(); };
        QTRY_VERIFY_WITH_TIMEOUT(settled(), test::patience(60'000));
        QVERIFY2(covered(view.picture()) > 0.05, qPrintable(QString::number(covered(view.picture()))));

        const QImage before = view.picture();
        QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("foliage.leafWidth"), 1.8));
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.picture() != before, test::patience(60'000));
        QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier); // as in the main window
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.picture() == before, test::patience(60'000));

        QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(&view, {180, 110});
        QTest::mouseRelease(&view, Qt::LeftButton, {}, {180, 110});
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.picture() != before, test::patience(60'000));
        QTest::keyClick(&view, Qt::Key_Home);
        QTRY_VERIFY_WITH_TIMEOUT(settled() && view.picture() == before, test::patience(60'000));
        trees.document().undo(); // the tree is gone: the last leaf stays
        QTRY_VERIFY(settled());
        QVERIFY(view.picture() == before);
    }
};

RAMURE_SUITE(TestLeafDialog)

} // namespace tst_leaf_dialog

#include "tst_leaf_dialog.moc"
