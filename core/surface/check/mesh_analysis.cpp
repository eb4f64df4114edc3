#include "core/surface/check/mesh_analysis.h"

#include <chrono>

namespace ramure {
namespace {

Expected<MeshAnalysis> analyse(const TriangleMesh& mesh, const std::vector<Index>& parent, unsigned threads,
                               const Progress& progress)
{
    auto analysis = analyseShape(mesh, threads, progress.part(0.0, 0.05));
    RAMURE_TRY(analysis);
    auto crossings = findSelfIntersections(mesh, parent, threads, progress.part(0.05, 0.98));
    RAMURE_TRY(crossings);
    analysis->crossings = std::move(*crossings);
    return analysis;
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

Expected<MeshAnalysis> analyseShape(const TriangleMesh& mesh, unsigned threads, const Progress& progress)
{
    MeshAnalysis analysis;
    analysis.hash = meshHash(mesh);
    auto quality = measureQuality(mesh, threads, progress);
    RAMURE_TRY(quality);
    analysis.quality = std::move(*quality);
    return analysis;
}

Expected<MeshAnalysis> analyseMesh(const BranchMesh& branches, const Skeleton& skeleton, unsigned threads,
                                   const Progress& progress)
{
    const auto start = std::chrono::steady_clock::now();
    auto analysis = analyse(branches.mesh, repairedParents(skeleton, branches.repairs), threads, progress);
    if (!analysis)
        return analysis;
    analysis->collisions = findCollisions(skeleton, analysis->crossings.branches);
    analysis->seconds = secondsSince(start);
    progress.report(1.0);
    return analysis;
}

Expected<MeshAnalysis> analyseMesh(const TriangleMesh& mesh, unsigned threads, const Progress& progress)
{
    const auto start = std::chrono::steady_clock::now();
    auto analysis = analyse(mesh, {}, threads, progress);
    if (analysis)
        analysis->seconds = secondsSince(start);
    progress.report(1.0);
    return analysis;
}

} // namespace ramure
