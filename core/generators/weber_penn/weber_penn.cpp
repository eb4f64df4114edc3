#include "core/generators/weber_penn/weber_penn.h"

#include "core/generators/grammar/turtle.h"
#include "core/generators/weber_penn/stem_course.h"
#include "core/generators/weber_penn/stem_formulas.h"
#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

constexpr std::uint64_t step = 0x9E3779B97F4A7C15ull;
/// What a stem draws for, beside its crookedness, which has the numbers of its segments.
enum class Draw : std::uint64_t { Length = 1000, DownAngle, Rotate, Split };

std::uint64_t below(std::uint64_t address, std::uint64_t number)
{
    return mixBits(address + step * (number + 1));
}

/// Where a piece of a stem ends.
struct Cut
{
    double at = 0.0;  ///< m along the whole stem
    int slot = -1;    ///< of a stem that starts there
    int splits = 0;   ///< stems more
    int segment = -1; ///< of the curve, where it ends too
};

class Grower
{
public:
    Grower(const WeberPennParams& params, std::uint64_t seed, const Progress& progress)
        : m_params(params)
        , m_seed(seed)
        , m_progress(progress)
    {
    }

    Expected<Skeleton> run()
    {
        RAMURE_TRY(checkSize());
        plantTrunks();
        for (std::size_t grown = 0; !m_waiting.empty(); ++grown) {
            if (grown % 256 == 0) {
                if (m_progress.cancelled())
                    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
                m_progress.report(double(grown) / double(grown + m_waiting.size()));
            }
            const Waiting next = m_waiting.back();
            m_waiting.pop_back();
            grow(next.stem, next.branch);
            if (m_skeleton.size() + m_waiting.size() > maxBranches)
                return tooMany();
        }
        if (m_skeleton.empty())
            return refuse(ErrorCode::Invalid, RAMURE_NOOP("the trunk has no length"),
                          m_params.level[0].branches == 0 ? "weberPenn.level0.branches"
                                                          : "weberPenn.level0.length");
        return std::move(m_skeleton);
    }

private:
    struct Waiting
    {
        Stem stem;
        Index branch = noIndex; ///< at whose end it starts
    };

    static tl::unexpected<Error> refuse(ErrorCode code, const char* text, std::string path,
                                        std::vector<std::string> args = {})
    {
        auto error = fail(code, text, std::move(args));
        error.value().path = std::move(path);
        return error;
    }

    [[nodiscard]] tl::unexpected<Error> tooMany() const
    {
        std::size_t most = 0;
        for (std::size_t level = 1; level < levels(); ++level)
            if (m_params.level[level].branches > m_params.level[most].branches || most == 0)
                most = level;
        return refuse(ErrorCode::Limit, RAMURE_NOOP("the stems have more pieces than the limit of %1"),
                      "weberPenn.level" + std::to_string(most) + ".branches", {std::to_string(maxBranches)});
    }

    [[nodiscard]] std::size_t levels() const { return static_cast<std::size_t>(m_params.levels); }

    /// By half of what there may be, before anything grows: the exact number depends on all lengths.
    [[nodiscard]] Expected<void> checkSize() const
    {
        double stems = 1.0, pieces = 0.0;
        for (std::size_t level = 0; level < levels(); ++level) {
            const WeberPennLevel& own = m_params.level[level];
            stems *= static_cast<double>(own.branches) * (level > 1 ? 0.4 : 1.0);
            const double split =
                (1.0 + double(own.baseSplits)) *
                maths::pow(1.0 + own.segSplits, double(std::max(own.curveRes - 2, std::int64_t(0))));
            pieces += stems * std::max(double(own.curveRes), split);
        }
        if (pieces > 2.0 * double(maxBranches))
            return tooMany();
        return {};
    }

    [[nodiscard]] double chance(std::uint64_t address, Draw channel, double most) const
    {
        if (most == 0.0)
            return 0.0;
        Random random(m_seed, RandomStream::Stems, below(address, static_cast<std::uint64_t>(channel)));
        return random.range(-most, most);
    }

    void plantTrunks()
    {
        const WeberPennLevel& level = m_params.level[0];
        for (std::int64_t i = level.branches; i-- > 0;) {
            Stem trunk;
            trunk.address = trunk.own = below(0, std::uint64_t(i));
            trunk.length = (m_params.scale + chance(1, Draw::Length, m_params.scaleV)) *
                           (level.length + chance(trunk.address, Draw::Length, level.lengthV));
            trunk.radius = trunk.length * m_params.ratio;
            lean(trunk, Frame(), level.downAngle, slotAzimuth(0, 0.0, level, int(i), trunk.address));
            if (trunk.length > 1e-4 * m_params.scale)
                m_waiting.push_back({trunk, noIndex});
        }
    }

    /// Turns the start of a stem away from \p before.
    void lean(Stem& stem, const Frame& before, double downAngle, double azimuth) const
    {
        downAngle +=
            chance(stem.address, Draw::DownAngle, std::max(m_params.level[stem.level].downAngleV, 0.0));
        const auto [aside, along] = maths::sincos(downAngle);
        const auto [sine, cosine] = maths::sincos(azimuth);
        stem.frame = transported(before, along * before.tangent +
                                             aside * (cosine * before.normal + sine * before.binormal));
        stem.azimuth = azimuth;
    }

    /// Rad, in the frame of what carries the stem. \p away its own azimuth: left and right are measured from
    /// there.
    [[nodiscard]] double slotAzimuth(std::size_t carrierLevel, double away, const WeberPennLevel& level,
                                     int slot, std::uint64_t address) const
    {
        const double varied = chance(address, Draw::Rotate, level.rotateV);
        if (level.rotate >= 0.0)
            return (slot + 1) * level.rotate + varied;
        const double side = pi + level.rotate + varied;
        return (carrierLevel > 0 ? away : 0.0) + (slot % 2 == 0 ? side : -side);
    }

    [[nodiscard]] double radiusAt(const Stem& stem, double at) const
    {
        const double z = std::clamp(at / stem.length, 0.0, 1.0);
        double radius =
            taperedRadius(m_params.level[stem.level].taper, stem.radius, stem.length, z) * stem.thin;
        if (stem.level == 0)
            radius *= trunkFactor(m_params, z);
        // A tip is as blunt as a twig.
        return std::max(radius, tipRadius(stem));
    }

    static double tipRadius(const Stem& stem) { return 0.06 * stem.radius * stem.thin; }

    /// m: below there is nothing of what limbs carry, which has less and less room below them.
    [[nodiscard]] double floorOf(const Stem& stem) const
    {
        if (stem.level < 2 || m_params.clearance == 0.0)
            return -std::numeric_limits<double>::infinity();
        return std::min(m_params.clearance * (stem.level == 2 ? 0.6 : 0.4), 0.8 * stem.foot.y);
    }

    [[nodiscard]] double bareBase(const Stem& stem) const
    {
        return stem.level == 0 ? m_params.baseSize * stem.length : 0.0;
    }

    /// Where the first of its own stems could stand: of limbs, out of the wood that carries them.
    [[nodiscard]] double firstOffset(const Stem& stem) const
    {
        return stem.level == 0 ? bareBase(stem) : std::min(1.5 * stem.carrier, 0.4 * stem.length);
    }

    /// Children the whole stem carries, those of its splits included.
    [[nodiscard]] int slotsOf(const Stem& stem) const
    {
        if (stem.level + 1 >= levels())
            return 0;
        return stemCount(m_params, stem.level + 1, stem.length, stem.parentLength, stem.offset);
    }

    /// Splits at the end of a piece, so that the mean over all stems of a level holds.
    int splitsAt(const Stem& stem, int segment)
    {
        const WeberPennLevel& level = m_params.level[stem.level];
        if (segment + 1 >= level.curveRes)
            return 0;
        if (segment == 0 && level.baseSplits > 0)
            return static_cast<int>(level.baseSplits);
        double& owed = m_owedSplits[stem.level];
        owed += level.segSplits;
        const int now = static_cast<int>(std::floor(owed + 0.5));
        owed -= now;
        return now;
    }

    /// The ends of all pieces, ascending; \p stem learns what splits leave it. Splits share the slots.
    std::vector<Cut> cutsOf(const Stem& stem)
    {
        const int slots = slotsOf(stem);
        const double first = firstOffset(stem), gap = slots > 0 ? (stem.length - first) / slots : stem.length;
        const auto pieces = static_cast<int>(m_params.level[stem.level].curveRes);
        const double piece = stem.length / pieces;
        std::vector<Cut> cuts;
        int share = stem.share, of = stem.of, slot = 0;
        while (slot < slots && first + (slot + 0.5) * gap <= stem.begin)
            ++slot;
        for (int segment = stem.segment; segment < pieces; ++segment) {
            const double end = segment + 1 == pieces ? stem.length : (segment + 1) * piece;
            for (; slot < slots && first + (slot + 0.5) * gap <= end; ++slot)
                if (slot % of == share)
                    cuts.push_back({first + (slot + 0.5) * gap, slot, 0, -1});
            const int splits = splitsAt(stem, segment);
            // No room for a piece of its own: the fork that is there serves.
            const bool close = !cuts.empty() && end - cuts.back().at < 0.3 * std::min(gap, piece);
            if (!close || cuts.back().segment >= 0 || segment + 1 == pieces)
                cuts.push_back({end, -1, splits, segment});
            else
                cuts.back().splits = splits, cuts.back().segment = segment;
            of *= 1 + splits;
        }
        return cuts;
    }

    /// Pieces grow shorter by less than half from one to the next: curves between very unequal ones swing
    /// out. The flare of a trunk has pieces of its own.
    [[nodiscard]] std::vector<Cut> graded(const Stem& stem, const std::vector<Cut>& cuts) const
    {
        std::vector<Cut> finer;
        if (stem.level == 0 && stem.begin == 0.0 && m_params.flare != 0.0)
            for (const double at : {1.0 / 64, 1.0 / 32, 1.0 / 16})
                if (at * stem.length < 0.7 * cuts.front().at)
                    finer.push_back({at * stem.length, -1, 0, -1});
        finer.insert(finer.end(), cuts.begin(), cuts.end());
        std::vector<Cut> all;
        double after = stem.length;
        for (std::size_t i = finer.size(); i-- > 0;) {
            const double start = i > 0 ? finer[i - 1].at : stem.begin;
            all.push_back(finer[i]);
            double end = finer[i].at;
            while (end - start > 2.5 * after && all.size() < 100'000) {
                end -= 2.0 * after;
                after *= 2.0;
                all.push_back({end, -1, 0, -1});
            }
            after = end - start;
        }
        std::ranges::reverse(all);
        return all;
    }

    void grow(Stem stem, Index branch)
    {
        const std::vector<Cut> cuts = graded(stem, cutsOf(stem));
        StemCourse course(m_params, m_seed, stem, stem.length);
        const std::size_t waitingBefore = m_waiting.size();
        int number = branch == noIndex ? 0 : 1;
        double at = stem.begin;
        for (const Cut& cut : cuts) {
            course.advance(cut.at - at);
            if (course.position().y < floorOf(stem)) {
                if (number == 0 && at > stem.begin) // it comes to its end in the piece before
                    m_skeleton.a1[branch] = std::min(m_skeleton.a1[branch], tipRadius(stem));
                break;
            }
            branch = addPiece(stem, branch, course.position(), at, cut.at, number);
            number = 0;
            at = cut.at;
            if (cut.slot >= 0)
                sprout(stem, cut, branch, course);
            if (cut.splits > 0)
                split(stem, cut, branch, course);
        }
        // The last one waiting grows first: so they grow in their order.
        std::reverse(m_waiting.begin() + std::ptrdiff_t(waitingBefore), m_waiting.end());
    }

    /// \param number 0: goes on; 1: starts.
    Index addPiece(const Stem& stem, Index parent, const glm::dvec3& to, double from, double end, int number)
    {
        const bool isRoot = parent == noIndex;
        const glm::dvec3 start = isRoot ? glm::dvec3(0.0) : m_skeleton.p1[parent];
        double radius = radiusAt(stem, from);
        if (!isRoot)
            radius = std::min(radius, m_skeleton.a1[parent]);
        // Only a trunk that is thinner at the ground grows thicker on its way.
        const bool widens = stem.level == 0 && m_params.flare < 0.0;
        const double last = widens ? radiusAt(stem, end) : std::min(radius, radiusAt(stem, end));
        const Index i = m_skeleton.add(parent, start, to, radius, last, static_cast<Index>(stem.level));
        const bool starts = isRoot || number > 0;
        m_skeleton.key[i] = starts ? mixBits(stem.own) : below(m_skeleton.key[parent], 0);
        return i;
    }

    void sprout(const Stem& carrier, const Cut& cut, Index branch, const StemCourse& course)
    {
        Stem stem;
        stem.level = carrier.level + 1;
        const WeberPennLevel& level = m_params.level[stem.level];
        stem.address = stem.own = below(carrier.address, std::uint64_t(cut.slot));
        const double base = bareBase(carrier);
        const double share = level.length + chance(stem.address, Draw::Length, level.lengthV);
        stem.length = stemLength(m_params, stem.level, share, carrier.length, cut.at, base);
        stem.parentLength = carrier.length;
        stem.offset = cut.at;
        stem.carrier = m_skeleton.a1[branch];
        stem.foot = course.position();
        lean(stem, course.frame(), stemDownAngle(level, carrier.length, cut.at, base),
             slotAzimuth(carrier.level, carrier.azimuth, level, cut.slot, stem.address));
        if (m_params.pruneRatio > 0.0)
            stem.length = pruned(stem);
        if (stem.foot.y - stem.length < floorOf(stem))
            stem.length = aboveGround(stem);
        // What does not leave the wood that carries it is no stem.
        if (stem.length <= std::max(1.5 * stem.carrier, 1e-4 * m_params.scale))
            return;
        const double radius = carrier.radius * maths::pow(stem.length / carrier.length, m_params.ratioPower);
        stem.radius = std::min(radius, stem.carrier);
        m_waiting.push_back({stem, branch});
    }

    /// The original turns away too; all of them stand evenly around where it went.
    void split(Stem& stem, const Cut& cut, Index branch, StemCourse& course)
    {
        const WeberPennLevel& level = m_params.level[stem.level];
        const int count = cut.splits + 1;
        const std::uint64_t place = below(stem.own, 5000 + std::uint64_t(cut.segment));
        const double declination = maths::acos(std::clamp(course.frame().tangent.y, -1.0, 1.0));
        const double varied = level.splitAngle + chance(place, Draw::Split, level.splitAngleV);
        const double angle = std::max(varied - 0.5 * declination, pi / 12.0);
        const double around = chance(place, Draw::Rotate, pi);
        stem.thin *= maths::pow(count, -0.4);
        for (int i = 1; i < count; ++i) {
            Stem clone = stem;
            clone.own = below(place, std::uint64_t(i));
            clone.foot = course.position();
            clone.frame = course.frame();
            clone.begin = cut.at;
            clone.segment = cut.segment + 1;
            clone.share = stem.share + stem.of * i;
            clone.of = stem.of * count;
            clone.splitAngle = angle;
            clone.splitAzimuth = around + 2.0 * pi * i / count;
            m_waiting.push_back({clone, branch});
        }
        stem.of *= count;
        course.split(angle, around);
    }

    [[nodiscard]] bool fits(const Stem& stem, double length) const
    {
        StemCourse course(m_params, m_seed, stem, length);
        const auto pieces = static_cast<int>(m_params.level[stem.level].curveRes);
        for (int i = 0; i < pieces; ++i) {
            course.advance(length / pieces);
            const glm::dvec3& at = course.position();
            const double height = m_params.scale * m_params.level[0].length;
            const double ratio = (height - at.y) / (height * (1.0 - m_params.baseSize));
            const double aside = std::sqrt(at.x * at.x + at.z * at.z);
            if (aside > height * m_params.pruneWidth * envelopeRatio(m_params, ratio))
                return false;
        }
        return true;
    }

    /// Its length inside the envelope, as far as the tree is pruned.
    [[nodiscard]] double pruned(const Stem& stem) const
    {
        double length = stem.length;
        for (int i = 0; i < 24 && !fits(stem, length); ++i)
            length *= 0.85;
        return stem.length + m_params.pruneRatio * (length - stem.length);
    }

    /// The length at which no bend of the stem is below its floor.
    [[nodiscard]] double aboveGround(const Stem& stem) const
    {
        const auto pieces = static_cast<int>(m_params.level[stem.level].curveRes);
        const auto sinks = [&](double length) {
            StemCourse course(m_params, m_seed, stem, length);
            for (int i = 0; i < pieces; ++i) {
                course.advance(length / pieces);
                if (course.position().y < floorOf(stem))
                    return true;
            }
            return false;
        };
        double length = stem.length;
        for (int i = 0; i < 24 && sinks(length); ++i)
            length *= 0.85;
        return length;
    }

    const WeberPennParams& m_params;
    std::uint64_t m_seed;
    const Progress& m_progress;
    std::vector<Waiting> m_waiting;
    std::array<double, weberPennLevels> m_owedSplits{};
    Skeleton m_skeleton;
};

} // namespace

Expected<Skeleton> growWeberPenn(const WeberPennParams& params, std::uint64_t seed, const Progress& progress)
{
    return Grower(params, seed, progress).run();
}

} // namespace ramure
