#include "core/surface/mesh/triangle_mesh.h"

#include "core/surface/mesh/mesh_hash.h"

namespace ramure {

std::uint64_t hashOf(const TriangleMesh& mesh)
{
    const MeshHash hash = meshHash(mesh);
    return hash.high ^ hash.low;
}

template <class T> static std::size_t bytesIn(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}

std::size_t bytesOf(const TriangleMesh& mesh)
{
    return bytesIn(mesh.positions) + bytesIn(mesh.normals) + bytesIn(mesh.triangles) + bytesIn(mesh.branch) +
           bytesIn(mesh.level) + bytesIn(mesh.uv) + bytesIn(mesh.uvTriangles) + bytesIn(mesh.colours) +
           bytesIn(mesh.radius);
}

} // namespace ramure
