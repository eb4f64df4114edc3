/// \file
/// Functions that the readers of scenes share. Internal to the formats.
#pragma once

#include "core/io/formats/text/animation_file.h"
#include "core/scene/scene.h"
#include <span>

namespace ramure {

/// Returns the placement nearest to a matrix. Numbers of single precision are never quite orthogonal; if the
/// matrix is close, the difference is ignored. Errors: those of decomposePlacement.
Expected<PlacementParams> placementNear(const glm::dmat4& matrix);

/// Frames that show all keys; default where nothing moves. \param saidRate frames a second; 0: the usual rate
/// that puts all keys on frames, and \p notes tells which one was taken.
TimelineSettings timelineOfKeys(std::span<const Node> nodes, double saidRate, std::vector<Note>& notes);

} // namespace ramure
