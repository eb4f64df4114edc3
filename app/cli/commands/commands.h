/// \file
/// The commands of ramure-cli.
#pragma once

#include "app/cli/command_line.h"
#include <array>

namespace ramure::cli {

struct Command
{
    CommandText text;
    void (*addOptions)(CommandLine& line);
    /// \param line parsed. Returns an exit code; an error is one line on the standard error and exit code 2.
    Expected<int> (*run)(const CommandLine& line);
    bool startsApplication = false; ///< run() starts the application that it needs: none may exist
};

extern const Command listCommand;
extern const Command infoCommand;
extern const Command importCommand;
extern const Command editCommand;
extern const Command recipeCommand;
extern const Command scatterCommand;
extern const Command exportCommand;
extern const Command ageCommand;
extern const Command levelsCommand;
extern const Command validateCommand;
extern const Command simulateCommand;
extern const Command ikCommand;
extern const Command renderCommand;
extern const Command billboardCommand;
extern const Command texturesCommand;
extern const Command batchCommand;
extern const Command jobCommand;
extern const Command sheetCommand;
extern const Command signsCommand;

/// In the order of the help.
inline constexpr std::array allCommands = {
    &listCommand,     &infoCommand,     &importCommand, &recipeCommand, &scatterCommand,
    &editCommand,     &exportCommand,   &levelsCommand, &ageCommand,    &validateCommand,
    &signsCommand,    &simulateCommand, &ikCommand,     &renderCommand, &billboardCommand,
    &texturesCommand, &batchCommand,    &jobCommand,    &sheetCommand};

/// An option that stands in a command's place.
struct ProgramOption
{
    const char* name; ///< "--help"
    const char* description;
};
inline constexpr ProgramOption programOptions[] = {
    {"--help", "Shows this text; behind a command, that command's."},
    {"--version", "Shows the version of the program."},
    {"--manual", "Shows the manual page of ramure-cli, for man(1)."},
    {"--manual-editor", "Shows the manual page of the editor, ramure."},
    {"--completion", "Shows what bash needs to complete the words behind ramure-cli and ramure."},
};

} // namespace ramure::cli
