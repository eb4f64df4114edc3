#include "widgets/view/render/scene_at.h"

#include <map>

namespace ramure {

Expected<RenderScene> renderSceneAt(EvaluatedScene& now, const SceneView& view, const Progress& progress)
{
    RAMURE_TRY(now.poseArms(progress));
    const Scene& scene = now.scene();
    std::map<NodeId, TreeResult> results;
    for (const Node& node : scene.nodes()) {
        if (node.kind != NodeKind::Tree || !scene.isShown(node.id))
            continue;
        auto result = now.tree(node, Stage::Foliage, progress);
        RAMURE_TRY(result);
        results.emplace(node.id, std::move(*result));
    }
    const auto resultOf = [&](NodeId id) {
        const auto found = results.find(id);
        return found == results.end() ? nullptr : &found->second;
    };
    return SceneBuilder().build(now, resultOf, view);
}

} // namespace ramure
