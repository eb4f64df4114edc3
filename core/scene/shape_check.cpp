#include "core/scene/shape_check.h"

#include "core/scene/object_mesh.h"

namespace ramure {

bool isGoodSurface(const MeshReport& r)
{
    return r.faces > 0 && r.nonManifoldEdges == 0 && r.nonManifoldVertices == 0 && r.inconsistentEdges == 0 &&
           r.duplicateVertices == 0 && r.duplicateFaces == 0 && r.degenerateFaces == 0 &&
           r.isolatedVertices == 0;
}

Expected<ShapeCheck> checkMesh(std::shared_ptr<const TriangleMesh> mesh, bool crossings,
                               const Progress& progress)
{
    auto report = validateMesh(*mesh, progress.part(0.0, 0.3));
    RAMURE_TRY(report);
    RAMURE_TRY(confirmWithOpenMesh(*mesh, *report, progress.part(0.3, 0.6)));
    if (report->openMeshChecked && !report->openMeshAgrees)
        report->valid = false;
    auto analysis = crossings ? analyseMesh(*mesh, 0, progress.part(0.6, 1.0))
                              : analyseShape(*mesh, 0, progress.part(0.6, 1.0));
    RAMURE_TRY(analysis);
    return ShapeCheck{std::move(mesh), std::move(*report), std::move(*analysis)};
}

Expected<ShapeCheck> checkShape(const Node& node, const NodeParams& params, bool crossings,
                                const Progress& progress)
{
    auto mesh = objectSolid(node, params);
    RAMURE_TRY(mesh);
    if (!*mesh)
        mesh = std::make_shared<const TriangleMesh>();
    auto checked = checkMesh(std::move(*mesh), crossings, progress.part(0.1, 1.0));
    if (!checked)
        return checked;
    checked->isOpen = isOpenSurface(node);
    if (checked->isOpen)
        checked->report.valid = isGoodSurface(checked->report);
    return checked;
}

Expected<ShapeCheck> checkShapeAtRest(const Node& node, bool crossings, const Progress& progress)
{
    return checkShape(node, paramsAt(node.params, node.animation, 0.0), crossings, progress);
}

} // namespace ramure
