/// \file
/// --levels, --budget, --switch, --map-size, --compress and --wind, of `export` and of what starts it for
/// many trees.
#pragma once

#include "app/cli/command_line.h"
#include "core/game_wind/wind_profile.h"
#include "core/lod/level_options.h"

namespace ramure::cli {

/// \param others what becomes of other formats than GLB
void addLevelOptions(CommandLine& line, const QString& others);
/// None where neither --levels nor --budget is given. Errors: Invalid.
Expected<LevelOptions> levelsFrom(const CommandLine& line);

/// --map-size. Error: Invalid.
Expected<int> mapSizeFrom(const CommandLine& line);

void addCompression(CommandLine& line);
/// WriteOptions::compressed. Error: Invalid.
Expected<bool> compressionFrom(const CommandLine& line);

void addWindOption(CommandLine& line);
/// Error: Unknown.
Expected<WindProfile> windFrom(const CommandLine& line);

} // namespace ramure::cli
