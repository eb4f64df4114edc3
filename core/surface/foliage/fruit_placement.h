/// \file
/// Where fruit hang and flowers stand: each on its stalk, which begins on the bark. Internal to
/// place_foliage.cpp.
#pragma once

#include "core/surface/foliage/leaf_placement.h"

namespace ramure {

/// One place, or a cluster's, on each twig that chance takes; twig b draws from
/// Random(seed, RandomStream::Apples, key of b). Fruit hang, flowers look outwards and up.
/// Errors: Limit (more than maxApples; path = foliage.applesProbability).
/// \pre the kind is not Faithful.
Expected<std::vector<FoliageItem>> placeFruit(const Placing& placing, const FruitForm& form,
                                              double probability);

/// Gives each fruit the colour of its ripeness. \param ripeness the share of them that are ripe
/// \pre the fruit's form ripens
void ripen(const Skeleton& skeleton, double ripeness, Foliage& foliage);

} // namespace ramure
