#include "core/surface/mesher/mesh_divisions.h"

#include "core/surface/mesher/stem_limbs.h"
#include "core/surface/mesher/trunk_foot.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {

namespace {

/// A little of thickness times length, as if every branch were bent that much: thick branches get
/// cross-sections even where they are straight, for shading and motion.
constexpr double bendShare = 0.1;
constexpr double seenCollar = 0.01; ///< m, radius of a limb: one as thick shows its collar
constexpr int collarSections = 4;   ///< its ends, and two on what narrows
constexpr int bisections = 60;
/// Of a tube as far as it is not clear of its nearest sibling: how much of it that one hides.
constexpr double hiddenShare = 0.6;

/// The i-th of numbers in [0, 1) that spread evenly, however many there are.
double spread(Index i, double step)
{
    const double at = step * (static_cast<double>(i) + 1.0);
    return at - std::floor(at);
}

/// Wall vertices of a fork with so many children, about. \param sides of them, on the average; \param arches
/// limbs that leave a stem to its side, if all but one do.
double wallVertices(double children, double sides, double arches)
{
    const double mids = std::clamp((sides + 1.0) / 4.0, 1.0, 12.0);
    if (arches > 0.0)
        return arches * std::max(3.0, 2.0 * mids - 1.5); // less what the stem loses beneath them
    if (children <= 2.0)
        return 2.0 * mids + 1.0;
    const double hull = std::min(children, 4.0);
    return 2.0 * children - 2.0 - hull + hull * mids + 3.0 * children - 3.0 - 2.0 * hull;
}

/// The curve's parameter at which two siblings come apart, whose ends are so far apart: starting in one
/// direction, they are (2 t^2 - t^3) times that apart.
double partingAt(double radii, double apart)
{
    if (radii >= apart)
        return 1.0;
    double t = 0.7;
    for (int i = 0; i < 3; ++i)
        t = std::sqrt(radii / apart / (2.0 - t));
    return t;
}

double limited(double value, int least, int most)
{
    return std::clamp(value, static_cast<double>(least), static_cast<double>(most));
}

} // namespace

double sidesAskedFor(double radius, double fineness)
{
    // The middle of a chord lies r (1 - cos(pi / n)) inside the circle.
    return fineness * std::numbers::pi * std::sqrt(0.5 * radius);
}

MeshDivisions::MeshDivisions(int sections, int sides)
    : m_sections(sections)
{
    m_rings.push_back(regularRing(sides));
}

MeshDivisions::MeshDivisions(std::span<const BranchShape> shapes, double fineness, double leastGap)
    : m_fineness(fineness)
    , m_leastGap(leastGap)
    , m_shapes(shapes)
{
    for (int sides = leastSides; sides <= mostSides; ++sides)
        m_rings.push_back(regularRing(sides));
}

std::span<const RingPoint> MeshDivisions::ringByShape(Index branch, double radius) const
{
    double asked = sidesAskedFor(radius, m_fineness) + m_shapes[branch].sidesThreshold;
    if (m_leastGap > 0.0)
        asked = std::min(asked, sidesOfRadius * radius / m_leastGap);
    return m_rings[static_cast<std::size_t>(limited(asked, leastSides, mostSides) - leastSides)];
}

int MeshDivisions::sections(Index branch) const
{
    if (m_shapes.empty())
        return m_sections;
    const BranchShape& shape = m_shapes[branch];
    return static_cast<int>(
        limited(1.0 + m_fineness * shape.spans + shape.spansThreshold, shape.fewestSections, mostSections));
}

MeshBudget::MeshBudget(const NormalSkeleton& skeleton, const MeshParams& params)
    : m_skeleton(skeleton)
    , m_params(params)
    , m_shapes(skeleton.branches.size())
{
    const auto count = static_cast<Index>(m_shapes.size());
    for (Index b = 0; b < count; ++b)
        measure(b);
    for (Index b = 0; b < count; ++b)
        if (skeleton.branches[b].childCount > 1)
            measureFork(b);
    double thinnest = skeleton.scene, fewest = 1e30;
    for (Index b = 0; b < count; ++b) {
        thinnest = std::min({thinnest, skeleton.branches[b].a0, skeleton.branches[b].a1});
        fewest = std::min(fewest, m_shapes[b].spans);
    }
    m_finest = std::max(mostSides / sidesAskedFor(thinnest, 1.0), mostSections / fewest);
}

/// The sagitta of a chord over a share h of the curve is h^2 / 8 of its second derivative; for the Hermite
/// curve that is 4 (v1 - v0) at the start and 2 (v0 - v1) at the end.
void MeshBudget::measure(Index b)
{
    const MeshBranch& branch = m_skeleton.branches[b];
    BranchShape& shape = m_shapes[b];
    const glm::dvec3 way = branch.p1 - branch.p0;
    const double length = glm::length(way), radius = 0.5 * (branch.a0 + branch.a1);
    double aside = 0.0;
    bool goesOn = false;
    if (branch.parent != noIndex && !branch.isLimb) {
        const MeshBranch& parent = m_skeleton.branches[branch.parent];
        const glm::dvec3 before = parent.p1 - parent.p0;
        const double ahead = glm::dot(before, way);
        aside = ahead > 0.0 ? glm::length(glm::cross(before, way)) / length : glm::length(before);
        goesOn = parent.childCount == 1;
    }
    shape.spans = std::sqrt(0.375 * aside + bendShare * radius * length);
    shape.spansThreshold = spread(b, std::numbers::sqrt2);
    if (branch.spreadStart > 0.0 && branch.a0 >= seenCollar)
        shape.fewestSections = collarSections;
    // A branch that only goes on from its parent is rounded as that one, or the sides would change to and
    // fro.
    shape.sidesThreshold = goesOn ? m_shapes[branch.parent].sidesThreshold : spread(b, std::numbers::phi);
}

/// Of very many siblings, only some are looked at: this is an estimate.
void MeshBudget::measureFork(Index parent)
{
    constexpr std::size_t mostLookedAt = 32;
    const std::span<const Index> children = m_skeleton.childrenOf(parent);
    const std::size_t step = 1 + children.size() / mostLookedAt;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const MeshBranch& child = m_skeleton.branches[children[i]];
        double latest = 0.0;
        for (std::size_t j = 0; j < children.size(); j += step) {
            const MeshBranch& other = m_skeleton.branches[children[j]];
            if (j != i &&
                (other.a0 > child.a0 || !areStemAndLimb(child.a0, other.a0))) // a limb hides nothing
                latest = std::max(latest, partingAt(child.a0 + other.a0, glm::length(child.p1 - other.p1)));
        }
        m_shapes[children[i]].hidden = hiddenShare * latest;
    }
    const auto radius = [&](Index child) { return m_skeleton.branches[child].a0; };
    const Index stem = *std::ranges::max_element(children, {}, radius);
    double share = 0.0;
    bool isStar = true;
    for (const Index child : children) {
        share += std::sqrt(radius(child) / m_skeleton.branches[parent].a1);
        isStar = isStar && (child == stem || areStemAndLimb(radius(child), radius(stem)));
    }
    const auto count = static_cast<double>(children.size());
    m_shapes[parent].wallSides = share / count;
    m_shapes[parent].arches = isStar ? count - 1.0 : 0.0;
}

double MeshBudget::triangles(double fineness) const
{
    double vertices = 0.0;
    for (std::size_t b = 0; b < m_shapes.size(); ++b) {
        const MeshBranch& branch = m_skeleton.branches[b];
        const double sides =
            limited(sidesAskedFor(0.5 * (branch.a0 + branch.a1), fineness), leastSides, mostSides);
        const double spans =
            limited(fineness * m_shapes[b].spans, m_shapes[b].fewestSections - 1, mostSections - 1);
        vertices +=
            sides * std::max(spans * (1.0 - m_shapes[b].hidden), 1.0) + (branch.childCount == 0 ? 1.0 : 0.0);
        if (branch.childCount > 1)
            vertices += wallVertices(branch.childCount, sides * m_shapes[b].wallSides, m_shapes[b].arches);
        if (branch.parent == noIndex) { // its first ring and pole, less the 2 of Euler's formula
            const double around = sidesAskedFor(branch.a0, fineness) + m_shapes[b].sidesThreshold;
            const FootSize foot =
                footSize(m_params, static_cast<Index>(limited(around, leastSides, mostSides)));
            vertices += foot.rings > 0 ? double(foot.rings) * foot.points - 1.0 : sides - 1.0;
        }
    }
    return 2.0 * vertices;
}

double MeshBudget::finenessFor(double wanted) const
{
    if (triangles(0.0) >= wanted)
        return 0.0;
    if (triangles(m_finest) <= wanted)
        return m_finest;
    double low = m_finest * 1e-12, high = m_finest;
    for (int i = 0; i < bisections && high > low * 1.0001; ++i) {
        const double middle = std::sqrt(low * high);
        (triangles(middle) < wanted ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

} // namespace ramure
