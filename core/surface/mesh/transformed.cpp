#include "core/surface/mesh/transformed.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace ramure {

TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix)
{
    TriangleMesh out = mesh;
    for (glm::vec3& p : out.positions)
        p = glm::vec3(glm::dvec3(matrix * glm::dvec4(p, 1.0)));
    const glm::dmat3 linear(matrix);
    const double determinant = glm::determinant(linear);
    if (determinant == 0.0) {
        out.normals.clear();
    } else {
        const glm::dmat3 forNormals = glm::transpose(glm::inverse(linear));
        for (glm::vec3& n : out.normals)
            n = glm::vec3(glm::normalize(forNormals * glm::dvec3(n)));
    }
    if (determinant < 0.0)
        for (std::vector<glm::uvec3>* corners : {&out.triangles, &out.uvTriangles})
            for (glm::uvec3& t : *corners)
                std::swap(t.y, t.z);
    return out;
}

} // namespace ramure
