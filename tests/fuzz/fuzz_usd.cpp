// USD as text: as meshes and as a scene.
#include "core/io/formats/usd/usd_reader.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const fuzz::MemoryFile file(data, size);
    const auto mesh = readUsd(file.path(), {});
    const auto scene = importUsd(file.path(), {}, {});
    if (!mesh)
        fuzz::claimGoodError(mesh.error());
    else
        for (const ReadObject& object : mesh->objects)
            fuzz::claimGoodMesh(object.mesh);
    if (!scene) {
        fuzz::claimGoodError(scene.error());
        return 0;
    }
    fuzz::claim(Scene::fromNodes(scene->nodes).has_value(), "the nodes are a scene");
    for (const Note& note : scene->notes)
        fuzz::claimGoodError(note);
    for (const Node& node : scene->nodes) {
        fuzz::claim(checkParams(node.params).has_value(), "parameters are within their ranges");
        if (node.mesh)
            fuzz::claimGoodMesh(*node.mesh);
    }
    return 0;
}
