#include "core/scene/preset_scene.h"

#include "core/presets/presets.h"

namespace ramure {

Expected<Node> presetTree(std::string_view preset)
{
    auto params = presetParams(preset);
    RAMURE_TRY(params);
    Node tree;
    tree.kind = NodeKind::Tree;
    tree.name = preset;
    tree.preset = preset;
    tree.params = std::move(*params);
    return tree;
}

Expected<Scene> presetScene(std::string_view preset)
{
    return presetTree(preset).and_then([](Node&& tree) {
        tree.id = 1;
        return Scene::fromNodes({std::move(tree)});
    });
}

} // namespace ramure
