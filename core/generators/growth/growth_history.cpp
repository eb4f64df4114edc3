#include "core/generators/growth/growth_history.h"

#include "core/generators/growth/growing_tree.h"
#include "core/generators/growth/palm.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace ramure {
namespace {

using growth::GrowingTree;
using growth::YearFactors;

tl::unexpected<Error> refuse(ErrorCode code, const char* text, const char* path,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().path = path;
    return error;
}

Expected<void> check(const GrowthParams& params)
{
    RAMURE_TRY(checkPart(&NodeParams::growth, params));
    const double voxel = std::max(params.internode, params.height / 80.0);
    const double voxels = params.height * params.crownWidth * params.crownWidth / (voxel * voxel * voxel);
    if (params.habit == GrowthHabit::Branching && voxels > double(ShadowGrid::maxVoxels))
        return refuse(
            ErrorCode::Limit,
            RAMURE_NOOP("the crown is too wide for its height: its shadows need more than %1 voxels"),
            "growth.crownWidth", {std::to_string(ShadowGrid::maxVoxels)});
    return {};
}

/// lambda is a switch: below 0.5 the trunk ends low, above it goes to the top. So it falls through 0.5 within
/// four years of the one that the artist names.
YearFactors factorsOf(const GrowthParams& p, int year)
{
    YearFactors f;
    f.year = year;
    f.shade = (0.13 - 0.11 * p.shadeTolerance) / std::sqrt(p.density);
    const double lost = std::clamp((double(year) - p.leaderUntil) / 4.0, 0.0, 1.0);
    f.trunkLambda = 0.54 - 0.08 * lost;
    f.limbLambda = 0.44 + 0.11 * p.apicalControl;
    const double youth = 2.0 * p.height / p.maturity / p.internode;
    f.longest = std::max(1.0, youth * (0.45 + 0.55 * maths::exp(-double(year) / p.maturity)));
    double side = f.longest;
    for (double& longest : f.sideLongest) {
        longest = side;
        side *= p.sideLength;
    }
    f.claim = f.longest * (1.0 - lost);
    // The leaves of a crown are its surface: about as many shoots a year as it has places in the sun.
    const double grown = 1.0 - maths::exp(-2.0 * double(year + 1) / p.maturity);
    const double places = std::numbers::pi * p.height * p.crownWidth / (p.internode * p.internode);
    f.vigourCap =
        std::max(f.longest, std::min(0.2 * p.density * places * grown * std::sqrt(grown), 200'000.0));
    return f;
}

/// A moment before their age their axes stand, or they miss them.
void noteCutsOfPalm(GrowthHistory& history, int age)
{
    for (std::size_t c = 0; c < history.cuts.size(); ++c) {
        if (history.cuts[c].age != age)
            continue;
        const Skeleton palm = palmAtAge(history.params, history.seed, double(age) - 1e-6, history.cuts);
        history.isMade[c] = std::ranges::any_of(
            palm.axisStarts, [&](const auto& start) { return start.second == history.cuts[c].axis; });
    }
}

} // namespace

std::uint16_t packedPipes(float pipes)
{
    constexpr std::uint32_t one = 0x3F800000u;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::max(pipes, 1.0f)) - one;
    return std::uint16_t(std::min(bits >> 12, 0xFFFFu));
}

float pipesOf(std::uint16_t packed)
{
    return std::bit_cast<float>((std::uint32_t(packed) << 12) + 0x3F800000u);
}

glm::dvec3 GrowthHistory::footOf(Index root) const
{
    const auto named = std::ranges::find(feet, root, &std::pair<Index, glm::dvec3>::first);
    return named == feet.end() ? glm::dvec3(0.0) : named->second;
}

std::size_t GrowthHistory::bytes() const
{
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return of(parent) + of(axis) + of(birth) + of(death) + of(direction) + of(length) + of(axisAddress) +
           of(axisOrder) + of(rowStart) + of(pipes) + of(bends) + of(years) + of(withered);
}

struct GrowthRun::State
{
    State(const GrowthParams& params, std::uint64_t seed, GrowthCuts cuts)
        : history(seedOf(params, seed, std::move(cuts)))
        , tree(history, seed)
    {
    }
    static GrowthHistory seedOf(const GrowthParams& params, std::uint64_t seed, GrowthCuts cuts)
    {
        GrowthHistory history;
        history.params = params;
        history.seed = seed;
        history.isMade.assign(cuts.size(), false);
        history.cuts = std::move(cuts);
        history.rowStart = {0, 0}; // nothing stands at age 0
        return history;
    }
    GrowthHistory history;
    GrowingTree tree;
    std::optional<GrowthRun> uncut; ///< where there are cuts: what the others live like
    int yearsBefore = 0;            ///< of what stood when it began
    bool follows = false;           ///< something was cut
    int dark = 0;                   ///< years without light
};

GrowthRun::GrowthRun(std::unique_ptr<State> state)
    : m_state(std::move(state))
{
}
GrowthRun::GrowthRun(GrowthRun&& other) noexcept = default;
GrowthRun& GrowthRun::operator=(GrowthRun&& other) noexcept = default;
GrowthRun::~GrowthRun() = default;

Expected<GrowthRun> GrowthRun::begin(const GrowthParams& params, std::uint64_t seed, GrowthCuts cuts,
                                     const Progress& progress)
{
    if (auto checked = check(params); !checked)
        return fail(std::move(checked.error()));
    std::erase_if(cuts, [](const GrowthCut& cut) { return !std::isfinite(cut.share); });
    auto state = std::make_unique<State>(params, seed, std::move(cuts));
    if (auto found = state->tree.findRoom(progress); !found)
        return fail(std::move(found.error()));
    if (!state->history.cuts.empty()) {
        auto uncut = begin(params, seed, {}, progress);
        RAMURE_TRY(uncut);
        state->uncut.emplace(std::move(*uncut));
    }
    return GrowthRun(std::move(state));
}

Expected<GrowthRun> GrowthRun::goOn(const Skeleton& tree, const TreeAxes& axes, int yearsBefore,
                                    const GrowthParams& params, std::uint64_t seed)
{
    auto run = begin(params, seed);
    RAMURE_TRY(run);
    run->m_state->yearsBefore = yearsBefore;
    run->m_state->tree.stand(tree, axes);
    return run;
}

Expected<void> GrowthRun::growTo(double age, const Progress& progress)
{
    GrowthHistory& history = m_state->history;
    GrowingTree& tree = m_state->tree;
    history.params.age = age;
    if (auto checked = check(history.params); !checked)
        return checked;
    constexpr int starves = 3; // years without light
    const int years = int(std::ceil(age));
    if (m_state->uncut)
        if (auto grown = m_state->uncut->growTo(age, progress.part(0.0, 0.5)); !grown)
            return grown;
    for (int year = history.grownYears(); year < years && history.diedAt == 0; ++year) {
        if (history.params.habit == GrowthHabit::Palm) { // palm.h draws it
            history.years.push_back({.light = history.params.sunlight});
            history.diedAt = history.params.sunlight <= 0.0 && year + 1 >= starves ? year + 1 : 0;
            noteCutsOfPalm(history, year + 1);
            continue;
        }
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        if (m_state->follows)
            tree.follow(m_state->uncut->history());
        YearFactors factors = factorsOf(history.params, year + m_state->yearsBefore);
        factors.year = year;
        if (!tree.gatherLight(factors))
            return refuse(ErrorCode::Limit, RAMURE_NOOP("the crown's shadows need more than %1 voxels"),
                          "growth.internode", {std::to_string(ShadowGrid::maxVoxels)});
        m_state->dark = year > 0 && tree.seen().light <= 0.0 ? m_state->dark + 1 : 0;
        tree.shareVigour(factors);
        tree.growShoots(factors);
        const bool isCut = tree.cut(year + 1);
        tree.shed(factors);
        if (m_state->dark >= starves || tree.empty()) {
            tree.die(year + 1);
            history.diedAt = year + 1;
        }
        tree.thicken(factors);
        tree.record();
        m_state->follows = m_state->follows || isCut;
        if (history.parent.size() > maxMetamers)
            return refuse(ErrorCode::Limit, RAMURE_NOOP("the tree bears more pieces than the limit of %1"),
                          "growth.density", {std::to_string(maxMetamers)});
        progress.report(double(year + 1) / double(years));
    }
    return {};
}

const GrowthHistory& GrowthRun::history() const
{
    return m_state->history;
}

GrowthHistory GrowthRun::take() &&
{
    return std::move(m_state->history);
}

Expected<GrowthHistory> growHistory(const GrowthParams& params, std::uint64_t seed, const GrowthCuts& cuts,
                                    const Progress& progress)
{
    auto run = GrowthRun::begin(params, seed, cuts, progress);
    RAMURE_TRY(run);
    if (auto grown = run->growTo(params.age, progress); !grown)
        return fail(std::move(grown.error()));
    return std::move(*run).take();
}

Expected<GrowthHistory> growHistory(const GrowthParams& params, std::uint64_t seed, const Progress& progress)
{
    return growHistory(params, seed, {}, progress);
}

} // namespace ramure
