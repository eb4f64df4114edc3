#include "core/math/srgb.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <array>

namespace ramure {

static const std::array<double, 256>& linearTable()
{
    static const std::array<double, 256> table = [] {
        std::array<double, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double s = double(i) / 255.0;
            made[i] = s <= 0.04045 ? s / 12.92 : maths::pow((s + 0.055) / 1.055, 2.4);
        }
        return made;
    }();
    return table;
}

double linearOf(std::uint8_t channel)
{
    return linearTable()[channel];
}

glm::vec3 linearOf(const glm::u8vec3& colour)
{
    return {float(linearOf(colour.r)), float(linearOf(colour.g)), float(linearOf(colour.b))};
}

std::uint8_t srgbOf(double linear)
{
    // The nearest of the table: no power for every pixel.
    const auto& table = linearTable();
    const auto above = std::ranges::lower_bound(table, linear);
    if (above == table.begin())
        return 0;
    if (above == table.end())
        return 255;
    const auto number = above - table.begin();
    return static_cast<std::uint8_t>(*above - linear < linear - *(above - 1) ? number : number - 1);
}

glm::u8vec3 srgbOf(const glm::vec3& linear)
{
    return {srgbOf(double(linear.r)), srgbOf(double(linear.g)), srgbOf(double(linear.b))};
}

} // namespace ramure
