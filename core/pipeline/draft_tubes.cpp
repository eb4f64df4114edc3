#include "core/pipeline/draft_tubes.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <glm/vec2.hpp>
#include <numbers>

namespace ramure {
namespace {

std::vector<glm::vec2> circle(int points)
{
    std::vector<glm::vec2> directions;
    for (int k = 0; k < points; ++k) {
        const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * k / points);
        directions.emplace_back(cosine, sine);
    }
    return directions;
}

void addRings(TriangleMesh& mesh, const SectionSet& sections, int points)
{
    const std::vector<glm::vec2> directions = circle(points);
    for (const CrossSection& section : sections.sections) {
        const glm::vec3 centre(section.centre);
        const glm::vec3 normal(section.frame.normal);
        const glm::vec3 binormal(section.frame.binormal);
        const auto radius = static_cast<float>(section.radius);
        for (const glm::vec2& direction : directions) {
            const glm::vec3 outward = direction.x * normal + direction.y * binormal;
            mesh.normals.push_back(outward);
            mesh.positions.push_back(centre + radius * outward);
        }
    }
}

} // namespace

SectionParams draftDivisions(const SectionParams& params, Index branches)
{
    const auto count = static_cast<std::int64_t>(std::max<Index>(branches, 1));
    constexpr auto most = static_cast<std::int64_t>(draftPoints);
    SectionParams draft;
    // A circle of fewer than five points is a poor one: rather fewer sections.
    draft.lengthDivisions = std::clamp<std::int64_t>(most / (5 * count), 2, params.lengthDivisions);
    draft.radialDivisions =
        std::clamp<std::int64_t>(most / (draft.lengthDivisions * count), 3, params.radialDivisions);
    return draft;
}

TriangleMesh buildDraftTubes(const Skeleton& skeleton, const SectionSet& sections, int radialDivisions)
{
    TriangleMesh mesh;
    const auto points = static_cast<Index>(radialDivisions);
    const Index perBranch = sections.perBranch * points;
    const std::size_t vertices = std::size_t(skeleton.size()) * perBranch;
    mesh.positions.reserve(vertices);
    mesh.normals.reserve(vertices);
    mesh.branch.reserve(vertices);
    mesh.triangles.reserve(2 * std::size_t(skeleton.size()) * (perBranch - points));
    addRings(mesh, sections, radialDivisions);
    for (Index branch = 0; branch < skeleton.size(); ++branch) {
        mesh.branch.insert(mesh.branch.end(), perBranch, branch);
        for (Index ring = branch * perBranch; ring < (branch + 1) * perBranch - points; ring += points) {
            Index last = points - 1;
            for (Index next = 0; next < points; last = next++) {
                const Index a = ring + last;
                const Index b = ring + next;
                mesh.triangles.push_back({a, b, b + points});
                mesh.triangles.push_back({a, b + points, a + points});
            }
        }
    }
    return mesh;
}

} // namespace ramure
