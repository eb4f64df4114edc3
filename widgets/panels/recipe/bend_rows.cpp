#include "widgets/panels/recipe/bend_rows.h"

#include "core/qt/session/jobs/unplaced_edits.h"
#include "widgets/base/texts/branch_names.h"
#include <algorithm>
#include <map>

namespace ramure {

std::vector<BendRow> bendRows(const Document& document, NodeId tree)
{
    const Node* node = document.scene().find(tree);
    const NodeResult* result = document.result(tree);
    const auto isBent = [](const auto& entry) { return entry.second.bendRad != glm::dvec3(0.0); };
    if (!node || !result || !result->tree.simplified || std::ranges::none_of(node->params.branches, isBent))
        return {};
    const BranchRows rows(result->tree);
    const BranchNames names;
    const Skeleton& skeleton = result->tree.simplified->skeleton;
    std::vector<BendRow> bends;
    std::map<Index, std::size_t> byAxis;
    for (Index b = 0; b < skeleton.size(); ++b) {
        const auto found = node->params.branches.find(skeleton.name(b));
        if (found == node->params.branches.end() || !isBent(*found))
            continue;
        const auto [place, isNew] = byAxis.try_emplace(rows.axisOf(b), bends.size());
        if (isNew)
            bends.push_back({{}, {}, names.axis(rows, rows.axisOf(b))});
        bends[place->second].names.push_back(found->first);
        bends[place->second].branches.push_back(b);
    }
    for (const std::vector<UnplacedEdit>& group : unplacedGroups(document)) {
        const UnplacedEdit& first = group.front();
        if (first.node != tree || first.isTreeEdit || !isBent(*node->params.branches.find(first.name)))
            continue;
        BendRow& lost = bends.emplace_back();
        for (const UnplacedEdit& edit : group)
            lost.names.push_back(edit.name);
    }
    return bends;
}

} // namespace ramure
