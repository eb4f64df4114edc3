#include "widgets/view/render/light/sun_position.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace ramure {

SunPosition sunPosition(double secondsSince1970, double latitudeDeg, double longitudeDeg)
{
    const double days = secondsSince1970 / 86400.0 - 10957.5; // since noon of the first day of 2000
    const double anomaly = glm::radians(357.528 + 0.9856003 * days);
    const double longitude = glm::radians(280.460 + 0.9856474 * days + 1.915 * std::sin(anomaly) +
                                          0.020 * std::sin(2.0 * anomaly)); // on the ecliptic
    const double obliquity = glm::radians(23.439 - 0.0000004 * days);
    const double ascension = std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
    const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));
    const double hours = std::fmod(secondsSince1970 / 3600.0, 24.0);
    const double sidereal = 6.697375 + 0.0657098242 * days + hours; // in Greenwich, h
    const double angle = glm::radians(15.0 * sidereal + longitudeDeg) - ascension;
    const double latitude = glm::radians(latitudeDeg);
    const double height = std::sin(declination) * std::sin(latitude) +
                          std::cos(declination) * std::cos(latitude) * std::cos(angle);
    const double east = -std::cos(declination) * std::sin(angle);
    const double north = std::sin(declination) * std::cos(latitude) -
                         std::cos(declination) * std::sin(latitude) * std::cos(angle);
    const double azimuth = glm::degrees(std::atan2(east, north));
    return {azimuth < 0.0 ? azimuth + 360.0 : azimuth,
            glm::degrees(std::asin(std::clamp(height, -1.0, 1.0)))};
}

} // namespace ramure
