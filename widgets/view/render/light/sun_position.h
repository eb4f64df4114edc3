/// \file
/// Computes the position of the sun at a place and a moment, to about 0.01 degrees and without refraction:
/// Michalsky, "The Astronomical Almanac's algorithm for approximate solar position (1950-2050)", Solar Energy
/// 40 (1988).
#pragma once

namespace ramure {

struct SunPosition
{
    double azimuthDeg = 0.0; ///< clockwise from the north, 0 .. 360
    double heightDeg = 0.0;  ///< over the horizon; below it negative
};

/// \param secondsSince1970 UTC, as QDateTime::toSecsSinceEpoch \param latitudeDeg north positive
/// \param longitudeDeg east positive
SunPosition sunPosition(double secondsSince1970, double latitudeDeg, double longitudeDeg);

} // namespace ramure
