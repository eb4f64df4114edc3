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
    Row{"AmericanElm", {26, 31, 1, 30, 10, 34}},
    Row{"AmericanElm1995", {19, 24, 36, 29, 3, 13}},
    Row{"BalsamFir", {8, 9, 1, 2, 4, 10}},
    Row{"BalsamFir1995", {19, 13, 10, 14, 6, 34}},
    Row{"Bamboo", {29, 7, 36, 24, 23, 11}},
    Row{"Baobab", {1, 35, 33, 40, 26, 13}},
    Row{"BlackLocust", {22, 5, 28, 36, 34, 13}},
    Row{"BlackLocust1995", {1, 34, 36, 13, 15, 31}},
    Row{"BlackTupelo", {19, 13, 10, 20, 4, 34}},
    Row{"BlueGum", {9, 3, 10, 8, 7, 4}},
    Row{"BlueGum1995", {3, 13, 33, 38, 2, 34}},
    Row{"BlueSpruce", {22, 9, 28, 12, 4, 25}},
    Row{"BlueSpruce1995", {19, 13, 33, 20, 6, 34}},
    Row{"CaliforniaBlackOak", {27, 13, 38, 14, 1, 34}},
    Row{"CoastRedwood", {8, 9, 1, 10, 7, 6}},
    Row{"CoastRedwood1995", {19, 13, 33, 20, 23, 34}},
    Row{"CoconutPalm", {24, 9, 13, 7, 21, 1}},
    Row{"CoconutPalmRules", {33, 30, 27, 8, 36, 12}},
    Row{"CommonAlder", {7, 5, 28, 32, 13, 26}},
    Row{"CommonAlder1995", {1, 22, 36, 40, 6, 13}},
    Row{"CommonAsh", {40, 23, 28, 29, 6, 34}},
    Row{"CommonAsh1995", {16, 31, 9, 4, 14, 13}},
    Row{"CommonWalnut", {8, 19, 10, 35, 6, 34}},
    Row{"CommonWalnut1995", {16, 34, 10, 27, 40, 13}},
    Row{"CommonYew", {4, 7, 9, 5, 3, 1}},
    Row{"CommonYew1995", {16, 2, 10, 27, 23, 13}},
    Row{"DatePalm", {16, 28, 1, 7, 35, 9}},
    Row{"DeodarCedar", {22, 9, 28, 32, 5, 24}},
    Row{"DeodarCedar1995", {40, 13, 10, 20, 4, 34}},
    Row{"DouglasFir", {8, 9, 1, 6, 5, 10}},
    Row{"DouglasFir1995", {19, 13, 10, 20, 6, 34}},
    Row{"EasternCottonwood", {6, 5, 1, 4, 3, 7}},
    Row{"EasternCottonwood1995", {15, 34, 38, 36, 40, 13}},
    Row{"EasternWhitePine", {20, 9, 28, 36, 4, 13}},
    Row{"EasternWhitePine1995", {1, 31, 33, 10, 6, 13}},
    Row{"EnglishOak", {35, 26, 8, 21, 16, 22}},
    Row{"EnglishOak1995", {23, 34, 38, 36, 31, 13}},
    Row{"EuropeanBeech", {40, 19, 32, 2, 27, 26}},
    Row{"EuropeanBeech1995", {40, 22, 10, 2, 30, 13}},
    Row{"EuropeanLarch", {37, 9, 17, 29, 26, 23}},
    Row{"EuropeanLarch1995", {19, 31, 10, 20, 6, 13}},
    Row{"FanPalm", {13, 38, 19, 40, 5, 12}},
    Row{"FieldElm", {9, 5, 10, 1, 7, 8}},
    Row{"FieldElm1995", {23, 20, 36, 19, 7, 13}},
    Row{"GiantSequoia", {8, 9, 1, 10, 2, 6}},
    Row{"GiantSequoia1995", {1, 13, 33, 10, 23, 34}},
    Row{"Ginkgo", {10, 9, 35, 28, 19, 23}},
    Row{"Ginkgo1995", {1, 13, 36, 24, 32, 34}},
    Row{"Hawthorn", {3, 5, 12, 38, 13, 29}},
    Row{"Hawthorn1995", {19, 34, 38, 25, 23, 13}},
    Row{"HoneyLocust", {6, 5, 1, 8, 9, 10}},
    Row{"HoneyLocust1995", {16, 2, 9, 21, 15, 13}},
    Row{"Hornbeam", {25, 5, 32, 8, 6, 26}},
    Row{"Hornbeam1995", {23, 13, 10, 18, 14, 34}},
    Row{"HorseChestnut", {10, 19, 4, 25, 24, 20}},
    Row{"HorseChestnut1995", {19, 13, 10, 21, 22, 34}},
    Row{"ItalianCypress", {4, 5, 1, 10, 9, 6}},
    Row{"ItalianCypress1995", {1, 13, 10, 22, 26, 34}},
    Row{"Jacaranda", {2, 5, 10, 1, 8, 9}},
    Row{"Jacaranda1995", {25, 13, 33, 31, 37, 34}},
    Row{"JapaneseMaple", {38, 3, 24, 12, 13, 10}},
    Row{"JapaneseMaple1995", {40, 34, 33, 35, 37, 13}},
    Row{"JoshuaTree", {6, 20, 28, 3, 18, 26}},
    Row{"LebanonCedar", {35, 19, 15, 18, 3, 26}},
    Row{"LebanonCedar1995", {1, 22, 33, 20, 30, 13}},
    Row{"LiveOak", {6, 5, 34, 10, 23, 15}},
    Row{"LiveOak1995", {40, 3, 33, 15, 24, 13}},
    Row{"LombardyPoplar", {7, 9, 32, 21, 34, 11}},
    Row{"LombardyPoplar1995", {23, 13, 36, 27, 38, 34}},
    Row{"LondonPlane", {40, 5, 4, 28, 34, 32}},
    Row{"LondonPlane1995", {23, 20, 38, 4, 29, 13}},
    Row{"NorwayMaple", {2, 5, 30, 38, 18, 7}},
    Row{"NorwayMaple1995", {40, 13, 33, 21, 22, 34}},
    Row{"NorwaySpruce", {18, 9, 28, 12, 5, 11}},
    Row{"NorwaySpruce1995", {19, 13, 10, 29, 6, 34}},
    Row{"OliveTree", {22, 26, 11, 30, 16, 10}},
    Row{"OliveTree1995", {18, 28, 33, 26, 23, 25}},
    Row{"OrchardApple", {8, 38, 15, 21, 5, 35}},
    Row{"OrchardApple1995", {3, 24, 10, 36, 23, 13}},
    Row{"QuakingAspen", {19, 13, 10, 8, 14, 34}},
    Row{"RainTree", {8, 7, 4, 10, 9, 1}},
    Row{"RainTree1995", {23, 34, 6, 29, 24, 13}},
    Row{"RedOak", {8, 5, 28, 29, 31, 39}},
    Row{"RedOak1995", {23, 34, 36, 8, 15, 13}},
    Row{"Rowan", {9, 3, 10, 28, 19, 26}},
    Row{"Rowan1995", {40, 13, 33, 30, 31, 34}},
    Row{"Saguaro", {6, 10, 25, 23, 39, 20}},
    Row{"Sassafras", {1, 31, 33, 10, 18, 23}},
    Row{"ScotsPine", {6, 5, 28, 32, 34, 16}},
    Row{"ScotsPine1995", {1, 13, 33, 40, 26, 34}},
    Row{"SilverBirch", {10, 9, 28, 36, 31, 18}},
    Row{"SilverBirch1995", {40, 13, 33, 8, 31, 34}},
    Row{"SmallLeavedLinden", {22, 2, 30, 35, 27, 26}},
    Row{"SmallLeavedLinden1995", {19, 31, 10, 18, 38, 13}},
    Row{"SouthernMagnolia", {2, 9, 1, 10, 3, 7}},
    Row{"SouthernMagnolia1995", {1, 34, 10, 20, 23, 13}},
    Row{"StonePine", {2, 3, 1, 8, 4, 5}},
    Row{"StonePine1995", {23, 13, 38, 20, 4, 34}},
    Row{"SugarMaple", {31, 19, 8, 30, 6, 25}},
    Row{"SugarMaple1995", {40, 13, 33, 21, 31, 34}},
    Row{"SweetChestnut", {37, 5, 30, 2, 9, 13}},
    Row{"SweetChestnut1995", {1, 21, 36, 8, 31, 13}},
    Row{"Sweetgum", {6, 9, 28, 35, 4, 40}},
    Row{"Sweetgum1995", {23, 13, 33, 24, 26, 34}},
    Row{"TreeFern", {5, 3, 4, 30, 23, 8}},
    Row{"TulipTree", {37, 9, 28, 29, 4, 25}},
    Row{"TulipTree1995", {23, 13, 38, 8, 22, 34}},
    Row{"UmbrellaAcacia", {33, 23, 5, 18, 2, 7}},
    Row{"WeepingWillow", {27, 5, 28, 12, 9, 8}},
    Row{"WeepingWillow1995", {1, 13, 33, 19, 34, 31}},
    Row{"WhiteWillow", {7, 5, 4, 1, 9, 3}},
    Row{"WhiteWillow1995", {16, 31, 9, 18, 1, 13}},
    Row{"WildCherry", {17, 9, 1, 18, 3, 6}},
    Row{"WildCherry1995", {1, 13, 38, 8, 31, 34}},
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
