/// \file
/// The arrays of a mesh that nobody needs any more, kept for the next one: memory that was used before is not
/// taken from the system again, and an array that has its size is not cleared before it is written.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <memory>

namespace ramure {

/// Copies share what they keep. Any thread.
class MeshArrays
{
public:
    MeshArrays();
    /// Arrays of whatever size and contents, or empty ones. Only those that every mesh has: positions,
    /// normals, triangles, branch and level.
    TriangleMesh take();
    /// Of two sets the larger one is kept, and none that is very large.
    void keep(TriangleMesh&& mesh);
    /// A mesh that gives its arrays back when nobody needs it any more, on whatever thread that is, even when
    /// this is gone.
    std::shared_ptr<const TriangleMesh> share(TriangleMesh&& mesh);

private:
    struct Kept;
    std::shared_ptr<Kept> m_kept;
};

} // namespace ramure
