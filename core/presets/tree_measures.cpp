#include "core/presets/tree_measures.h"

#include <algorithm>

namespace ramure {
namespace {

constexpr const char* urbanTrees =
    "E. G. McPherson, N. S. van Doorn, P. J. Peper: Urban tree database. Forest Service Research Data "
    "Archive, Fort Collins 2016, doi 10.2737/RDS-2016-0005";
constexpr const char* britishTrees =
    "J. Fennell: Handbook of UK urban tree allometric equations and size characteristics, version 1.4, 2024, "
    "doi 10.13140/RG.2.2.28745.04961; its trees: Open British Arboricultural Record Dataset, "
    "zenodo.org/records/15593688";

/// Means made by us of the single trees measured in streets, parks and fields of the United States and of
/// Britain; the first where it has a species. Scots pines are the British ones: dry summers east of the Rocky
/// Mountains keep them lower. Apples are all that are noted as apple trees, whatever their kind.
constexpr std::array measuredTrees{
    PublishedMeasures{"Acer palmatum", {9.9, 0.52, 12.0}, 35, urbanTrees},
    PublishedMeasures{"Acer platanoides", {19.3, 0.84, 17.0}, 319, urbanTrees},
    PublishedMeasures{"Acer saccharum", {23.2, 0.84, 16.7}, 245, urbanTrees},
    PublishedMeasures{"Aesculus hippocastanum", {17.2, 0.81, 13.6}, 33, urbanTrees},
    PublishedMeasures{"Alnus glutinosa", {12.7, 0.60, 9.9}, 190, britishTrees},
    PublishedMeasures{"Betula pendula", {19.0, 0.46, 10.7}, 70, urbanTrees},
    PublishedMeasures{"Carpinus betulus", {13.3, 0.53, 11.1}, 151, britishTrees},
    PublishedMeasures{"Castanea sativa", {16.5, 1.35, 14.4}, 128, britishTrees},
    PublishedMeasures{"Cedrus deodara", {24.4, 1.06, 19.3}, 89, urbanTrees},
    PublishedMeasures{"Cocos nucifera", {21.2, 0.39, 5.4}, 34, urbanTrees},
    PublishedMeasures{"Crataegus monogyna", {6.1, 0.33, 5.7}, 564, britishTrees},
    PublishedMeasures{"Eucalyptus globulus", {37.4, 1.22, 20.4}, 66, urbanTrees},
    PublishedMeasures{"Fagus sylvatica", {21.1, 0.69, 17.0}, 38, urbanTrees},
    PublishedMeasures{"Fraxinus excelsior", {15.4, 0.70, 12.5}, 1312, britishTrees},
    PublishedMeasures{"Ginkgo biloba", {18.4, 0.65, 13.1}, 243, urbanTrees},
    PublishedMeasures{"Gleditsia triacanthos", {20.3, 0.71, 16.6}, 345, urbanTrees},
    PublishedMeasures{"Jacaranda mimosifolia", {12.5, 0.44, 12.1}, 96, urbanTrees},
    PublishedMeasures{"Juglans regia", {14.3, 0.61, 13.0}, 30, britishTrees},
    PublishedMeasures{"Larix decidua", {14.7, 0.50, 10.1}, 20, britishTrees},
    PublishedMeasures{"Liquidambar styraciflua", {22.5, 0.75, 15.2}, 468, urbanTrees},
    PublishedMeasures{"Liriodendron tulipifera", {24.4, 0.86, 16.8}, 134, urbanTrees},
    PublishedMeasures{"Magnolia grandiflora", {15.0, 0.74, 13.0}, 336, urbanTrees},
    PublishedMeasures{"Malus domestica", {7.1, 0.40, 7.6}, 251, britishTrees},
    PublishedMeasures{"Olea europaea", {9.2, 0.60, 7.5}, 36, urbanTrees},
    PublishedMeasures{"Phoenix dactylifera", {15.8, 0.58, 6.3}, 56, urbanTrees},
    PublishedMeasures{"Picea abies", {18.0, 0.52, 9.1}, 48, britishTrees},
    PublishedMeasures{"Picea pungens", {17.3, 0.62, 9.5}, 97, urbanTrees},
    PublishedMeasures{"Pinus strobus", {20.4, 0.64, 12.8}, 71, urbanTrees},
    PublishedMeasures{"Pinus sylvestris", {13.8, 0.63, 9.5}, 376, britishTrees},
    PublishedMeasures{"Platanus × hispanica", {22.9, 0.92, 20.0}, 375, urbanTrees},
    PublishedMeasures{"Populus deltoides", {28.5, 1.18, 20.8}, 59, urbanTrees},
    PublishedMeasures{"Prunus avium", {9.9, 0.53, 9.8}, 441, britishTrees},
    PublishedMeasures{"Pseudotsuga menziesii", {30.7, 1.03, 16.4}, 39, urbanTrees},
    PublishedMeasures{"Quercus robur", {17.4, 1.10, 16.4}, 1786, britishTrees},
    PublishedMeasures{"Quercus rubra", {25.6, 1.03, 21.4}, 332, urbanTrees},
    PublishedMeasures{"Quercus virginiana", {17.4, 1.08, 22.0}, 177, urbanTrees},
    PublishedMeasures{"Robinia pseudoacacia", {22.2, 0.96, 11.8}, 95, urbanTrees},
    PublishedMeasures{"Salix alba", {16.7, 1.34, 17.9}, 71, britishTrees},
    PublishedMeasures{"Samanea saman", {18.5, 1.40, 25.9}, 62, urbanTrees},
    PublishedMeasures{"Sequoia sempervirens", {33.5, 1.30, 12.8}, 113, urbanTrees},
    PublishedMeasures{"Sorbus aucuparia", {7.5, 0.30, 6.7}, 165, britishTrees},
    PublishedMeasures{"Taxus baccata", {13.4, 0.84, 11.3}, 146, britishTrees},
    PublishedMeasures{"Tilia cordata", {19.6, 0.80, 14.2}, 195, urbanTrees},
    PublishedMeasures{"Ulmus americana", {25.0, 1.08, 22.4}, 243, urbanTrees},
    PublishedMeasures{"Washingtonia filifera", {12.2, 0.82, 3.7}, 71, urbanTrees},
};

// Mean and standard deviation of all stands of a kind of forest; a species that is known to be lighter or
// denser has a range of its own.
constexpr PublishedRange deciduous{3.46, 6.66}, evergreenBroadleaf{3.27, 8.13}, needles{2.10, 8.84},
    deciduousNeedles{2.26, 7.00};

/// Lengths of the usual leaves, in m, and of the leafy shoots of conifers. The ground below the column of a
/// poplar or a cypress is so small that no index is given.
constexpr std::array measuredLeaves{
    PublishedLeaves{"Abies balsamea", {0.10, 0.22}, needles},
    PublishedLeaves{"Acer palmatum", {0.04, 0.08}, deciduous},
    PublishedLeaves{"Acer platanoides", {0.08, 0.16}, {4, 7}},
    PublishedLeaves{"Acer saccharum", {0.08, 0.14}, {4, 7}},
    PublishedLeaves{"Aesculus hippocastanum", {0.18, 0.34}, {4, 7}},
    PublishedLeaves{"Alnus glutinosa", {0.04, 0.09}, deciduous},
    PublishedLeaves{"Betula pendula", {0.03, 0.07}, {2, 3.5}},
    PublishedLeaves{"Carpinus betulus", {0.04, 0.10}, deciduous},
    PublishedLeaves{"Castanea sativa", {0.10, 0.25}, deciduous},
    PublishedLeaves{"Cedrus deodara", {0.10, 0.20}, needles},
    PublishedLeaves{"Cedrus libani", {0.10, 0.20}, needles},
    PublishedLeaves{"Crataegus monogyna", {0.02, 0.05}, deciduous},
    PublishedLeaves{"Cupressus sempervirens", {0.05, 0.18}, {}},
    PublishedLeaves{"Eucalyptus globulus", {0.15, 0.25}, evergreenBroadleaf},
    PublishedLeaves{"Fagus sylvatica", {0.05, 0.10}, {5, 8}},
    PublishedLeaves{"Fraxinus excelsior", {0.20, 0.35}, deciduous},
    PublishedLeaves{"Ginkgo biloba", {0.04, 0.08}, deciduous},
    PublishedLeaves{"Gleditsia triacanthos", {0.12, 0.25}, {2, 4}},
    PublishedLeaves{"Jacaranda mimosifolia", {0.25, 0.45}, deciduous},
    PublishedLeaves{"Juglans regia", {0.20, 0.45}, deciduous},
    PublishedLeaves{"Larix decidua", {0.08, 0.18}, deciduousNeedles},
    PublishedLeaves{"Liquidambar styraciflua", {0.07, 0.15}, deciduous},
    PublishedLeaves{"Liriodendron tulipifera", {0.08, 0.15}, deciduous},
    PublishedLeaves{"Magnolia grandiflora", {0.12, 0.22}, evergreenBroadleaf},
    PublishedLeaves{"Malus domestica", {0.04, 0.10}, {2, 4}},
    PublishedLeaves{"Nyssa sylvatica", {0.06, 0.12}, deciduous},
    PublishedLeaves{"Olea europaea", {0.04, 0.08}, {1.5, 4}},
    PublishedLeaves{"Picea abies", {0.10, 0.25}, needles},
    PublishedLeaves{"Picea pungens", {0.10, 0.25}, needles},
    PublishedLeaves{"Pinus pinea", {0.12, 0.28}, needles},
    PublishedLeaves{"Pinus strobus", {0.12, 0.28}, needles},
    PublishedLeaves{"Pinus sylvestris", {0.10, 0.24}, needles},
    PublishedLeaves{"Platanus × hispanica", {0.10, 0.22}, deciduous},
    PublishedLeaves{"Populus deltoides", {0.06, 0.13}, deciduous},
    PublishedLeaves{"Populus nigra 'Italica'", {0.05, 0.08}, {}},
    PublishedLeaves{"Populus tremuloides", {0.03, 0.07}, {2, 4}},
    PublishedLeaves{"Prunus avium", {0.07, 0.12}, deciduous},
    PublishedLeaves{"Pseudotsuga menziesii", {0.10, 0.25}, needles},
    PublishedLeaves{"Quercus robur", {0.07, 0.14}, {3, 6}},
    PublishedLeaves{"Quercus rubra", {0.12, 0.20}, deciduous},
    PublishedLeaves{"Quercus virginiana", {0.04, 0.10}, evergreenBroadleaf},
    PublishedLeaves{"Robinia pseudoacacia", {0.15, 0.30}, deciduous},
    PublishedLeaves{"Salix alba", {0.05, 0.10}, {3, 5}},
    PublishedLeaves{"Salix babylonica", {0.08, 0.16}, {3, 5}},
    PublishedLeaves{"Samanea saman", {0.20, 0.40}, evergreenBroadleaf},
    PublishedLeaves{"Sassafras albidum", {0.09, 0.17}, deciduous},
    PublishedLeaves{"Sequoia sempervirens", {0.10, 0.25}, needles},
    PublishedLeaves{"Sequoiadendron giganteum", {0.10, 0.25}, needles},
    PublishedLeaves{"Sorbus aucuparia", {0.10, 0.20}, deciduous},
    PublishedLeaves{"Taxus baccata", {0.10, 0.22}, needles},
    PublishedLeaves{"Tilia cordata", {0.04, 0.08}, {4, 7}},
    PublishedLeaves{"Ulmus americana", {0.07, 0.14}, deciduous},
    PublishedLeaves{"Ulmus minor", {0.05, 0.10}, deciduous},
};

} // namespace

const char* const publishedLeavesSource =
    "Lengths: the usual range in floras of Europe and North America. Index of a kind of forest: G. P. Asner, "
    "J. M. O. Scurlock, J. A. Hicke: Global synthesis of leaf area index observations. Global Ecology and "
    "Biogeography 12, 2003";

std::span<const PublishedLeaves> publishedLeaves()
{
    return measuredLeaves;
}

const PublishedLeaves* publishedLeaves(std::string_view latin)
{
    const auto found = std::ranges::find(measuredLeaves, latin, &PublishedLeaves::latin);
    return found == measuredLeaves.end() ? nullptr : &*found;
}

std::span<const PublishedMeasures> publishedMeasures()
{
    return measuredTrees;
}

const PublishedMeasures* publishedMeasures(std::string_view latin)
{
    const auto found = std::ranges::find(measuredTrees, latin, &PublishedMeasures::latin);
    return found == measuredTrees.end() ? nullptr : &*found;
}

} // namespace ramure
