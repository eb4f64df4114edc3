#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/base/hint_source.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/tools/limb_finder.h"
#include <QContextMenuEvent>

namespace tst_viewport_hand {

using namespace ramure;

/// What the hand does in the view: limbs that follow at once, a menu, hints, copies that move.
class TestViewportHand : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (const OpenGlProbe probe = probeOpenGl(); !probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }
    void aLimbIsSeenBeforeItsMesh();
    void escapeTakesALimbBack();
    void aLimbIsMadeWhileTheHandRests();
    void aRightClickAsksForAMenu();
    void theHintSaysTreeBeforeItMoves();
    void copiesMoveInTheSameStep();
};

namespace {

struct Window : test::ViewWindow
{
    Recompute recompute{&document};

    Window()
    {
        Scene scene;
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = presetParams("TinyTree").value_or(NodeParams{});
        (void)scene.insert({node}, noNode, 0);
        document.reset(scene, {});
        host.settings()->displayMode.set(DisplayMode::Simplified);
        compute();
        show({480, 360});
        view->setFocus();
    }
    void compute()
    {
        if (!recompute.waitForFull(test::patience(20'000)))
            qWarning("no result");
    }
    [[nodiscard]] NodeId tree() const { return document.scene().nodes().front().id; }
    [[nodiscard]] const Skeleton& skeleton() const
    {
        return document.result(tree())->tree.simplified->skeleton;
    }
    [[nodiscard]] std::vector<Index> limb() const { return LimbFinder().limbOf(document, tree(), twig()); }
    [[nodiscard]] Index twig() const { return skeleton().size() - 1; }
    [[nodiscard]] QPoint onTwig() const
    {
        return pixelOf(glm::mix(skeleton().p0[twig()], skeleton().p1[twig()], 0.8));
    }
    [[nodiscard]] bool isBent() const { return !document.scene().nodes().front().params.edits.empty(); }
    void click(QPoint at, Qt::MouseButton button = Qt::LeftButton) const
    {
        QTest::mouseClick(view, button, Qt::NoModifier, at);
        if (!QTest::qWaitFor([this] { return !view->work().pick; }))
            qWarning("the click has no effect");
    }
    /// Presses on the twig and drags it; the button stays down.
    void bend(QPoint by) const
    {
        const QPoint at = onTwig();
        click(at); // then what is picked in is ready
        waitForPicture();
        QTest::mousePress(view, Qt::LeftButton, Qt::ControlModifier, at);
        for (int i = 1; i <= 4; ++i)
            move(QPointF(at) + QPointF(by) * i / 4.0, Qt::LeftButton, Qt::ControlModifier);
    }
    void release(Qt::KeyboardModifiers modifiers = Qt::ControlModifier) const
    {
        QTest::mouseRelease(view, Qt::LeftButton, modifiers, {200, 150});
    }
};

/// How many points are of quite another colour. (The ground fades elsewhere around another box.)
int farApart(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor one = a.pixelColor(x, y), other = b.pixelColor(x, y);
            count += std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
                         std::abs(one.blue() - other.blue()) >
                     90;
        }
    return count;
}

} // namespace

void TestViewportHand::aLimbIsSeenBeforeItsMesh()
{
    Window window;
    window.host.settings()->outlineVisible.set(false); // it fades from one picture to the next
    window.waitForPicture();
    const QImage before = window.view->grabFramebuffer();
    window.bend({30, -12});
    QVERIFY(window.view->hints()->hint().contains(QStringLiteral("wheel")));
    QVERIFY(!window.isBent()); // nothing is computed
    QVERIFY(farApart(before, window.view->grabFramebuffer()) > 50);
    window.release();
    QVERIFY(window.isBent());
    QCOMPARE(window.document.undoStack()->count(), 1);
    const QImage posed = window.view->grabFramebuffer();
    window.compute();
    window.waitForPicture();
    const QImage made = window.view->grabFramebuffer();
    // The pose was the shape that has been made since. Marks without a branch are not posed: only the twig
    // counts.
    const QRect twig(window.onTwig() - QPoint(10, 10), QSize(21, 21));
    const int off = farApart(posed.copy(twig), made.copy(twig));
    const int moved = farApart(before.copy(twig), made.copy(twig));
    QVERIFY2(off < moved / 2, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(moved)));
}

void TestViewportHand::escapeTakesALimbBack()
{
    Window window;
    window.bend({30, -12});
    QTRY_VERIFY(window.isBent()); // the hand rests
    QCOMPARE(window.document.undoStack()->count(), 0);
    QTest::keyClick(window.view, Qt::Key_Escape);
    QVERIFY(!window.isBent());
    QVERIFY(!window.document.selection().branches.empty()); // Esc cleared no selection
    window.move({100, 100}, Qt::LeftButton, Qt::ControlModifier);
    window.release();
    QVERIFY(!window.isBent());
    QCOMPARE(window.document.undoStack()->count(), 0);
    window.compute();
    window.waitForPicture();
    QCOMPARE(window.document.selection().branches, window.limb());
    window.click(window.onTwig()); // again: the branch alone
    QCOMPARE(window.document.selection().branches, std::vector<Index>{window.twig()});
}

void TestViewportHand::aLimbIsMadeWhileTheHandRests()
{
    Window window;
    window.bend({30, -12});
    QTRY_VERIFY(window.isBent());
    const auto first = window.document.scene().nodes().front().params.edits;
    window.compute();
    window.waitForPicture();
    window.move(QPointF(window.onTwig()) + QPointF(-20.0, 4.0), Qt::LeftButton, Qt::ControlModifier);
    window.release();
    QVERIFY(window.document.scene().nodes().front().params.edits != first);
    QCOMPARE(window.document.undoStack()->count(), 1);
    window.document.undo();
    QVERIFY(!window.isBent());
}

void TestViewportHand::aRightClickAsksForAMenu()
{
    Window window;
    QSignalSpy menu(window.view, &Viewport::menuRequested);
    window.click(window.onTwig()); // then what is picked in is ready
    window.waitForPicture();
    window.view->clearSelection();
    window.click(window.onTwig(), Qt::RightButton);
    QCOMPARE(menu.count(), 1);
    QCOMPARE(menu.last()[1].value<NodeId>(), window.tree());
    QCOMPARE(menu.last()[2].value<Index>(), window.twig());
    QCOMPARE(window.document.selection().branches, window.limb());
    window.click({3, 3}, Qt::RightButton);
    QCOMPARE(menu.count(), 2);
    QCOMPARE(menu.last()[1].value<NodeId>(), noNode);
    QCOMPARE(window.document.selection().branches, window.limb()); // beside it nothing changes
    // A drag is none, nor is what turns the view.
    QTest::mousePress(window.view, Qt::RightButton, Qt::NoModifier, {100, 100});
    QTest::mouseRelease(window.view, Qt::RightButton, Qt::NoModifier, {160, 100});
    QTest::mouseClick(window.view, Qt::RightButton, Qt::AltModifier, {100, 100});
    QCOMPARE(menu.count(), 2);
    QContextMenuEvent key(QContextMenuEvent::Keyboard, {100, 100},
                          window.view->mapToGlobal(QPoint(100, 100)));
    QCoreApplication::sendEvent(window.view, &key);
    QCOMPARE(menu.count(), 3);
    QCOMPARE(menu.last()[2].value<Index>(), window.twig());
}

void TestViewportHand::theHintSaysTreeBeforeItMoves()
{
    Window window;
    window.view->setGestureKeys([] { return QStringLiteral("G R S"); });
    const HintSource* hints = window.view->hints();
    window.click(window.onTwig());
    QVERIFY2(hints->hint().contains(QStringLiteral("G R S: move, rotate, scale tree")),
             qPrintable(hints->hint()));
    QTest::keyPress(window.view, Qt::Key_Control);
    QVERIFY(!hints->hint().contains(QStringLiteral("G R S")));
    QTest::keyRelease(window.view, Qt::Key_Control);
    QVERIFY(!hints->isGesture());
    window.view->beginTransform(TransformTool::Move);
    QVERIFY(hints->isGesture());
    QVERIFY(hints->hint().startsWith(QStringLiteral("Move tree: ")));
    QTest::keyClick(window.view, Qt::Key_Escape);
    QVERIFY(!hints->isGesture());
}

void TestViewportHand::copiesMoveInTheSameStep()
{
    Window window;
    const Scene before = window.document.scene();
    const auto copy = [&] {
        QVERIFY(edit::duplicateNodes(window.document, {window.tree()}));
        window.view->beginMovingCopies();
        QVERIFY(window.view->work().transforming);
        QTest::keyClicks(window.view, QStringLiteral("x2"));
    };
    copy();
    QTest::keyClick(window.view, Qt::Key_Return);
    QCOMPARE(window.document.scene().nodes().back().params.tree.translation, glm::dvec3(2.0, 0.0, 0.0));
    QCOMPARE(window.document.undoStack()->count(), 1);
    window.document.undo();
    QVERIFY(window.document.scene() == before);
    // Given up, the copy stays where its original is.
    copy();
    QTest::keyClick(window.view, Qt::Key_Escape);
    QCOMPARE(window.document.scene().nodes().size(), std::size_t(2));
    QCOMPARE(window.document.scene().nodes().back().params.tree.translation,
             before.nodes().front().params.tree.translation);
    QCOMPARE(window.document.undoStack()->count(), 1);
}

RAMURE_SUITE(TestViewportHand)

} // namespace tst_viewport_hand

#include "tst_viewport_hand.moc"
