#include "tests/support/wind_preview.h"

#include "core/math/reproducible.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace ramure {
namespace {

constexpr double wholeTurn = glm::two_pi<double>();
/// Of T. Sousa: "good frequencies".
constexpr double edgeRates[] = {1.975, 0.793}, branchRates[] = {0.375, 0.193};

/// 0 to 1.
double smoothTriangleWave(double x)
{
    const double triangle = std::abs((x + 0.5 - std::floor(x + 0.5)) * 2.0 - 1.0);
    return triangle * triangle * (3.0 - 2.0 * triangle);
}

double waves(double at, const double (&rates)[2])
{
    double sum = 0.0;
    for (const double rate : rates) {
        const double turns = at * rate;
        sum += smoothTriangleWave((turns - std::floor(turns)) * 2.0 - 1.0);
    }
    return sum;
}

glm::dvec3 plain(const WindPlace& place, const WindVertex& vertex, const WindNow& now)
{
    const double sway =
        vertex.lean + vertex.sway * maths::sin(wholeTurn * (0.5 * now.seconds + vertex.phase));
    const double flutter = vertex.flutter * maths::sin(wholeTurn * (2.0 * now.seconds + vertex.phase));
    return place.position + now.strength * (sway * now.direction + flutter * place.normal);
}

/// CryEngine has Z up.
glm::dvec3 zUp(const glm::dvec3& v)
{
    return {v.x, -v.z, v.y};
}

glm::dvec3 crysis(const WindPlace& place, const WindVertex& vertex, const WindSettings& settings,
                  const WindNow& now)
{
    glm::dvec3 p = zUp(place.position);
    const glm::dvec3 n = zUp(place.normal), wind = now.strength * zUp(now.direction);
    const double phase = vertex.phase, edge = waves(now.seconds + (p.x + p.y + p.z) * phase, edgeRates),
                 branch = waves(now.seconds + phase, branchRates);
    p += now.strength *
         glm::dvec3(edge * vertex.flutter * n.x, edge * vertex.flutter * n.y, branch * vertex.sway);
    const double length = glm::length(p), bend = 1.0 + p.z * settings.bendScale, squared = bend * bend;
    const double factor = squared * squared - squared;
    const glm::dvec3 bent(p.x + factor * wind.x, p.y + factor * wind.y, p.z);
    if (glm::length(bent) > 0.0)
        p = bent * (length / glm::length(bent));
    return {p.x, p.z, -p.y};
}

/// Unity is left-handed: readers of glTF turn X round.
glm::dvec3 mirrored(const glm::dvec3& v)
{
    return {-v.x, v.y, v.z};
}

glm::dvec3 unity(const WindPlace& place, const WindVertex& vertex, const WindNow& now)
{
    constexpr double detailAmp = 0.1, branchAmp = 0.3;
    const glm::dvec3 p = mirrored(place.position), n = mirrored(place.normal),
                     wind = now.strength * mirrored(now.direction);
    const double flutter = std::min(double(vertex.flutter) / detailAmp, 1.0), phase = vertex.phase;
    const double edge = waves(now.seconds + (p.x + p.y + p.z) * (flutter + phase), edgeRates),
                 branch = waves(now.seconds + phase, branchRates);
    glm::dvec3 bend = flutter * detailAmp * n;
    bend.y = vertex.sway * branchAmp;
    const glm::dvec3 detail(edge * bend.x, branch * bend.y, edge * bend.z);
    return mirrored(p + now.strength * (detail + branch * double(vertex.sway) * wind) +
                    double(vertex.lean) * wind);
}

/// Unreal has Z up, is left-handed and counts centimetres; formulas are the same in either hand.
glm::dvec3 unreal(const glm::dvec3& v)
{
    return {v.x, v.z, v.y};
}

/// How far one element takes a place of its own or of what stands on it, cm. \p p from the pivot.
glm::dvec3 turnedBy(const WindElement& element, const glm::dvec3& p, const WindNow& now,
                    const PivotMotion& motion)
{
    const glm::dvec3 axis = unreal(element.axis), wind = unreal(now.direction), across(-wind.y, wind.x, 0.0);
    const double extent = 100.0 * element.extent, along = glm::dot(wind, axis);
    const glm::dvec3 tip = 100.0 * unreal(element.pivot) + extent * axis;
    const double gust = gustAt(now.seconds * motion.speed + glm::dot(wind, tip) / motion.worldScale,
                               now.seconds * motion.across + glm::dot(across, tip) / motion.worldScale);
    const double share = std::clamp(glm::dot(p, axis) / (motion.falloff * extent), 0.0, 1.0);
    const double angle = wholeTurn * now.strength * motion.turns[element.depth] * (motion.gustOffset + gust) *
                         (along + motion.shelterBias) * motion.shelterScale * share;
    const double ahead = std::max(0.0, along);
    const glm::dvec3 down(0.0, 0.0, -0.2 * ahead * ahead * ahead * ahead * ahead);
    const glm::dvec3 about = glm::cross(axis, wind + down);
    if (glm::length(about) < 1e-3) // against the wind: neither way
        return glm::dvec3(0.0);
    const glm::dvec3 unit = glm::normalize(about), on = glm::dot(unit, p) * unit, from = p - on;
    const maths::SinCos turn = maths::sincos(angle);
    return turn.cos * from + turn.sin * glm::cross(unit, from) - from;
}

glm::dvec3 pivotPainter(const WindPlace& place, const WindVertex& vertex, const WindElements& elements,
                        const WindNow& now, const PivotMotion& motion)
{
    glm::dvec3 offset(0.0);
    for (Index at = vertex.element;;) {
        const WindElement& element = elements.elements[at];
        offset += turnedBy(element, 100.0 * unreal(place.position - element.pivot), now, motion);
        if (element.parent == at)
            break;
        at = element.parent;
    }
    return place.position + 0.01 * unreal(offset);
}

} // namespace

double gustAt(double u, double v)
{
    return 0.5 + 0.25 * (maths::sin(wholeTurn * u) + maths::sin(wholeTurn * v));
}

glm::dvec3 windPreview(WindProfile profile, const WindPlace& place, const WindVertex& vertex,
                       const WindSettings& settings, const WindElements& elements, const WindNow& now,
                       const PivotMotion& motion)
{
    switch (profile) {
    case WindProfile::Crysis:
        return crysis(place, vertex, settings, now);
    case WindProfile::Unity:
        return unity(place, vertex, now);
    case WindProfile::PivotPainter:
        return pivotPainter(place, vertex, elements, now, motion);
    case WindProfile::None:
    case WindProfile::Plain:
        break;
    }
    return plain(place, vertex, now);
}

} // namespace ramure
