#include "core/generators/weber_penn/stem_course.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {
namespace {

/// Of length 1, in the plane of a frame's normal and binormal.
glm::dvec2 inPlane(double azimuth)
{
    const auto [sine, cosine] = maths::sincos(azimuth);
    return {cosine, sine};
}

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    const auto [sine, cosine] = maths::sincos(angle);
    return cosine * v + sine * glm::cross(axis, v) + (1.0 - cosine) * glm::dot(axis, v) * axis;
}

} // namespace

StemCourse::StemCourse(const WeberPennParams& params, std::uint64_t seed, const Stem& stem, double length)
    : m_level(params.level[stem.level])
    , m_attraction(stem.level > 1 ? params.attractionUp : 0.0)
    , m_floor(stem.level == 1 && params.clearance > 0.0 ? params.clearance
                                                        : -std::numeric_limits<double>::infinity())
    , m_seed(seed)
    , m_address(stem.own)
    , m_length(length)
    , m_away(inPlane(stem.azimuth))
    , m_position(stem.foot)
    , m_frame(stem.frame)
    , m_tangent(stem.frame.tangent)
    , m_helix(turned(m_tangent,
                     glm::cross(m_tangent, m_away.x * m_frame.normal + m_away.y * m_frame.binormal),
                     std::abs(m_level.curveV)))
    , m_at(stem.begin)
{
    if (stem.splitAngle != 0.0)
        split(stem.splitAngle, stem.splitAzimuth);
}

void StemCourse::turn(const glm::dvec2& by)
{
    const double angle = glm::length(by);
    if (angle == 0.0)
        return;
    const auto [sine, cosine] = maths::sincos(angle);
    const glm::dvec3 aside = (by.x * m_frame.normal + by.y * m_frame.binormal) / angle;
    m_tangent = glm::normalize(cosine * m_frame.tangent + sine * aside);
}

void StemCourse::split(double angle, double azimuth)
{
    const glm::dvec2 by = angle * inPlane(azimuth);
    turn(by);
    m_frame = transported(m_frame, m_tangent);
    m_back = -by / std::max(m_length - m_at, 1e-9);
    m_before = 0.0;
}

void StemCourse::attract(double step)
{
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const glm::dvec3 axis = glm::cross(m_tangent, up);
    const double sine = glm::length(axis);
    if (m_attraction == 0.0 || sine < 1e-6)
        return;
    const double declination = maths::atan2(sine, m_tangent.y);
    const double wanted = m_attraction * declination * sine * step / m_length;
    m_tangent = glm::normalize(
        turned(m_tangent, axis / sine, std::clamp(wanted, declination - std::numbers::pi, declination)));
}

void StemCourse::level(double next)
{
    // It comes down to the floor ever more slowly, as a limb that its own shade lifts.
    const double lowest = -std::max(m_position.y - m_floor, 0.0) / std::max(next, 0.3 * m_length);
    if (m_tangent.y >= lowest)
        return;
    glm::dvec3 ahead(m_tangent.x, 0.0, m_tangent.z);
    if (glm::length(ahead) < 1e-6)
        ahead = {m_frame.normal.x, 0.0, m_frame.normal.z};
    if (glm::length(ahead) < 1e-6)
        ahead = {m_frame.binormal.x, 0.0, m_frame.binormal.z};
    const double down = std::max(lowest, -1.0);
    m_tangent = std::sqrt(1.0 - down * down) * glm::normalize(ahead) + glm::dvec3(0.0, down, 0.0);
}

void StemCourse::bend(double next)
{
    const double half = 0.5 * m_length;
    const auto pieces = static_cast<double>(m_level.curveRes);
    const double middle = m_at - 0.5 * m_before;
    const int segment = static_cast<int>(std::min(middle / m_length * pieces, pieces - 1.0));
    if (segment != m_segment) {
        Random random(m_seed, RandomStream::Stems, mixBits(m_address + std::uint64_t(segment) + 1));
        const double most = std::max(m_level.curveV, 0.0) / m_length;
        m_crooked = most * random.range(-1.0, 1.0);
        m_aside = 0.5 * most * random.range(-1.0, 1.0);
        m_segment = segment;
    }
    double curve = m_level.curve / m_length;
    if (m_level.curveBack != 0.0)
        curve = (middle < half ? m_level.curve : m_level.curveBack) / half;
    const glm::dvec2 across(-m_away.y, m_away.x);
    turn(m_before * ((curve + m_crooked) * m_away + m_aside * across + m_back));
    if (m_level.curveV < 0.0)
        m_tangent = glm::normalize(turned(m_tangent, m_helix, 2.0 * std::numbers::pi * m_before / m_length));
    attract(m_before);
    level(next);
    m_frame = transported(m_frame, m_tangent);
}

void StemCourse::advance(double step)
{
    if (m_before > 0.0)
        bend(step);
    m_position += step * m_frame.tangent;
    m_at += step;
    m_before = step;
}

} // namespace ramure
