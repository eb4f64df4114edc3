/// \file
/// A tree with its edits so far, for making the next edit. It finds limbs, says where they are, and turns
/// values that refer to the present tree into an edit that keeps its meaning when the tree changes.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/math/frame.h"
#include "core/params/tree_edit.h"
#include "core/recipe/edit_report.h"
#include "core/skeleton/axes.h"
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace ramure {

class EditTree;

/// The parts that an edit would take off a tree.
struct EditLoss
{
    /// Pieces by Skeleton::key, and what share of their length goes, from their ends.
    std::vector<std::pair<std::uint64_t, double>> pieces;
    double metres = 0.0; ///< length of the removed wood
};

class EditContext
{
public:
    /// \param grown the tree as the generator made it, or as it is frozen (TreeResult::grown); it is not kept
    /// \param axes its axes, if already known \param seed of the tree (treeSeed)
    EditContext(const Skeleton& grown, std::span<const TreeEdit> edits,
                std::shared_ptr<const TreeAxes> axes = nullptr, std::uint64_t seed = 0,
                const Progress& progress = {});
    ~EditContext();
    EditContext(const EditContext& other);
    EditContext(EditContext&&) noexcept;
    EditContext& operator=(EditContext&&) noexcept;
    /// Returns a copy continued to these edits, if its own edits are the first of them; else nothing.
    [[nodiscard]] std::optional<EditContext> upTo(std::span<const TreeEdit> edits,
                                                  const Progress& progress = {}) const;
    /// Report on the edits that it began with.
    [[nodiscard]] const EditReport& report() const { return m_report; }
    [[nodiscard]] std::size_t bytes() const;

    [[nodiscard]] bool has(std::uint64_t address) const;
    /// An axis by its address, for TreeEdit::target and other. Error: Unknown.
    [[nodiscard]] Expected<EditTarget> target(std::uint64_t address) const;
    /// m; 0 where there is no such axis.
    [[nodiscard]] double lengthOf(std::uint64_t address) const;
    /// m, tree space, and the radius there.
    [[nodiscard]] std::optional<StrokePoint> pointOn(std::uint64_t address, double share) const;
    /// Returns the frame that the axis carries at a share of its length, without twist from the root. Twigs
    /// that grow there are measured in it.
    [[nodiscard]] std::optional<Frame> frameOn(std::uint64_t address, double share) const;
    /// Returns the frame of the axis's parent at its fork; for a root, that of +Y.
    [[nodiscard]] std::optional<Frame> frameBelow(std::uint64_t address) const;

    /// Returns the edit in the form in which it is kept. \p edit names its limbs by their addresses alone.
    /// Its vectors are in tree space if \p inTreeSpace (points as places in it), else in the frames of
    /// TreeEdit. Errors: those of checkTreeEdit; Unknown (no such limb), path = the key.
    [[nodiscard]] Expected<TreeEdit> prepared(TreeEdit edit, bool inTreeSpace) const;
    /// Whether a prepared edit can act on the tree as it is now. Errors: why not.
    [[nodiscard]] Expected<void> tried(const TreeEdit& edit) const;
    /// Returns the loss that a prepared edit would cause; it is empty for an edit that removes nothing.
    /// Errors: as tried().
    [[nodiscard]] Expected<EditLoss> lossOf(const TreeEdit& edit) const;
    /// Makes it, for the edits behind it. Errors: why not, and then nothing is changed.
    Expected<void> apply(const TreeEdit& edit);

    /// A limb with all on it, for a graft onto another tree (TreeEdit::limb, and target empty). Empty: no
    /// such axis.
    [[nodiscard]] std::vector<LimbPiece> limb(std::uint64_t address) const;
    /// The tree as it is now. Untouched axes keep their addresses and keys.
    [[nodiscard]] Skeleton skeleton() const;

private:
    [[nodiscard]] Expected<EditTarget> named(std::uint64_t address, const char* key) const;

    std::shared_ptr<const TreeAxes> m_grown; ///< axes of the tree as grown
    std::vector<TreeEdit> m_edits;           ///< the edits that it began with
    EditReport m_report;
    std::uint64_t m_mark = 0;
    std::unique_ptr<EditTree> m_tree;
};

} // namespace ramure
