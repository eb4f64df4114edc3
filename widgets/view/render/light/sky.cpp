#include "widgets/view/render/light/sky.h"

#include "core/math/angle.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace ramure {
namespace {

constexpr double lowest = 0.01; ///< sine of the height at which the formula still holds

using Basis = std::array<double, 9>;

Basis basisAt(const glm::dvec3& n)
{
    return {
        1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.y * n.y - 1.0, n.x * n.z, n.z * n.z - n.x * n.x};
}

/// Squares of the harmonics' factors times what a cosine keeps of each band, over pi.
constexpr Basis weights = [] {
    constexpr double constant = 1.0 / (4.0 * pi);
    constexpr double linear = 2.0 / 3.0 * 3.0 / (4.0 * pi);
    constexpr double product = 0.25 * 15.0 / (4.0 * pi);
    constexpr double upright = 0.25 * 5.0 / (16.0 * pi);
    constexpr double level = 0.25 * 15.0 / (16.0 * pi);
    return Basis{constant, linear, linear, linear, product, product, upright, product, level};
}();

glm::dvec3 perez(const Sky& sky, double cosine, double angle)
{
    const double across = std::cos(angle);
    return (1.0 + sky.a * glm::exp(sky.b / cosine)) *
           (1.0 + sky.c * glm::exp(sky.d * angle) + sky.e * (across * across));
}

/// A film for daylight: the white of D55, what the sun and a clear sky give together, is shown as white.
constexpr glm::dvec3 daylight{1.0 / 1.104, 1.0 / 0.987, 1.0 / 0.823};

/// CIE 1931 Y, x, y to linear sRGB (IEC 61966-2-1). The formula's horizons come out purple: no sky lies below
/// the line of the phases of daylight (CIE 15).
glm::dvec3 linearRgb(const glm::dvec3& colour)
{
    const double tint = std::max(colour.z, colour.y * (2.870 - 3.000 * colour.y) - 0.275);
    const double y = colour.x, x = y * colour.y / tint, z = y * (1.0 - colour.y - tint) / tint;
    return daylight *
           glm::max(glm::dvec3(3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
                               0.0557 * x - 0.2040 * y + 1.0570 * z),
                    glm::dvec3(0.0));
}

/// Y (kcd/m²), x and y straight above. \param angle of the sun from the zenith, rad
glm::dvec3 zenith(double t, double angle)
{
    const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * angle);
    const glm::dvec4 powers(angle * angle * angle, angle * angle, angle, 1.0);
    const auto chromaticity = [&](const glm::dvec4& square, const glm::dvec4& first, const glm::dvec4& rest) {
        return t * t * glm::dot(square, powers) + t * glm::dot(first, powers) + glm::dot(rest, powers);
    };
    return {std::max((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, 0.05),
            chromaticity({0.00166, -0.00375, 0.00209, 0.0}, {-0.02903, 0.06377, -0.03202, 0.00394},
                         {0.11693, -0.21196, 0.06052, 0.25886}),
            chromaticity({0.00275, -0.00610, 0.00317, 0.0}, {-0.04214, 0.08970, -0.04153, 0.00516},
                         {0.15346, -0.26756, 0.06670, 0.26688})};
}

/// What is left of the sun's light behind molecules, dust and ozone, at one wavelength for each colour.
glm::dvec3 sunlightThrough(double t, double angle)
{
    constexpr double outside = 133.3;                                          // klx
    const glm::dvec3 wavelength(0.65, 0.55, 0.45), ozone(0.058, 0.085, 0.003); // µm; 1/cm
    const double way = 1.0 / (std::cos(angle) + 0.15 * std::pow(93.885 - angle * 180.0 / pi, -1.253));
    const double dust = 0.04608 * t - 0.04586;
    const glm::dvec3 lost = 0.008735 * glm::pow(wavelength, glm::dvec3(-4.08)) +
                            dust * glm::pow(wavelength, glm::dvec3(-1.3)) + 0.35 * ozone;
    return outside * daylight * glm::exp(-way * lost);
}

} // namespace

glm::dvec3 Sky::radiance(const glm::dvec3& direction) const
{
    const double angle = std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0));
    return linearRgb(scale * perez(*this, std::max(direction.y, lowest), angle));
}

Sky clearSky(const glm::dvec3& sun, double t)
{
    Sky sky;
    sky.sun = sun;
    sky.a = {0.1787 * t - 1.4630, -0.0193 * t - 0.2592, -0.0167 * t - 0.2608};
    sky.b = {-0.3554 * t + 0.4275, -0.0665 * t + 0.0008, -0.0950 * t + 0.0092};
    sky.c = {-0.0227 * t + 5.3251, -0.0004 * t + 0.2125, -0.0079 * t + 0.2102};
    sky.d = {0.1206 * t - 2.5771, -0.0641 * t - 0.8989, -0.0441 * t - 1.6537};
    sky.e = {-0.0670 * t + 0.3703, -0.0033 * t + 0.0452, -0.0109 * t + 0.0529};
    const double angle = std::acos(std::clamp(sun.y, lowest, 1.0));
    sky.scale = zenith(t, angle) / perez(sky, 1.0, angle);
    sky.sunlight = sunlightThrough(t, angle);
    return sky;
}

Ambient ambientOf(const std::function<glm::dvec3(const glm::dvec3&)>& radiance)
{
    constexpr int rings = 32, spokes = 48;
    std::array<glm::dvec3, 9> sums{};
    for (int ring = 0; ring < rings; ++ring) {
        const double y = (ring + 0.5) * 2.0 / rings - 1.0, out = std::sqrt(1.0 - y * y);
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double turn = 2.0 * pi * (spoke + 0.5) / spokes;
            const glm::dvec3 direction(out * std::cos(turn), y, out * std::sin(turn));
            const glm::dvec3 light = radiance(direction);
            const Basis basis = basisAt(direction);
            for (std::size_t i = 0; i < basis.size(); ++i)
                sums[i] += basis[i] * light;
        }
    }
    Ambient ambient;
    for (std::size_t i = 0; i < ambient.size(); ++i)
        ambient[i] = glm::vec3(weights[i] * 4.0 * pi / (rings * spokes) * sums[i]);
    return ambient;
}

Ambient ambientOf(const Sky& sky, const glm::dvec3& ground)
{
    return ambientOf([&](const glm::dvec3& way) { return way.y > 0.0 ? sky.radiance(way) : ground; });
}

Ambient ambientOf(const glm::vec3& above, const glm::vec3& below)
{
    return {0.5f * (above + below), 0.5f * (above - below)};
}

glm::vec3 ambientAt(const Ambient& ambient, const glm::vec3& normal)
{
    const Basis basis = basisAt(normal);
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < basis.size(); ++i)
        sum += float(basis[i]) * ambient[i];
    return glm::max(sum, glm::vec3(0.0f));
}

} // namespace ramure
