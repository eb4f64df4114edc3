#include "core/qt/session/jobs/unplaced_edits.h"

#include <algorithm>

namespace ramure {

std::vector<UnplacedEdit> unplacedEdits(const Document& document)
{
    std::vector<UnplacedEdit> all;
    for (const Node& node : document.scene().nodes()) {
        const NodeResult* result = document.result(node.id);
        if (!result || !result->tree.edits)
            continue;
        for (const EditOutcome& outcome : *result->tree.edits)
            if (outcome.state == EditState::Unplaced &&
                std::ranges::find(node.params.edits, outcome.id, &TreeEdit::id) != node.params.edits.end())
                all.push_back({node.id, outcome.id});
    }
    return all;
}

} // namespace ramure
