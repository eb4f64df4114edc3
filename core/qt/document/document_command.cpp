#include "core/qt/document/document_command.h"

#include <atomic>

namespace ramure {

GestureId newGesture()
{
    static std::atomic<GestureId> last{0};
    return ++last;
}

tl::unexpected<Error> unknownNode(NodeId id)
{
    return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(id)});
}

Expected<void> checkEditable(const Scene& scene, NodeId id)
{
    const Node* node = scene.find(id);
    if (!node)
        return unknownNode(id);
    if (scene.isLocked(id))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is locked"), {node->name});
    return {};
}

Expected<std::vector<NodeId>> editable(const Scene& scene, const std::vector<NodeId>& ids)
{
    std::vector<NodeId> once;
    for (const NodeId id : ids) {
        RAMURE_TRY(checkEditable(scene, id));
        addOnce(once, id);
    }
    return once;
}

} // namespace ramure
