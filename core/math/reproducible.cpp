#include "core/math/reproducible.h"

#include <sleef.h>

// Of SLEEF's functions those marked cinz (no fused operations, whatever the processor) are reproducible;
// purec are the plain ones for one number, u10 stands for an error of at most 1.0 units in the last place.
namespace ramure::maths {

double sin(double angle)
{
    return Sleef_cinz_sind1_u10purec(angle);
}

double cos(double angle)
{
    return Sleef_cinz_cosd1_u10purec(angle);
}

SinCos sincos(double angle)
{
    const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(angle);
    return {both.x, both.y};
}

double tan(double angle)
{
    return Sleef_cinz_tand1_u10purec(angle);
}

double asin(double sine)
{
    return Sleef_cinz_asind1_u10purec(sine);
}

double acos(double cosine)
{
    return Sleef_cinz_acosd1_u10purec(cosine);
}

double atan2(double y, double x)
{
    return Sleef_cinz_atan2d1_u10purec(y, x);
}

double exp(double x)
{
    return Sleef_cinz_expd1_u10purec(x);
}

double exp2(double x)
{
    return Sleef_cinz_exp2d1_u10purec(x);
}

double log(double x)
{
    return Sleef_cinz_logd1_u10purec(x);
}

double pow(double base, double exponent)
{
    return Sleef_cinz_powd1_u10purec(base, exponent);
}

double hypot(double x, double y)
{
    return Sleef_cinz_hypotd1_u05purec(x, y);
}

glm::dquat angleAxis(double angle, const glm::dvec3& axis)
{
    const auto [sine, cosine] = sincos(0.5 * angle);
    return {cosine, sine * axis};
}

} // namespace ramure::maths
