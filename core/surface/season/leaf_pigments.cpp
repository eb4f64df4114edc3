#include "core/surface/season/leaf_pigments.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr double plates = 1.5;

/// What the model knows of one wavelength. Optical constants: J.-B. Féret, S. Jacquemoud, C. François,
/// F. de Boissieu and others, data of PROSPECT-D and PROSPECT-PRO (MIT licence), every 10 nm.
struct Wavelength
{
    double inward;        ///< share of light within 40° of the normal that enters the leaf
    double inwardDiffuse; ///< the same of diffuse light (Stern 1964, Allen 1973)
    double refraction;
    double chlorophyll, carotenoids, anthocyanin, brown; ///< absorption by each, per amount
    double matter;                                       ///< absorption by water and dry matter
    glm::dvec3 seen; ///< X, Y, Z of the light of D65 there; all of them make white with Y = 1
};

/// 400 to 720 nm.
// clang-format off
constexpr std::array<Wavelength, 33> wavelengths{{
    {0.9569, 0.9065, 1.5115, 0.06488, 0.1673, 0.06667, 0.5272, 0.9873, {0.00112, 0.00003, 0.00531}},
    {0.9574, 0.907, 1.5081, 0.07149, 0.1659, 0.05095, 0.5172, 0.567, {0.00377, 0.0001, 0.01796}},
    {0.958, 0.9078, 1.5032, 0.06982, 0.1672, 0.04543, 0.5072, 0.321, {0.01188, 0.00035, 0.05708}},
    {0.9584, 0.9082, 1.5002, 0.07245, 0.1676, 0.04386, 0.4972, 0.1822, {0.02329, 0.00095, 0.11366}},
    {0.9587, 0.9085, 1.498, 0.07379, 0.1696, 0.04479, 0.4852, 0.09864, {0.03456, 0.00228, 0.17337}},
    {0.959, 0.9089, 1.4955, 0.05877, 0.1674, 0.04641, 0.4733, 0.05994, {0.03723, 0.00421, 0.19622}},
    {0.9592, 0.9091, 1.4937, 0.04387, 0.1517, 0.04884, 0.4608, 0.04118, {0.03242, 0.00669, 0.18609}},
    {0.9594, 0.9094, 1.4923, 0.03973, 0.137, 0.05194, 0.4504, 0.03116, {0.02123, 0.00989, 0.13996}},
    {0.9596, 0.9095, 1.491, 0.03678, 0.1333, 0.05715, 0.4401, 0.02523, {0.01049, 0.01525, 0.08918}},
    {0.9598, 0.9098, 1.4896, 0.02966, 0.1207, 0.06292, 0.4272, 0.02316, {0.0033, 0.02142, 0.0479}},
    {0.96, 0.91, 1.488, 0.01905, 0.099, 0.06777, 0.4144, 0.02176, {0.00051, 0.03343, 0.02815}},
    {0.9602, 0.9103, 1.4861, 0.009701, 0.07595, 0.07047, 0.4057, 0.02096, {0.00095, 0.05131, 0.01614}},
    {0.9605, 0.9106, 1.4836, 0.004334, 0.05321, 0.07168, 0.3962, 0.0207, {0.00627, 0.07041, 0.00776}},
    {0.9609, 0.9111, 1.4807, 0.004069, 0.03252, 0.07235, 0.3867, 0.0207, {0.01687, 0.08784, 0.0043}},
    {0.9613, 0.9116, 1.4774, 0.006786, 0.0156, 0.07206, 0.3654, 0.0207, {0.02869, 0.09426, 0.00201}},
    {0.9618, 0.9121, 1.4739, 0.009309, 0.004189, 0.06814, 0.3511, 0.02071, {0.04268, 0.09796, 0.00086}},
    {0.9623, 0.9126, 1.4701, 0.01105, 0, 0.05965, 0.3401, 0.02071, {0.05626, 0.09416, 0.00037}},
    {0.9628, 0.9132, 1.4662, 0.0136, 0, 0.04848, 0.3223, 0.02071, {0.06948, 0.08679, 0.00019}},
    {0.9632, 0.9138, 1.4624, 0.01695, 0, 0.03741, 0.3019, 0.02071, {0.08306, 0.07886, 0.00015}},
    {0.9637, 0.9143, 1.4588, 0.01942, 0, 0.0268, 0.2821, 0.02071, {0.08613, 0.06353, 0.00009}},
    {0.9641, 0.9148, 1.4559, 0.02085, 0, 0.01874, 0.2636, 0.02072, {0.09047, 0.05375, 0.00007}},
    {0.9644, 0.9151, 1.4533, 0.02318, 0, 0.0128, 0.2463, 0.02073, {0.08501, 0.04265, 0.00003}},
    {0.9647, 0.9155, 1.451, 0.02653, 0, 0.008411, 0.2302, 0.02073, {0.07091, 0.03162, 0.00002}},
    {0.9649, 0.9158, 1.4492, 0.02798, 0, 0.005398, 0.2156, 0.02073, {0.05063, 0.02089, 0}},
    {0.9651, 0.9159, 1.448, 0.03125, 0, 0.003453, 0.202, 0.02073, {0.03548, 0.01386, 0}},
    {0.9651, 0.916, 1.4473, 0.03901, 0, 0.002252, 0.189, 0.02073, {0.02147, 0.0081, 0}},
    {0.9652, 0.9161, 1.4468, 0.04749, 0, 0.001471, 0.1768, 0.02074, {0.01252, 0.00463, 0}},
    {0.9653, 0.9162, 1.4464, 0.06611, 0, 0.0007848, 0.1641, 0.02074, {0.00681, 0.00249, 0}},
    {0.9653, 0.9163, 1.4458, 0.06892, 0, 0.0002011, 0.1504, 0.02074, {0.00346, 0.00126, 0}},
    {0.9654, 0.9164, 1.4451, 0.03367, 0, 0, 0.137, 0.02075, {0.0015, 0.00054, 0}},
    {0.9655, 0.9165, 1.4444, 0.01224, 0, 0, 0.1245, 0.02076, {0.00077, 0.00028, 0}},
    {0.9656, 0.9166, 1.4433, 0.005421, 0, 0, 0.1133, 0.02077, {0.00041, 0.00015, 0}},
    {0.9658, 0.9169, 1.4417, 0.002643, 0, 0, 0.1024, 0.02081, {0.00017, 0.00006, 0}},
}};
// clang-format on

/// The integral of exp(-t) / t from x to infinity (Abramowitz, Stegun 1964, 5.1.53 and 5.1.56), to 2e-7.
double exponentialIntegral(double x)
{
    if (x <= 1.0)
        return -maths::log(x) - 0.57721566 +
               x * (0.99999193 + x * (-0.24991055 + x * (0.05519968 + x * (-0.00976004 + x * 0.00107857))));
    const double above = 0.2677737343 + x * (8.6347608925 + x * (18.059016973 + x * (8.5733287401 + x)));
    const double below = 3.9584969228 + x * (21.0996530827 + x * (25.6329561486 + x * (9.5733223454 + x)));
    return maths::exp(-x) * above / (x * below);
}

/// Light that a surface of the leaf, or a pile of plates, throws back and lets through.
struct Shares
{
    double back, through;
};

/// The light that enters goes to and fro inside. \param inward the share that enters from outside
Shares plate(const Wavelength& at, double inward, double inside)
{
    const double outward = at.inwardDiffuse / (at.refraction * at.refraction), kept = 1.0 - outward;
    const double through = inward * inside * outward / (1.0 - kept * kept * inside * inside);
    return {1.0 - inward + kept * inside * through, through};
}

/// So many equal plates on each other (Stokes 1862), also where their number is no integer.
Shares pile(const Shares& one, double count)
{
    const double r = one.back, t = one.through;
    if (r + t >= 1.0) {
        const double through = t / (t + (1.0 - t) * count);
        return {1.0 - through, through};
    }
    const double d = std::sqrt((1.0 + r + t) * (1.0 + r - t) * (1.0 - r + t) * (1.0 - r - t));
    const double a = (1.0 + r * r - t * t + d) / (2.0 * r), b = (1.0 - r * r + t * t + d) / (2.0 * t);
    const double power = maths::pow(b, count), divisor = a * a * power * power - 1.0;
    return {a * (power * power - 1.0) / divisor, power * (a * a - 1.0) / divisor};
}

Shares sharesOf(const Wavelength& at, const Pigments& pigments)
{
    const double absorbed = (pigments.chlorophyll * at.chlorophyll + pigments.carotenoids * at.carotenoids +
                             pigments.anthocyanin * at.anthocyanin + pigments.brown * at.brown + at.matter) /
                            plates;
    const double inside =
        (1.0 - absorbed) * maths::exp(-absorbed) + absorbed * absorbed * exponentialIntegral(absorbed);
    // The first plate is lit from above, those below it from everywhere.
    const Shares first = plate(at, at.inward, inside), other = plate(at, at.inwardDiffuse, inside);
    const Shares below = pile(other, plates - 1.0);
    const double fro = 1.0 - below.back * other.back;
    return {first.back + first.through * below.back * other.through / fro,
            first.through * below.through / fro};
}

float toSrgb(double light)
{
    const double c = std::clamp(light, 0.0, 1.0);
    return static_cast<float>(255.0 *
                              (c <= 0.0031308 ? 12.92 * c : 1.055 * maths::pow(c, 1.0 / 2.4) - 0.055));
}

glm::vec3 toSrgb(const glm::dvec3& seen)
{
    const auto [x, y, z] = std::array{seen.x, seen.y, seen.z};
    return {toSrgb(3.2406 * x - 1.5372 * y - 0.4986 * z), toSrgb(-0.9689 * x + 1.8758 * y + 0.0415 * z),
            toSrgb(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

float amount(float wanted, float most)
{
    return wanted > 0.0F ? std::min(wanted, most) : 0.0F; // what is no number is not above 0
}

} // namespace

Pigments mix(const Pigments& from, const Pigments& to, float share)
{
    const auto between = [share](float a, float b) { return a + share * (b - a); };
    return {between(from.chlorophyll, to.chlorophyll), between(from.carotenoids, to.carotenoids),
            between(from.anthocyanin, to.anthocyanin), between(from.brown, to.brown)};
}

LeafColours photographed(const LeafColours& colours)
{
    constexpr double exposure = 2.75, kept = 0.4; // of the sheen
    const auto light = [](const glm::vec3& srgb) {
        glm::dvec3 out;
        for (int i = 0; i < 3; ++i) {
            const double c = double(srgb[i]) / 255.0;
            out[i] = c <= 0.04045 ? c / 12.92 : maths::pow((c + 0.055) / 1.055, 2.4);
        }
        return out;
    };
    const glm::dvec3 within =
        glm::max(light(colours.reflected) - (1.0 - kept) * glm::dvec3(surfaceSheen), glm::dvec3(0.0));
    const double bright = glm::dot(within, glm::dvec3(0.2126, 0.7152, 0.0722));
    // Film saturates: what is bright gains less.
    const double gain = bright > 1e-6 ? (1.0 - maths::exp(-exposure * bright)) / bright : exposure;
    const auto shown = [gain](const glm::dvec3& linear) {
        return glm::vec3(toSrgb(gain * linear.r), toSrgb(gain * linear.g), toSrgb(gain * linear.b));
    };
    return {shown(within), shown(light(colours.transmitted))};
}

LeafColours pigmentColours(const Pigments& pigments)
{
    const Pigments held{amount(pigments.chlorophyll, 150.0F), amount(pigments.carotenoids, 25.0F),
                        amount(pigments.anthocyanin, 50.0F), amount(pigments.brown, 4.0F)};
    glm::dvec3 back(0.0), through(0.0);
    for (const Wavelength& at : wavelengths) {
        const Shares shares = sharesOf(at, held);
        back += shares.back * at.seen;
        through += shares.through * at.seen;
    }
    return {toSrgb(back), toSrgb(through)};
}

} // namespace ramure
