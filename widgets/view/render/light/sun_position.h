/// \file
/// Where the sun stands at a place and a moment: Michalsky, "The Astronomical Almanac's algorithm for
/// approximate solar position (1950-2050)", Solar Energy 40 (1988), to about 0.01 degrees; the air bends
/// nothing.
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
