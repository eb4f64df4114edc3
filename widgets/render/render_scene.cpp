#include "widgets/render/render_scene.h"

namespace ramure {

void RenderScene::updateBoxes()
{
    box = Box();
    casters = Box();
    for (const MeshItem& item : meshes) {
        const Box world = item.box.transformed(item.world);
        box.add(world);
        if (item.castsShadow)
            casters.add(world);
    }
    for (const LineItem& item : lines)
        box.add(item.lines->box.transformed(item.world));
    for (const PointItem& item : points)
        box.add(item.points->box.transformed(item.world));
}

Box meshBox(const TriangleMesh& mesh)
{
    if (mesh.positions.empty())
        return {};
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {glm::dvec3(low), glm::dvec3(high)};
}

} // namespace ramure
