#include "core/qt/session/jobs/unplaced_edits.h"

#include "core/skeleton/edit_places.h"
#include <algorithm>
#include <map>
#include <tuple>

namespace ramure {

std::vector<UnplacedEdit> unplacedEdits(const Document& document)
{
    std::vector<UnplacedEdit> all;
    for (const Node& node : document.scene().nodes()) {
        const NodeResult* result = document.result(node.id);
        if (!result || !result->tree.simplified)
            continue;
        for (const EditOutcome& outcome : result->tree.edits ? *result->tree.edits : EditReport())
            if (outcome.state == EditState::Unplaced &&
                std::ranges::find(node.params.edits, outcome.id, &TreeEdit::id) != node.params.edits.end())
                all.push_back({node.id, outcome.id, true});
        if (node.params.branches.empty())
            continue;
        for (const std::uint64_t name : countEdits(node.params.branches, *result->tree.simplified).unplaced)
            all.push_back({node.id, name, false});
    }
    return all;
}

std::vector<std::vector<UnplacedEdit>> unplacedGroups(const Document& document)
{
    std::vector<std::vector<UnplacedEdit>> groups;
    std::map<std::tuple<NodeId, std::uint64_t, bool>, std::size_t> byAxis; // true: bends
    for (const UnplacedEdit& edit : unplacedEdits(document)) {
        const NodeParams& params = document.scene().find(edit.node)->params;
        const BranchParams* branch = edit.isTreeEdit ? nullptr : &params.branches.at(edit.name);
        if (!branch || branch->place.way.empty()) {
            groups.push_back({edit});
            continue;
        }
        const auto [at, isNew] = byAxis.try_emplace(
            {edit.node, branch->place.way.back().address, branch->bendRad != glm::dvec3(0.0)}, groups.size());
        if (isNew)
            groups.emplace_back();
        groups[at->second].push_back(edit);
    }
    return groups;
}

} // namespace ramure
