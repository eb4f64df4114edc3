#include "widgets/view/tools/limb_finder.h"

#include "core/evaluate/evaluator.h"
#include "core/math/hermite.h"
#include "core/skeleton/edit_places.h"
#include "core/skeleton/sections.h"
#include "widgets/view/tools/motion_tools.h"
#include <algorithm>
#include <cmath>

namespace ramure {

const TreeResult* LimbFinder::tree(const Document& document, NodeId node) const
{
    const NodeResult* result = document.result(node);
    const TreeResult* tree = m_shown ? m_shown(node) : result ? &result->tree : nullptr;
    return tree && tree->skeleton && tree->simplified && !(result && result->error) ? tree : nullptr;
}

/// \return whether there is a tree to look in
bool LimbFinder::take(const Document& document, NodeId node)
{
    const TreeResult* found = tree(document, node);
    if (!found)
        return false;
    const TreeResult& tree = *found;
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
    hit.drawn = m_drawn;
    hit.simplified = m_simplified;
    return hit;
}

namespace {

/// The place on the centre line of a branch, which bows where its mesh does, that is nearest to a point.
glm::dvec3 nearestOnCentre(const Skeleton& skeleton, Index branch, const glm::dvec3& point)
{
    constexpr int steps = 32;
    const BranchCurve curve = branchCurve(skeleton, branch);
    glm::dvec3 from = curve.h0, nearest = curve.h0;
    for (int k = 1; k <= steps; ++k) {
        const glm::dvec3 to = hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(k) / steps).point;
        const glm::dvec3 way = to - from;
        const double squared = glm::dot(way, way);
        const double t = squared > 0.0 ? std::clamp(glm::dot(point - from, way) / squared, 0.0, 1.0) : 0.0;
        if (glm::distance(from + t * way, point) < glm::distance(nearest, point))
            nearest = from + t * way;
        from = to;
    }
    return nearest;
}

} // namespace

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
    if (found) {
        found->aside = point - found->seen;
        found->side = point - nearestOnCentre(seen, hit.branch, point);
    }
    return found;
}

std::optional<LimbHit> LimbFinder::under(const Document& document, const PickView& view,
                                         const glm::dvec2& pixel)
{
    constexpr double tolerance = 6.0; // logical pixels
    const EvaluatedScene now(document.scene());
    std::vector<StandingTree> trees;
    for (const Node& node : document.scene().nodes())
        if (const TreeResult* tree = node.kind == NodeKind::Tree && document.scene().isShown(node.id)
                                         ? this->tree(document, node.id)
                                         : nullptr)
            trees.push_back({node.id, now.transforms(node.id).geometry, &tree->simplified->skeleton});
    const auto near = branchUnder(view, pixel, trees, tolerance);
    auto found = near ? place(document, near->node, near->branch, near->along) : std::nullopt;
    if (!found)
        return found;
    found->aside = sideTowards(document, *found, view, pixel);
    found->side = found->aside;
    return found;
}

glm::dvec3 LimbFinder::sideTowards(const Document& document, const LimbHit& hit, const PickView& view,
                                   const glm::dvec2& pixel) const
{
    const glm::dmat4 inverse = glm::inverse(EvaluatedScene(document.scene()).transforms(hit.node).geometry);
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dvec3 eye(inverse * glm::dvec4(ray.origin, 1.0));
    const glm::dvec3 way = glm::normalize(glm::dmat3(inverse) * ray.direction);
    const glm::dvec3 across = eye + glm::dot(hit.seen - eye, way) * way - hit.seen;
    const double before = hit.radius * hit.radius - glm::dot(across, across);
    return before > 0.0 ? across - std::sqrt(before) * way : hit.radius * glm::normalize(across);
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
    const auto isOfOneAxis = [](const LimbHit& a, const LimbHit& b) { return a.axis == b.axis; };
    hits.erase(std::unique(hits.begin(), hits.end(), isOfOneAxis), hits.end());
    return hits;
}

std::vector<LimbHit> LimbFinder::meantBy(const Document& document, const LimbHit& hit)
{
    const Selection& selection = document.selection();
    const bool among =
        selection.branchNode == hit.node && std::ranges::binary_search(selection.branches, hit.branch);
    std::vector<LimbHit> limbs = among ? selected(document) : std::vector<LimbHit>();
    return limbs.size() > 1 ? limbs : std::vector{hit};
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

std::vector<Index> LimbFinder::axesAt(const Document& document, NodeId node,
                                      std::vector<std::uint64_t> addresses)
{
    std::vector<Index> branches;
    if (addresses.empty() || !take(document, node))
        return branches;
    std::ranges::sort(addresses);
    const Skeleton& seen = m_simplified->skeleton;
    for (Index b = 0; b < seen.size(); ++b)
        if (std::ranges::binary_search(addresses, m_axes.axes[m_axes.axisOf[seen.source[b]]].address))
            branches.push_back(b);
    return branches;
}

std::vector<Index> LimbFinder::limbOf(const Document& document, NodeId node, Index branch)
{
    if (!take(document, node) || branch >= m_simplified->skeleton.size())
        return {branch};
    return limb(document, node, m_axes.axes[m_axes.axisOf[m_simplified->skeleton.source[branch]]].address);
}

std::vector<Index> LimbFinder::inDocument(const Document& document, NodeId node,
                                          std::vector<Index> branches) const
{
    const NodeResult* result = document.result(node);
    const TreeResult* shown = tree(document, node);
    if (!shown || !result || !result->tree.skeleton || !result->tree.simplified ||
        shown->simplified == result->tree.simplified)
        return branches;
    std::erase_if(branches, [count = shown->simplified->skeleton.size()](Index b) { return b >= count; });
    branches = followBranches(*shown->skeleton, *shown->simplified, branches, *result->tree.skeleton,
                              *result->tree.simplified);
    std::ranges::sort(branches);
    branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
    std::erase(branches, noIndex);
    return branches;
}

} // namespace ramure
