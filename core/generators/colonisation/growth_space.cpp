#include "core/generators/colonisation/growth_space.h"

#include "core/math/random.h"
#include "core/surface/proof/validate.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

std::array<glm::dvec3, 3> cornersOf(const TriangleMesh& mesh, Index triangle)
{
    const glm::uvec3& t = mesh.triangles[triangle];
    return {glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
            glm::dvec3(mesh.positions[t.z])};
}

glm::dvec3 areaVector(const std::array<glm::dvec3, 3>& corners)
{
    return 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

} // namespace

GrowthSpace::GrowthSpace(std::vector<Solid> solids)
    : m_solids(std::move(solids))
{
    bool first = true;
    for (const Solid& solid : m_solids) {
        if (solid.role != GrowthRole::Envelope)
            continue;
        for (const glm::vec3& p : solid.mesh->positions) {
            m_min = first ? glm::dvec3(p) : glm::min(m_min, glm::dvec3(p));
            m_max = first ? glm::dvec3(p) : glm::max(m_max, glm::dvec3(p));
            first = false;
        }
    }
}

const GrowthSpace::Bodies& GrowthSpace::bodies() const
{
    std::call_once(m_once, [this] {
        for (const Solid& solid : m_solids) {
            const auto report = validateMesh(*solid.mesh);
            const bool closed = report && report->boundaryEdges == 0 && report->nonManifoldEdges == 0 &&
                                report->inconsistentEdges == 0 && report->faces > 0;
            auto& side = solid.role == GrowthRole::Envelope ? m_bodies.fills : m_bodies.avoids;
            side.push_back(
                {solid.name, MeshRays(solid.mesh), closed, report && report->volume < 0.0 ? -1.0 : 1.0});
        }
        double area = 0.0;
        for (std::size_t i = 0; i < m_bodies.fills.size(); ++i) {
            const TriangleMesh& mesh = *m_bodies.fills[i].rays.mesh();
            for (Index face = 0; face < mesh.faceCount(); ++face) {
                m_bodies.faces.emplace_back(i, face);
                m_bodies.area.push_back(area += glm::length(areaVector(cornersOf(mesh, face))));
            }
        }
    });
    return m_bodies;
}

Expected<void> GrowthSpace::checkEnvelope() const
{
    const auto refuse = [](const char* text, std::vector<std::string> args) {
        auto error = fail(ErrorCode::Invalid, text, std::move(args));
        error.value().path = "colonisation.envelope";
        return error;
    };
    const auto& fills = bodies().fills;
    if (fills.empty())
        return refuse(RAMURE_NOOP("below the tree stands no solid that trees fill"), {});
    for (const Body& body : fills)
        if (!body.closed)
            return refuse(RAMURE_NOOP("%1 is not closed: it has no inside that a tree could fill"),
                          {body.name});
    if (m_max.y <= 0.0)
        return refuse(RAMURE_NOOP("%1 lies below the foot of the tree"), {fills.front().name});
    return {};
}

double GrowthSpace::top() const
{
    return m_max.y;
}

/// The first face along a ray that is along no edge of what artists build.
bool GrowthSpace::isInside(const Body& body, const glm::dvec3& point)
{
    static const glm::dvec3 skew(0.0172, 1.0, 0.0091);
    if (!body.closed)
        return false;
    const auto hit = body.rays.nearest({point, skew});
    return hit &&
           body.outward * glm::dot(areaVector(cornersOf(*body.rays.mesh(), hit->triangle)), skew) > 0.0;
}

bool GrowthSpace::blocks(const glm::dvec3& point) const
{
    return std::ranges::any_of(bodies().avoids, [&](const Body& body) { return isInside(body, point); });
}

bool GrowthSpace::blocks(const glm::dvec3& from, const glm::dvec3& to) const
{
    if (from == to)
        return false;
    return std::ranges::any_of(bodies().avoids, [&](const Body& body) {
        const auto hit = body.rays.nearest({from, to - from});
        return hit && hit->t <= 1.0;
    });
}

/// Every place of the surface is as likely as every other.
glm::dvec3 GrowthSpace::onSurface(Random& random) const
{
    const auto& [fills, avoids, faces, area] = bodies();
    const double wanted = random.unit() * area.back();
    const auto at = static_cast<std::size_t>(std::ranges::upper_bound(area, wanted) - area.begin());
    const auto& [body, face] = faces[std::min(at, faces.size() - 1)];
    const auto corners = cornersOf(*fills[body].rays.mesh(), face);
    const double root = std::sqrt(random.unit()), share = random.unit();
    return (1.0 - root) * corners[0] + root * (1.0 - share) * corners[1] + root * share * corners[2];
}

Expected<std::vector<glm::dvec3>> GrowthSpace::points(std::int64_t count, double surface, std::uint64_t seed,
                                                      const Progress& progress) const
{
    const glm::dvec3 low(m_min.x, std::max(m_min.y, 0.0), m_min.z);
    const auto isWithin = [this](const glm::dvec3& point) {
        return std::ranges::any_of(bodies().fills, [&](const Body& body) { return isInside(body, point); });
    };
    std::vector<glm::dvec3> points;
    points.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % 1024 == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        Random random(seed, RandomStream::CrownPoints, std::uint64_t(i));
        const bool outside = random.unit() < surface;
        // Of a sheet that is hardly thicker than nothing, the tries may be used up: its surface is near.
        glm::dvec3 point{0.0};
        bool found = false;
        for (int tries = 0; !found && tries < 1000; ++tries) {
            if (outside || tries >= 900)
                point = onSurface(random);
            else
                point = low + glm::dvec3(random.unit(), random.unit(), random.unit()) * (m_max - low);
            found = point.y > 0.0 && (outside || tries >= 900 || isWithin(point));
        }
        if (found)
            points.push_back(point);
    }
    return points;
}

} // namespace ramure
