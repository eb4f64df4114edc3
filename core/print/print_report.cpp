#include "core/print/print_report.h"

#include "core/base/parallel.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesh/mesh_rays.h"
#include "core/surface/proof/validate.h"
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace ramure {
namespace {

constexpr double steep = std::numbers::sqrt2 / 2.0; ///< sine of 45°
/// A wall is one that looks back: else the ray leaves through the edge of a step.
constexpr double looksBack = 0.5;
constexpr std::size_t grain = 2048; ///< rays

struct Face
{
    glm::dvec3 a, b, c;

    Face(const TriangleMesh& mesh, Index face)
        : a(mesh.positions[mesh.triangles[face].x])
        , b(mesh.positions[mesh.triangles[face].y])
        , c(mesh.positions[mesh.triangles[face].z])
    {
    }
    [[nodiscard]] glm::dvec3 middle() const { return (a + b + c) / 3.0; }
    [[nodiscard]] glm::dvec3 twiceArea() const { return glm::cross(b - a, c - a); }
    [[nodiscard]] double volume() const { return glm::dot(a, glm::cross(b, c)) / 6.0; }
    [[nodiscard]] bool isOverhang() const
    {
        const glm::dvec3 normal = twiceArea();
        return -normal.y > steep * glm::length(normal) && !(a.y == 0.0 && b.y == 0.0 && c.y == 0.0);
    }
};

void addSums(PrintReport& report, const TriangleMesh& mesh)
{
    report.low = glm::dvec3(std::numeric_limits<double>::infinity());
    report.high = -report.low;
    glm::dvec3 moment(0.0);
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        const Face face(mesh, i);
        report.low = glm::min(report.low, glm::min(face.a, glm::min(face.b, face.c)));
        report.high = glm::max(report.high, glm::max(face.a, glm::max(face.b, face.c)));
        report.volume += face.volume();
        moment += face.volume() * 0.75 * face.middle();
        if (face.isOverhang())
            report.overhang += 0.5 * glm::length(face.twiceArea());
    }
    if (report.volume != 0.0)
        report.centreOfMass = moment / report.volume;
}

void addBalance(PrintReport& report, const TriangleMesh& mesh)
{
    std::vector<glm::dvec2> ground;
    for (const glm::vec3& p : mesh.positions)
        if (p.y == 0.0F)
            ground.emplace_back(p.x, p.z);
    const std::vector<glm::dvec2> hull = convexHull(std::move(ground));
    report.balance = -std::numeric_limits<double>::infinity();
    if (hull.size() < 3)
        return;
    const glm::dvec2 centre(report.centreOfMass.x, report.centreOfMass.z);
    report.balance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 from = hull[i], way = hull[(i + 1) % hull.size()] - from, to = centre - from;
        report.footArea += 0.5 * (from.x * (from + way).y - from.y * (from + way).x);
        report.balance = std::min(report.balance, (way.x * to.y - way.y * to.x) / glm::length(way));
    }
}

/// The way through the material below a face.
struct Wall
{
    double thickness = 0.0;
    glm::dvec3 middle{0.0};
};

/// How thick the material is below the middle of a face.
std::optional<Wall> wallBelow(const TriangleMesh& mesh, const MeshRays& rays, Index number, double speck)
{
    const Face face(mesh, number);
    const glm::dvec3 normal = face.twiceArea();
    const double length = glm::length(normal);
    if (!(length > 0.0))
        return std::nullopt;
    const glm::dvec3 inward = -normal / length;
    const auto hit = rays.nearest({face.middle() + speck * inward, inward});
    if (!hit || hit->triangle == number)
        return std::nullopt;
    const glm::dvec3 other = Face(mesh, hit->triangle).twiceArea();
    if (glm::dot(other, inward) < looksBack * glm::length(other))
        return std::nullopt;
    return Wall{hit->t + speck, face.middle() + 0.5 * (hit->t + speck) * inward};
}

using Cell = std::array<int, 3>;
using Walls = std::map<Cell, Wall>; ///< the thickest of each cell of space

Walls wallsOf(const TriangleMesh& mesh, const std::vector<std::optional<Wall>>& below, double side)
{
    Walls walls;
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        if (!below[i])
            continue;
        const glm::dvec3 at = glm::floor(Face(mesh, i).middle() / side);
        Wall& most = walls[{int(at.x), int(at.y), int(at.z)}];
        if (below[i]->thickness > most.thickness)
            most = *below[i];
    }
    return walls;
}

/// The thickest of a cell and those around it.
Wall thickestAround(const Walls& walls, const Cell& cell)
{
    Wall most;
    for (int i = 0; i < 27; ++i) {
        const auto near = walls.find({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
        if (near != walls.end() && near->second.thickness > most.thickness)
            most = near->second;
    }
    return most;
}

Expected<Walls> findWalls(const std::shared_ptr<const TriangleMesh>& mesh, double around, double speck,
                          const Progress& progress)
{
    const MeshRays rays(mesh, progress.stop);
    std::vector<std::optional<Wall>> below(mesh->triangles.size());
    parallelFor(below.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !progress.cancelled(); ++i)
            below[i] = wallBelow(*mesh, rays, static_cast<Index>(i), speck);
    });
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return wallsOf(*mesh, below, around);
}

Expected<void> addThinnest(PrintReport& report, const std::shared_ptr<const TriangleMesh>& mesh,
                           double around, const Progress& progress)
{
    const double length = glm::length(report.size());
    const auto walls = findWalls(mesh, std::max(around, 1e-4 * length), 1e-6 * length, progress);
    RAMURE_TRY(walls);
    for (const auto& [cell, wall] : *walls) {
        const Wall most = thickestAround(*walls, cell);
        if (report.thinnest == 0.0 || most.thickness < report.thinnest) {
            report.thinnest = most.thickness;
            report.thinnestAt = most.middle;
        }
    }
    return {};
}

} // namespace

bool isOverhang(const TriangleMesh& mesh, Index face)
{
    return Face(mesh, face).isOverhang();
}

std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points)
{
    const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<glm::dvec2> hull;
    const auto addAll = [&hull](auto begin, auto end) { // Andrew 1979
        const std::size_t least = hull.size() + 1;
        for (auto at = begin; at != end; ++at) {
            while (hull.size() > least) {
                const glm::dvec2 &a = hull[hull.size() - 2], &b = hull.back();
                if ((b.x - a.x) * (at->y - a.y) - (b.y - a.y) * (at->x - a.x) > 0.0)
                    break;
                hull.pop_back();
            }
            hull.push_back(*at);
        }
        hull.pop_back();
    };
    addAll(points.begin(), points.end());
    addAll(points.rbegin(), points.rend());
    return hull;
}

Expected<std::vector<glm::dvec3>> thinPlaces(const std::shared_ptr<const TriangleMesh>& mesh, double below,
                                             double around, const Progress& progress)
{
    const auto walls = findWalls(mesh, around, 1e-4 * around, progress);
    RAMURE_TRY(walls);
    std::vector<glm::dvec3> places;
    for (const auto& [cell, wall] : *walls)
        if (wall.thickness < below)
            places.push_back(wall.middle);
    return places;
}

Expected<PrintReport> printReport(const std::shared_ptr<const TriangleMesh>& mesh, double around,
                                  const Progress& progress)
{
    PrintReport report;
    const auto checked = validateMesh(*mesh, progress.part(0.0, 0.1));
    RAMURE_TRY(checked);
    report.isClosed = checked->valid;
    report.pieces = checked->components;
    report.triangles = checked->faces;
    if (mesh->empty())
        return report;
    addSums(report, *mesh);
    addBalance(report, *mesh);
    const auto crossings = findSelfIntersections(*mesh, {}, 0, progress.part(0.1, 0.5));
    RAMURE_TRY(crossings);
    report.crossings = crossings->total();
    progress.report(0.5);
    RAMURE_TRY(addThinnest(report, mesh, around, progress));
    progress.report(1.0);
    return report;
}

} // namespace ramure
