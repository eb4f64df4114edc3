#include "core/print/notch_fill.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr float far = 1e9F;
/// Distances are up to so many steps too short: what they say of flat places must not move these.
constexpr float slack = 0.1F;
/// The grid takes some of a fillet.
constexpr double fillet = 1.15 * leastFillet;
constexpr double deepest = 1.5;   ///< steps below the new surface that are told apart
constexpr double leastSine = 0.5; ///< of the angle between branches; sharper forks are filled as far as that

double sineBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0 ? std::max(leastSine, glm::length(glm::cross(a, b)) / lengths) : 1.0;
}

/// By point of a lattice the least of a weight at a point and the way from there: of the sources that a
/// point's neighbours have found, the best is taken (Danielsson 1980, with weights).
class NearestSource
{
public:
    explicit NearestSource(const glm::ivec3& size)
        : m_size(size)
        , m_source(count(), -1)
        , m_weight(count(), far)
        , m_best(count(), far)
    {
    }

    void add(std::size_t at, float weight)
    {
        m_source[at] = static_cast<int>(at);
        m_weight[at] = m_best[at] = weight;
    }

    const std::vector<float>& run()
    {
        sweep(1);
        sweep(-1);
        return m_best;
    }

private:
    [[nodiscard]] std::size_t count() const
    {
        return std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z);
    }
    [[nodiscard]] int at(const glm::ivec3& p) const { return (p.z * m_size.y + p.y) * m_size.x + p.x; }
    [[nodiscard]] glm::ivec3 place(int i) const
    {
        return {i % m_size.x, i / m_size.x % m_size.y, i / (m_size.x * m_size.y)};
    }

    void sweep(int way)
    {
        const glm::ivec3 last = m_size - 1;
        for (int k = 0; k <= last.z; ++k)
            for (int j = 0; j <= last.y; ++j)
                for (int i = 0; i <= last.x; ++i)
                    take(way > 0 ? glm::ivec3(i, j, k) : last - glm::ivec3(i, j, k), way);
    }

    /// From the 13 neighbours that a sweep has passed.
    void take(const glm::ivec3& p, int way)
    {
        const auto here = static_cast<std::size_t>(at(p));
        for (int n = 0; n < 13; ++n) {
            const glm::ivec3 q = p + way * glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (q.x < 0 || q.y < 0 || q.z < 0 || q.x >= m_size.x || q.y >= m_size.y || q.z >= m_size.z)
                continue;
            const int source = m_source[static_cast<std::size_t>(at(q))];
            if (source < 0 || source == m_source[here])
                continue;
            const glm::vec3 gap(p - place(source));
            const float value = m_weight[static_cast<std::size_t>(source)] + std::sqrt(glm::dot(gap, gap));
            if (value < m_best[here]) {
                m_best[here] = value;
                m_source[here] = source;
            }
        }
    }

    glm::ivec3 m_size;
    std::vector<int> m_source;
    std::vector<float> m_weight, m_best;
};

/// Distances beyond the band, from those in it.
std::vector<float> allDistances(const DistanceBox& box)
{
    NearestSource nearest(box.size);
    for (std::size_t i = 0; i < box.values.size(); ++i)
        if (std::abs(box.values[i]) < 0.99F * box.band)
            nearest.add(i, box.values[i]);
    std::vector<float> all = nearest.run();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (box.values[i] < 0.99F * box.band)
            all[i] = box.values[i];
    return all;
}

/// From a point to one beside it.
struct Step
{
    std::ptrdiff_t by;
    float length;
};

/// The nearest first.
std::vector<Step> stepsWithin(double radius, const DistanceBox& box)
{
    const int most = static_cast<int>(std::ceil(radius));
    std::vector<Step> steps;
    for (int z = -most; z <= most; ++z)
        for (int y = -most; y <= most; ++y)
            for (int x = -most; x <= most; ++x) {
                const double length = glm::length(glm::dvec3(x, y, z));
                if (length <= radius)
                    steps.push_back(
                        {(std::ptrdiff_t(z) * box.size.y + y) * box.size.x + x, static_cast<float>(length)});
            }
    std::stable_sort(steps.begin(), steps.end(),
                     [](const Step& a, const Step& b) { return a.length < b.length; });
    return steps;
}

/// How far a point lies outside of the nearest ball that has room, or, negative, how far it lies from all.
float filledValue(const std::vector<float>& distance, const std::vector<float>& room, std::size_t here,
                  const std::vector<Step>& steps)
{
    float best = -float(deepest);
    for (const Step& step : steps) {
        const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(here) + step.by);
        if (distance[at] > 0.0F && distance[at] >= room[at])
            best = std::max(best, distance[at] - step.length);
        if (best + slack >= distance[here])
            return distance[here]; // no notch
    }
    return best + slack;
}

} // namespace

std::vector<NotchBall> notchBalls(const Skeleton& skeleton)
{
    std::vector<Index> thickest(skeleton.size(), noIndex); // of the children
    for (Index i = 0; i < skeleton.size(); ++i) {
        const Index parent = skeleton.parent[i];
        if (parent != noIndex &&
            (thickest[parent] == noIndex || skeleton.a0[i] > skeleton.a0[thickest[parent]]))
            thickest[parent] = i;
    }
    std::vector<NotchBall> balls;
    for (Index i = 0; i < skeleton.size(); ++i) {
        const Index parent = skeleton.parent[i], main = parent == noIndex ? noIndex : thickest[parent];
        const glm::dvec3 way = skeleton.p1[i] - skeleton.p0[i];
        const double length = glm::length(way);
        if (main == noIndex || main == i || !(length > 0.0))
            continue;
        const double sine = std::min(sineBetween(way, skeleton.p1[main] - skeleton.p0[main]),
                                     sineBetween(way, skeleton.p1[parent] - skeleton.p0[parent]));
        const double thin = skeleton.a0[i], thick = std::max(skeleton.a0[main], skeleton.a1[parent]);
        // A ball that touches both lies so far from the axis of the thick one, and so far along it from where
        // the other crosses.
        NotchBall ball;
        ball.radius = fillet * thin;
        ball.centre = skeleton.p0[i] + way / length * ((thick + ball.radius) / sine);
        ball.inner = (thin + ball.radius) / sine + ball.radius;
        ball.outer = 1.4 * ball.inner;
        balls.push_back(ball);
    }
    return balls;
}

std::vector<float> withFilledNotch(const DistanceBox& box, const NotchBall& ball)
{
    const bool isInBand = ball.radius + 1.0 < double(box.band);
    const std::vector<float> all = isInBand ? std::vector<float>() : allDistances(box);
    const std::vector<float>& distance = isInBand ? box.values : all;
    std::vector<float> room(distance.size()); // what a ball about the point must have to stay outside
    std::size_t i = 0;
    for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
            for (int x = 0; x < box.size.x; ++x, ++i) {
                const double out = glm::distance(glm::dvec3(x, y, z), ball.centre);
                const double share = std::clamp((ball.outer - out) / (ball.outer - ball.inner), 0.0, 1.0);
                room[i] = static_cast<float>(share * ball.radius);
            }
    const std::vector<Step> steps = stepsWithin(ball.radius + deepest, box);
    const glm::ivec3 reach(static_cast<int>(std::ceil(ball.radius + deepest)));
    std::vector<float> filled = box.values;
    glm::ivec3 at;
    for (at.z = reach.z; at.z < box.size.z - reach.z; ++at.z)
        for (at.y = reach.y; at.y < box.size.y - reach.y; ++at.y)
            for (at.x = reach.x; at.x < box.size.x - reach.x; ++at.x) {
                const std::size_t here = box.index(at.x, at.y, at.z);
                if (distance[here] > 0.0F && distance[here] < room[here])
                    filled[here] = filledValue(distance, room, here, steps);
            }
    return filled;
}

} // namespace ramure
