/// \file
/// Flowers and fruit of a deciduous tree on a day. Internal to foliage_on_day.cpp.
#pragma once

#include "core/surface/foliage/foliage.h"
#include "core/surface/season/phenology.h"

namespace ramure {

/// Flowers stand where leaves do, whatever fruit they become; then the fruit that were placed grow on their
/// stalks, ripen and fall. Cones stay. \param out has its form of fruit; gets its flowers or fruit.
void fruitOnDay(const Foliage& placed, const Skeleton& skeleton, const PlantYear& plant,
                const YearDates& dates, double day, double alpha, Foliage& out);

} // namespace ramure
