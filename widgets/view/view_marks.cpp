#include "widgets/view/view_marks.h"

#include <utility>

namespace ramure {
namespace {

std::vector<NodeId> withAllBelow(const Scene& scene, NodeId top)
{
    std::vector<NodeId> nodes;
    for (const Node& node : scene.nodes())
        if (node.id == top || scene.isAncestor(top, node.id))
            nodes.push_back(node.id);
    return nodes;
}

} // namespace

void ViewMarks::beginDocument()
{
    m_pointed = m_marked = {};
    m_inspected = {};
}

void ViewMarks::inspect(NodeId node, Index branch, Index section)
{
    const InspectedSection next{node, branch, section};
    if (std::exchange(m_inspected, next) != next)
        emit sceneChanged();
}

void ViewMarks::isolate(NodeId node, const std::vector<Index>& branches)
{
    const Branches next{node, branches};
    if (std::exchange(m_isolated, next) != next)
        emit sceneChanged();
}

void ViewMarks::pointAt(NodeId node, const std::vector<Index>& branches)
{
    const Branches next{node, branches};
    if (std::exchange(m_pointed, next) != next)
        emit highlightsChanged();
}

void ViewMarks::mark(NodeId node, std::vector<Index> branches, bool go)
{
    const bool any = node != noNode && !branches.empty();
    const Branches next = any ? Branches{node, std::move(branches), go} : Branches();
    if (std::exchange(m_marked, next) != next)
        emit highlightsChanged();
}

void ViewMarks::addTo(SceneView& view, const Scene& scene) const
{
    view.inspected = m_inspected;
    view.isolatedNode = m_isolated.node;
    view.isolatedBranches = m_isolated.branches;
    // What is pointed at elsewhere goes before what the mouse left behind here.
    const Branches& shownAs = m_pointed.node != noNode ? m_pointed : m_marked;
    if (shownAs.node == noNode)
        return;
    view.hoverNode = shownAs.node;
    view.hoverBranches = shownAs.branches;
    view.hoverGoes = shownAs.go;
    view.hoverThrough = !shownAs.branches.empty();
    if (m_pointed.node != noNode && m_pointed.branches.empty())
        view.hoverNodes = withAllBelow(scene, m_pointed.node);
}

} // namespace ramure
