#include "core/base/float4.h"
#include "core/base/wide_clone.h"
#include "core/surface/mesh/largest_index.h"
#include "core/surface/proof/validate_parts.h"
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

/// Numbers that are compared at a time: sixteen points.
constexpr std::size_t rangeSize = 48;

/// The lowest and the highest of the finite numbers in each place.
struct Range
{
    std::array<float, rangeSize> low, high;
};

RAMURE_WIDEST_CLONE void addToRange(Range& range, const float* numbers, std::size_t count)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t from = 0; from + rangeSize <= count; from += rangeSize)
        for (std::size_t i = 0; i < rangeSize; ++i) {
            const float p = numbers[from + i], low = range.low[i], high = range.high[i];
            range.low[i] = p < low && p > -infinity ? p : low; // NaN is neither
            range.high[i] = p > high && p < infinity ? p : high;
        }
}

/// The box of the finite positions.
Box boxOf(std::span<const glm::vec3> positions)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high = -low;
    Range range;
    range.low.fill(low.x);
    range.high.fill(high.x);
    const std::size_t together = rangeSize / 3, whole = positions.size() / together * together;
    if (whole > 0)
        addToRange(range, &positions.front().x, 3 * whole);
    const auto add = [&](int axis, float from, float to) {
        low[axis] = std::min(low[axis], from);
        high[axis] = std::max(high[axis], to);
    };
    for (std::size_t i = 0; i < rangeSize; ++i)
        add(static_cast<int>(i % 3), range.low[i], range.high[i]);
    for (std::size_t i = whole; i < positions.size(); ++i)
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
RAMURE_WIDEST_CLONE bool solve(Block& b, const glm::dvec3& centre, double smallestSquared)
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

void storeLanes(Block& b, std::size_t row, std::size_t i, Float4* four)
{
    transpose(four[0], four[1], four[2], four[3]);
    for (std::size_t axis = 0; axis < 3; ++axis)
        storeFloat4(&b.in[row + axis][i], four[axis]);
}

/// Faces from \p from on, and calls \p also(i) for i below \p alsoCount on the way: sums in a fixed order
/// wait for each addition, and there is time for them here.
/// \tparam toLast the last vertex may be among their corners: nothing behind it can be read
template <bool toLast, class Also>
void load(Block& b, const TriangleMesh& mesh, std::size_t from, std::size_t count, std::size_t alsoCount,
          Also&& also)
{
    const glm::uvec3* const triangles = &mesh.triangles[from];
    const glm::vec3* const positions = mesh.positions.data();
    const auto last = static_cast<Index>(mesh.positions.size() - 1);
    const auto at = [positions, last](Index v) {
        return !toLast || v != last ? loadFloat4(&positions[v].x) : loadFloat3(&positions[v].x);
    };
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        Float4 corners[3][4];
        for (std::size_t k = 0; k < 4; ++k)
            for (int corner = 0; corner < 3; ++corner)
                corners[corner][k] = at(triangles[i + k][corner]);
        for (std::size_t corner = 0; corner < 3; ++corner)
            storeLanes(b, 3 * corner, i, corners[corner]);
        if (i + 4 <= alsoCount)
            for (std::size_t k = 0; k < 4; ++k)
                also(i + k);
    }
    for (std::size_t k = i; k < count; ++k)
        for (std::size_t row = 0; row < 9; ++row)
            b.in[row][k] = positions[triangles[k][int(row / 3)]][int(row % 3)];
    for (; i < alsoCount; ++i)
        also(i);
}

/// Calls \p add(block, i, face) for all faces in order and \p check(block, first, count, smallestSquared) for
/// blocks of them, in which there may be degenerate ones; until cancelled, or a vertex does not exist.
template <class Add, class Check>
void forMeasured(const TriangleMesh& mesh, const Progress& progress, Add&& add, Check&& check)
{
    const Box box = boxOf(mesh.positions);
    // Doubled areas are compared squared: |cross|² <= (2 * area)².
    const double smallest = 2.0 * smallestAreaRatio * box.squaredDiagonal;
    Block blocks[2] = {};
    std::size_t countBefore = 0;
    for (std::size_t from = 0; from < mesh.triangles.size(); from += blockSize) {
        if (from % (blockSize << 10) == 0 && progress.cancelled())
            return;
        const std::size_t count = std::min(blockSize, mesh.triangles.size() - from);
        const std::size_t behind = std::size_t(largestIndex({&mesh.triangles[from], count})) + 1;
        if (behind > mesh.positions.size())
            return;
        Block &block = blocks[from / blockSize % 2], &before = blocks[1 - from / blockSize % 2];
        const auto addBefore = [&](std::size_t i) { add(before, i, from - blockSize + i); };
        if (behind < mesh.positions.size()) [[likely]]
            load<false>(block, mesh, from, count, countBefore, addBefore);
        else
            load<true>(block, mesh, from, count, countBefore, addBefore);
        if (solve(block, box.centre, smallest * smallest))
            check(block, from, count, smallest * smallest);
        countBefore = count;
    }
    const std::size_t lastBlock = mesh.triangles.size() - countBefore;
    for (std::size_t i = 0; i < countBefore; ++i)
        add(blocks[lastBlock / blockSize % 2], i, lastBlock + i);
}

} // namespace

// Volumes are sums over tetrahedra whose tip is the box's centre: near the mesh, so that little is lost to
// cancellation.
Volumes measureFaces(const TriangleMesh& mesh, DefectLog& log, const Progress& progress)
{
    double volume = 0.0;
    const auto add = [&](const Block& block, std::size_t i, std::size_t) { volume += block.sixfold[i]; };
    forMeasured(mesh, progress, add,
                [&](const Block& block, std::size_t first, std::size_t count, double smallestSquared) {
                    for (std::size_t i = 0; i < count; ++i)
                        if (!(block.squared[i] > smallestSquared))
                            log.add(DefectKind::DegenerateFace, static_cast<Index>(first + i));
                });
    return {volume / 6.0, volume / 6.0 > 0.0};
}

Volumes measureComponents(const TriangleMesh& mesh, const Components& components)
{
    std::vector<double> volume(components.count, 0.0);
    const auto add = [&](const Block& block, std::size_t i, std::size_t face) {
        if (const Index component = components.of[mesh.triangles[face].x]; component != noIndex)
            volume[component] += block.sixfold[i];
    };
    forMeasured(mesh, {}, add, [](const Block&, std::size_t, std::size_t, double) {});
    Volumes result;
    for (const double v : volume) {
        result.sum += v / 6.0;
        result.allPositive = result.allPositive && v > 0.0;
    }
    return result;
}

} // namespace ramure::validation
