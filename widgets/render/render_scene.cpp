#include "widgets/render/render_scene.h"

#include <algorithm>

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

/// Where a vertex is now.
static glm::dvec3 placeOf(const MeshItem& item, std::size_t vertex)
{
    const glm::dvec3 rest(item.mesh->positions[vertex]);
    const ItemMotion& motion = item.motion;
    if (!motion.moves() || !motion.skin)
        return rest;
    const SkinInfluence& own = motion.skin->of(static_cast<Index>(vertex));
    return glm::dvec3(skinMatrix(own, *motion.bones, motion.method) * glm::dvec4(rest, 1.0));
}

std::vector<glm::dvec3> RenderScene::framePoints() const
{
    constexpr std::size_t perBlock = 4096;
    std::vector<glm::dvec3> chosen;
    const auto take = [&chosen](std::size_t count, const glm::dmat4& world, auto&& positionOf) {
        const std::size_t step = std::max<std::size_t>(1, count / perBlock);
        for (std::size_t i = 0; i < count; i += step)
            chosen.emplace_back(world * glm::dvec4(glm::dvec3(positionOf(i)), 1.0));
    };
    for (const MeshItem& item : meshes)
        take(item.mesh->positions.size(), item.world, [&](std::size_t i) { return placeOf(item, i); });
    for (const LineItem& item : lines) {
        take(item.lines->segments.size(), item.world,
             [&](std::size_t i) { return item.lines->segments[i].a; });
        take(item.lines->segments.size(), item.world,
             [&](std::size_t i) { return item.lines->segments[i].b; });
    }
    return chosen;
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
