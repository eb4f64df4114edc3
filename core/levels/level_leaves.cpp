#include "core/levels/level_leaves.h"

#include "core/math/random.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// How much sooner a leaf goes whose twig has gone.
constexpr double looseness = 2.0;

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

std::vector<LeafShapeOfLevel> leafShapesOfLevels(const LeafForm& form, double alpha)
{
    std::vector<LeafShapeOfLevel> out;
    const auto add = [&](const LeafForm& simpler, FoliageModel model) {
        LeafShapeOfLevel shape{simpler, model, oneLeaf(simpler, alpha, model)};
        shape.area = areaOf(shape.mesh);
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
    add(form, FoliageModel::Rough);
    return out;
}

std::vector<double> itemChances(std::span<const FoliageItem> items, const Skeleton& skeleton)
{
    constexpr std::uint64_t step = 0x9E3779B97F4A7C15ull;
    std::vector<double> chances(items.size());
    std::uint64_t rank = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        rank = i > 0 && items[i].branch == items[i - 1].branch ? rank + 1 : 0;
        const std::uint64_t hash = mixBits(mixBits(skeleton.key[items[i].branch]) + step * (rank + 1));
        chances[i] = static_cast<double>(hash >> 11) * 0x1.0p-53;
    }
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
