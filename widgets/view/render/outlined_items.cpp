#include "widgets/view/render/outlined_items.h"

#include "widgets/view/render/isolated_parts.h"
#include "widgets/view/render/line_art.h"
#include "widgets/view/render/outline.h"
#include <algorithm>

namespace ramure {
namespace {

/// Faces of a tree's bark that its outline is found from: most of it stands inside the crown.
constexpr Index mostBark = 20'000;

/// The selected nodes and all below them.
std::vector<NodeId> outlinedNodes(const Scene& scene, const std::vector<NodeId>& selected)
{
    std::vector<NodeId> nodes;
    for (const Node& node : scene.nodes()) {
        const auto isIn = [](const std::vector<NodeId>& list, NodeId id) {
            return std::ranges::find(list, id) != list.end();
        };
        if (isIn(selected, node.id) || (node.parent != noNode && isIn(nodes, node.parent)))
            nodes.push_back(node.id); // parents stand before their children
    }
    return nodes;
}

/// Nothing of the tree but its bark, and that is not too much to draw once more.
bool isBare(const RenderScene& built, NodeId tree)
{
    constexpr Index most = 1'000'000; // faces
    return std::ranges::all_of(built.meshes, [tree](const MeshItem& item) {
        return item.node != tree || item.isMark || (!item.copies && item.mesh->faceCount() <= most);
    });
}

} // namespace

void outlineSelected(RenderScene& built, ScenePartCache& cache, const Scene& scene,
                     const SceneBuilder::ResultOf& resultOf, const SceneView& view)
{
    const TreeResult* tree = view.branches.empty() ? nullptr : resultOf(view.branchNode);
    const NodeId branchNode = tree && tree->simplified ? view.branchNode : noNode;
    std::vector<NodeId> whole = outlinedNodes(scene, view.selectedNodes);
    std::erase(whole, branchNode);
    const auto isWhole = [&whole](NodeId id) { return std::ranges::find(whole, id) != whole.end(); };
    for (MeshItem& item : built.meshes) {
        if (item.isMark || item.node == noNode)
            continue;
        if (isWhole(item.node)) {
            const Node* node = scene.find(item.node);
            const bool isTree = node && node->kind == NodeKind::Tree;
            const Index most = isTree && !item.copies && !isBare(built, item.node) ? mostBark : 0;
            item.outlined = cache.get<OutlinedFaces>(
                ScenePart::Outlined, item.mesh.key(), item.mesh.key(), {double(most)},
                [&] { return outlinedWhole(item.mesh, item.box, most); });
        } else if (item.node == branchNode && item.material.name == barkMaterial().name &&
                   item.mesh->branch.size() == item.mesh->positions.size()) {
            item.outlined = cache.get<OutlinedFaces>(
                ScenePart::Outlined, item.mesh.key(), tree->simplified, asNumbers(view.branches), [&] {
                    return outlinedBranches(*item.mesh,
                                            branchFlags(tree->simplified->skeleton.size(), view.branches));
                });
        }
    }
    for (LineItem& item : built.lines)
        if (item.pickable || scene.isLocked(item.node))
            item.outlined = isWhole(item.node)        ? OutlinedLines::All
                            : item.node == branchNode ? OutlinedLines::Selected
                                                      : item.outlined;
}

} // namespace ramure
