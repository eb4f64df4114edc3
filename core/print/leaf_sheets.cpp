#include "core/print/leaf_sheets.h"
#include "core/surface/foliage/place_foliage.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <optional>

namespace ramure {
namespace {

glm::dvec3 nearestOn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
{
    const glm::dvec3 way = b - a;
    const double length2 = glm::dot(way, way);
    return length2 > 0.0 ? a + std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) * way : a;
}

/// Of the shape, from its foot or, where it is about its middle, across.
double lengthOf(const TriangleMesh& shape)
{
    glm::vec3 low(0.0F), high(0.0F);
    for (const glm::vec3& p : shape.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return high.y - low.y;
}

/// Where a leaf's stalk ends: on the axis of the nearest branch on the way down that is printed.
std::optional<glm::dvec3> anchorOf(const Skeleton& tree, const PrintSkeleton& print, Index branch,
                                   const glm::dvec3& foot, double reach)
{
    while (branch != noIndex && print.numberOf[branch] == noIndex)
        branch = tree.parent[branch];
    if (branch == noIndex)
        return std::nullopt;
    const Index number = print.numberOf[branch];
    const Skeleton& kept = print.skeleton;
    const glm::dvec3 anchor = nearestOn(kept.p0[number], kept.p1[number], foot);
    const double radius = std::max(kept.a0[number], kept.a1[number]);
    if (glm::distance(anchor, foot) > reach + radius)
        return std::nullopt;
    return anchor;
}

/// About: both sides and the rim.
double shellArea(const TriangleMesh& shape, double scale, double thickness)
{
    constexpr double rim = 2.2; // lengths of the leaf
    double area = 0.0;
    for (const glm::uvec3& t : shape.triangles) {
        const glm::dvec3 a(shape.positions[t.x]), b(shape.positions[t.y]), c(shape.positions[t.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return 2.0 * scale * scale * area + 0.5 * std::numbers::pi * thickness * rim * scale * lengthOf(shape);
}

void addStalk(TriangleMesh& mesh, const glm::dvec3& from, const glm::dvec3& to)
{
    const Index first = mesh.vertexCount();
    mesh.positions.emplace_back(from);
    mesh.positions.emplace_back(0.5 * (from + to));
    mesh.positions.emplace_back(to);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

void addLeaf(TriangleMesh& mesh, const TriangleMesh& shape, const FoliageItem& item, const glm::dvec3& foot,
             double scale)
{
    const Index first = mesh.vertexCount();
    const glm::dmat3 turn(glm::mat3_cast(item.orientation));
    for (const glm::vec3& p : shape.positions)
        mesh.positions.emplace_back(foot + turn * (scale * double(item.size) * glm::dvec3(p)));
    for (const glm::uvec3& t : shape.triangles)
        mesh.triangles.push_back(t + first);
}

} // namespace

LeafSheets leafSheets(const Foliage& foliage, const Skeleton& tree, const PrintSkeleton& print, double alpha,
                      const LeafLimits& limits)
{
    LeafSheets out;
    LeafForm form = foliage.form;
    form.detail = 1; // a shell rounds off what more would show
    const TriangleMesh shape = oneLeaf(form, alpha, FoliageModel::Fine);
    const double length = print.scale * lengthOf(shape);
    out.leftOut = static_cast<Index>(foliage.leaves.size());
    if (!(length > 0.0))
        return out;
    out.enlargement = std::max(1.0, leastLeafLength * limits.thickness / length);
    struct Place
    {
        const FoliageItem& item;
        glm::dvec3 foot, anchor;
    };
    std::vector<Place> places; // where a leaf could stand
    const double reach = mostStalk * out.enlargement * length;
    for (const FoliageItem& item : foliage.leaves) {
        const glm::dvec3 foot = print.scale * (item.position - print.foot);
        if (const auto anchor = anchorOf(tree, print, item.branch, foot, reach))
            places.push_back({item, foot, *anchor});
    }
    const double scale = print.scale * out.enlargement;
    const double each = shellArea(shape, scale, limits.thickness);
    const double share = std::min(1.0 / (out.enlargement * out.enlargement),
                                  limits.area / (each * double(std::max<std::size_t>(1, places.size()))));
    double due = 0.0;
    for (const Place& place : places) {
        due += share;
        if (due < 1.0 - 1e-9)
            continue;
        due -= 1.0;
        addStalk(out.mesh, place.foot, place.anchor);
        addLeaf(out.mesh, shape, place.item, place.foot, scale);
        ++out.leaves;
    }
    out.leftOut -= out.leaves;
    return out;
}

} // namespace ramure
