#include "core/scene/arm_demo.h"

#include "core/scene/kinds/node_kinds.h"

namespace ramure {

Scene armDemo()
{
    std::vector<Node> nodes;
    for (const NodeKind kind : {NodeKind::Arm, NodeKind::Terrain}) {
        Node& node = nodes.emplace_back();
        node.id = static_cast<NodeId>(nodes.size());
        node.kind = kind;
        node.name = kindRow(kind).label;
        kindRow(kind).begin(node.params);
    }
    // Both are new, different ids: this cannot fail.
    return Scene::fromNodes(std::move(nodes)).value_or(Scene());
}

} // namespace ramure
