#include "widgets/view/tools/selection_edits.h"

#include <algorithm>
#include <iterator>

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

/// Adds the limb; or, where the branch was selected, takes out what of the limb is.
void toggle(Selection& selection, Index branch, const std::vector<Index>& limb)
{
    std::vector<Index> after;
    if (!std::ranges::binary_search(selection.branches, branch)) {
        std::ranges::set_union(selection.branches, limb, std::back_inserter(after));
        selection.activeBranch = branch;
    } else {
        std::ranges::set_difference(selection.branches, limb, std::back_inserter(after));
        if (!std::ranges::binary_search(after, selection.activeBranch))
            selection.activeBranch = after.empty() ? noIndex : after.back();
    }
    selection.branches = std::move(after);
    if (selection.branches.empty())
        selection.branchNode = noNode;
}

} // namespace

Selection afterClick(const Selection& selection, const std::optional<PickHit>& hit,
                     const std::vector<Index>& limb, bool extend)
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
    const bool again = !extend && hit->node == selection.branchNode && selection.branches == limb;
    toggle(next, hit->branch, again ? std::vector{hit->branch} : limb);
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
