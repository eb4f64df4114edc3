#include "core/scatter/stand.h"

#include "core/base/index.h"
#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

constexpr double cell = 0.5;            ///< m, of the grid on which the canopy shares out the ground
constexpr double farthest = 1000.0;     ///< m
constexpr double firstDiameter = 0.004; ///< m, of a seedling

constexpr std::array table{
    StandSpecies{"EuropeanBeech", 52.7, 0.0209, 2.45, 0.82, 0.0092, 1.35, 1.80, 52.5, 0.30},
    StandSpecies{"NorwaySpruce", 42.2, 0.0274, 2.01, 0.634, 0.0146, 1.01, 1.510, 32.1, 0.30},
    StandSpecies{"ScotsPine", 33.4, 0.0303, 2.08, 0.530, 0.0167, 1.05, 1.52, 40.0, 0.30},
    StandSpecies{"EnglishOak", 30.9, 0.0286, 1.83, 0.661, 0.0144, 1.40, 1.484, 67.1, 0.30},
    StandSpecies{"DouglasFir", 51.4, 0.0295, 1.94, 0.882, 0.0178, 1.14, 1.866, 31.1, 0.30},
};

double risen(double end, double rate, double shape, double years)
{
    return end * maths::pow(1.0 - maths::exp(-rate * years), shape);
}

struct Living
{
    StandTree tree;
    const StandSpecies* species = nullptr;
    double vigour = 1.0; ///< share of the ground that it needs, over the last years
    double held = 0.0;   ///< m²
    glm::dvec2 middle{0.0};
    double luck = 1.0; ///< how fast it grows by its genes and its soil
};

class Stand
{
public:
    Stand(std::span<const Seedling> seedlings, std::uint64_t seed)
        : m_seed(seed)
    {
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
        for (std::size_t i = 0; i < seedlings.size(); ++i) {
            const glm::dvec2& foot = seedlings[i].foot;
            Random random(seed, RandomStream::Stand, i);
            Living& living = m_trees.emplace_back();
            living.tree.foot = foot;
            living.species = seedlings[i].species;
            living.tree.number = static_cast<std::uint32_t>(i);
            living.tree.diameter = firstDiameter;
            living.tree.height = 0.2;
            living.luck = 0.8 + 0.2 * (random.unit() + random.unit());
            low = glm::dvec2(std::min(low.x, foot.x), std::min(low.y, foot.y));
            high = glm::dvec2(std::max(high.x, foot.x), std::max(high.y, foot.y));
        }
        constexpr double around = 12.0; // crowns at the edge reach out
        m_low = low - around;
        m_columns = static_cast<std::size_t>(std::ceil((high.x - low.x + 2.0 * around) / cell));
        m_rows = static_cast<std::size_t>(std::ceil((high.y - low.y + 2.0 * around) / cell));
    }

    void grow(int year)
    {
        shareOut();
        for (Living& living : m_trees)
            grow(living, year);
        std::erase_if(m_trees, [&](const Living& living) {
            Random random(m_seed, RandomStream::Stand, (std::uint64_t(year) << 32) + living.tree.number);
            return living.vigour < living.species->endurance || random.unit() < byChance;
        });
    }

    [[nodiscard]] std::vector<StandTree> trees() const
    {
        std::vector<StandTree> out;
        for (const Living& living : m_trees) {
            out.push_back(living.tree);
            if (living.held > 0.0)
                out.back().crownOffset = living.middle - living.tree.foot;
        }
        return out;
    }

private:
    static constexpr double byChance = 0.002; ///< share of trees that die in a year for other reasons
    static constexpr double spread = 1.5; ///< radius of a free crown over that of the ground that it needs

    static double needOf(const Living& living)
    {
        return living.species->ground * maths::pow(living.tree.diameter / 0.25, living.species->thinning);
    }

    /// Calls \p act(cell number, its middle, squared share of the crown's radius) for all under a crown.
    template <class Act> void underCrown(const StandTree& tree, Act&& act) const
    {
        const auto first = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::floor(x))); };
        const glm::dvec2 at = (tree.foot - m_low) / cell;
        const double reach = tree.crownRadius / cell;
        const std::size_t right = std::min(m_columns, first(at.x + reach) + 1);
        const std::size_t end = std::min(m_rows, first(at.y + reach) + 1);
        for (std::size_t row = first(at.y - reach); row < end; ++row)
            for (std::size_t column = first(at.x - reach); column < right; ++column) {
                const double x = double(column) + 0.5 - at.x, y = double(row) + 0.5 - at.y;
                const double share = (x * x + y * y) / (reach * reach);
                if (share < 1.0)
                    act(row * m_columns + column,
                        m_low + cell * glm::dvec2(double(column) + 0.5, double(row) + 0.5), share);
            }
    }

    /// Each cell goes to the crown that stands highest over it.
    void shareOut()
    {
        m_top.assign(m_columns * m_rows, 0.0F);
        m_owner.assign(m_columns * m_rows, noIndex);
        for (std::size_t i = 0; i < m_trees.size(); ++i) {
            Living& living = m_trees[i];
            StandTree& tree = living.tree;
            tree.crownRadius = spread * std::sqrt(needOf(living) / pi);
            living.held = 0.0;
            living.middle = glm::dvec2(0.0);
            const double deep = std::min(0.6 * tree.height, 2.0 * tree.crownRadius);
            underCrown(tree, [&](std::size_t at, const glm::dvec2&, double share) {
                const auto top = static_cast<float>(tree.height - deep * share);
                if (top > m_top[at]) {
                    m_top[at] = top;
                    m_owner[at] = static_cast<Index>(i);
                }
            });
        }
        for (std::size_t i = 0; i < m_trees.size(); ++i) {
            Living& living = m_trees[i];
            underCrown(living.tree, [&](std::size_t at, const glm::dvec2& middle, double) {
                if (m_owner[at] != static_cast<Index>(i))
                    return;
                living.held += cell * cell;
                living.middle += cell * cell * middle;
            });
            if (living.held > 0.0)
                living.middle /= living.held;
        }
    }

    static void grow(Living& living, int year)
    {
        StandTree& tree = living.tree;
        const double need = needOf(living);
        const StandSpecies& species = *living.species;
        // A seedling that is smaller than a cell is in nobody's shade yet.
        const double share = need < cell * cell ? 1.0 : std::min(1.2, living.held / need);
        constexpr double memory = 0.8; // of the year before
        living.vigour = memory * living.vigour + (1.0 - memory) * share;
        const auto grown = [year](double end, double rate, double shape) {
            return risen(end, rate, shape, year) - risen(end, rate, shape, year - 1);
        };
        const double wide = grown(species.diameter, species.diameterRate, species.diameterShape);
        const double high = grown(species.topHeight, species.heightRate, species.heightShape);
        const double light = std::min(1.0, living.vigour);
        tree.diameter += living.luck * wide * light;
        tree.height += high * (0.5 + 0.5 * std::sqrt(light)) * (0.85 + 0.15 * living.luck);
        const double open = std::sqrt(std::min(1.0, living.held / std::max(need, cell * cell)));
        tree.crownBase = std::max(tree.crownBase, tree.height * (0.62 - 0.35 * std::max(0.0, open - 0.6)));
    }

    std::uint64_t m_seed;
    glm::dvec2 m_low{0.0};
    std::size_t m_columns = 0, m_rows = 0;
    std::vector<Living> m_trees;
    std::vector<float> m_top;   ///< m, per cell: height of the canopy
    std::vector<Index> m_owner; ///< per cell: which of the trees
};

} // namespace

std::span<const StandSpecies> standSpecies()
{
    return table;
}

const StandSpecies* findStandSpecies(std::string_view name)
{
    const auto found = std::ranges::find(table, name, &StandSpecies::name);
    return found == table.end() ? nullptr : &*found;
}

double topHeightAt(const StandSpecies& species, double years)
{
    return risen(species.topHeight, species.heightRate, species.heightShape, years);
}

Expected<std::vector<StandTree>> grownStand(std::span<const Seedling> seedlings, int years,
                                            std::uint64_t seed, const Progress& progress)
{
    if (years < 1 || years > 400 || seedlings.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a stand has trees, and an age of 1 to 400 years"));
    if (seedlings.size() > mostSeedlings)
        return fail(ErrorCode::Limit, RAMURE_NOOP("a stand is sown with %1 trees at most"),
                    {std::to_string(mostSeedlings)});
    for (const Seedling& seedling : seedlings)
        if (!(std::abs(seedling.foot.x) <= farthest && std::abs(seedling.foot.y) <= farthest))
            return fail(ErrorCode::Limit, RAMURE_NOOP("a stand reaches %1 m from its middle at most"),
                        {std::to_string(int(farthest))});
    Stand stand(seedlings, seed);
    for (int year = 1; year <= years; ++year) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        progress.report(double(year) / years);
        stand.grow(year);
    }
    return stand.trees();
}

} // namespace ramure
