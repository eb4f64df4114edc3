#include "core/qt/session/jobs/evaluation.h"

#include <memory>

namespace ramure {

Evaluation treeEvaluation()
{
    const auto pipeline = std::make_shared<TreePipeline>();
    Evaluation evaluation;
    evaluation.evaluate = [pipeline](const NodeParams& params, const Progress& progress) {
        return pipeline->evaluate(params, Stage::Foliage, progress);
    };
    evaluation.draft = [pipeline](const NodeParams& params, const Progress& progress) {
        return pipeline->evaluateDraft(params, progress);
    };
    evaluation.confirm = [](const TriangleMesh& mesh, MeshReport& report, const Progress& progress) {
        return confirmWithOpenMesh(mesh, report, progress);
    };
    // A draft and a full result of each tree, and room for going back and forth in the undo stack.
    evaluation.prepare = [pipeline](std::size_t trees) { pipeline->setCacheSize(8 + 2 * trees); };
    return evaluation;
}

} // namespace ramure
