#include "core/surface/mesh/normals.h"

#include "core/base/float4.h"
#include "core/base/large_buffer.h"
#include "core/base/wide_clone.h"
#include "core/surface/mesh/largest_index.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace ramure {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Triangles computed together: their numbers lie side by side, so that the compiler uses vector
/// instructions.
constexpr std::size_t vertexBlock = 128;
using Lane = std::array<float, vertexBlock>;

struct Lanes
{
    alignas(64) Lane x, y, z;
};

struct Block
{
    Lanes e1, e2;                ///< in: edges from the first corner
    Lanes normal;                ///< out: unit, zero for a triangle without area
    Lane angle0, angle1, angle2; ///< out: at the corners
};

/// The sum of a vertex; the fourth float stays zero.
struct Sum
{
    Float4 xyz{};
};

/// atan2(y, x) for y >= 0, within 1.2e-5 rad: weights need no more, and it is plain arithmetic. The
/// polynomial is 4.4.49 of Abramowitz and Stegun, "Handbook of Mathematical Functions".
inline float angleOf(float y, float x)
{
    const float across = std::abs(x);
    const float low = y < across ? y : across, high = y < across ? across : y;
    const float t = low / high;
    const float s = t * t;
    const float p = (((0.0208351f * s - 0.0851330f) * s + 0.1801410f) * s - 0.3302995f) * s + 0.9998660f;
    const float small = p * t;
    const float acute = y < across ? small : 0.5f * pi - small;
    return x < 0.0f ? pi - acute : acute;
}

/// Edges come scaled so that the mesh is about 1 in size: their squares neither vanish nor overflow.
RAMURE_WIDEST_CLONE void solveBlock(Block& b)
{
    for (std::size_t i = 0; i < vertexBlock; ++i) {
        const float ax = b.e1.x[i], ay = b.e1.y[i], az = b.e1.z[i];
        const float cx = b.e2.x[i], cy = b.e2.y[i], cz = b.e2.z[i];
        const float nx = ay * cz - az * cy, ny = az * cx - ax * cz, nz = ax * cy - ay * cx;
        const float squared = nx * nx + ny * ny + nz * nz;
        const float length = ax * ax + ay * ay + az * az;
        const float dot0 = ax * cx + ay * cy + az * cz;
        const float dot1 = length - dot0;
        const float sine = std::sqrt(squared);
        // Below the rounding of the coordinates a normal has no meaning; not-a-number fails the comparison
        // too.
        const bool usable = squared > 1e-14f * length * length;
        const float inverse = 1.0f / sine;
        b.normal.x[i] = usable ? nx * inverse : 0.0f;
        b.normal.y[i] = usable ? ny * inverse : 0.0f;
        b.normal.z[i] = usable ? nz * inverse : 0.0f;
        const float angle0 = angleOf(sine, dot0), angle1 = angleOf(sine, dot1);
        b.angle0[i] = usable ? angle0 : 0.0f;
        b.angle1[i] = usable ? angle1 : 0.0f;
        b.angle2[i] = usable ? pi - angle0 - angle1 : 0.0f;
    }
}

/// Four vectors side by side.
void storeLanes(Lanes& to, std::size_t i, Float4 a, Float4 b, Float4 c, Float4 d)
{
    transpose(a, b, c, d);
    storeFloat4(&to.x[i], a);
    storeFloat4(&to.y[i], b);
    storeFloat4(&to.z[i], c);
}

/// \tparam toLast the last vertex may be among the corners: no four floats can be read there
template <bool toLast>
[[gnu::always_inline]] inline void loadEdges(const TriangleMesh& mesh, std::size_t from, std::size_t count,
                                             float scale, Block& b)
{
    const glm::vec3* const positions = mesh.positions.data();
    const auto last = static_cast<Index>(mesh.positions.size() - 1);
    const glm::uvec3* const triangles = &mesh.triangles[from];
    const auto load = [&](Index v) {
        return !toLast || v != last ? loadFloat4(&positions[v].x) : loadFloat3(&positions[v].x);
    };
    const auto edges = [&](const glm::uvec3& t, Float4& e1, Float4& e2) {
        const Float4 p = load(t.x);
        e1 = scale * (load(t.y) - p);
        e2 = scale * (load(t.z) - p);
    };
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        Float4 a1, a2, b1, b2, c1, c2, d1, d2;
        edges(triangles[i], a1, a2);
        edges(triangles[i + 1], b1, b2);
        edges(triangles[i + 2], c1, c2);
        edges(triangles[i + 3], d1, d2);
        storeLanes(b.e1, i, a1, b1, c1, d1);
        storeLanes(b.e2, i, a2, b2, c2, d2);
    }
    // What lies behind the last triangle is solved too, and not used.
    for (; i < count; ++i) {
        Float4 e1, e2;
        edges(triangles[i], e1, e2);
        b.e1.x[i] = e1[0], b.e1.y[i] = e1[1], b.e1.z[i] = e1[2];
        b.e2.x[i] = e2[0], b.e2.y[i] = e2[1], b.e2.z[i] = e2[2];
    }
}

RAMURE_WIDE_CLONE void loadBlock(const TriangleMesh& mesh, std::size_t from, std::size_t count, float scale,
                                 bool toLast, Block& b)
{
    if (toLast)
        loadEdges<true>(mesh, from, count, scale, b);
    else
        loadEdges<false>(mesh, from, count, scale, b);
}

RAMURE_WIDE_CLONE void addBlock(const Block& b, const glm::uvec3* triangles, std::size_t count, Sum* sums)
{
    const auto add = [&](std::size_t i, const Float4& normal) {
        const glm::uvec3 t = triangles[i];
        sums[t.x].xyz += b.angle0[i] * normal;
        sums[t.y].xyz += b.angle1[i] * normal;
        sums[t.z].xyz += b.angle2[i] * normal;
    };
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        Float4 n0 = loadFloat4(&b.normal.x[i]), n1 = loadFloat4(&b.normal.y[i]),
               n2 = loadFloat4(&b.normal.z[i]), n3{};
        transpose(n0, n1, n2, n3);
        add(i, n0);
        add(i + 1, n1);
        add(i + 2, n2);
        add(i + 3, n3);
    }
    for (; i < count; ++i)
        add(i, Float4{b.normal.x[i], b.normal.y[i], b.normal.z[i], 0.0f});
}

RAMURE_WIDEST_CLONE void normalise(Lanes& lanes)
{
    for (std::size_t i = 0; i < vertexBlock; ++i) {
        const float x = lanes.x[i], y = lanes.y[i], z = lanes.z[i];
        const float squared = x * x + y * y + z * z;
        const float inverse = 1.0f / std::sqrt(squared);
        // Faces that cancel each other leave rounding, not a direction.
        const bool usable = squared > 1e-12f;
        lanes.x[i] = usable ? x * inverse : 0.0f;
        lanes.y[i] = usable ? y * inverse : 1.0f;
        lanes.z[i] = usable ? z * inverse : 0.0f;
    }
}

/// Floats without their sign compare like whole numbers, which is quick.
RAMURE_WIDEST_CLONE std::int32_t largestSize(const float* numbers, std::size_t count)
{
    std::int32_t largest = 0;
    for (std::size_t i = 0; i < count; ++i)
        largest = std::max(largest, std::bit_cast<std::int32_t>(numbers[i]) & std::int32_t(0x7FFFFFFF));
    return largest;
}

/// A power of two, so that scaling is exact.
float scaleOf(const std::vector<glm::vec3>& positions)
{
    if (positions.empty())
        return 1.0f;
    const auto size = std::bit_cast<float>(largestSize(&positions[0].x, 3 * positions.size()));
    return size > 0.0f && size <= std::numeric_limits<float>::max() ? std::ldexp(1.0f, -std::ilogb(size))
                                                                    : 1.0f;
}

} // namespace

void computeNormals(TriangleMesh& mesh)
{
    LargeBuffer<Sum> sums(mesh.positions.size() + 4); // read four at a time
    // Cleared just before they are needed: then they are in the cache, of vertices in the order of the faces.
    std::size_t cleared = 0;
    const auto clearTo = [&](std::size_t end) {
        for (; cleared < end; ++cleared)
            sums[cleared] = {};
    };
    const float scale = scaleOf(mesh.positions);
    Block block{};
    for (std::size_t from = 0; from < mesh.triangles.size(); from += vertexBlock) {
        const std::size_t count = std::min(vertexBlock, mesh.triangles.size() - from);
        const Index largest = largestIndex({&mesh.triangles[from], count});
        clearTo(std::size_t(largest) + 1);
        loadBlock(mesh, from, count, scale, largest + 1 >= mesh.positions.size(), block);
        solveBlock(block);
        addBlock(block, &mesh.triangles[from], count, sums.data());
    }
    clearTo(sums.size());
    mesh.normals.resize(mesh.positions.size());
    Lanes lanes{};
    for (std::size_t from = 0; from < mesh.normals.size(); from += vertexBlock) {
        const std::size_t count = std::min(vertexBlock, mesh.normals.size() - from);
        for (std::size_t i = 0; i < count; i += 4) {
            const Sum* const sum = &sums[from + i];
            storeLanes(lanes, i, sum[0].xyz, sum[1].xyz, sum[2].xyz, sum[3].xyz);
        }
        normalise(lanes);
        for (std::size_t i = 0; i < count; ++i)
            mesh.normals[from + i] = {lanes.x[i], lanes.y[i], lanes.z[i]};
    }
}

} // namespace ramure
