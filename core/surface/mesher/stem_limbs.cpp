#include "core/surface/mesher/stem_limbs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double thin = 0.5;       ///< of the stem's radius: the most of a limb. Two thicker ones are a fork
constexpr double leastSine = 0.01; ///< of the angle between the two
// Of the stem's radius.
constexpr double below = 0.5;         ///< its wood below the fork
constexpr double farthestStart = 2.0; ///< from the fork, along the stem: where a limb may start
constexpr double leastBeyond = 0.2;   ///< from the stem's surface to the limb's end
// Shares of the stem's length.
constexpr double nearNext = 0.5; ///< where a limb comes out, and starts at the next fork instead
constexpr double longEnough = 1.2;
// Of a limb's radius, over the sine of its angle: its size on the stem.
constexpr double above = 1.1;  ///< how far above the fork its axis comes out
constexpr double room = 1.6;   ///< from there to the next fork
constexpr double space = 1.25; ///< of the radii of two limbs: between their axes around the stem
// Thin ones at a fork of equals.
constexpr double thinAtEquals = 0.25; ///< of the second thickest one's radius
constexpr double clearOfFork = 1.05;  ///< of the radius of what forks: nearer to its axis they end inside

bool isLimb(const StemLimb& limb, const StemLimb& stem)
{
    return limb.radius <= thin * stem.radius;
}

double sineOf(double cosine)
{
    return std::max(std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), leastSine);
}

/// How far above the fork its axis comes out of the stem.
double heightOf(const StemLimb& limb, double sine)
{
    return above * limb.radius / std::max(sine, 0.1);
}

/// Unit, across the stem.
glm::dvec3 aroundStem(const StemLimb& limb, const StemLimb& stem)
{
    const glm::dvec3 way = limb.direction - glm::dot(limb.direction, stem.direction) * stem.direction;
    return way / std::max(glm::length(way), 1e-9);
}

} // namespace

bool areStemAndLimb(double oneRadius, double otherRadius)
{
    return std::min(oneRadius, otherRadius) <= thin * std::max(oneRadius, otherRadius);
}

LimbAtFork limbAtFork(const StemLimb& limb, const StemLimb& stem)
{
    if (!isLimb(limb, stem))
        return LimbAtFork::Stands;
    const double cosine = glm::dot(limb.direction, stem.direction), sine = sineOf(cosine);
    const double ahead = limb.length * cosine, aside = limb.length * sine;
    if (aside < stem.radius && ahead > -below * stem.radius && (limb.hasChildren || ahead < stem.length))
        return LimbAtFork::Inside;
    if (stem.radius * cosine > nearNext * stem.length * sine && ahead > longEnough * stem.length)
        return LimbAtFork::Beyond;
    const double clear = heightOf(limb, sine) + room * limb.radius / std::max(sine, 0.1);
    return stem.length < clear ? LimbAtFork::Crowded : LimbAtFork::Stands;
}

double limbStart(const StemLimb& limb, const StemLimb& stem)
{
    const double cosine = glm::dot(limb.direction, stem.direction), sine = sineOf(cosine);
    const double height = heightOf(limb, sine), beyond = limb.length * sine - stem.radius;
    // The line from its end through the place where it comes out, on to the stem's axis.
    const double slope =
        (limb.length * cosine - height) / std::max({beyond, leastBeyond * stem.radius, 1e-12});
    return std::clamp(height - stem.radius * slope, -farthestStart * stem.radius,
                      farthestStart * stem.radius);
}

bool endsInFork(std::span<const StemLimb> children, std::size_t child, const StemLimb& below)
{
    double first = 0.0, second = 0.0; // the thickest
    for (const StemLimb& other : children) {
        second = std::max(second, std::min(first, other.radius));
        first = std::max(first, other.radius);
    }
    const StemLimb& limb = children[child];
    const double ahead = limb.length * glm::dot(limb.direction, below.direction);
    const double aside = glm::length(limb.length * limb.direction - ahead * below.direction);
    return !areStemAndLimb(second, first) && !areStemAndLimb(second, below.radius) &&
           limb.radius <= thinAtEquals * second && aside < clearOfFork * below.radius && ahead < below.radius;
}

Index stemOf(std::span<const StemLimb> children)
{
    if (children.empty())
        return noIndex;
    const auto stem = std::ranges::max_element(children, {}, &StemLimb::radius);
    for (auto child = children.begin(); child != children.end(); ++child)
        if (child != stem && !isLimb(*child, *stem))
            return noIndex;
    return static_cast<Index>(stem - children.begin());
}

bool standAroundStem(std::span<const StemLimb> children, double share)
{
    const Index stem = stemOf(children);
    if (stem == noIndex)
        return false;
    const StemLimb& centre = children[stem];
    for (Index i = 0; i < children.size(); ++i)
        for (Index k = 0; k < i; ++k)
            if (i != stem && k != stem &&
                glm::length(aroundStem(children[i], centre) - aroundStem(children[k], centre)) *
                        centre.radius <
                    share * space * (children[i].radius + children[k].radius))
                return false;
    return true;
}

} // namespace ramure
