/// \file
/// Is a mesh one closed, oriented 2-manifold? Every defect is counted and listed.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <cstdint>
#include <functional>
#include <vector>

namespace ramure {

enum class DefectKind : std::uint8_t {
    BoundaryEdge,      ///< one face only
    NonManifoldEdge,   ///< three faces or more
    NonManifoldVertex, ///< more than one fan of faces
    InconsistentEdge,  ///< its two faces run along it in the same direction
    DuplicateVertex,   ///< at the position of an earlier vertex (-0 = 0)
    DuplicateFace,     ///< the same three vertices as an earlier face, in whatever order
    DegenerateFace,    ///< a repeated vertex, or no area
    IsolatedVertex,    ///< in no face
};
inline constexpr int defectKindCount = 8;

struct Defect
{
    DefectKind kind;
    Index a = noIndex; ///< vertex, or first vertex of the edge, or face
    Index b = noIndex; ///< second vertex of the edge, the other vertex or face of a duplicate
};

struct MeshReport
{
    bool valid = false; ///< no defect of any kind, at least one face, volume > 0 in every component
    Index vertices = 0, faces = 0;
    Index boundaryEdges = 0, nonManifoldEdges = 0, nonManifoldVertices = 0, inconsistentEdges = 0;
    Index duplicateVertices = 0, duplicateFaces = 0, degenerateFaces = 0, isolatedVertices = 0;
    Index components = 0;                 ///< pieces that share no vertex
    std::int64_t eulerCharacteristic = 0; ///< V - E + F of the vertices in use
    double volume = 0.0;                  ///< signed, m³: positive when faces look outward
    bool openMeshAgrees = false; ///< OpenMesh's half-edge structure took every face and found no boundary
    bool openMeshChecked = false;
    std::vector<Defect> defects; ///< at most 10,000 of each kind; the counts above are complete

    [[nodiscard]] Index count(DefectKind kind) const;
};

/// The check over plain arrays: fast, always on. A face is degenerate when two of its vertices are one, or
/// when its area is below 1e-14 of the squared diagonal of the mesh's box (or not a number). One with a
/// repeated vertex has no edges and counts for nothing else. Faces around a vertex belong to one fan when
/// they hang together through edges at it. Defects are listed kind by kind, by ascending vertex or face.
/// \param alongside if given, is called once, on whatever thread, and is done when this returns without an
/// error: work that takes about a third as long and writes nothing that the check reads. It may come before
/// the look at the indices: for meshes of the program's own making.
/// Errors: Cancelled, Invalid for an index out of range, Limit (more than 1.4 billion faces).
Expected<MeshReport> validateMesh(const TriangleMesh& mesh, const Progress& progress = {},
                                  const std::function<void()>& alongside = {});

/// Builds OpenMesh's half-edge structure from the mesh and sets openMeshChecked and openMeshAgrees. A mesh
/// with more than 20,000 faces around one vertex stays unchecked: OpenMesh's time grows with the square of
/// their number. Errors: Cancelled, or Invalid for an index out of range.
Expected<void> confirmWithOpenMesh(const TriangleMesh& mesh, MeshReport& report,
                                   const Progress& progress = {});

} // namespace ramure
