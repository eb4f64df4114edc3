/// \file
/// What each operation does to a tree. For this folder; everybody else uses edit_context.h.
#pragma once

#include "core/base/error.h"
#include "core/math/random.h"
#include "core/params/tree_edit.h"
#include "core/recipe/edit_tree.h"

namespace ramure::edits {

/// \param target,other axes of the tree that are there; noIndex: the edit has none. Errors: why it cannot be
/// done (Invalid), and then the tree is as it was.
using Act = Expected<void>(EditTree& tree, const TreeEdit& edit, Index target, Index other);

Act cut, remove, keep, prune, leaves;                     // edit_cuts.cpp
Act bend, curl, twist, roll, length, attract, comb, root; // edit_bends.cpp
Act thickness, taper, redraw;                             // edit_shapes.cpp
Act draw, extend, graft, move;                            // edit_growth.cpp
Act place;                                                // edit_organs.cpp
Act sag, gnarl;                                           // wandering.cpp
Act deadWood;                                             // dead_wood.cpp
Act pipe, flare;                                          // radii.cpp
Act growOn;                                               // grow_on.cpp
Act source;                                               // step_source.cpp
Act frozen;  ///< does nothing: Applier takes the tree that the step holds
Act unknown; ///< an error

struct OperationAct
{
    EditOperation operation;
    Act* act;
};
/// What is not here is a source.
inline constexpr OperationAct acts[] = {
    {EditOperation::Cut, cut},       {EditOperation::Remove, remove},   {EditOperation::Keep, keep},
    {EditOperation::Bend, bend},     {EditOperation::Curl, curl},       {EditOperation::Twist, twist},
    {EditOperation::Roll, roll},     {EditOperation::Length, length},   {EditOperation::Thickness, thickness},
    {EditOperation::Taper, taper},   {EditOperation::Draw, draw},       {EditOperation::Extend, extend},
    {EditOperation::Redraw, redraw}, {EditOperation::Graft, graft},     {EditOperation::Move, move},
    {EditOperation::Prune, prune},   {EditOperation::Attract, attract}, {EditOperation::Comb, comb},
    {EditOperation::Leaves, leaves}, {EditOperation::Root, root},       {EditOperation::Place, place},
    {EditOperation::Sag, sag},       {EditOperation::Gnarl, gnarl},     {EditOperation::DeadWood, deadWood},
    {EditOperation::Pipe, pipe},     {EditOperation::Flare, flare},     {EditOperation::GrowOn, growOn},
    {EditOperation::Frozen, frozen}, {EditOperation::Unknown, unknown},
};

Expected<void> act(EditTree& tree, const TreeEdit& edit, Index target, Index other);

/// The axes that a modifier or a source acts on: those for which its condition holds, on a limb or anywhere.
/// EditTree::meant() has them then, unless it is the whole tree.
/// \param target of the limb; noIndex: the whole tree. Errors: those of AxisFilter::parse; Invalid where the
/// condition names none.
Expected<std::vector<bool>> axesMeant(EditTree& tree, const TreeEdit& edit, Index target);
/// What a step draws by chance on one axis.
Random chanceOf(const EditTree& tree, const TreeEdit& edit, Index axis);

/// Where something grows on an axis: never at its very foot, which is its parent's.
AxisSpot forkSpot(const EditTree& tree, Index axis, double share);
/// A limb with all on it, in the frame below it, from its foot.
std::vector<LimbPiece> limbOf(const EditTree& tree, Index axis);
/// The address of the copy of an axis that a graft makes.
std::uint64_t graftedAddress(std::uint64_t graft, std::uint64_t original);

} // namespace ramure::edits
