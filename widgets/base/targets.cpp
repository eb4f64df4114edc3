#include "widgets/base/targets.h"

#include "core/params/param_relevance.h"
#include <algorithm>

namespace ramure {

std::vector<NodeId> targetNodes(const Document& document)
{
    const Selection& selection = document.selection();
    if (!selection.nodes.empty())
        return selection.nodes;
    if (selection.branchNode != noNode)
        return {selection.branchNode};
    const auto& nodes = document.scene().nodes();
    return nodes.size() == 1 ? std::vector<NodeId>{nodes.front().id} : std::vector<NodeId>();
}

std::vector<NodeId> targetTrees(const Document& document)
{
    const Scene& scene = document.scene();
    const std::vector<NodeId> targets = targetNodes(document);
    std::vector<NodeId> trees;
    for (const Node& node : scene.nodes()) {
        const auto isMeant = [&](NodeId target) {
            return target == node.id || scene.isAncestor(target, node.id);
        };
        if (node.kind == NodeKind::Tree && (targets.empty() || std::ranges::any_of(targets, isMeant)))
            trees.push_back(node.id);
    }
    return trees;
}

NodeId nodeWithParam(const Document& document, const ParamDef& def)
{
    const Scene& scene = document.scene();
    std::vector<NodeId> nodes = targetNodes(document);
    for (const Node& node : scene.nodes())
        nodes.push_back(node.id);
    std::erase_if(nodes, [&](NodeId id) {
        const Node* node = scene.find(id);
        return !node || !hasParam(node->kind, def);
    });
    const auto best = std::ranges::find_if(
        nodes, [&](NodeId id) { return !scene.isLocked(id) && isRelevant(scene.find(id)->params, def); });
    return best != nodes.end() ? *best : nodes.empty() ? noNode : nodes.front();
}

} // namespace ramure
