#include "core/math/random.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "tests/support/suite.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/scene_builder.h"
#include "widgets/view/tools/motion_tools.h"
#include <cmath>

namespace tst_motion_tools {

using namespace ramure;

/// The hand on moving trees, and scenes that move: without OpenGL.
class TestMotionTools : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { test::failOnAnyWarning(); }
    void nothingIsUnderAnEmptyView();
    void branchesAreFoundWhereTheyAre();
    void lockedAndHiddenTreesAreLeftAlone();
    void pullsStayAtTheirDepth();
    void applesAreFoundWhereTheyAre();
    void windArrowsGoThereAndBack();
    void windArrowsStayInThePicture();
    void windIsShownWhereItBlows();
    void restNeedsNoMotion();
    void movedScenesShareTheirMeshes();
    void posedScenesAreTheDeformedMeshes();
    void foreignMeshesFollowTheirBranches();
    void splitMeshesDoNotComeApart();

private:
    PickView viewOf() const;
    glm::dvec2 pixelOf(const PickView& view, const glm::dvec3& world) const;
    RenderScene restScene() const;
    void setWind(double strength, double direction);

    std::unique_ptr<Document> m_document = std::make_unique<Document>();
    std::unique_ptr<Recompute> m_recompute;
    std::shared_ptr<const MotionFrame> m_frame;
    NodeId m_tree = noNode;
};

void TestMotionTools::initTestCase()
{
    m_recompute = std::make_unique<Recompute>(m_document.get());
    m_recompute->setRest(0);
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "tree";
    node.params = presetParams("TinyTree").value_or(NodeParams{});
    node.params.foliage.leavesCutoff = 1.0;
    node.params.foliage.applesProbability = 1.0;
    node.params.tree.translation = {3.0, 0.5, -2.0};
    node.params.tree.rotation = {0.0, 0.7, 0.0};
    m_tree = edit::insertNodes(*m_document, {node}, noNode, 0).value_or(noNode);
    QVERIFY(m_recompute->waitForFull(test::patience(20000)));
    Player player(m_document.get());
    player.seek(30);
    QVERIFY(player.waitForIdle(20000));
    m_frame = player.motion();
    QVERIFY(m_frame->of(m_tree) && m_frame->of(m_tree)->moves());
}

RenderScene TestMotionTools::restScene() const
{
    SceneView view;
    return SceneBuilder().build(
        m_document->scene(), [this](NodeId id) { return &m_document->result(id)->tree; }, view);
}

PickView TestMotionTools::viewOf() const
{
    PickView view;
    view.size = {800.0, 600.0};
    view.camera.frame(restScene().box, view.aspect(), 1.2);
    return view;
}

glm::dvec2 TestMotionTools::pixelOf(const PickView& view, const glm::dvec3& world) const
{
    const glm::dvec2 ndc = *view.camera.project(world, view.aspect());
    return 0.5 * glm::dvec2(ndc.x + 1.0, 1.0 - ndc.y) * view.size;
}

void TestMotionTools::nothingIsUnderAnEmptyView()
{
    const PickView view = viewOf();
    QVERIFY(!branchUnder(view, {-500.0, -500.0}, *m_document, *m_frame));
    QVERIFY(!branchUnder(view, {400.0, 300.0}, *m_document, MotionFrame{}));
    QVERIFY(!appleUnder(view, {400.0, 300.0}, *m_document, MotionFrame{}));
    QVERIFY(!windArrow(EvaluatedScene(m_document->scene()), noNode, {}, 1.0));
    QVERIFY(!windArrowOver(EvaluatedScene(m_document->scene()), m_tree, {}, viewOf(),
                           true)); // no box: nothing to stand on
}

/// Whatever is found lies under the cursor, and the ends of branches find a branch.
void TestMotionTools::branchesAreFoundWhereTheyAre()
{
    const PickView view = viewOf();
    const Skeleton& skeleton = m_document->result(m_tree)->tree.simplified->skeleton;
    const glm::dmat4 world = worldMatrix(m_document->scene(), m_tree);
    for (Index b = 0; b < skeleton.size(); ++b) {
        const RigidTransform& bone = (*m_frame->of(m_tree)->bones)[b];
        const glm::dvec3 middle = bone.point(0.5 * (skeleton.p0[b] + skeleton.p1[b]));
        const glm::dvec3 place(world * glm::dvec4(middle, 1.0));
        const auto found = branchUnder(view, pixelOf(view, place), *m_document, *m_frame);
        QVERIFY(found);
        QCOMPARE(found->node, m_tree);
        QVERIFY(found->along >= 0.0 && found->along <= 1.0);
        const double radius = std::max(skeleton.a0[found->branch], skeleton.a1[found->branch]);
        const double reach = 14.0 + radius / view.camera.metresPerPixel(found->point, view.size.y);
        QVERIFY(glm::length(pixelOf(view, found->point) - pixelOf(view, place)) < reach);
    }
}

void TestMotionTools::lockedAndHiddenTreesAreLeftAlone()
{
    const PickView view = viewOf();
    const glm::dmat4 world = worldMatrix(m_document->scene(), m_tree);
    const Skeleton& skeleton = m_document->result(m_tree)->tree.simplified->skeleton;
    const glm::dvec2 pixel =
        pixelOf(view, glm::dvec3(world * glm::dvec4(0.5 * (skeleton.p0[0] + skeleton.p1[0]), 1.0)));
    QVERIFY(branchUnder(view, pixel, *m_document, *m_frame));
    QVERIFY(edit::setNodeLocked(*m_document, {m_tree}, true));
    QVERIFY(!branchUnder(view, pixel, *m_document, *m_frame));
    QVERIFY(edit::setNodeLocked(*m_document, {m_tree}, false));
    QVERIFY(edit::setNodeVisible(*m_document, {m_tree}, false));
    QVERIFY(!branchUnder(view, pixel, *m_document, *m_frame));
    QVERIFY(edit::setNodeVisible(*m_document, {m_tree}, true));
}

void TestMotionTools::pullsStayAtTheirDepth()
{
    for (const bool orthographic : {false, true}) {
        PickView view = viewOf();
        view.camera.orthographic = orthographic;
        const glm::dvec3 held = view.camera.target + glm::dvec3(0.2, 0.1, -0.3);
        QVERIFY(glm::length(pulledTo(view, pixelOf(view, held), held) - held) < 1e-9);
        const glm::dvec3 moved = pulledTo(view, {50.0, 70.0}, held);
        QVERIFY(glm::length(pixelOf(view, moved) - glm::dvec2(50.0, 70.0)) < 1e-6);
        QVERIFY(std::abs(glm::dot(moved - held, view.camera.backward())) < 1e-9);
    }
}

void TestMotionTools::applesAreFoundWhereTheyAre()
{
    const PickView view = viewOf();
    const TreeResult& tree = m_document->result(m_tree)->tree;
    const glm::dmat4 world = worldMatrix(m_document->scene(), m_tree);
    QVERIFY(!tree.foliage->apples.empty());
    for (std::size_t apple = 0; apple < tree.foliage->apples.size(); ++apple) {
        const RigidTransform& bone = (*m_frame->of(m_tree)->bones)[tree.simplified->skeleton.size() + apple];
        const glm::dvec3 centre(world * glm::dvec4(bone.point(tree.foliage->apples[apple].position), 1.0));
        const auto found = appleUnder(view, pixelOf(view, centre), *m_document, *m_frame);
        QVERIFY(found); // itself, or one in front of it
        if (found->apple == apple)
            return;
    }
    QFAIL("no apple is in front of the others");
}

void TestMotionTools::windArrowsGoThereAndBack()
{
    PickView view = viewOf();
    view.camera.pitchRad = 0.5; // the plane of the arrow is not seen from its edge
    const Box box = m_frame->of(m_tree)->box;
    Random random(3, RandomStream::Leaves, 0);
    for (int i = 0; i < 50; ++i) {
        const double strength = random.range(0.1, 20.0), direction = random.range(-3.0, 3.0);
        setWind(strength, direction);
        const auto arrow = windArrowOver(EvaluatedScene(m_document->scene()), m_tree, box, view, false);
        QVERIFY(arrow);
        const auto back =
            windAt(view, pixelOf(view, arrow->head), *arrow, EvaluatedScene(m_document->scene()));
        QVERIFY(back);
        QVERIFY(std::abs(back->strength - strength) < 1e-6 * strength);
        QVERIFY(std::abs(std::remainder(back->directionRad - direction, 6.283185307179586)) < 1e-6);
        const auto none =
            windAt(view, pixelOf(view, arrow->foot), *arrow, EvaluatedScene(m_document->scene()));
        QVERIFY(none && none->strength == 0.0);
    }
}

/// Also where the tree fills the picture, or is half outside.
void TestMotionTools::windArrowsStayInThePicture()
{
    const Box box = m_frame->of(m_tree)->box;
    for (const double strength : {0.0, 1.0, 8.0, 100.0})
        for (const double direction : {-2.0, 0.0, 1.5, 3.1})
            for (const double zoom : {0.2, 1.0, 4.0})
                for (const double pitch : {-0.3, 0.1, 0.8, 1.5}) {
                    setWind(strength, direction);
                    PickView view = viewOf();
                    view.camera.pitchRad = pitch;
                    view.camera.distance *= zoom;
                    view.camera.pan({0.4, -0.3}, view.aspect());
                    const auto arrow =
                        windArrowOver(EvaluatedScene(m_document->scene()), m_tree, box, view, true);
                    QVERIFY(arrow);
                    for (const glm::dvec3& end : {arrow->foot, arrow->head}) {
                        const glm::dvec2 at = pixelOf(view, end);
                        QVERIFY(at.x > 0.0 && at.y > 0.0 && at.x < view.size.x && at.y < view.size.y);
                    }
                }
}

void TestMotionTools::windIsShownWhereItBlows()
{
    const Scene& scene = m_document->scene();
    const auto trees = [&](NodeId active) { return windyTrees(scene, active, 10); };
    setWind(0.0, 0.0);
    QVERIFY(std::get<NoWind>(trees(noNode)) == NoWind::NoneChosen);
    QCOMPARE(std::get<0>(trees(m_tree)), std::vector{m_tree}); // to be pulled out of nothing
    setWind(2.0, 0.0);
    QCOMPARE(std::get<0>(trees(noNode)), std::vector{m_tree}); // nothing is selected
    QVERIFY(std::get<NoWind>(windyTrees(Scene(), noNode, 10)) == NoWind::NoTree);
}

void TestMotionTools::setWind(double strength, double direction)
{
    (void)edit::setParam(*m_document, {m_tree}, *findParam("physics.windStrength"), strength);
    (void)edit::setParam(*m_document, {m_tree}, *findParam("physics.windDirection"), direction);
}

void TestMotionTools::restNeedsNoMotion()
{
    const RenderScene rest = restScene();
    QVERIFY(!MovingScene::moves(rest, MotionFrame{}));
    QVERIFY(MovingScene::moves(rest, *m_frame));
    MovingScene moving;
    const RenderScene still = moving.moved(rest, MotionFrame{});
    for (const MeshItem& item : still.meshes)
        QVERIFY(!item.motion.moves());
}

void TestMotionTools::movedScenesShareTheirMeshes()
{
    const RenderScene rest = restScene();
    MovingScene moving;
    const RenderScene now = moving.moved(rest, *m_frame);
    QCOMPARE(now.meshes.size(), rest.meshes.size());
    for (std::size_t i = 0; i < now.meshes.size(); ++i) {
        QCOMPARE(now.meshes[i].mesh, rest.meshes[i].mesh);
        QVERIFY(now.meshes[i].motion.moves());
        QCOMPARE(now.meshes[i].motion.bones, m_frame->of(m_tree)->bones);
        QCOMPARE(now.meshes[i].motion.skin->vertices, now.meshes[i].mesh->vertexCount());
    }
}

void TestMotionTools::posedScenesAreTheDeformedMeshes()
{
    MovingScene moving;
    const RenderScene now = moving.moved(restScene(), *m_frame);
    const RenderScene still = posed(now);
    for (std::size_t i = 0; i < still.meshes.size(); ++i) {
        const ItemMotion& motion = now.meshes[i].motion;
        QVERIFY(!still.meshes[i].motion.moves());
        QVERIFY(*still.meshes[i].mesh ==
                deformed(*now.meshes[i].mesh, *motion.skin, *motion.bones, motion.method));
        // The box that frames, shadows and depths go by holds everything.
        const Box box = meshBox(*still.meshes[i].mesh);
        const Box told = now.meshes[i].box.grown(1e-6);
        QVERIFY(told.min.x <= box.min.x && told.min.y <= box.min.y && told.min.z <= box.min.z);
        QVERIFY(told.max.x >= box.max.x && told.max.y >= box.max.y && told.max.z >= box.max.z);
    }
}

/// The rough model has no skin of its own: every cone follows its branch.
void TestMotionTools::foreignMeshesFollowTheirBranches()
{
    SceneView view;
    view.mode = DisplayMode::Rough;
    const RenderScene rest = SceneBuilder().build(
        m_document->scene(), [this](NodeId id) { return &m_document->result(id)->tree; }, view);
    MovingScene moving;
    const RenderScene now = moving.moved(rest, *m_frame);
    const MeshItem& bark = now.meshes.front();
    QVERIFY(bark.motion.moves());
    for (Index v = 0; v < bark.mesh->vertexCount(); v += 7)
        QCOMPARE(bark.motion.skin->of(v).bone[0], bark.mesh->branch[v]);
    // Skins made here are made once.
    QCOMPARE(moving.moved(rest, *m_frame).meshes.front().motion.skin, bark.motion.skin);
}

/// The texture modes split vertices: their copies move together, as the branches do, so that no seam opens.
void TestMotionTools::splitMeshesDoNotComeApart()
{
    for (const DisplayMode mode : {DisplayMode::Checker, DisplayMode::Stretch}) {
        SceneView view;
        view.mode = mode;
        SceneBuilder builder;
        const RenderScene rest = builder.build(
            m_document->scene(), [this](NodeId id) { return &m_document->result(id)->tree; }, view);
        MovingScene moving;
        const RenderScene now = moving.moved(rest, *m_frame);
        const MeshItem& bark = now.meshes.front();
        QVERIFY(bark.motion.moves());
        QVERIFY(bark.split.from != nullptr && bark.split.from != bark.mesh);
        const Skin& whole = *m_frame->of(m_tree)->branches;
        QCOMPARE(bark.motion.skin->vertices, bark.mesh->vertexCount());
        QCOMPARE(bark.split.vertex->size(), bark.mesh->positions.size());
        for (Index v = 0; v < bark.mesh->vertexCount(); ++v)
            QVERIFY(bark.motion.skin->of(v) == whole.of((*bark.split.vertex)[v]));
        QVERIFY(posed(now).meshes.front().mesh->positions != bark.mesh->positions);
        QCOMPARE(moving.moved(rest, *m_frame).meshes.front().motion.skin, bark.motion.skin);
    }
}

RAMURE_SUITE(TestMotionTools)

} // namespace tst_motion_tools

#include "tst_motion_tools.moc"
