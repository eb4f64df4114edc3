#include "widgets/view/render/line_art.h"
#include "widgets/view/render/scene_builder.h"
#include <algorithm>

namespace ramure {
namespace {

/// Where the branches that are pointed at are behind the leaves.
void addPointedCurves(RenderScene& built, const SceneBuilder::ResultOf& resultOf, const SceneView& view)
{
    std::erase_if(built.lines, [](const LineItem& item) { return item.pointed; });
    const TreeResult* tree = view.hoverThrough ? resultOf(view.hoverNode) : nullptr;
    if (!tree || !tree->simplified || (view.hoverBranches.size() > mostCurves && !view.hoverGoes))
        return;
    const auto bark = std::ranges::find_if(built.meshes, [&view](const MeshItem& item) {
        return item.node == view.hoverNode && !item.isMark && item.hasBranches();
    });
    if (bark == built.meshes.end())
        return;
    LineItem line;
    line.lines = std::make_shared<const LineSet>(
        branchCurves(tree->simplified->skeleton, view.hoverBranches,
                     view.hoverGoes ? CurveColour::Goes : CurveColour::Pointed));
    line.world = bark->world;
    line.node = view.hoverNode;
    line.throughSurfaces = line.pointed = true;
    if (!line.lines->segments.empty())
        built.lines.push_back(std::move(line));
}

} // namespace

void updateHighlights(RenderScene& built, const SceneBuilder::ResultOf& resultOf, const SceneView& view)
{
    built.highlights.clear();
    addPointedCurves(built, resultOf, view);
    const auto statesOf = [&resultOf](NodeId node) -> BranchStates {
        const TreeResult* tree = node == noNode ? nullptr : resultOf(node);
        return BranchStates(tree && tree->simplified ? tree->simplified->skeleton.size() : 0,
                            BranchState::Plain);
    };
    const auto add = [&built](NodeId node, BranchStates states) {
        if (!states.empty())
            built.highlights.push_back({node, std::make_shared<const BranchStates>(std::move(states))});
    };
    BranchStates selected = view.branches.empty() ? BranchStates() : statesOf(view.branchNode);
    for (const Index branch : view.branches) {
        if (branch < selected.size())
            selected[branch] = branch == view.activeBranch ? BranchState::Active : BranchState::Selected;
    }
    const auto hover = [&view](BranchState& state) {
        state = view.hoverGoes && !view.hoverBranches.empty() ? BranchState::Goes
                : state == BranchState::Plain                 ? BranchState::Hovered
                                                              : BranchState::HoveredSelected;
    };
    if (!view.hoverBranches.empty()) {
        const bool same = view.hoverNode == view.branchNode && !selected.empty();
        BranchStates hovered = same ? BranchStates() : statesOf(view.hoverNode);
        BranchStates& target = same ? selected : hovered;
        for (const Index branch : view.hoverBranches)
            if (branch < target.size())
                hover(target[branch]);
        add(view.hoverNode, std::move(hovered));
    }
    for (const NodeId node : view.hoverNodes) {
        if (node == view.branchNode && !selected.empty()) {
            std::ranges::for_each(selected, hover);
            continue;
        }
        BranchStates hovered = statesOf(node);
        const bool isTree = !hovered.empty();
        hovered.assign(isTree ? hovered.size() : mostArmJoints + 1, BranchState::Hovered);
        add(node, std::move(hovered));
        built.highlights.back().whole = !isTree;
    }
    add(view.branchNode, std::move(selected));
}

} // namespace ramure
