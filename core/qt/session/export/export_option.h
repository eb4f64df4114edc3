/// \file
/// The options of an export, a row each. The command line with its help, manual page and completion, batches
/// with their jobs and the hash of a row's inputs, the fields of the export dialog and the settings that it
/// keeps are made from these rows.
#pragma once

#include "core/io/formats/file_format.h"
#include "core/qt/session/export/export_options.h"
#include <span>
#include <string>

namespace ramure {

/// The flags of an option name its commands and the conditions under which it applies.
using OptionFlag = std::uint16_t;
inline constexpr OptionFlag ofExport = 1;    ///< `ramure-cli export`
inline constexpr OptionFlag ofBatch = 2;     ///< `batch` and `job`
inline constexpr OptionFlag ofImport = 4;    ///< `import`
inline constexpr OptionFlag ofPrint = 8;     ///< says how a print is made
inline constexpr OptionFlag notOfPrint = 16; ///< has no say in a print
inline constexpr OptionFlag ofTrees = 32;    ///< needs a tree
inline constexpr OptionFlag ofClips = 64;    ///< says something about files that move
/// The command line refuses the option for formats that do not hold it.
inline constexpr OptionFlag ofFormats = 128;
inline constexpr OptionFlag ofLevels = 256; ///< `levels`

/// The purpose of an export. Each has a page of the export dialog.
enum class ExportUse : std::uint8_t { Blender, Game, Print, Web, Pictures };
/// Bits 1 << ExportUse.
inline constexpr std::uint8_t forBlender = 1, forGame = 2, forPrint = 4, forWeb = 8, forEveryUse = 31;

/// A value that can be chosen.
struct OptionItem
{
    const char* name; ///< on the command line
    std::int64_t value;
    /// In the dialog, English, context "core", with the value for %1. Empty: the field is a box to tick.
    const char* label = "";
};

/// Reads and sets the member of ExportOptions that an option stands for: a choice, a switch, a number.
struct OptionPlace
{
    double (*get)(const ExportOptions&) = nullptr;
    void (*set)(ExportOptions&, double) = nullptr;
};

struct ExportOption
{
    const char* name = ""; ///< "map-size": --map-size
    /// Its value on the command line: "PIXELS", or words to choose from; empty: it takes none.
    const char* values = "";
    const char* help = "";                    ///< %1 is what follows
    const char *inExport = "", *inBatch = ""; ///< in the place of %1
    std::uint16_t flags = 0;                  ///< bits of OptionFlag
    OptionPlace place{};
    std::span<const OptionItem> items{}; ///< by name, or else
    double least = 0.0, most = 0.0;      ///< a number; none where least is most
    const char* expected = "";           ///< in an error; empty: the names of the items
    /// Reads and writes the option where place, items and range do not suffice; null: they do.
    Expected<void> (*read)(ExportOptions& options, const std::string& text) = nullptr;
    std::string (*text)(const ExportOptions& options) = nullptr;
    /// Text that goes into the hash of a row's inputs if the option is not at its default; %1 is its value.
    /// Null: nothing goes in.
    const char* hashed = nullptr;
    std::uint16_t holds = 0; ///< bits of FormatHolds: other formats cannot have it

    const char* key = ""; ///< "maps": in the settings that the dialog keeps; empty: the dialog has no field
    const char *label = "", *tip = ""; ///< texts of the dialog's field, English, context "core"
    std::uint8_t uses = 0;             ///< bits of the pages that have the field
    double factor = 1.0;               ///< the field shows the value times this

    [[nodiscard]] bool is(int flag) const { return (flags & flag) != 0; }
};

/// Returns the table, in the order of the help.
std::span<const ExportOption> exportOptions();
/// \param text empty for an option that takes nothing. Errors, with the name of the option: Unknown, Invalid,
/// Syntax.
Expected<void> readOption(const ExportOption& option, ExportOptions& options, const std::string& text);
/// Returns the value as the command line writes it.
std::string optionText(const ExportOption& option, const ExportOptions& options);
bool isUsual(const ExportOption& option, const ExportOptions& options);

/// The choices that decide which options are offered.
struct ExportPage
{
    ExportUse use = ExportUse::Blender;
    const FileFormat* format = nullptr; ///< null: pictures
    bool isPrint = false;
    bool isClip = false; ///< one file that moves
};
bool isOffered(const ExportOption& option, const ExportPage& page);

} // namespace ramure
