/// \file
/// What the first animation of a GLB moves, as tracks of nodes. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_nodes.h"
#include "core/io/formats/text/animation_file.h"

namespace ramure::glb {

struct Clip
{
    std::map<Index, NodeAnimation> moves; ///< by the nodes of the file: global tracks of all that places them
    std::vector<Note> notes;              ///< what was left out
};

/// Straight and stepped keys stay what they are; splines keep the slope at their keys, turns by splines are
/// told by their keys alone. Errors: those of File; Invalid (fewer values than keys, a time before 0).
Expected<Clip> readClip(File& file, const FileNodes& nodes);

} // namespace ramure::glb
