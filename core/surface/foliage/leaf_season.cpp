#include "core/surface/foliage/leaf_season.h"

#include "core/math/random.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {
namespace {

/// The first leaf turns, and has turned so much later; the first falls.
constexpr double firstTurns = 0.1, turnsFor = 0.3, lastTurns = 0.6, firstFalls = 0.55;
/// The first fruit and flower fall, and the last so much later.
constexpr double fruitFalls = 0.4, blossomFalls = 0.0, fallsFor = 0.4;
constexpr glm::vec3 withered(0x7A, 0x52, 0x2C);

float smooth(double x)
{
    const double u = std::clamp(x, 0.0, 1.0);
    return static_cast<float>(u * u * (3.0 - 2.0 * u));
}

/// How much of the way to its last colour a leaf has gone. \param late 0..1: when it turns.
float turnedShare(double season, double late)
{
    return smooth((season - firstTurns - (lastTurns - firstTurns) * late) / turnsFor);
}

} // namespace

void turnLeaves(const Skeleton& skeleton, double season, Foliage& foliage)
{
    const LeafRow& row = leafRow(foliage.form.shape);
    if (row.evergreen || foliage.leaves.empty())
        return;
    double low = skeleton.p0.front().y, high = low;
    for (const glm::dvec3& end : skeleton.p1) {
        low = std::min(low, end.y);
        high = std::max(high, end.y);
    }
    const glm::vec3 summer(row.colour), autumn(row.autumn), all(leafColour(row.shape, true));
    const auto falls = [&](FoliageItem& leaf) {
        Random random(skeleton.key[leaf.branch], RandomStream::LeafFall, leaf.number);
        const double height = high > low ? (leaf.position.y - low) / (high - low) : 0.0;
        const double late = 0.65 * random.unit() + 0.35 * std::clamp(1.0 - height, 0.0, 1.0);
        const double order = 0.75 * random.unit() + 0.25 * late;
        if (season >= firstFalls + (1.0 - firstFalls) * order)
            return true;
        // Some keep a breath of green, some wither on the twig.
        const float hue = static_cast<float>(random.unit());
        const glm::vec3 turned = glm::mix(glm::mix(autumn, summer, 0.25F * hue * hue), withered,
                                          0.6F * smooth(random.range(0.5, 2.0) * (season - firstFalls)));
        leaf.tint *= glm::min(glm::mix(summer, turned, turnedShare(season, late)) / all, glm::vec3(1.0F));
        return false;
    };
    foliage.shed = std::erase_if(foliage.leaves, falls);
}

void dropFruit(const Skeleton& skeleton, double season, Foliage& foliage)
{
    const FruitKind kind = foliage.fruit.kind;
    if (leafRow(foliage.form.shape).evergreen || kind == FruitKind::Cone || kind == FruitKind::Faithful)
        return;
    const double first = kind == FruitKind::Blossom ? blossomFalls : fruitFalls;
    std::erase_if(foliage.apples, [&](const FoliageItem& fruit) {
        Random random(skeleton.key[fruit.branch], RandomStream::LeafFall, ~fruit.number);
        return season > 0.0 && season >= first + fallsFor * random.unit();
    });
}

glm::vec3 seasonColour(LeafShape shape, double season)
{
    const LeafRow& row = leafRow(shape);
    const glm::vec3 summer(row.colour);
    return row.evergreen ? summer : glm::mix(summer, glm::vec3(row.autumn), turnedShare(season, 0.5));
}

} // namespace ramure
