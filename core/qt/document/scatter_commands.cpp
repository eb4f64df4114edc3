#include "core/qt/document/scatter_commands.h"

#include "core/qt/document/document_command.h"
#include "core/scatter/scatter.h"
#include "core/scene/kinds/node_kinds.h"
#include <array>
#include <charconv>

namespace ramure {
namespace {

Expected<const Node*> scatterOf(const Document& document, NodeId id)
{
    const Node* node = document.scene().find(id);
    if (!node || node->kind != NodeKind::Scatter)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(id)});
    return node;
}

bool canBeCopied(const Node& node)
{
    return node.kind == NodeKind::Tree || (isShape(node.kind) && node.kind != NodeKind::Terrain);
}

std::string hexText(std::uint32_t key)
{
    std::array<char, 8> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), key, 16).ptr};
}

} // namespace

Expected<NodeId> edit::addScatter(Document& document, Node scatter, const std::vector<NodeId>& nodes)
{
    std::vector<NodeId> tops;
    for (const NodeId id : nodes) {
        const Scene& scene = document.scene();
        RAMURE_TRY(checkEditable(scene, id));
        if (!canBeCopied(*scene.find(id)))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("“%1” is nothing that a scatter can copy"),
                        {scene.find(id)->name});
        if (std::ranges::none_of(nodes, [&](NodeId other) { return scene.isAncestor(other, id); }))
            tops.push_back(id);
    }
    const Node* first = tops.empty() ? nullptr : document.scene().find(tops.front());
    const NodeId parent = first ? first->parent : noNode;
    const int row = first ? document.scene().row(first->id) : int(document.scene().children(noNode).size());
    scatter.id = 1; // replaced by the document
    scatter.parent = noNode;
    const OneStep step(document, DocumentCommand::tr("Scatter"));
    const auto added = insertNodes(document, {std::move(scatter)}, parent, row);
    RAMURE_TRY(added);
    for (const NodeId id : tops)
        RAMURE_TRY(moveNode(document, id, *added, int(document.scene().children(*added).size()), false));
    Selection selection;
    selection.nodes = {*added};
    document.setSelection(std::move(selection));
    return added;
}

Expected<NodeId> edit::makeReal(Document& document, NodeId scatter, std::uint32_t key)
{
    const auto from = scatterOf(document, scatter);
    RAMURE_TRY(from);
    const auto places = scatterPlaces(document.scene(), **from);
    RAMURE_TRY(places);
    const auto place = std::ranges::find(**places, key, &ScatterPlace::key);
    if (place == (*places)->end())
        return fail(ErrorCode::Unknown, RAMURE_NOOP("the scatter has no such copy"));
    const Node& prototype = *prototypesOf(document.scene(), scatter)[place->prototype];
    std::vector<Node> nodes = document.scene().subtree(prototype.id);
    PlacementParams turned = prototype.params.tree;
    turned.translation = glm::dvec3(0.0);
    auto standing = decomposePlacement(placementMatrix((*from)->params.tree) * placeMatrix(*place) *
                                       placementMatrix(turned));
    RAMURE_TRY(standing);
    nodes.front().params.tree = *standing;
    const NodeId parent = (*from)->parent;
    const int row = document.scene().row(scatter) + 1;
    const OneStep step(document, DocumentCommand::tr("Make it a tree of its own"));
    RAMURE_TRY(removeCopies(document, scatter, {key}));
    return insertNodes(document, std::move(nodes), parent, row);
}

Expected<void> edit::removeCopies(Document& document, NodeId scatter, const std::vector<std::uint32_t>& keys)
{
    const auto from = scatterOf(document, scatter);
    RAMURE_TRY(from);
    std::string removed = (*from)->params.scatter.removed;
    for (const std::uint32_t key : keys)
        removed.append(removed.empty() ? "" : " ").append(hexText(key));
    return setParam(document, {scatter}, *findParam("scatter.removed"), removed);
}

} // namespace ramure
