/// \file
/// Finds where a ray first meets a mesh. The structure is built once and can be asked from any thread.
#pragma once

#include "core/math/bvh.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <memory>
#include <optional>

namespace ramure {

struct MeshHit
{
    double t = 0.0; ///< in lengths of the ray's direction
    Index triangle = 0;
    glm::dvec3 point{0.0};
};

class MeshRays
{
public:
    MeshRays() = default;
    /// \param mesh may be null: nothing is ever met
    explicit MeshRays(std::shared_ptr<const TriangleMesh> mesh, const std::stop_token& stop = {});

    /// The nearest hit, of either side of the triangles; of several at the same distance the first triangle.
    [[nodiscard]] std::optional<MeshHit> nearest(const Ray& ray) const;
    [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const { return m_mesh; }

private:
    std::shared_ptr<const TriangleMesh> m_mesh;
    Bvh m_tree;
};

} // namespace ramure
