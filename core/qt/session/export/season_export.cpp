#include "core/qt/session/export/season_export.h"

#include "core/params/source_facts.h"
#include "core/surface/season/foliage_on_day.h"
#include "core/surface/season/phenology.h"
#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace ramure {
namespace {

/// How bright an average leaf is, of the brightest.
constexpr float meanTone = 0.82F;

struct State
{
    const char* name;
    double day;
};

std::array<State, 4> statesOf(LeafShape shape, SeasonClimate climate)
{
    const YearDates dates =
        datesOf(plantYear(shape), climateOf(climate)).value_or(YearDates{100.0, 140.0, 300.0, 310.0, 340.0});
    return {{{"spring", dates.burst + 0.6 * (dates.unfolded - dates.burst)},
             {"summer", 200.0},
             {"autumn", dates.turned + 5.0},
             {"winter", 20.0}}};
}

} // namespace

TreeSeasons seasonsOf(ExportScene& out, const Foliage& placed, const Skeleton& skeleton,
                      const NodeParams& params)
{
    ExportSeasons leaves, fruit;
    for (const State& state : statesOf(placed.form.shape, params.season.climate)) {
        SeasonParams season = params.season;
        season.day = state.day;
        const Foliage now = foliageOnDay(placed, skeleton, season, trunkRadius(params));
        Material leaf = leavesMaterial(now, params.leafPictures);
        leaf.name.append("_").append(state.name);
        leaf.colour = glm::u8vec3(glm::min(now.meanColour / meanTone + 0.5F, glm::vec3(255.0F)));
        leaf.hidden = 3 * now.leaves.size() < placed.leaves.size();
        leaves.variants.push_back({state.name, materialIn(out, leaf)});
        Material apple = applesMaterial(placed.fruit.kind, params.fruitPictures);
        apple.name.append("_").append(state.name);
        apple.hidden = now.apples.empty() || now.fruit.kind != placed.fruit.kind;
        fruit.variants.push_back({state.name, materialIn(out, apple)});
    }
    leaves.phases = leafPhases(placed, skeleton);
    return {std::make_shared<const ExportSeasons>(std::move(leaves)),
            std::make_shared<const ExportSeasons>(std::move(fruit))};
}

void tellSeasons(ExportScene& out, const std::string& suffix, const TreeSeasons& seasons)
{
    const auto tell = [&](auto& all) {
        for (auto& each : all) {
            const auto& own = each.name == "leaves" + suffix ? seasons.leaves : seasons.fruit;
            if (!own || (each.name != "leaves" + suffix && each.name != "fruit" + suffix))
                continue;
            each.seasons = own;
            each.material = own->variants[1].material;
        }
    };
    tell(out.meshes);
    tell(out.copies);
}

} // namespace ramure
