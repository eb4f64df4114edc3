/// \file
/// Finds the limb that the hand means, by the branch under the cursor or by selected branches. Limbs are axes
/// (core/skeleton/axes.h) of the tree with its edits so far; the view shows its simplified skeleton.
#pragma once

#include "core/qt/document/document.h"
#include "core/skeleton/axes.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ramure {

/// A place on a limb.
struct LimbHit
{
    NodeId node = noNode;
    Index branch = noIndex;                ///< index in the simplified skeleton
    Index axis = noIndex;                  ///< index in LimbFinder::axes
    std::uint64_t address = 0;             ///< address of the axis
    double share = 0.0;                    ///< place along the axis, as a share of its length from the foot
    glm::dvec3 seen{0.0};                  ///< m, tree space, on the middle of the branch as it is shown
    glm::dvec3 along{0.0};                 ///< unit, tree space: the way of the branch
    double radius = 0.0;                   ///< m
    glm::dvec3 aside{0.0};                 ///< m, tree space: from the middle to where it was hit
    glm::dvec3 side{0.0};                  ///< m, tree space: the same from the centre line of the bark
    std::shared_ptr<const Skeleton> drawn; ///< skeletons of the searched tree, as in TreeResult
    std::shared_ptr<const SimplifiedSkeleton> simplified;
};

/// The part of an axis that a branch of the simplified skeleton covers.
struct LimbSpan
{
    std::uint64_t address = 0;
    double from = 0.0, to = 0.0; ///< m from the foot of the axis
};

/// Searches the trees of the last picture if it knows them, else those of the document.
class LimbFinder
{
public:
    using Shown = std::function<const TreeResult*(NodeId)>;
    void setShown(Shown shown) { m_shown = std::move(shown); }
    /// The tree that it looks in; null where there is none yet, or only an error.
    [[nodiscard]] const TreeResult* tree(const Document& document, NodeId node) const;
    /// Axes of tree(); null if it has none yet.
    const TreeAxes* axes(const Document& document, NodeId node);
    /// Returns nothing unless it is a branch of a tree that may be changed.
    std::optional<LimbHit> at(const Document& document, const PickHit& hit);
    /// Finds a branch by skeletons alone, while the scene to pick in is not ready: objects in front of a
    /// branch do not hide it. Thin branches are hit from a few logical pixels beside them.
    std::optional<LimbHit> under(const Document& document, const PickView& view, const glm::dvec2& pixel);
    /// The side of the place that a ray passes on: LimbHit::side, of a click that is beside the bark.
    [[nodiscard]] glm::dvec3 sideTowards(const Document& document, const LimbHit& hit, const PickView& view,
                                         const glm::dvec2& pixel) const;
    /// Returns the start of a branch of the simplified skeleton on its limb.
    std::optional<LimbHit> startOf(const Document& document, NodeId node, Index branch);
    /// At a share of a branch of the simplified skeleton.
    std::optional<LimbHit> onBranch(const Document& document, NodeId node, Index branch, double share);
    /// Returns the ancestor of this branch order on which \p hit lies, at the place where the twig leaves it.
    /// Returns \p hit itself if there is none, and for order 0.
    LimbHit onLimb(const Document& document, const LimbHit& hit, int order);
    /// All limbs with selected branches where \p hit is one of those and they are several; else \p hit alone.
    std::vector<LimbHit> meantBy(const Document& document, const LimbHit& hit);
    /// The limbs with selected branches, each once, from its lowest selected branch on.
    std::vector<LimbHit> selected(const Document& document);
    /// Returns all branches of the limb of this branch, from foot to tip; the branch alone if it has no limb.
    std::vector<Index> limbOf(const Document& document, NodeId node, Index branch);
    /// Finds branches of tree() in the document's own result. Branches that are gone from it are left out.
    std::vector<Index> inDocument(const Document& document, NodeId node, std::vector<Index> branches) const;
    /// Branches of the simplified skeleton of a limb above that place, with all that grows there. \param
    /// whole from the foot of the limb on
    std::vector<Index> above(const Document& document, const LimbHit& hit, bool whole);
    /// All branches of the limb that an edit acts on; empty: there is no such axis.
    std::vector<Index> limb(const Document& document, NodeId node, std::uint64_t address)
    {
        return axesAt(document, node, {address});
    }
    /// The branches of all axes that have these addresses.
    std::vector<Index> axesAt(const Document& document, NodeId node, std::vector<std::uint64_t> addresses);
    /// By branch of the simplified skeleton; empty where there is none.
    std::vector<LimbSpan> spans(const Document& document, NodeId node);

private:
    std::optional<LimbHit> place(const Document& document, NodeId node, Index branch, double share);
    bool take(const Document& document, NodeId node);

    Shown m_shown;
    std::shared_ptr<const Skeleton> m_drawn; ///< the skeleton that the members below belong to
    std::shared_ptr<const SimplifiedSkeleton> m_simplified;
    TreeAxes m_axes;
    std::vector<double> m_start, m_end; ///< m from the foot of the axis; by branch of the simplified skeleton
};

} // namespace ramure
