#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/motion_request.h"
#include "core/qt/session/motion/player.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include <QSignalSpy>
#include <QThread>
#include <numeric>

namespace tst_player {

using namespace ramure;

/// Playing a document: time, frames, the hand, and what edits do to frames already computed.
class TestPlayer : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void emptyDocumentsPlayToo();
    void keysOfADayCountAtTheFirstFrame();
    void frameZeroIsRest();
    void seekingGivesAFrame();
    void anyOrderGivesTheSameFrames();
    void playingTouchesNoUndoAndNoStar();
    void playingGoesOnAndPauses();
    void everyFrameShowsAllFrames();
    void onceEndsAtTheLastFrame();
    void stopGoesBackAndForgetsTheHand();
    void busyUntilTheLastFrameIsThere();
    void bandTellsCachedStaleAndMissing();
    void physicsEditsChangeTheFrameOnShow();
    void shapeEditsChangeTheFrameOnShow();
    void checksMoveNothing();
    void hiddenTreesDoNotMove();
    void removedTreesAreForgotten();
    void openingAnotherDocumentStops();
    void pulledBranchesFollowAndSpringBack();
    void shakenApplesFall();
    void movedMeshesStayClosed();
    void closingWhilePlayingEndsCleanly();
    void reshapedTreesAreSketchedFirst();

private:
    NodeId addTree(const char* preset);
    const NodeMotion& motion(NodeId node) { return *m_player->motion()->of(node); }
    void seek(qint64 frame)
    {
        m_player->seek(frame);
        QVERIFY(m_player->waitForIdle(20000));
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<Player> m_player;
};

void TestPlayer::init()
{
    test::failOnAnyWarning();
    m_document = std::make_unique<Document>();
    m_recompute = std::make_unique<Recompute>(m_document.get());
    m_recompute->setRest(0);
    m_player = std::make_unique<Player>(m_document.get());
}

void TestPlayer::cleanup()
{
    m_player.reset();
    m_recompute.reset();
    m_document.reset();
}

NodeId TestPlayer::addTree(const char* preset)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = preset;
    node.params = presetParams(preset).value_or(NodeParams{});
    const auto id = edit::insertNodes(*m_document, {node}, noNode, 0);
    [&] { QVERIFY(m_recompute->waitForFull(test::patience(20000))); }();
    return id.value_or(noNode);
}

void TestPlayer::emptyDocumentsPlayToo()
{
    m_player->play();
    QVERIFY(m_player->isPlaying());
    QTRY_VERIFY(m_player->frame() > 1);
    m_player->stop();
    QCOMPARE(m_player->frame(), std::int64_t(0));
    QVERIFY(m_player->motion()->nodes.empty());
    m_player->seek(std::numeric_limits<qint64>::max());
    QCOMPARE(m_player->frame(), mostFrame);
    QVERIFY(m_player->waitForIdle(5000));
}

/// A file that begins on the first of January is opened bare.
void TestPlayer::keysOfADayCountAtTheFirstFrame()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "tree";
    node.params = presetParams("TinyTree").value_or(NodeParams{});
    node.params.leaf.shape = LeafShape::Birch;
    std::vector<Key> keys(2);
    keys[0].value = 10.0;
    keys[1].value = 200.0;
    keys[1].time = ticksOf(2.0);
    node.animation.set(Channel{ChannelPart::Parameter, 0, paramId(*findParam("season.day"))},
                       AnyTrack(Track::fromKeys(keys).value()));
    auto scene = Scene::fromNodes({node});
    QVERIFY(scene);
    m_document->reset(std::move(*scene), QString());
    QVERIFY(m_recompute->waitForFull(test::patience(20000)));
    const auto leaves = [this] {
        const auto found = m_player->motion()->trees.find(1);
        return found == m_player->motion()->trees.end() ? -1 : int(found->second.foliage->leaves.size());
    };
    QTRY_COMPARE(leaves(), 0);
    seek(48);
    QVERIFY(leaves() > 0);
    seek(0);
    QCOMPARE(leaves(), 0);
}

void TestPlayer::frameZeroIsRest()
{
    const NodeId tree = addTree("TinyTree");
    seek(10);
    QVERIFY(motion(tree).moves());
    seek(0);
    QVERIFY(!motion(tree).moves());
    for (const RigidTransform& bone : *motion(tree).bones)
        QVERIFY(bone == RigidTransform{});
    seek(-5);
    QVERIFY(!motion(tree).moves());
}

void TestPlayer::seekingGivesAFrame()
{
    const NodeId tree = addTree("TinyTree");
    QSignalSpy shown(m_player.get(), &Player::motionChanged);
    seek(48);
    QVERIFY(shown.size() >= 1);
    QCOMPARE(m_player->motion()->frame, std::int64_t(48));
    QCOMPARE(m_player->timeSeconds(), 2.0);
    QCOMPARE(motion(tree).step, std::int64_t(200));
    const TreeResult& result = m_document->result(tree)->tree;
    QCOMPARE(motion(tree).mesh, result.branches);
    QCOMPARE(motion(tree).branches->vertices, result.branches->mesh.vertexCount());
    QCOMPARE(motion(tree).bones->size(), result.simplified->skeleton.size() + result.foliage->apples.size() +
                                             result.foliage->leaves.size());
    QVERIFY(motion(tree).figures.lengthError < 1e-6);
    QVERIFY(!motion(tree).box.empty());
}

void TestPlayer::anyOrderGivesTheSameFrames()
{
    const NodeId tree = addTree("TinyTree");
    std::map<qint64, std::vector<RigidTransform>> straight;
    seek(1); // frame 0 is where the player stands: nothing was computed yet
    for (qint64 frame = 0; frame <= 40; frame += 4) {
        seek(frame);
        straight[frame] = *motion(tree).bones;
    }
    for (const qint64 frame : {36, 4, 20, 16, 40, 0, 8, 24}) {
        seek(frame);
        QVERIFY(*motion(tree).bones == straight[frame]);
    }
}

void TestPlayer::playingTouchesNoUndoAndNoStar()
{
    addTree("TinyTree");
    m_document->markSaved();
    const int steps = m_document->undoStack()->count();
    const quint64 revision = m_document->revision();
    m_player->play();
    QTRY_VERIFY(m_player->frame() > 3);
    m_player->stop();
    seek(30);
    QCOMPARE(m_document->undoStack()->count(), steps);
    QCOMPARE(m_document->revision(), revision);
    QVERIFY(!m_document->isModified());
}

void TestPlayer::playingGoesOnAndPauses()
{
    addTree("TinyTree");
    QSignalSpy playing(m_player.get(), &Player::playingChanged);
    m_player->play();
    m_player->play(); // once is enough
    QTRY_VERIFY(m_player->frame() >= 5);
    m_player->pause();
    QCOMPARE(playing.size(), 2);
    const std::int64_t at = m_player->frame();
    QVERIFY(m_player->waitForIdle(5000));
    test::letHappen(60);
    QCOMPARE(m_player->frame(), at);
    QTRY_COMPARE(m_player->motion()->frame, at);
}

void TestPlayer::everyFrameShowsAllFrames()
{
    addTree("TinyTree");
    m_player->setPace(PlayPace::EveryFrame);
    m_player->setSpeed(100.0); // clamped
    QCOMPARE(m_player->speed(), Player::mostSpeed);
    QVERIFY(edit::setTimeline(*m_document, {24.0, 0, 20, PlayLoop::Once}));
    std::vector<std::int64_t> frames;
    connect(m_player.get(), &Player::motionChanged, this,
            [&] { frames.push_back(m_player->motion()->frame); });
    m_player->play();
    QTRY_VERIFY(!m_player->isPlaying());
    QVERIFY(m_player->waitForIdle(5000));
    std::erase(frames, 0);
    std::vector<std::int64_t> meant(20);
    std::iota(meant.begin(), meant.end(), 1);
    QVERIFY(frames == meant);
    QCOMPARE(m_player->droppedFrames(), std::int64_t(0));
}

void TestPlayer::onceEndsAtTheLastFrame()
{
    addTree("TinyTree");
    QVERIFY(edit::setTimeline(*m_document, {60.0, 2, 12, PlayLoop::Once}));
    m_player->play(); // the frame on show lies outside: from the first one on
    QVERIFY(m_player->frame() >= 2);
    QTRY_VERIFY(!m_player->isPlaying());
    QCOMPARE(m_player->frame(), std::int64_t(12));
    m_player->play(); // again from the start
    QVERIFY(m_player->frame() < 12);
}

void TestPlayer::stopGoesBackAndForgetsTheHand()
{
    const NodeId tree = addTree("TinyTree");
    seek(30);
    const std::vector<RigidTransform> calm = *motion(tree).bones;
    seek(1);
    m_player->play();
    m_player->setPull(tree, Pull{0, 1.0, {5.0, 0.0, 5.0}, 50.0});
    QTRY_VERIFY(m_player->frame() > 20);
    m_player->stop();
    QVERIFY(m_player->waitForIdle(20000));
    QCOMPARE(m_player->frame(), std::int64_t(0));
    QVERIFY(!motion(tree).moves());
    seek(30);
    QVERIFY(*motion(tree).bones == calm);
}

/// The end of an earlier request must not be taken for the end of the last one: its frame may still be on
/// the way.
void TestPlayer::busyUntilTheLastFrameIsThere()
{
    addTree("TinyTree");
    seek(1);
    const auto once = connect(m_player.get(), &Player::motionChanged, this, [&] {
        if (m_player->motion()->frame != 5)
            return;
        m_player->seek(9);
        test::work(500); // enough for the worker to be through
    });
    m_player->seek(5);
    test::work(500); // its frame and its end are told in one go
    QVERIFY(QTest::qWaitFor([&] { return !m_player->isBusy(); }, test::patience(20000)));
    QCOMPARE(m_player->motion()->frame, std::int64_t(9));
    disconnect(once);
    m_player->seek(20);
    m_player->cancel();
    QVERIFY(QTest::qWaitFor([&] { return !m_player->isBusy(); }, test::patience(20000)));
}

void TestPlayer::bandTellsCachedStaleAndMissing()
{
    const NodeId tree = addTree("TinyTree");
    QVERIFY(edit::setTimeline(*m_document, {24.0, 0, 100, PlayLoop::Loop}));
    seek(50);
    QTRY_COMPARE(m_player->band().size(), std::size_t(2));
    QCOMPARE(m_player->band()[0].state, FrameState::Cached);
    QVERIFY(m_player->band()[0].last >= 50);
    QCOMPARE(m_player->band()[1].state, FrameState::Missing);
    QCOMPARE(m_player->band()[1].last, std::int64_t(100));
    seek(0);
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("physics.windStrength"), 3.0));
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_VERIFY(m_player->band().size() >= 2);
    QCOMPARE(m_player->band()[0], (FrameRange{0, 0, FrameState::Cached}));
    QCOMPARE(m_player->band()[1].state, FrameState::Stale);
    m_document->undo();
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_COMPARE(m_player->band()[0].state, FrameState::Cached);
    QVERIFY(m_player->band()[0].last >= 50);
}

void TestPlayer::physicsEditsChangeTheFrameOnShow()
{
    const NodeId tree = addTree("TinyTree");
    seek(24);
    const std::vector<RigidTransform> before = *motion(tree).bones;
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("physics.windStrength"), 4.0));
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_VERIFY(*motion(tree).bones != before);
    m_document->undo();
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_VERIFY(*motion(tree).bones == before);
}

void TestPlayer::shapeEditsChangeTheFrameOnShow()
{
    const NodeId tree = addTree("TinyTree");
    seek(24);
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("sections.radialDivisions"), std::int64_t(12)));
    QVERIFY(m_recompute->waitForFull(test::patience(20000)));
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_COMPARE(motion(tree).mesh, m_document->result(tree)->tree.branches);
    QVERIFY(motion(tree).moves());
}

/// The second opinion on a mesh comes late, and while playing at the pace of every frame it must not show a
/// frame twice.
void TestPlayer::checksMoveNothing()
{
    const NodeId tree = addTree("TinyTree");
    seek(24);
    NodeResult checked = *m_document->result(tree);
    checked.tree.report = std::make_shared<MeshReport>(*checked.tree.report);
    m_document->setResult(tree, checked);
    QVERIFY(!m_player->isBusy());
    checked.tree.branches = std::make_shared<BranchMesh>(*checked.tree.branches);
    m_document->setResult(tree, checked);
    QVERIFY(m_player->isBusy());
    QVERIFY(m_player->waitForIdle(20000));
    QCOMPARE(motion(tree).mesh, checked.tree.branches);
}

void TestPlayer::hiddenTreesDoNotMove()
{
    const NodeId tree = addTree("TinyTree");
    seek(5);
    QVERIFY(edit::setNodeVisible(*m_document, {tree}, false));
    QVERIFY(m_player->waitForIdle(20000));
    QTRY_VERIFY(!m_player->motion()->of(tree));
    QVERIFY(edit::setNodeVisible(*m_document, {tree}, true));
    QTRY_VERIFY(m_player->motion()->of(tree));
}

void TestPlayer::removedTreesAreForgotten()
{
    const NodeId tree = addTree("TinyTree");
    seek(5);
    QVERIFY(edit::removeNodes(*m_document, {tree}));
    QTRY_VERIFY(m_player->motion()->nodes.empty());
    m_document->undo();
    QVERIFY(m_recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(m_player->motion()->of(tree));
}

void TestPlayer::openingAnotherDocumentStops()
{
    addTree("TinyTree");
    m_player->play();
    QTRY_VERIFY(m_player->frame() > 2);
    m_document->reset({}, {});
    QVERIFY(!m_player->isPlaying());
    QCOMPARE(m_player->frame(), std::int64_t(0));
    QVERIFY(m_player->waitForIdle(5000));
    QVERIFY(m_player->motion()->nodes.empty());
}

void TestPlayer::pulledBranchesFollowAndSpringBack()
{
    const NodeId tree = addTree("TinyTree");
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("physics.windStrength"), 0.0));
    QVERIFY(edit::setTimeline(*m_document, {60.0, 0, 2000, PlayLoop::Once}));
    const Skeleton& skeleton = m_document->result(tree)->tree.simplified->skeleton;
    const Index tip = skeleton.size() - 1;
    const glm::dvec3 target = skeleton.p1[tip] + glm::dvec3(1.0, 0.0, 0.0);
    const auto reached = [&] {
        return glm::length((*motion(tree).bones)[tip].point(skeleton.p1[tip]) - skeleton.p1[tip]);
    };
    seek(1);
    m_player->play();
    m_player->setPull(tree, Pull{tip, 1.0, target, 20.0});
    QTRY_VERIFY(reached() > 0.05);
    m_player->setPull(tree, {});
    const double pulled = reached();
    QTRY_VERIFY(reached() < 0.5 * pulled);
}

void TestPlayer::shakenApplesFall()
{
    const NodeId tree = addTree("TinyTree");
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("foliage.leavesCutoff"), 1.0));
    QVERIFY(edit::setParam(*m_document, {tree}, *findParam("foliage.applesProbability"), 1.0));
    QVERIFY(m_recompute->waitForFull(test::patience(20000)));
    const TreeResult result = m_document->result(tree)->tree;
    QVERIFY(!result.foliage->apples.empty());
    seek(1);
    m_player->play();
    m_player->shakeOff(tree, 0);
    const std::size_t bone = result.simplified->skeleton.size();
    const glm::dvec3 start = result.foliage->apples[0].position;
    QTRY_VERIFY((*motion(tree).bones)[bone].point(start).y < start.y - 0.2);
    m_player->stop();
    QVERIFY(m_player->waitForIdle(20000));
    QVERIFY((*motion(tree).bones)[bone] == RigidTransform{});
}

/// SPEC A8: forks do not tear, whatever the frame.
void TestPlayer::movedMeshesStayClosed()
{
    const NodeId tree = addTree("SmallTree");
    for (const qint64 frame : {12, 30, 60}) {
        seek(frame);
        const NodeMotion& now = motion(tree);
        const auto report = validateMesh(deformed(now.mesh->mesh, *now.branches, *now.bones, now.method));
        QVERIFY(report && report->valid);
    }
}

void TestPlayer::closingWhilePlayingEndsCleanly()
{
    addTree("SmallTree");
    m_player->play();
    QTRY_VERIFY(m_player->frame() > 1);
    m_player.reset();                  // joins
    QCoreApplication::processEvents(); // nothing is delivered any more
}

/// A sketch at once, then the whole tree of the same frame; one that is known comes as it is.
void TestPlayer::reshapedTreesAreSketchedFirst()
{
    const NodeId tree = addTree("SmallTree");
    Key first, last;
    first.mode = last.mode = KeyMode::Linear;
    first.value = 0.3;
    last.time = 2 * ticksPerSecond;
    last.value = 0.6;
    const auto turn = std::make_shared<const AnyTrack>(*Track::fromKeys({first, last}));
    const Channel theta = *channelFromKey("turtle.theta", NodeKind::Tree);
    std::vector<std::shared_ptr<const MotionFrame>> shown;
    connect(m_player.get(), &Player::motionChanged, this, [&] { shown.push_back(m_player->motion()); });
    QVERIFY(edit::setTracks(*m_document, {{tree, theta, turn}}, QStringLiteral("turn")));
    QVERIFY(m_player->waitForIdle(20000));
    QVERIFY(shown.size() >= 2);
    const TreeResult &draft = shown.front()->trees.at(tree), &whole = shown.back()->trees.at(tree);
    QVERIFY(isSketch(*shown.front()) && draft.draftTubes && !draft.branches);
    QVERIFY(!isSketch(*shown.back()) && whole.branches && whole.report->valid);
    QCOMPARE(shown.front()->frame, shown.back()->frame);
    QVERIFY(draft.skeleton == whole.skeleton && draft.skeleton != m_document->result(tree)->tree.skeleton);
    seek(24);
    QVERIFY(!isSketch(*m_player->motion()) && m_player->motion()->trees.at(tree).branches);
    m_player->setPace(PlayPace::EveryFrame); // whatever that takes
    shown.clear();
    m_player->play();
    QTRY_VERIFY(shown.size() >= 3);
    m_player->pause();
    QVERIFY(std::ranges::none_of(shown, [](const auto& one) { return isSketch(*one); }));
}

RAMURE_SUITE(TestPlayer)

} // namespace tst_player

#include "tst_player.moc"
