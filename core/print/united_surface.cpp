#include "core/print/united_surface.h"

#include "core/base/parallel.h"
#include "core/surface/proof/validate.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>

namespace ramure {
namespace {

using openvdb::FloatGrid;

constexpr float band = 3.0F; ///< voxels that have a distance, on either side of the surface
constexpr int mostRepairs = 12;
constexpr double mostSide = 16'000.0;

/// The way of OpenVDB to be stopped.
struct Interrupter
{
    const Progress& progress;

    void start(const char* = nullptr) {}
    void end() {}
    bool wasInterrupted(int percent = -1)
    {
        if (percent >= 0)
            progress.report(0.01 * percent);
        return progress.cancelled();
    }
};

/// A mesh as OpenVDB wants to see it. The grid stands half a voxel off, so that the ground lies between two
/// of its layers: distances to it are never 0.
struct GridMesh
{
    const TriangleMesh& mesh;
    double voxel;

    [[nodiscard]] std::size_t polygonCount() const { return mesh.triangles.size(); }
    [[nodiscard]] std::size_t pointCount() const { return mesh.positions.size(); }
    [[nodiscard]] std::size_t vertexCount(std::size_t) const { return 3; }
    void getIndexSpacePoint(std::size_t polygon, std::size_t corner, openvdb::Vec3d& out) const
    {
        const glm::vec3& p = mesh.positions[mesh.triangles[polygon][static_cast<int>(corner)]];
        out = {p.x / voxel + 0.5, p.y / voxel + 0.5, p.z / voxel + 0.5};
    }
};

TriangleMesh boxMesh(const glm::vec3& low, const glm::vec3& high)
{
    TriangleMesh box;
    for (int i = 0; i < 8; ++i)
        box.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return box;
}

FloatGrid::Ptr levelSetOf(const TriangleMesh& mesh, double voxel, const Progress& progress)
{
    Interrupter interrupter{progress};
    const GridMesh adapter{mesh, voxel};
    return openvdb::tools::meshToVolume<FloatGrid>(
        interrupter, adapter, *openvdb::math::Transform::createLinearTransform(1.0), band, band);
}

/// Shells around open surfaces, half their thickness on either side: rounded at the rims.
FloatGrid::Ptr shellsOf(const TriangleMesh& sheets, double voxel, double thickness, const Progress& progress)
{
    Interrupter interrupter{progress};
    const GridMesh adapter{sheets, voxel};
    const auto half = static_cast<float>(0.5 * thickness / voxel);
    const FloatGrid::Ptr shells = openvdb::tools::meshToVolume<FloatGrid>(
        interrupter, adapter, *openvdb::math::Transform::createLinearTransform(1.0), half + band, 0.0F,
        openvdb::tools::UNSIGNED_DISTANCE_FIELD);
    for (auto leaf = shells->tree().beginLeaf(); leaf; ++leaf)
        for (auto value = leaf->beginValueAll(); value; ++value)
            value.setValue(std::min(value.getValue() - half, band));
    openvdb::tools::changeBackground(shells->tree(), band);
    return shells;
}

/// The part of a grid around a ball, at every so many voxels.
struct NotchPart
{
    openvdb::Coord low;
    int stride = 1;
    DistanceBox box;
    NotchBall ball; ///< in steps

    NotchPart(const FloatGrid& grid, const NotchBall& notch, double voxel)
    {
        constexpr double finest = 4.0; // steps in the radius of a large ball
        constexpr int coarsest = 3;    // else no step lies in the band of the surface
        stride = std::clamp(static_cast<int>(notch.radius / voxel / finest), 1, coarsest);
        const double step = stride * voxel;
        const openvdb::Vec3d middle(notch.centre.x / voxel + 0.5, notch.centre.y / voxel + 0.5,
                                    notch.centre.z / voxel + 0.5);
        const int half = static_cast<int>(std::ceil((notch.outer + notch.radius) / step)) + 3;
        low = openvdb::Coord::round(middle).offsetBy(-half * stride);
        box.size = glm::ivec3(2 * half + 1);
        box.band = band / float(stride);
        const openvdb::Vec3d centre = (middle - low.asVec3d()) / stride;
        ball = {{centre.x(), centre.y(), centre.z()},
                notch.radius / step,
                notch.inner / step,
                notch.outer / step};
        auto values = grid.getConstAccessor();
        box.values.reserve(std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z));
        for (int z = 0; z < box.size.z; ++z)
            for (int y = 0; y < box.size.y; ++y)
                for (int x = 0; x < box.size.x; ++x)
                    box.values.push_back(values.getValue(low.offsetBy(stride * x, stride * y, stride * z)) /
                                         float(stride));
    }
};

using Change = std::pair<openvdb::Coord, float>;

/// Between the steps, values are those of the cell's corners, mixed.
float mixedAt(const DistanceBox& box, const std::vector<float>& values, const glm::ivec3& at, int stride)
{
    const glm::ivec3 cell = glm::min(at / stride, box.size - 2);
    const glm::vec3 share = glm::vec3(at - stride * cell) / float(stride);
    float value = 0.0F;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
        const glm::vec3 part = glm::mix(1.0F - share, share, glm::vec3(corner));
        value += part.x * part.y * part.z *
                 values[box.index(cell.x + corner.x, cell.y + corner.y, cell.z + corner.z)];
    }
    return value * float(stride);
}

std::vector<Change> changesOf(const FloatGrid& grid, const NotchBall& notch, double voxel)
{
    const NotchPart part(grid, notch, voxel);
    const std::vector<float> filled = withFilledNotch(part.box, part.ball);
    std::vector<Change> changes;
    auto values = grid.getConstAccessor();
    const glm::ivec3 last = part.stride * (part.box.size - 1);
    glm::ivec3 at;
    for (at.z = 0; at.z <= last.z; ++at.z)
        for (at.y = 0; at.y <= last.y; ++at.y)
            for (at.x = 0; at.x <= last.x; ++at.x) {
                const openvdb::Coord where = part.low.offsetBy(at.x, at.y, at.z);
                const float value = mixedAt(part.box, filled, at, part.stride),
                            before = values.getValue(where);
                if (before > 0.0F && value < before - 1e-3F)
                    changes.emplace_back(where, std::max(value, -band));
            }
    return changes;
}

/// All notches as they are before any is filled, so that their order does not matter.
void fillNotches(FloatGrid& grid, const std::vector<NotchBall>& notches, double voxel,
                 const Progress& progress)
{
    std::vector<std::vector<Change>> changes(notches.size());
    constexpr std::size_t grain = 4;
    parallelFor(notches.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !progress.cancelled(); ++i)
            changes[i] = changesOf(grid, notches[i], voxel);
    });
    auto values = grid.getAccessor();
    for (const std::vector<Change>& of : changes)
        for (const auto& [at, value] : of)
            if (value < values.getValue(at))
                values.setValue(at, value);
}

/// What lies below the ground is covered by a box that is taken off.
void cutGround(FloatGrid& grid, double voxel, const Progress& progress)
{
    constexpr int margin = 8; // voxels
    openvdb::CoordBBox deep;
    for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
        if (leaf->origin().y() <= margin)
            deep.expand(leaf->getNodeBoundingBox());
    if (deep.empty())
        return;
    deep.expand(margin);
    const auto corner = [voxel](const openvdb::Coord& at) {
        return glm::vec3(glm::dvec3(at.x(), at.y(), at.z()) * voxel);
    };
    const glm::vec3 low = corner(deep.min()), high = corner(deep.max());
    const FloatGrid::Ptr box = levelSetOf(boxMesh(low, {high.x, 0.0F, high.z}), voxel, progress);
    openvdb::tools::csgDifference(grid, *box);
}

TriangleMesh meshOf(const FloatGrid& grid)
{
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(grid, points, triangles, quads, 0.0, 0.0);
    TriangleMesh mesh;
    mesh.positions.reserve(points.size());
    for (const openvdb::Vec3s& p : points)
        mesh.positions.emplace_back(p.x(), p.y(), p.z());
    mesh.triangles.reserve(triangles.size() + 2 * quads.size());
    // OpenVDB counts corners clockwise.
    for (const openvdb::Vec3I& t : triangles)
        mesh.triangles.emplace_back(t[2], t[1], t[0]);
    const auto gap = [&mesh](Index a, Index b) {
        const glm::vec3 way = mesh.positions[a] - mesh.positions[b];
        return glm::dot(way, way);
    };
    for (const openvdb::Vec4I& q : quads) {
        const bool first = gap(q[0], q[2]) <= gap(q[1], q[3]);
        mesh.triangles.emplace_back(q[2], q[1], q[0]);
        mesh.triangles.emplace_back(q[3], q[2], q[0]);
        if (!first) {
            mesh.triangles[mesh.triangles.size() - 2] = {q[3], q[1], q[0]};
            mesh.triangles.back() = {q[3], q[2], q[1]};
        }
    }
    return mesh;
}

/// Where more than two faces meet in an edge, or two surfaces in a vertex, the cell around it is filled.
bool fillKnots(FloatGrid& grid, const TriangleMesh& mesh, const MeshReport& report)
{
    bool any = false;
    auto values = grid.getAccessor();
    const auto fill = [&](const glm::vec3& p) {
        const openvdb::Coord from = openvdb::Coord::floor(openvdb::Vec3s(p.x, p.y, p.z));
        for (int i = 0; i < 8; ++i) {
            const openvdb::Coord at = from.offsetBy(i & 1, (i >> 1) & 1, i >> 2);
            constexpr float inside = -0.4F;
            if (values.getValue(at) > inside) {
                values.setValue(at, inside);
                any = true;
            }
        }
    };
    for (const Defect& defect : report.defects)
        if (defect.kind == DefectKind::NonManifoldEdge)
            fill(0.5F * (mesh.positions[defect.a] + mesh.positions[defect.b]));
        else if (defect.kind == DefectKind::NonManifoldVertex)
            fill(mesh.positions[defect.a]);
    return any;
}

/// A surface that runs through a point of the grid has faces without area about it.
void keepOffPoints(FloatGrid& grid)
{
    constexpr float least = 0.03F;
    for (auto leaf = grid.tree().beginLeaf(); leaf; ++leaf)
        for (auto value = leaf->beginValueOn(); value; ++value)
            if (std::abs(*value) < least)
                value.setValue(std::copysign(least, *value));
}

Expected<TriangleMesh> manifoldMesh(FloatGrid& grid, const Progress& progress)
{
    keepOffPoints(grid);
    for (int round = 0; round < mostRepairs; ++round) {
        TriangleMesh mesh = meshOf(grid);
        if (mesh.empty())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing is left to print"));
        const auto report = validateMesh(mesh, Progress{progress.stop, {}});
        RAMURE_TRY(report);
        progress.report(double(round + 1) / mostRepairs);
        const bool isClosed = report->boundaryEdges == 0 && report->inconsistentEdges == 0;
        if (isClosed && report->nonManifoldEdges == 0 && report->nonManifoldVertices == 0)
            return mesh;
        if (!fillKnots(grid, mesh, *report))
            break;
    }
    return fail(ErrorCode::Invalid,
                RAMURE_NOOP("the branches could not be united into one surface: try another height"));
}

/// Six times the signed volume of what hangs together, by its first vertex.
std::vector<Index> piecesOf(const TriangleMesh& mesh)
{
    std::vector<Index> first(mesh.positions.size());
    std::iota(first.begin(), first.end(), Index(0));
    const auto find = [&first](Index v) {
        while (first[v] != v)
            v = first[v] = first[first[v]];
        return v;
    };
    for (const glm::uvec3& t : mesh.triangles)
        for (const Index other : {t.y, t.z}) {
            const Index a = find(t.x), b = find(other);
            first[std::max(a, b)] = std::min(a, b);
        }
    for (Index v = 0; v < first.size(); ++v)
        first[v] = find(v);
    return first;
}

/// The largest piece; hollows in it, which are pieces that look inward, are left out and so filled.
UnitedSurface largestPiece(const TriangleMesh& mesh)
{
    const std::vector<Index> pieces = piecesOf(mesh);
    std::vector<double> volume(mesh.positions.size(), 0.0);
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        volume[pieces[t.x]] += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    const auto best = static_cast<Index>(std::max_element(volume.begin(), volume.end()) - volume.begin());
    UnitedSurface out;
    std::vector<Index> numberOf(mesh.positions.size(), noIndex);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        if (pieces[v] == best) {
            numberOf[v] = out.mesh.vertexCount();
            out.mesh.positions.push_back(mesh.positions[v]);
        } else if (pieces[v] == v && volume[v] > 0.0) {
            ++out.loose;
            out.looseVolume += volume[v];
        } else if (pieces[v] == v && volume[v] < 0.0) {
            ++out.cavities;
        }
    }
    for (const glm::uvec3& t : mesh.triangles)
        if (pieces[t.x] == best)
            out.mesh.triangles.emplace_back(numberOf[t.x], numberOf[t.y], numberOf[t.z]);
    return out;
}

/// Out of the grid; the cut lies in the ground exactly.
void intoMetres(UnitedSurface& surface, double voxel, bool cutsGround)
{
    constexpr double nearGround = 0.02; // voxels
    for (glm::vec3& p : surface.mesh.positions) {
        const glm::dvec3 at = glm::dvec3(p) - 0.5;
        p = glm::vec3(at * voxel);
        if (cutsGround && std::abs(at.y) < nearGround)
            p.y = 0.0F;
    }
    surface.looseVolume *= voxel * voxel * voxel;
}

Expected<void> checkSize(const TriangleMesh& mesh, double voxel)
{
    glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (mesh.empty() || !(voxel > 0.0) || !std::isfinite(voxel))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing is left to print"));
    const glm::vec3 size = high - low;
    if (!(std::max({size.x, size.y, size.z}) / voxel < mostSide))
        return fail(ErrorCode::Limit,
                    RAMURE_NOOP("so large a print needs too fine a grid: lower it, or allow thicker twigs"));
    return {};
}

} // namespace

Expected<UnitedSurface> unitedSurface(const TriangleMesh& closed, const UnionOptions& options,
                                      const Progress& progress)
{
    RAMURE_TRY(checkSize(closed, options.voxel));
    const auto cancelled = [] { return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")); };
    openvdb::initialize();
    const FloatGrid::Ptr grid = levelSetOf(closed, options.voxel, progress.part(0.0, 0.25));
    if (progress.cancelled())
        return cancelled();
    fillNotches(*grid, options.notches, options.voxel, Progress{progress.stop, {}});
    progress.report(0.4);
    if (!options.sheets.empty() && !progress.cancelled()) {
        const FloatGrid::Ptr shells =
            shellsOf(options.sheets, options.voxel, options.thickness, progress.part(0.4, 0.5));
        if (!progress.cancelled())
            openvdb::tools::csgUnion(*grid, *shells);
    }
    if (progress.cancelled())
        return cancelled();
    if (options.cutsGround)
        cutGround(*grid, options.voxel, Progress{progress.stop, {}});
    if (progress.cancelled())
        return cancelled();
    const auto mesh = manifoldMesh(*grid, progress.part(0.5, 0.95));
    RAMURE_TRY(mesh);
    UnitedSurface out = largestPiece(*mesh);
    intoMetres(out, options.voxel, options.cutsGround);
    progress.report(1.0);
    return out;
}

} // namespace ramure
