#include "core/surface/texture/cut_wood.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr float barkShare = 0.88F;  ///< of the radius is wood
constexpr float lift = 0.012F;      ///< of the radius: how far it lies on the end
constexpr double yearWidth = 0.012; ///< m, of a ring; thinner branches have fewer
constexpr int fewestYears = 3, mostYears = 9;
constexpr float heartShare = 0.5F, offCentre = 0.12F; ///< of the radius
constexpr glm::vec3 sapwood(226.0F, 197.0F, 152.0F), heartwood(186.0F, 139.0F, 90.0F);
constexpr float lateWood = 0.86F;                      ///< every other ring is darker
constexpr glm::vec3 brokenWood(150.0F, 126.0F, 98.0F); ///< grey and brown: it has stood in the rain
constexpr float leastUneven = 0.02F;                   ///< of the radius: what is less uneven was sawn

/// The border of a flat end, counter-clockwise seen from outside.
struct FlatEnd
{
    std::vector<glm::vec3> border;
    glm::vec3 centre{0.0F};
    Index branch = noIndex;
};

glm::u8vec3 colourOf(int year, int years)
{
    const float share = (static_cast<float>(year) + 0.5F) / static_cast<float>(years);
    const glm::vec3 wood = share < heartShare ? heartwood : sapwood;
    return glm::u8vec3((year % 2 == 0 ? 1.0F : lateWood) * wood);
}

/// The fan at the end of a tube, or at the beginning: triangles around a centre, their last corners.
FlatEnd endOf(const TriangleMesh& mesh, Index first, Index last, bool atStart)
{
    FlatEnd end;
    const Index centre = mesh.triangles[atStart ? first : last].z;
    end.centre = mesh.positions[centre];
    end.branch = mesh.branch[centre];
    for (Index i = 0; i <= last - first; ++i) {
        const glm::uvec3& triangle = mesh.triangles[atStart ? first + i : last - i];
        if (triangle.z != centre)
            break;
        end.border.push_back(mesh.positions[triangle.x]);
    }
    // The fan of a root goes backwards, and that of a tip was read so.
    std::ranges::reverse(end.border);
    if (atStart) // around a root there is no ring within the edge
        for (glm::vec3& point : end.border)
            point = glm::mix(end.centre, point, barkShare);
    return end;
}

void addWood(const FlatEnd& end, std::uint64_t key, Index level, float leastGap, TriangleMesh& out)
{
    const auto sides = static_cast<Index>(end.border.size());
    if (sides < 3)
        return;
    glm::vec3 normal(0.0F);
    float radius = 0.0F;
    for (Index k = 0; k < sides; ++k) {
        const glm::vec3 way = end.border[k] - end.centre;
        normal += glm::cross(way, end.border[(k + 1) % sides] - end.centre);
        radius = std::max(radius, glm::length(way));
    }
    if (!(glm::dot(normal, normal) > 0.0F))
        return;
    normal = glm::normalize(normal);
    // The pith is seldom in the middle.
    const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * double(mixBits(key) >> 11) * 0x1p-53);
    const glm::vec3 aside = end.border[0] - end.centre, across = glm::cross(normal, aside);
    const glm::vec3 pith = end.centre + offCentre * (float(cosine) * aside + float(sine) * across);
    const int years =
        std::clamp(static_cast<int>(std::lround(double(radius) / yearWidth)), fewestYears, mostYears);
    const Index first = out.vertexCount();
    const auto add = [&](const glm::vec3& at) {
        out.positions.push_back(at + std::max(lift * radius, leastGap) * normal);
        out.normals.push_back(normal);
        out.branch.push_back(end.branch);
        out.level.push_back(level);
    };
    add(pith);
    for (int year = 1; year <= years; ++year)
        for (const glm::vec3& point : end.border)
            add(glm::mix(pith, point, static_cast<float>(year) / static_cast<float>(years)));
    for (int year = 0; year < years; ++year)
        for (Index k = 0; k < sides; ++k) {
            const Index outer = first + 1 + static_cast<Index>(year) * sides, inner = outer - sides;
            const Index next = (k + 1) % sides;
            const glm::u8vec3 colour = colourOf(year, years);
            if (year > 0) {
                out.triangles.push_back({inner + k, outer + k, outer + next});
                out.triangles.push_back({inner + k, outer + next, inner + next});
                out.colours.push_back(colour);
            } else {
                out.triangles.push_back({first, outer + k, outer + next});
            }
            out.colours.push_back(colour);
        }
}

/// m, from its middle; and how far its points are from one plane.
struct EndShape
{
    float radius = 0.0F, uneven = 0.0F;
};

EndShape shapeOf(const FlatEnd& end)
{
    EndShape shape;
    glm::vec3 normal(0.0F);
    for (std::size_t k = 0; k < end.border.size(); ++k) {
        const glm::vec3 way = end.border[k] - end.centre;
        normal += glm::cross(way, end.border[(k + 1) % end.border.size()] - end.centre);
        shape.radius = std::max(shape.radius, glm::length(way));
    }
    if (const float size = glm::length(normal); size > 0.0F)
        for (const glm::vec3& point : end.border)
            shape.uneven = std::max(shape.uneven, std::abs(glm::dot(point - end.centre, normal / size)));
    return shape;
}

/// The splinters of a broken end, and what they stand around: a copy a little above the bark's.
/// \param last triangle of the tube, which ends with a fan; the strip around that has twice its triangles
/// \param above m, how far
void addSplinters(const TriangleMesh& mesh, Index last, Index fan, std::uint64_t key, Index level,
                  float above, TriangleMesh& out)
{
    for (Index t = last + 1 - 3 * fan; t <= last; ++t) {
        const glm::uvec3& corners = mesh.triangles[t];
        const glm::vec3 &a = mesh.positions[corners.x], &b = mesh.positions[corners.y],
                        &c = mesh.positions[corners.z];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const float size = glm::length(normal);
        if (!(size > 0.0F))
            continue;
        const Index first = out.vertexCount();
        for (int k = 0; k < 3; ++k) {
            const glm::vec3& own = mesh.normals.empty() ? normal / size : mesh.normals[corners[k]];
            out.positions.push_back(mesh.positions[corners[k]] + above * own);
            out.normals.push_back(normal / size);
            out.branch.push_back(mesh.branch[corners[k]]);
            out.level.push_back(level);
        }
        out.triangles.push_back({first, first + 1, first + 2});
        const float shade = 0.75F + 0.5F * static_cast<float>(mixBits(key + t - last) >> 40) * 0x1p-24F;
        out.colours.push_back(glm::u8vec3(shade * brokenWood));
    }
}

} // namespace

TriangleMesh cutWood(const BranchMesh& mesh, const Skeleton& skeleton)
{
    TriangleMesh out;
    if (skeleton.sawn.empty() && skeleton.loose.empty())
        return out;
    const auto add = [&](const TubeRange& tube, Index last, bool atStart) {
        const FlatEnd end = endOf(mesh.mesh, tube.firstTriangle, last, atStart);
        const std::uint64_t key = skeleton.key[tube.branch];
        const Index level = skeleton.level[tube.branch];
        const auto leastGap = static_cast<float>(mesh.leastGap);
        const auto fan = static_cast<Index>(end.border.size());
        const auto [radius, uneven] = shapeOf(end);
        const bool isTorn = uneven > leastUneven * radius && 3 * fan <= last - tube.firstTriangle + 1;
        if (isTorn && !atStart && std::ranges::binary_search(skeleton.bare, tube.branch))
            addSplinters(mesh.mesh, last, fan, key, level, std::max(lift * radius, leastGap), out);
        else
            addWood(end, key, level, leastGap, out);
    };
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        const TubeRange& tube = mesh.tubes[t];
        const Index last =
            (t + 1 < mesh.tubes.size() ? mesh.tubes[t + 1].firstTriangle : mesh.mesh.faceCount()) - 1;
        const bool isSawn = std::ranges::binary_search(skeleton.sawn, tube.branch);
        const bool isLoose = std::ranges::binary_search(skeleton.loose, tube.branch, {}, &LooseLimb::first);
        if (isLoose && tube.parent == noIndex)
            add(tube, last, true);
        if (isSawn)
            add(tube, last, false);
    }
    return out;
}

} // namespace ramure
