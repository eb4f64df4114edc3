#include "core/evaluate/evaluator.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace tst_swinging_leaves {

using namespace ramure;

namespace {

Node treeWithLeaves(LeafShape shape, double wind = 1.0)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = presetParams("TinyTree").value_or(NodeParams{});
    node.params.leaf.shape = shape;
    node.params.physics.windStrength = wind;
    return node;
}

/// The tree as it moves; fails the test where there is none.
PosedTree posedAt(Evaluator& evaluator, const Node& node, double seconds)
{
    auto posed = evaluator.posedTree(node, Stage::Foliage, seconds, true);
    if (!posed)
        qFatal("%s", posed.error().message().c_str());
    return std::move(*posed);
}

double distanceToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a))
        return std::abs(glm::dot(p - a, glm::normalize(normal)));
    const auto toSide = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 way = to - from;
        const double share = std::clamp(glm::dot(p - from, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::length(p - from - share * way);
    };
    return std::min({toSide(a, b), toSide(b, c), toSide(c, a)});
}

/// The triangles of the tubes, by branch.
std::vector<std::span<const glm::uvec3>> trianglesByBranch(const BranchMesh& mesh, Index branches)
{
    std::vector<std::span<const glm::uvec3>> out(branches);
    const std::span<const glm::uvec3> all = mesh.mesh.triangles;
    for (std::size_t i = 0; i < mesh.tubes.size(); ++i) {
        const std::size_t first = mesh.tubes[i].firstTriangle;
        const std::size_t end = i + 1 < mesh.tubes.size() ? mesh.tubes[i + 1].firstTriangle : all.size();
        out[mesh.tubes[i].branch] = all.subspan(first, end - first);
    }
    return out;
}

/// From the foot of a leaf to the tube of its branch, in radii of its thinner end.
double distanceToBark(const FoliageItem& leaf, std::span<const glm::uvec3> tube, const TreeResult& tree)
{
    const std::vector<glm::vec3>& bark = tree.branches->mesh.positions;
    double nearest = std::numeric_limits<double>::max();
    for (const glm::uvec3& t : tube)
        nearest = std::min(nearest, distanceToTriangle(leaf.position, glm::dvec3(bark[t.x]),
                                                       glm::dvec3(bark[t.y]), glm::dvec3(bark[t.z])));
    const Skeleton& skeleton = tree.simplified->skeleton;
    return nearest / std::min(skeleton.a0[leaf.branch], skeleton.a1[leaf.branch]);
}

} // namespace

class TestSwingingLeaves : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void anyValuesGiveRigidFrames()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        for (const char* key : {"foliage.leafStiffness", "foliage.leafFlutter", "physics.windStrength",
                                "physics.gravity", "physics.windTurbulence"}) {
            const ParamDef& def = *findParam(key);
            for (const double value : {def.hardMin, def.hardMax})
                for (const PhysicsMode mode : {PhysicsMode::Faithful, PhysicsMode::Robust}) {
                    Node node = treeWithLeaves(LeafShape::Aspen);
                    node.params.physics.mode = mode;
                    def.assign(node.params, value);
                    const NodeMotion motion = posedAt(evaluator, node, 0.7).motion;
                    QVERIFY(motion.firstLeaf != noIndex && motion.bones->size() > motion.firstLeaf);
                    for (const RigidTransform& bone : *motion.bones) {
                        QVERIFY2(std::abs(glm::length(bone.rotation) - 1.0) < 1e-6, key);
                        QVERIFY2(std::isfinite(glm::length(bone.translation)), key);
                    }
                }
        }
    }

    void faithfulLeavesGoWithTheirBranches()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        const PosedTree posed = posedAt(evaluator, treeWithLeaves(LeafShape::Faithful), 1.0);
        QCOMPARE(posed.motion.firstLeaf, noIndex);
        QCOMPARE(posed.motion.bones->size(),
                 posed.rest.simplified->skeleton.size() + posed.rest.foliage->apples.size());
    }

    void inStillAirTheyRest()
    {
        TreePipeline pipeline;
        for (const LeafShape shape : {LeafShape::Birch, LeafShape::Fir}) {
            Evaluator evaluator(pipelineSource(pipeline));
            const Node node = treeWithLeaves(shape, 0.0);
            for (const double seconds : {0.0, 0.01, 0.5, 7.0}) {
                const NodeMotion motion = posedAt(evaluator, node, seconds).motion;
                for (const RigidTransform& bone : *motion.bones) {
                    QVERIFY(std::abs(bone.rotation.w - 1.0) < 1e-14);
                    QVERIFY(glm::length(bone.translation) < 1e-14);
                }
            }
        }
    }

    void theFirstStepIsNoJump()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        const Node node = treeWithLeaves(LeafShape::Aspen, 5.0);
        const NodeMotion motion = posedAt(evaluator, node, 0.01).motion;
        for (const RigidTransform& bone : std::span(*motion.bones).subspan(motion.firstLeaf))
            QVERIFY(std::abs(bone.rotation.w) > std::cos(0.1));
    }

    /// As far as a wind of its strength bears them; and not all alike.
    void theySwing()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        const auto meanTurn = [&](const Node& node, double seconds) {
            const PosedTree posed = posedAt(evaluator, node, seconds);
            const std::vector<RigidTransform>& bones = *posed.motion.bones;
            double sum = 0.0;
            const std::vector<FoliageItem>& leaves = posed.rest.foliage->leaves;
            for (std::size_t i = 0; i < leaves.size(); ++i) {
                const glm::dquat turned = glm::conjugate(bones[leaves[i].branch].rotation) *
                                          bones[posed.motion.firstLeaf + i].rotation;
                sum += 2.0 * std::acos(std::min(std::abs(turned.w), 1.0));
            }
            return sum / double(leaves.size());
        };
        Node node = treeWithLeaves(LeafShape::Aspen);
        const double breeze = meanTurn(node, 2.0);
        node.params.physics.windStrength = 5.0;
        const double storm = meanTurn(node, 2.0);
        node.params.leaf.stiffness = 20.0;
        const double stiff = meanTurn(node, 2.0);
        QVERIFY2(breeze > 0.1 && storm > 1.5 * breeze && stiff < 0.5 * storm,
                 qPrintable(QStringLiteral("%1 %2 %3 rad").arg(breeze).arg(storm).arg(stiff)));
    }

    void weightPullsWhereTheTwigTurns()
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        Node node = treeWithLeaves(LeafShape::Maple, 0.0);
        node.params.physics.settled = false; // the weight comes with the first step
        const PosedTree posed = posedAt(evaluator, node, 3.0);
        const auto now = movedTree(posed.rest, posed.motion, {});
        QVERIFY(now);
        int lower = 0, all = 0;
        for (std::size_t i = 0; i < posed.rest.foliage->leaves.size(); ++i, ++all) {
            const auto& bone = (*posed.motion.bones)[posed.rest.foliage->leaves[i].branch];
            const glm::dvec3 tip(0.0, 1.0, 0.0);
            lower += (now->foliage->leaves[i].orientation * tip).y <=
                     (bone.rotation * posed.rest.foliage->leaves[i].orientation * tip).y + 1e-9;
        }
        QVERIFY(all > 50 && lower == all);
    }

    void anyOrderOfTimesGivesTheSame()
    {
        TreePipeline pipeline;
        Evaluator played(pipelineSource(pipeline)), sought(pipelineSource(pipeline));
        const Node node = treeWithLeaves(LeafShape::Birch, 3.0);
        std::vector<std::vector<RigidTransform>> frames;
        for (int frame = 0; frame < 40; ++frame)
            frames.push_back(*posedAt(played, node, 0.04 * frame).motion.bones);
        for (const int frame : {39, 3, 17, 18, 0, 25, 1})
            QVERIFY(*posedAt(sought, node, 0.04 * frame).motion.bones == frames[std::size_t(frame)]);
    }

    /// The feet of all petioles, in a storm of 300 frames.
    void feetStayOnTheBark()
    {
        TreePipeline pipeline;
        for (const SkinMethod method : {SkinMethod::DualQuaternion, SkinMethod::Linear}) {
            Evaluator evaluator(pipelineSource(pipeline));
            Node node = treeWithLeaves(LeafShape::Birch, 5.0);
            node.params.sections = {12, 48};
            node.params.skin.method = method;
            const PosedTree rest = posedAt(evaluator, node, 0.0);
            const auto tubes = trianglesByBranch(*rest.rest.branches, rest.rest.simplified->skeleton.size());
            std::vector<std::size_t> feet;
            const std::vector<FoliageItem>& leaves = rest.rest.foliage->leaves;
            for (std::size_t i = 0; i < leaves.size(); ++i)
                if (distanceToBark(leaves[i], tubes[leaves[i].branch], rest.rest) < 0.01)
                    feet.push_back(i);
            QCOMPARE(feet.size(), leaves.size());
            double most = 0.0;
            for (std::size_t frame = 1; frame <= 300; frame += test::isSanitized ? 20 : 1) {
                const PosedTree posed = posedAt(evaluator, node, double(frame) / 25.0);
                const auto now = movedTree(posed.rest, posed.motion, {});
                QVERIFY(now);
                for (std::size_t k = frame % 8; k < feet.size(); k += 8) {
                    const FoliageItem& leaf = now->foliage->leaves[feet[k]];
                    most = std::max(most, distanceToBark(leaf, tubes[leaf.branch], *now));
                }
            }
            qInfo("%zu of %zu feet, largest distance from the bark: %.2f %% of the radius", feet.size(),
                  leaves.size(), 100.0 * most);
            QVERIFY2(most < 0.02, qPrintable(QString::number(most)));
        }
    }
};

RAMURE_SUITE(TestSwingingLeaves)

} // namespace tst_swinging_leaves

#include "tst_swinging_leaves.moc"
