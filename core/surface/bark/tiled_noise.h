/// \file
/// Noise that repeats after one tile, in floats and without functions of the C library: the same bits
/// everywhere. Places are in tiles; a period says how many lattice cells a tile has each way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace ramure {

inline int wrapped(int i, int period)
{
    if (static_cast<unsigned>(i) < static_cast<unsigned>(period)) // nearly always: a division less
        return i;
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

/// Of what fits into an int: without a call of the C library.
inline int floorOf(float x)
{
    const int towardsZero = static_cast<int>(x);
    return towardsZero - (x < static_cast<float>(towardsZero) ? 1 : 0);
}

inline std::uint32_t latticeHash(int x, int y, std::uint32_t seed)
{
    std::uint32_t h = seed + std::uint32_t(x) * 0x8DA6B343u + std::uint32_t(y) * 0xD8163841u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

/// 0 .. 1 from bits of a hash.
inline float share(std::uint32_t hash)
{
    return float(hash >> 8) * 0x1.0p-24f;
}

/// Gradient noise (Perlin, "Improving noise", SIGGRAPH 2002), about -1 .. 1.
inline float gradientNoise(glm::vec2 at, glm::ivec2 period, std::uint32_t seed)
{
    static constexpr float d = 0.70710678f;
    static constexpr std::array<glm::vec2, 8> slopes{
        {{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}}};
    const glm::vec2 place = at * glm::vec2(period);
    const glm::ivec2 base(floorOf(place.x), floorOf(place.y));
    const glm::vec2 in = place - glm::vec2(base);
    const int x0 = wrapped(base.x, period.x), y0 = wrapped(base.y, period.y);
    const int x1 = x0 + 1 == period.x ? 0 : x0 + 1, y1 = y0 + 1 == period.y ? 0 : y0 + 1;
    const auto corner = [&](int x, int y, float dx, float dy) {
        return glm::dot(slopes[latticeHash(x, y, seed) >> 29], in - glm::vec2(dx, dy));
    };
    const glm::vec2 s = in * in * in * (in * (in * 6.0f - 15.0f) + 10.0f);
    const float low = glm::mix(corner(x0, y0, 0, 0), corner(x1, y0, 1, 0), s.x);
    const float high = glm::mix(corner(x0, y1, 0, 1), corner(x1, y1, 1, 1), s.x);
    return 1.5f * glm::mix(low, high, s.y);
}

/// Octaves of it, each twice as fine and half as strong; about -1 .. 1.
inline float fractalNoise(glm::vec2 at, glm::ivec2 period, int octaves, std::uint32_t seed)
{
    float sum = 0.0f, strength = 1.0f, all = 0.0f;
    for (int i = 0; i < octaves; ++i, strength *= 0.5f, period *= 2) {
        sum += strength * gradientNoise(at, period, seed + std::uint32_t(i));
        all += strength;
    }
    return sum / all;
}

/// What lies about a place among points strewn one a cell (Worley, "A cellular texture basis function",
/// SIGGRAPH 1996).
struct Cells
{
    float nearest = 8.0f, second = 8.0f; ///< distances, in cells
    std::uint32_t id = 0;                ///< of the nearest point
    glm::vec2 from{0.0f};                ///< from the nearest point to the place, in cells
    /// 0 on the border between two cells.
    [[nodiscard]] float inside() const { return second - nearest; }
};

/// \param jitter 0: a grid, 1: anywhere in the cell.
inline Cells cellsAt(glm::vec2 at, glm::ivec2 period, float jitter, std::uint32_t seed)
{
    const glm::vec2 place = at * glm::vec2(period);
    const glm::ivec2 base(floorOf(place.x), floorOf(place.y));
    Cells found;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const std::uint32_t id =
                latticeHash(wrapped(base.x + dx, period.x), wrapped(base.y + dy, period.y), seed);
            const glm::vec2 strewn(share(id) - 0.5f, share(id * 0x9E3779B9u) - 0.5f);
            const glm::vec2 from =
                place - (glm::vec2(base) + glm::vec2(float(dx), float(dy)) + 0.5f + jitter * strewn);
            const float distance = glm::dot(from, from);
            // Choices, not branches: which one is nearer cannot be foretold.
            const bool nearer = distance < found.nearest;
            found.second = std::min(found.second, nearer ? found.nearest : distance);
            found.nearest = nearer ? distance : found.nearest;
            found.id = nearer ? id : found.id;
            found.from.x = nearer ? from.x : found.from.x;
            found.from.y = nearer ? from.y : found.from.y;
        }
    found.nearest = std::sqrt(found.nearest);
    found.second = std::sqrt(found.second);
    return found;
}

} // namespace ramure
