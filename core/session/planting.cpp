#include "core/session/planting.h"

#include "core/document/commands.h"
#include "core/document/document_command.h"
#include "core/document/origin_commands.h"
#include "core/math/box.h"
#include "core/params/param_def.h"
#include "core/scene/object_mesh.h"
#include "core/scene/preset_scene.h"
#include <QUndoStack>
#include <algorithm>
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
    if (const auto mesh = isObject(node.kind) ? objectMesh(node, node.params) : nullptr)
        for (const glm::vec3& p : mesh->positions)
            box.add(glm::dvec3(p));
    return box;
}

} // namespace

double usualReach(const NodeParams& params)
{
    switch (params.generator.kind) {
    case TreeGenerator::Grammar:
        break;
    case TreeGenerator::WeberPenn:
        return 0.35 * params.weberPenn.scale;
    case TreeGenerator::Colonisation:
        return params.colonisation.crownRadius;
    }
    return 10.0 * params.turtle.alpha;
}

glm::dvec3 freePlace(const Document& document, double reach)
{
    const Scene& scene = document.scene();
    std::optional<double> right;
    for (const Node& node : scene.nodes()) {
        // Trees stand on a terrain, and nobody stumbles over a camera.
        const bool counts = node.kind != NodeKind::Group && node.kind != NodeKind::Camera &&
                            node.kind != NodeKind::Terrain && scene.isShown(node.id);
        if (!counts)
            continue;
        const Box world = boxOf(document, node).transformed(worldMatrix(scene, node.id));
        right = std::max(right.value_or(world.max.x), world.max.x);
    }
    return {right ? *right + reach : 0.0, 0.0, 0.0};
}

Expected<NodeId> edit::plantTree(Document& document, const std::string& preset, NodeId parent,
                                 const std::optional<glm::dvec3>& place)
{
    return presetTree(preset).and_then(
        [&](Node&& tree) { return plantTree(document, std::move(tree), parent, place); });
}

Expected<NodeId> edit::plantTree(Document& document, Node tree, NodeId parent,
                                 const std::optional<glm::dvec3>& place)
{
    const glm::dvec3 wanted = place ? *place : freePlace(document, usualReach(tree.params));
    const glm::dmat4 above = worldMatrix(document.scene(), parent);
    const auto inParent =
        decomposePlacement(above) ? glm::dvec3(glm::inverse(above) * glm::dvec4(wanted, 1.0)) : wanted;
    tree.params.tree.translation = inParent;
    tree.id = 1; // replaced by the document
    const int row = static_cast<int>(document.scene().children(parent).size());
    return insertNodes(document, {std::move(tree)}, parent, row);
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
    const auto ids = editable(document.scene(), trees); // an empty macro would stay a step
    if (!ids)
        return fail(ids.error());
    QUndoStack& steps = *document.undoStack();
    steps.beginMacro(step);
    auto done = setParams(document, trees, values, step);
    for (const NodeId id : *ids) {
        const Node* tree = done ? document.scene().find(id) : nullptr;
        if (!tree)
            break;
        done =
            setNodeOrigin(document, id, isNamedByPreset(*tree) ? like.name : tree->name, like.preset, step);
    }
    steps.endMacro();
    return done;
}

} // namespace ramure
