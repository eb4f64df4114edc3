#include "core/surface/season/fruit_on_day.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/season/crown_place.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Days: a flower opens, stays, and a fruit grows from its end on; fruit hang ripe and fall one after the
/// other.
constexpr double opening = 4.0, flowering = 11.0, hangsRipe = 8.0, falling = 30.0;
/// m: the radius of an open flower, and of one of the small ones that berries grow from.
constexpr double flowerRadius = 0.019, smallRadius = 0.007;
/// Heads of flowers on a tree, and flowers of a head; of berries more.
constexpr std::size_t mostHeads = 40'000;
constexpr double headsOfLeaf = 3.0;
constexpr int flowersOfHead = 6, smallOfHead = 12;
/// Of the stalk of a single flower.
constexpr double headStalk = 2.0, smallStalk = 4.0;
/// Days after budburst when fruit are set whose flowers nobody looks at.
constexpr double quietFlowers = 25.0;

bool isOfFlowers(FruitKind kind)
{
    switch (kind) {
    case FruitKind::Apple:
    case FruitKind::Pear:
    case FruitKind::Cherry:
    case FruitKind::Plum:
    case FruitKind::Berries:
    case FruitKind::Blossom:
        return true;
    default:
        return false;
    }
}

/// The foot of the stalk stays on the twig.
void resize(FoliageItem& fruit, float share, const FruitForm& form, double alpha)
{
    const glm::dvec3 stalk = fruit.orientation * glm::dvec3(0.0, 1.0, 0.0);
    const double reach = fruitRadius(form, alpha) * fruitReach(form) * double(fruit.size);
    fruit.position += (1.0 - double(share)) * reach * stalk;
    fruit.size *= share;
}

/// Heads of flowers where leaves will stand, at most mostHeads.
void bloom(const Foliage& placed, const Skeleton& skeleton, double since, double alpha, Foliage& out)
{
    const FruitKind kind = placed.fruit.kind;
    if (placed.leaves.empty() || placed.apples.empty() || !(alpha > 0.0))
        return;
    const bool areSmall = kind == FruitKind::Berries;
    out.fruit = {.kind = FruitKind::Blossom,
                 .stalk = areSmall ? smallStalk : headStalk,
                 .diameter = 2.0 * (areSmall ? smallRadius : flowerRadius),
                 .head = areSmall ? smallOfHead : flowersOfHead};
    const double each = std::min(headsOfLeaf, double(mostHeads) / double(placed.leaves.size()));
    const double reach = fruitRadius(out.fruit, alpha) * fruitReach(out.fruit);
    for (const FoliageItem& leaf : placed.leaves) {
        const Lots lots = CrownPlace::lotsOf(skeleton, leaf);
        const double open = since - 6.0 * double(lots[1]);
        if (open <= 0.0 || open > flowering + 6.0 * double(lots[2]) - 6.0)
            continue;
        const int heads = int(each + double(lots[0]));
        for (int i = 0; i < heads; ++i) {
            FoliageItem head = leaf;
            head.tone = 0.9F + 0.1F * lots[2];
            head.tint = glm::vec3(1.0F);
            head.size =
                static_cast<float>(std::min(0.3 + 0.7 * open / opening, 1.0)) * (0.85F + 0.3F * lots[1]);
            const auto [sine, cosine] = maths::sincos(fullTurn * (double(lots[3]) + i / double(heads)));
            const double aside = heads > 1 ? 0.8 : 0.3;
            const glm::dvec3 way =
                glm::normalize(leaf.orientation * glm::dvec3(aside * cosine, 0.6, aside * sine + 0.4));
            // Stalks are drawn out of a flower's back.
            const glm::dvec3 up = std::abs(way.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
            const glm::dvec3 across = glm::normalize(glm::cross(up, -way));
            const glm::dvec3 right = cosine * across + sine * glm::cross(across, -way);
            head.orientation =
                glm::normalize(glm::quat_cast(glm::dmat3(right, -way, glm::cross(right, -way))));
            head.position = leaf.position + double(head.size) * reach * way;
            head.number = leaf.number * std::uint32_t(headsOfLeaf + 1.0) + std::uint32_t(i);
            out.apples.push_back(head);
            out.fruitOf.push_back(noIndex);
        }
    }
}

void grow(const Foliage& placed, const Skeleton& skeleton, const PlantYear& plant, double since, double day,
          double alpha, Foliage& out)
{
    const double needs = std::max(plant.ripe - (day - since), 20.0);
    const auto grown = static_cast<float>(std::clamp(since / needs, 0.0, 1.0));
    // In steps, so that most days share their shape.
    out.fruit.ripe = std::round(16.0 * std::clamp((day - plant.ripe + 25.0) / 25.0, 0.0, 1.0)) / 16.0;
    for (Index i = 0; i < placed.apples.size(); ++i) {
        const FoliageItem& fruit = placed.apples[i];
        const Lots lots = CrownPlace::lotsOf(skeleton, fruit);
        if (day > plant.ripe + hangsRipe + falling * double(lots[0]))
            continue;
        out.apples.push_back(fruit);
        out.fruitOf.push_back(i);
        resize(out.apples.back(), 0.15F + 0.85F * std::sqrt(grown), placed.fruit, alpha);
    }
}

} // namespace

void fruitOnDay(const Foliage& placed, const Skeleton& skeleton, const PlantYear& plant,
                const YearDates& dates, double day, double alpha, Foliage& out)
{
    const FruitKind kind = placed.fruit.kind;
    if (kind == FruitKind::Faithful || kind == FruitKind::Cone) {
        out.apples = placed.apples;
        return;
    }
    const bool blooms = isOfFlowers(kind) && (plant.flowers < 1000.0 || kind == FruitKind::Blossom);
    const double opens = dates.burst + (plant.flowers < 1000.0 ? plant.flowers : 0.0);
    const double set = blooms ? opens + flowering + 2.0 : dates.burst + quietFlowers;
    if (blooms && day > opens && day <= set)
        bloom(placed, skeleton, day - opens, alpha, out);
    else if (day > set && kind != FruitKind::Blossom)
        grow(placed, skeleton, plant, day - set, day, alpha, out);
}

} // namespace ramure
