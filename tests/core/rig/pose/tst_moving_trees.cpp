#include "core/rig/pose/skin.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "tests/core/rig/physics/physics_support.h"

namespace tst_moving_trees {

using namespace ramure;
using namespace ramure::test;

/// Trees as the physics moves them, at frames drawn by chance: still one closed manifold, and leaves and
/// apples still where they grow.
class TestMovingTrees : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void theMeshNeverCracks_data() { presetsAndModes(); }
    void theMeshNeverCracks();
    void leavesAndApplesStayAtTheirAnchors_data() { presetsAndModes(); }
    void leavesAndApplesStayAtTheirAnchors();

private:
    static void presetsAndModes();
};

namespace {

constexpr std::int64_t stepsPlayed = test::isSanitized ? 200 : 1000;
constexpr int framesLookedAt = test::isSanitized ? 20 : 100;

/// A storm: the strongest wind of the slider, with gusts.
PhysicsParams stormy(PhysicsMode mode)
{
    PhysicsParams params;
    params.mode = mode;
    params.windStrength = 5.0;
    params.windGust = 1.0;
    params.windTurbulence = 1.0;
    return params;
}

/// Poses at \p frames random steps of one play.
std::vector<Pose> randomFrames(const MovingTree& tree, PhysicsMode mode)
{
    Random random(5, RandomStream::Leaves, 0);
    std::vector<bool> wanted(stepsPlayed + 1);
    for (int i = 0; i < framesLookedAt; ++i)
        wanted[1 + random.below(stepsPlayed)] = true;
    TreePhysics physics(tree.body(), stormy(mode));
    PhysicsState state = physics.restState();
    std::vector<Pose> frames;
    while (state.step < stepsPlayed) {
        physics.step(state);
        if (wanted[static_cast<std::size_t>(state.step)])
            physics.pose(state, frames.emplace_back());
    }
    return frames;
}

double heightOf(const Skeleton& skeleton)
{
    double top = 0.0;
    for (const glm::dvec3& end : skeleton.p1)
        top = std::max(top, end.y);
    return top;
}

glm::dvec3 centreOf(const std::vector<glm::vec3>& positions, std::size_t first, std::size_t count)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = first; i < first + count; ++i)
        sum += glm::dvec3(positions[i]) / double(count);
    return sum;
}

/// The farthest that the centre of a piece is from where it grows, over all frames.
double farthestFromAnchor(const TriangleMesh& mesh, const std::vector<FoliageItem>& items, const Skin& skin,
                          const std::vector<Pose>& frames, SkinMethod method)
{
    const std::size_t corners = mesh.positions.size() / items.size();
    TriangleMesh now = mesh;
    Deformer deformer;
    double most = 0.0;
    for (const Pose& pose : frames) {
        deformer.setPose(pose.bones, method);
        deformer.deform(mesh.positions, mesh.normals, skin, now.positions, now.normals);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const SkinInfluence& influence = skin.of(static_cast<Index>(i * corners));
            const glm::dmat4 matrix = skinMatrix(influence, pose.bones, method);
            const glm::dvec3 grows(matrix * glm::dvec4(items[i].position, 1.0));
            // On its own branch alone there is no mixing to ask: the branch's bone says where it grows.
            const glm::dvec3 onBranch = pose.bones[items[i].branch].point(items[i].position);
            if (influence.weight[1] == 0.0F && influence.bone[0] == items[i].branch)
                most = std::max(most, glm::distance(grows, onBranch));
            most = std::max(most, glm::distance(grows, centreOf(now.positions, i * corners, corners)));
        }
    }
    return most;
}

} // namespace

void TestMovingTrees::presetsAndModes()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("mode");
    for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"}) {
        QTest::addRow("%s robust", name) << QString(name) << int(PhysicsMode::Robust);
        QTest::addRow("%s faithful", name) << QString(name) << int(PhysicsMode::Faithful);
    }
}

void TestMovingTrees::theMeshNeverCracks()
{
    QFETCH(const QString, preset);
    QFETCH(const int, mode);
    const MovingTree tree = presetTree(preset.toStdString());
    const auto mesh = buildBranchMesh(tree.skeleton, {});
    QVERIFY(mesh);
    const std::vector<Pose> frames = randomFrames(tree, PhysicsMode(mode));
    QVERIFY(5 * frames.size() > 4 * std::size_t(framesLookedAt)); // some were drawn twice
    const auto skin = bindBranches(*mesh, tree.skeleton, true);
    TriangleMesh now = mesh->mesh;
    Deformer deformer;
    double moved = 0.0;
    for (const Pose& pose : frames) {
        deformer.setPose(pose.bones, SkinMethod::DualQuaternion);
        deformer.deform(mesh->mesh.positions, mesh->mesh.normals, *skin, now.positions, now.normals);
        const auto report = validateMesh(now);
        QVERIFY(report);
        QCOMPARE(report->boundaryEdges + report->nonManifoldEdges + report->nonManifoldVertices +
                     report->inconsistentEdges + report->duplicateVertices + report->duplicateFaces +
                     report->degenerateFaces,
                 Index(0));
        QVERIFY(report->valid);
        moved = std::max(moved, double(glm::distance(now.positions.back(), mesh->mesh.positions.back())));
    }
    QVERIFY(moved > 0.001 * heightOf(tree.skeleton));
}

void TestMovingTrees::leavesAndApplesStayAtTheirAnchors()
{
    QFETCH(const QString, preset);
    QFETCH(const int, mode);
    MovingTree tree = presetTree(preset.toStdString());
    FoliageParams params;
    params.leavesDensity = 10;
    params.leavesCutoff = 0.8;
    params.applesProbability = 0.1;
    tree.foliage = *placeFoliage(tree.skeleton, params, tree.alpha);
    const auto branches = buildBranchMesh(tree.skeleton, {});
    QVERIFY(branches);
    const std::vector<Pose> frames = randomFrames(tree, PhysicsMode(mode));
    const double bar = 1e-4 * heightOf(tree.skeleton);
    for (const bool apples : {false, true}) {
        const std::vector<FoliageItem>& items = apples ? tree.foliage.apples : tree.foliage.leaves;
        if (items.empty())
            continue;
        const TriangleMesh mesh =
            apples ? buildApples(tree.skeleton, tree.foliage, tree.alpha, FoliageModel::Fine)
                   : buildLeaves(tree.skeleton, tree.foliage, tree.alpha, FoliageModel::Fine);
        for (const SkinMethod method : {SkinMethod::Rigid, SkinMethod::Linear, SkinMethod::DualQuaternion}) {
            const auto skin = bindFoliage(mesh, items, *branches, tree.skeleton, method != SkinMethod::Rigid);
            QVERIFY(skin);
            const double most = farthestFromAnchor(mesh, items, *skin, frames, method);
            QVERIFY2(most < bar, qPrintable(QString::number(most / heightOf(tree.skeleton))));
        }
    }
}

RAMURE_SUITE(TestMovingTrees)

} // namespace tst_moving_trees

#include "tst_moving_trees.moc"
