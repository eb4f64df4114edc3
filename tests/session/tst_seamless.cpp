#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/pose/skin.h"
#include "core/scene/loop_blend.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_seamless {

using namespace ramure;

/// Loops whose end goes over into their beginning.
class TestSeamless : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void onlySeamlessLoopsBlend();
    void theBlendIsSmoothAndEndsAtTheFirstFrame();
    void treesGoOnWithoutAJump();
    void armsGoOnWithoutAJump();
    void branchesKeepTheirLengths();
    void filesAreWhatThePlayerShows();

private:
    static constexpr TimelineSettings loop{24.0, 0, 47, PlayLoop::Loop, true};
    using Points = std::vector<glm::dvec3>;
    NodeId add(NodeKind kind);
    const NodeMotion& motion(NodeId node) { return *m_player->motion()->of(node); }
    void setLoop(bool seamless)
    {
        TimelineSettings settings = loop;
        settings.seamless = seamless;
        QVERIFY(edit::setTimeline(*m_document, settings));
    }
    void seek(qint64 frame)
    {
        m_player->seek(frame);
        QVERIFY(m_player->waitForIdle(20000));
    }
    /// Where the bones' ends are, frame by frame.
    std::vector<Points> played(NodeId node, const Points& rest);
    static double distance(const Points& a, const Points& b);
    static double typicalStep(const std::vector<Points>& frames);

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<Player> m_player;
};

void TestSeamless::init()
{
    test::failOnAnyWarning();
    m_document = std::make_unique<Document>();
    m_recompute = std::make_unique<Recompute>(m_document.get());
    m_recompute->setRest(0);
    m_player = std::make_unique<Player>(m_document.get());
}

void TestSeamless::cleanup()
{
    m_player.reset();
    m_recompute.reset();
    m_document.reset();
}

NodeId TestSeamless::add(NodeKind kind)
{
    Node node;
    node.id = 1;
    node.kind = kind;
    node.name = "It";
    if (kind == NodeKind::Tree)
        node.params = *presetParams("TinyTree");
    const auto id = edit::insertNodes(*m_document, {node}, noNode, 0);
    [&] { QVERIFY(m_recompute->waitForFull(test::patience(20000))); }();
    return id.value_or(noNode);
}

std::vector<TestSeamless::Points> TestSeamless::played(NodeId node, const Points& rest)
{
    std::vector<Points> frames;
    seek(loop.lastFrame); // at the first frame nothing would be computed
    for (std::int64_t frame = loop.firstFrame; frame <= loop.lastFrame; ++frame) {
        seek(frame);
        Points points;
        for (std::size_t i = 0; i < rest.size(); ++i)
            points.push_back((*motion(node).bones)[i].point(rest[i]));
        frames.push_back(std::move(points));
    }
    return frames;
}

double TestSeamless::distance(const Points& a, const Points& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += glm::length(a[i] - b[i]);
    return sum / double(a.size());
}

double TestSeamless::typicalStep(const std::vector<Points>& frames)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < frames.size(); ++i)
        steps.push_back(distance(frames[i - 1], frames[i]));
    std::ranges::nth_element(steps, steps.begin() + std::ptrdiff_t(steps.size() / 2));
    return steps[steps.size() / 2];
}

void TestSeamless::onlySeamlessLoopsBlend()
{
    for (const auto& [kind, on] : {std::pair(PlayLoop::Once, true), std::pair(PlayLoop::PingPong, true),
                                   std::pair(PlayLoop::Loop, false)})
        for (const std::int64_t frame : {0, 30, 47, 48})
            QCOMPARE(loopBlend({24.0, 0, 47, kind, on}, loop.timeOf(frame)).weight, 0.0);
}

void TestSeamless::theBlendIsSmoothAndEndsAtTheFirstFrame()
{
    const TimelineSettings settings{24.0, 10, 129, PlayLoop::Loop, true};
    double before = 0.0;
    for (std::int64_t frame = 0; frame <= 130; ++frame) {
        const LoopBlend blend = loopBlend(settings, settings.timeOf(frame));
        QCOMPARE(blend.weight > 0.0, frame > 130 - 24);
        QVERIFY(blend.weight >= before && blend.weight - before < 0.07);
        if (blend.weight > 0.0)
            QCOMPARE(settings.frameAt(blend.earlierSeconds), frame - 120);
        before = blend.weight;
    }
    QCOMPARE(before, 1.0); // the frame behind the last one is the first
    QCOMPARE(loopBlend(settings, settings.timeOf(131)).weight, 0.0);
    // A loop shorter than two seconds keeps its first half.
    const TimelineSettings quick{24.0, 0, 9, PlayLoop::Loop, true};
    QCOMPARE(loopBlend(quick, quick.timeOf(5)).weight, 0.0);
    QVERIFY(loopBlend(quick, quick.timeOf(6)).weight > 0.0);
}

void TestSeamless::treesGoOnWithoutAJump()
{
    const NodeId tree = add(NodeKind::Tree);
    const Points rest = m_document->result(tree)->tree.simplified->skeleton.p1;
    setLoop(false);
    const auto jumping = played(tree, rest);
    setLoop(true);
    const auto smooth = played(tree, rest);
    QVERIFY(distance(jumping.back(), jumping.front()) > 2.0 * typicalStep(jumping));
    QVERIFY(distance(smooth.back(), smooth.front()) <= typicalStep(smooth));
    for (std::size_t i = 1; i < smooth.size(); ++i)
        QVERIFY(distance(smooth[i - 1], smooth[i]) < 12.0 * typicalStep(smooth)); // nor elsewhere
    QVERIFY(smooth[20] == jumping[20]); // the first half is as it was
}

void TestSeamless::armsGoOnWithoutAJump()
{
    const NodeId arm = add(NodeKind::Arm);
    Points ends; // of the arm that stands straight up: its bones are measured from there
    for (const ArmJoint& joint : m_document->scene().find(arm)->params.joints)
        ends.emplace_back(0.0, 0.0, joint.length + (ends.empty() ? 0.0 : ends.back().z));
    setLoop(false);
    const auto jumping = played(arm, ends);
    setLoop(true);
    const auto smooth = played(arm, ends);
    QVERIFY(distance(jumping.back(), jumping.front()) > 0.01);
    QVERIFY(distance(smooth.back(), smooth.front()) < 0.05 * distance(jumping.back(), jumping.front()));
    // Files have the same joints.
    Evaluator arms({}, loop);
    for (const qint64 frame : {20, 36, 47}) {
        seek(frame);
        const auto joints = arms.joints(*m_document->scene().find(arm), loop.timeOf(frame));
        QVERIFY(joints);
        for (std::size_t i = 0; i < joints->size(); ++i)
            QCOMPARE(motion(arm).arm->angles[2 * i], (*joints)[i].phi.angleRad);
    }
}

void TestSeamless::branchesKeepTheirLengths()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = *presetParams("SmallTree");
    TreePipeline pipeline;
    Evaluator moving(pipelineSource(pipeline), loop);
    const auto rest = pipelineSource(pipeline)(node, Stage::Foliage, {});
    const auto now = moving.tree(node, Stage::Foliage, loop.timeOf(38));
    QVERIFY(rest && now && now->report->valid);
    const Skeleton &before = rest->simplified->skeleton, &bones = now->simplified->skeleton;
    double moved = 0.0;
    for (Index b = 0; b < bones.size(); ++b) {
        QVERIFY(std::abs(bones.length(b) - before.length(b)) < 1e-9 * before.length(b));
        if (bones.parent[b] != noIndex)
            QVERIFY(glm::length(bones.p0[b] - bones.p1[bones.parent[b]]) < 1e-9);
        moved = std::max(moved, glm::length(bones.p1[b] - before.p1[b]));
    }
    QVERIFY(moved > 0.001);
}

void TestSeamless::filesAreWhatThePlayerShows()
{
    const NodeId tree = add(NodeKind::Tree);
    setLoop(true);
    TreePipeline pipeline;
    Evaluator moving(pipelineSource(pipeline), m_document->scene().timeline());
    for (const qint64 frame : {47, 30, 20}) {
        seek(frame);
        const NodeMotion& shown = motion(tree);
        const auto now =
            moving.tree(*m_document->scene().find(tree), Stage::Foliage, m_player->timeSeconds());
        QVERIFY(now);
        QVERIFY(now->branches->mesh ==
                deformed(shown.mesh->mesh, *shown.branches, *shown.bones, shown.method));
    }
}

RAMURE_SUITE(TestSeamless)

} // namespace tst_seamless

#include "tst_seamless.moc"
