#include "core/qt/session/export/scene_counts.h"

#include "core/scene/object_mesh.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

void add(PartCount& count, const PartCount& more)
{
    count.vertices += more.vertices;
    count.faces += more.faces;
}

PartCount countOf(const DeferredMesh& mesh)
{
    return {mesh.vertexCount(), mesh.faceCount()};
}

/// An arm has as many faces in every pose, and a shape wherever it stands: what follows the mouse is not
/// built again for its numbers.
Node counted(const Node& node, const NodeParams& params)
{
    Node out = node;
    out.params = params;
    out.animation = {};
    out.params.tree = {};
    out.params.local = {};
    out.params.surface = {};
    out.params.arm = {};
    for (ArmJoint& joint : out.params.joints)
        joint.phi.angleRad = joint.theta.angleRad = 0.0;
    return out;
}

bool sameShape(const Node& a, const Node& b)
{
    return a.kind == b.kind && a.params == b.params && a.mesh.pointer() == b.mesh.pointer();
}

} // namespace

bool isExported(const Scene& scene, const ExportOptions& options, const Node& node)
{
    if (!(node.kind == NodeKind::Tree || isShape(node.kind)) || !isChosen(scene, options, node))
        return false;
    const auto isChosenAlone = [&](NodeId id) {
        return (id == node.id || scene.isAncestor(id, node.id)) && isPrototype(scene, id);
    };
    return !isPrototype(scene, node.id) || std::ranges::any_of(options.nodes, isChosenAlone);
}

bool isChosen(const Scene& scene, const ExportOptions& options, const Node& node)
{
    if (!options.hidden && !scene.isShown(node.id))
        return false;
    if (options.nodes.empty())
        return true;
    return std::any_of(options.nodes.begin(), options.nodes.end(),
                       [&](NodeId id) { return id == node.id || scene.isAncestor(id, node.id); });
}

PartCount SceneCounts::total() const
{
    PartCount sum;
    for (const PartCount& part : parts)
        add(sum, part);
    for (const auto& [kind, count] : kinds)
        add(sum, count);
    return sum;
}

SceneCounts SceneCounter::count(const Scene& scene, const ExportOptions& options, const TreeSource& trees)
{
    SceneCounts counts;
    const auto addTo = [&](ScenePart part, const PartCount& more) {
        add(counts.parts[static_cast<std::size_t>(part)], more);
    };
    std::map<NodeId, Known> before = std::exchange(m_shapes, {});
    EvaluatedScene now(scene);
    for (const Node& node : scene.nodes()) {
        if (!isExported(scene, options, node))
            continue;
        if (isShape(node.kind)) {
            Node shape = counted(node, now.params(node));
            const auto known = before.find(node.id);
            if (known == before.end() || !sameShape(known->second.node, shape)) {
                const auto mesh = now.solid(node);
                const PartCount made = mesh ? countOf(*mesh) : PartCount();
                m_shapes[node.id] = {std::move(shape), made};
            } else {
                m_shapes.insert(before.extract(known));
            }
            add(counts.kinds[node.kind], m_shapes[node.id].count);
            continue;
        }
        const auto tree = trees(node, Stage::Foliage, {});
        if (!tree || !tree->branches) {
            counts.complete = false;
            continue;
        }
        if (options.parts & exportBranches)
            addTo(ScenePart::Branches, countOf(DeferredMesh::Pointer(tree->branches, &tree->branches->mesh)));
        if (options.parts & exportLeaves)
            addTo(ScenePart::Leaves, countOf(tree->leaves));
        if (options.parts & exportApples)
            addTo(ScenePart::Apples, countOf(tree->apples));
    }
    return counts;
}

} // namespace ramure
