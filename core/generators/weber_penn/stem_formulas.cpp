#include "core/generators/weber_penn/stem_formulas.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

double flame(double ratio)
{
    return ratio <= 0.7 ? ratio / 0.7 : (1.0 - ratio) / 0.3;
}

} // namespace

double envelopeRatio(const WeberPennParams& params, double ratio)
{
    if (ratio < 0.0 || ratio > 1.0)
        return 0.0;
    const double above = 1.0 - params.pruneWidthPeak;
    if (ratio < above)
        return maths::pow(ratio / above, params.prunePowerHigh);
    return params.pruneWidthPeak > 0.0
               ? maths::pow((1.0 - ratio) / params.pruneWidthPeak, params.prunePowerLow)
               : 1.0;
}

double shapeRatio(const WeberPennParams& params, CrownShape shape, double ratio)
{
    switch (shape) {
    case CrownShape::Conical:
        return 0.2 + 0.8 * ratio;
    case CrownShape::Spherical:
        return 0.2 + 0.8 * maths::sin(pi * ratio);
    case CrownShape::Hemispherical:
        return 0.2 + 0.8 * maths::sin(0.5 * pi * ratio);
    case CrownShape::Cylindrical:
        return 1.0;
    case CrownShape::TaperedCylindrical:
        return 0.5 + 0.5 * ratio;
    case CrownShape::Flame:
        return flame(ratio);
    case CrownShape::InverseConical:
        return 1.0 - 0.8 * ratio;
    case CrownShape::TendFlame:
        return 0.5 + 0.5 * flame(ratio);
    case CrownShape::Envelope:
        return envelopeRatio(params, ratio);
    }
    return 1.0;
}

double stemLength(const WeberPennParams& params, std::size_t level, double share, double parentLength,
                  double offset, double base)
{
    if (level > 1)
        return share * (parentLength - 0.6 * offset);
    const double ratio = (parentLength - offset) / (parentLength - base);
    return parentLength * share * shapeRatio(params, params.shape, ratio);
}

double stemDownAngle(const WeberPennLevel& level, double parentLength, double offset, double base)
{
    if (level.downAngleV >= 0.0)
        return level.downAngle;
    const double ratio = (parentLength - offset) / (parentLength - base);
    return level.downAngle + level.downAngleV * (1.0 - 2.0 * (0.2 + 0.8 * ratio));
}

int stemCount(const WeberPennParams& params, std::size_t level, double length, double parentLength,
              double offset)
{
    const auto most = static_cast<double>(params.level[level].branches);
    double share = 1.0;
    if (level == 2) {
        const double longest = params.level[1].length;
        share = longest > 0.0 ? 0.2 + 0.8 * (length / parentLength) / longest : 0.2;
    } else if (level > 2) {
        share = 1.0 - 0.5 * offset / parentLength;
    }
    return static_cast<int>(std::floor(most * share + 0.5));
}

double taperedRadius(double taper, double radius, double length, double z)
{
    const double unit = taper < 1.0 ? taper : taper < 2.0 ? 2.0 - taper : 0.0;
    const double cone = radius * (1.0 - unit * z);
    if (taper < 1.0)
        return cone;
    const double left = (1.0 - z) * length;
    const double depth = taper < 2.0 || left < cone ? 1.0 : taper - 2.0;
    const double sphere = taper < 2.0 || cone <= 0.0
                              ? left
                              : std::abs(left - 2.0 * cone * std::floor(left / (2.0 * cone) + 0.5));
    if (taper < 2.0 && sphere >= cone)
        return cone;
    const double aside = sphere - cone;
    return (1.0 - depth) * cone + depth * std::sqrt(std::max(cone * cone - aside * aside, 0.0));
}

double trunkFactor(const WeberPennParams& params, double z)
{
    const double rest = std::max(1.0 - 8.0 * z, 0.0);
    const double flare = 1.0 + params.flare * (maths::pow(100.0, rest) - 1.0) / 100.0;
    // The mean of |sin| is 2 / pi.
    return params.lobes > 0 ? flare * (1.0 + params.lobeDepth * 2.0 / pi) : flare;
}

} // namespace ramure
