#include "widgets/view/render/passes/sky_picture.h"

#include "core/base/file_writer.h"
#include "core/base/number_text.h"
#include "core/math/angle.h"
#include "widgets/view/render/passes/picture_light.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Three mantissas and the exponent of the largest.
void addRgbe(std::string& out, const glm::dvec3& colour)
{
    int exponent = 0;
    const double most = std::max({colour.r, colour.g, colour.b});
    if (most < 1e-32) {
        out.append(4, '\0');
        return;
    }
    const double scale = std::frexp(most, &exponent) * 256.0 / most;
    for (int i = 0; i < 3; ++i)
        out += char(static_cast<unsigned char>(colour[i] * scale));
    out += char(static_cast<unsigned char>(exponent + 128));
}

std::string numbers(const glm::dvec3& v)
{
    return numberText(v.x) + " " + numberText(v.y) + " " + numberText(v.z);
}

} // namespace

Expected<void> saveSkyPicture(const SceneLight& light, int width, const std::string& path, bool hasSun)
{
    SceneLight clear = light;
    clear.backdrop = Backdrop::Sky;
    const PictureLight lit = lightOf(clear);
    const int height = width / 2;
    const auto wayOf = [&](int x, int y) {
        return directionInPicture({(x + 0.5) / width, (y + 0.5) / height});
    };
    const double side = fullTurn / width; // of a pixel, rad
    const double rim = std::cos(std::max(0.27 * oneDegree, 0.75 * side));
    double sun = 0.0; // sr
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (hasSun && glm::dot(wayOf(x, y), lit.sun) > rim)
                sun += side * side * std::sin((y + 0.5) * side);
    std::string out = "#?RADIANCE\n# sun " + numbers(lit.sun) + "\n# sunlight " +
                      numbers(glm::dvec3(lit.sunlight)) + "\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
                      numberText(height) + " +X " + numberText(width) + "\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 way = wayOf(x, y);
            const bool isSun = hasSun && glm::dot(way, lit.sun) > rim;
            addRgbe(out, lit.radiance(way) + (isSun ? pi / sun : 0.0) * glm::dvec3(lit.sunlight));
        }
    }
    return writeFile(path, out);
}

} // namespace ramure
