#include "core/presets/named_seeds.h"

#include "core/base/error.h"
#include <algorithm>

namespace ramure {
namespace {

struct Row
{
    std::string_view preset;
    std::array<std::int64_t, namedSeedCount> seeds;
};

constexpr std::array namedSeedRows{
    Row{"AmericanElm", {19, 24, 36, 29, 3, 13}},
    Row{"BalsamFir", {19, 13, 10, 14, 6, 34}},
    Row{"Bamboo", {29, 7, 36, 24, 23, 11}},
    Row{"Baobab", {1, 35, 33, 40, 26, 13}},
    Row{"BlackLocust", {1, 34, 36, 13, 15, 31}},
    Row{"BlackTupelo", {19, 13, 10, 20, 4, 34}},
    Row{"BlueGum", {3, 13, 33, 38, 2, 34}},
    Row{"BlueSpruce", {19, 13, 33, 20, 6, 34}},
    Row{"CaliforniaBlackOak", {27, 13, 38, 14, 1, 34}},
    Row{"CoastRedwood", {19, 13, 33, 20, 23, 34}},
    Row{"CoconutPalm", {33, 30, 27, 8, 36, 12}},
    Row{"CommonAlder", {1, 22, 36, 40, 6, 13}},
    Row{"CommonAsh", {16, 31, 9, 4, 14, 13}},
    Row{"CommonWalnut", {16, 34, 10, 27, 40, 13}},
    Row{"CommonYew", {16, 2, 10, 27, 23, 13}},
    Row{"DatePalm", {16, 28, 1, 7, 35, 9}},
    Row{"DeodarCedar", {40, 13, 10, 20, 4, 34}},
    Row{"DouglasFir", {19, 13, 10, 20, 6, 34}},
    Row{"EasternCottonwood", {15, 34, 38, 36, 40, 13}},
    Row{"EasternWhitePine", {1, 31, 33, 10, 6, 13}},
    Row{"EnglishOak1995", {23, 34, 38, 36, 31, 13}},
    Row{"EuropeanBeech1995", {40, 22, 10, 2, 30, 13}},
    Row{"EuropeanLarch", {19, 31, 10, 20, 6, 13}},
    Row{"FanPalm", {13, 38, 19, 40, 5, 12}},
    Row{"FieldElm", {23, 20, 36, 19, 7, 13}},
    Row{"GiantSequoia", {1, 13, 33, 10, 23, 34}},
    Row{"Ginkgo", {1, 13, 36, 24, 32, 34}},
    Row{"Hawthorn", {19, 34, 38, 25, 23, 13}},
    Row{"HoneyLocust", {16, 2, 9, 21, 15, 13}},
    Row{"Hornbeam", {23, 13, 10, 18, 14, 34}},
    Row{"HorseChestnut", {19, 13, 10, 21, 22, 34}},
    Row{"ItalianCypress", {1, 13, 10, 22, 26, 34}},
    Row{"Jacaranda", {25, 13, 33, 31, 37, 34}},
    Row{"JapaneseMaple", {40, 34, 33, 35, 37, 13}},
    Row{"JoshuaTree", {6, 20, 28, 3, 18, 26}},
    Row{"LebanonCedar1995", {1, 22, 33, 20, 30, 13}},
    Row{"LiveOak", {40, 3, 33, 15, 24, 13}},
    Row{"LombardyPoplar1995", {23, 13, 36, 27, 38, 34}},
    Row{"LondonPlane", {23, 20, 38, 4, 29, 13}},
    Row{"NorwayMaple", {40, 13, 33, 21, 22, 34}},
    Row{"NorwaySpruce1995", {19, 13, 10, 29, 6, 34}},
    Row{"OliveTree1995", {18, 28, 33, 26, 23, 25}},
    Row{"OrchardApple1995", {3, 24, 10, 36, 23, 13}},
    Row{"QuakingAspen", {19, 13, 10, 8, 14, 34}},
    Row{"RainTree", {23, 34, 6, 29, 24, 13}},
    Row{"RedOak", {23, 34, 36, 8, 15, 13}},
    Row{"Rowan", {40, 13, 33, 30, 31, 34}},
    Row{"Saguaro", {6, 10, 25, 23, 39, 20}},
    Row{"Sassafras", {1, 31, 33, 10, 18, 23}},
    Row{"ScotsPine1995", {1, 13, 33, 40, 26, 34}},
    Row{"SilverBirch1995", {40, 13, 33, 8, 31, 34}},
    Row{"SmallLeavedLinden1995", {19, 31, 10, 18, 38, 13}},
    Row{"SouthernMagnolia", {1, 34, 10, 20, 23, 13}},
    Row{"StonePine", {23, 13, 38, 20, 4, 34}},
    Row{"SugarMaple", {40, 13, 33, 21, 31, 34}},
    Row{"SweetChestnut", {1, 21, 36, 8, 31, 13}},
    Row{"Sweetgum", {23, 13, 33, 24, 26, 34}},
    Row{"TreeFern", {5, 3, 4, 30, 23, 8}},
    Row{"TulipTree", {23, 13, 38, 8, 22, 34}},
    Row{"UmbrellaAcacia", {33, 23, 5, 18, 2, 7}},
    Row{"WeepingWillow1995", {1, 13, 33, 19, 34, 31}},
    Row{"WhiteWillow", {16, 31, 9, 18, 1, 13}},
    Row{"WildCherry", {1, 13, 38, 8, 31, 34}},
};

} // namespace

const std::array<const char*, namedSeedCount> seedNames = {RAMURE_NOOP("typical"), RAMURE_NOOP("tall"),
                                                           RAMURE_NOOP("low"),     RAMURE_NOOP("wide"),
                                                           RAMURE_NOOP("slender"), RAMURE_NOOP("stout")};

const std::array<std::int64_t, namedSeedCount>* namedSeeds(std::string_view preset)
{
    const auto found = std::ranges::find(namedSeedRows, preset, &Row::preset);
    return found == namedSeedRows.end() ? nullptr : &found->seeds;
}

} // namespace ramure
