#include "core/surface/foliage/bark_place.h"

#include <glm/geometric.hpp>
#include <limits>

namespace ramure {

/// The shares of a, b and c in the triangle's point nearest to \p p (Ericson, Real-Time Collision Detection,
/// 2005, 5.1.5).
static glm::dvec3 nearestShares(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d1 <= 0.0 && d2 <= 0.0)
        return {1.0, 0.0, 0.0};
    if (d3 >= 0.0 && d4 <= d3)
        return {0.0, 1.0, 0.0};
    if (d6 >= 0.0 && d5 <= d6)
        return {0.0, 0.0, 1.0};
    const double ofC = d1 * d4 - d3 * d2, ofB = d5 * d2 - d1 * d6, ofA = d3 * d6 - d5 * d4;
    if (ofC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
    if (ofB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
    if (ofA <= 0.0 && d4 >= d3 && d5 >= d6) {
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - share, share};
    }
    return glm::dvec3(ofA, ofB, ofC) / (ofA + ofB + ofC);
}

std::vector<std::span<const glm::uvec3>> trianglesOfTubes(const BranchMesh& mesh, std::size_t branches)
{
    std::vector<std::span<const glm::uvec3>> out(branches);
    const std::span<const glm::uvec3> all = mesh.mesh.triangles;
    for (std::size_t i = 0; i < mesh.tubes.size(); ++i) {
        const std::size_t first = mesh.tubes[i].firstTriangle;
        const std::size_t end = i + 1 < mesh.tubes.size() ? mesh.tubes[i + 1].firstTriangle : all.size();
        if (auto& tube = out[mesh.tubes[i].branch]; tube.empty())
            tube = all.subspan(first, end - first);
    }
    return out;
}

BarkPlace nearestOnBark(const TriangleMesh& mesh, std::span<const glm::uvec3> tube, const glm::dvec3& place)
{
    const auto corner = [&mesh](Index vertex) { return glm::dvec3(mesh.positions[vertex]); };
    double nearest = std::numeric_limits<double>::max();
    BarkPlace found{tube.front()};
    for (const glm::uvec3& t : tube) {
        const glm::dvec3 a = corner(t.x), b = corner(t.y), c = corner(t.z);
        const glm::dvec3 shares = nearestShares(place, a, b, c);
        const glm::dvec3 away = shares.x * a + shares.y * b + shares.z * c - place;
        if (const double distance = glm::dot(away, away); distance < nearest) {
            nearest = distance;
            found = {t, shares};
        }
    }
    return found;
}

} // namespace ramure
