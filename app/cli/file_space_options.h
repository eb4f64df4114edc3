/// \file
/// --up, --unit and --scale: the axes and the unit of mesh files.
#pragma once

#include "app/cli/command_line.h"
#include "core/io/file_space.h"

namespace ramure::cli {

void addSpaceOptions(CommandLine& line);
/// Nothing where none of them was given. Errors: Unknown (axis, unit), Syntax, Invalid (scale).
Expected<std::optional<FileSpace>> fileSpaceFrom(const CommandLine& line);

} // namespace ramure::cli
