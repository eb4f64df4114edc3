#include "core/surface/foliage/leaf_placement.h"

#include "core/base/parallel.h"
#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/leaf_turns.h"
#include "core/surface/foliage/twig_line.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ramure {
namespace {

constexpr std::size_t twigsAtOnce = 64;

/// The leaves of one twig after the other.
class Grower
{
public:
    Grower(const Placing& placing, const LeafParams& params)
        : m_placing(placing)
        , m_params(params)
        , m_internode(internodeOf(params, placing.alpha))
        , m_turns(leafTurns(params.arrangement == LeafArrangement::Natural ? leafRow(params.shape).arrangement
                                                                           : params.arrangement,
                            static_cast<int>(params.whorl)))
    {
    }

    /// How many leaves a twig has.
    [[nodiscard]] double count(Index twig) const
    {
        const double room = twigLength(m_placing.skeleton, twig) - firstNode(m_placing.skeleton, twig);
        return nodes(room) * m_turns.perNode + (m_placing.isTip[twig] != 0 ? 1 : 0);
    }

    void grow(Index twig, std::vector<FoliageItem>& leaves) const
    {
        const Skeleton& skeleton = m_placing.skeleton;
        const TwigLine line(skeleton, twig);
        const double from = firstNode(m_placing.skeleton, twig), count = nodes(line.length() - from);
        Random random(m_placing.seed, RandomStream::TwigLeaves, skeleton.key[twig]);
        const double start = 2.0 * pi * random.unit();
        for (double node = 0.0; node < count; ++node) {
            const double along = from + m_internode * (node + 0.3 * random.unit());
            const TwigLine::Place place = line.at(along);
            const double turned = (m_turns.level ? levelAngle(place.frame, start) : start) +
                                  std::remainder(node * m_turns.fromNodeToNode, 2.0 * pi);
            // Young leaves near the tip are smaller.
            const double share = along / line.length(), young = m_placing.isTip[twig] != 0 ? 0.35 : 0.0;
            const double size = 1.0 - young * share * share * share;
            for (int leaf = 0; leaf < m_turns.perNode; ++leaf)
                leaves.push_back(leafAt(twig, place, turned + 2.0 * pi * leaf / m_turns.perNode,
                                        m_params.angle, size, random));
        }
        if (m_placing.isTip[twig] != 0)
            leaves.push_back(leafAt(twig, line.at(line.length()), start, 0.2 * m_params.angle, 0.75, random));
    }

private:
    static double internodeOf(const LeafParams& params, double alpha)
    {
        const LeafRow& row = leafRow(params.shape);
        return leafLength(leafForm(params), alpha) * row.internode / row.length * params.internode;
    }
    [[nodiscard]] double nodes(double room) const
    {
        return room > 0.0 && m_internode > 0.0 ? std::floor(room / m_internode) : 0.0;
    }
    /// Where around the twig it is level; any angle where the twig stands upright.
    static double levelAngle(const Frame& frame, double otherwise)
    {
        const glm::dvec3 side = glm::cross(frame.tangent, sky);
        if (glm::length(side) < 0.2)
            return otherwise;
        return maths::atan2(glm::dot(side, frame.binormal), glm::dot(side, frame.normal));
    }

    FoliageItem leafAt(Index twig, const TwigLine::Place& place, double around, double angle, double size,
                       Random& random) const
    {
        const auto [sine, cosine] = maths::sincos(around + random.range(-0.2, 0.2));
        const glm::dvec3 out = cosine * place.frame.normal + sine * place.frame.binormal;
        const auto [away, ahead] = maths::sincos(angle * random.range(0.85, 1.15));
        const double twist = random.range(-0.3, 0.3), other = random.range(-1.0, 1.0), tone = random.unit();
        FoliageItem leaf;
        leaf.branch = twig;
        leaf.position = place.centre + place.radius * out;
        leaf.orientation = orientation(drooped(ahead * place.frame.tangent + away * out, out), out,
                                       place.frame.tangent, twist);
        leaf.size = static_cast<float>(m_params.size * size * (1.0 + m_params.variation * other));
        leaf.tone = static_cast<float>(1.0 - 0.28 * tone);
        leaf.tint = tintOf(tone);
        return leaf;
    }
    /// Some leaves are yellower than their plant's and some bluer: about six degrees of hue either way.
    /// \param tone a random number, whose later digits are used.
    static glm::vec3 tintOf(double tone)
    {
        const double digits = 4099.0 * tone, way = 2.0 * (digits - std::floor(digits)) - 1.0;
        const double yellow = std::max(way, 0.0), blue = std::max(-way, 0.0);
        return {1.0 - 0.11 * blue, 1.0 - 0.05 * yellow, 1.0 - 0.22 * yellow};
    }
    /// Pulled down, but never into the bark.
    [[nodiscard]] glm::dvec3 drooped(const glm::dvec3& way, const glm::dvec3& out) const
    {
        glm::dvec3 bent = way * (1.0 - m_params.droop) - sky * m_params.droop;
        bent += out * std::max(0.15 - glm::dot(bent, out), 0.0);
        return glm::normalize(bent);
    }
    /// The upper side looks towards the twig's tip, or as far to the sky as the light asks.
    [[nodiscard]] glm::dquat orientation(const glm::dvec3& way, const glm::dvec3& out,
                                         const glm::dvec3& tangent, double twist) const
    {
        const auto across = [&way](const glm::dvec3& v) { return v - glm::dot(v, way) * way; };
        const glm::dvec3 natural = across(tangent - 0.01 * out);
        glm::dvec3 upper = across((1.0 - m_params.light) * tangent + m_params.light * sky);
        if (glm::length(upper) < 1e-3)
            upper = natural;
        if (glm::length(upper) < 1e-6)
            upper = across(std::abs(way.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
        upper = glm::normalize(upper);
        const glm::dvec3 right = glm::cross(way, upper);
        const auto [sine, cosine] = maths::sincos(twist);
        const glm::dvec3 z = cosine * upper + sine * right;
        return glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(way, z), way, z)));
    }

    const Placing& m_placing;
    const LeafParams& m_params;
    double m_internode;
    LeafTurns m_turns;
};

} // namespace

Expected<std::vector<FoliageItem>> placeLeaves(const Placing& placing, const LeafParams& params,
                                               const Progress& progress)
{
    std::vector<FoliageItem> leaves;
    const std::size_t faces = leafMesh(leafForm(params)).triangles.size();
    if (!(params.size > 0.0) || faces == 0)
        return leaves;
    const Grower grower(placing, params);
    std::vector<double> counts(placing.twigs.size());
    parallelFor(counts.size(), twigsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            counts[i] = grower.count(placing.twigs[i]);
    });
    const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
    const std::size_t most = std::min(maxLeaves, maxLeafFaces / faces);
    if (all > static_cast<double>(most))
        return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 leaves"), most,
                              "foliage.internode");
    std::vector<std::size_t> first{0};
    for (const double count : counts)
        first.push_back(first.back() + static_cast<std::size_t>(count));
    leaves.resize(first.back());
    parallelFor(placing.twigs.size(), twigsAtOnce, [&](std::size_t begin, std::size_t end) {
        std::vector<FoliageItem> own;
        for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) {
            own.clear();
            grower.grow(placing.twigs[i], own);
            for (std::size_t leaf = 0; leaf < own.size(); ++leaf)
                own[leaf].number = static_cast<std::uint32_t>(leaf);
            std::ranges::copy(own, leaves.begin() + static_cast<std::ptrdiff_t>(first[i]));
        }
    });
    return leaves;
}

} // namespace ramure
