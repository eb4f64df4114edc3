#include "widgets/view/render/pick/pick_scene.h"

#include "core/math/bvh.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

std::vector<PrimitiveBounds> boundsOf(const TriangleMesh& mesh)
{
    std::vector<PrimitiveBounds> bounds;
    bounds.reserve(mesh.triangles.size());
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::vec3& a = mesh.positions[t.x];
        const glm::vec3& b = mesh.positions[t.y];
        const glm::vec3& c = mesh.positions[t.z];
        bounds.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
    }
    return bounds;
}

std::vector<PrimitiveBounds> boundsOf(const LineSet& lines)
{
    std::vector<PrimitiveBounds> bounds;
    for (Index i = 0; i < lines.segments.size(); ++i) {
        const LineSegment& s = lines.segments[i];
        if (s.branch != noIndex)
            bounds.push_back({glm::min(s.a, s.b), glm::max(s.a, s.b), i});
    }
    return bounds;
}

glm::dvec3 moved(const glm::dmat4& matrix, const glm::vec3& point)
{
    return glm::dvec3(matrix * glm::dvec4(glm::dvec3(point), 1.0));
}

/// A segment as the screen shows it.
struct ScreenDistance
{
    double pixels = 0.0;   ///< from the cursor
    glm::dvec3 point{0.0}; ///< world, of the segment, nearest to the cursor
};

/// Nothing where the whole segment is behind the eye.
std::optional<ScreenDistance> screenDistance(const PickView& view, const glm::dvec2& pixel, glm::dvec3 a,
                                             glm::dvec3 b)
{
    const Camera& camera = view.camera;
    const auto depth = [&camera](const glm::dvec3& p) {
        return -glm::dot(p - camera.eye(), camera.backward());
    };
    if (!camera.orthographic) {
        const double least = 1e-6 * camera.distance;
        const double atA = depth(a);
        const double atB = depth(b);
        if (atA < least && atB < least)
            return std::nullopt;
        if (atA < least)
            a = glm::mix(a, b, (least - atA) / (atB - atA));
        else if (atB < least)
            b = glm::mix(b, a, (least - atB) / (atA - atB));
    }
    const auto onScreen = [&](const glm::dvec3& p) { return view.pixel(p).value_or(0.5 * view.size); };
    const glm::dvec2 from = onScreen(a);
    const glm::dvec2 way = onScreen(b) - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(pixel - from, way) / square, 0.0, 1.0) : 0.0;
    // Equal steps on the screen are not equal steps in space.
    const double nearA = camera.orthographic ? 1.0 : depth(a);
    const double nearB = camera.orthographic ? 1.0 : depth(b);
    const double inSpace = share * nearA / (share * nearA + (1.0 - share) * nearB);
    return ScreenDistance{glm::length(from + share * way - pixel), glm::mix(a, b, inSpace)};
}

} // namespace

/// One pickable item of the scene with its hierarchy; the hierarchy is shared with the next scene.
struct PickScene::Part
{
    std::shared_ptr<const TriangleMesh> mesh; ///< one of the two
    std::shared_ptr<const LineSet> lines;
    std::shared_ptr<const Bvh> hierarchy;
    glm::dmat4 world{1.0};
    glm::dmat4 inverse{1.0};
    NodeId node = noNode;

    [[nodiscard]] const void* block() const
    {
        return mesh ? static_cast<const void*>(mesh.get()) : static_cast<const void*>(lines.get());
    }
    [[nodiscard]] Ray localRay(const ViewRay& ray) const
    {
        // Not normalised: t then means the same in the world and here.
        return {glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)), glm::dmat3(inverse) * ray.direction};
    }
    /// Half-spaces of the world, here.
    [[nodiscard]] std::vector<CutPlane> localPlanes(std::span<const CutPlane> planes) const
    {
        std::vector<CutPlane> local;
        for (const CutPlane& plane : planes)
            local.push_back(glm::transpose(world) * plane);
        return local;
    }
    [[nodiscard]] Index branchAt(Index triangle, const glm::dvec3& weights) const
    {
        if (mesh->branch.size() != mesh->positions.size())
            return noIndex;
        const int heaviest =
            weights.x >= weights.y ? (weights.x >= weights.z ? 0 : 2) : (weights.y >= weights.z ? 1 : 2);
        return mesh->branch[mesh->triangles[triangle][heaviest]];
    }
    void pickSurface(const ViewRay& ray, double& nearest, std::optional<PickHit>& hit) const;
    void pickLine(const PickView& view, const ViewRay& ray, const glm::dvec2& pixel, double& least,
                  double& leastDepth, std::optional<PickHit>& hit) const;
    /// Marks the branches inside, by their index.
    void collect(std::span<const CutPlane> planes, std::vector<bool>& inside) const;
};

void PickScene::Part::pickSurface(const ViewRay& ray, double& nearest, std::optional<PickHit>& hit) const
{
    const Ray local = localRay(ray);
    hierarchy->alongRay(local, nearest, [&](Index triangle, double& tMax) {
        const glm::uvec3& t = mesh->triangles[triangle];
        const auto found = intersect(local, glm::dvec3(mesh->positions[t.x]),
                                     glm::dvec3(mesh->positions[t.y]), glm::dvec3(mesh->positions[t.z]));
        if (!found || found->t >= nearest)
            return;
        nearest = tMax = found->t;
        hit = PickHit{node, branchAt(triangle, found->weights), ray.origin + found->t * ray.direction};
    });
}

void PickScene::Part::pickLine(const PickView& view, const ViewRay& ray, const glm::dvec2& pixel,
                               double& least, double& leastDepth, std::optional<PickHit>& hit) const
{
    const Camera& camera = view.camera;
    // Depth is linear in the local position; a box holds its largest value at a corner.
    const glm::dvec4 depthOf =
        -(glm::transpose(world) * glm::dvec4(camera.backward(), -glm::dot(camera.backward(), camera.eye())));
    const double perDepth = 2.0 * std::tan(0.5 * camera.fovRad) / view.size.y;
    const double flat = camera.heightAtTarget() / view.size.y;
    double norm = 0.0; // bounds how much longer a distance of the world can be here
    for (int i = 0; i < 3; ++i)
        norm += glm::dot(glm::dvec3(inverse[i]), glm::dvec3(inverse[i]));
    norm = std::sqrt(norm);
    const auto growth = [&](const glm::dvec3& min, const glm::dvec3& max) {
        const glm::dvec3 centre = 0.5 * (min + max);
        const double depth = glm::dot(glm::dvec3(depthOf), centre) + depthOf.w +
                             glm::dot(glm::abs(glm::dvec3(depthOf)), 0.5 * (max - min));
        return norm * (least + 1e-6) * (camera.orthographic ? flat : perDepth * std::max(depth, 0.0));
    };
    hierarchy->nearRay(localRay(ray), growth, [&](Index i) {
        const LineSegment& s = lines->segments[i];
        const auto at = screenDistance(view, pixel, moved(world, s.a), moved(world, s.b));
        // Within a line's own width the one in front wins.
        const double pixels = at ? std::max(at->pixels, 1.5) : 0.0;
        if (!at || pixels > least)
            return;
        const double depth = glm::dot(camera.eye() - at->point, camera.backward());
        if (pixels == least && hit && depth >= leastDepth)
            return;
        least = pixels;
        leastDepth = depth;
        hit = PickHit{node, s.branch, at->point};
    });
}

void PickScene::Part::collect(std::span<const CutPlane> planes, std::vector<bool>& inside) const
{
    const std::vector<CutPlane> local = localPlanes(planes);
    // A branch has hundreds of triangles: one is enough.
    const auto isNew = [&inside](Index branch) { return branch >= inside.size() || !inside[branch]; };
    const auto mark = [&inside](Index branch) {
        if (branch == noIndex)
            return;
        if (branch >= inside.size())
            inside.resize(std::max<std::size_t>(branch + 1, 2 * inside.size()));
        inside[branch] = true;
    };
    hierarchy->inPlanes(local, [&](Index i, bool certain) {
        if (lines) {
            const LineSegment& s = lines->segments[i];
            if (isNew(s.branch) && (certain || touches(local, glm::dvec3(s.a), glm::dvec3(s.b))))
                mark(s.branch);
            return;
        }
        const glm::uvec3& t = mesh->triangles[i];
        if (mesh->branch.size() != mesh->positions.size())
            return;
        const Index branch = mesh->branch[t.x];
        if (isNew(branch) &&
            (certain || touches(local, glm::dvec3(mesh->positions[t.x]), glm::dvec3(mesh->positions[t.y]),
                                glm::dvec3(mesh->positions[t.z]))))
            mark(branch);
    });
}

PickScene::PickScene() = default;
PickScene::~PickScene() = default;
PickScene::PickScene(PickScene&&) noexcept = default;
PickScene& PickScene::operator=(PickScene&&) noexcept = default;

PickScene::PickScene(const RenderScene& scene, const PickScene* previous, const std::stop_token& stop)
    : m_box(scene.box)
{
    const auto add = [&](Part part, auto&& bounds) {
        if (stop.stop_requested() || glm::determinant(glm::dmat3(part.world)) == 0.0)
            return;
        part.inverse = glm::inverse(part.world);
        for (std::size_t i = 0; previous && i < previous->m_parts.size() && !part.hierarchy; ++i) {
            if (previous->m_parts[i]->block() == part.block())
                part.hierarchy = previous->m_parts[i]->hierarchy;
        }
        if (!part.hierarchy)
            part.hierarchy = std::make_shared<const Bvh>(bounds(), stop);
        m_parts.push_back(std::make_shared<const Part>(std::move(part)));
    };
    for (const MeshItem& item : scene.meshes) {
        if (item.pickable)
            add(Part{item.mesh, nullptr, nullptr, item.world, {}, item.node},
                [&] { return boundsOf(*item.mesh); });
    }
    for (const LineItem& item : scene.lines) {
        if (item.pickable)
            add(Part{nullptr, item.lines, nullptr, item.world, {}, item.node},
                [&] { return boundsOf(*item.lines); });
    }
    for (const CrowdItem& item : scene.crowds)
        if (item.pickable && glm::determinant(glm::dmat3(item.world)) != 0.0)
            m_crowds.push_back(item);
    if (stop.stop_requested()) {
        m_parts.clear();
        m_crowds.clear();
    }
}

ViewRay PickScene::rayUnder(const PickView& view, const glm::dvec2& pixel) const
{
    ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    // Parallel rays start before everything: an orthographic view also shows what is behind the eye.
    if (view.camera.orthographic)
        ray.origin += view.camera.depthRange(m_box).near * ray.direction;
    return ray;
}

bool PickScene::hasSurface(NodeId node, const TriangleMesh* mesh) const
{
    return std::any_of(m_parts.begin(), m_parts.end(), [&](const auto& part) {
        return part->mesh && part->node == node && (!mesh || part->mesh.get() == mesh);
    });
}

std::optional<glm::dvec3> PickScene::meet(const PickView& view, const glm::dvec2& pixel, NodeId node,
                                          const glm::dmat4& world) const
{
    if (glm::determinant(glm::dmat3(world)) == 0.0)
        return std::nullopt;
    const ViewRay ray = rayUnder(view, pixel);
    std::optional<PickHit> hit;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& part : m_parts) {
        if (!part->mesh || part->node != node)
            continue;
        Part now = *part;
        now.world = world;
        now.inverse = glm::inverse(world);
        now.pickSurface(ray, nearest, hit);
    }
    return hit ? std::optional(hit->point) : std::nullopt;
}

std::optional<PickHit> PickScene::pick(const PickView& view, const glm::dvec2& pixel, double tolerance) const
{
    std::optional<PickHit> hit;
    double nearest = std::numeric_limits<double>::infinity();
    double least = tolerance;
    const ViewRay ray = rayUnder(view, pixel);
    for (const auto& part : m_parts) {
        if (part->lines)
            part->pickLine(view, ray, pixel, least, nearest, hit);
    }
    if (hit)
        return hit;
    nearest = std::numeric_limits<double>::infinity();
    for (const auto& part : m_parts) {
        if (part->mesh)
            part->pickSurface(ray, nearest, hit);
    }
    for (const CrowdItem& item : m_crowds) {
        const glm::dmat4 inverse = glm::inverse(item.world);
        const Ray local{glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)),
                        glm::dmat3(inverse) * ray.direction}; // t means the same here and there
        if (const auto met = item.crowd->meet(local, nearest)) {
            nearest = met->t;
            hit = PickHit{item.node, noIndex, ray.origin + met->t * ray.direction,
                          item.crowd->places()[met->place].key};
        }
    }
    return hit;
}

std::vector<PickedBranches> PickScene::inRectangle(const PickView& view, const glm::dvec2& cornerA,
                                                   const glm::dvec2& cornerB) const
{
    const Camera& camera = view.camera;
    const glm::dvec2 a = view.ndc(cornerA);
    const glm::dvec2 b = view.ndc(cornerB);
    const glm::dvec2 low = glm::min(a, b);
    const glm::dvec2 high = glm::max(a, b);
    // Rows of the clip matrix: low * w <= x <= high * w, the same for y, and in front of the eye.
    const DepthRange range{1e-6 * camera.distance, 1e6 * camera.distance};
    const glm::dmat4 rows =
        glm::transpose(camera.projectionMatrix(view.aspect(), range) * camera.viewMatrix());
    std::vector<CutPlane> planes{rows[0] - low.x * rows[3], high.x * rows[3] - rows[0],
                                 rows[1] - low.y * rows[3], high.y * rows[3] - rows[1]};
    if (!camera.orthographic)
        planes.push_back(rows[3]);
    std::vector<std::pair<NodeId, std::vector<bool>>> marked;
    for (const auto& part : m_parts) {
        auto at = std::find_if(marked.begin(), marked.end(),
                               [&part](const auto& other) { return other.first == part->node; });
        if (at == marked.end())
            at = marked.insert(marked.end(), {part->node, {}});
        part->collect(planes, at->second);
    }
    std::vector<PickedBranches> picked;
    for (const auto& [node, inside] : marked) {
        PickedBranches of{node, {}};
        for (Index branch = 0; branch < inside.size(); ++branch)
            if (inside[branch])
                of.branches.push_back(branch);
        if (!of.branches.empty())
            picked.push_back(std::move(of));
    }
    return picked;
}

} // namespace ramure
