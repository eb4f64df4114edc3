#include "widgets/base/targets.h"

#include "core/params/param_relevance.h"
#include "widgets/base/texts/core_text.h"
#include <QCoreApplication>
#include <algorithm>

namespace ramure {

struct TargetWords
{
    Q_DECLARE_TR_FUNCTIONS(Targets)
};

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

/// The targets, then the rest of the scene.
static std::vector<NodeId> nodesOfKind(const Document& document, const ParamDef& def)
{
    const Scene& scene = document.scene();
    std::vector<NodeId> nodes = targetNodes(document);
    for (const Node& node : scene.nodes())
        nodes.push_back(node.id);
    std::erase_if(nodes, [&](NodeId id) {
        const Node* node = scene.find(id);
        return !node || !hasParam(node->kind, def);
    });
    return nodes;
}

NodeId nodeWithParam(const Document& document, const ParamDef& def)
{
    const Scene& scene = document.scene();
    std::vector<NodeId> nodes = nodesOfKind(document, def);
    std::erase_if(nodes, [&](NodeId id) { return !acts(scene.find(id)->params, def); });
    const auto best = std::ranges::find_if(nodes, [&](NodeId id) { return !scene.isLocked(id); });
    return best != nodes.end() ? *best : nodes.empty() ? noNode : nodes.front();
}

const ParamDef* switchOf(const ParamDef& def)
{
    const auto decides = [&def](const ParamDef& other) {
        NodeParams params;
        const auto isUsed = [&](bool on) {
            other.assign(params, on);
            return def.matters(params);
        };
        return other.type == ParamType::Bool && isUsed(true) && !isUsed(false);
    };
    const auto found = def.matters ? std::ranges::find_if(paramTable(), decides) : paramTable().end();
    return found == paramTable().end() ? nullptr : &*found;
}

QString whyNoNode(const Document& document, const ParamDef& def)
{
    const std::vector<NodeId> nodes = nodesOfKind(document, def);
    if (nodes.empty())
        return TargetWords::tr("nothing in the scene has it");
    const NodeParams& params = document.scene().find(nodes.front())->params;
    const ParamDef* wanted = &def;
    if (isRelevant(params, def)) {
        const ParamDef* off = switchOf(def);
        return off ? TargetWords::tr("no effect while “%1” is off").arg(coreText(off->label))
                   : TargetWords::tr("no effect now: another value turns it off");
    }
    // The outermost choice comes first: without a grammar nobody asks for its language.
    while (const Relevance* relevance = relevanceOf(*wanted)) {
        wanted = findParam(relevance->chooser);
        if (isRelevant(params, *wanted))
            break;
    }
    const std::string chosen = std::get<EnumValue>(wanted->get(params)).name;
    const auto item =
        std::ranges::find_if(wanted->items, [&](const EnumItem& each) { return each.name == chosen; });
    return TargetWords::tr("no effect while “%1” is “%2”")
        .arg(coreText(wanted->label), coreText(item->label));
}

} // namespace ramure
