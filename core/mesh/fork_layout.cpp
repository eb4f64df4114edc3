#include "core/mesh/fork_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2.0 * std::numbers::pi;
constexpr double widestAngle = 0.95 * pi; ///< a child straight back has no stereographic place
constexpr int spreadRounds = 60;

/// A direction's place in the plane of the fork: stereographic, so that circles of directions stay circles.
glm::dvec2 stereographic(const Frame& frame, const glm::dvec3& direction)
{
    const glm::dvec2 lateral(glm::dot(direction, frame.normal), glm::dot(direction, frame.binormal));
    const double across = glm::length(lateral);
    const double angle = std::min(std::atan2(across, glm::dot(direction, frame.tangent)), widestAngle);
    const double far = std::tan(0.5 * angle);
    return across > 1e-12 ? lateral * (far / across) : glm::dvec2(far, 0.0);
}

double wrapped(double angle)
{
    return angle - turn * std::floor(angle / turn);
}

} // namespace

/// Pushes the split points apart until neighbours are at least \p gap from each other; where that does not
/// come about, they are spaced evenly.
void ForkPlanner::spread(double gap)
{
    const std::size_t count = m_splits.size();
    const auto gapAfter = [&](std::size_t i) {
        return i + 1 < count ? m_splits[i + 1] - m_splits[i] : m_splits[0] + turn - m_splits[i];
    };
    const auto narrowest = [&] {
        double least = turn;
        for (std::size_t i = 0; i < count; ++i)
            least = std::min(least, gapAfter(i));
        return least;
    };
    for (int round = 0; round < spreadRounds && narrowest() < 0.999 * gap; ++round)
        for (std::size_t i = 0; i < count; ++i) {
            const double lack = gap - gapAfter(i);
            if (lack <= 0.0)
                continue;
            m_splits[i] -= 0.5 * lack;
            m_splits[i + 1 < count ? i + 1 : 0] += 0.5 * lack;
        }
    if (narrowest() >= 0.3 * gap)
        return;
    double shift = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        shift += m_splits[i] - turn * static_cast<double>(i) / static_cast<double>(count);
    shift /= static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i)
        m_splits[i] = shift + turn * static_cast<double>(i) / static_cast<double>(count);
}

/// Adds the regular points of the ring that are not too near to a split point.
void ForkPlanner::fillRing(int radialDivisions, ForkLayout& layout)
{
    const double pitch = turn / radialDivisions;
    const double keepOff = 0.42 * pitch;
    const std::size_t count = m_splits.size();
    layout.azimuths.clear();
    layout.splitPoint.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const double from = m_splits[i];
        const double to = i + 1 < count ? m_splits[i + 1] : m_splits[0] + turn;
        layout.splitPoint.push_back(static_cast<Index>(layout.azimuths.size()));
        layout.azimuths.push_back(from);
        for (auto k = static_cast<std::int64_t>(std::floor(from / pitch)); double(k) * pitch < to; ++k) {
            const double azimuth = static_cast<double>(k) * pitch;
            if (azimuth > from + keepOff && azimuth < to - keepOff)
                layout.azimuths.push_back(azimuth);
        }
    }
    while (layout.azimuths.size() < 3) { // two split points and no room beside them: halve the wider side
        const double first = layout.azimuths[0], second = layout.azimuths[1];
        if (second - first >= pi) {
            layout.azimuths.insert(layout.azimuths.begin() + 1, 0.5 * (first + second));
            layout.splitPoint[1] = 2;
        } else {
            layout.azimuths.push_back(0.5 * (second + first + turn));
        }
    }
}

void ForkPlanner::plan(const Frame& frame, std::span<const glm::dvec3> directions, int radialDivisions,
                       ForkLayout& layout)
{
    m_sites.clear();
    for (const glm::dvec3& direction : directions)
        m_sites.push_back(stereographic(frame, direction));
    layout.triangulation.build(m_sites);

    const auto& hull = layout.triangulation.hull();
    m_splits.clear();
    for (const ForkTriangulation::HullEdge& edge : hull) {
        const glm::dvec2 along = layout.triangulation.place(edge.to) - layout.triangulation.place(edge.from);
        double azimuth = wrapped(std::atan2(-along.x, along.y)); // of the outward normal (y, -x)
        // The hull is convex: its normals turn one way, once around.
        if (!m_splits.empty()) {
            const double step = wrapped(azimuth - m_splits.back());
            azimuth = m_splits.back() + (step > turn - 1e-6 ? 0.0 : step);
        }
        m_splits.push_back(azimuth);
    }
    const auto count = static_cast<double>(hull.size());
    spread(std::min(pi / radialDivisions, 0.8 * turn / count));
    fillRing(radialDivisions, layout);
}

} // namespace ramure
