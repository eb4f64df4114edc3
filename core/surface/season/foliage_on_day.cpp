#include "core/surface/season/foliage_on_day.h"

#include "core/base/parallel.h"
#include "core/params/source_facts.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/season/crown_place.h"
#include "core/surface/season/fruit_on_day.h"
#include "core/surface/season/leaf_palette.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {
namespace {

constexpr std::size_t leavesAtOnce = 4096;
/// Shares of the time that a leaf takes to unfold: so long before it a bud swells; so long does a leaf grow
/// darker afterwards.
constexpr float swelling = 0.6F, darkening = 1.0F;
/// Length of a bud just before it bursts, of the leaf's.
constexpr float budLength = 0.16F;
constexpr glm::vec3 budColour(0x6B, 0x4C, 0x33);
/// Days: half the time between the first and the last leaf that bursts or turns; what one leaf needs to turn,
/// and to wither where it does not fall.
constexpr float burstSpread = 4.0F, turnSpread = 11.0F, turning = 15.0F, withering = 24.0F;

float smooth(float x)
{
    const float u = std::clamp(x, 0.0F, 1.0F);
    return u * u * (3.0F - 2.0F * u);
}

/// Where a leaf stands in its life. Size 0: it is not there.
struct LeafState
{
    float size = 1.0F, age = leafGrown;
    bool isBud = false, isToCome = false;
};

/// Even between 0 and 1 where the two numbers are: the sum of 0.6 of the one and 0.4 of the other, looked up
/// in its distribution.
float evenSum(float most, float least)
{
    const float x = 0.6F * most + 0.4F * least;
    if (x < 0.4F)
        return x * x / 0.48F;
    return x > 0.6F ? 1.0F - (1.0F - x) * (1.0F - x) / 0.48F : (x - 0.2F) / 0.6F;
}

/// Leaves of one plant in its climate on one day.
class LeafDay
{
public:
    LeafDay(const PlantYear& plant, const LeafRow& row, const YearDates& dates, double day)
        : m_plant(plant)
        , m_dates(dates)
        , m_isEvergreen(row.evergreen)
        , m_dropsInAutumn(row.family == LeafFamily::Shoot || row.shape == LeafShape::Cypress)
        , m_day(static_cast<float>(day))
        , m_burst(static_cast<float>(dates.burst))
        , m_unfolds(static_cast<float>(dates.unfolded - dates.burst))
        , m_turned(static_cast<float>(dates.turned))
    {
    }

    [[nodiscard]] LeafState of(float light, float phase, const Lots& lots) const
    {
        return m_isEvergreen ? evergreen(light, phase, lots) : deciduous(light, phase, lots);
    }

private:
    [[nodiscard]] LeafState deciduous(float light, float phase, const Lots& lots) const
    {
        const bool stays = lots[2] < m_plant.keeps * (1.5F - light);
        // Twigs inside wake first.
        const float burst = m_burst + burstSpread * (0.8F * light + 0.6F * lots[1] - 0.7F);
        const float opened = (m_day - burst) / m_unfolds;
        if (opened < 0.0F) {
            if (stays && opened < -0.1F)
                return {0.94F, leafWithered, false};
            if (opened < -swelling)
                return {0.0F, 0.0F, false, true};
            return {budLength * (0.4F + 0.6F * (1.0F + opened / swelling)), 0.0F, true};
        }
        LeafState state = growing(opened);
        const float turn = m_turned + turnSpread * (2.0F * phase - 1.0F) - 0.5F * turning;
        if (m_day <= turn)
            return state;
        const float gone = m_day - turn;
        state.age = gone < turning ? leafGrown + gone / turning
                                   : leafTurned + std::min((gone - turning) / withering, 1.0F);
        if (!stays && m_day >= fallOf(phase, lots))
            state.size = 0.0F;
        return state;
    }
    /// The oldest needles, which stand inside, turn and fall; what stands outside is young in spring.
    [[nodiscard]] LeafState evergreen(float light, float phase, const Lots& lots) const
    {
        LeafState state;
        if (!(m_plant.needleYears > 0.0))
            return state;
        const float opened = (m_day - m_burst - burstSpread * (2.0F * lots[1] - 1.0F)) / m_unfolds;
        const bool isOld = lots[2] * m_plant.needleYears < 1.6F * (1.0F - light);
        if (isOld) {
            const float from = m_dropsInAutumn ? m_turned - 40.0F : m_burst + m_unfolds;
            const float turn = from + turnSpread * (2.0F * phase - 1.0F);
            const float gone = m_day - turn;
            if (opened < 0.0F || gone > 2.0F * turning) // new ones take their place in spring
                state.size = m_dropsInAutumn || gone > 2.0F * turning ? 0.0F : 1.0F;
            else if (gone > 0.0F)
                state.age = std::min(leafGrown + gone / turning, leafWithered);
            else if (m_dropsInAutumn && opened < 1.0F)
                return growing(opened);
            return state;
        }
        const float fresh = std::clamp(2.2F * (light - 0.55F), 0.0F, 1.0F);
        if (opened > 0.0F && opened < 1.0F + 2.0F * darkening) {
            const float tender =
                smooth(3.0F * opened) * (1.0F - smooth((opened - 0.6F) / (2.0F * darkening)));
            state.age = leafGrown - 0.9F * fresh * tender;
        }
        return state;
    }
    /// \param opened days since its bud burst, of those that it takes to unfold
    [[nodiscard]] static LeafState growing(float opened)
    {
        LeafState state;
        state.size = opened < 1.0F ? glm::mix(budLength, 1.0F, smooth(0.08F + 0.92F * opened)) : 1.0F;
        state.age = opened < 1.0F ? opened : std::min(1.0F + (opened - 1.0F) / darkening, leafGrown);
        return state;
    }
    /// A tenth of the leaves has fallen on the first date, nine tenths on the second.
    [[nodiscard]] float fallOf(float phase, const Lots& lots) const
    {
        const float order = evenSum(lots[3], phase);
        return static_cast<float>(m_dates.firstFall) +
               static_cast<float>(m_dates.lastFall - m_dates.firstFall) * (order - 0.1F) / 0.8F;
    }

    PlantYear m_plant;
    YearDates m_dates;
    bool m_isEvergreen, m_dropsInAutumn;
    float m_day, m_burst, m_unfolds, m_turned;
};

/// The colours of leaves; of evergreens those of their plant, whose wax and hairs no pigment knows, as far as
/// pigments change.
class LeafPaint
{
public:
    LeafPaint(const LeafRow& row, const SeasonParams& season)
        : m_palette(paletteOf(row.shape, season))
    {
        if (row.evergreen && !season.purple)
            m_own = glm::vec3(row.colour) / m_palette->at(leafGrown, 0.5F).reflected;
    }
    [[nodiscard]] LeafColours of(const LeafState& state, float light) const
    {
        if (state.isBud)
            return {budColour, glm::vec3(0.0F)};
        LeafColours colours = m_palette->at(state.age, light);
        colours.reflected = glm::min(m_own * colours.reflected, glm::vec3(255.0F));
        colours.transmitted = glm::min(m_own * colours.transmitted, glm::vec3(255.0F));
        return colours;
    }

private:
    std::shared_ptr<const LeafPalette> m_palette;
    glm::vec3 m_own{1.0F};
};

/// Half of the difference between one leaf and the next stays: pigments bring the other half.
float brightness(const FoliageItem& leaf)
{
    return 0.5F + 0.5F * leaf.tone / 0.84F;
}

/// What one chunk of the leaves adds up to.
struct Sum
{
    glm::dvec3 reflected{0.0}, transmitted{0.0};
    std::size_t count = 0, toCome = 0;
};

void paintLeaves(const std::vector<LeafPhase>& phases, const LeafDay& day, const LeafPaint& paint,
                 Foliage& out)
{
    const std::size_t count = out.leaves.size();
    std::vector<Sum> sums((count + leavesAtOnce - 1) / leavesAtOnce);
    parallelFor(count, leavesAtOnce, [&](std::size_t begin, std::size_t end) {
        Sum& own = sums[begin / leavesAtOnce];
        for (std::size_t i = begin; i < end; ++i) {
            FoliageItem& leaf = out.leaves[i];
            const LeafState state = day.of(phases[i].light, phases[i].phase, Lots(phases[i].lots));
            leaf.size *= state.size;
            own.toCome += state.isToCome ? 1 : 0;
            if (state.size <= 0.0F)
                continue;
            const LeafColours colours = paint.of(state, phases[i].light);
            leaf.tint = glm::min(brightness(leaf) / 255.0F * colours.reflected * leaf.tint, glm::vec3(1.0F));
            leaf.tone = 1.0F;
            own.reflected += glm::dvec3(colours.reflected);
            own.transmitted += glm::dvec3(colours.transmitted);
            ++own.count;
        }
    });
    Sum all;
    for (const Sum& each : sums) {
        all.reflected += each.reflected;
        all.transmitted += each.transmitted;
        all.count += each.count;
        all.toCome += each.toCome;
    }
    if (all.count > 0) {
        out.meanColour = glm::vec3(all.reflected / double(all.count));
        out.meanThrough = glm::vec3(all.transmitted / double(all.count));
    }
    out.toCome = all.toCome;
    if (all.count < count)
        out.shed = std::erase_if(out.leaves, [](const FoliageItem& leaf) { return leaf.size <= 0.0F; });
}

} // namespace

Foliage foliageOnDay(const Foliage& placed, const Skeleton& skeleton, const SeasonParams& season,
                     double alpha)
{
    if (placed.form.shape == LeafShape::Faithful)
        return placed;
    const LeafRow& row = leafRow(placed.form.shape);
    const PlantYear& plant = plantYear(placed.form.shape);
    if (row.evergreen && !(plant.needleYears > 0.0))
        return placed; // nothing is seen of its year
    Foliage out;
    out.form = placed.form;
    out.fruit = placed.fruit;
    out.form.onDay = true;
    // Where there is no winter, it is always summer.
    const YearDates summer{-1e6, -1e6 + 30.0, 1e6, 1e6, 2e6};
    const std::optional<YearDates> dates = datesOf(plant, climateOf(season.climate));
    out.leaves = placed.leaves;
    const bool hasPhases = placed.phases && placed.phases->size() == placed.leaves.size();
    const auto phases = hasPhases
                            ? placed.phases
                            : std::make_shared<const std::vector<LeafPhase>>(phasesOf(placed, skeleton));
    paintLeaves(*phases, LeafDay(plant, row, dates.value_or(summer), season.day), LeafPaint(row, season),
                out);
    if (!row.evergreen)
        out.fallenColour = paletteOf(row.shape, season)->at(leafTurned, 0.5F).reflected;
    if (dates && !row.evergreen)
        fruitOnDay(placed, skeleton, plant, *dates, season.day, alpha, out);
    else
        out.apples = placed.apples;
    return out;
}

Expected<Foliage> placedFoliage(const Skeleton& skeleton, const NodeParams& params, const Progress& progress)
{
    LeafParams leaf = params.leaf;
    if (hasDay(params.season))
        leaf.season = 0.0;
    auto placed = placeFoliage(skeleton, params.foliage, leaf, params.fruit, trunkRadius(params), progress);
    if (placed && params.leaf.shape != LeafShape::Faithful) // it may get a day later
        placed->phases = std::make_shared<const std::vector<LeafPhase>>(phasesOf(*placed, skeleton));
    return placed;
}

Expected<Foliage> foliageOf(const Skeleton& skeleton, const NodeParams& params, const Progress& progress)
{
    auto placed = placedFoliage(skeleton, params, progress);
    if (!placed || !hasDay(params.season))
        return placed;
    return foliageOnDay(*placed, skeleton, params.season, trunkRadius(params));
}

std::vector<float> leafPhases(const Foliage& foliage, const Skeleton& skeleton)
{
    std::vector<float> phases;
    phases.reserve(foliage.leaves.size());
    for (const LeafPhase& each : phasesOf(foliage, skeleton))
        phases.push_back(each.phase);
    return phases;
}

} // namespace ramure
