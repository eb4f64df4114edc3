#include "core/scene/shown_nodes.h"

#include "core/scene/kinds/node_kinds.h"
#include <algorithm>

namespace ramure {

void showOnly(Scene& scene, std::span<const NodeId> chosen)
{
    const Scene whole = scene;
    for (const Node& from : whole.nodes()) {
        const auto isAbove = [&](NodeId id) { return whole.isAncestor(from.id, id); };
        const auto isBelow = [&](NodeId id) { return whole.isAncestor(id, from.id); };
        Node& node = *scene.find(from.id);
        if (std::ranges::count(chosen, from.id) > 0)
            node.visible = true;
        else if (std::ranges::any_of(chosen, isBelow))
            continue;
        else if (std::ranges::any_of(chosen, isAbove)) {
            node.kind = NodeKind::Group; // a place for what was chosen, nothing to see
            node.visible = true;
        } else
            node.visible = false;
    }
}

bool showsAnything(const Scene& scene)
{
    return std::ranges::any_of(scene.nodes(), [&scene](const Node& node) {
        return (node.kind == NodeKind::Tree || isShape(node.kind)) && scene.isShown(node.id);
    });
}

} // namespace ramure
