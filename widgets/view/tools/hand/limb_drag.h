/// \file
/// Grab a twig: the hand drags a branch of a tree at rest, the limb it grows on follows
/// (core/rig/arm/limb.h). What is thicker than twice the grabbed branch stays, and the root, unless the hand
/// says otherwise. Knows cameras and the document, no window.
///
/// The drag itself changes only bends(), for a view to show as a pose; apply() gives them to the document, as
/// one Bend step for each branch that turns.
#pragma once

#include "core/rig/arm/limb.h"
#include "widgets/view/render/pick/pick_scene.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include "widgets/view/tools/hand/symmetry.h"
#include <memory>

namespace ramure {

/// A branch that turns as another one does.
struct BranchTwin
{
    Index from = noIndex, to = noIndex; ///< of the simplified skeleton
    SymmetryMap map;
};

class LimbDrag
{
public:
    static constexpr std::size_t usualBranches = 8, mostBranches = 64;

    /// Null where the hit is no branch of a tree that may be changed. \p document is not owned.
    /// \param branches follow at most
    static std::unique_ptr<LimbDrag> grab(Document& document, const PickHit& hit, std::size_t branches);
    /// What else turns with the limb, from now on.
    void setTwins(std::vector<BranchTwin> twins) { m_twins = std::move(twins); }
    /// The grabbed place comes under the cursor, as far from the eye as it was.
    void dragTo(const PickView& view, const glm::dvec2& pixel);
    /// What is thick follows, too (Shift). The drag goes on where it is.
    void setWhole(bool whole);
    /// So many branches follow from now on, however thick; clamped. The drag goes on where it is.
    void setBranches(std::size_t branches);

    /// The document gets the bends; the whole drag is one undo step. \return false where it has them already
    bool apply();
    void keep() { m_edit->keep(); } ///< what was applied becomes a step of undo
    /// Everything as it was, the undo stack too; nothing where the document has ended the gesture.
    void cancel() { m_edit->cancel(); }

    [[nodiscard]] NodeId node() const { return m_node; }
    /// By branch of skeleton(): as they were, as the document has them, and as the hand wants them.
    [[nodiscard]] std::vector<glm::dvec3> bendsAtGrab() const;
    [[nodiscard]] std::vector<glm::dvec3> bendsNow() const;
    [[nodiscard]] std::vector<glm::dvec3> bends() const;
    [[nodiscard]] const std::shared_ptr<const SimplifiedSkeleton>& skeleton() const { return m_skeleton; }
    [[nodiscard]] std::size_t branches() const { return m_limb.branchCount(); } ///< that follow
    [[nodiscard]] const glm::dvec3& hand() const { return m_hand; }             ///< world
    [[nodiscard]] double shortBy() const { return m_shortBy; }                  ///< m, tree space

private:
    LimbDrag(Document& document, const PickHit& hit, const TreeResult& tree, std::size_t branches,
             std::unique_ptr<HandEdit> edit);
    [[nodiscard]] Limb limb() const;
    void takeLimb();
    void pull();

    Document& m_document;
    NodeId m_node;
    Index m_branch;
    std::size_t m_wanted;   ///< branches, where nothing stays
    bool m_whole = false;   ///< nothing stays: while Shift is held
    bool m_counted = false; ///< nothing stays: the wheel has said how many follow
    std::unique_ptr<HandEdit> m_edit;
    std::vector<glm::dvec3> m_applied;                    ///< bends(); empty: nothing was applied yet
    std::shared_ptr<const SimplifiedSkeleton> m_skeleton; ///< when it was grabbed
    TreeAxes m_axes;                                      ///< axes of what it was made of
    Limb m_limb;
    std::vector<BranchTwin> m_twins;
    glm::dmat4 m_world, m_inverse;
    glm::dvec3 m_grabbed, m_hand; ///< world
    double m_shortBy = 0.0;
};

} // namespace ramure
