#include "widgets/view/render/passes/crowd_pictures.h"

#include <cmath>

namespace ramure {
namespace {

/// What a picture of this quality may cost. A processor takes a microsecond for a triangle, a card fifty
/// times less.
CrowdBudget budgetOf(const RenderOptions& options)
{
    CrowdBudget budget;
    const bool isBest = options.quality == Quality::Best && !options.hurried;
    const bool isDraft = options.quality == Quality::Draft || options.hurried;
    const std::int64_t usual = options.sparing ? 200'000 : 6'000'000;
    budget.triangles = isBest ? 5 * usual : isDraft ? usual / 3 : usual;
    budget.whole = isDraft || (options.sparing && !isBest) ? 0 : budget.triangles;
    budget.coarser = isDraft ? 2.0 : 1.0;
    return budget;
}

/// Sides and front of what the camera shows, in the world.
std::vector<CutPlane> planesOf(const Camera& camera, double aspect)
{
    const DepthRange range{1e-6 * camera.distance, 1e6 * camera.distance};
    const glm::dmat4 rows = glm::transpose(camera.projectionMatrix(aspect, range) * camera.viewMatrix());
    std::vector<CutPlane> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
    if (!camera.orthographic)
        planes.push_back(rows[3]);
    return planes;
}

/// Sides of all that throws shadows on what is around the camera's target.
std::vector<CutPlane> planesTowards(const glm::dvec3& sun, const Camera& camera, double aspect)
{
    const double reach = camera.heightAtTarget() * std::max(aspect, 1.0);
    const glm::dvec3 helper = std::abs(sun.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 across = glm::normalize(glm::cross(helper, sun));
    std::vector<CutPlane> planes;
    for (const glm::dvec3& axis : {across, glm::cross(sun, across)})
        for (const double side : {1.0, -1.0})
            planes.emplace_back(side * axis, reach - side * glm::dot(axis, camera.target));
    return planes;
}

CrowdSight sightOf(const CrowdItem& item, const Camera& camera, QSize size, std::vector<CutPlane> planes)
{
    const glm::dmat4 toWorld = glm::transpose(item.world);
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(item.world))));
    CrowdSight sight;
    sight.eye = glm::dvec3(glm::inverse(item.world) * glm::dvec4(camera.eye(), 1.0));
    sight.isParallel = camera.orthographic;
    sight.pixels =
        double(size.height()) / camera.heightAtTarget() * (camera.orthographic ? scale : camera.distance);
    for (const CutPlane& plane : planes)
        sight.planes.push_back(toWorld * plane);
    return sight;
}

void addForm(std::vector<MeshItem>& items, const CrowdItem& crowd, std::size_t prototype,
             const CrowdForm& form, const std::shared_ptr<const std::vector<MeshCopy>>& places)
{
    const CrowdPrototype& own = crowd.crowd->prototypes()[prototype];
    for (const CrowdPart& part : form.parts) {
        MeshItem& item = items.emplace_back();
        item.mesh = std::shared_ptr<const TriangleMesh>(part.shape, &part.shape->shape);
        item.copies = part.shape;
        item.places = places;
        item.box = crowd.crowd->box();
        item.material = part.material;
        item.crown = own.crown;
        item.bark = part.bark;
        item.images = part.images;
        item.mean = part.mean;
        item.flat = part.flat;
        item.world = crowd.world;
        item.node = crowd.node;
        item.closed = part.closed;
    }
}

void addWhole(std::vector<MeshItem>& items, const CrowdItem& crowd, const ScatterPlace& place)
{
    const auto& whole = crowd.whole[place.prototype];
    const glm::dmat4 world = crowd.world * placeMatrix(place);
    for (const MeshItem& own : *whole) {
        MeshItem& item = items.emplace_back(own);
        item.world = world * own.world;
        item.node = crowd.node;
    }
}

void add(std::vector<MeshItem>& items, const CrowdItem& crowd, const CrowdChoice& choice)
{
    for (const CrowdChoice::OfForm& of : choice.forms)
        addForm(items, crowd, of.prototype, crowd.crowd->prototypes()[of.prototype].forms[of.form],
                of.places);
    for (const Index place : choice.whole)
        addWhole(items, crowd, crowd.crowd->places()[place]);
}

} // namespace

void CrowdPictures::choose(const Key& key)
{
    m_seen.clear();
    m_far.clear();
    m_near.clear();
    m_counts = {};
    const double aspect = double(key.size.width()) / std::max(1, key.size.height());
    for (const CrowdItem& item : key.crowds) {
        if (std::abs(glm::determinant(glm::dmat3(item.world))) == 0.0)
            continue;
        const CrowdChoice choice = chooseForms(
            *item.crowd, sightOf(item, key.camera, key.size, planesOf(key.camera, aspect)), key.budget);
        add(m_seen, item, choice);
        m_counts.all += item.crowd->places().size();
        m_counts.seen += choice.instances;
        m_counts.whole += choice.whole.size();
        m_counts.triangles += choice.triangles;
        const auto& prototypes = item.crowd->prototypes();
        for (std::size_t p = 0; p < prototypes.size(); ++p)
            if (!item.crowd->copies(p)->empty())
                addForm(m_far, item, p, prototypes[p].forms.back(), item.crowd->copies(p));
        if (key.sun == glm::dvec3(0.0))
            continue;
        CrowdBudget budget = key.budget;
        budget.coarser *= 2.0;
        budget.triangles /= 3;
        add(m_near, item,
            chooseForms(*item.crowd,
                        sightOf(item, key.camera, key.size, planesTowards(key.sun, key.camera, aspect)),
                        budget));
    }
    for (MeshItem& item : m_seen)
        item.castsShadow = false;
}

const RenderScene& CrowdPictures::of(const RenderScene& scene, const Camera& camera, QSize size,
                                     const RenderOptions& options)
{
    m_scene = {};
    if (scene.crowds.empty()) {
        m_key = {};
        m_counts = {};
        return scene;
    }
    Key key{scene.crowds, camera, size, budgetOf(options), {}};
    if (options.shadows && !options.hurried && options.quality != Quality::Draft)
        key.sun = options.light.sun();
    if (!(key == m_key)) {
        choose(key);
        m_key = std::move(key);
    }
    m_scene = scene;
    m_scene.meshes.insert(m_scene.meshes.end(), m_seen.begin(), m_seen.end());
    m_scene.farCasters = m_far;
    m_scene.nearCasters = m_near;
    return m_scene;
}

} // namespace ramure
