/// \file
/// A tree that has lived: one run of the self-organising model with everything that happened stamped by year,
/// so that the tree of any age can be cut out of it (grown_skeleton.h).
#pragma once

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/params/growth_params.h"
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace ramure {

struct Skeleton;
struct TreeAxes;

/// Oldest age, in years.
inline constexpr double maxGrowthAge = 2000.0;
/// Most metamers that one tree may bear, living or shed.
inline constexpr std::size_t maxMetamers = 4'000'000;

/// Whether a place, m, is in a shape.
using GrowthShape = std::function<bool(const glm::dvec3&)>;

/// A limb that somebody cuts, or the wood that stands out of a pruning shape. The shoots it shaded get light,
/// and dormant buds below the wound shoot in the next year (epicormic shoots). A stump without shoots dies
/// back.
struct GrowthCut
{
    std::uint64_t axis = 0; ///< address, see GrowthHistory::axisAddress; 0: the whole tree, by a shape
    double share = 0.0; ///< share of the axis's length that stays; the first internode of a trunk always does
    int age = 0;        ///< age of the tree in years; the limb is missing from this age on
    std::uint64_t edit = 0; ///< TreeEdit::id of the step that asks for it
    /// The space in which wood stays; if it is set, `share` is ignored. Trunks may come from outside.
    std::shared_ptr<const GrowthShape> within{};
    bool operator==(const GrowthCut&) const = default;
};
/// Their order changes nothing. Cuts of axes that do not stand at that age do nothing.
using GrowthCuts = std::vector<GrowthCut>;

/// The figures of one year.
struct GrowthYear
{
    Index living = 0; ///< metamers at its end
    Index born = 0, shed = 0;
    double light = 0.0;       ///< sum of the light of all buds
    double vigour = 0.0;      ///< vigour that left the roots
    double vigourSpent = 0.0; ///< vigour that arrived at buds; equal to `vigour` but for rounding
    bool operator==(const GrowthYear&) const = default;
};

/// Metamers are internodes with the buds at their upper ends. Arrays run by birth: parents before children.
struct GrowthHistory
{
    static constexpr std::uint16_t lives = 0xFFFF;

    GrowthParams params;
    std::uint64_t seed = 0;

    // By metamer.
    std::vector<Index> parent;        ///< noIndex: a root
    std::vector<Index> axis;          ///< the same as the parent's where it goes on
    std::vector<std::uint16_t> birth; ///< the year that it grew in: it is there at ages above this one
    std::vector<std::uint16_t> death; ///< the age at which it is no longer there; or lives
    std::vector<glm::vec3> direction; ///< unit, at its birth, in the frame of its parent's bends
    std::vector<float> length;        ///< m
    /// The age at which it died and stood on, or lives; of metamers up to the last of which it is true.
    std::vector<std::uint16_t> withered;

    // By axis.
    std::vector<std::uint64_t> axisAddress; ///< hash of the parent's, the year, the node in it and the bud
    std::vector<std::uint8_t> axisOrder;

    // Rows: row a holds the metamers that live at the age of a years, in the order of their births.
    std::vector<std::size_t> rowStart;
    std::vector<std::uint16_t> pipes; ///< see pipesOf()
    std::vector<std::int16_t> bends;  ///< 1e-4 rad, down about the horizontal at birth; since birth

    /// Metamers that stood when growth began (standing_wood.h), those of the year 0; and where they leave the
    /// ground: of roots that are not named it is the origin.
    Index standing = 0;
    std::vector<bool> bareWood, flatWood; ///< by these: without leaves; flat where nothing goes on from it
    std::vector<std::pair<Index, glm::dvec3>> feet;
    GrowthCuts cuts;          ///< the requested cuts
    std::vector<bool> isMade; ///< by cut: its axis stood at that age

    std::vector<GrowthYear> years;
    /// The age at which nothing lived any more; 0: it lives.
    int diedAt = 0;

    [[nodiscard]] glm::dvec3 footOf(Index root) const;
    /// Whether it stands dead at an age.
    [[nodiscard]] bool isDead(Index metamer, int age) const
    {
        return metamer < withered.size() && int(withered[metamer]) <= age;
    }
    [[nodiscard]] Index size() const { return static_cast<Index>(parent.size()); }
    /// Whole years that were grown.
    [[nodiscard]] int grownYears() const { return static_cast<int>(years.size()); }
    [[nodiscard]] std::span<const std::uint16_t> pipesAt(int age) const
    {
        return {pipes.data() + rowStart[std::size_t(age)], pipes.data() + rowStart[std::size_t(age) + 1]};
    }
    [[nodiscard]] std::span<const std::int16_t> bendsAt(int age) const
    {
        return {bends.data() + rowStart[std::size_t(age)], bends.data() + rowStart[std::size_t(age) + 1]};
    }
    [[nodiscard]] std::size_t bytes() const;
};

/// The number of tips whose sap a section carries, as a row stores it: 5 bits of exponent and 11 of mantissa,
/// rounded down to 1 / 2048.
std::uint16_t packedPipes(float pipes);
float pipesOf(std::uint16_t packed);

/// Grows a tree from the ground for params.age years, the last one begun as a whole. Each year: light at
/// every bud (shadow_grid.h), vigour from the roots to the buds by Borchert and Honda, shoots, shedding,
/// thickness by the pipe model (Shinozaki et al. 1964), and the bend that the new weight leaves in the wood.
/// Nothing in a year knows of later ones: growing longer only adds.
///
/// Cuts are made at the end of the year before their age, so that all years before are as without them. From
/// then on the tree without them grows beside, and what stands away from the wounds shares its life: else the
/// vigour that a limb leaves to all others would change every axis within decades. So vigour is not
/// conserved.
///
/// Random numbers are keyed by the addresses of axes, with a hash of their own: Random mixes four times and
/// keeps a state for a stream, of which each number here would be the first. Errors, path = "growth." and the
/// parameter: Invalid (what the table of parameters refuses), Limit (more metamers than maxMetamers, more
/// voxels than ShadowGrid has), Cancelled.
Expected<GrowthHistory> growHistory(const GrowthParams& params, std::uint64_t seed, const GrowthCuts& cuts,
                                    const Progress& progress = {});
/// The same without cuts.
Expected<GrowthHistory> growHistory(const GrowthParams& params, std::uint64_t seed,
                                    const Progress& progress = {});

/// A tree that can go on from where it stopped: growTo() twice is the same history as once.
class GrowthRun
{
public:
    /// Errors: those of growHistory(). \param params whose age counts for nothing
    static Expected<GrowthRun> begin(const GrowthParams& params, std::uint64_t seed, GrowthCuts cuts = {},
                                     const Progress& progress = {});
    /// A tree that stands already, as at the age of one year. \param yearsBefore how old it counts
    static Expected<GrowthRun> goOn(const Skeleton& tree, const TreeAxes& axes, int yearsBefore,
                                    const GrowthParams& params, std::uint64_t seed);
    GrowthRun(GrowthRun&& other) noexcept;
    GrowthRun& operator=(GrowthRun&& other) noexcept;
    ~GrowthRun();

    /// Continues the growth. Errors: Limit, Cancelled; the years before are kept, and the function can be
    /// called again. \param age years; a smaller age than the present one does nothing
    Expected<void> growTo(double age, const Progress& progress = {});
    [[nodiscard]] const GrowthHistory& history() const;
    /// The history itself; the run is over.
    GrowthHistory take() &&;

private:
    struct State;
    explicit GrowthRun(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace ramure
