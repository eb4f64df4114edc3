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
    MeshReport report;                        ///< valid as a closed solid, or as an open surface if it is one
    MeshAnalysis analysis;                    ///< without crossings unless they were asked for
    bool isOpen = false;                      ///< a terrain or a plane: valid with a boundary
};

/// Checks whether a mesh is closed, manifold and oriented and whether OpenMesh agrees. Adds quality and hash,
/// and with \p crossings the triangles that run through each other. \param mesh not null. Errors: those of
/// validateMesh and analyseMesh.
Expected<ShapeCheck> checkMesh(std::shared_ptr<const TriangleMesh> mesh, bool crossings,
                               const Progress& progress = {});
/// Checks the result of objectSolid, before its placement; open surfaces (isOpenSurface) may have a boundary.
/// \param params at the time, joints included. Errors: those of objectSolid too.
Expected<ShapeCheck> checkShape(const Node& node, const NodeParams& params, bool crossings,
                                const Progress& progress = {});

/// Checks the shape as it is at 0 s, an arm before it turns.
Expected<ShapeCheck> checkShapeAtRest(const Node& node, bool crossings, const Progress& progress = {});

/// True if the mesh is valid except for a boundary, which an open surface has.
bool isGoodSurface(const MeshReport& report);

} // namespace ramure
