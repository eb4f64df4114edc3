/// \file
/// Limbs that are put on a tree. For this folder.
#pragma once

#include "core/params/tree_edit.h"
#include "core/recipe/edit_tree.h"

namespace ramure::edits {

/// A limb, and how its axes are called where they grow. Axes are counted as LimbPiece::axis counts them.
struct Scion
{
    std::vector<LimbPiece> limb;
    std::vector<std::uint64_t> addresses;
    std::vector<Index> originals; ///< axes of this tree that they are copies of; noIndex: of none
    std::vector<Index> pieces{};  ///< of this tree, one for each of the limb; or empty
};

/// The coordinates of a limb at a fork, turned about the parent's axis.
struct Seat
{
    glm::dvec3 foot;
    Frame frame;
};
Seat turnedSeat(const EditTree& tree, Index below, double byRad);

struct ScionSize
{
    double length = 1.0, thickness = 1.0; ///< times
};
/// Grows a limb in a seat's frame. \param maker TreeEdit::id of whose doing it is \param below the piece at
/// whose end it grows; noIndex: on the ground
void growLimb(EditTree& tree, const Scion& scion, std::uint64_t maker, const ScionSize& size, Index below,
              const Seat& seat);

} // namespace ramure::edits
