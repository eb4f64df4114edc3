#include "core/surface/proof/validate.h"
#include "core/base/parallel.h"
#include "core/surface/mesh/largest_index.h"
#include "core/surface/proof/validate_parts.h"
#include <algorithm>
#include <functional>
#include <limits>

namespace ramure {

namespace {

using validation::Corners;
using validation::DefectLog;
using validation::Volumes;

/// Three corners per face are counted in 32 bits.
constexpr std::size_t maxFaces = std::numeric_limits<Index>::max() / 3;

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
        if (corners.degree(v) == 0 && (inLeftOut.empty() || !inLeftOut[v]))
            log.add(DefectKind::IsolatedVertex, v);
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

Expected<void> validation::checkSize(const TriangleMesh& mesh)
{
    if (mesh.triangles.size() > maxFaces || mesh.positions.size() >= noIndex)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the mesh has too many faces to be checked"));
    return {};
}

Expected<void> validation::checkIndices(const TriangleMesh& mesh)
{
    if (auto size = checkSize(mesh); !size)
        return size;
    if (mesh.triangles.empty() || largestIndex(mesh.triangles) < mesh.positions.size())
        return {};
    const auto bad = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
        return std::max(t.x, std::max(t.y, t.z)) >= mesh.positions.size();
    });
    return fail(ErrorCode::Invalid,
                RAMURE_NOOP("face %1 refers to a vertex that does not exist (%2 vertices)"),
                {std::to_string(bad - mesh.triangles.begin()), std::to_string(mesh.positions.size())});
}

void validation::DefectLog::take(const DefectLog& other)
{
    for (std::size_t i = 0; i < m_kinds.size(); ++i)
        if (m_kinds[i].count == 0)
            m_kinds[i] = other.m_kinds[i];
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

Expected<MeshReport> validateMesh(const TriangleMesh& mesh, const Progress& progress,
                                  const std::function<void()>& alongside)
{
    RAMURE_TRY(validation::checkSize(mesh));
    // Things that know nothing of each other. A second thread takes what the first has not begun; the longest
    // comes first.
    Expected<Corners> corners = Corners();
    Expected<validation::FanResult> fans = validation::FanResult();
    DefectLog fanLog, faceLog, vertexLog;
    Volumes volumes;
    const std::array<std::function<void()>, 4> tasks = {
        [&] {
            corners = validation::collectCorners(mesh, progress.part(0.0, 0.5));
            if (corners)
                fans = validation::checkFans(mesh, *corners, fanLog, progress.part(0.5, 0.7));
        },
        [&] {
            if (alongside)
                alongside();
        },
        [&] {
            volumes = validation::measureFaces(mesh, faceLog, {progress.stop, {}});
        },
        [&] { validation::findDuplicateVertices(mesh.positions, vertexLog); },
    };
    // Waking a thread costs as much as checking a few thousand faces.
    const ThreadLimit limit(mesh.triangles.size() < 10'000 ? 1 : parallelThreads());
    parallelFor(tasks.size(), 1, [&](std::size_t begin, std::size_t) { tasks[begin](); });
    RAMURE_TRY(corners);
    RAMURE_TRY(fans);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    if (fans->components.count > 1)
        volumes = validation::measureComponents(mesh, fans->components);
    if (fans->vertices != mesh.vertexCount())
        findIsolatedVertices(mesh, *corners, vertexLog);

    MeshReport report;
    report.vertices = mesh.vertexCount();
    report.faces = mesh.faceCount();
    fanLog.take(faceLog);
    fanLog.take(vertexLog);
    fillCounts(report, fanLog);
    report.components = fans->components.count;
    report.eulerCharacteristic = fans->vertices - fans->edges + std::int64_t(corners->faces);
    report.volume = volumes.sum;
    report.valid = report.defects.empty() && report.faces > 0 && volumes.allPositive;
    progress.report(1.0);
    return report;
}

} // namespace ramure
