#include "widgets/view/tools/limb_finder.h"

#include "core/evaluate/evaluator.h"
#include <algorithm>

namespace ramure {

/// \return whether there is a tree to look in
bool LimbFinder::take(const Document& document, NodeId node)
{
    const NodeResult* result = document.result(node);
    if (!result || result->error || !result->tree.skeleton || !result->tree.simplified)
        return false;
    const TreeResult& tree = result->tree;
    if (tree.skeleton == m_drawn && tree.simplified == m_simplified)
        return true;
    m_drawn = tree.skeleton;
    m_simplified = tree.simplified;
    m_axes = axesOf(*m_drawn);
    const Skeleton& seen = m_simplified->skeleton;
    m_start.resize(seen.size());
    for (Index b = 0; b < seen.size(); ++b)
        m_start[b] = m_axes.start[seen.source[b]];
    m_end = m_start;
    for (Index piece = 0; piece < m_drawn->size(); ++piece) {
        double& end = m_end[m_simplified->mergedInto[piece]];
        end = std::max(end, m_axes.start[piece] + m_drawn->length(piece));
    }
    return true;
}

const TreeAxes* LimbFinder::axes(const Document& document, NodeId node)
{
    return take(document, node) ? &m_axes : nullptr;
}

/// \param share of the branch
std::optional<LimbHit> LimbFinder::place(const Document& document, NodeId node, Index branch, double share)
{
    const Node* tree = document.scene().find(node);
    if (!tree || tree->kind != NodeKind::Tree || document.scene().isLocked(node) || !take(document, node) ||
        branch >= m_simplified->skeleton.size())
        return std::nullopt;
    const Skeleton& seen = m_simplified->skeleton;
    LimbHit hit;
    hit.node = node;
    hit.branch = branch;
    hit.axis = m_axes.axisOf[seen.source[branch]];
    const Axis& axis = m_axes.axes[hit.axis];
    hit.address = axis.address;
    const double metres = glm::mix(m_start[branch], m_end[branch], share);
    hit.share = axis.length > 0.0 ? std::clamp(metres / axis.length, 0.0, 1.0) : 0.0;
    hit.seen = glm::mix(seen.p0[branch], seen.p1[branch], share);
    const double length = seen.length(branch);
    hit.along = length > 0.0 ? (seen.p1[branch] - seen.p0[branch]) / length : glm::dvec3(0.0, 1.0, 0.0);
    hit.radius = glm::mix(seen.a0[branch], seen.a1[branch], share);
    return hit;
}

std::optional<LimbHit> LimbFinder::at(const Document& document, const PickHit& hit)
{
    if (hit.branch == noIndex || !take(document, hit.node) || hit.branch >= m_simplified->skeleton.size())
        return std::nullopt;
    const glm::dmat4 world = EvaluatedScene(document.scene()).transforms(hit.node).geometry;
    const glm::dvec3 point(glm::inverse(world) * glm::dvec4(hit.point, 1.0));
    const Skeleton& seen = m_simplified->skeleton;
    const glm::dvec3 way = seen.p1[hit.branch] - seen.p0[hit.branch];
    const double squared = glm::dot(way, way);
    const double share = squared > 0.0 ? glm::dot(point - seen.p0[hit.branch], way) / squared : 0.0;
    auto found = place(document, hit.node, hit.branch, std::clamp(share, 0.0, 1.0));
    if (found)
        found->aside = point - found->seen;
    return found;
}

std::optional<LimbHit> LimbFinder::startOf(const Document& document, NodeId node, Index branch)
{
    return place(document, node, branch, 0.0);
}

std::optional<LimbHit> LimbFinder::onBranch(const Document& document, NodeId node, Index branch, double share)
{
    return place(document, node, branch, share);
}

LimbHit LimbFinder::onLimb(const Document& document, const LimbHit& hit, int order)
{
    if (order <= 0 || !take(document, hit.node) || hit.axis >= m_axes.axes.size())
        return hit;
    Index axis = hit.axis;
    double springs = 0.0; // m from the foot of the axis
    while (m_axes.axes[axis].order > Index(order)) {
        springs = m_axes.axes[axis].s;
        axis = m_axes.axes[axis].parent;
    }
    const Skeleton& seen = m_simplified->skeleton;
    for (Index b = 0; b < seen.size() && axis != hit.axis; ++b) {
        const double metres = m_end[b] - m_start[b];
        if (m_axes.axisOf[seen.source[b]] == axis && m_end[b] >= springs && metres > 0.0)
            return place(document, hit.node, b, std::clamp((springs - m_start[b]) / metres, 0.0, 1.0))
                .value_or(hit);
    }
    return hit;
}

std::vector<LimbHit> LimbFinder::selected(const Document& document)
{
    std::vector<LimbHit> hits;
    const Selection& selection = document.selection();
    for (const Index branch : selection.branches)
        if (const auto hit = startOf(document, selection.branchNode, branch))
            hits.push_back(*hit);
    std::ranges::stable_sort(hits, {}, [](const LimbHit& hit) { return std::pair(hit.axis, hit.share); });
    return hits;
}

std::vector<LimbHit> LimbFinder::meantBy(const Document& document, const LimbHit& hit)
{
    const Selection& selection = document.selection();
    const bool among = selection.branchNode == hit.node && selection.branches.size() > 1 &&
                       std::ranges::binary_search(selection.branches, hit.branch);
    return among ? selected(document) : std::vector{hit};
}

std::vector<Index> LimbFinder::above(const Document& document, const LimbHit& hit, bool whole)
{
    if (!take(document, hit.node) || hit.axis >= m_axes.axes.size())
        return {};
    const Skeleton& seen = m_simplified->skeleton;
    const double from = whole ? 0.0 : hit.share * m_axes.axes[hit.axis].length;
    std::vector<bool> goes(seen.size(), false);
    std::vector<Index> branches;
    for (Index b = 0; b < seen.size(); ++b) {
        const bool isAbove = m_axes.axisOf[seen.source[b]] == hit.axis && m_end[b] > from;
        goes[b] = isAbove || (seen.parent[b] != noIndex && goes[seen.parent[b]]);
        if (goes[b])
            branches.push_back(b);
    }
    return branches;
}

std::vector<LimbSpan> LimbFinder::spans(const Document& document, NodeId node)
{
    std::vector<LimbSpan> spans;
    if (!take(document, node))
        return spans;
    const Skeleton& seen = m_simplified->skeleton;
    spans.reserve(seen.size());
    for (Index b = 0; b < seen.size(); ++b)
        spans.push_back({m_axes.axes[m_axes.axisOf[seen.source[b]]].address, m_start[b], m_end[b]});
    return spans;
}

std::vector<Index> LimbFinder::limb(const Document& document, NodeId node, std::uint64_t address)
{
    std::vector<Index> branches;
    if (!take(document, node))
        return branches;
    const Skeleton& seen = m_simplified->skeleton;
    for (Index b = 0; b < seen.size(); ++b)
        if (m_axes.axes[m_axes.axisOf[seen.source[b]]].address == address)
            branches.push_back(b);
    return branches;
}

} // namespace ramure
