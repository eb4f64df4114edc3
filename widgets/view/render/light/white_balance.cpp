#include "widgets/view/render/light/white_balance.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace ramure {
namespace {

constexpr glm::dvec3 luminance{0.2126, 0.7152, 0.0722};

double cubic(double a, double b, double c, double d, double x)
{
    return ((a * x + b) * x + c) * x + d;
}

/// Linear sRGB of luminance 1.
glm::dvec3 blackBody(double kelvin)
{
    const double inverse = 1e3 / kelvin;
    const double x = kelvin < 4000.0 ? cubic(-0.2661239, -0.2343589, 0.8776956, 0.179910, inverse)
                                     : cubic(-3.0258469, 2.1070379, 0.2226347, 0.240390, inverse);
    const double y = kelvin < 4000.0 ? cubic(-0.9549476, -1.37418593, 2.09137015, -0.16748867, x)
                                     : cubic(3.0817580, -5.87338670, 3.75112997, -0.37001483, x);
    const glm::dvec3 xyz{x / y, 1.0, (1.0 - x - y) / y};
    const glm::dmat3 toLinear{
        {3.2406, -0.9689, 0.0557}, {-1.5372, 1.8758, -0.2040}, {-0.4986, 0.0415, 1.0570}};
    return toLinear * xyz;
}

} // namespace

glm::dvec3 whiteBalance(double kelvin)
{
    const glm::dvec3 factors = blackBody(usualKelvin) / blackBody(kelvin);
    return factors / glm::dot(factors, luminance);
}

} // namespace ramure
