/// \file
/// The light that the crowns of neighbours take. Internal to the growing tree.
#pragma once

#include "core/params/growth_space.h"
#include <vector>

namespace ramure::growth {

/// Crowns are half ellipsoids over their bases that grow with the years, as their parameters say: no tree
/// waits for another to be grown, and the order of trees changes nothing.
class Neighbours
{
public:
    explicit Neighbours(const std::vector<NeighbourCrown>& crowns)
        : m_crowns(crowns)
    {
    }
    /// Sets the crowns to what they are in a year. \param year 0: that of the seed
    void grow(int year);
    [[nodiscard]] bool empty() const { return m_crowns.empty(); }
    /// The share of the sky's light that is left at a place, m, tree space.
    /// \param away becomes where there is more of it: level, shorter than 1
    [[nodiscard]] double lightAt(const glm::dvec3& at, glm::dvec3& away) const;

private:
    struct Crown
    {
        glm::dvec3 foot{0.0};
        double apart = 0.0;                         ///< m, from the foot of the tree that they shade
        double top = 0.0, base = 0.0, radius = 0.0; ///< m
    };
    const std::vector<NeighbourCrown>& m_crowns;
    std::vector<Crown> m_now;
};

} // namespace ramure::growth
