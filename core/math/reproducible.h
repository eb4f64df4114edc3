/// \file
/// Sine, exponential and the like that give the same bits on every processor. The functions of the C library
/// do not: with and without fused multiply-add they differ in the last digit, and a tree grown from such
/// numbers is another file. All code in core whose result reaches a file or a decision calls these
/// (tst_layers checks it). Square roots, remainders and roundings are exact everywhere and stay those of std.
#pragma once

#include <glm/gtc/quaternion.hpp>

/// Angles are in radians. Invalid arguments give the results of std; errors are at most one unit in the last
/// place.
namespace ramure::maths {

struct SinCos
{
    double sin, cos;
};

double sin(double angle);
double cos(double angle);
/// Returns both in the time of one; their last digits may differ from those of sin() and cos().
SinCos sincos(double angle);
double tan(double angle);
double asin(double sine);
double acos(double cosine);
double atan2(double y, double x);
double exp(double x);
double exp2(double x);
double log(double x);
double pow(double base, double exponent);
double hypot(double x, double y);

/// The rotation by \p angle about a unit vector.
glm::dquat angleAxis(double angle, const glm::dvec3& axis);

} // namespace ramure::maths
