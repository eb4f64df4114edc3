#include "core/surface/foliage/leaf_maps.h"

#include "core/math/reproducible.h"
#include "core/surface/foliage/venation.h"

#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Half the width of a vein's tip, of the blade's length; and how far what lies beside a vein rises to the
/// next.
constexpr double tipWidth = 0.0016, pillow = 0.012;

/// From pixels to the flat blade, as leafMesh lays its texture coordinates.
struct Sheet
{
    Sheet(const FlatBlade& blade, int pixels)
        : size(pixels)
        , half(blade.halfWidth)
        , low(std::ranges::min(blade.points, {}, &glm::dvec2::y).y)
    {
    }

    [[nodiscard]] glm::dvec2 at(double x, double y) const
    {
        return {half * (2.0 * x / size - 1.0), low + (1.0 - low) * y / size};
    }
    [[nodiscard]] glm::dvec2 pixel(const glm::dvec2& p) const
    {
        return {0.5 * (p.x / half + 1.0) * size, (p.y - low) / (1.0 - low) * size};
    }

    int size;
    double half, low;
};

double distanceTo(const Vein& vein, const glm::dvec2& p)
{
    const glm::dvec2 way = vein.to - vein.from;
    const double length2 = glm::dot(way, way);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - vein.from, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(p - vein.from - t * way);
}

/// What veins do to each pixel: how much it is one, 0..1, and how far the blade has risen beside it, 0..1.
struct Field
{
    std::vector<float> vein, rise;
};

Field fieldOf(const std::vector<Vein>& veins, const Sheet& sheet)
{
    const auto pixels = static_cast<std::size_t>(sheet.size) * static_cast<std::size_t>(sheet.size);
    Field field{std::vector<float>(pixels, 0.0f), std::vector<float>(pixels, 1.0f)};
    const double narrow = std::min(1.0, 3.0 * sheet.half); // veins of a narrow blade are finer
    // Thinner than a pixel, it would be dotted.
    const double finest = 0.7 * std::max(2.0 * sheet.half, 1.0 - sheet.low) / sheet.size;
    for (const Vein& vein : veins) {
        const double width = std::max(finest, narrow * tipWidth * std::min(vein.radius, 8.0)),
                     reach = width + 2.0 * narrow * pillow;
        const glm::dvec2 a = sheet.pixel(glm::min(vein.from, vein.to) - reach);
        const glm::dvec2 b = sheet.pixel(glm::max(vein.from, vein.to) + reach);
        const auto cut = [&](double v) {
            return std::clamp(static_cast<int>(std::floor(v)), 0, sheet.size - 1);
        };
        for (int y = cut(a.y); y <= cut(b.y); ++y)
            for (int x = cut(a.x); x <= cut(b.x); ++x) {
                const double away = distanceTo(vein, sheet.at(x + 0.5, y + 0.5));
                const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(sheet.size) +
                                      static_cast<std::size_t>(x);
                const double core = std::max(0.0, 1.0 - away / width);
                const double beside = std::clamp((away - width) / (2.0 * narrow * pillow), 0.0, 1.0);
                field.vein[i] = std::max(field.vein[i], static_cast<float>(std::min(1.0, 1.6 * core)));
                field.rise[i] = std::min(field.rise[i], static_cast<float>(beside * (2.0 - beside)));
            }
    }
    return field;
}

std::uint8_t byte(double share)
{
    return static_cast<std::uint8_t>(std::clamp(255.0 * share, 0.0, 255.0) + 0.5);
}

void cover(const FlatBlade& blade, const Sheet& sheet, std::vector<std::uint8_t>& coverage)
{
    const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    for (const glm::uvec3& t : blade.triangles) {
        const glm::dvec2 a = sheet.pixel(blade.points[t.x]), b = sheet.pixel(blade.points[t.y]),
                         c = sheet.pixel(blade.points[t.z]);
        const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        const auto cut = [&](double v) { return std::clamp(static_cast<int>(v), 0, sheet.size - 1); };
        for (int y = cut(low.y); y <= cut(high.y); ++y)
            for (int x = cut(low.x); x <= cut(high.x); ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                if (side(a, b, p) >= 0.0 && side(b, c, p) >= 0.0 && side(c, a, p) >= 0.0)
                    coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(sheet.size) +
                             static_cast<std::size_t>(x)] = 255;
            }
    }
}

} // namespace

Expected<LeafMaps> leafMaps(LeafShape shape, int size)
{
    if (shape == LeafShape::Faithful)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the faithful leaf has no picture"));
    if (size < leastLeafSize || size > mostLeafSize)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a picture of %1 pixels: %2 to %3 are possible"),
                    {std::to_string(size), std::to_string(leastLeafSize), std::to_string(mostLeafSize)});
    const VeinedBlade veined = veinedBlade(shape);
    const Sheet sheet(veined.blade, size);
    const Field field = fieldOf(veined.veins, sheet);
    LeafMaps maps;
    maps.size = size;
    maps.blade = leafRow(shape).colour;
    const std::size_t pixels = field.vein.size(), row = static_cast<std::size_t>(size);
    maps.colour.resize(pixels);
    maps.normal.resize(pixels);
    maps.height.resize(pixels);
    maps.through.resize(pixels);
    maps.coverage.assign(pixels, 0);
    cover(veined.blade, sheet, maps.coverage);
    const glm::dvec3 blade = glm::dvec3(leafRow(shape).colour) / 255.0;
    const glm::dvec3 pale = glm::mix(blade, glm::dvec3(0.86, 0.88, 0.62), 0.3);
    for (std::size_t i = 0; i < pixels; ++i) {
        const double vein = field.vein[i], rise = field.rise[i];
        const glm::dvec3 colour = glm::mix(blade * (0.94 + 0.06 * rise), pale, vein);
        maps.colour[i] = {byte(colour.r), byte(colour.g), byte(colour.b)};
        maps.height[i] = byte(0.25 + 0.5 * rise * (1.0 - vein));
        maps.through[i] = byte(0.85 + 0.15 * rise - 0.5 * vein);
    }
    // The blade is pillowed between its veins; slopes go by what a pixel is wide.
    const double across = 2.0 * sheet.half / size, along = (1.0 - sheet.low) / size, relief = 0.006;
    for (std::size_t y = 0; y < row; ++y)
        for (std::size_t x = 0; x < row; ++x) {
            const auto height = [&](std::size_t at, std::size_t line) {
                const std::size_t i = line * row + at;
                return static_cast<double>(field.rise[i]) * (1.0 - 0.5 * static_cast<double>(field.vein[i]));
            };
            const std::size_t left = x > 0 ? x - 1 : x, right = std::min(x + 1, row - 1);
            const std::size_t below = y > 0 ? y - 1 : y, above = std::min(y + 1, row - 1);
            const glm::dvec3 n = glm::normalize(glm::dvec3(
                relief * (height(left, y) - height(right, y)) / (across * static_cast<double>(right - left)),
                relief * (height(x, below) - height(x, above)) / (along * static_cast<double>(above - below)),
                1.0));
            maps.normal[y * row + x] = {byte(0.5 + 0.5 * n.x), byte(0.5 + 0.5 * n.y), byte(0.5 + 0.5 * n.z)};
        }
    return maps;
}

} // namespace ramure
