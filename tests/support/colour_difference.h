/// \file
/// How different two colours look: CIEDE2000, beside the white of D65.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace ramure::test {

/// \param light linear sRGB, 0..1. Returns L*, a*, b*.
inline glm::dvec3 labOfLight(const glm::dvec3& light)
{
    const auto root = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = root((0.4124 * light.r + 0.3576 * light.g + 0.1805 * light.b) / 0.95047),
                 y = root(0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b),
                 z = root((0.0193 * light.r + 0.1192 * light.g + 0.9505 * light.b) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// \param srgb 0..255
inline glm::dvec3 labOf(const glm::dvec3& srgb)
{
    const auto light = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return labOfLight({light(srgb.r / 255.0), light(srgb.g / 255.0), light(srgb.b / 255.0)});
}

/// Sharma, Wu, Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test data,
/// and mathematical observations", 2005. \param one and \param other are L*, a*, b*.
inline double deltaE00(const glm::dvec3& one, const glm::dvec3& other)
{
    constexpr double degree = 3.14159265358979323846 / 180.0;
    const auto seventh = [](double c) {
        return std::sqrt(std::pow(c, 7.0) / (std::pow(c, 7.0) + std::pow(25.0, 7.0)));
    };
    const double meanChroma = 0.5 * (std::hypot(one.y, one.z) + std::hypot(other.y, other.z));
    const double wider = 1.0 + 0.5 * (1.0 - seventh(meanChroma));
    const double a1 = wider * one.y, a2 = wider * other.y;
    const double c1 = std::hypot(a1, one.z), c2 = std::hypot(a2, other.z);
    const auto hue = [](double a, double b) { return std::fmod(std::atan2(b, a) / degree + 360.0, 360.0); };
    const double h1 = hue(a1, one.z), h2 = hue(a2, other.z);
    double turn = h2 - h1, h = 0.5 * (h1 + h2);
    if (c1 * c2 == 0.0) {
        turn = 0.0;
        h = h1 + h2;
    } else if (std::abs(turn) > 180.0) {
        turn += turn > 0.0 ? -360.0 : 360.0;
        h += h < 180.0 ? 180.0 : -180.0;
    }
    const double l = 0.5 * (one.x + other.x) - 50.0, c = 0.5 * (c1 + c2);
    const double t = 1.0 - 0.17 * std::cos((h - 30.0) * degree) + 0.24 * std::cos(2.0 * h * degree) +
                     0.32 * std::cos((3.0 * h + 6.0) * degree) - 0.20 * std::cos((4.0 * h - 63.0) * degree);
    const double lightness = (other.x - one.x) / (1.0 + 0.015 * l * l / std::sqrt(20.0 + l * l));
    const double chroma = (c2 - c1) / (1.0 + 0.045 * c);
    const double hues = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * turn * degree) / (1.0 + 0.015 * c * t);
    const double blue = 60.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2.0));
    const double rotated = -2.0 * seventh(c) * std::sin(blue * degree);
    return std::sqrt(lightness * lightness + chroma * chroma + hues * hues + rotated * chroma * hues);
}

} // namespace ramure::test
