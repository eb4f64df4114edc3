// Signs of how a tree lives: it is grown again on other sites, and cut.
#include "core/generators/growth/grown_skeleton.h"
#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/signs/sign_rows.h"
#include "core/skeleton/axes.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace ramure::signs {
namespace {

constexpr double leanAngle = 30.0 * oneDegree; ///< of the seedling
constexpr double uprightAgain = 10.0 * oneDegree;
constexpr int mostLeanYears = 30;
constexpr double cutYears = 4.0;   ///< how long ago the limb is cut
constexpr double nearCut = 0.3;    ///< m, of shoots at the wound
constexpr double latestAge = 40.0; ///< years: what answers at all has done it by then

/// The same tree on level ground in calm air and light from all sides, alone.
GrowthParams undisturbed(const GrowthParams& params)
{
    GrowthParams out = params;
    out.wind = out.sideLight = out.slope = out.lean = 0.0;
    out.lightDirection = 0.0;
    out.neighbours = false;
    out.space = {};
    out.age = std::min(params.age, latestAge);
    return out;
}

Expected<Skeleton> grown(const GrowthParams& params, std::uint64_t seed, const Progress& progress)
{
    const auto history = growHistory(params, seed, progress);
    RAMURE_TRY(history);
    return skeletonAtAge(*history, params.age);
}

/// m, the middle of the wood, seen from above.
glm::dvec2 middleOf(const Skeleton& tree)
{
    glm::dvec2 sum(0.0);
    double length = 0.0;
    for (Index i = 0; i < tree.size(); ++i) {
        const double own = tree.length(i);
        const glm::dvec3 at = own * 0.5 * (tree.p0[i] + tree.p1[i]);
        sum += glm::dvec2(at.x, at.z);
        length += own;
    }
    return length > 0.0 ? sum / length : sum;
}

/// m, of the crown that nine ends of ten are within.
double crownRadius(const Skeleton& tree)
{
    const glm::dvec2 middle = middleOf(tree);
    std::vector<double> away;
    for (const glm::dvec3& end : tree.p1)
        away.push_back(glm::length(glm::dvec2(end.x, end.z) - middle));
    if (away.empty())
        return 0.0;
    const auto most = away.begin() + std::ptrdiff_t(9 * away.size() / 10);
    std::ranges::nth_element(away, most);
    return *most;
}

/// In the open crowns stand over their stems, on the mean of some seeds.
Expected<void> addLight(Rows& rows, const GrowthParams& params, std::uint64_t seed, const Progress& progress)
{
    TreeSign balance{"balance", "crown in the open",
                     "",        {},
                     0.0,       0.0,
                     0.03,      "its middle from the stem, in radii of the crown; mean place of eight seeds"};
    TreeSign response{"lightResponse",
                      "light from one side",
                      "",
                      {},
                      0.0,
                      0.15,
                      std::numeric_limits<double>::infinity(),
                      "how far the crown's middle goes there, in its radii"};
    GrowthParams sided = params;
    sided.sideLight = 1.0;
    const auto lit = grown(sided, seed, progress.part(0.0, 0.2));
    RAMURE_TRY(lit);
    constexpr int seeds = 8;
    glm::dvec2 mean(0.0), own(0.0);
    double radius = 0.0;
    for (int i = 0; i < seeds; ++i) {
        const auto open = grown(params, seed + std::uint64_t(i), progress.part(0.2 + 0.1 * i, 0.3 + 0.1 * i));
        RAMURE_TRY(open);
        const double wide = crownRadius(*open);
        mean += wide > 0.0 ? middleOf(*open) / (wide * seeds) : glm::dvec2(0.0);
        own = i == 0 ? middleOf(*open) : own;
        radius = i == 0 ? wide : radius;
    }
    if (lit->empty() || !(radius > 0.0)) {
        rows.push_back(absent(std::move(balance), "no crown"));
        rows.push_back(absent(std::move(response), "no crown"));
        return {};
    }
    rows.push_back(measured(std::move(balance), glm::length(mean)));
    rows.push_back(measured(std::move(response), (middleOf(*lit).x - own.x) / radius));
    return {};
}

/// rad, of the upper end of the stem from the vertical; of the highest stem where there are several.
double leanOf(const Skeleton& tree)
{
    Index top = noIndex;
    for (Index i = 0; i < tree.size(); ++i)
        if (tree.level[i] == 0 && (top == noIndex || tree.p1[i].y > tree.p1[top].y))
            top = i;
    const double length = top == noIndex ? 0.0 : tree.length(top);
    return length > 0.0 ? maths::acos(std::clamp((tree.p1[top].y - tree.p0[top].y) / length, -1.0, 1.0))
                        : 0.0;
}

Expected<void> addLean(Rows& rows, GrowthParams params, std::uint64_t seed, const Progress& progress)
{
    TreeSign sign{"leanRecovery",
                  "leaning stem turns up",
                  "years",
                  {},
                  0.0,
                  3.0,
                  6.0,
                  "until the shoots of a seedling that leans 30 degrees stand upright"};
    params.lean = leanAngle;
    params.age = mostLeanYears;
    const auto history = growHistory(params, seed, progress);
    RAMURE_TRY(history);
    for (int year = 1; year <= mostLeanYears; ++year)
        if (leanOf(skeletonAtAge(*history, double(year))) <= uprightAgain) {
            rows.push_back(measured(std::move(sign), double(year)));
            return {};
        }
    sign.note = "not within 30 years";
    rows.push_back(measured(std::move(sign), double(mostLeanYears)));
    return {};
}

/// The thickest limb of a trunk: its axis, or noIndex.
Index thickestLimb(const TreeAxes& axes)
{
    Index best = noIndex;
    for (Index a = 0; a < axes.axes.size(); ++a)
        if (const Axis& axis = axes.axes[a]; axis.order == 1)
            best = best == noIndex || axis.radius > axes.axes[best].radius ? a : best;
    return best;
}

/// What is published: many shoots at cuts of some, none of spruces.
TreeSign epicormicSign(std::string_view latin)
{
    TreeSign sign{"epicormic", "shoots at a cut", "", SignState::NoBand, 0.0};
    sign.note = "out of sleeping buds within 0.3 m of where the thickest limb was cut, in four years";
    for (const std::string_view genus : {"Salix", "Quercus", "Tilia", "Platanus"})
        if (latin.starts_with(genus)) {
            sign.low = 1.0;
            sign.state = SignState::Outside;
        }
    if (latin.starts_with("Picea")) {
        sign.high = 0.0;
        sign.state = SignState::Outside;
    }
    return sign;
}

/// The addresses of shoots since an age that came out of wood of more than a year before: of buds that slept.
std::set<std::uint64_t> fromOldWood(const GrowthHistory& history, int since)
{
    std::set<std::uint64_t> out;
    for (Index i = 0; i < history.size(); ++i)
        if (const Index below = history.parent[i];
            below != noIndex && history.axis[below] != history.axis[i] && int(history.birth[i]) >= since &&
            history.birth[i] >= history.birth[below] + 2)
            out.insert(history.axisAddress[history.axis[i]]);
    return out;
}

/// \param params of the age at which the shoots are counted
Expected<void> addCutShoots(Rows& rows, const GrowthParams& params, std::uint64_t seed,
                            std::string_view latin, const Progress& progress)
{
    TreeSign sign = epicormicSign(latin);
    const double cutAge = std::floor(params.age - cutYears);
    const auto whole = growHistory(params, seed, progress.part(0.0, 0.5));
    RAMURE_TRY(whole);
    const Skeleton before = cutAge >= 1.0 ? skeletonAtAge(*whole, cutAge) : Skeleton();
    const TreeAxes axes = axesOf(before);
    const Index limb = thickestLimb(axes);
    if (limb == noIndex) {
        rows.push_back(absent(std::move(sign), "no limb to cut"));
        return {};
    }
    GrowthCut cut;
    cut.axis = axes.axes[limb].address;
    cut.share = 0.4;
    cut.age = int(cutAge);
    const auto answered = growHistory(params, seed, {cut}, progress.part(0.5, 1.0));
    RAMURE_TRY(answered);
    const Skeleton after = skeletonAtAge(*answered, params.age);
    const TreeAxes now = axesOf(after);
    const auto stump = std::ranges::find(now.axes, cut.axis, &Axis::address);
    if (stump == now.axes.end()) {
        rows.push_back(absent(std::move(sign), "the stump died back"));
        return {};
    }
    const std::set<std::uint64_t> sleepers = fromOldWood(*answered, cut.age);
    const glm::dvec3 wound = after.p1[now.nodesOf(Index(stump - now.axes.begin())).back()];
    double shoots = 0.0;
    for (Index a = 0; a < now.axes.size(); ++a) {
        const glm::dvec3 foot = after.p0[now.nodesOf(a).front()];
        shoots += sleepers.contains(now.axes[a].address) && glm::length(foot - wound) <= nearCut ? 1.0 : 0.0;
    }
    const bool hasBand = sign.state != SignState::NoBand;
    sign = measured(std::move(sign), shoots);
    sign.state = hasBand ? sign.state : SignState::NoBand;
    rows.push_back(std::move(sign));
    return {};
}

} // namespace

Expected<void> addGrowth(Rows& rows, const NodeParams& params, std::string_view latin,
                         const Progress& progress)
{
    const bool lives =
        params.generator.kind == EditOperation::Growth && params.growth.habit == GrowthHabit::Branching;
    if (!lives) {
        for (const auto& [key, label] :
             std::array<std::pair<const char*, const char*>, 4>{{{"balance", "crown in the open"},
                                                                 {"lightResponse", "light from one side"},
                                                                 {"leanRecovery", "leaning stem turns up"},
                                                                 {"epicormic", "shoots at a cut"}}}) {
            TreeSign sign{key, label};
            sign.note = "of trees that grow by years alone";
            rows.push_back(std::move(sign));
        }
        return {};
    }
    const std::uint64_t seed = treeSeed(params);
    const GrowthParams quiet = undisturbed(params.growth);
    RAMURE_TRY(addLight(rows, quiet, seed, progress.part(0.0, 0.5)));
    RAMURE_TRY(addLean(rows, quiet, seed, progress.part(0.5, 0.7)));
    return addCutShoots(rows, quiet, seed, latin, progress.part(0.7, 1.0));
}

} // namespace ramure::signs
