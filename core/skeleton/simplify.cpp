#include "core/skeleton/simplify.h"

#include <algorithm>
#include <cmath>
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
        , m_squaredTangent(std::tan(thresholdRad) * std::tan(thresholdRad))
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

/// A run of merged branches: a branch of the result.
struct Run
{
    Index first, last;
};

std::vector<Index> countChildren(const Skeleton& skeleton)
{
    std::vector<Index> counts(skeleton.size(), 0);
    for (const Index parent : skeleton.parent)
        if (parent != noIndex)
            ++counts[parent];
    return counts;
}

/// Continues for the branches from \p from up to \p to.
void findRuns(const Skeleton& skeleton, const AngleTest& angle, const std::vector<Index>& children,
              Index from, Index to, std::vector<Run>& runs, std::vector<Index>& runOf)
{
    for (Index i = from; i < to; ++i) {
        const Index parent = skeleton.parent[i];
        if (parent != noIndex && children[parent] == 1) {
            Run& run = runs[runOf[parent]];
            const glm::dvec3 merged = skeleton.p1[run.last] - skeleton.p0[run.first];
            if (angle.isBelow(merged, skeleton.p1[i] - skeleton.p0[i])) {
                run.last = i;
                runOf[i] = runOf[parent];
                continue;
            }
        }
        runOf[i] = static_cast<Index>(runs.size());
        runs.push_back({i, i});
    }
}

/// Memory is written once, not first with zeros.
template <class T>
std::vector<T> gathered(const std::vector<T>& from, const std::vector<Run>& runs, Index Run::*end)
{
    std::vector<T> picked;
    picked.reserve(runs.size());
    for (const Run& run : runs)
        picked.push_back(from[run.*end]);
    return picked;
}

} // namespace

SimplifiedSkeleton simplify(const Skeleton& skeleton, double rotationThresholdRad)
{
    return *simplify(skeleton, rotationThresholdRad, {}); // nobody can cancel it
}

Expected<SimplifiedSkeleton> simplify(const Skeleton& skeleton, double rotationThresholdRad,
                                      const Progress& progress)
{
    const auto cancelled = [&progress] { return progress.cancelled(); };
    const auto stopped = [] { return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")); };
    SimplifiedSkeleton result;
    result.mergedInto.resize(skeleton.size());
    const AngleTest angle(rotationThresholdRad);
    const std::vector<Index> children = countChildren(skeleton);
    std::vector<Run> runs;
    runs.reserve(skeleton.size());
    constexpr Index stride = Index(1) << 19;
    for (Index from = 0; from < skeleton.size(); from += stride) {
        if (cancelled())
            return stopped();
        findRuns(skeleton, angle, children, from, std::min(skeleton.size(), from + stride), runs,
                 result.mergedInto);
    }
    Skeleton& out = result.skeleton;
    out.parent = gathered(skeleton.parent, runs, &Run::first);
    for (Index& parent : out.parent)
        parent = parent == noIndex ? noIndex : result.mergedInto[parent];
    const auto gather = [&](auto Skeleton::*values, Index Run::*end) {
        if (!cancelled())
            out.*values = gathered(skeleton.*values, runs, end);
    };
    gather(&Skeleton::p0, &Run::first);
    gather(&Skeleton::p1, &Run::last);
    gather(&Skeleton::a0, &Run::first);
    gather(&Skeleton::a1, &Run::last);
    gather(&Skeleton::level, &Run::first);
    gather(&Skeleton::key, &Run::first);
    gather(&Skeleton::source, &Run::first);
    if (cancelled())
        return stopped();
    return result;
}

} // namespace ramure
