#include "core/session/unplaced_edits.h"

#include "core/skeleton/edit_places.h"
#include <algorithm>

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

} // namespace ramure
