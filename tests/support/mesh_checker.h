/// \file
/// An independent judge of triangle meshes for the tests. It shares no code with the mesher and none with
/// core/surface/proof/validate: definitions are spelled out again, in the plainest way, so that one slip
/// cannot hide another.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <cstdint>
#include <string>
#include <vector>

namespace ramure::test {

/// One connected piece of a mesh (connected through shared vertices).
struct CheckedComponent
{
    Index vertices = 0, faces = 0;
    std::int64_t euler = 0; ///< vertices - edges + faces
    double volume = 0.0;    ///< signed, m³: positive when the faces look outward
};

/// What is wrong with a mesh. Counts are complete; `examples` names the first few places of each kind in
/// words.
struct CheckedMesh
{
    Index vertices = 0, faces = 0;
    Index badIndices = 0;       ///< faces that name a vertex which does not exist (they take no further part)
    Index nonFinite = 0;        ///< positions with a NaN or an infinity
    Index boundaryEdges = 0;    ///< edges of one face
    Index crowdedEdges = 0;     ///< edges of three faces or more
    Index misorientedEdges = 0; ///< edges of two faces which both run along them in the same direction
    Index pinchedVertices = 0;  ///< vertices whose faces form more than one fan
    Index duplicateVertices = 0; ///< vertices at the position of an earlier one
    Index duplicateFaces = 0;    ///< faces with the same three vertices as an earlier one
    Index degenerateFaces = 0;   ///< a repeated vertex, or an area below 1e-14 of the squared box diagonal
    Index isolatedVertices = 0;  ///< vertices in no face
    Index badNormals = 0;        ///< normals that are missing or not of unit length to 1e-4
    Index inwardNormals = 0;     ///< normals against the angle-weighted mean of the faces around the vertex
    Index badOwners = 0;         ///< branch or level arrays that do not have one entry per vertex
    std::vector<CheckedComponent> components;
    std::string examples;

    /// Closed, oriented, one fan per vertex, nothing twice, nothing without area: topology alone, normals
    /// aside.
    [[nodiscard]] bool closedManifold() const;
    /// closedManifold(), exactly \p componentCount pieces of Euler characteristic 2 and positive volume each,
    /// and normals (where the mesh has some) unit and outward.
    [[nodiscard]] bool perfect(std::size_t componentCount) const;
    /// Sum of the components' volumes, m³.
    [[nodiscard]] double volume() const;
    /// Everything that is not as it should be, with places; "perfect" pieces only are listed as counts.
    [[nodiscard]] std::string summary() const;
};

CheckedMesh checkMesh(const TriangleMesh& mesh);

} // namespace ramure::test
