/// \file
/// One row of the parameter table: all that the program knows about one parameter. Property editors, undo,
/// project file, command line and handbook are made from these rows.
#pragma once

#include "core/base/error.h"
#include "core/params/enum_item.h"
#include "core/params/node_kind.h"
#include "core/params/node_params.h"
#include "core/params/stage.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace ramure {

/// One of the items of a choice, by its name in files and on the command line.
struct EnumValue
{
    std::string name;
    bool operator==(const EnumValue&) const = default;
};

/// Alternatives stand in the order of ParamType.
using ParamValue = std::variant<bool, std::int64_t, double, std::string, glm::dvec3, EnumValue>;

enum class ParamType : std::uint8_t { Bool, Int, Real, Text, Vec3, Enum };

/// Inside the program angles are radians and lengths metres; the interface may show degrees.
/// A share is a ratio that the interface shows in per cent.
enum class ParamUnit : std::uint8_t {
    None,
    Metre,
    Radian,
    Ratio,
    Count,
    Degree,
    Second,
    Share,
    Kilogram,
    Factor,
    Year,
    Day ///< of the year, 1..365; 0: none
};

enum ParamFlag : std::uint16_t {
    paramNone = 0,
    paramAnimatable = 1, ///< may have a track on the timeline
    paramAdvanced = 2,   ///< folded away at first
    paramMultiline = 4,  ///< a text of several lines
    paramSeed = 8,       ///< a random seed: the editor offers a dice
    paramGrammar = 16,   ///< text in the grammar's language
    paramColor = 32,     ///< three numbers that are red, green and blue, 0..1
    paramPicture = 64,   ///< a text that is the path of an image file
    paramNumbered = 128, ///< a choice whose items texts may also name by their number, from 0
    paramProfile = 256,  ///< a text that is the outline of a crown
};

/// Index of a row in paramTable(); stable within one run of the program only (files use keys).
using ParamId = std::uint16_t;

struct ParamDef
{
    const char* key;   ///< "sections.radialDivisions": project file and command line
    const char* group; ///< label of its group, English, context "core"
    const char* label; ///< English, context "core"
    const char*
        tooltip; ///< one or two sentences, English, context "core"; unit and range are added by the view
    ParamType type;
    ParamUnit unit;
    double hardMin, hardMax; ///< numbers outside are refused (vectors: per component)
    double softMin, softMax; ///< the slider's range
    double step;
    int decimals;
    Stage stage;
    std::uint16_t flags;
    KindBits kinds; ///< bit 1 << NodeKind: the kinds of node that have it
    ParamValue (*get)(const NodeParams&);
    void (*assign)(NodeParams&, const ParamValue&); ///< no check; the alternative must be the row's type
    std::span<const EnumItem> items{}; ///< values of a choice, at least two; empty for other types
    /// False: beside the other values no stage looks at this one, and results stay as they are. Null: always.
    bool (*matters)(const NodeParams&) = nullptr;
};

/// All rows, in the order in which the interface shows them.
std::span<const ParamDef> paramTable();
/// The row with this key, or null.
const ParamDef* findParam(std::string_view key);
ParamId paramId(const ParamDef& def);
bool hasParam(NodeKind kind, const ParamDef& def);

/// The default, taken from the struct's member initialisers.
ParamValue defaultValue(const ParamDef& def);
/// Refuses another type, non-finite numbers and numbers outside the hard range, texts with a zero byte or
/// over 1 MiB, names that are no item. Error: code Invalid, path = key.
Expected<void> checkValue(const ParamDef& def, const ParamValue& value);
/// checkValue, then assign. On an error \p params is unchanged.
Expected<void> setParam(NodeParams& params, const ParamDef& def, const ParamValue& value);
/// The nearest value inside the hard range; non-finite numbers become the default. For sliders, never for
/// files.
ParamValue clampValue(const ParamDef& def, const ParamValue& value);

/// Text as the command line writes it: numbers in the C locale (shortest round trip), bool "true"/"false",
/// vectors "x,y,z", choices their name. parseValue also reads 0, 1, yes, no, on, off as bools and, in texts,
/// \n as a new line and
/// \\ as one backslash where \p unescape is set. It does not check the range: setParam does. Error: path =
/// key, code Syntax, or Invalid for a number that its type cannot hold.
std::string formatValue(const ParamValue& value);
Expected<ParamValue> parseValue(const ParamDef& def, std::string_view text, bool unescape = false);

/// Checks every value of \p params against the table; the first error.
Expected<void> checkParams(const NodeParams& params);
/// The same for what takes one part alone: checkPart(&NodeParams::terrain, terrain).
template <class Part> Expected<void> checkPart(Part NodeParams::*part, const Part& value)
{
    NodeParams params;
    params.*part = value;
    return checkParams(params);
}

} // namespace ramure
