/// \file
/// Room for growth as points: the second light model of Palubicki et al. (2009), section 4.1, after Runions
/// et al. (2007).
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Each point goes to the nearest bud that sees it, and is gone when wood comes near. What a bud sees is its
/// light, and where it lies is where the shoot turns to.
class FreeSpace
{
public:
    /// \param reach m, how far buds see
    FreeSpace(std::vector<glm::dvec3> points, double reach);

    /// Wood has come here.
    void occupy(const glm::dvec3& at, double radius);
    /// Wood has gone from here; what still stands has to occupy() its room again.
    void release(const glm::dvec3& at, double radius);
    /// A bud looks, before sum(). Of two as near as each other the one that looked first gets the point.
    void look(Index bud, const glm::dvec3& at, const glm::dvec3& direction);
    /// After all have looked: \p towards of each bud that got points becomes their mean direction, the others
    /// stay; all points are free again for the next year. \return how many points were seen
    Index sum(std::vector<glm::dvec3>& towards);

private:
    template <class Visit> void around(const glm::dvec3& at, double radius, bool gone, Visit&& visit);

    double m_reach, m_cell;
    glm::dvec3 m_min{0.0};
    int m_x = 1, m_y = 1, m_z = 1;
    std::vector<glm::dvec3> m_points; ///< cell by cell
    std::vector<Index> m_first;       ///< of each cell
    std::vector<bool> m_gone;
    std::vector<double> m_nearest; ///< m2
    std::vector<Index> m_bud;
    std::vector<glm::dvec3> m_from; ///< where that bud is
};

} // namespace ramure
