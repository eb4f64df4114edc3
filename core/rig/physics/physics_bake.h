/// \file
/// A baked run beside the project: what a PhysicsCache keeps, in one binary file. A file is bound to the tree
/// that it was made from.
///
/// Little-endian 64-bit words: the text "RAMRPHYS", version, number of words that follow before the last,
/// those words (body key, counts, script, states), and a checksum over them.
#pragma once

#include "core/rig/physics/physics_cache.h"
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
/// The same, but only of a run that had \p params from its beginning to its end and no hand on it. Error
/// besides: Invalid (baked with other parameters).
Expected<void> loadBake(PhysicsCache& cache, const PhysicsParams& params, const std::string& path,
                        const Progress& progress = {});

/// Which run a file says it holds.
struct BakeLabel
{
    std::uint64_t bodyKey = 0;
    PhysicsParams params; ///< at the beginning of the run
};
/// From the first words of the file alone, at once: whether loading is worth a try. Only loadBake looks
/// whether the file is sound. Errors: those of loadBake.
Expected<BakeLabel> readBakeLabel(const std::string& path);
/// Does the file begin as one of saveBake does? False also where there is none.
[[nodiscard]] bool isBakeFile(const std::string& path);

} // namespace ramure
