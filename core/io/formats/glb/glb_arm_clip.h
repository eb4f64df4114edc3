/// \file
/// How the joints of a chain move, as tracks of an arm's joints. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_arm.h"
#include "core/io/formats/glb/glb_clip_reader.h"

namespace ramure::glb {

/// Straight keys of phi and theta of every joint at the times of the chain's own keys, up to 100,000 of them.
/// Empty where nothing moves. \param joints the nodes that are the chain's joints, from the foot on
NodeAnimation armTracks(const ChainArm& arm, const Chain& chain, const FileNodes& nodes, const Clip& clip,
                        std::span<const Index> joints);

} // namespace ramure::glb
