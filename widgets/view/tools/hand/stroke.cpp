#include "widgets/view/tools/hand/stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr std::size_t mostPoints = 40, leastPoints = 4;
constexpr std::size_t densePoints = 160; ///< in which it is smoothed
constexpr int mostRounds = 400;          ///< of smoothing

double lengthOf(const std::vector<StrokePoint>& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::length(points[i].position - points[i - 1].position);
    return length;
}

/// The same way in so many points, evenly.
std::vector<StrokePoint> spaced(const std::vector<StrokePoint>& points, double length, std::size_t count)
{
    std::vector<StrokePoint> even{points.front()};
    double passed = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = glm::length(points[i].position - points[i - 1].position);
        while (even.size() + 1 < count) {
            const double wanted = length * double(even.size()) / double(count - 1);
            if (wanted > passed + step || step == 0.0)
                break;
            const double share = (wanted - passed) / step;
            even.push_back({glm::mix(points[i - 1].position, points[i].position, share),
                            glm::mix(points[i - 1].radius, points[i].radius, share)});
        }
        passed += step;
    }
    even.push_back(points.back());
    return even;
}

void smooth(std::vector<StrokePoint>& points, int rounds)
{
    for (int round = 0; round < rounds; ++round) {
        StrokePoint before = points.front();
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const StrokePoint here = points[i];
            points[i].position = 0.25 * before.position + 0.5 * here.position + 0.25 * points[i + 1].position;
            points[i].radius = 0.25 * before.radius + 0.5 * here.radius + 0.25 * points[i + 1].radius;
            before = here;
        }
    }
}

} // namespace

std::vector<StrokePoint> strokeBranch(const std::vector<StrokePoint>& drawn, const StrokeShape& shape)
{
    const double length = lengthOf(drawn);
    if (drawn.size() < 2 || !(length > std::max(shape.footRadius, 1e-6)))
        return {};
    std::vector<StrokePoint> dense = spaced(drawn, length, densePoints);
    smooth(dense, static_cast<int>(std::round(shape.smoothing * shape.smoothing * mostRounds)));
    const double smoothed = lengthOf(dense);
    // As long as the branch is thick twice over, as the crossing of forks is.
    const double wanted = smoothed / (2.0 * std::max(shape.footRadius, 1e-6));
    const auto count =
        static_cast<std::size_t>(std::clamp(std::round(wanted), double(leastPoints), double(mostPoints)));
    std::vector<StrokePoint> points = spaced(dense, smoothed, count);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double share = double(i) / double(points.size() - 1);
        points[i].radius *= glm::mix(shape.footRadius, shape.tipRadius, share);
    }
    return points;
}

} // namespace ramure
