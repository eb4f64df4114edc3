/// \file
/// A baked run beside the project: all that a PhysicsCache keeps, in one binary file (little-endian,
/// versioned, with a checksum). A file is bound to the tree it was made from.
#pragma once

#include "core/physics/physics_cache.h"
#include <string>

namespace ramure {

/// Computes states 0 .. lastStep (or takes them from the cache) and writes them. Written beside and renamed:
/// the file is whole or not there. Errors: Io, Cancelled.
Expected<void> saveBake(PhysicsCache& cache, std::int64_t lastStep, const std::string& path,
                        const Progress& progress = {});
/// Replaces changes and states of \p cache by those of the file. On an error \p cache is as before.
/// Errors: Io; Syntax (no such file format, cut short, checksum differs); Version; Invalid (values that
/// cannot be, or made from another tree: says so).
Expected<void> loadBake(PhysicsCache& cache, const std::string& path, const Progress& progress = {});

} // namespace ramure
