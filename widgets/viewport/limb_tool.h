/// \file
/// Grab a twig: the hand drags a branch of a tree at rest, the limb it grows on follows (core/arm/limb.h).
/// One undo step per drag. Knows cameras and the document, no window.
#pragma once

#include "core/arm/limb.h"
#include "core/document/commands.h"
#include "widgets/render/pick_scene.h"
#include <memory>

namespace ramure {

class LimbTool
{
public:
    static constexpr std::size_t usualBranches = 8, mostBranches = 64;

    /// Null where the hit is no branch of a tree that may be changed. \p document is not owned.
    static std::unique_ptr<LimbTool> grab(Document& document, const PickHit& hit, std::size_t branches);

    /// The grabbed place comes under the cursor, as far from the eye as it was.
    void dragTo(const PickView& view, const glm::dvec2& pixel);
    /// Another number of branches follows from now on; clamped. The drag goes on where it is.
    void setBranches(std::size_t branches);

    [[nodiscard]] std::size_t branches() const { return m_limb.branchCount(); } ///< that follow
    [[nodiscard]] const glm::dvec3& hand() const { return m_hand; }             ///< world
    [[nodiscard]] double shortBy() const { return m_shortBy; }                  ///< m, tree space

private:
    LimbTool(Document& document, const PickHit& hit, const Node& node, const Skeleton& skeleton,
             std::size_t branches);
    void pull();

    Document& m_document;
    NodeId m_node;
    Index m_branch;
    GestureId m_gesture = newGesture();
    Skeleton m_skeleton; ///< when it was grabbed
    Limb::Bends m_bends; ///< likewise
    Limb m_limb;
    glm::dmat4 m_world, m_inverse;
    glm::dvec3 m_grabbed, m_hand; ///< world
    double m_shortBy = 0.0;
};

} // namespace ramure
