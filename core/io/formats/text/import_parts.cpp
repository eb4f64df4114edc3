#include "core/io/formats/text/import_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

namespace ramure {

Expected<PlacementParams> placementNear(const glm::dmat4& matrix)
{
    const glm::dvec3 length{glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1])),
                            glm::length(glm::dvec3(matrix[2]))};
    if (!(length.x > 0.0 && length.y > 0.0 && length.z > 0.0))
        return decomposePlacement(matrix);
    const glm::dvec3 x = glm::dvec3(matrix[0]) / length.x;
    glm::dvec3 y = glm::dvec3(matrix[1]) / length.y;
    y = glm::normalize(y - x * glm::dot(x, y));
    glm::dvec3 z = glm::cross(x, y);
    if (glm::dot(z, glm::dvec3(matrix[2])) < 0.0)
        z = -z;
    const glm::dmat4 square(glm::dvec4(x * length.x, 0.0), glm::dvec4(y * length.y, 0.0),
                            glm::dvec4(z * length.z, 0.0), matrix[3]);
    constexpr double near = 2e-6; // of an axis, relative
    for (int i = 0; i < 3; ++i)
        if (!(glm::length(square[i] - matrix[i]) <= near * length[i]))
            return decomposePlacement(matrix);
    return decomposePlacement(square);
}

/// The usual rate that puts all keys on frames, if there is one.
static double guessedRate(const std::set<Ticks>& times)
{
    for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 120.0}) {
        const auto onFrame = [rate](Ticks time) {
            const double frame = secondsOf(time) * rate;
            return std::abs(frame - std::round(frame)) < 1e-3;
        };
        if (std::all_of(times.begin(), times.end(), onFrame))
            return rate;
    }
    return 0.0;
}

TimelineSettings timelineOfKeys(std::span<const Node> nodes, double saidRate, std::vector<Note>& notes)
{
    std::set<Ticks> times;
    for (const Node& node : nodes)
        for (const auto& [channel, track] : node.animation.tracks())
            for (std::size_t i = 0; i < keyCount(*track); ++i)
                times.insert(keyShape(*track, i).time);
    TimelineSettings timeline;
    if (times.empty())
        return timeline;
    const double guess = saidRate > 0.0 ? saidRate : guessedRate(times);
    if (guess > 0.0)
        timeline.framesPerSecond = guess;
    if (saidRate == 0.0)
        notes.push_back(fail(ErrorCode::Invalid,
                             RAMURE_NOOP("no file says the frame rate: %1 frames a second are taken"),
                             {std::to_string(static_cast<int>(timeline.framesPerSecond))})
                            .value());
    const auto frame = [&timeline](Ticks time) {
        return std::clamp(
            static_cast<std::int64_t>(std::ceil(secondsOf(time) * timeline.framesPerSecond - 1e-6)),
            leastFrame, mostFrame);
    };
    timeline.firstFrame = std::min<std::int64_t>(0, frame(*times.begin()));
    timeline.lastFrame = std::max(timeline.firstFrame, frame(*times.rbegin()));
    return timeline;
}

} // namespace ramure
