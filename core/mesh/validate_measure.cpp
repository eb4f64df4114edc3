#include "core/base/float4.h"
#include "core/base/wide_clone.h"
#include "core/mesh/validate_parts.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure::validation {

namespace {

/// A face is degenerate when its area is not above this share of the squared diagonal of the mesh's box.
constexpr double smallestAreaRatio = 1e-14;

struct Box
{
    glm::dvec3 centre{0.0};
    double squaredDiagonal = 0.0;
};

/// The lowest and the highest of the finite numbers in each place.
struct Range
{
    Float4 low = Float4{} + std::numeric_limits<float>::max();
    Float4 high = Float4{} - std::numeric_limits<float>::max();

    void add(Float4 p)
    {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const auto isFinite = (p < infinity) & (p > -infinity); // NaN is neither
        low = (p < low) & isFinite ? p : low;
        high = (p > high) & isFinite ? p : high;
    }
};

/// The box of the finite positions. Four of them are three times four numbers: xyzx, yzxy, zxyz.
Box boxOf(std::span<const glm::vec3> positions)
{
    Range ranges[3];
    std::size_t i = 0;
    for (; i + 4 <= positions.size(); i += 4)
        for (std::size_t k = 0; k < 3; ++k)
            ranges[k].add(loadFloat4(&positions[i].x + 4 * k));
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high = -low;
    const auto add = [&](int axis, float from, float to) {
        low[axis] = std::min(low[axis], from);
        high[axis] = std::max(high[axis], to);
    };
    for (int place = 0; place < 12; ++place)
        add(place % 3, ranges[place / 4].low[place % 4], ranges[place / 4].high[place % 4]);
    for (; i < positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(positions[i][axis]))
                add(axis, positions[i][axis], positions[i][axis]);
    if (low.x > high.x || low.y > high.y || low.z > high.z)
        return {};
    const glm::dvec3 from(low);
    const glm::dvec3 to(high);
    return {(from + to) * 0.5, glm::dot(to - from, to - from)};
}

/// Faces measured together: their numbers lie side by side, so that vector instructions take several.
constexpr std::size_t blockSize = 64;
using Lane = std::array<double, blockSize>;

struct Block
{
    std::array<std::array<float, blockSize>, 9> in; ///< x, y and z of the first, second and third corner
    Lane squared;                                   ///< out: doubled area, squared
    Lane sixfold;                                   ///< out: volume over the box's centre, six times
};

/// True where a face may be degenerate.
RAMURE_WIDE_CLONE bool solve(Block& b, const glm::dvec3& centre, double smallestSquared)
{
    for (std::size_t i = 0; i < blockSize; ++i) {
        const double ax = b.in[0][i], ay = b.in[1][i], az = b.in[2][i];
        const double ux = b.in[3][i] - ax, uy = b.in[4][i] - ay, uz = b.in[5][i] - az;
        const double vx = b.in[6][i] - ax, vy = b.in[7][i] - ay, vz = b.in[8][i] - az;
        const double nx = uy * vz - vy * uz, ny = uz * vx - vz * ux, nz = ux * vy - vx * uy;
        b.squared[i] = nx * nx + ny * ny + nz * nz;
        b.sixfold[i] = (ax - centre.x) * nx + (ay - centre.y) * ny + (az - centre.z) * nz;
    }
    std::int64_t small = 0;
    for (std::size_t i = 0; i < blockSize; ++i)
        small |= b.squared[i] > smallestSquared ? 0 : 1; // so written that NaN is degenerate too
    return small != 0;
}

void load(Block& b, const TriangleMesh& mesh, std::size_t from, std::size_t count)
{
    const glm::uvec3* const triangles = &mesh.triangles[from];
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3& p = mesh.positions[triangles[i][k]];
            const auto row = static_cast<std::size_t>(3 * k);
            b.in[row][i] = p.x, b.in[row + 1][i] = p.y, b.in[row + 2][i] = p.z;
        }
}

/// Calls \p use(block, first, count, smallestSquared) for all faces in order, until cancelled; the last is
/// negative where none of them is degenerate.
template <class Use> void forMeasured(const TriangleMesh& mesh, const Progress& progress, Use&& use)
{
    const Box box = boxOf(mesh.positions);
    // Doubled areas are compared squared: |cross|² <= (2 * area)².
    const double smallest = 2.0 * smallestAreaRatio * box.squaredDiagonal;
    Block block{};
    for (std::size_t from = 0; from < mesh.triangles.size(); from += blockSize) {
        if (from % (blockSize << 10) == 0 && progress.cancelled())
            return;
        const std::size_t count = std::min(blockSize, mesh.triangles.size() - from);
        load(block, mesh, from, count);
        const bool mayBeDegenerate = solve(block, box.centre, smallest * smallest);
        use(block, static_cast<Index>(from), static_cast<Index>(count),
            mayBeDegenerate ? smallest * smallest : -1.0);
    }
}

} // namespace

// Volumes are sums over tetrahedra whose tip is the box's centre: near the mesh, so that little is lost to
// cancellation.
Volumes measureFaces(const TriangleMesh& mesh, DefectLog& log, const Progress& progress)
{
    double volume = 0.0;
    forMeasured(mesh, progress, [&](const Block& block, Index first, Index count, double smallestSquared) {
        for (Index i = 0; i < count; ++i)
            volume += block.sixfold[i];
        for (Index i = 0; i < count && smallestSquared >= 0.0; ++i)
            if (!(block.squared[i] > smallestSquared))
                log.add(DefectKind::DegenerateFace, first + i);
    });
    return {volume / 6.0, volume / 6.0 > 0.0};
}

Volumes measureComponents(const TriangleMesh& mesh, const Components& components)
{
    std::vector<double> volume(components.count, 0.0);
    forMeasured(mesh, {}, [&](const Block& block, Index first, Index count, double) {
        for (Index i = 0; i < count; ++i)
            if (const Index component = components.of[mesh.triangles[first + i].x]; component != noIndex)
                volume[component] += block.sixfold[i];
    });
    Volumes result;
    for (const double v : volume) {
        result.sum += v / 6.0;
        result.allPositive = result.allPositive && v > 0.0;
    }
    return result;
}

} // namespace ramure::validation
