/// \file
/// One gesture that edits a tree (core/params/tree_edit.h). Its effect is visible at once, and becomes one
/// step of the undo stack when it is kept.
#pragma once

#include "core/qt/document/commands.h"
#include "core/recipe/edit_context.h"
#include "widgets/view/tools/limb_finder.h"
#include <memory>

namespace ramure {

/// The loss that a gesture would cause to the tree on show.
struct HandLoss
{
    std::vector<Index> branches; ///< indices in the simplified skeleton; more than half of each goes
    double metres = 0.0;         ///< length of the wood
};

class HandEdit
{
public:
    /// Errors: Unknown (node), Invalid (locked, no tree, not grown). \p document is not owned.
    static Expected<std::unique_ptr<HandEdit>> begin(Document& document, NodeId tree);
    ~HandEdit(); ///< calls keep()
    HandEdit(const HandEdit&) = delete;
    HandEdit& operator=(const HandEdit&) = delete;

    [[nodiscard]] NodeId node() const { return m_node; }
    /// The tree before the gesture, with the edits added since.
    [[nodiscard]] const EditContext& context() const { return m_context; }
    /// One more edit, which names its limbs by their addresses, behind those before it: made ready, tried and
    /// applied to the context. \param inTreeSpace see EditContext::prepared. Errors: why not; then nothing
    /// changes.
    Expected<void> add(const TreeEdit& edit, bool inTreeSpace = true);
    /// The added edits, with their ids once they were shown. Change their numbers, then call show().
    [[nodiscard]] std::vector<TreeEdit>& edits() { return m_edits; }
    /// In the place of all so far, each of them as if it were the only one: for a stroke that goes on. Not
    /// with add(). Errors: likewise.
    Expected<void> replace(const std::vector<TreeEdit>& edits, bool inTreeSpace = true);
    /// Returns the loss if this were the only edit. Errors: why it cannot be done.
    [[nodiscard]] Expected<HandLoss> loss(const TreeEdit& edit, bool inTreeSpace = true) const;
    /// The gesture goes on with the tree's last edit, where that is one of this kind of this limb alone: then
    /// it is in edits(), and not in the context. Before anything is added.
    bool resume(EditOperation operation, std::uint64_t address);
    /// Puts the edits into the document. Errors: those of edit::putTreeEdits.
    Expected<void> show();

    /// A cut of a growing tree becomes part of its life: later years respond to it.
    void keep();
    void cancel(); ///< everything as it was

private:
    HandEdit(Document& document, NodeId tree, const TreeResult& result, std::vector<TreeEdit> before);
    bool liveOn();

    Document& m_document;
    NodeId m_node;
    std::shared_ptr<const Skeleton> m_grown;
    std::vector<TreeEdit> m_before;
    std::uint64_t m_seed; ///< seed of the tree
    EditContext m_context;
    std::vector<TreeEdit> m_edits;
    std::vector<std::uint64_t> m_shown; ///< ids of the edits in the document
    GestureId m_gesture = 0;
};

/// So many of an edit evenly around the limb where it was hit, the first on the side that was clicked: its
/// target, place and azimuth are set here. One step of undo. Errors: why not; then nothing changes.
Expected<void> putAround(Document& document, const LimbHit& limb, TreeEdit edit, int copies);
/// Removes limbs with all that grows on them. If a limb was hit above its foot, only the part above goes.
/// Limbs that go with another one are skipped. \param whole limbs go from their feet on, wherever they were
/// hit \param fallsAfter s until the cut limb falls; unset: it vanishes. One step of undo. Errors: why not;
/// then nothing changes.
Expected<void> removeLimbs(Document& document, const std::vector<LimbHit>& limbs, bool whole,
                           std::optional<double> fallsAfter = {});
/// A step of the recipe that acts on a limb alone, on all of its axes. Returns its id. Errors: likewise.
Expected<std::vector<std::uint64_t>> putStepOn(Document& document, const LimbHit& limb, TreeEdit step);
/// All goes but this limb. Errors: likewise.
Expected<void> keepLimb(Document& document, const LimbHit& limb);
/// Removes the limbs' leaves, or restores them if those of the first limb are gone. Errors: likewise.
Expected<void> toggleLeaves(Document& document, const std::vector<LimbHit>& limbs);

} // namespace ramure
