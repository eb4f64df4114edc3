#include "core/lod/level_leaves.h"

#include "core/lod/leaf_sprays.h"
#include "core/math/box.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace ramure {
namespace {

/// How much sooner a leaf goes whose twig has gone.
constexpr double looseness = 2.0;
/// Of its length: no blade becomes broader.
constexpr double broadest = 0.6;

/// The bits of three numbers of 21 bits, one after the other.
std::uint64_t mortonOf(const glm::dvec3& place)
{
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        auto x = static_cast<std::uint64_t>(place[axis] * 2097151.0);
        x = (x | x << 32) & 0x1F00000000FFFFull;
        x = (x | x << 16) & 0x1F0000FF0000FFull;
        x = (x | x << 8) & 0x100F00F00F00F00Full;
        x = (x | x << 4) & 0x10C30C30C30C30C3ull;
        x = (x | x << 2) & 0x1249249249249249ull;
        code |= x << axis;
    }
    return code;
}

std::vector<Index> alongCurve(std::span<const FoliageItem> items)
{
    Box box;
    for (const FoliageItem& item : items)
        box.add(item.position);
    const glm::dvec3 size = glm::max(box.size(), glm::dvec3(1e-12));
    std::vector<std::pair<std::uint64_t, Index>> places;
    for (const FoliageItem& item : items)
        places.emplace_back(mortonOf((item.position - box.min) / size), static_cast<Index>(places.size()));
    std::ranges::sort(places);
    std::vector<Index> order;
    for (const auto& place : places)
        order.push_back(place.second);
    return order;
}

std::uint32_t reversed(std::uint32_t number, std::uint32_t bits)
{
    std::uint32_t out = 0;
    for (std::uint32_t i = 0; i < bits; ++i, number >>= 1)
        out = out << 1 | (number & 1);
    return out;
}

glm::dvec3 middleOf(const TriangleMesh& shape)
{
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const glm::uvec3& t : shape.triangles) {
        const glm::dvec3 a(shape.positions[t.x]), b(shape.positions[t.y]), c(shape.positions[t.z]);
        const double twice = glm::length(glm::cross(b - a, c - a));
        sum += twice * (a + b + c) / 3.0;
        area += twice;
    }
    return area > 0.0 ? sum / area : sum;
}

glm::dmat3 spreadOf(const TriangleMesh& shape, const glm::dvec3& middle)
{
    glm::dmat3 sum(0.0);
    double area = 0.0;
    for (const glm::uvec3& t : shape.triangles) {
        const glm::dvec3 a = glm::dvec3(shape.positions[t.x]) - middle,
                         b = glm::dvec3(shape.positions[t.y]) - middle,
                         c = glm::dvec3(shape.positions[t.z]) - middle;
        const double twice = glm::length(glm::cross(b - a, c - a));
        for (const glm::dvec3& way : {a, b, c, a + b + c})
            sum += twice / 12.0 * glm::outerProduct(way, way);
        area += twice;
    }
    return area > 0.0 ? sum / area : sum;
}

LeafShapeOfLevel shapeOf(const LeafForm& form, FoliageModel model, double alpha)
{
    LeafShapeOfLevel shape{form, model, oneLeaf(form, alpha, model)};
    shape.area = areaOf(shape.mesh);
    shape.middle = middleOf(shape.mesh);
    shape.spread = spreadOf(shape.mesh, shape.middle);
    return shape;
}

} // namespace

double areaOf(const TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[t.y]) - a,
                                            glm::dvec3(mesh.positions[t.z]) - a));
    }
    return sum;
}

FoliageModel simplestLeaf(const PictureParams& pictures)
{
    return pictures.opacity.empty() ? FoliageModel::Rhomb : FoliageModel::Rough;
}

std::vector<LeafShapeOfLevel> leafShapesOfLevels(const LeafForm& form, const PictureParams& pictures,
                                                 double alpha, bool cards)
{
    std::vector<LeafShapeOfLevel> out;
    const auto add = [&](const LeafForm& simpler, FoliageModel model) {
        LeafShapeOfLevel shape = shapeOf(simpler, model, alpha);
        const bool isSimpler = out.empty() || shape.mesh.faceCount() < out.back().mesh.faceCount();
        if (isSimpler && shape.area > 0.0)
            out.push_back(std::move(shape));
    };
    add(form, FoliageModel::Fine);
    if (form.shape == LeafShape::Faithful)
        return out;
    LeafForm simpler = form;
    while (--simpler.detail >= 1)
        add(simpler, FoliageModel::Fine);
    simpler = form;
    if (cards && pictures.isEmpty()) {
        out.push_back(out.front());
        out.back().mesh = {};
        out.back().mesh.triangles.assign(facesOfSpray, glm::uvec3(0)); // those of its cards are made later
        out.back().isSpray = true;
        return out;
    }
    for (add(simpler, simplestLeaf(pictures)); simpler.perShoot > 1; add(simpler, simplestLeaf(pictures)))
        simpler.perShoot = (simpler.perShoot + 1) / 2;
    return out;
}

LeafShapeOfLevel broadened(const LeafShapeOfLevel& shape, double growth, double alpha)
{
    if (shape.form.shape == LeafShape::Faithful || shape.isSpray)
        return shape;
    const double most = broadest / leafRow(shape.form.shape).width;
    LeafForm form = shape.form;
    form.width = std::max(form.width, std::min(form.width * growth, most));
    return form.width > shape.form.width ? shapeOf(form, shape.model, alpha) : shape;
}

std::vector<double> itemChances(std::span<const FoliageItem> items)
{
    // Along a curve that fills the crown neighbours follow each other; every prefix of the numbers 0, 1/2,
    // 1/4, 3/4 ... is spread evenly over it.
    const std::vector<Index> order = alongCurve(items);
    std::vector<double> chances(items.size());
    std::uint32_t bits = 1;
    while ((std::size_t(1) << bits) < items.size())
        ++bits;
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        chances[order[rank]] = static_cast<double>(reversed(static_cast<std::uint32_t>(rank), bits)) /
                               static_cast<double>(std::uint64_t(1) << bits);
    return chances;
}

std::vector<Index> chosenItems(std::span<const FoliageItem> items, std::span<const double> chances,
                               std::span<const Index> candidates, std::span<const Index> branchOf,
                               std::size_t count)
{
    std::vector<Index> chosen(candidates.begin(), candidates.end());
    if (count >= chosen.size())
        return chosen;
    const auto turn = [&](Index i) {
        return std::pair(chances[i] * (branchOf[items[i].branch] == noIndex ? looseness : 1.0), i);
    };
    const auto cut = chosen.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::nth_element(chosen, cut, {}, turn);
    chosen.erase(cut, chosen.end());
    std::ranges::sort(chosen);
    return chosen;
}

double enlarge(std::vector<FoliageItem>& items, double area, double each)
{
    double squares = 0.0;
    for (const FoliageItem& item : items)
        squares += double(item.size) * double(item.size);
    if (!(squares * each > 0.0))
        return 1.0;
    const double scale = std::sqrt(area / (squares * each));
    for (FoliageItem& item : items)
        item.size = static_cast<float>(scale * double(item.size));
    return scale;
}

} // namespace ramure
