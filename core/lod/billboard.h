/// \file
/// Billboards: what stands for a tree that is far away. The mathematics of crossed cards and of an atlas of
/// views from the upper hemisphere, without any drawing. Y is up, metres.
#pragma once

#include "core/base/error.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ramure {

/// How a picture is seen, straight: unit vectors, right-handed. \c backward points to the eye.
struct ViewFrame
{
    glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, backward{0.0, 0.0, 1.0};
};
/// Upright; straight from above or below with +X to the right. \param backward unit
ViewFrame viewFrame(const glm::dvec3& backward);

/// A direction of the upper hemisphere (y >= 0, not zero) as a point of the square -1..1, and back; below the
/// horizon, the horizon. Hemi-octahedral: Cigolle, Donow, Evangelakos, Mara, McGuire, Meyer, "A Survey of
/// Efficient Representations for Independent Unit Vectors" (JCGT 2014), with Y up.
glm::dvec2 hemiOctEncoded(const glm::dvec3& direction);
/// \returns unit
glm::dvec3 hemiOctDecoded(const glm::dvec2& point);

inline constexpr int leastViews = 2, mostViews = 32; ///< of an atlas, each way

/// A view of an atlas: column from the left, row from the top.
struct AtlasCell
{
    int column = 0, row = 0;
    bool operator==(const AtlasCell&) const = default;
};
/// From the tree to the eye, unit. The outermost views stand on the horizon. \pre 0 <= both < views
glm::dvec3 atlasDirection(AtlasCell cell, int views);

/// Those that together know what a direction shows: closer to it than one and a half steps from view to view,
/// row by row; three or more, but of small atlases.
std::vector<AtlasCell> viewsAround(const glm::dvec3& direction, int views);

/// A rectangle in a plane, in metres: x to the right, y up.
struct PlaneRect
{
    glm::dvec2 low{0.0}, high{0.0};
    [[nodiscard]] glm::dvec2 size() const { return high - low; }
    [[nodiscard]] glm::dvec2 centre() const { return 0.5 * (low + high); }
};
/// A rectangle of a picture, in pixels: x from the left, y from the top.
struct PixelRect
{
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PixelRect&) const = default;
};

/// A flat piece that shows the tree from one side.
struct BillboardCard
{
    ViewFrame frame;   ///< it faces \c backward
    PlaneRect seen;    ///< of its plane through the middle, about it
    PixelRect picture; ///< the same in the picture
};

inline constexpr int leastCards = 1, mostCards = 16; ///< that stand

/// What the cards look along: those that stand, evenly turned about the axis, each seen from both sides, and
/// one that lies where \p lying.
std::vector<ViewFrame> cardFrames(int standing, bool lying);
/// Gives every card its place in a square picture: all at one scale, none over another, with \p gap pixels
/// about each; \c seen grows to whole pixels and stays about its middle. Errors: Invalid (a rectangle without
/// extent, or not finite; a size under 16), Limit (they do not fit).
Expected<void> packCards(std::vector<BillboardCard>& cards, int size, int gap);
/// Two triangles a card, each with its own four corners, their texture coordinates (v up) and the card's
/// normal. \param middle what \c seen counts from \param size of the picture
TriangleMesh cardMesh(std::span<const BillboardCard> cards, const glm::dvec3& middle, int size);

} // namespace ramure
