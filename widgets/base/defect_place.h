/// \file
/// The place of a mesh's defect, for the viewport to frame and to draw.
#pragma once

#include "core/math/box.h"
#include "core/surface/proof/validate.h"
#include <QMetaType>
#include <QString>
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ramure {

/// World space. Only the lists that fit the kind are filled: vertices as points, edges with their two ends,
/// faces with their three corners.
struct DefectPlace
{
    DefectKind kind = DefectKind::BoundaryEdge;
    std::vector<glm::dvec3> points;
    std::vector<std::array<glm::dvec3, 2>> edges;
    std::vector<std::array<glm::dvec3, 3>> faces;
    Box box;       ///< bounds of the whole defect, with room around it for the eye
    QString label; ///< its name, one or two lines; may be empty
};

/// \param world from the mesh's space. Indices that the mesh does not have are left out.
DefectPlace defectPlace(const TriangleMesh& mesh, const Defect& defect, const glm::dmat4& world);
/// Faces of a mesh; noIndex is left out.
DefectPlace facesPlace(const TriangleMesh& mesh, const std::array<Index, 2>& faces, const glm::dmat4& world);
/// A point of the mesh's space with so much room around it, in the same space.
DefectPlace pointPlace(const glm::dvec3& point, double room, const glm::dmat4& world);
/// Returns its middle in the mesh's space; nothing if the mesh does not have it.
std::optional<glm::dvec3> defectMiddle(const TriangleMesh& mesh, const Defect& defect);
std::optional<glm::dvec3> facesMiddle(const TriangleMesh& mesh, const std::array<Index, 2>& faces);
/// The branch that the face's first vertex follows, or noIndex.
Index faceBranch(const TriangleMesh& mesh, Index face);
/// The branch that the defect's first vertex follows, or noIndex.
Index defectBranch(const TriangleMesh& mesh, const Defect& defect);

} // namespace ramure

Q_DECLARE_METATYPE(ramure::DefectPlace)
