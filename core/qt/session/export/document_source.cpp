#include "core/qt/session/export/document_source.h"

#include "core/qt/document/document.h"
#include <map>

namespace ramure {

static Expected<TreeResult> currentResult(const Document& document, NodeId id)
{
    const NodeResult* result = document.result(id);
    if (!result || !document.isCurrent(id))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the tree is still being computed"));
    if (result->error)
        return fail(*result->error);
    return result->tree;
}

TreeSource documentSource(const Document& document)
{
    std::map<NodeId, Expected<TreeResult>> results;
    for (const Node& node : document.scene().nodes())
        if (node.kind == NodeKind::Tree)
            results.emplace(node.id, currentResult(document, node.id));
    return [kept = std::move(results)](const Node& node, Stage, const Progress&) -> Expected<TreeResult> {
        const auto found = kept.find(node.id);
        if (found == kept.end())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(node.id)});
        return found->second;
    };
}

} // namespace ramure
