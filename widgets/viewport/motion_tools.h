/// \file
/// What the mouse does to moving trees: which branch or apple is under it, where a pull goes, and the arrow
/// that stands for the wind. Functions of cameras and plain data: tested without OpenGL.
#pragma once

#include "core/document/document.h"
#include "core/document/motion.h"
#include "widgets/render/pick_scene.h"
#include <optional>

namespace ramure {

/// A place on a branch that the hand holds.
struct GrabbedBranch
{
    NodeId node = noNode;
    Index branch = noIndex;
    double along = 1.0;    ///< 0 at its start .. 1 at its end
    glm::dvec3 point{0.0}; ///< world, where it was grabbed
};

/// The branch whose axis is nearest to the cursor, within \p tolerance logical pixels; of several equally
/// near the one in front. Only of trees that are shown, not locked, and part of the frame.
std::optional<GrabbedBranch> branchUnder(const PickView& view, const glm::dvec2& pixel,
                                         const Document& document, const MotionFrame& frame,
                                         double tolerance = 12.0);

/// Where the hand is: under the cursor, as far from the eye as \p held. World.
glm::dvec3 pulledTo(const PickView& view, const glm::dvec2& pixel, const glm::dvec3& held);

struct AppleUnder
{
    NodeId node = noNode;
    Index apple = 0; ///< position in Foliage::apples
};
/// The frontmost apple that covers the cursor.
std::optional<AppleUnder> appleUnder(const PickView& view, const glm::dvec2& pixel, const Document& document,
                                     const MotionFrame& frame);

/// The wind of one tree: from beside its foot, as long as the wind is strong. World.
struct WindArrow
{
    glm::dvec3 foot{0.0};
    glm::dvec3 head{0.0};
    double metresPerStrength = 1.0;
};
/// \param box of the tree, its own space. Nothing for nodes that are no trees.
std::optional<WindArrow> windArrow(const Scene& scene, NodeId node, const Box& box);
/// The arrow's parameters when its head is dragged under the cursor, in the horizontal plane of its foot:
/// strength 0 to the most the table allows, and direction (rad about +Y from +X, in the tree's own space).
struct WindValues
{
    double strength = 0.0;
    double directionRad = 0.0;
};
std::optional<WindValues> windAt(const PickView& view, const glm::dvec2& pixel, const WindArrow& arrow,
                                 const Scene& scene, NodeId node);

} // namespace ramure
