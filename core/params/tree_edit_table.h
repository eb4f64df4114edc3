/// \file
/// The operations of tree_edit.h: their names, the values that each has and what these may be. Made from it:
/// the check, the project file, scripts and the lists of the interface.
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include "core/params/tree_edit.h"
#include <span>
#include <string_view>

namespace ramure {

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
};
/// One per operation, in their order.
std::span<const EditOperationInfo> editOperations();
const EditOperationInfo& infoOf(EditOperation operation);
/// Null: there is none of that key.
const EditOperationInfo* editOperationOf(std::string_view key);
/// The rows of paramTable(), followed by those that only steps have. findParam() knows all of them.
std::span<const ParamDef> allParams();
/// The parameters of a step, whose values are in TreeEdit::values; none of a hand edit.
std::span<const ParamDef* const> stepParams(EditOperation operation);
/// A step as a new one begins, without an id.
TreeEdit newStep(EditOperation operation);
/// Makes a step with the values that \p like has for its kind, for example those of a preset.
TreeEdit newStep(EditOperation operation, const NodeParams& like);

/// Returns the number of steps that do not run because a frozen step holds their result; 0: none is frozen.
std::size_t stepsFrozen(std::span<const TreeEdit> steps);

struct EditNumber
{
    const char* key;
    double TreeEdit::*member;
    std::uint32_t field;
    double least, most;
    bool isAngle; ///< rad; degrees in scripts
};
std::span<const EditNumber> editNumbers();

struct EditVector
{
    const char* key;
    glm::dvec3 TreeEdit::*member;
    std::uint32_t field;
};
std::span<const EditVector> editVectors();

struct EditFlag
{
    const char* key;
    bool TreeEdit::*member;
    std::uint32_t field;
};
std::span<const EditFlag> editFlags();

struct EditShapeInfo
{
    EditShapeKind kind;
    const char* key;     ///< "sphere"
    std::size_t numbers; ///< numbers of EditShape
};
std::span<const EditShapeInfo> editShapes();

struct EditOrganInfo
{
    EditOrgan organ;
    const char* key;   ///< "leaf"
    const char* label; ///< RAMURE_NOOP
};
/// In the order of EditOrgan.
std::span<const EditOrganInfo> editOrgans();

/// Most points of a stroke or a limb.
inline constexpr std::size_t mostEditPoints = 100'000;
inline constexpr std::size_t mostShapeTriangles = 1'000'000;

/// Errors: Invalid, path = the key of the value: no target where one is needed, a number that is not finite
/// or out of range, too few points or too many, a shape without extent, a limb whose pieces do not follow
/// each other.
Expected<void> checkTreeEdit(const TreeEdit& edit);
/// Checks a list. Errors: those of checkTreeEdit, Invalid (id 0, or twice); path = "edits[3].at".
Expected<void> checkTreeEdits(std::span<const TreeEdit> edits);

/// A name for a new edit that is unlike all of the list's: the same list and edit give the same one.
std::uint64_t newEditId(std::span<const TreeEdit> edits, const TreeEdit& edit);

} // namespace ramure
