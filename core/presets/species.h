/// \file
/// Trees of Weber and Penn by their numbers: what sets one species apart; and plants that grammars draw.
/// Internal to the presets.
#pragma once

#include "core/params/node_params.h"
#include "core/presets/presets.h"
#include <array>
#include <span>
#include <vector>

namespace ramure {

struct SpeciesDress
{
    LeafShape leaf = LeafShape::Beech;
    double size = 1.0, internode = 1.0; ///< relative to the plant's natural values, for this trunk
    double twig = 0.1;                  ///< thinner than this share of the trunk, branches carry leaves
    BarkFamily bark = BarkFamily::Smooth;
    double light = 0.0;
    FruitKind fruit = FruitKind::Faithful;
    double fruitful = 0.0;
    double fruitDiameter = 0.0; ///< m, at the widest; from floras
    double tile = 0.0;          ///< m, of the bark; 0: as grownBarkTile says
};

struct Species
{
    const char* name = "";        ///< "QuakingAspen"
    const char* latin = "";       ///< "Populus tremuloides"
    const char* description = ""; ///< English, context "core"
    bool conifer = false;
    WeberPennParams growth; ///< with angles in degrees, unlike everywhere else
    SpeciesDress dress;
};

/// The four of the paper, and some in its style; then ours.
std::span<const Species> species();
std::span<const Species> broadleavedSpecies();
std::span<const Species> coniferSpecies();
/// Leaves in the sizes of a flora.
struct GrownLeaves
{
    double length = 0.1;    ///< m, of a blade without its petiole; of needles, that of the shoot
    double internode = 1.0; ///< between leaves, or short shoots, of a twig; see LeafParams
    int perShoot = 1;
    double width = 1.0; ///< see LeafParams
};

/// A species that grows year by year. Its bark, leaves and fruit are those of the species with the same name
/// and "1995", or for a palm with the same name and "Rules".
struct GrownSpecies
{
    const char* name;
    const char* latin;
    const char* description; ///< English, context "core"
    bool conifer = false;
    std::array<int, 3> ages{}; ///< years: young, mature, old
    GrowthParams growth;       ///< with its axil in degrees
    GrownLeaves leaves;
    double redness = 1.0; ///< SeasonParams
};
std::span<const GrownSpecies> grownSpecies();
void setLeaves(NodeParams& params, const GrownLeaves& leaves);
/// \param dress the parameters of the other tree of the species
NodeParams grownParams(const GrownSpecies& species, const NodeParams& dress);
/// m, so that plates, furrows and scars are as large as on grown trees.
double grownBarkTile(BarkFamily family);
/// The parameters of a node, angles in rad.
NodeParams speciesParams(const Species& species);
/// Palms, ferns and rosettes: grammars that put their leaves where they belong.
std::vector<Preset> organPresets();

} // namespace ramure
