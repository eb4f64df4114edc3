#include "core/scene/view_bookmarks.h"

#include "core/math/angle.h"

namespace ramure {

Expected<void> checkViewBookmark(const ViewBookmark& bookmark)
{
    constexpr double farthest = 1e6; // m
    struct Range
    {
        const char* field;
        double value, least, most;
    };
    const Range ranges[] = {
        {"target", bookmark.target.x, -farthest, farthest},
        {"target", bookmark.target.y, -farthest, farthest},
        {"target", bookmark.target.z, -farthest, farthest},
        {"distance", bookmark.distance, 1e-4, farthest},
        {"yaw", bookmark.yawRad, -2.0 * pi, 2.0 * pi},
        {"pitch", bookmark.pitchRad, -0.5 * pi, 0.5 * pi},
        {"fov", bookmark.fovRad, 0.01, 3.0},
    };
    for (const Range& range : ranges)
        if (!(range.value >= range.least && range.value <= range.most)) {
            auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("a camera cannot stand like that"));
            error.value().path = range.field;
            return error;
        }
    return {};
}

} // namespace ramure
