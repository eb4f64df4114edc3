#include "core/generators/growth/palm.h"

#include "core/generators/colonisation/growth_space.h"
#include "core/generators/growth/growing_tree.h"
#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
constexpr glm::dvec3 up(0.0, 1.0, 0.0);

double eased(double share)
{
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The stem as a function of time. A palm first builds the width of its stem, near the ground, and rises
/// afterwards; wood that has left the crown neither grows nor moves.
class Stem
{
public:
    Stem(const GrowthParams& params, std::uint64_t seed)
        : m_params(params)
        , m_tall(std::max(params.height - 0.6 * params.frondLength, 0.3 * params.height))
        , m_vigour(0.4 + 0.6 * std::min(params.sunlight, 1.0))
    {
        Random random(seed, RandomStream::Stems);
        const auto [sine, cosine] = maths::sincos(fullTurn * random.unit());
        m_aside = {cosine, 0.0, sine};
        m_lean = 0.35 * params.wander * random.range(0.3, 1.0) * m_tall;
        m_phase = fullTurn * random.unit();
        const glm::dvec3 light = growth::Site(params).light;
        if (params.space.space() || light != glm::dvec3(0.0))
            lookForSky(light);
    }

    /// m along the stem, of its end at a time in years.
    [[nodiscard]] double heightAt(double years) const
    {
        const double low = (0.02 + 0.045 * std::min(years, widening)) * std::min(1.0, m_tall);
        const double rising = std::max(0.0, m_vigour * (years - widening)) / m_params.maturity;
        return std::min(low + 1.1 * m_tall * (1.0 - maths::exp(-2.4 * rising)), m_roof);
    }
    [[nodiscard]] glm::dvec3 at(double height) const
    {
        const double share = height / m_tall;
        const double aside = m_lean * (1.0 - maths::exp(-2.2 * share));
        const double across = 0.04 * m_lean * (maths::sin(5.0 * share + m_phase) - maths::sin(m_phase));
        const glm::dvec3 free = height * up + aside * m_aside + across * glm::cross(up, m_aside);
        if (m_shifts.empty())
            return free;
        const double place = std::min(height / m_step, double(m_shifts.size() - 1));
        const auto k = std::min(std::size_t(place), m_shifts.size() - 2);
        return free + glm::mix(m_shifts[k], m_shifts[k + 1], place - double(k));
    }
    /// \param born years, when that height was reached; \param years now
    [[nodiscard]] double radiusAt(double height, double born, double years) const
    {
        const double r = m_params.stemRadius, swollen = height / (3.5 * r);
        const double grown =
            r * (1.0 - 0.2 * height / m_tall) * (1.0 + 0.75 * maths::exp(-swollen * swollen));
        const double wide = 0.12 + 0.88 * std::min(1.0, years / (1.25 * widening));
        return grown * wide * (0.62 + 0.38 * eased((years - born) / m_params.frondYears));
    }
    /// When the frond of that number opens: few a year while the palm is young.
    [[nodiscard]] double birthOf(std::uint64_t frond) const
    {
        constexpr double few = 0.35;
        const double rate = double(m_params.fronds) * m_vigour, count = double(frond) / rate;
        const double rise = (1.0 - few) / (2.0 * widening), whole = 0.5 * (1.0 + few) * widening;
        return count < whole ? (std::sqrt(few * few + 4.0 * rise * count) - few) / (2.0 * rise)
                             : widening + count - whole;
    }
    /// How much of a grown palm's frond one has that opens at that time.
    [[nodiscard]] double sizeOf(double born) const { return 0.2 + 0.8 * eased(born / (1.5 * widening)); }

private:
    /// The bud turns to the light and to the open sky on its way, as fast as wood this thick can, and upright
    /// again beyond.
    void lookForSky(const glm::dvec3& light)
    {
        const GrowthSpace* space = m_params.space.space();
        constexpr double steps = 80.0, turns = 0.3, rights = 0.25, most = 0.5; // by metre; slope
        m_step = 1.15 * m_tall / steps;
        std::vector<glm::dvec3> shifts{glm::dvec3(0.0)};
        glm::dvec3 slope(0.0), below = at(0.0);
        for (int k = 1; k <= int(steps); ++k) {
            glm::dvec3 open(0.0);
            if (space == nullptr || growth::openSky(m_params, below, open) >= 1.0)
                open = glm::dvec3(0.0);
            slope += turns * m_params.light * m_step * (light + open);
            slope *= std::max(0.0, 1.0 - rights * m_step);
            slope *= std::min(1.0, most / std::max(glm::length(slope), most));
            shifts.push_back(shifts.back() + m_step * slope);
            const glm::dvec3 next = at(m_step * k) + shifts.back();
            if (space != nullptr && space->blocks(below, next + 2.0 * m_params.stemRadius * up)) {
                m_roof = m_step * std::max(1, k - 1);
                break;
            }
            below = next;
        }
        m_shifts = std::move(shifts);
    }

    static constexpr double widening = 4.0; // years
    const GrowthParams& m_params;
    double m_tall, m_vigour;
    double m_roof = std::numeric_limits<double>::infinity(); ///< m along the stem, where a solid ends it
    double m_step = 0.0;                                     ///< m along the stem, between the shifts
    std::vector<glm::dvec3> m_shifts;                        ///< towards the light; none without solids
    glm::dvec3 m_aside{0.0};
    double m_lean = 0.0, m_phase = 0.0;
};

class Palm
{
public:
    Palm(const GrowthParams& params, std::uint64_t seed, double age, const GrowthCuts& cuts)
        : m_params(params)
        , m_cuts(cuts)
        , m_seed(seed)
        , m_age(age)
        , m_stem(params, seed)
    {
        for (const GrowthCut& cut : cuts)
            if (!cut.within && cut.axis == palmStemAddress && double(cut.age) <= m_age) {
                m_age = double(cut.age);
                m_end = cut.share * m_stem.heightAt(m_age);
            }
    }

    Skeleton run()
    {
        // Nodes are where the end of the stem was when enough fronds had opened: ages have them in common.
        constexpr std::uint64_t atOneNode = 4;
        const double least = 0.35 * m_params.stemRadius;
        std::uint64_t first = 0;
        double below = 0.0;
        while (m_stem.birthOf(first) <= m_age) {
            std::uint64_t next = first + atOneNode;
            while (m_stem.heightAt(m_stem.birthOf(next)) - below < least && next < first + 6 * atOneNode)
                ++next;
            const double born = m_stem.birthOf(next);
            const double height = std::min(m_stem.heightAt(std::min(born, m_age)), std::max(m_end, least));
            // The end of the stem is no disc: until it has a length, its fronds stand on the node below.
            if (m_top == noIndex || height - below > 0.3 * least) {
                addNode(below, height, born);
                below = height;
            }
            const bool isDead = std::isfinite(m_end);
            for (std::uint64_t k = first; k < next && !isDead; ++k)
                addFrond(k);
            first = next;
        }
        if (std::isfinite(m_end))
            m_skeleton.sawn.push_back(m_top);
        return std::move(m_skeleton);
    }

private:
    /// How much of an axis stands, as a share of its length.
    [[nodiscard]] double shareOf(std::uint64_t address) const
    {
        double share = 1.0;
        for (const GrowthCut& cut : m_cuts)
            if (!cut.within && cut.axis == address && double(cut.age) <= m_age)
                share = std::min(share, cut.share);
        return share;
    }
    [[nodiscard]] double chance(std::uint64_t address, std::uint64_t purpose) const
    {
        return double(mixBits(mixBits(address + purpose * golden) ^ mixBits(m_seed * golden)) >> 11) *
               0x1.0p-53;
    }

    void addNode(double below, double height, double born)
    {
        const bool isFoot = m_top == noIndex;
        const double from = isFoot ? m_stem.radiusAt(0.0, 0.0, m_age) : m_skeleton.a1[m_top];
        const double to = std::min(from, m_stem.radiusAt(height, born, m_age));
        m_top = m_skeleton.add(m_top, m_stem.at(below), m_stem.at(height), from, to, 0);
        m_skeleton.key[m_top] = mixBits(palmStemAddress + golden * ++m_nodes);
        if (isFoot)
            m_skeleton.axisStarts.emplace_back(m_top, palmStemAddress);
    }

    void addFrond(std::uint64_t number)
    {
        const std::uint64_t address = mixBits(palmStemAddress ^ golden * (number + 1));
        const double born = m_stem.birthOf(number),
                     lives = m_params.frondYears * (0.9 + 0.2 * chance(address, 1));
        const double share = (m_age - born) / lives;
        if (share <= 0.0 || share >= 1.0)
            return;
        const double turn = double(number) * goldenAngle + 0.25 * (chance(address, 2) - 0.5);
        const auto [sine, cosine] = maths::sincos(turn);
        const Frond frond{address, {cosine, 0.0, sine}, born, share};
        drawFrond(frond);
        // Bunches stand in the axils of leaves; the first years have none.
        constexpr double firstFruit = 6.0;
        if (number % 2 == 0 && m_params.fruit > 0 && born > firstFruit && share > 0.3 && share < 0.97)
            drawBunch(frond);
    }

    struct Frond
    {
        std::uint64_t address;
        glm::dvec3 out; ///< unit, level
        double born;    ///< years
        double share;   ///< of its life
    };

    void drawFrond(const Frond& frond)
    {
        constexpr int pieces = 14;
        const double opened = eased(frond.share / 0.22);
        const double length = m_params.frondLength * m_stem.sizeOf(frond.born) *
                              (0.92 + 0.16 * chance(frond.address, 3)) * (0.08 + 0.92 * opened);
        // Upright when it opens, hanging when it falls, and bowed more the older it is.
        const double first = (7.0 + 102.0 * maths::pow(frond.share, 0.85)) * oneDegree;
        const double bow = (6.0 + 58.0 * opened * (0.5 + 0.5 * frond.share)) * oneDegree;
        const double aside = 0.25 * (chance(frond.address, 4) - 0.5);
        const glm::dvec3 across = glm::cross(frond.out, up);
        const double thick = 0.0105 * length * (0.6 + 0.4 * opened);
        Index below = m_top;
        glm::dvec3 at = m_skeleton.p1[m_top];
        double radius = std::min(1.5 * thick, 0.8 * m_skeleton.a1[m_top]);
        const double stands = shareOf(frond.address);
        for (int k = 0; k < pieces; ++k) {
            const double share = double(k + 1) / pieces;
            if (share - 0.5 / pieces > stands) {
                if (k > 0)
                    m_skeleton.sawn.push_back(below);
                return;
            }
            const double angle = std::min(first + bow * maths::pow(share, 1.2), 165.0 * oneDegree);
            const auto [sine, cosine] = maths::sincos(angle);
            const glm::dvec3 way =
                glm::normalize(sine * (frond.out + aside * share * share * across) + cosine * up);
            const glm::dvec3 to = at + length / pieces * way;
            if (m_params.space.space() && m_params.space.space()->blocks(at, to))
                return; // a wall
            const double end = std::min(radius, thick * (1.0 - 0.9 * share));
            below = m_skeleton.add(below, at, to, radius, end, 1);
            m_skeleton.key[below] = mixBits(frond.address + golden * std::uint64_t(k + 1));
            if (k == 0)
                m_skeleton.axisStarts.emplace_back(below, frond.address);
            addLeaflets(frond, below, {way, across, length, opened, double(k) / pieces, 1.0 / pieces});
            at = to;
            radius = end;
        }
    }

    struct Rachis
    {
        glm::dvec3 way, across; ///< unit
        double length;          ///< m, of the whole frond
        double opened;
        double from, step; ///< shares of the length
    };

    /// Pairs, longest before the middle, closed along the rachis of a young frond.
    void addLeaflets(const Frond& frond, Index branch, const Rachis& rachis)
    {
        constexpr int pairs = 4; // on a piece
        constexpr double stalk = 0.2;
        const glm::dvec3 upper = glm::normalize(glm::cross(rachis.across, rachis.way));
        for (int pair = 0; pair < pairs; ++pair) {
            const double share = rachis.from + rachis.step * (pair + 0.5) / pairs;
            if (share < stalk)
                continue;
            const double along = (share - stalk) / (1.0 - stalk);
            const double size =
                0.245 * rachis.length * std::min(0.62 + 1.6 * along, 1.06 - 0.74 * along * along);
            for (const double side : {-1.0, 1.0}) {
                const double wild = chance(frond.address, 16 + std::uint64_t(share * 1e4) * 2 + (side > 0.0));
                const double spread = (66.0 - 38.0 * along + 8.0 * (wild - 0.5)) * oneDegree * rachis.opened;
                const double hang = (8.0 + 34.0 * frond.share + 10.0 * wild) * oneDegree * rachis.opened;
                addLeaf(branch, (share - rachis.from) / rachis.step, rachis.way, size,
                        side * maths::sin(spread) * rachis.across, spread, hang, upper);
            }
        }
    }

    void addLeaf(Index branch, double place, const glm::dvec3& way, double size, const glm::dvec3& aside,
                 double spread, double hang, const glm::dvec3& upper)
    {
        const glm::dvec3 level = maths::cos(spread) * way + aside;
        const glm::dvec3 heading = glm::normalize(maths::cos(hang) * level - maths::sin(hang) * upper);
        const glm::dvec3 face = upper - glm::dot(upper, heading) * heading;
        m_skeleton.organs.push_back(
            {branch, OrganKind::Leaf, place, glm::dvec3(0.0), way, heading, glm::normalize(face), size});
    }

    /// A stalk that bows over under its fruit, which swell within a year.
    void drawBunch(const Frond& frond)
    {
        constexpr int pieces = 3;
        const double ripe = eased((frond.share - 0.3) / 0.45);
        const std::uint64_t address = mixBits(frond.address + 7);
        if (shareOf(address) < 1.0)
            return;
        const auto [swing, keep] = maths::sincos(0.5);
        const glm::dvec3 out = keep * frond.out + swing * glm::cross(up, frond.out);
        const double length = m_params.stemRadius * (3.0 + 1.5 * ripe);
        Index below = m_top;
        glm::dvec3 at = m_skeleton.p1[m_top];
        double radius = std::min(0.11 * m_params.stemRadius + 0.08 * m_params.stemRadius * ripe,
                                 0.6 * m_skeleton.a1[m_top]);
        const std::int64_t fruit = m_params.fruit;
        for (int k = 0; k < pieces; ++k) {
            const double angle = (40.0 + 25.0 * ripe + (22.0 + 16.0 * ripe) * k) * oneDegree;
            const auto [sine, cosine] = maths::sincos(angle);
            const glm::dvec3 way = sine * out + cosine * up, to = at + length / pieces * way;
            below = m_skeleton.add(below, at, to, radius, 0.8 * radius, 1);
            m_skeleton.key[below] = mixBits(address + golden * std::uint64_t(k + 1));
            if (k == 0)
                m_skeleton.axisStarts.emplace_back(below, address);
            at = to;
            radius *= 0.8;
            for (std::int64_t nut = k == 0 ? fruit : 0; nut < fruit; ++nut)
                if (nut % 2 == k - 1)
                    hangFruit(address, below, nut, ripe, way);
        }
    }

    void hangFruit(std::uint64_t address, Index branch, std::int64_t nut, double ripe, const glm::dvec3& way)
    {
        const double turn = double(nut) * goldenAngle + chance(address, 32 + std::uint64_t(nut));
        const auto [sine, cosine] = maths::sincos(turn);
        const glm::dvec3 level = glm::normalize(glm::cross(way, glm::dvec3(way.z, 0.3, -way.x)));
        const glm::dvec3 around = cosine * level + sine * glm::cross(way, level);
        const glm::dvec3 heading = glm::normalize(0.75 * around - 0.55 * up + 0.15 * way);
        const glm::dvec3 face = glm::normalize(glm::cross(heading, glm::cross(way, heading)));
        const double size = m_params.stemRadius * (0.35 + 1.15 * ripe) *
                            (0.9 + 0.2 * chance(address, 90 + std::uint64_t(nut)));
        m_skeleton.organs.push_back({branch, OrganKind::Fruit,
                                     0.3 + 0.65 * chance(address, 60 + std::uint64_t(nut)), glm::dvec3(0.0),
                                     way, heading, face, size});
    }

    const GrowthParams& m_params;
    const GrowthCuts& m_cuts;
    std::uint64_t m_seed;
    double m_age;                                           ///< of a dead palm that of its death
    double m_end = std::numeric_limits<double>::infinity(); ///< m along the stem, where it was cut
    Stem m_stem;
    Index m_top = noIndex;
    std::uint64_t m_nodes = 0;
    Skeleton m_skeleton;
};

} // namespace

Skeleton palmAtAge(const GrowthParams& params, std::uint64_t seed, double age, const GrowthCuts& cuts)
{
    return Palm(params, seed, age, cuts).run();
}

} // namespace ramure
