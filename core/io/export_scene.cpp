#include "core/io/export_scene.h"

#include "core/rig/arm/arm_shape.h"
#include "core/surface/mesh/transformed.h"
#include <algorithm>

namespace ramure {

ExportScene sceneOfMeshes(std::vector<ReadObject> objects, const Material& material)
{
    ExportScene scene;
    scene.materials = {material};
    for (ReadObject& object : objects) {
        const auto node = static_cast<Index>(scene.nodes.size());
        scene.nodes.push_back({object.name});
        scene.meshes.push_back(
            {std::move(object.name), node, std::make_shared<const TriangleMesh>(std::move(object.mesh))});
    }
    scene.frames.push_back({0.0, std::vector<NodeTransforms>(scene.nodes.size()), {}});
    scene.frames.back().bones.resize(scene.nodes.size());
    return scene;
}

Index materialIn(ExportScene& scene, const Material& material)
{
    Material wanted = material;
    for (int number = 2;; ++number) {
        const auto same = std::ranges::find(scene.materials, wanted.name, &Material::name);
        const auto at = static_cast<Index>(same - scene.materials.begin());
        if (same == scene.materials.end())
            scene.materials.push_back(wanted);
        else if (*same != wanted) {
            wanted.name = material.name + "_" + std::to_string(number);
            continue;
        }
        return at;
    }
}

int lastLevel(const ExportScene& scene)
{
    int last = 0;
    for (const ExportMesh& mesh : scene.meshes)
        last = std::max(last, mesh.level);
    return last;
}

ExportScene levelOf(const ExportScene& scene, int level)
{
    ExportScene out = scene;
    std::erase_if(out.meshes, [&](const ExportMesh& mesh) { return mesh.isLevel && mesh.level != level; });
    for (ExportMesh& mesh : out.meshes) {
        mesh.level = 0;
        mesh.finest = noIndex;
    }
    return out;
}

std::vector<MeshPart> FlatScene::parts() const
{
    std::vector<MeshPart> out;
    out.reserve(meshes.size());
    for (const Entry& entry : meshes)
        out.push_back({entry.name, entry.mesh.get(), entry.material});
    return out;
}

/// Null: the mesh is as it is.
static const ExportShape* shapeAt(const ExportMesh& mesh, std::size_t time)
{
    if (!mesh.shapes || time >= mesh.shapes->at.size() || mesh.shapes->at[time] == noIndex)
        return nullptr;
    return &mesh.shapes->shapes[mesh.shapes->at[time]];
}

FlatScene flattened(const ExportScene& scene, std::size_t frame)
{
    FlatScene flat;
    for (const ExportMesh& each : scene.meshes) {
        const ExportFrame& now = scene.frames[std::min(frame, scene.frames.size() - 1)];
        const ExportNode& node = scene.nodes[each.node];
        std::shared_ptr<const TriangleMesh> mesh = each.mesh;
        const auto become = [&mesh](TriangleMesh&& other) {
            mesh = std::make_shared<const TriangleMesh>(std::move(other));
        };
        if (const auto& bones = now.bones[each.node]; each.skin && bones)
            become(deformed(*mesh, *each.skin, *bones, node.method));
        if (const ExportShape* shape = shapeAt(each, frame)) {
            TriangleMesh form = *mesh;
            form.positions = shape->positions;
            if (!shape->normals.empty())
                form.normals = shape->normals;
            become(std::move(form));
        }
        const glm::dmat4& world = now.transforms[each.node].geometry;
        const glm::dmat4 place = scene.space.isOwn() ? world : scene.space.matrix() * world;
        if (node.isArm)
            become(transformed(upright(*mesh), place));
        else if (place != glm::dmat4(1.0))
            become(transformed(*mesh, place));
        flat.meshes.push_back({each.name, std::move(mesh), scene.materials[each.material]});
    }
    return flat;
}

} // namespace ramure
