/// \file
/// Mouse actions on moving trees: finds the branch or apple under the mouse, the target of a pull, and the
/// arrow that shows the wind. The functions take cameras and plain data, so they are tested without OpenGL.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/document/document.h"
#include "core/qt/session/motion/motion.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace ramure {

/// A place on a branch that the hand holds.
struct GrabbedBranch
{
    NodeId node = noNode;
    Index branch = noIndex;
    double along = 1.0;    ///< 0 at its start .. 1 at its end
    glm::dvec3 point{0.0}; ///< world, where it was grabbed
};

/// A tree as it stands in a picture.
struct StandingTree
{
    NodeId node = noNode;
    glm::dmat4 world{1.0};
    const Skeleton* skeleton = nullptr;                 ///< simplified
    const std::vector<RigidTransform>* bones = nullptr; ///< by branch; null: at rest
    const std::vector<Index>* branches = nullptr;       ///< that count; null: all
};
/// The branch whose axis is nearest to the cursor, within \p tolerance logical pixels; of several equally
/// near the one in front. Only of trees that are shown, not locked, and part of the frame.
std::optional<GrabbedBranch> branchUnder(const PickView& view, const glm::dvec2& pixel,
                                         const Document& document, const MotionFrame& frame,
                                         double tolerance = 12.0);
/// The same of given trees.
std::optional<GrabbedBranch> branchUnder(const PickView& view, const glm::dvec2& pixel,
                                         std::span<const StandingTree> trees, double tolerance);

/// Returns the place of the hand in the world: under the cursor, as far from the eye as \p held.
glm::dvec3 pulledTo(const PickView& view, const glm::dvec2& pixel, const glm::dvec3& held);

struct AppleUnder
{
    NodeId node = noNode;
    Index apple = 0; ///< position in Foliage::apples
};
/// The frontmost apple that covers the cursor.
std::optional<AppleUnder> appleUnder(const PickView& view, const glm::dvec2& pixel, const Document& document,
                                     const MotionFrame& frame);

/// The wind of one tree: over its crown, the longer the stronger the wind, and of about the same size on the
/// screen wherever the tree stands: no wind is so strong that the head leaves the window. World.
struct WindArrow
{
    NodeId node = noNode;
    glm::dvec3 foot{0.0};
    glm::dvec3 head{0.0};
    double reach = 1.0; ///< m: as long as for a wind without end
};
/// Returns the arrow of the tree's present wind, from \p foot. Nothing for nodes that are no trees.
std::optional<WindArrow> windArrow(const EvaluatedScene& now, NodeId node, const glm::dvec3& foot,
                                   double reach);
/// The same, standing on the tree as \p view sees it. \p stay: moved to where all of it is in the picture.
/// \param box of the tree, its own space. Nothing where that is empty, or, for one that may not move, behind
/// the eye.
std::optional<WindArrow> windArrowOver(const EvaluatedScene& now, NodeId node, const Box& box,
                                       const PickView& view, bool stay);
/// The parameters for an arrow whose head is dragged under the cursor, in the horizontal plane of its foot:
/// strength from 0 to the table's maximum, and direction (rad about +Y from +X, in the tree's own space). If
/// that plane is seen from its edge, the head moves across the picture only.
struct WindValues
{
    double strength = 0.0;
    double directionRad = 0.0;
};
std::optional<WindValues> windAt(const PickView& view, const glm::dvec2& pixel, const WindArrow& arrow,
                                 const EvaluatedScene& now);
/// Why there is no wind to show in this scene: no tree, or none that is selected or has wind.
enum class NoWind : std::uint8_t { NoTree, NoneChosen };
/// The trees whose wind is shown: the active one, and all shown ones that have wind; at most \p most.
std::variant<std::vector<NodeId>, NoWind> windyTrees(const Scene& scene, NodeId active, std::size_t most);

} // namespace ramure
