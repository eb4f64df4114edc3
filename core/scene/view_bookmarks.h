/// \file
/// Views that the artist keeps, to come back to: where the camera stands and how it looks. Saved in the
/// project; no picture of its own, nothing moves.
#pragma once

#include "core/base/error.h"
#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace ramure {

/// A camera that turns about a target, as in widgets/view/render/camera.h.
struct ViewBookmark
{
    glm::dvec3 target{0.0, 1.0, 0.0}; ///< world, m
    double distance = 5.0;            ///< from the eye to the target, m
    double yawRad = 0.0;
    double pitchRad = 0.0; ///< -pi/2 .. pi/2
    double fovRad = 0.69;  ///< vertical opening
    bool orthographic = false;
    bool operator==(const ViewBookmark&) const = default;
};

inline constexpr std::size_t viewBookmarkCount = 9;
/// The bookmarks; the index is their digit less one.
using ViewBookmarks = std::array<std::optional<ViewBookmark>, viewBookmarkCount>;

/// Errors: Invalid, path = the field ("distance").
Expected<void> checkViewBookmark(const ViewBookmark& bookmark);

} // namespace ramure
