#include "core/surface/proof/validate_parts.h"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

namespace ramure {

namespace {

/// OpenMesh prints a line for every face it refuses. What is wrong is in the report; nobody reads stderr.
void silenceOpenMesh()
{
    [[maybe_unused]] static const bool done = [] {
        omerr().disable();
        return true;
    }();
}

/// For every face OpenMesh walks around its vertices: with d faces around one that is d² steps. Foreign files
/// may have hubs on which it would spend hours.
constexpr Index mostFacesAroundVertex = 20'000;

bool hasHugeHub(const TriangleMesh& mesh)
{
    std::vector<Index> degree(mesh.positions.size());
    Index most = 0;
    for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            most = std::max(most, ++degree[t[k]]);
    return most > mostFacesAroundVertex;
}

bool isClosedManifold(const OpenMesh::TriMesh_ArrayKernelT<>& structure)
{
    for (const auto edge : structure.edges())
        if (structure.is_boundary(edge))
            return false;
    for (const auto vertex : structure.vertices())
        if (structure.is_isolated(vertex) || !structure.is_manifold(vertex))
            return false;
    return true;
}

} // namespace

Expected<void> confirmWithOpenMesh(const TriangleMesh& mesh, MeshReport& report, const Progress& progress)
{
    report.openMeshChecked = report.openMeshAgrees = false;
    if (const auto indices = validation::checkIndices(mesh); !indices)
        return indices;
    if (hasHugeHub(mesh))
        return {};
    silenceOpenMesh();
    OpenMesh::TriMesh_ArrayKernelT<> structure;
    const std::size_t vertices = mesh.positions.size();
    const std::size_t faces = mesh.triangles.size();
    structure.reserve(vertices, faces * 3 / 2, faces);
    for (const glm::vec3& p : mesh.positions)
        structure.add_vertex({p.x, p.y, p.z});
    bool tookAll = true;
    constexpr std::size_t chunk = std::size_t(1) << 16;
    for (std::size_t i = 0; i < faces && tookAll; ++i) {
        if (i % chunk == 0) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            progress.report(0.9 * double(i) / double(faces));
        }
        const glm::uvec3& t = mesh.triangles[i];
        const bool isProper = t.x != t.y && t.y != t.z && t.z != t.x;
        const auto handle = [](Index v) { return OpenMesh::VertexHandle(static_cast<int>(v)); };
        tookAll = isProper && structure.add_face(handle(t.x), handle(t.y), handle(t.z)).is_valid();
    }
    report.openMeshChecked = true;
    report.openMeshAgrees = tookAll && faces > 0 && isClosedManifold(structure);
    progress.report(1.0);
    return {};
}

} // namespace ramure
