#include "core/surface/foliage/leaf_light.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace ramure {
namespace {

/// Of a solid ellipsoid: its half axis over the spread of its points along it.
const double axisOverSpread = std::sqrt(5.0);

double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace

std::vector<float> leafLight(const std::vector<FoliageItem>& leaves)
{
    std::vector<float> light(leaves.size());
    if (leaves.empty())
        return light;
    const double count = double(leaves.size());
    glm::dvec3 middle(0.0), square(0.0);
    for (const FoliageItem& leaf : leaves)
        middle += leaf.position / count;
    for (const FoliageItem& leaf : leaves) {
        const glm::dvec3 away = leaf.position - middle;
        square += away * away / count;
    }
    const glm::dvec3 axes = glm::max(axisOverSpread * glm::sqrt(square), glm::dvec3(1e-9));
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const glm::dvec3 place = (leaves[i].position - middle) / axes;
        const double out = glm::length(place), up = out > 0.0 ? place.y / out : 0.0;
        light[i] = static_cast<float>(smoothStep(0.4, 1.05, out) * (0.7 + 0.3 * up));
    }
    return light;
}

void growByLight(double ratio, Foliage& foliage)
{
    if (!(ratio > 0.0) || ratio == 1.0 || foliage.leaves.empty())
        return;
    constexpr double usual = 1.6; // at which shade leaves are as dark as they get
    constexpr glm::vec3 shadeTint(0.90F, 0.95F, 0.93F);
    const std::vector<float> light = leafLight(foliage.leaves);
    const double mean = std::accumulate(light.begin(), light.end(), 0.0) / double(light.size());
    const float darkens = static_cast<float>(std::clamp((ratio - 1.0) / (usual - 1.0), 0.0, 1.0));
    for (std::size_t i = 0; i < light.size(); ++i) {
        FoliageItem& leaf = foliage.leaves[i];
        leaf.size *= static_cast<float>(maths::pow(ratio, 0.5 * (mean - double(light[i]))));
        leaf.tint *= glm::mix(glm::vec3(1.0F), shadeTint, darkens * (1.0F - light[i]));
    }
}

} // namespace ramure
