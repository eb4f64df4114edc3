#include "widgets/view/tools/selection_edits.h"

#include <algorithm>

namespace ramure {
namespace {

/// Puts the node last: it becomes the active one.
void activate(Selection& selection, NodeId node)
{
    std::erase(selection.nodes, node);
    selection.nodes.push_back(node);
}

void clearBranches(Selection& selection)
{
    selection.branchNode = noNode;
    selection.branches.clear();
    selection.activeBranch = noIndex;
}

void toggle(Selection& selection, Index branch)
{
    const auto at = std::lower_bound(selection.branches.begin(), selection.branches.end(), branch);
    if (at == selection.branches.end() || *at != branch) {
        selection.branches.insert(at, branch);
        selection.activeBranch = branch;
        return;
    }
    selection.branches.erase(at);
    if (selection.activeBranch == branch)
        selection.activeBranch = selection.branches.empty() ? noIndex : selection.branches.back();
    if (selection.branches.empty())
        selection.branchNode = noNode;
}

} // namespace

Selection afterClick(const Selection& selection, const std::optional<PickHit>& hit, bool extend)
{
    Selection next = selection;
    if (!hit) {
        if (!extend)
            clearBranches(next);
        return next;
    }
    if (!extend)
        next.nodes.clear();
    activate(next, hit->node);
    if (!extend || hit->node != selection.branchNode)
        clearBranches(next);
    if (hit->branch == noIndex)
        return next;
    next.branchNode = hit->node;
    toggle(next, hit->branch);
    return next;
}

bool isSelected(const Selection& selection, const PickHit& hit)
{
    if (hit.branch != noIndex)
        return hit.node == selection.branchNode && std::ranges::binary_search(selection.branches, hit.branch);
    return std::ranges::find(selection.nodes, hit.node) != selection.nodes.end();
}

Selection afterBox(const Selection& selection, const std::vector<PickedBranches>& picked, bool extend)
{
    Selection next = selection;
    if (!extend)
        clearBranches(next);
    if (picked.empty())
        return next;
    const PickedBranches* chosen = &picked.front();
    for (const PickedBranches& of : picked) {
        const bool wasChosen = chosen->node == selection.branchNode;
        if (of.node == selection.branchNode || (!wasChosen && of.branches.size() > chosen->branches.size()))
            chosen = &of;
    }
    if (!extend)
        next.nodes.clear();
    for (const PickedBranches& of : picked)
        activate(next, of.node);
    activate(next, chosen->node);
    if (next.branchNode != chosen->node)
        clearBranches(next);
    std::vector<Index> both;
    std::set_union(next.branches.begin(), next.branches.end(), chosen->branches.begin(),
                   chosen->branches.end(), std::back_inserter(both));
    next.branchNode = chosen->node;
    next.branches = std::move(both);
    if (!std::binary_search(next.branches.begin(), next.branches.end(), next.activeBranch))
        next.activeBranch = next.branches.front();
    return next;
}

} // namespace ramure
