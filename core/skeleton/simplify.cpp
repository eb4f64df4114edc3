#include "core/skeleton/simplify.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace ramure {
namespace {

/// Is the angle between two directions below a threshold? Compares squared tangents, |cross|² with tan² ·
/// dot²: exact to rounding for the smallest angles, where a cosine would see nothing, and free of inverse
/// functions.
class AngleTest
{
public:
    explicit AngleTest(double thresholdRad)
        : m_never(!(thresholdRad > 0.0))
        , m_always(thresholdRad > std::numbers::pi)
        , m_acute(thresholdRad <= std::numbers::pi / 2)
        , m_squaredTangent(maths::tan(thresholdRad) * maths::tan(thresholdRad))
    {
    }

    [[nodiscard]] bool isBelow(const glm::dvec3& a, const glm::dvec3& b) const
    {
        const glm::dvec3 normal = glm::cross(a, b);
        const double across = glm::dot(normal, normal);
        const double along = glm::dot(a, b);
        const double bound = m_squaredTangent * along * along;
        const bool below = m_acute ? along > 0.0 && across < bound : along > 0.0 || across > bound;
        // A branch without length has no direction to turn to.
        const bool straight = across == 0.0 && along == 0.0;
        return !m_never && (m_always || straight || below);
    }

private:
    bool m_never, m_always, m_acute;
    double m_squaredTangent;
};

std::vector<Index> countChildren(const Skeleton& skeleton)
{
    std::vector<Index> counts(skeleton.size(), 0);
    for (const Index parent : skeleton.parent)
        if (parent != noIndex)
            ++counts[parent];
    return counts;
}

/// The branch as a new one of the result.
void append(const Skeleton& skeleton, Index i, Index parent, Skeleton& out)
{
    out.parent.push_back(parent);
    out.p0.push_back(skeleton.p0[i]);
    out.p1.push_back(skeleton.p1[i]);
    out.a0.push_back(skeleton.a0[i]);
    out.a1.push_back(skeleton.a1[i]);
    out.level.push_back(skeleton.level[i]);
    out.key.push_back(skeleton.key[i]);
    out.source.push_back(skeleton.source[i]);
}

/// Leaves may end where a branch does.
bool differs(const std::vector<bool>& bare, Index a, Index b)
{
    return !bare.empty() && bare[a] != bare[b];
}

/// By branch; empty where leaves grow on all.
std::vector<bool> bareBranches(const Skeleton& skeleton)
{
    if (skeleton.bare.empty())
        return {};
    std::vector<bool> bare(skeleton.size(), false);
    for (const Index i : skeleton.bare)
        bare[i] = true;
    return bare;
}

/// In the order of the branches: whether the next that rolls is this one.
bool isNext(const Skeleton& skeleton, std::size_t& roll, Index branch)
{
    const bool rolls = roll < skeleton.rolls.size() && skeleton.rolls[roll].first == branch;
    roll += rolls ? 1 : 0;
    return rolls;
}

/// What goes on from the branch before it does not bend by more.
struct MostBend
{
    AngleTest angle;
    OutlineLimits limits;

    [[nodiscard]] bool allows(const Skeleton& merged, Index into, const Skeleton& skeleton, Index i) const
    {
        const glm::dvec3 before = merged.p1[into] - merged.p0[into], way = skeleton.p1[i] - skeleton.p0[i];
        return angle.isBelow(before, way) &&
               (std::isinf(limits.taper) ||
                std::abs(taperOf(merged, into) - taperOf(skeleton, i)) < limits.taper) &&
               (std::isinf(limits.aside) || isArcFlat(before, way, 2.0 * merged.a0[into]));
    }
    /// An arc that ends an angle a from its chord, of length c, is about c sin(a) / 4 high.
    [[nodiscard]] bool isArcFlat(const glm::dvec3& chord, const glm::dvec3& way, double thick) const
    {
        return 0.25 * thick * glm::length(glm::cross(chord, way)) <
               limits.aside * limits.aside * glm::length(way);
    }
};

/// Continues for the branches from \p from up to \p to.
void merge(const Skeleton& skeleton, const MostBend& most, const std::vector<Index>& children,
           const std::vector<bool>& bare, Index from, Index to, SimplifiedSkeleton& result)
{
    Skeleton& out = result.skeleton;
    std::vector<Index>& mergedInto = result.mergedInto;
    std::size_t roll = out.rolls.size(); // each begins a branch of the result
    for (Index i = from; i < to; ++i) {
        const bool rolls = isNext(skeleton, roll, i);
        const Index parent = skeleton.parent[i];
        const Index into = parent == noIndex ? noIndex : mergedInto[parent];
        if (parent != noIndex && children[parent] == 1 && !rolls && !differs(bare, i, parent) &&
            most.allows(out, into, skeleton, i)) {
            out.p1[into] = skeleton.p1[i];
            out.a1[into] = skeleton.a1[i];
            mergedInto[i] = into;
            continue;
        }
        mergedInto[i] = out.size();
        append(skeleton, i, into, out);
        if (rolls)
            out.rolls.emplace_back(mergedInto[i], skeleton.rolls[roll - 1].second);
        if (!bare.empty() && bare[i])
            out.bare.push_back(mergedInto[i]);
    }
}

/// Organs stay where they are, on the branch that took theirs in.
void moveOrgans(const Skeleton& skeleton, SimplifiedSkeleton& result)
{
    Skeleton& out = result.skeleton;
    out.organs = skeleton.organs;
    for (Organ& organ : out.organs) {
        const Index from = organ.branch, into = result.mergedInto[from];
        const glm::dvec3 place = glm::mix(skeleton.p0[from], skeleton.p1[from], organ.share) + organ.offset;
        const glm::dvec3 way = out.p1[into] - out.p0[into];
        const double squared = glm::dot(way, way);
        organ.branch = into;
        organ.axis = squared > 0.0 ? way / std::sqrt(squared) : organ.axis;
        organ.share =
            squared > 0.0 ? std::clamp(glm::dot(place - out.p0[into], way) / squared, 0.0, 1.0) : 1.0;
        organ.offset = place - glm::mix(out.p0[into], out.p1[into], organ.share);
    }
}

} // namespace

double taperOf(const Skeleton& skeleton, Index branch)
{
    const double length = skeleton.length(branch);
    return length > 0.0 ? (skeleton.a0[branch] - skeleton.a1[branch]) / length : 0.0;
}

SimplifiedSkeleton simplify(const Skeleton& skeleton, double rotationThresholdRad)
{
    return *simplify(skeleton, rotationThresholdRad, {}); // nobody can cancel it
}

Expected<SimplifiedSkeleton> simplify(const Skeleton& skeleton, double rotationThresholdRad,
                                      const Progress& progress, const OutlineLimits& limits)
{
    SimplifiedSkeleton result;
    result.mergedInto.resize(skeleton.size());
    const MostBend most{AngleTest(rotationThresholdRad), limits};
    const std::vector<Index> children = countChildren(skeleton);
    const std::vector<bool> bare = bareBranches(skeleton);
    result.skeleton.reserve(skeleton.size());
    constexpr Index stride = Index(1) << 19;
    for (Index from = 0; from < skeleton.size(); from += stride) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        merge(skeleton, most, children, bare, from, std::min(skeleton.size(), from + stride), result);
    }
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    moveOrgans(skeleton, result);
    for (const Index i : skeleton.sawn)
        if (children[i] == 0)
            result.skeleton.sawn.push_back(result.mergedInto[i]);
    for (const LooseLimb& limb : skeleton.loose)
        result.skeleton.loose.push_back({result.mergedInto[limb.first],
                                         limb.stump == noIndex ? noIndex : result.mergedInto[limb.stump],
                                         limb.seconds});
    return result;
}

} // namespace ramure
