/// \file
/// The veins of a blade: A. Runions, M. Fuhrer, B. Lane, P. Federl, A.-G. Rolland-Lagan and P. Prusinkiewicz,
/// "Modeling and visualization of leaf venation patterns", 2005, the open kind. Sources of auxin appear in
/// the gaps of a growing blade; veins grow towards those that are nearest to them and silence those they
/// reach.
#pragma once

#include "core/params/leaf_params.h"
#include "core/surface/foliage/leaf_blade.h"

namespace ramure {

/// One piece of a vein, in the flat blade: foot of the blade at the origin, 1 long.
struct Vein
{
    glm::dvec2 from, to;
    double radius; ///< that of its tip ends' bundles: r^3 = sum of r_i^3; 1 = a tip
};

/// Parents before children. \param ribs ends of the veins that are there from the beginning, each a straight
/// way from the foot. \param gap how far apart veins end up, of the blade's length, 0.02..0.5.
std::vector<Vein> venation(const FlatBlade& blade, const std::vector<glm::dvec2>& ribs, double gap,
                           std::uint64_t seed);

/// The blade of a plant's leaf, or of one of its leaflets, and its veins. Needles have their midrib alone.
/// \pre the shape is not Faithful.
struct VeinedBlade
{
    FlatBlade blade;
    std::vector<Vein> veins;
};
VeinedBlade veinedBlade(LeafShape shape);

} // namespace ramure
