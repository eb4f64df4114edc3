#include "core/surface/foliage/foliage_texture.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/foliage_shapes.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {

namespace {

bool isPole(const glm::vec3& place)
{
    return std::abs(place.x) < 1e-4f && std::abs(place.z) < 1e-4f;
}

/// Fruit have the picture of the globe around them; what lies on a unit sphere stays where it is.
glm::vec3 round(const glm::vec3& place)
{
    const float length = glm::length(place);
    return std::abs(length - 1.0f) < 1e-5f || length == 0.0f ? place : place / length;
}

glm::vec2 onGlobe(const glm::vec3& place)
{
    return {maths::atan2(place.x, place.z) / (2.0 * pi) + 0.5,
            maths::asin(std::clamp(place.y, -1.0f, 1.0f)) / pi + 0.5};
}

/// Three coordinates per triangle of a body about the origin.
std::vector<glm::vec2> globe(const TriangleMesh& sphere)
{
    std::vector<glm::vec2> uv;
    uv.reserve(3 * sphere.triangles.size());
    for (const glm::uvec3& triangle : sphere.triangles) {
        std::array<glm::vec2, 3> corner;
        int pole = -1;
        float least = 1.0f, most = 0.0f;
        for (int c = 0; c < 3; ++c) {
            const glm::vec3 place = round(sphere.positions[triangle[c]]);
            corner[std::size_t(c)] = onGlobe(place);
            if (isPole(place)) {
                pole = c;
                continue;
            }
            least = std::min(least, corner[std::size_t(c)].x);
            most = std::max(most, corner[std::size_t(c)].x);
        }
        if (most - least > 0.5f)
            for (glm::vec2& at : corner)
                at.x += at.x < 0.5f ? 1.0f : 0.0f;
        if (pole >= 0) // between the other two
            corner[std::size_t(pole)].x =
                0.5f * (corner[std::size_t(pole + 1) % 3].x + corner[std::size_t(pole + 2) % 3].x);
        uv.insert(uv.end(), corner.begin(), corner.end());
    }
    return uv;
}

} // namespace

void addLeafTexture(TriangleMesh& leaves, const LeafForm& form)
{
    const bool faithful = form.shape == LeafShape::Faithful;
    TriangleMesh leaf = faithful ? unitTriangle() : leafMesh(form);
    if (faithful)
        for (const glm::vec3& at : leaf.positions)
            leaf.uv.emplace_back(at.x + 0.5f, at.y - leaf.positions[0].y);
    leaves.uvTriangles.clear();
    leaves.uv.resize(leaves.positions.size());
    for (std::size_t v = 0; v < leaves.uv.size(); ++v)
        leaves.uv[v] = leaf.uv[v % leaf.uv.size()];
}

void addAppleTexture(TriangleMesh& apples, const FruitForm& form)
{
    const std::vector<glm::vec2> apple = globe(fruitMesh(form));
    const std::size_t corners = apple.size();
    apples.uv = apple; // the same for all apples
    apples.uvTriangles.resize(apples.triangles.size());
    for (std::size_t t = 0; t < apples.triangles.size(); ++t) {
        const auto first = static_cast<Index>(3 * t % corners);
        apples.uvTriangles[t] = {first, first + 1, first + 2};
    }
}

} // namespace ramure
