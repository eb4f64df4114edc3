#include "widgets/dialogs/export/print_scene.h"

#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// The faces that are overhangs, or those that are not.
TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<bool>& isOver, bool over)
{
    TriangleMesh part;
    std::vector<Index> numberOf(mesh.positions.size(), noIndex);
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        if (isOver[i] != over)
            continue;
        glm::uvec3 t = mesh.triangles[i];
        for (int k = 0; k < 3; ++k) {
            Index& number = numberOf[t[k]];
            if (number == noIndex) {
                number = part.vertexCount();
                part.positions.push_back(mesh.positions[t[k]]);
                part.normals.push_back(mesh.normals[t[k]]);
            }
            t[k] = number;
        }
        part.triangles.push_back(t);
    }
    return part;
}

void addItem(RenderScene& scene, TriangleMesh&& mesh, const glm::u8vec3& colour)
{
    if (mesh.empty())
        return;
    MeshItem item;
    item.box = meshBox(mesh);
    item.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    item.material.name = "print";
    item.material.colour = colour;
    item.node = 1;
    item.closed = true; // together they are
    item.pickable = false;
    scene.meshes.push_back(std::move(item));
}

} // namespace

RenderScene previewScene(const PrintedTree& print)
{
    const TriangleMesh& mesh = *print.mesh;
    std::vector<bool> isOver(mesh.triangles.size());
    for (Index i = 0; i < mesh.faceCount(); ++i)
        isOver[i] = isOverhang(mesh, i);
    RenderScene scene;
    addItem(scene, partOf(mesh, isOver, false), printColour);
    addItem(scene, partOf(mesh, isOver, true), overhangColour);
    scene.updateBoxes();
    return scene;
}

Camera wholePrint(const PrintedTree& print, Camera camera, double aspect)
{
    camera.frame(Box{print.report.low, print.report.high}, aspect);
    return camera;
}

Camera thinnestPlace(const PrintedTree& print, Camera camera)
{
    constexpr double shown = 0.12; // of the height of the print
    const glm::dvec3 at = print.report.thinnestAt, from = 0.5 * (print.report.low + print.report.high);
    const glm::dvec3 out = at - from;
    camera.target = at;
    const double height = std::max(shown * print.report.size().y, 8.0 * print.report.thinnest);
    camera.distance = 0.5 * height / std::tan(0.5 * camera.fovRad);
    if (std::hypot(out.x, out.z) > 0.0)
        camera.yawRad = std::atan2(out.x, out.z);
    camera.pitchRad = std::clamp(std::atan2(out.y, std::hypot(out.x, out.z)), -0.3, 0.6);
    return camera;
}

} // namespace ramure
