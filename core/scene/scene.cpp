#include "core/scene/scene.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <set>
#include <utility>

namespace ramure {

NodeList::operator std::vector<Node>() const
{
    return {begin(), end()};
}

/// Nodes mostly stand in the order they were made in: looked for from there outwards, both ways.
std::size_t Scene::indexOf(NodeId id) const
{
    const std::size_t count = m_nodes.size();
    if (count == 0)
        return 0;
    const std::size_t guess = id == noNode ? 0 : std::min(static_cast<std::size_t>(id) - 1, count - 1);
    std::size_t below = guess + 1, above = guess + 1; // below: one more than the next index to look at
    while (below > 0 || above < count) {
        if (below > 0 && m_nodes[--below]->id == id)
            return below;
        if (above < count && m_nodes[above++]->id == id)
            return above - 1;
    }
    return count;
}

const Node* Scene::find(NodeId id) const
{
    const std::size_t index = id == noNode ? m_nodes.size() : indexOf(id);
    return index < m_nodes.size() ? m_nodes[index].get() : nullptr;
}

Node* Scene::find(NodeId id)
{
    const std::size_t index = id == noNode ? m_nodes.size() : indexOf(id);
    return index < m_nodes.size() ? &own(index) : nullptr;
}

/// To be changed.
Node& Scene::own(std::size_t index)
{
    std::shared_ptr<Node>& node = m_nodes[index];
    if (node.use_count() > 1)
        node = std::make_shared<Node>(*node);
    else
        std::atomic_thread_fence(std::memory_order_acquire); // whoever shared it until now has read it
    return *node;
}

std::vector<NodeId> Scene::children(NodeId parent) const
{
    std::vector<NodeId> ids;
    for (const Node& node : nodes())
        if (node.parent == parent)
            ids.push_back(node.id);
    return ids;
}

int Scene::row(NodeId id) const
{
    const Node* node = find(id);
    if (!node)
        return -1;
    int row = 0;
    for (const Node& other : nodes()) {
        if (other.id == id)
            break;
        row += other.parent == node->parent ? 1 : 0;
    }
    return row;
}

/// One past the last node below the one at \p top: a node belongs to it as long as its parent has been seen
/// in the block, and depth-first order keeps the block together.
std::size_t Scene::subtreeEnd(std::size_t top) const
{
    std::set<NodeId> inside{m_nodes[top]->id};
    std::size_t end = top + 1;
    while (end < m_nodes.size() && inside.contains(m_nodes[end]->parent))
        inside.insert(m_nodes[end++]->id);
    return end;
}

std::vector<Node> Scene::subtree(NodeId id) const
{
    if (!find(id))
        return {};
    const std::size_t top = indexOf(id);
    const auto first = nodes().begin();
    return {first + static_cast<std::ptrdiff_t>(top), first + static_cast<std::ptrdiff_t>(subtreeEnd(top))};
}

bool Scene::isAncestor(NodeId ancestor, NodeId node) const
{
    const Node* current = find(node);
    while (current) {
        if (current->parent == ancestor)
            return true;
        current = find(current->parent);
    }
    return false;
}

bool Scene::isShown(NodeId id) const
{
    const Node* node = find(id);
    if (!node)
        return false;
    for (; node; node = find(node->parent))
        if (!node->visible)
            return false;
    return true;
}

bool Scene::isLocked(NodeId id) const
{
    for (const Node* node = find(id); node; node = find(node->parent))
        if (node->locked)
            return true;
    return false;
}

bool isPrototype(const Scene& scene, NodeId id)
{
    const Node* node = scene.find(id);
    while (node && (node = scene.find(node->parent)))
        if (node->kind == NodeKind::Scatter)
            return true;
    return false;
}

NodeId Scene::newId()
{
    if (m_nextId != noNode)
        return m_nextId++;
    std::set<NodeId> used;
    for (const Node& node : nodes())
        used.insert(node.id);
    NodeId id = 1;
    while (used.contains(id))
        ++id;
    return id;
}

void Scene::noteUsed(NodeId highest)
{
    if (m_nextId != noNode && highest >= m_nextId)
        m_nextId = highest + 1; // wraps to noNode behind the highest id of all
}

/// Index in m_nodes at which a child of \p parent must be inserted to become its child number \p row.
std::size_t Scene::placeFor(NodeId parent, int row) const
{
    const std::size_t first = parent == noNode ? 0 : indexOf(parent) + 1;
    const std::size_t last = parent == noNode ? m_nodes.size() : subtreeEnd(indexOf(parent));
    int seen = 0;
    for (std::size_t i = first; i < last; ++i) {
        if (m_nodes[i]->parent != parent)
            continue;
        if (seen >= row)
            return i;
        ++seen;
    }
    return last;
}

void Scene::splice(NodeList::Pointers block, NodeId parent, int row)
{
    const auto place = static_cast<std::ptrdiff_t>(placeFor(parent, row));
    block.front()->parent = parent;
    m_nodes.insert(m_nodes.begin() + place, std::make_move_iterator(block.begin()),
                   std::make_move_iterator(block.end()));
}

Expected<void> Scene::insert(std::vector<Node> nodes, NodeId parent, int row)
{
    if (nodes.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no node to insert"));
    if (parent != noNode && !find(parent))
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(parent)});
    std::set<NodeId> used;
    for (const Node& node : this->nodes())
        used.insert(node.id);
    std::set<NodeId> seen;
    for (const Node& node : nodes) {
        const std::string id = std::to_string(node.id);
        if (!seen.empty() && !seen.contains(node.parent))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the parent of node %1 does not stand before it"),
                        {id});
        if (used.contains(node.id))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("another node has the id %1 as well"), {id});
        seen.insert(node.id);
    }
    nodes.front().parent = noNode; // whatever it was: within the block it is the top
    auto ordered = fromNodes(std::move(nodes));
    RAMURE_TRY(ordered);
    noteUsed(*seen.rbegin());
    splice(std::move(ordered->m_nodes), parent, row);
    return {};
}

NodeList::Pointers Scene::take(NodeId id)
{
    const std::size_t top = indexOf(id);
    own(top); // it may get another parent
    const auto first = m_nodes.begin() + static_cast<std::ptrdiff_t>(top);
    const auto last = m_nodes.begin() + static_cast<std::ptrdiff_t>(subtreeEnd(top));
    NodeList::Pointers taken(std::make_move_iterator(first), std::make_move_iterator(last));
    m_nodes.erase(first, last);
    return taken;
}

std::vector<Node> Scene::remove(NodeId id)
{
    if (!std::as_const(*this).find(id))
        return {};
    const NodeList::Pointers taken = take(id);
    return NodeList(taken);
}

bool Scene::operator==(const Scene& other) const
{
    const auto same = [](const std::shared_ptr<Node>& a, const std::shared_ptr<Node>& b) {
        return a == b || *a == *b;
    };
    return std::ranges::equal(m_nodes, other.m_nodes, same) && m_timeline == other.m_timeline &&
           m_bookmarks == other.m_bookmarks;
}

Expected<void> Scene::move(NodeId id, NodeId newParent, int row)
{
    for (const NodeId known : {id, newParent})
        if (known != noNode && !find(known))
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(known)});
    if (id == noNode)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(id)});
    if (id == newParent || isAncestor(id, newParent))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a node cannot be moved below itself"));
    splice(take(id), newParent, row);
    return {};
}

} // namespace ramure
