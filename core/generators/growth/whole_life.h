/// \file
/// All wood that a tree has ever had, as one skeleton, and where this is at each age: for files in which a
/// tree grows though its mesh always has the same vertices.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Where each metamer ends at an age, and how thick it is there.
struct WoodAtAge
{
    std::vector<glm::dvec3> at; ///< m, by metamer
    std::vector<double> radius; ///< m, by metamer; 0: it does not stand at that age
};
/// \pre a branching habit (a palm has no history of metamers), 0 <= age <= the years that were grown
WoodAtAge woodAtAge(const GrowthHistory& history, double age);

/// What of all ages' wood an axis carries, with all that grows on it, at the age where this is the most: 1 is
/// all that the tree has then. So the twigs of a young tree count as much as the limbs of an old one.
/// \param ages at which it is measured \return by axis
std::vector<double> greatestShares(const GrowthHistory& history, const std::vector<double>& ages);

/// A skeleton of the wood of all ages. Its topology is that of every age; its places are those of the last
/// age, but that limbs which were shed stand on the bark of then. Its wood is slender, so that a mesh of it
/// has the forks of old wood apart from each other, and those of young wood not far too large.
struct WholeLife
{
    static constexpr double slenderness = 0.6; ///< of the radii that wood has had at most

    Skeleton skeleton;
    std::vector<Index> metamer; ///< by branch: the one at its end
    std::vector<double> radius; ///< m, by metamer, of the skeleton; 0: it is not there
};
/// \param axes by axis of the history: whether it is wanted. An axis without its parent is not.
WholeLife wholeLife(const GrowthHistory& history, const std::vector<bool>& axes);

} // namespace ramure
