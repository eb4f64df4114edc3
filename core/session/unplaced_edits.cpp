#include "core/session/unplaced_edits.h"

#include "core/skeleton/edit_places.h"

namespace ramure {

std::vector<UnplacedEdit> unplacedEdits(const Document& document)
{
    std::vector<UnplacedEdit> all;
    for (const Node& node : document.scene().nodes()) {
        const NodeResult* result = document.result(node.id);
        if (node.params.branches.empty() || !result || !result->tree.simplified)
            continue;
        for (const std::uint64_t name : countEdits(node.params.branches, *result->tree.simplified).unplaced)
            all.push_back({node.id, name});
    }
    return all;
}

} // namespace ramure
