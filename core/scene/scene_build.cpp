#include "core/scene/scene.h"

#include <algorithm>

namespace ramure {

/// Per node, the indices of its children; under noNode those of the top level.
using Family = std::map<NodeId, std::vector<std::size_t>>;

static tl::unexpected<Error> failAt(std::size_t index, const char* key, const char* text, NodeId id)
{
    auto error = fail(ErrorCode::Invalid, text, {std::to_string(id)});
    error.value().path.append("[").append(std::to_string(index)).append("].").append(key);
    return error;
}

static Expected<Family> familyOf(const std::vector<Node>& nodes)
{
    Family below{{noNode, {}}};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].id == noNode)
            return failAt(i, "id", RAMURE_NOOP("%1 is no id of a node"), nodes[i].id);
        if (!below.try_emplace(nodes[i].id).second)
            return failAt(i, "id", RAMURE_NOOP("another node has the id %1 as well"), nodes[i].id);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto parent = below.find(nodes[i].parent);
        if (parent == below.end())
            return failAt(i, "parent", RAMURE_NOOP("there is no node %1"), nodes[i].parent);
        parent->second.push_back(i);
    }
    return below;
}

Expected<Scene> Scene::fromNodes(std::vector<Node> nodes)
{
    const auto below = familyOf(nodes);
    RAMURE_TRY(below);
    Scene scene;
    scene.m_nodes.reserve(nodes.size());
    std::vector<bool> placed(nodes.size(), false);
    std::vector<std::size_t> stack;
    const auto push = [&](NodeId parent) {
        const std::vector<std::size_t>& children = below->at(parent);
        stack.insert(stack.end(), children.rbegin(), children.rend());
    };
    push(noNode);
    while (!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        placed[i] = true;
        push(nodes[i].id);
        scene.noteUsed(nodes[i].id);
        scene.m_nodes.push_back(std::make_shared<Node>(std::move(nodes[i])));
    }
    // What the way down from the top level never met hangs in a circle.
    const auto lost = std::find(placed.begin(), placed.end(), false);
    if (lost != placed.end()) {
        const auto index = static_cast<std::size_t>(lost - placed.begin());
        return failAt(index, "parent", RAMURE_NOOP("the parents of node %1 go round in a circle"),
                      nodes[index].id);
    }
    return scene;
}

} // namespace ramure
