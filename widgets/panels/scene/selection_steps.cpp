#include "widgets/panels/scene/selection_steps.h"

#include <algorithm>
#include <map>
#include <set>

namespace ramure {
namespace {

/// Whom a step starts from and whom it reaches, in terms of parents alone: one description for branches and
/// nodes. Parents stand before their children.
struct Hierarchy
{
    std::vector<std::size_t> parent; ///< noPlace at the top
    std::vector<std::size_t> level;
};
constexpr std::size_t noPlace = ~std::size_t{0};

using Marks = std::vector<bool>;

Marks parentsOf(const Hierarchy& all, const Marks& from)
{
    Marks marks(from.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i])
            marks[all.parent[i] == noPlace ? i : all.parent[i]] = true;
    }
    return marks;
}

Marks childrenOf(const Hierarchy& all, const Marks& from)
{
    Marks marks(from.size(), false), childless = from;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (all.parent[i] != noPlace && from[all.parent[i]]) {
            marks[i] = true;
            childless[all.parent[i]] = false;
        }
    }
    for (std::size_t i = 0; i < from.size(); ++i)
        marks[i] = marks[i] || childless[i];
    return marks;
}

Marks siblingsOf(const Hierarchy& all, const Marks& from)
{
    Marks meant(from.size() + 1, false); // the last: the top
    const auto place = [&](std::size_t i) { return all.parent[i] == noPlace ? from.size() : all.parent[i]; };
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i])
            meant[place(i)] = true;
    }
    Marks marks(from.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i)
        marks[i] = meant[place(i)];
    return marks;
}

Marks subtreesOf(const Hierarchy& all, Marks marks)
{
    for (std::size_t i = 0; i < marks.size(); ++i)
        marks[i] = marks[i] || (all.parent[i] != noPlace && marks[all.parent[i]]);
    return marks;
}

Marks levelsOf(const Hierarchy& all, const Marks& from)
{
    std::set<std::size_t> levels;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i])
            levels.insert(all.level[i]);
    }
    Marks marks(from.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i)
        marks[i] = levels.contains(all.level[i]);
    return marks;
}

Marks stepped(const Hierarchy& all, const Marks& from, SelectionStep step)
{
    switch (step) {
    case SelectionStep::Parent:
        return parentsOf(all, from);
    case SelectionStep::Children:
        return childrenOf(all, from);
    case SelectionStep::Siblings:
        return siblingsOf(all, from);
    case SelectionStep::Subtree:
        return subtreesOf(all, from);
    case SelectionStep::Order:
        return levelsOf(all, from);
    }
    return from;
}

Selection afterBranchStep(Selection selection, const Skeleton& bones, SelectionStep step)
{
    Hierarchy all;
    all.parent.assign(bones.parent.begin(), bones.parent.end());
    std::ranges::replace(all.parent, std::size_t{noIndex}, noPlace);
    all.level.assign(bones.level.begin(), bones.level.end());
    Marks from(bones.size(), false);
    for (const Index branch : selection.branches)
        from[branch] = true;
    const Marks marks = stepped(all, from, step);
    const Index active = selection.activeBranch;
    selection.branches.clear();
    for (Index branch = 0; branch < bones.size(); ++branch) {
        if (marks[branch])
            selection.branches.push_back(branch);
    }
    // The active one stays, or is followed: up to its parent, down to its first child.
    if (active != noIndex && active < bones.size() && !marks[active]) {
        selection.activeBranch = selection.branches.empty() ? noIndex : selection.branches.front();
        for (Index branch = 0; branch < bones.size(); ++branch) {
            if (marks[branch] && (bones.parent[branch] == active || bones.parent[active] == branch)) {
                selection.activeBranch = branch;
                break;
            }
        }
    }
    return selection;
}

Selection afterNodeStep(Selection selection, const Scene& scene, SelectionStep step)
{
    const auto& nodes = scene.nodes();
    Hierarchy all;
    Marks from(nodes.size(), false);
    std::map<NodeId, std::size_t> places;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        places[nodes[i].id] = i;
        const bool top = nodes[i].parent == noNode;
        all.parent.push_back(top ? noPlace : places.at(nodes[i].parent));
        all.level.push_back(top ? 0 : all.level[all.parent[i]] + 1);
        if (std::ranges::count(selection.nodes, nodes[i].id) > 0)
            from[i] = true;
    }
    const Marks marks = stepped(all, from, step);
    const NodeId active = selection.activeNode();
    selection.nodes.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (marks[i] && nodes[i].id != active)
            selection.nodes.push_back(nodes[i].id);
    }
    if (active != noNode && marks[places.at(active)])
        selection.nodes.push_back(active); // the last is the active one
    return selection;
}

} // namespace

Selection afterStep(const Document& document, SelectionStep step)
{
    const Selection& selection = document.selection();
    const NodeResult* result = selection.branches.empty() ? nullptr : document.result(selection.branchNode);
    if (!result || !result->tree.simplified)
        return afterNodeStep(selection, document.scene(), step);
    return afterBranchStep(selection, result->tree.simplified->skeleton, step);
}

} // namespace ramure
