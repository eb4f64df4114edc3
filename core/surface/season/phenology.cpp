#include "core/surface/season/phenology.h"

#include "core/math/reproducible.h"
#include <algorithm>

namespace ramure {
namespace {

constexpr std::array<BudModel, 7> budModels{{
    {7, 3, 1372, -246}, // European larch
    {9, 4, 1848, -317}, // Norway spruce
    {9, 5, 1395, -223}, // Scots pine
    {9, 5, 1438, -261}, // downy birch
    {9, 4, 1748, -298}, // English oak
    {9, 3, 1741, -282}, // sessile oak
    {9, 6, 1922, -348}, // beech
}};
/// The first of November, of February and of September, and midsummer, counted from 0.
constexpr int november = 304, february = 31, september = 243, midsummer = 172;

using S = LeafShape;
using B = BudKind;

/// Plants beyond Menzel's follow the nearest of them by as many days as in phenological calendars of central
/// Europe, to about a week; when leaves turn and how long they fall likewise. Pigments are such that the
/// colours are those of the plant.
// clang-format off
constexpr std::array<PlantYear, leafShapeCount - 1> plants{{
    {.shape = S::Beech, .buds = B::Beech, .fallWeeks = 4, .redYoung = 0.5F, .summer = {48, 10, 1, 0}, .autumn = {3, 6, 5.5F, 0.5F}, .withers = 0.8F, .byLight = 0.3F, .keeps = 0.14F, .ripe = 275},
    {.shape = S::Elm, .buds = B::Birch, .later = 6, .turns = 0.95, .fallWeeks = 3, .redYoung = 0.8F, .autumn = {3, 7, 0, 0.05F}},
    {.shape = S::Cherry, .buds = B::Birch, .later = 5, .turns = 0.9, .fallWeeks = 3, .redYoung = 3.0F, .autumn = {3, 7, 13, 0}, .byLight = 0.7F, .flowers = -10, .ripe = 180},
    {.shape = S::Magnolia, .later = 5, .summer = {60, 13, 0.5F, 0}, .needleYears = 2},
    {.shape = S::Box, .buds = B::Birch, .later = 5, .summer = {60, 13, 0.5F, 0}, .needleYears = 3},
    {.shape = S::Birch, .buds = B::Birch, .turns = 0.82, .fallWeeks = 5, .redYoung = 0.6F, .summer = {40, 9, 0.8F, 0}, .autumn = {2, 7, 0, 0}, .withers = 0.15F},
    {.shape = S::Apple, .buds = B::Birch, .later = 7, .turns = 1.08, .fallWeeks = 4, .redYoung = 1.0F, .autumn = {6, 6, 1, 0.12F}, .flowers = 8, .ripe = 265},
    {.shape = S::Aspen, .buds = B::Birch, .later = 8, .turns = 0.85, .fallWeeks = 3, .redYoung = 2.5F, .summer = {38, 8, 0.8F, 0}, .autumn = {2, 8, 0.3F, 0}, .withers = 0.15F},
    {.shape = S::Hazel, .buds = B::Birch, .later = -6, .fallWeeks = 4, .autumn = {4, 6, 0, 0.12F}, .ripe = 260},
    {.shape = S::Linden, .later = -4, .turns = 0.92, .fallWeeks = 4, .redYoung = 0.5F, .autumn = {2.5F, 7, 0, 0.04F}},
    {.shape = S::Redbud, .later = 6, .fallWeeks = 3, .autumn = {3, 7, 0, 0.03F}, .flowers = -12},
    {.shape = S::Willow, .buds = B::Larch, .turns = 1.12, .fallWeeks = 5, .redYoung = 0.5F, .summer = {34, 8, 0.5F, 0}, .autumn = {7, 7, 0, 0.04F}},
    {.shape = S::Olive, .summer = {50, 11, 0.5F, 0}, .needleYears = 3, .ripe = 320},
    {.shape = S::Eucalyptus, .summer = {45, 11, 1, 0}, .needleYears = 2},
    {.shape = S::Bamboo, .later = 5, .summer = {40, 9, 0.5F, 0}, .needleYears = 2},
    {.shape = S::Grass, .buds = B::Larch, .fallWeeks = 8, .autumn = {1, 3, 0, 0.12F}, .keeps = 0.8F},
    {.shape = S::Maple, .later = -3, .turns = 0.9, .fallWeeks = 3.5, .redYoung = 1.5F, .autumn = {2.5F, 7, 13, 0.02F}, .byLight = 0.85F},
    {.shape = S::JapaneseMaple, .later = -4, .turns = 1.03, .fallWeeks = 3, .redYoung = 8.0F, .summer = {26, 8, 4, 0}, .autumn = {2, 5, 32, 0}, .byLight = 0.4F},
    {.shape = S::Plane, .later = 6, .turns = 1.08, .fallWeeks = 6, .autumn = {5, 5, 1, 0.35F}, .withers = 0.6F},
    {.shape = S::Sweetgum, .later = 6, .turns = 1.05, .fallWeeks = 5, .autumn = {3, 6, 26, 0}, .byLight = 0.7F},
    {.shape = S::Oak, .turns = 1.1, .fallWeeks = 5, .redYoung = 1.2F, .summer = {45, 10, 1, 0}, .autumn = {6, 6, 2.5F, 0.6F}, .withers = 0.8F, .byLight = 0.4F, .keeps = 0.1F, .ripe = 275},
    {.shape = S::RedOak, .later = 4, .fallWeeks = 4, .redYoung = 4.0F, .summer = {45, 10, 1, 0}, .autumn = {4, 5, 18, 0.12F}, .withers = 0.8F, .byLight = 0.6F, .keeps = 0.12F, .ripe = 275},
    {.shape = S::Hawthorn, .buds = B::Birch, .later = -14, .fallWeeks = 4, .redYoung = 0.8F, .autumn = {4, 5, 10, 0.12F}, .byLight = 0.6F, .flowers = 32, .ripe = 260},
    {.shape = S::Ginkgo, .later = 4, .turns = 1.06, .fallWeeks = 1.5, .summer = {34, 8, 0.5F, 0}, .autumn = {1, 8, 0, 0}, .withers = 0.05F},
    {.shape = S::FanPalm},
    {.shape = S::Ash, .later = 11, .turns = 0.93, .fallWeeks = 2, .redYoung = 1.2F, .autumn = {6, 7, 0, 0.02F}, .withers = 0.15F},
    {.shape = S::Rowan, .buds = B::Birch, .turns = 0.84, .fallWeeks = 3, .redYoung = 0.8F, .autumn = {3, 7, 13, 0.02F}, .byLight = 0.6F, .flowers = 28, .ripe = 235},
    {.shape = S::Walnut, .later = 9, .turns = 0.98, .fallWeeks = 2, .redYoung = 5.0F, .autumn = {4, 6, 0, 0.15F}, .ripe = 270},
    {.shape = S::Robinia, .later = 14, .turns = 1.06, .fallWeeks = 4, .redYoung = 0.6F, .summer = {34, 8, 0.5F, 0}, .autumn = {5, 7, 0, 0}, .withers = 0.1F},
    {.shape = S::Mimosa, .summer = {45, 10, 1, 0}, .needleYears = 2},
    {.shape = S::HorseChestnut, .buds = B::Birch, .later = -3, .turns = 0.85, .fallWeeks = 4, .redYoung = 1.0F, .autumn = {4, 6, 2, 0.4F}, .withers = 0.7F},
    {.shape = S::Laburnum, .buds = B::Birch, .later = 6, .fallWeeks = 3, .autumn = {6, 7, 0, 0.05F}},
    {.shape = S::Fern, .later = 4, .turns = 0.85, .fallWeeks = 5, .autumn = {2, 5, 2, 0.5F}, .withers = 0.3F, .keeps = 0.5F},
    {.shape = S::Palm},
    {.shape = S::Yew, .buds = B::Spruce, .later = 2, .redYoung = 0.2F, .summer = {70, 15, 0.2F, 0}, .needleYears = 6},
    {.shape = S::Fir, .buds = B::Spruce, .later = 4, .redYoung = 0.2F, .summer = {70, 15, 0.2F, 0}, .needleYears = 7},
    {.shape = S::Spruce, .buds = B::Spruce, .redYoung = 0.2F, .summer = {70, 15, 0.2F, 0}, .needleYears = 6},
    {.shape = S::BlueSpruce, .buds = B::Spruce, .later = 3, .redYoung = 0.2F, .summer = {70, 15, 0.2F, 0}, .needleYears = 6},
    {.shape = S::Cedar, .buds = B::Spruce, .later = -6, .redYoung = 0.2F, .summer = {60, 13, 0.2F, 0}, .needleYears = 4},
    {.shape = S::ScotsPine, .buds = B::Pine, .redYoung = 0.2F, .summer = {60, 13, 0.2F, 0}, .needleYears = 3},
    {.shape = S::WhitePine, .buds = B::Pine, .later = -3, .redYoung = 0.2F, .summer = {60, 13, 0.2F, 0}, .needleYears = 2.5},
    {.shape = S::Larch, .buds = B::Larch, .turns = 1.1, .fallWeeks = 4, .redYoung = 0.2F, .summer = {28, 8, 0.5F, 0}, .autumn = {2, 8, 1.2F, 0.03F}, .withers = 0.2F},
    {.shape = S::Cypress, .buds = B::Spruce, .redYoung = 0.2F, .summer = {60, 13, 0.2F, 0}, .needleYears = 5},
}};
// clang-format on

constexpr bool plantsStandInOrder()
{
    for (std::size_t i = 0; i < plants.size(); ++i)
        if (static_cast<std::size_t>(plants[i].shape) != i + 1)
            return false;
    return true;
}

/// Days until 300 degree days above 5 °C have come together.
double unfoldingDays(const Climate& climate, int from)
{
    double warmth = 0.0;
    for (int day = from; day < daysOfYear; ++day) {
        warmth += std::max(climate.mean[std::size_t(day)] - 5.0, 0.0);
        if (warmth >= 300.0)
            return day + 1 - from;
    }
    return daysOfYear - from;
}

} // namespace

BudModel budModel(BudKind kind)
{
    return budModels[static_cast<std::size_t>(kind)];
}

std::optional<int> budburst(const BudModel& model, const Climate& climate)
{
    const auto chills = [&](int day) { return climate.mean[std::size_t(day)] <= model.chill ? 1 : 0; };
    int chill = 0;
    for (int day = november; day < daysOfYear; ++day)
        chill += chills(day);
    double warmth = 0.0;
    for (int day = 0; day < september; ++day) {
        chill += chills(day);
        if (day < february)
            continue;
        warmth += std::max(climate.mean[std::size_t(day)] - model.warmth, 0.0);
        // However long the winter, some warmth is needed.
        if (chill > 0 && warmth > 0.0 && warmth >= model.a + model.b * maths::log(double(chill)))
            return day + 1;
    }
    return {};
}

std::optional<int> colouring(const Climate& climate, double share)
{
    constexpr double warm = 28.5, longDay = 14.5, critical = 8268.0;
    double sum = 0.0;
    for (int day = midsummer; day < daysOfYear; ++day) {
        const double cold = warm - climate.mean[std::size_t(day)],
                     hours = dayLength(climate.latitude, day + 1);
        if (cold > 0.0 && hours < longDay)
            sum += cold * cold * (hours / longDay) * (hours / longDay);
        if (sum >= share * critical)
            return day + 1;
    }
    return {};
}

const PlantYear& plantYear(LeafShape shape)
{
    static_assert(plantsStandInOrder(), "the plants stand in the order of the shapes");
    return plants[static_cast<std::size_t>(shape) - 1];
}

std::optional<YearDates> datesOf(const PlantYear& plant, const Climate& climate)
{
    const auto buds = budburst(budModel(plant.buds), climate);
    const auto turned = colouring(climate, plant.turns);
    if (!buds || !turned)
        return {};
    YearDates out;
    out.burst = std::max(1.0, *buds + plant.later);
    out.unfolded = out.burst + unfoldingDays(climate, int(out.burst));
    out.turned = std::max(double(*turned), out.unfolded + 30.0);
    const double weeks = 7.0 * plant.fallWeeks;
    out.firstFall = out.turned + std::max(3.0, 16.0 - 0.4 * weeks);
    out.lastFall = out.firstFall + weeks;
    return out;
}

} // namespace ramure
