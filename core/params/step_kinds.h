/// \file
/// The kinds of steps of a recipe: hand edits, modifiers and sources, each with the values that it has. A new
/// kind has its enumerator and its row here; what it does stands in core/recipe/edit_operations.h, or of a
/// source in core/generators/sources.cpp.
#pragma once

#include "core/base/error.h"
#include "core/params/enum_item.h"
#include <cstdint>
#include <iterator>

namespace ramure {

enum class EditOperation : std::uint8_t {
    Cut,       ///< removes the wood above `at`, or lets it fall; a closed end stays
    Remove,    ///< the limb goes, with all on it
    Keep,      ///< keeps a limb with its twigs and the wood down to the ground, and removes the rest
    Bend,      ///< turns the wood above `from`, gradually up to `to` if that is above
    Curl,      ///< turned bit by bit between `from` and `to`
    Twist,     ///< turns the limbs of an axis about it, by `angleRad` at the tip
    Roll,      ///< turns the bark of an axis above `from` and of its limbs about their curves, no wood moves
    Length,    ///< times `factor`
    Thickness, ///< radii times `factor`
    Taper,     ///< radii times `factor` at the tip, unchanged at the foot
    Draw,      ///< a new axis along `points`, at `at` of the target
    Extend,    ///< the tip goes on along `points`
    Redraw,    ///< gives the axis another course; its limbs follow
    Graft,     ///< a copy of a limb, at `at` of the target
    Move,      ///< the limb is put at `at` of its parent, or of another axis
    Prune,     ///< cuts the wood outside a shape
    Attract,   ///< branches within a sphere turn towards its centre, or away from it
    Comb,      ///< branches within a sphere turn into a direction
    Leaves,    ///< shows or hides the leaves of a limb, or without a target those within a sphere
    Root,      ///< the foot stands elsewhere, and flares
    Place,     ///< one leaf, fruit or flower, at `at` of the target, on the side of `azimuth`
    // Modifiers and sources: no hand made them, and their values are rows of the parameter table.
    Sag,
    Gnarl,
    DeadWood,
    Pipe, ///< radii by the pipe rule
    Flare,
    GrowOn, ///< the tree lives some years longer, whatever made it
    Grammar,
    WeberPenn,
    Colonisation,
    Growth,
    Frozen,  ///< the tree as it was behind the steps before, which do not run
    Unknown, ///< from the file of a newer version: kept without effect
};
inline constexpr std::size_t editOperationCount = static_cast<std::size_t>(EditOperation::Unknown) + 1;

/// Bits: which values an operation has.
enum EditField : std::uint32_t {
    editAt = 1,
    editFrom = 2,
    editTo = 4,
    editFactor = 8,
    editAngle = 16,
    editAzimuth = 32,
    editRadius = 64,
    editStrength = 128,
    editRotation = 256,
    editDirection = 512,
    editCentre = 1024,
    editOffset = 2048,
    editBelow = 4096,
    editShown = 8192,
    editShape = 16384,
    editPoints = 32768,
    editLimb = 65536,
    editOther = 131072,       ///< TreeEdit::other
    editNeedsTarget = 262144, ///< else the target may be left out
    editTreeSpace = 524288,   ///< vectors are in tree space
    editMakesAxes = 1048576,  ///< names of axes come from TreeEdit::id
    editOrgan = 2097152,
    editFalls = 4194304,   ///< TreeEdit::falls and seconds
    editPath = 8388608,    ///< points, or none
    editFrozen = 16777216, ///< TreeEdit::frozen
    editYear = 33554432,   ///< TreeEdit::year
};

/// The origin of a step, for grouping.
enum class StepGroup : std::uint8_t { Hand, Modifier, Source, Unknown };

struct EditOperationInfo
{
    EditOperation operation;
    const char* key;       ///< "cut", in files and scripts
    const char* label;     ///< RAMURE_NOOP
    const char* targetKey; ///< "target" or "parent"
    const char* otherKey;  ///< "source", "parent" or ""
    std::uint32_t fields;  ///< EditField
    StepGroup group = StepGroup::Hand;
    const char* tip = "";   ///< one line for a menu, RAMURE_NOOP; modifiers and sources have one
    const char* rows = "";  ///< prefixes of the parameters that it has, with a blank between
    const char* where = ""; ///< default condition of a new step
    std::int64_t version = 1;
    /// Name and label of a source that a tree can begin with, as `generator.kind` has them; empty: it cannot.
    EnumItem first{"", ""};
};
/// One row per operation, in their order.
inline constexpr EditOperationInfo stepKinds[] = {
    {EditOperation::Cut, "cut", RAMURE_NOOP("Cut"), "target", "",
     editAt | editFalls | editYear | editNeedsTarget},
    {EditOperation::Remove, "remove", RAMURE_NOOP("Remove"), "target", "", editYear | editNeedsTarget},
    {EditOperation::Keep, "keep", RAMURE_NOOP("Keep only this"), "target", "", editNeedsTarget},
    {EditOperation::Bend, "bend", RAMURE_NOOP("Bend"), "target", "",
     editFrom | editTo | editRotation | editNeedsTarget},
    {EditOperation::Curl, "curl", RAMURE_NOOP("Curl"), "target", "",
     editFrom | editTo | editRotation | editNeedsTarget},
    {EditOperation::Twist, "twist", RAMURE_NOOP("Twist"), "target", "", editAngle | editNeedsTarget},
    {EditOperation::Roll, "roll", RAMURE_NOOP("Roll"), "target", "", editFrom | editAngle | editNeedsTarget},
    {EditOperation::Length, "length", RAMURE_NOOP("Length"), "target", "",
     editFactor | editBelow | editNeedsTarget},
    {EditOperation::Thickness, "thickness", RAMURE_NOOP("Thickness"), "target", "",
     editFactor | editBelow | editNeedsTarget},
    {EditOperation::Taper, "taper", RAMURE_NOOP("Taper"), "target", "", editFactor | editNeedsTarget},
    {EditOperation::Draw,
     "draw",
     RAMURE_NOOP("Draw"),
     "parent",
     "",
     editAt | editPoints | editBelow | editMakesAxes,
     StepGroup::Hand,
     "",
     "",
     "",
     1,
     {"drawn", RAMURE_NOOP("Drawn by hand")}},
    {EditOperation::Extend, "extend", RAMURE_NOOP("Extend"), "target", "", editPoints | editNeedsTarget},
    {EditOperation::Redraw, "redraw", RAMURE_NOOP("Redraw"), "target", "", editPoints | editNeedsTarget},
    {EditOperation::Graft, "graft", RAMURE_NOOP("Graft"), "parent", "source",
     editAt | editAzimuth | editFactor | editLimb | editOther | editNeedsTarget | editMakesAxes},
    {EditOperation::Move, "move", RAMURE_NOOP("Move"), "target", "parent",
     editAt | editAzimuth | editOther | editNeedsTarget},
    {EditOperation::Prune, "prune", RAMURE_NOOP("Prune to a shape"), "target", "",
     editShape | editYear | editTreeSpace},
    {EditOperation::Attract, "attract", RAMURE_NOOP("Attract"), "target", "",
     editCentre | editRadius | editStrength | editTreeSpace},
    {EditOperation::Comb, "comb", RAMURE_NOOP("Comb"), "target", "",
     editCentre | editRadius | editStrength | editDirection | editPath | editTreeSpace},
    {EditOperation::Leaves, "leaves", RAMURE_NOOP("Leaves"), "target", "",
     editShown | editCentre | editRadius | editPath | editTreeSpace},
    {EditOperation::Root, "root", RAMURE_NOOP("Root"), "target", "",
     editOffset | editFactor | editNeedsTarget | editTreeSpace},
    {EditOperation::Place, "place", RAMURE_NOOP("Place a leaf or fruit"), "target", "",
     editAt | editAzimuth | editFactor | editOrgan | editNeedsTarget},
    {EditOperation::Sag, "sag", RAMURE_NOOP("Sag"), "target", "", 0, StepGroup::Modifier,
     RAMURE_NOOP("Limbs bend by their own weight"), "step.where sag.", "order > 0"},
    {EditOperation::Gnarl, "gnarl", RAMURE_NOOP("Gnarl"), "target", "", 0, StepGroup::Modifier,
     RAMURE_NOOP("Axes wander from side to side"), "step. gnarl."},
    {EditOperation::DeadWood, "deadWood", RAMURE_NOOP("Dead wood"), "target", "", 0, StepGroup::Modifier,
     RAMURE_NOOP("Some limbs have died and lost their twigs"), "step. deadWood.", "order = 1"},
    {EditOperation::Pipe, "pipe", RAMURE_NOOP("Thickness by the pipe rule"), "target", "", 0,
     StepGroup::Modifier, RAMURE_NOOP("Makes wood as thick as its load requires"), "step.where pipe."},
    {EditOperation::Flare, "flare", RAMURE_NOOP("Flare"), "target", "", 0, StepGroup::Modifier,
     RAMURE_NOOP("The foot of the trunk swells"), "step.where flare.", "order = 0"},
    {EditOperation::GrowOn, "growOn", RAMURE_NOOP("Grow on"), "target", "", 0, StepGroup::Modifier,
     RAMURE_NOOP("The tree lives some years longer: shoots look for light, shaded limbs fall"),
     "step.seed growOn. growth.height growth.maturity growth.leaderUntil growth.crownBase growth.density "
     "growth.internode growth.phyllotaxis growth.divergence growth.axil growth.whorl growth.endBuds "
     "growth.acrotony growth.branching growth.shortShoots growth.orders growth.shadeTolerance "
     "growth.shedding growth.light growth.apicalControl growth.sideLength growth.upright growth.weeping "
     "growth.plagiotropy growth.wander growth.pipeExponent growth.tipRadius growth.droop growth.reaction "
     "growth.wind growth.windDirection growth.sideLight growth.lightDirection growth.slope "
     "growth.slopeDirection"},
    {EditOperation::Grammar,
     "grammar",
     RAMURE_NOOP("Grammar"),
     "target",
     "",
     0,
     StepGroup::Source,
     RAMURE_NOOP("Twigs or trees that rules draw"),
     "step. stand. grammar. turtle. variation.",
     "order = 1",
     1,
     {"grammar", RAMURE_NOOP("Grammar")}},
    {EditOperation::WeberPenn,
     "weberPenn",
     RAMURE_NOOP("Weber and Penn"),
     "target",
     "",
     0,
     StepGroup::Source,
     RAMURE_NOOP("Limbs, branches and twigs, each level by its own numbers"),
     "step. stand. weberPenn.",
     "order = 0",
     1,
     {"weber_penn", RAMURE_NOOP("Weber and Penn")}},
    {EditOperation::Colonisation,
     "colonisation",
     RAMURE_NOOP("Space colonisation"),
     "target",
     "",
     0,
     StepGroup::Source,
     RAMURE_NOOP("Branches that fill a crown of your shape"),
     "step. stand. colonisation.",
     "order = 0",
     1,
     {"colonisation", RAMURE_NOOP("Space colonisation")}},
    {EditOperation::Growth,
     "growth",
     RAMURE_NOOP("Growth"),
     "target",
     "",
     0,
     StepGroup::Source,
     RAMURE_NOOP("Shoots that compete for light, year by year"),
     "step. stand. growth.",
     "order = 1",
     1,
     {"growth", RAMURE_NOOP("Growth")}},
    {EditOperation::Frozen, "frozen", RAMURE_NOOP("Frozen tree"), "target", "", editFrozen, StepGroup::Hand,
     RAMURE_NOOP(
         "Holds the result of the steps above: they do not run until this step is switched off or deleted")},
    {EditOperation::Unknown, "", RAMURE_NOOP("Unknown step"), "target", "", 0, StepGroup::Unknown},
};
static_assert(std::size(stepKinds) == editOperationCount);

} // namespace ramure
