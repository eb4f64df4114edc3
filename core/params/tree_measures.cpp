#include "core/params/tree_measures.h"

#include <algorithm>

namespace ramure {
namespace {

/// Means made by us of the trees measured in streets and parks of the United States. Scots pines
/// there are left out: dry summers east of the Rocky Mountains keep them at half the height of European ones.
constexpr std::array all{
    PublishedMeasures{"Acer palmatum", {9.9, 0.52, 12.0}, 35},
    PublishedMeasures{"Acer saccharum", {23.2, 0.84, 16.7}, 245},
    PublishedMeasures{"Aesculus hippocastanum", {17.2, 0.81, 13.6}, 33},
    PublishedMeasures{"Betula pendula", {19.0, 0.46, 10.7}, 70},
    PublishedMeasures{"Eucalyptus globulus", {37.4, 1.22, 20.4}, 66},
    PublishedMeasures{"Fagus sylvatica", {21.1, 0.69, 17.0}, 38},
    PublishedMeasures{"Ginkgo biloba", {18.4, 0.65, 13.1}, 243},
    PublishedMeasures{"Liquidambar styraciflua", {22.5, 0.75, 15.2}, 468},
    PublishedMeasures{"Magnolia grandiflora", {15.0, 0.74, 13.0}, 336},
    PublishedMeasures{"Olea europaea", {9.2, 0.60, 7.5}, 36},
    PublishedMeasures{"Pinus strobus", {20.4, 0.64, 12.8}, 71},
    PublishedMeasures{"Platanus × hispanica", {22.9, 0.92, 20.0}, 375},
    PublishedMeasures{"Populus deltoides", {28.5, 1.18, 20.8}, 59},
    PublishedMeasures{"Pseudotsuga menziesii", {30.7, 1.03, 16.4}, 39},
    PublishedMeasures{"Robinia pseudoacacia", {22.2, 0.96, 11.8}, 95},
    PublishedMeasures{"Tilia cordata", {19.6, 0.80, 14.2}, 195},
};

} // namespace

std::span<const PublishedMeasures> publishedMeasures()
{
    return all;
}

const PublishedMeasures* publishedMeasures(std::string_view latin)
{
    const auto found = std::ranges::find(all, latin, &PublishedMeasures::latin);
    return found == all.end() ? nullptr : &*found;
}

} // namespace ramure
