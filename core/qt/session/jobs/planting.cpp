#include "core/qt/session/jobs/planting.h"

#include "core/evaluate/evaluator.h"
#include "core/math/box.h"
#include "core/params/param_def.h"
#include "core/params/source_facts.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/document_command.h"
#include "core/qt/document/origin_commands.h"
#include "core/scene/object_mesh.h"
#include "core/scene/preset_scene.h"
#include <QCoreApplication>
#include <algorithm>
#include <glm/vector_relational.hpp>
#include <string_view>

namespace ramure {
namespace {

/// In the node's own space.
Box boxOf(const Document& document, const Node& node)
{
    Box box;
    box.add(glm::dvec3(0.0));
    const NodeResult* result = document.result(node.id);
    if (result && result->tree.simplified) {
        const Skeleton& skeleton = result->tree.simplified->skeleton;
        for (Index i = 0; i < skeleton.size(); ++i)
            box.add(skeleton.p1[i]);
    }
    // An arm is nothing to look at but in its pose.
    const auto mesh = isObject(node.kind) ? objectMesh(node, node.params)
                                          : EvaluatedScene(document.scene()).solid(node).value_or(nullptr);
    if (mesh)
        for (const glm::vec3& p : mesh->positions)
            box.add(glm::dvec3(p));
    return box;
}

/// With the leaves, which reach beyond their twigs.
Box crownOf(const Document& document, const Node& node)
{
    Box box = boxOf(document, node);
    const NodeResult* result = document.result(node.id);
    if (result && result->tree.leaves)
        for (const glm::vec3& p : result->tree.leaves->positions)
            box.add(glm::dvec3(p));
    return box;
}

/// Trees stand on a terrain, and nobody stumbles over a camera.
bool isObstacle(const Scene& scene, const Node& node)
{
    return (node.kind == NodeKind::Tree || isShape(node.kind)) && node.kind != NodeKind::Terrain &&
           scene.isShown(node.id) && !isPrototype(scene, node.id);
}

/// m to the left of its origin, with a little air.
double reachOf(const Document& document, const Node& node)
{
    if (node.kind == NodeKind::Tree)
        return sourceFacts(node.params).reach(node.params);
    const Box box = boxOf(document, node);
    return 0.2 * box.size().x - box.min.x;
}

bool overlap(const Box& a, const Box& b)
{
    const glm::dvec3 least = 1e-6 * glm::min(a.size(), b.size()); // those that touch do not
    return glm::all(glm::lessThan(a.min + least, b.max)) && glm::all(glm::lessThan(b.min + least, a.max));
}

} // namespace

glm::dvec3 freePlace(const Document& document, double reach)
{
    const Scene& scene = document.scene();
    std::optional<double> right;
    for (const Node& node : scene.nodes()) {
        if (!isObstacle(scene, node))
            continue;
        const Box world = boxOf(document, node).transformed(worldMatrix(scene, node.id));
        right = std::max(right.value_or(world.max.x), world.max.x);
    }
    return {right ? *right + reach : 0.0, 0.0, 0.0};
}

Expected<NodeId> edit::plantNode(Document& document, Node node, NodeId parent,
                                 const std::optional<glm::dvec3>& place)
{
    const glm::dvec3 wanted = place ? *place : freePlace(document, reachOf(document, node));
    const glm::dmat4 above = worldMatrix(document.scene(), parent);
    const auto inParent =
        decomposePlacement(above) ? glm::dvec3(glm::inverse(above) * glm::dvec4(wanted, 1.0)) : wanted;
    node.params.tree.translation = inParent;
    node.id = 1; // replaced by the document
    const int row = static_cast<int>(document.scene().children(parent).size());
    return insertNodes(document, {std::move(node)}, parent, row);
}

Expected<double> edit::moveBeside(Document& document, const std::vector<NodeId>& tops)
{
    constexpr double gap = 0.1; // of how wide they are
    const Scene& scene = document.scene();
    Box own, others;
    std::vector<Box> boxes; // of the others
    for (const Node& node : scene.nodes()) {
        const bool isOwn = std::ranges::any_of(
            tops, [&](NodeId top) { return top == node.id || scene.isAncestor(top, node.id); });
        if (isOwn && std::ranges::find(tops, node.id) != tops.end() && !node.animation.empty())
            return 0.0;
        if (!isObstacle(scene, node))
            continue;
        const Box world = crownOf(document, node).transformed(worldMatrix(scene, node.id));
        (isOwn ? own : others).add(world);
        if (!isOwn)
            boxes.push_back(world);
    }
    if (std::ranges::none_of(boxes, [&](const Box& box) { return overlap(own, box); }))
        return 0.0;
    const double by = others.max.x - own.min.x + gap * own.size().x;
    const OneStep step(document, QCoreApplication::translate("ramure::Planting", "Move beside the others"));
    Expected<void> moved;
    for (const NodeId top : tops) {
        const Node& node = *scene.find(top);
        const glm::dmat4 above = worldMatrix(scene, node.parent);
        const glm::dvec3 way = decomposePlacement(above)
                                   ? glm::dvec3(glm::inverse(above) * glm::dvec4(by, 0.0, 0.0, 0.0))
                                   : glm::dvec3(by, 0.0, 0.0);
        if (moved)
            moved =
                setParam(document, {top}, *findParam("tree.translation"), node.params.tree.translation + way);
    }
    return moved ? Expected<double>(by) : fail(std::move(moved.error()));
}

/// What a species is, without where a tree stands and what holds it.
static bool isOfSpecies(const ParamDef& def)
{
    const std::string_view key = def.key;
    return hasParam(NodeKind::Tree, def) && def.stage != Stage::Placement && !key.starts_with("tree.") &&
           !key.starts_with("local.") && !key.starts_with("physics.");
}

/// "SmallTree" or "SmallTree 2": nobody has named it.
static bool isNamedByPreset(const Node& tree)
{
    const auto made = presetTree(tree.preset);
    if (!made || !tree.name.starts_with(made->name))
        return false;
    const std::string rest = tree.name.substr(made->name.size());
    return rest.empty() || rest.find_first_not_of("0123456789", rest[0] == ' ' ? 1 : 0) == std::string::npos;
}

Expected<void> edit::makeTreesLike(Document& document, const std::vector<NodeId>& trees, const Node& like,
                                   const QString& step)
{
    std::vector<std::pair<const ParamDef*, ParamValue>> values;
    for (const ParamDef& def : paramTable())
        if (isOfSpecies(def))
            values.emplace_back(&def, def.get(like.params));
    const auto ids = editable(document.scene(), trees);
    RAMURE_TRY(ids);
    const OneStep all(document, step);
    auto done = setParams(document, trees, values, step);
    for (const NodeId id : *ids) {
        const Node* tree = done ? document.scene().find(id) : nullptr;
        if (!tree)
            break;
        done =
            setNodeOrigin(document, id, isNamedByPreset(*tree) ? like.name : tree->name, like.preset, step);
    }
    return done;
}

} // namespace ramure
