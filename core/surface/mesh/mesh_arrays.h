/// \file
/// Keeps the arrays of unused meshes for the next one: used memory need not be taken from the system again,
/// and an array of the right size is not cleared before it is written.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <memory>

namespace ramure {

/// Copies share the kept arrays. May be used from any thread.
class MeshArrays
{
public:
    MeshArrays();
    /// Returns arrays of any size and contents, or empty ones. Only the arrays that every mesh has are kept:
    /// positions, normals, triangles, branch and level.
    TriangleMesh take();
    /// Keeps the larger of two sets of arrays, but no very large one.
    void keep(TriangleMesh&& mesh);
    /// Makes a mesh that gives its arrays back when its last owner is gone, on any thread, even if this
    /// object is gone.
    std::shared_ptr<const TriangleMesh> share(TriangleMesh&& mesh);

private:
    struct Kept;
    std::shared_ptr<Kept> m_kept;
};

} // namespace ramure
