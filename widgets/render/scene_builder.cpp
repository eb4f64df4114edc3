#include "widgets/render/scene_builder.h"

#include "core/mesh/normals.h"

namespace ramure {

struct SceneBuilder::Cache
{
};

SceneBuilder::SceneBuilder()
    : m_cache(std::make_unique<Cache>())
{
}
SceneBuilder::~SceneBuilder() = default;

RenderScene SceneBuilder::build(const Scene&, const ResultOf&, const SceneView&)
{
    return {};
}

void SceneBuilder::updateHighlights(RenderScene&, const ResultOf&, const SceneView&)
{
}

RenderScene sceneOfMesh(TriangleMesh mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        computeNormals(mesh);
    RenderScene scene;
    MeshItem item;
    item.box = meshBox(mesh);
    item.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    item.material = barkMaterial();
    scene.meshes.push_back(std::move(item));
    scene.updateBoxes();
    return scene;
}

} // namespace ramure
