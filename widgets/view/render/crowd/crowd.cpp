#include "widgets/view/render/crowd/crowd.h"

#include <cmath>
#include <glm/gtx/component_wise.hpp>
#include <string>

namespace ramure {
namespace {

bool isFinite(const ScatterPlace& place)
{
    const double sum =
        glm::compAdd(place.position) + place.size + place.turn.x + place.turn.y + place.turn.z + place.turn.w;
    return std::isfinite(sum) && std::abs(glm::length(place.turn) - 1.0) < 1e-3;
}

/// Where a ray enters the ellipsoid in a box; a box that is flat counts as a little thick.
std::optional<double> enter(const Ray& ray, const Box& box)
{
    const glm::dvec3 half = glm::max(0.5 * box.size(), 1e-3 * box.radius());
    const glm::dvec3 from = (ray.origin - box.centre()) / half, way = ray.direction / half;
    const double a = glm::dot(way, way), b = glm::dot(from, way), c = glm::dot(from, from) - 1.0;
    const double root = b * b - a * c;
    if (!(a > 0.0) || root < 0.0)
        return std::nullopt;
    const double near = (-b - std::sqrt(root)) / a, far = (-b + std::sqrt(root)) / a;
    if (far < 0.0)
        return std::nullopt;
    return near >= 0.0 ? near : far;
}

} // namespace

MeshCopy copyOf(const ScatterPlace& place, const CrowdPrototype& prototype, std::uint8_t shown)
{
    const ScatterPlace& own = prototype.local;
    const glm::quat turn(place.turn * own.turn);
    return {glm::vec3(place.position + place.turn * (place.size * own.position)),
            float(place.size * own.size),
            {turn.x, turn.y, turn.z, turn.w},
            noIndex,
            glm::u8vec4(255, 255, 255, shown)};
}

Box Crowd::boxOf(const ScatterPlace& place) const
{
    const Box& own = m_prototypes[place.prototype].box;
    if (own.empty())
        return own;
    const glm::dmat3 turn = glm::mat3_cast(place.turn);
    const glm::dvec3 middle = place.position + turn * (place.size * own.centre());
    glm::dvec3 half(0.0);
    for (int i = 0; i < 3; ++i)
        half += 0.5 * place.size * own.size()[i] * glm::abs(turn[i]);
    return {middle - half, middle + half};
}

Expected<std::shared_ptr<const Crowd>> Crowd::make(SharedPlaces places,
                                                   std::vector<CrowdPrototype> prototypes)
{
    std::shared_ptr<Crowd> made(new Crowd);
    made->m_places = places ? std::move(places) : std::make_shared<const std::vector<ScatterPlace>>();
    made->m_prototypes = std::move(prototypes);
    std::vector<PrimitiveBounds> bounds;
    bounds.reserve(made->places().size());
    std::vector<std::vector<MeshCopy>> copies(made->m_prototypes.size());
    for (std::size_t i = 0; i < made->places().size(); ++i) {
        const ScatterPlace& place = made->places()[i];
        if (!isFinite(place) || !(place.size > 0.0) || place.prototype >= made->m_prototypes.size())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("place %1 of a crowd is none"), {std::to_string(i)});
        if (made->m_prototypes[place.prototype].forms.empty())
            continue;
        const Box box = made->boxOf(place);
        if (box.empty())
            continue;
        made->m_box.add(box);
        bounds.push_back({glm::vec3(box.min), glm::vec3(box.max), static_cast<Index>(i)});
        copies[place.prototype].push_back(copyOf(place, made->m_prototypes[place.prototype]));
    }
    made->m_bounds = Bvh(std::move(bounds));
    for (auto& each : copies)
        made->m_copies.push_back(std::make_shared<const std::vector<MeshCopy>>(std::move(each)));
    return std::shared_ptr<const Crowd>(std::move(made));
}

std::optional<Crowd::Hit> Crowd::meet(const Ray& ray, double most) const
{
    std::optional<Hit> hit;
    m_bounds.alongRay(ray, most, [&](Index at, double& nearest) {
        const ScatterPlace& place = places()[at];
        const glm::dmat4 back = glm::inverse(placeMatrix(place));
        const Ray own{glm::dvec3(back * glm::dvec4(ray.origin, 1.0)), glm::dmat3(back) * ray.direction};
        const auto t = enter(own, m_prototypes[place.prototype].box);
        if (!t || *t >= nearest)
            return;
        nearest = *t;
        hit = Hit{at, *t};
    });
    return hit;
}

} // namespace ramure
