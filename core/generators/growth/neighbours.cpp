#include "core/generators/growth/neighbours.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure::growth {

namespace {

constexpr double densest = 0.9;  ///< of the light: what a crown takes at most
constexpr double fromSide = 0.5; ///< of the sky's light comes from the side of a neighbour

glm::dvec3 level(const glm::dvec3& at)
{
    return {at.x, 0.0, at.z};
}

} // namespace

void Neighbours::grow(int year)
{
    m_now.clear();
    for (const NeighbourCrown& crown : m_crowns) {
        const double share = 1.0 - maths::exp(-2.0 * double(year + 1) / crown.maturity);
        const double tall = crown.height * share;
        m_now.push_back({crown.foot, glm::length(level(crown.foot)), crown.foot.y + tall,
                         crown.foot.y + tall * crown.base * share * share,
                         0.5 * crown.width * share * (0.35 + 0.65 * share)});
    }
}

double Neighbours::lightAt(const glm::dvec3& at, glm::dvec3& away) const
{
    double left = 1.0;
    away = glm::dvec3(0.0);
    for (const Crown& crown : m_now) {
        if (at.y >= crown.top || !(crown.radius > 0.0))
            continue;
        const glm::dvec3 aside = level(at - crown.foot);
        const double distance = std::max(glm::length(aside), 1e-6);
        const double rise = crown.top - at.y;
        const double blocked =
            std::min(1.0, crown.radius / distance) * rise * rise / (rise * rise + distance * distance);
        double taken = densest * fromSide * blocked;
        if (const double part = distance / crown.radius; part < 1.0) {
            // Leaves over the place, as far as it is nearer to their stem than to the tree's own.
            const double over = crown.base + (crown.top - crown.base) * std::sqrt(1.0 - part * part);
            const double depth = std::max(0.0, over - std::max(at.y, crown.base));
            const double own = glm::length(level(at)) - distance;
            const double theirs =
                crown.apart > 0.0 ? std::clamp(0.5 + 0.5 * own / crown.apart, 0.0, 1.0) : 0.5;
            const double inside = densest * theirs * (1.0 - maths::exp(-depth / (0.25 * crown.radius)));
            taken = 1.0 - (1.0 - taken) * (1.0 - inside);
        }
        left *= 1.0 - taken;
        away += taken / distance * aside;
    }
    away /= std::max(1.0, glm::length(away));
    return left;
}

} // namespace ramure::growth
