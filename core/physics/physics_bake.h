/// \file
/// A baked run beside the project: what a PhysicsCache keeps, in one binary file. A file is bound to the tree
/// that it was made from.
///
/// Little-endian 64-bit words: the text "RAMRPHYS", version, number of words that follow before the last,
/// those words (body key, counts, script, states), and a checksum over them.
#pragma once

#include "core/physics/physics_cache.h"
#include <string>

namespace ramure {

/// Computes the states up to \p lastStep, or takes them from the cache, and writes the checkpoints and the
/// last. The file is whole or as it was before. Errors: those of seek, Io.
Expected<void> saveBake(PhysicsCache& cache, std::int64_t lastStep, const std::string& path,
                        const Progress& progress = {});
/// Replaces script and states of \p cache by those of the file. On an error \p cache is as before.
/// Errors: Io; Syntax (not such a file, cut short, damaged); Version; Invalid (values that cannot be; made
/// from another tree); Cancelled.
Expected<void> loadBake(PhysicsCache& cache, const std::string& path, const Progress& progress = {});

} // namespace ramure
