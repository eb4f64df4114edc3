#include "tests/support/fork_judge.h"
#include "core/surface/mesher/build_branch_mesh.h"

#include "core/surface/proof/validate.h"
#include "tests/support/mesh_checker.h"
#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

namespace ramure::test {
namespace {

/// What the program itself says; its counts must be those of the tests' own judge.
std::string programsFaults(const TriangleMesh& mesh, const CheckedMesh& checked)
{
    Expected<MeshReport> report = validateMesh(mesh);
    if (!report)
        return "validateMesh: " + report.error().message();
    std::ostringstream text;
    const Expected<void> confirmed = confirmWithOpenMesh(mesh, *report);
    if (!confirmed)
        text << "OpenMesh: " << confirmed.error().message() << '\n';
    else if (!report->openMeshAgrees)
        text << "OpenMesh does not agree\n";
    if (!report->valid)
        text << "validateMesh finds the mesh not valid\n";
    const std::pair<Index, Index> counts[] = {
        {report->boundaryEdges, checked.boundaryEdges},
        {report->nonManifoldEdges, checked.crowdedEdges},
        {report->nonManifoldVertices, checked.pinchedVertices},
        {report->inconsistentEdges, checked.misorientedEdges},
        {report->duplicateVertices, checked.duplicateVertices},
        {report->duplicateFaces, checked.duplicateFaces},
        {report->degenerateFaces, checked.degenerateFaces},
        {report->isolatedVertices, checked.isolatedVertices},
        {report->components, static_cast<Index>(checked.components.size())},
    };
    for (std::size_t i = 0; i < std::size(counts); ++i)
        if (counts[i].first != counts[i].second)
            text << "the judges differ in count " << i << ": " << counts[i].first << " against "
                 << counts[i].second << '\n';
    return text.str();
}

std::string ownerFaults(const Skeleton& skeleton, const TriangleMesh& mesh)
{
    if (mesh.branch.size() != mesh.positions.size() || mesh.level.size() != mesh.positions.size())
        return "a vertex without branch or level\n";
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.branch[v] >= skeleton.size())
            return "vertex " + std::to_string(v) + " of branch " + std::to_string(mesh.branch[v]) + "\n";
        if (mesh.level[v] != skeleton.level[mesh.branch[v]])
            return "vertex " + std::to_string(v) + " not on the level of its branch\n";
    }
    return {};
}

/// Roots that start within a radius of each other stand together.
std::size_t standsOf(const Skeleton& skeleton)
{
    std::vector<Index> roots;
    for (Index i = 0; i < skeleton.size(); ++i)
        if (skeleton.parent[i] == noIndex)
            roots.push_back(i);
    std::vector<std::size_t> stand(roots.size());
    std::iota(stand.begin(), stand.end(), std::size_t{0});
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (stand[i] != stand[k] && glm::length(skeleton.p0[roots[i]] - skeleton.p0[roots[k]]) <=
                                            std::max(skeleton.a0[roots[i]], skeleton.a0[roots[k]]))
                std::ranges::replace(stand, std::size_t(stand[i]), std::size_t(stand[k]));
    return std::set<std::size_t>(stand.begin(), stand.end()).size();
}

} // namespace

std::string branchMeshFaults(const Skeleton& skeleton, const BranchMesh& built)
{
    const std::size_t roots = standsOf(skeleton);
    const CheckedMesh checked = checkMesh(built.mesh);
    std::ostringstream text;
    if (!checked.perfect(roots) || built.mesh.normals.empty())
        text << roots << " roots; " << checked.summary();
    if (built.roots != roots)
        text << "the mesher counts " << built.roots << " roots of " << roots << '\n';
    text << ownerFaults(skeleton, built.mesh) << programsFaults(built.mesh, checked);
    return text.str();
}

std::string branchMeshFaults(const Skeleton& skeleton, const BranchMeshOptions& options)
{
    const Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
    if (!built)
        return "not built: " + built.error().message() + '\n';
    return branchMeshFaults(skeleton, *built);
}

} // namespace ramure::test
