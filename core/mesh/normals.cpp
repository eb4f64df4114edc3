#include "core/mesh/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Triangles computed together: their numbers lie side by side, so that the compiler uses vector
/// instructions.
constexpr std::size_t blockSize = 128;
using Lane = std::array<float, blockSize>;

struct Lanes
{
    Lane x, y, z;
};

struct Block
{
    Lanes e1, e2;                ///< in: edges from the first corner
    Lanes normal;                ///< out: unit, zero for a triangle without area
    Lane angle0, angle1, angle2; ///< out: at the corners
};

/// atan2(y, x) for y >= 0, within 1.2e-5 rad: weights need no more, and it is plain arithmetic. The
/// polynomial is 4.4.49 of Abramowitz and Stegun, "Handbook of Mathematical Functions".
inline float angleOf(float y, float x)
{
    const float across = std::abs(x);
    const float low = y < across ? y : across, high = y < across ? across : y;
    const float t = low / (high + 1e-37f);
    const float s = t * t;
    const float p = (((0.0208351f * s - 0.0851330f) * s + 0.1801410f) * s - 0.3302995f) * s + 0.9998660f;
    const float small = p * t;
    const float acute = y < across ? small : 0.5f * pi - small;
    return x < 0.0f ? pi - acute : acute;
}

inline float largest(float a, float b)
{
    return a > b ? a : b;
}

void solveBlock(Block& b)
{
    for (std::size_t i = 0; i < blockSize; ++i) {
        float ax = b.e1.x[i], ay = b.e1.y[i], az = b.e1.z[i];
        float cx = b.e2.x[i], cy = b.e2.y[i], cz = b.e2.z[i];
        // Only the shape counts: scaled to about 1, no triangle is too small or too large for a float's
        // squares.
        const float size =
            largest(largest(largest(std::abs(ax), std::abs(ay)), largest(std::abs(az), std::abs(cx))),
                    largest(std::abs(cy), std::abs(cz)));
        const float scale = 1.0f / largest(size, 1e-37f);
        ax *= scale, ay *= scale, az *= scale;
        cx *= scale, cy *= scale, cz *= scale;
        const float nx = ay * cz - az * cy, ny = az * cx - ax * cz, nz = ax * cy - ay * cx;
        const float squared = nx * nx + ny * ny + nz * nz;
        const float sine = std::sqrt(squared);
        const float bx = cx - ax, by = cy - ay, bz = cz - az;
        const float dot0 = ax * cx + ay * cy + az * cz;
        const float dot1 = -(ax * bx + ay * by + az * bz);
        // Below the rounding of the coordinates a normal has no meaning; not-a-number fails the comparison
        // too.
        const bool usable = squared > 1e-14f;
        const float inverse = usable ? 1.0f / sine : 0.0f;
        b.normal.x[i] = usable ? nx * inverse : 0.0f;
        b.normal.y[i] = usable ? ny * inverse : 0.0f;
        b.normal.z[i] = usable ? nz * inverse : 0.0f;
        const float angle0 = angleOf(sine, dot0), angle1 = angleOf(sine, dot1);
        b.angle0[i] = usable ? angle0 : 0.0f;
        b.angle1[i] = usable ? angle1 : 0.0f;
        b.angle2[i] = usable ? pi - angle0 - angle1 : 0.0f;
    }
}

void loadBlock(const TriangleMesh& mesh, std::size_t from, std::size_t count, Block& b)
{
    for (std::size_t i = 0; i < count; ++i) {
        const glm::uvec3& t = mesh.triangles[from + i];
        const glm::vec3& p = mesh.positions[t.x];
        const glm::vec3 e1 = mesh.positions[t.y] - p, e2 = mesh.positions[t.z] - p;
        b.e1.x[i] = e1.x, b.e1.y[i] = e1.y, b.e1.z[i] = e1.z;
        b.e2.x[i] = e2.x, b.e2.y[i] = e2.y, b.e2.z[i] = e2.z;
    }
}

void addBlock(const Block& b, std::size_t from, std::size_t count, TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < count; ++i) {
        const glm::uvec3& t = mesh.triangles[from + i];
        const glm::vec3 normal(b.normal.x[i], b.normal.y[i], b.normal.z[i]);
        mesh.normals[t.x] += b.angle0[i] * normal;
        mesh.normals[t.y] += b.angle1[i] * normal;
        mesh.normals[t.z] += b.angle2[i] * normal;
    }
}

} // namespace

void computeNormals(TriangleMesh& mesh)
{
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    Block block{};
    for (std::size_t from = 0; from < mesh.triangles.size(); from += blockSize) {
        const std::size_t count = std::min(blockSize, mesh.triangles.size() - from);
        loadBlock(mesh, from, count, block);
        solveBlock(block);
        addBlock(block, from, count, mesh);
    }
    for (glm::vec3& normal : mesh.normals) {
        const float squared = glm::dot(normal, normal);
        // Faces that cancel each other leave rounding, not a direction.
        normal = squared > 1e-12f ? normal * (1.0f / std::sqrt(squared)) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

} // namespace ramure
