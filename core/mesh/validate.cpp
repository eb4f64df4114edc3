#include "core/mesh/validate.h"
#include "core/base/float4.h"
#include "core/mesh/validate_parts.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {

namespace {

using validation::Components;
using validation::Corners;
using validation::DefectLog;

/// A face is degenerate when its area is not above this share of the squared diagonal of the mesh's box.
constexpr double smallestAreaRatio = 1e-14;
/// Three corners per face are counted in 32 bits.
constexpr std::size_t maxFaces = std::numeric_limits<Index>::max() / 3;

struct Box
{
    glm::dvec3 centre{0.0};
    double squaredDiagonal = 0.0;
};

/// The box of the finite positions. Four numbers at a time: the fourth is the next position's first, and
/// ignored.
Box boxOf(std::span<const glm::vec3> positions)
{
    constexpr float far = std::numeric_limits<float>::max();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Float4 low = Float4{} + far;
    Float4 high = Float4{} - far;
    const auto add = [&](Float4 p) {
        const auto isFinite = (p < infinity) & (p > -infinity); // NaN is neither
        low = (p < low) & isFinite ? p : low;
        high = (p > high) & isFinite ? p : high;
    };
    if (positions.empty())
        return {};
    for (std::size_t i = 0; i + 1 < positions.size(); ++i)
        add(loadFloat4(&positions[i].x));
    const glm::vec3& last = positions.back();
    add(Float4{last.x, last.y, last.z, 0.0f});
    if (low[0] > high[0] || low[1] > high[1] || low[2] > high[2])
        return {};
    const glm::dvec3 from(low[0], low[1], low[2]);
    const glm::dvec3 to(high[0], high[1], high[2]);
    return {(from + to) * 0.5, glm::dot(to - from, to - from)};
}

struct Volumes
{
    double sum = 0.0;
    bool allPositive = true;
};

/// Areas, and the signed volume of every component from tetrahedra whose tip is the box's centre: near the
/// mesh, so that little is lost to cancellation.
Volumes measureFaces(const TriangleMesh& mesh, const Components& components, DefectLog& log)
{
    const Box box = boxOf(mesh.positions);
    // Doubled areas are compared squared: |cross|² <= (2 * area)².
    const double smallest = 2.0 * smallestAreaRatio * box.squaredDiagonal;
    const double smallestSquared = smallest * smallest;
    std::vector<double> volume(std::max<std::size_t>(components.count, 1), 0.0);
    const bool isOne = components.count <= 1;
    double onlyVolume = 0.0;
    for (Index face = 0; face < mesh.faceCount(); ++face) {
        const glm::uvec3& t = mesh.triangles[face];
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
        if (!(glm::dot(normal, normal) > smallestSquared)) // so written that NaN is degenerate too
            log.add(DefectKind::DegenerateFace, face);
        const double sixfold = glm::dot(a - box.centre, normal);
        if (isOne)
            onlyVolume += sixfold;
        else if (const Index component = components.of[t.x]; component != noIndex)
            volume[component] += sixfold;
    }
    if (isOne)
        volume[0] = onlyVolume;
    Volumes result;
    for (const double v : volume) {
        result.sum += v / 6.0;
        result.allPositive = result.allPositive && v > 0.0;
    }
    return result;
}

void findIsolatedVertices(const TriangleMesh& mesh, const Corners& corners, DefectLog& log)
{
    // Vertices that are only in faces with a repeated vertex have no corners, but are in a face.
    std::vector<bool> inLeftOut;
    if (corners.faces != mesh.faceCount()) {
        inLeftOut.resize(mesh.positions.size());
        for (const glm::uvec3& t : mesh.triangles)
            if (validation::hasRepeatedVertex(t))
                inLeftOut[t.x] = inLeftOut[t.y] = inLeftOut[t.z] = true;
    }
    for (Index v = 0; v < mesh.vertexCount(); ++v)
        if (corners.degree[v] == 0 && (inLeftOut.empty() || !inLeftOut[v]))
            log.add(DefectKind::IsolatedVertex, v);
}

std::int64_t verticesWithCorners(const TriangleMesh& mesh, const Corners& corners)
{
    std::int64_t used = 0;
    for (Index v = 0; v < mesh.vertexCount(); ++v)
        used += corners.degree[v] != 0;
    return used;
}

void fillCounts(MeshReport& report, const DefectLog& log)
{
    report.boundaryEdges = log.count(DefectKind::BoundaryEdge);
    report.nonManifoldEdges = log.count(DefectKind::NonManifoldEdge);
    report.nonManifoldVertices = log.count(DefectKind::NonManifoldVertex);
    report.inconsistentEdges = log.count(DefectKind::InconsistentEdge);
    report.duplicateVertices = log.count(DefectKind::DuplicateVertex);
    report.duplicateFaces = log.count(DefectKind::DuplicateFace);
    report.degenerateFaces = log.count(DefectKind::DegenerateFace);
    report.isolatedVertices = log.count(DefectKind::IsolatedVertex);
    report.defects = log.all();
}

} // namespace

Expected<void> validation::checkIndices(const TriangleMesh& mesh)
{
    if (mesh.triangles.size() > maxFaces || mesh.positions.size() >= noIndex)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the mesh has too many faces to be checked"));
    Index largest = 0;
    for (const glm::uvec3& t : mesh.triangles)
        largest = std::max(largest, std::max(t.x, std::max(t.y, t.z)));
    if (mesh.triangles.empty() || largest < mesh.positions.size())
        return {};
    const auto bad = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
        return std::max(t.x, std::max(t.y, t.z)) >= mesh.positions.size();
    });
    return fail(ErrorCode::Invalid,
                RAMURE_NOOP("face %1 refers to a vertex that does not exist (%2 vertices)"),
                {std::to_string(bad - mesh.triangles.begin()), std::to_string(mesh.positions.size())});
}

std::vector<Defect> validation::DefectLog::all() const
{
    std::vector<Defect> out;
    for (const Kind& kind : m_kinds)
        out.insert(out.end(), kind.listed.begin(), kind.listed.end());
    return out;
}

Index MeshReport::count(DefectKind kind) const
{
    switch (kind) {
    case DefectKind::BoundaryEdge:
        return boundaryEdges;
    case DefectKind::NonManifoldEdge:
        return nonManifoldEdges;
    case DefectKind::NonManifoldVertex:
        return nonManifoldVertices;
    case DefectKind::InconsistentEdge:
        return inconsistentEdges;
    case DefectKind::DuplicateVertex:
        return duplicateVertices;
    case DefectKind::DuplicateFace:
        return duplicateFaces;
    case DefectKind::DegenerateFace:
        return degenerateFaces;
    case DefectKind::IsolatedVertex:
        return isolatedVertices;
    }
    return 0;
}

Expected<MeshReport> validateMesh(const TriangleMesh& mesh, const Progress& progress)
{
    if (const auto indices = validation::checkIndices(mesh); !indices)
        return fail(indices.error());
    const auto corners = validation::collectCorners(mesh, progress.part(0.0, 0.3));
    if (!corners)
        return fail(corners.error());
    DefectLog log;
    const auto fans = validation::checkFans(mesh, *corners, log, progress.part(0.3, 0.7));
    if (!fans)
        return fail(fans.error());
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    const Volumes volumes = measureFaces(mesh, fans->components, log);
    progress.report(0.9);
    validation::findDuplicateVertices(mesh.positions, log);
    findIsolatedVertices(mesh, *corners, log);

    MeshReport report;
    report.vertices = mesh.vertexCount();
    report.faces = mesh.faceCount();
    fillCounts(report, log);
    report.components = fans->components.count;
    report.eulerCharacteristic =
        verticesWithCorners(mesh, *corners) - fans->edges + std::int64_t(corners->faces);
    report.volume = volumes.sum;
    report.valid = report.defects.empty() && report.faces > 0 && volumes.allPositive;
    progress.report(1.0);
    return report;
}

} // namespace ramure
