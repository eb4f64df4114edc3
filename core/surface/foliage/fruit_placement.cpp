#include "core/surface/foliage/fruit_placement.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/twig_line.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

class FruitGrower
{
public:
    FruitGrower(const Placing& placing, const FruitForm& form)
        : m_placing(placing)
        , m_form(form)
        , m_reach(fruitRadius(form, placing.alpha) * fruitReach(form))
    {
    }

    void grow(Index twig, Random& random, std::vector<FoliageItem>& fruit) const
    {
        const TwigLine line(m_placing.skeleton, twig);
        const double first = std::min(firstNode(m_placing.skeleton, twig), line.length());
        const TwigLine::Place place = line.at(first + random.unit() * (line.length() - first));
        for (int i = m_form.cluster; i > 0; --i)
            fruit.push_back(fruitAt(twig, place, random));
    }

private:
    FoliageItem fruitAt(Index twig, const TwigLine::Place& place, Random& random) const
    {
        const double turn = 2.0 * std::numbers::pi * random.unit(), lean = std::sqrt(random.unit());
        const double spin = 2.0 * std::numbers::pi * random.unit(), other = random.range(-1.0, 1.0);
        const auto [sine, cosine] = maths::sincos(turn);
        const bool hung = hangs(m_form.kind);
        // Its foot is on the side of the twig to which it goes.
        const glm::dvec3 side = cosine * place.frame.normal + sine * place.frame.binormal;
        const glm::dvec3 out = across((hung ? -sky : sky) + 0.9 * side, place.frame.tangent, side);
        const glm::dvec3 way = glm::normalize(hung ? -sky + 0.3 * lean * side + 0.15 * out
                                                   : out + 0.5 * sky + 0.4 * place.frame.tangent);
        FoliageItem item;
        item.branch = twig;
        item.size = static_cast<float>(1.0 + 0.12 * other);
        item.position = place.centre + 0.95 * place.radius * out + item.size * m_reach * way;
        const glm::dvec3 x = across(place.frame.tangent, way, place.frame.normal);
        const auto [turned, straight] = maths::sincos(spin);
        const glm::dvec3 right = straight * x + turned * glm::cross(way, x);
        item.orientation = glm::normalize(glm::quat_cast(glm::dmat3(right, -way, glm::cross(right, -way))));
        return item;
    }

    const Placing& m_placing;
    const FruitForm& m_form;
    double m_reach; ///< m, from the middle of the fruit to the foot of its stalk
};

} // namespace

Expected<std::vector<FoliageItem>> placeFruit(const Placing& placing, const FruitForm& form,
                                              double probability)
{
    std::vector<FoliageItem> fruit;
    if (!(fruitRadius(form, placing.alpha) > 0.0))
        return fruit;
    const FruitGrower grower(placing, form);
    for (const Index twig : placing.twigs) {
        Random random(placing.seed, RandomStream::Apples, placing.skeleton.key[twig]);
        if (random.unit() >= probability)
            continue;
        grower.grow(twig, random, fruit);
        if (fruit.size() > maxApples)
            return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 apples"), maxApples,
                                  "foliage.applesProbability");
    }
    return fruit;
}

void ripen(const Skeleton& skeleton, double ripeness, Foliage& foliage)
{
    constexpr double takes = 0.35; // of the time from the first that is ripe to the last
    Index branch = noIndex;
    std::uint32_t number = 0;
    for (FoliageItem& fruit : foliage.apples) {
        number = fruit.branch == branch ? number + 1 : 0;
        branch = fruit.branch;
        Random random(skeleton.key[branch], RandomStream::Ripening, number);
        const double share = std::clamp((ripeness * (1.0 + takes) - random.unit()) / takes, 0.0, 1.0);
        fruit.tint = ripenedTint(foliage.fruit.kind, share);
    }
}

} // namespace ramure
