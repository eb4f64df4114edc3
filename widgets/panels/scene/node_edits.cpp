#include "widgets/panels/scene/node_edits.h"

#include "core/qt/document/commands.h"
#include <QCoreApplication>
#include <algorithm>
#include <optional>
#include <set>

namespace ramure {
namespace {

QString stepText(const char* english)
{
    return QCoreApplication::translate("NodeEdits", english);
}

struct Shift
{
    NodeId node;
    int row;
};

/// In an order in which each can be done after those before it.
std::vector<Shift> shiftsOf(const Scene& scene, const std::vector<NodeId>& nodes, int step)
{
    std::set<NodeId> parents;
    for (const NodeId id : nodes) {
        if (const Node* node = scene.find(id))
            parents.insert(node->parent);
    }
    std::vector<Shift> shifts;
    for (const NodeId parent : parents) {
        std::vector<NodeId> order = scene.children(parent);
        if (step > 0)
            std::ranges::reverse(order);
        // Seen from the end they move towards: whoever is not yet there changes places with the one before.
        for (std::size_t at = 1; at < order.size(); ++at) {
            const auto meant = [&](std::size_t i) { return std::ranges::count(nodes, order[i]) > 0; };
            if (!meant(at) || meant(at - 1))
                continue;
            std::swap(order[at], order[at - 1]);
            const auto row = step > 0 ? order.size() - at : at - 1;
            shifts.push_back({order[at - 1], static_cast<int>(row)});
        }
    }
    return shifts;
}

} // namespace

Expected<void> edit::shiftNodes(Document& document, const std::vector<NodeId>& nodes, int step)
{
    const std::vector<Shift> shifts = shiftsOf(document.scene(), nodes, step);
    for (const Shift& shift : shifts) {
        if (document.scene().isLocked(shift.node))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is locked"),
                        {document.scene().find(shift.node)->name});
    }
    std::optional<OneStep> all;
    if (shifts.size() > 1)
        all.emplace(document, stepText(QT_TRANSLATE_NOOP("NodeEdits", "Move nodes")));
    for (const Shift& shift : shifts) {
        const NodeId parent = document.scene().find(shift.node)->parent;
        RAMURE_TRY(moveNode(document, shift.node, parent, shift.row, false));
    }
    return {};
}

Expected<void> edit::isolateNodes(Document& document, const std::vector<NodeId>& nodes)
{
    const Scene& scene = document.scene();
    std::vector<NodeId> hide, show;
    for (const Node& node : scene.nodes()) {
        if (scene.isLocked(node.id))
            continue;
        const auto isMeant = [&](NodeId id) { return id == node.id || scene.isAncestor(id, node.id); };
        const auto isAbove = [&](NodeId id) { return scene.isAncestor(node.id, id); };
        const bool holds = std::ranges::any_of(nodes, isAbove) || std::ranges::count(nodes, node.id) > 0;
        if (holds && !node.visible)
            show.push_back(node.id);
        else if (!holds && node.visible && std::ranges::none_of(nodes, isMeant) && scene.isShown(node.id))
            hide.push_back(node.id);
    }
    // Of a hidden group what is below it need not be hidden as well.
    const std::vector<NodeId> all = hide;
    std::erase_if(hide, [&](NodeId id) {
        return std::ranges::any_of(all, [&](NodeId other) { return scene.isAncestor(other, id); });
    });
    if (hide.empty() && show.empty())
        return showAllNodes(document);
    const OneStep step(document, stepText(QT_TRANSLATE_NOOP("NodeEdits", "Isolate")));
    if (!hide.empty()) {
        RAMURE_TRY(setNodeVisible(document, hide, false));
    }
    return show.empty() ? Expected<void>() : setNodeVisible(document, show, true);
}

Expected<void> edit::showAllNodes(Document& document)
{
    std::vector<NodeId> hidden;
    for (const Node& node : document.scene().nodes()) {
        if (!node.visible && !document.scene().isLocked(node.id))
            hidden.push_back(node.id);
    }
    return hidden.empty() ? Expected<void>() : setNodeVisible(document, hidden, true);
}

} // namespace ramure
