/// \file
/// Judges a mesh in one word: the same in the status bar, the panel of checks, the export dialog, on the
/// command line and in its JSON.
#pragma once

#include "core/surface/check/self_intersections.h"
#include "core/surface/proof/validate.h"

namespace ramure {

/// From the best to the worst: of several meshes the largest counts.
enum class MeshVerdict : std::uint8_t {
    Clean,    ///< closed, and no triangle runs through another
    Closed,   ///< closed; whether triangles run through each other has not been looked for
    Crossing, ///< closed, but triangles run through each other
    Broken,   ///< not what it has to be: one closed, oriented, outward surface per piece
};

/// Returns the verdict. For a terrain or a plane "closed" means free of faults except for the boundary
/// (isGoodSurface), as the report says. \param crossings null if nobody looked for them \param pieces the
/// expected number of closed pieces, one per root of a tree; 0: any number
MeshVerdict verdictOn(const MeshReport& report, const SelfIntersections* crossings, Index pieces = 0);

/// "clean", "closed", "crossing" or "broken": as the command line and JSON have it.
const char* verdictName(MeshVerdict verdict);

} // namespace ramure
