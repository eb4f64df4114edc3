/// \file
/// The check of everything that is no tree: arms, terrains, primitives and imported meshes. One for the
/// command line and for the editor.
#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/proof/validate.h"
#include <memory>

namespace ramure {

struct ShapeCheck
{
    std::shared_ptr<const TriangleMesh> mesh; ///< the node's own space; never null, may be empty
    MeshReport report;     ///< valid: as a closed solid, or as an open surface where it is one
    MeshAnalysis analysis; ///< without crossings unless they were asked for
    bool isOpen = false;   ///< a terrain or a plane: valid with a boundary
};

/// Closed, manifold and oriented, does OpenMesh agree; quality and hash; with \p crossings also which
/// triangles run through each other. \param mesh not null. Errors: those of validateMesh and analyseMesh.
Expected<ShapeCheck> checkMesh(std::shared_ptr<const TriangleMesh> mesh, bool crossings,
                               const Progress& progress = {});
/// The same of what objectSolid gives, before its placement; open surfaces (isOpenSurface) may have a
/// boundary. \param params those of the time, joints included. Errors: those of objectSolid too.
Expected<ShapeCheck> checkShape(const Node& node, const NodeParams& params, bool crossings,
                                const Progress& progress = {});

/// Checks the shape as it is at 0 s, an arm before it turns.
Expected<ShapeCheck> checkShapeAtRest(const Node& node, bool crossings, const Progress& progress = {});

/// Nothing but a boundary keeps it from being valid: what an open surface has to be.
bool isGoodSurface(const MeshReport& report);

} // namespace ramure
