#include "core/surface/season/leaf_palette.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

namespace ramure {
namespace {

/// Of leaves that are dark red: what hides the green, and how much of the green there is.
constexpr float purpleAnthocyanin = 29.0F, purpleGreen = 0.78F;

Pigments young(const PlantYear& plant)
{
    return {0.38F * plant.summer.chlorophyll, 0.45F * plant.summer.carotenoids, plant.redYoung, 0.0F};
}

/// Brown pigments come as the others go.
Pigments withered(const PlantYear& plant)
{
    const Pigments& turned = plant.autumn;
    return {0.6F * turned.chlorophyll, 0.4F * turned.carotenoids, 0.6F * turned.anthocyanin,
            turned.brown + plant.withers};
}

Pigments pigmentsAt(const PlantYear& plant, bool purple, float age, float light)
{
    const std::array stages{young(plant), young(plant), plant.summer, plant.autumn, withered(plant)};
    const int before = std::clamp(int(age), 0, 3);
    Pigments out = mix(stages[std::size_t(before)], stages[std::size_t(before) + 1], age - float(before));
    if (age > leafGrown)
        out.anthocyanin *= 1.0F + plant.byLight * (2.0F * light - 1.0F);
    if (purple) {
        out.chlorophyll *= purpleGreen;
        out.anthocyanin += purpleAnthocyanin * std::clamp(leafWithered - age, 0.0F, 1.0F);
    }
    return out;
}

} // namespace

LeafPalette::LeafPalette(const PlantYear& usual, bool purple, double redness)
{
    PlantYear plant = usual;
    plant.autumn.anthocyanin *= float(redness);
    for (int age = 0; age < ages; ++age)
        for (int light = 0; light < lights; ++light)
            m_colours[std::size_t(age)][std::size_t(light)] = photographed(
                pigmentColours(pigmentsAt(plant, purple, float(age) / steps, float(light) / (lights - 1))));
}

std::shared_ptr<const LeafPalette> paletteOf(LeafShape shape, const SeasonParams& season)
{
    constexpr std::size_t most = 2 * std::size_t(leafShapeCount); // somebody may drag the redness
    static std::mutex mutex;
    static std::map<std::tuple<LeafShape, bool, double>, std::shared_ptr<const LeafPalette>> kept;
    const std::lock_guard lock(mutex);
    const std::tuple key(shape, season.purple, season.redness);
    if (const auto found = kept.find(key); found != kept.end())
        return found->second;
    if (kept.size() >= most)
        kept.clear();
    return kept[key] = std::make_shared<const LeafPalette>(plantYear(shape), season.purple, season.redness);
}

LeafColours LeafPalette::at(float age, float light) const
{
    const float row = std::clamp(age * steps, 0.0F, float(ages - 1));
    const float column = std::clamp(light, 0.0F, 1.0F) * (lights - 1);
    const int i = std::min(int(row), ages - 2), k = std::min(int(column), lights - 2);
    const float down = row - float(i), along = column - float(k);
    LeafColours out;
    const auto add = [&](int step, int brightness, float share) {
        if (share <= 0.0F)
            return;
        const LeafColours& each = m_colours[std::size_t(step)][std::size_t(brightness)];
        out.reflected += share * each.reflected;
        out.transmitted += share * each.transmitted;
    };
    add(i, k, (1.0F - down) * (1.0F - along));
    add(i, k + 1, (1.0F - down) * along);
    add(i + 1, k, down * (1.0F - along));
    add(i + 1, k + 1, down * along);
    return out;
}

} // namespace ramure
