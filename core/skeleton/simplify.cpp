#include "core/skeleton/simplify.h"

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

std::vector<Run> findRuns(const Skeleton& skeleton, const AngleTest& angle, std::vector<Index>& runOf)
{
    const std::vector<Index> children = countChildren(skeleton);
    std::vector<Run> runs;
    runs.reserve(skeleton.size());
    for (Index i = 0; i < skeleton.size(); ++i) {
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
    return runs;
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
    SimplifiedSkeleton result;
    result.mergedInto.resize(skeleton.size());
    const std::vector<Run> runs = findRuns(skeleton, AngleTest(rotationThresholdRad), result.mergedInto);
    Skeleton& out = result.skeleton;
    out.parent = gathered(skeleton.parent, runs, &Run::first);
    for (Index& parent : out.parent)
        parent = parent == noIndex ? noIndex : result.mergedInto[parent];
    out.p0 = gathered(skeleton.p0, runs, &Run::first);
    out.p1 = gathered(skeleton.p1, runs, &Run::last);
    out.a0 = gathered(skeleton.a0, runs, &Run::first);
    out.a1 = gathered(skeleton.a1, runs, &Run::last);
    out.level = gathered(skeleton.level, runs, &Run::first);
    out.key = gathered(skeleton.key, runs, &Run::first);
    out.source = gathered(skeleton.source, runs, &Run::first);
    return result;
}

} // namespace ramure
