#include "core/scene/node_transform.h"
#include "core/scene/world_transforms.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/scene/scene_model.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/scene_tree.h"
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>

namespace tst_scene_drops {

using namespace ramure;

/// Nodes that get another parent by drag and drop, at any time.
class TestSceneDrops : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        open(false);
        m_panel = std::make_unique<ScenePanel>(m_document.get(), m_preferences.get());
        m_panel->setTime([this] { return m_seconds; });
        m_panel->resize(420, 300);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
        m_panel->view()->expandAll();
    }
    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
    }
    void shearIsSaidAndNothingMoves();
    void theWorldPlaceIsKeptAtTheTime_data();
    void theWorldPlaceIsKeptAtTheTime();
    void withShiftTheOwnValuesAreKept();
    void theStatusBarTellsTheKey();

private:
    void open(bool uneven);
    void drop(NodeId what, NodeId onto, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] glm::dmat4 world(NodeId id) const
    {
        return worldTransformAt(m_document->scene(), id, m_seconds).world;
    }

    test::OwnSettings m_settings;
    double m_seconds = 0.0;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ScenePanel> m_panel;
};

static double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double worst = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            worst = std::max(worst, std::abs(a[column][row] - b[column][row]));
    return worst;
}

/// Group 1 turns and goes, node 2 beside it goes along its own track, group 3 stands in group 1.
void TestSceneDrops::open(bool uneven)
{
    const auto slope = [](double to) {
        Key a, b;
        a.mode = b.mode = KeyMode::Linear;
        b.time = 2 * ticksPerSecond;
        b.value = to;
        return std::make_shared<const AnyTrack>(*Track::fromKeys({a, b}));
    };
    OrientationKey from, to;
    from.mode = to.mode = KeyMode::Linear;
    to.time = 2 * ticksPerSecond;
    to.value = glm::angleAxis(2.0, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    std::vector<Node> nodes{test::groupNode(1, "A"), test::groupNode(3, "C", 1), test::treeNode(2, "B")};
    nodes[0].animation.set(globalChannel(0), slope(4.0));
    nodes[0].animation.set(globalChannel(3), AnyTrack(*OrientationTrack::fromKeys({from, to})));
    nodes[0].params.tree.scale = uneven ? glm::dvec3(1.0, 3.0, 1.0) : glm::dvec3(2.0);
    nodes[1].params.tree = {{0.5, 1.0, 0.0}, {0.4, 0.2, 0.1}, glm::dvec3(0.5)};
    nodes[2].animation.set(globalChannel(1), slope(-3.0));
    nodes[2].params.tree = {{1.0, 2.0, 3.0}, {0.1, 0.7, -0.3}, {1.0, 0.5, 2.0}};
    test::openNodes(*m_document, nodes);
}

void TestSceneDrops::drop(NodeId what, NodeId onto, Qt::KeyboardModifiers modifiers)
{
    SceneTree* view = m_panel->view();
    const std::unique_ptr<QMimeData> data(m_panel->model()->mimeData({m_panel->model()->nodeIndex(what)}));
    const QPoint at = view->visualRect(m_panel->model()->nodeIndex(onto)).center();
    QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(view->viewport(), &enter);
    QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(view->viewport(), &move);
    QDropEvent event(at, Qt::MoveAction, data.get(), Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(view->viewport(), &event);
}

void TestSceneDrops::shearIsSaidAndNothingMoves()
{
    open(true);
    m_panel->view()->expandAll();
    m_seconds = 1.0;
    QSignalSpy said(m_panel.get(), &ScenePanel::messageRaised);
    drop(2, 3, Qt::NoModifier);
    QCOMPARE(m_document->scene().find(2)->parent, noNode);
    QVERIFY(said.last().front().toString().contains(QStringLiteral("sheared")));
    QCOMPARE(m_document->undoStack()->count(), 0);
}

void TestSceneDrops::theWorldPlaceIsKeptAtTheTime_data()
{
    QTest::addColumn<double>("seconds");
    for (const double seconds : {0.0, 0.3, 1.0, 1.75, 2.0, 5.0})
        QTest::addRow("%g s", seconds) << seconds;
}

void TestSceneDrops::theWorldPlaceIsKeptAtTheTime()
{
    QFETCH(double, seconds);
    m_seconds = seconds;
    for (const NodeId onto : {NodeId(1), NodeId(3)}) {
        const glm::dmat4 before = world(2);
        const PlacementParams placement = m_document->scene().find(2)->params.tree;
        drop(2, onto, Qt::NoModifier);
        QCOMPARE(m_document->scene().find(2)->parent, onto);
        QVERIFY(difference(world(2), before) < 1e-9);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undo();
        QCOMPARE(m_document->scene().find(2)->params.tree, placement);
        QCOMPARE(m_document->scene().find(2)->parent, noNode);
        m_panel->view()->expandAll();
    }
}

void TestSceneDrops::withShiftTheOwnValuesAreKept()
{
    m_seconds = 1.0;
    const PlacementParams placement = m_document->scene().find(2)->params.tree;
    const glm::dmat4 before = world(2);
    drop(2, 1, Qt::ShiftModifier);
    QCOMPARE(m_document->scene().find(2)->parent, NodeId(1));
    QCOMPARE(m_document->scene().find(2)->params.tree, placement);
    QVERIFY(difference(world(2), before) > 0.1);
    // The next one without the key stays where it is again.
    m_panel->view()->expandAll();
    const glm::dmat4 now = world(2);
    drop(2, 3, Qt::NoModifier);
    QCOMPARE(m_document->scene().find(2)->parent, NodeId(3));
    QVERIFY(difference(world(2), now) < 1e-9);
}

void TestSceneDrops::theStatusBarTellsTheKey()
{
    QSignalSpy said(m_panel.get(), &ScenePanel::messageRaised);
    drop(2, 1, Qt::NoModifier);
    QVERIFY(!said.isEmpty());
    QVERIFY(said.front().front().toString().contains(QStringLiteral("Shift")));
}

RAMURE_SUITE(TestSceneDrops)

} // namespace tst_scene_drops

#include "tst_scene_drops.moc"
