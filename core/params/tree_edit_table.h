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
