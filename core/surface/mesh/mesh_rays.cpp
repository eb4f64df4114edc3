#include "core/surface/mesh/mesh_rays.h"

namespace ramure {

MeshRays::MeshRays(std::shared_ptr<const TriangleMesh> mesh, const std::stop_token& stop)
    : m_mesh(std::move(mesh))
{
    if (!m_mesh)
        return;
    std::vector<PrimitiveBounds> bounds;
    bounds.reserve(m_mesh->triangles.size());
    for (Index i = 0; i < m_mesh->faceCount(); ++i) {
        const glm::uvec3& t = m_mesh->triangles[i];
        const glm::vec3 &a = m_mesh->positions[t.x], &b = m_mesh->positions[t.y], &c = m_mesh->positions[t.z];
        bounds.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
    }
    m_tree = Bvh(std::move(bounds), stop);
}

std::optional<MeshHit> MeshRays::nearest(const Ray& ray) const
{
    std::optional<MeshHit> best;
    m_tree.alongRay(ray, std::numeric_limits<double>::max(), [&](Index i, double& tMost) {
        const glm::uvec3& t = m_mesh->triangles[i];
        const auto hit = intersect(ray, glm::dvec3(m_mesh->positions[t.x]),
                                   glm::dvec3(m_mesh->positions[t.y]), glm::dvec3(m_mesh->positions[t.z]));
        if (!hit || (best && (hit->t > best->t || (hit->t == best->t && i > best->triangle))))
            return;
        best = MeshHit{hit->t, i, ray.at(hit->t)};
        tMost = hit->t;
    });
    return best;
}

} // namespace ramure
