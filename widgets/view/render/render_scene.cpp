#include "widgets/view/render/render_scene.h"

#include <algorithm>
#include <cmath>

namespace ramure {

void RenderScene::updateBoxes()
{
    box = Box();
    casters = Box();
    for (const MeshItem& item : meshes) {
        const Box world = item.box.transformed(item.world);
        (item.framed ? box : trailBox).add(world);
        if (item.castsShadow)
            casters.add(world);
    }
    for (const CrowdItem& item : crowds) {
        const Box world = item.crowd->box().transformed(item.world);
        box.add(world);
        casters.add(world);
    }
    for (const LineItem& item : lines)
        (item.framed ? box : trailBox).add(item.lines->box.transformed(item.world));
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

namespace {

constexpr std::size_t mostSeen = std::size_t(1)
                                 << 22; ///< points looked at for framing: some tens of milliseconds
constexpr std::size_t mostMoved = 4096; ///< of one block whose points must be moved first

/// Of points around a middle the farthest in each direction, all that framing needs.
class Rim
{
public:
    explicit Rim(const glm::dvec3& middle)
        : m_middle(middle)
        , m_farthest(6 * side * side)
    {
    }
    void add(const glm::dvec3& point)
    {
        const glm::dvec3 way = point - m_middle;
        const glm::dvec3 size = glm::abs(way);
        const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const double most = std::max(size[axis], 1e-300);
        const auto cell = [most](double part) {
            return std::min(side - 1, static_cast<std::size_t>(0.5 * (part / most + 1.0) * double(side)));
        };
        const std::size_t face = 2 * static_cast<std::size_t>(axis) + (way[axis] < 0.0 ? 1 : 0);
        Farthest& at =
            m_farthest[(face * side + cell(way[(axis + 1) % 3])) * side + cell(way[(axis + 2) % 3])];
        const double square = glm::dot(way, way);
        if (square <= at.square)
            return;
        at = {square, point};
    }
    void appendTo(std::vector<glm::dvec3>& points, const glm::dmat4& world) const
    {
        for (const Farthest& at : m_farthest)
            if (at.square >= 0.0)
                points.emplace_back(world * glm::dvec4(at.point, 1.0));
    }

private:
    static constexpr std::size_t side = 20; ///< cells along the edge of a cube around the middle
    struct Farthest
    {
        double square = -1.0;
        glm::dvec3 point{0.0};
    };
    glm::dvec3 m_middle;
    std::vector<Farthest> m_farthest;
};

} // namespace

std::vector<glm::dvec3> RenderScene::framePoints() const
{
    std::size_t all = 1;
    for (const MeshItem& item : meshes)
        all += item.mesh.vertexCount();
    for (const LineItem& item : lines)
        all += 2 * item.lines->segments.size();
    const std::size_t usualStep = (all + mostSeen - 1) / mostSeen;
    std::vector<glm::dvec3> chosen;
    const auto take = [&](std::size_t count, std::size_t step, const Box& around, const glm::dmat4& world,
                          auto&& positionOf) {
        Rim rim(around.centre());
        for (std::size_t i = 0; i < count; i += step)
            rim.add(glm::dvec3(positionOf(i)));
        rim.appendTo(chosen, world);
    };
    for (const MeshItem& item : meshes) {
        if (!item.framed)
            continue;
        const std::size_t count = item.mesh->positions.size();
        const std::size_t step = item.motion.moves() ? std::max(usualStep, count / mostMoved) : usualStep;
        take(count, step, item.box, item.world, [&](std::size_t i) { return placeOf(item, i); });
    }
    for (const CrowdItem& item : crowds) {
        const auto& places = item.crowd->places();
        take(2 * places.size(), places.size() > mostSeen / 2 ? 7 : 1, item.crowd->box(), item.world,
             [&](std::size_t i) {
                 const Box own = item.crowd->boxOf(places[i / 2]);
                 const glm::dvec3 low(own.centre().x, own.min.y, own.centre().z);
                 return own.empty()  ? item.crowd->box().centre()
                        : i % 2 == 0 ? low
                                     : low + glm::dvec3(0.0, own.size().y, 0.0);
             });
    }
    for (const LineItem& item : lines) {
        if (!item.framed)
            continue;
        const auto& segments = item.lines->segments;
        take(2 * segments.size(), usualStep, item.lines->box, item.world,
             [&](std::size_t i) { return i % 2 == 0 ? segments[i / 2].a : segments[i / 2].b; });
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
