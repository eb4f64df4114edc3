#include "core/math/random.h"
#include "core/rig/pose/skin.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_skin {

using namespace ramure;
using namespace ramure::test;

class TestSkin : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void foreignSkeletonsAreErrors();
    void influencesAreConvex_data() { presets(); }
    void influencesAreConvex();
    void restPoseChangesNothing_data() { presets(); }
    void restPoseChangesNothing();
    void rigidFollowsTheBranch();
    void wholeTreesTurnAsOne_data() { methods(); }
    void wholeTreesTurnAsOne();
    void blendsMatchAPlainComputation_data() { methods(); }
    void blendsMatchAPlainComputation();
    void strongBendsKeepTheRadiusWithDualQuaternions();
    void movingTreesStayManifolds_data() { presets(); }
    void movingTreesStayManifolds();
    void leavesStayAtTheirAnchors();
    void normalsStandOnTheSurface();
    void loosePiecesHaveTheirOwnBones();
    void lengthsOfRunsChangeNoBit();

private:
    static void presets();
    static void methods();
};

namespace {

struct Tree
{
    Skeleton skeleton;
    BranchMesh mesh;
};

Tree treeOf(const QString& preset)
{
    Tree tree;
    tree.skeleton = presetSkeleton({preset.toStdString()}).value_or(Skeleton{});
    tree.mesh = buildBranchMesh(tree.skeleton, {}).value_or(BranchMesh{});
    return tree;
}

using Bones = std::vector<RigidTransform>;

/// Every branch turns by at most \p mostRad about its start, after its parent.
Bones swayingPose(const Skeleton& skeleton, double mostRad, std::uint64_t seed)
{
    Random random(seed, RandomStream::Leaves, 0);
    const auto signedUnit = [&] { return 2.0 * random.unit() - 1.0; };
    Bones pose(skeleton.size());
    for (Index b = 0; b < skeleton.size(); ++b) {
        glm::dvec3 axis(signedUnit(), signedUnit(), signedUnit());
        const double length = glm::length(axis);
        axis = length > 1e-3 ? axis / length : glm::dvec3(1, 0, 0);
        const RigidTransform own = turnAbout(skeleton.p0[b], glm::angleAxis(mostRad * signedUnit(), axis));
        pose[b] = skeleton.parent[b] == noIndex ? own : pose[skeleton.parent[b]] * own;
    }
    return pose;
}

double farthest(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    double most = a.size() == b.size() ? 0.0 : 1e9;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
        most = std::max(most, double(glm::length(a[i] - b[i])));
    return most;
}

bool isSmooth(SkinMethod method)
{
    return method != SkinMethod::Rigid;
}

/// Without quaternions and without runs: matrices by Rodrigues' formula, or the definition of the dual
/// quaternion's motion as the mean screw of two bones.
glm::dvec3 plainLinear(const SkinInfluence& influence, const Bones& pose, const glm::dvec3& point)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 3; ++i)
        sum += double(influence.weight[i]) * pose[influence.bone[i]].point(point);
    return sum;
}

} // namespace

void TestSkin::presets()
{
    QTest::addColumn<QString>("preset");
    for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        QTest::newRow(name) << QString(name);
}

void TestSkin::methods()
{
    QTest::addColumn<int>("method");
    QTest::newRow("rigid") << int(SkinMethod::Rigid);
    QTest::newRow("linear") << int(SkinMethod::Linear);
    QTest::newRow("dual quaternion") << int(SkinMethod::DualQuaternion);
}

void TestSkin::foreignSkeletonsAreErrors()
{
    const Tree tree = treeOf("TinyTree");
    Skeleton one;
    one.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    QVERIFY(!bindBranches(tree.mesh, one, true));
    QVERIFY(!bindBranches(tree.mesh, one, false));
    QVERIFY(!bindBranches(tree.mesh, Skeleton{}, true));
    BranchMesh ownerless = tree.mesh;
    ownerless.mesh.branch.clear();
    QVERIFY(!bindBranches(ownerless, tree.skeleton, false));
    const std::vector<FoliageItem> stray{{tree.skeleton.size(), {}, {}}};
    TriangleMesh leaf;
    leaf.positions.resize(3);
    QVERIFY(!bindFoliage(leaf, stray, tree.mesh, tree.skeleton, true));
    const std::vector<FoliageItem> two(2, FoliageItem{0, {}, {1, 0, 0, 0}});
    QVERIFY(!bindFoliage(leaf, two, tree.mesh, tree.skeleton, true)); // three vertices for two leaves
    QVERIFY(!bindLoose(leaf.vertexCount(), 2, 0));
    QCOMPARE(bindLoose(0, 0, 5)->runs.size(), std::size_t(0));
}

void TestSkin::influencesAreConvex()
{
    QFETCH(QString, preset);
    const Tree tree = treeOf(preset);
    for (const bool smooth : {false, true}) {
        const auto skin = bindBranches(tree.mesh, tree.skeleton, smooth);
        QVERIFY(skin);
        QCOMPARE(skin->vertices, tree.mesh.mesh.vertexCount());
        QCOMPARE(skin->bones, tree.skeleton.size());
        QCOMPARE(skin->runs.front().firstVertex, Index(0));
        for (std::size_t r = 0; r < skin->runs.size(); ++r) {
            const SkinRun& run = skin->runs[r];
            QVERIFY(r == 0 || run.firstVertex > skin->runs[r - 1].firstVertex);
            float sum = 0.0F;
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(run.influence.weight[i] >= 0.0F);
                QVERIFY(i == 0 || run.influence.weight[i] <= run.influence.weight[i - 1]);
                QVERIFY(run.influence.bone[i] < skin->bones);
                sum += run.influence.weight[i];
            }
            QVERIFY(std::abs(sum - 1.0F) < 1e-6F);
        }
        // A cross-section has one set of weights: far fewer runs than vertices.
        QVERIFY(skin->runs.size() * (smooth ? 3 : 8) < std::size_t(tree.mesh.mesh.vertexCount()) * 2);
    }
}

void TestSkin::restPoseChangesNothing()
{
    QFETCH(QString, preset);
    const Tree tree = treeOf(preset);
    const Bones rest(tree.skeleton.size());
    for (const SkinMethod method : {SkinMethod::Rigid, SkinMethod::Linear, SkinMethod::DualQuaternion}) {
        const auto skin = bindBranches(tree.mesh, tree.skeleton, isSmooth(method));
        const TriangleMesh out = deformed(tree.mesh.mesh, *skin, rest, method);
        QVERIFY(farthest(out.positions, tree.mesh.mesh.positions) < 2e-6);
        QVERIFY(farthest(out.normals, tree.mesh.mesh.normals) < 2e-6);
    }
}

void TestSkin::rigidFollowsTheBranch()
{
    const Tree tree = treeOf("SmallTree");
    const Bones pose = swayingPose(tree.skeleton, 0.2, 7);
    const auto skin = bindBranches(tree.mesh, tree.skeleton, false);
    const TriangleMesh& mesh = tree.mesh.mesh;
    const TriangleMesh out = deformed(mesh, *skin, pose, SkinMethod::Rigid);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const RigidTransform& bone = pose[mesh.branch[v]];
        QVERIFY(glm::length(bone.point(glm::dvec3(mesh.positions[v])) - glm::dvec3(out.positions[v])) < 1e-5);
        QVERIFY(glm::length(bone.direction(glm::dvec3(mesh.normals[v])) - glm::dvec3(out.normals[v])) < 1e-5);
    }
}

void TestSkin::wholeTreesTurnAsOne()
{
    QFETCH(int, method);
    const Tree tree = treeOf("FanTree");
    const RigidTransform turn{glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.1)), {1.0, -2.0, 0.5}};
    Bones pose(tree.skeleton.size(), turn);
    // q and -q are one rotation: the mix must not care.
    for (std::size_t b = 0; b < pose.size(); b += 3)
        pose[b].rotation = -pose[b].rotation;
    const auto skin = bindBranches(tree.mesh, tree.skeleton, isSmooth(SkinMethod(method)));
    const TriangleMesh out = deformed(tree.mesh.mesh, *skin, pose, SkinMethod(method));
    for (Index v = 0; v < tree.mesh.mesh.vertexCount(); ++v) {
        QVERIFY(glm::length(turn.point(glm::dvec3(tree.mesh.mesh.positions[v])) -
                            glm::dvec3(out.positions[v])) < 1e-5);
        QVERIFY(std::abs(glm::length(out.normals[v]) - 1.0F) < 1e-5F);
    }
}

void TestSkin::blendsMatchAPlainComputation()
{
    QFETCH(int, method);
    const Tree tree = treeOf("SmallTree");
    const Bones pose = swayingPose(tree.skeleton, 0.3, 11);
    const auto skin = bindBranches(tree.mesh, tree.skeleton, isSmooth(SkinMethod(method)));
    const TriangleMesh out = deformed(tree.mesh.mesh, *skin, pose, SkinMethod(method));
    Index blended = 0;
    for (Index v = 0; v < tree.mesh.mesh.vertexCount(); ++v) {
        const SkinInfluence& influence = skin->of(v);
        const glm::dvec3 rest(tree.mesh.mesh.positions[v]), now(out.positions[v]);
        blended += influence.weight[1] > 0.0F ? 1 : 0;
        if (SkinMethod(method) != SkinMethod::DualQuaternion)
            QVERIFY(glm::length(plainLinear(influence, pose, rest) - now) < 1e-5);
        else
            QVERIFY(glm::length(glm::dvec3(skinMatrix(influence, pose, SkinMethod::DualQuaternion) *
                                           glm::dvec4(rest, 1.0)) -
                                now) < 1e-5);
    }
    QCOMPARE(blended > 0, SkinMethod(method) != SkinMethod::Rigid);
}

/// Half way between two bones that are bent by 120 degrees, about the joint: linear mixing halves the
/// radius, dual quaternions keep it.
void TestSkin::strongBendsKeepTheRadiusWithDualQuaternions()
{
    const glm::dvec3 joint(0.3, 1.0, -0.2);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.0, 0.0, 1.0));
    const Bones pose{{}, turnAbout(joint, glm::angleAxis(2.0943951023931953, axis))};
    const SkinInfluence half{{0, 1, 0}, {0.5F, 0.5F, 0.0F}};
    const glm::dvec3 offset(0.1, 0.0, 0.0); // in the plane of the bend
    const auto radius = [&](SkinMethod method) {
        const glm::dvec4 at = skinMatrix(half, pose, method) * glm::dvec4(joint + offset, 1.0);
        return glm::length(glm::dvec3(at) - joint) / 0.1;
    };
    QVERIFY(std::abs(radius(SkinMethod::Linear) - 0.5) < 1e-9);
    QVERIFY(std::abs(radius(SkinMethod::DualQuaternion) - 1.0) < 1e-9);
    // The mean of two screws about one axis through the joint is half the turn.
    const glm::dvec4 at =
        skinMatrix(half, pose, SkinMethod::DualQuaternion) * glm::dvec4(joint + offset, 1.0);
    const glm::dvec3 meant = joint + glm::angleAxis(1.0471975511965976, axis) * offset;
    QVERIFY(glm::length(glm::dvec3(at) - meant) < 1e-12);
}

void TestSkin::movingTreesStayManifolds()
{
    QFETCH(QString, preset);
    const Tree tree = treeOf(preset);
    for (const SkinMethod method : {SkinMethod::Rigid, SkinMethod::Linear, SkinMethod::DualQuaternion}) {
        const auto skin = bindBranches(tree.mesh, tree.skeleton, isSmooth(method));
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            TriangleMesh now = tree.mesh.mesh;
            now.positions =
                deformed(tree.mesh.mesh, *skin, swayingPose(tree.skeleton, 0.15, seed), method).positions;
            const auto report = validateMesh(now);
            QVERIFY(report);
            QCOMPARE(report->boundaryEdges + report->nonManifoldEdges + report->inconsistentEdges, Index(0));
            QCOMPARE(report->duplicateVertices, Index(0));
            QCOMPARE(report->degenerateFaces, Index(0));
            QVERIFY(report->valid);
        }
    }
}

void TestSkin::leavesStayAtTheirAnchors()
{
    const Tree tree = treeOf("SmallTree");
    FoliageParams params;
    params.leavesCutoff = 0.6;
    const auto foliage = placeFoliage(tree.skeleton, params, 0.2);
    QVERIFY(foliage && !foliage->leaves.empty());
    const TriangleMesh leaves = buildLeaves(tree.skeleton, *foliage, 0.2, FoliageModel::Fine);
    const Bones pose = swayingPose(tree.skeleton, 0.2, 3);
    const std::size_t corners = leaves.positions.size() / foliage->leaves.size();
    for (const bool smooth : {false, true}) {
        const auto skin = bindFoliage(leaves, foliage->leaves, tree.mesh, tree.skeleton, smooth);
        QVERIFY(skin);
        const SkinMethod method = smooth ? SkinMethod::DualQuaternion : SkinMethod::Rigid;
        const TriangleMesh out = deformed(leaves, *skin, pose, method);
        for (std::size_t leaf = 0; leaf < foliage->leaves.size(); ++leaf) {
            const FoliageItem& item = foliage->leaves[leaf];
            const SkinInfluence& influence = skin->of(static_cast<Index>(leaf * corners));
            QVERIFY(influence.bone[0] == item.branch ||
                    influence.bone[0] == tree.skeleton.parent[item.branch] || influence.weight[1] > 0.0F);
            const glm::dvec3 anchor(skinMatrix(influence, pose, method) * glm::dvec4(item.position, 1.0));
            glm::dvec3 before(0.0), after(0.0);
            for (std::size_t c = 0; c < corners; ++c) {
                before += glm::dvec3(leaves.positions[leaf * corners + c]) / double(corners);
                after += glm::dvec3(out.positions[leaf * corners + c]) / double(corners);
            }
            // As far from its anchor as it was, and as large.
            QVERIFY(std::abs(glm::length(after - anchor) - glm::length(before - item.position)) < 1e-5);
            QVERIFY(std::abs(glm::distance(out.positions[leaf * corners], out.positions[leaf * corners + 1]) -
                             glm::distance(leaves.positions[leaf * corners],
                                           leaves.positions[leaf * corners + 1])) < 1e-5F);
        }
    }
}

/// Normals of the moved mesh against those computed anew from its faces.
void TestSkin::normalsStandOnTheSurface()
{
    const Tree tree = treeOf("SmallTree");
    for (const SkinMethod method : {SkinMethod::Rigid, SkinMethod::Linear, SkinMethod::DualQuaternion}) {
        const auto skin = bindBranches(tree.mesh, tree.skeleton, isSmooth(method));
        TriangleMesh now = tree.mesh.mesh;
        const TriangleMesh out = deformed(tree.mesh.mesh, *skin, swayingPose(tree.skeleton, 0.05, 5), method);
        now.positions = out.positions;
        computeNormals(now);
        double sum = 0.0;
        for (Index v = 0; v < now.vertexCount(); ++v)
            sum += std::acos(std::clamp(double(glm::dot(now.normals[v], out.normals[v])), -1.0, 1.0));
        const double mean = sum / now.vertexCount(); // where parts bend, normals turn by a share of the bend
        QVERIFY2(mean < (isSmooth(method) ? 0.018 : 0.025), qPrintable(QString::number(mean)));
    }
}

void TestSkin::loosePiecesHaveTheirOwnBones()
{
    TriangleMesh pieces;
    for (int i = 0; i < 9; ++i) {
        pieces.positions.emplace_back(float(i), 0.0F, 0.0F);
        pieces.normals.emplace_back(0.0F, 1.0F, 0.0F);
    }
    const auto skin = bindLoose(pieces.vertexCount(), 3, 4);
    QVERIFY(skin);
    QCOMPARE(skin->bones, Index(7));
    Bones pose(7);
    pose[5].translation = {0.0, 2.0, 0.0};
    const TriangleMesh out = deformed(pieces, *skin, pose, SkinMethod::Rigid);
    for (std::size_t i = 0; i < 9; ++i)
        QCOMPARE(out.positions[i].y, i / 3 == 1 ? 2.0F : 0.0F);
}

/// Vertices are moved several at once: each comes out as it does alone, whatever stands around it, and
/// nothing behind the last one is touched.
void TestSkin::lengthsOfRunsChangeNoBit()
{
    constexpr float guard = -77.0F;
    Random random(3, RandomStream::Leaves, 0);
    const auto number = [&random] { return static_cast<float>(4.0 * random.unit() - 2.0); };
    const Bones pose{turnAbout({0.1, 0.2, 0.3}, glm::normalize(glm::dquat(0.7, 0.1, -0.5, 0.3))),
                     turnAbout({0.5, -2.0, 0.1}, glm::normalize(glm::dquat(0.2, 0.6, 0.4, -0.3)))};
    Deformer deformer, alone;
    deformer.setPose(pose, SkinMethod::Rigid);
    alone.setPose(pose, SkinMethod::Rigid);
    for (std::size_t first = 1; first <= 28; ++first)
        for (std::size_t second = 1; second <= 28; second += first < 10 ? 1 : 5) {
            const std::size_t all = first + second;
            std::vector<glm::vec3> rest(all), normals(all), out(all + 1, glm::vec3(guard)), turned(out);
            for (std::size_t v = 0; v < all; ++v) {
                rest[v] = {number(), number(), number()};
                normals[v] = {number(), number(), number()};
            }
            const Skin skin{{{0, {{0, 0, 0}, {1, 0, 0}}}, {Index(first), {{1, 1, 1}, {1, 0, 0}}}},
                            static_cast<Index>(all),
                            2};
            deformer.deform(rest, normals, skin, std::span(out).first(all), std::span(turned).first(all));
            QVERIFY(out.back() == glm::vec3(guard) && turned.back() == glm::vec3(guard));
            for (std::size_t v = 0; v < all; ++v) {
                const Index bone = v < first ? 0 : 1;
                const Skin one{{{0, {{bone, bone, bone}, {1, 0, 0}}}}, 1, 2};
                glm::vec3 at, normal;
                alone.deform({&rest[v], 1}, {&normals[v], 1}, one, {&at, 1}, {&normal, 1});
                QVERIFY(at == out[v] && normal == turned[v]);
            }
        }
}

RAMURE_SUITE(TestSkin)

} // namespace tst_skin

#include "tst_skin.moc"
