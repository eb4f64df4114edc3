#include "core/surface/bark/bark_pattern.h"

#include "core/base/wide_clone.h"
#include "core/surface/bark/tiled_noise.h"
#include <array>

namespace ramure {
namespace {

using glm::ivec2;
using glm::vec2;
using Seed = std::uint32_t;

float step(float from, float to, float x)
{
    return glm::smoothstep(from, to, x);
}
/// Moves a place about, so that borders wander. Both ways octave by octave: what they share is computed once.
RAMURE_WIDE_CLONE vec2 warped(vec2 p, ivec2 period, vec2 by, int octaves, Seed seed)
{
    vec2 sum(0.0f);
    float strength = 1.0f, all = 0.0f;
    for (int i = 0; i < octaves; ++i, strength *= 0.5f, period *= 2) {
        if (by.x != 0.0f)
            sum.x += strength * gradientNoise(p, period, seed + 101u + Seed(i));
        if (by.y != 0.0f)
            sum.y += strength * gradientNoise(p, period, seed + 201u + Seed(i));
        all += strength;
    }
    return p + by * (sum / all);
}
/// Sharp crests where the noise passes zero.
float ridged(vec2 p, ivec2 period, int octaves, Seed seed)
{
    float sum = 0.0f, strength = 1.0f, all = 0.0f;
    for (int i = 0; i < octaves; ++i, strength *= 0.5f, period *= 2) {
        sum += strength * (1.0f - std::abs(gradientNoise(p, period, seed + Seed(i))));
        all += strength;
    }
    return sum / all;
}
float tintOf(std::uint32_t id)
{
    return 2.0f * share(id * 0x85EBCA6Bu) - 1.0f;
}

RAMURE_WIDE_CLONE BarkSample smoothBark(vec2 p, Seed seed)
{
    // Many features a tile, none of which stands out: on a stem of many tiles one that did would show the
    // grid.
    const float wide = fractalNoise(p, {7, 9}, 4, seed);
    const float wrinkles = fractalNoise(warped(p, {8, 8}, {0.0f, 0.01f}, 1, seed), {6, 56}, 2, seed + 11u);
    const float lichen = fractalNoise(p, {13, 11}, 4, seed + 21u);
    return {0.6f + 0.2f * wide + 0.18f * wrinkles, wide, 0.5f * step(0.1f, 0.5f, lichen)};
}

RAMURE_WIDE_CLONE BarkSample platedBark(vec2 p, Seed seed)
{
    // Long plates of thin flakes, one on the other. Each layer has broken off along an edge of its own, so
    // that a plate goes down to the fissure in steps, here close together and there far apart.
    const vec2 at = warped(p, {4, 3}, {0.06f, 0.07f}, 2, seed);
    const Cells plate = cellsAt(at, {6, 3}, 0.95f, seed);
    const float grain = fractalNoise(at, {17, 12}, 2, seed + 39u), flake = step(-0.05f, 0.05f, grain);
    float stack = 0.0f, tint = 0.35f * tintOf(plate.id);
    for (int layer = 0; layer < 3; ++layer) {
        const Seed own = Seed(layer);
        const float lobes =
            fractalNoise(at, {10 + 5 * layer, 6 + 4 * layer}, layer == 0 ? 2 : 1, seed + 31u + 7u * own);
        const float edge = 0.03f + 0.1f * float(layer) + 0.16f * (share(plate.id * (7u + own)) - 0.4f);
        const float there = step(edge, edge + 0.05f, plate.inside() + 0.24f * lobes);
        stack += 0.33f * there * (0.7f + 0.3f * stack);
        tint += there * (share(plate.id * (11u + own)) - 0.5f);
    }
    return {glm::clamp(0.1f + 0.82f * stack + 0.1f * flake + 0.06f * grain, 0.0f, 1.0f),
            0.55f * tint + 0.6f * grain + 0.5f * (flake - 0.5f),
            0.3f * step(0.55f, 1.0f, stack + 0.3f * grain)};
}

RAMURE_WIDE_CLONE BarkSample furrowedBark(vec2 p, Seed seed)
{
    // Furrows lean to the left and to the right and cross; where one closes, two ridges are one. They are as
    // wide as they like, and slope.
    constexpr float furrows = 5.0f;
    const vec2 at = warped(p, {5, 6}, {0.045f, 0.035f}, 3, seed);
    float away = 1.0f;
    for (const float lean : {1.0f, -1.0f}) {
        const Seed own = seed + (lean > 0.0f ? 31u : 37u);
        const float x = furrows * at.x + lean * at.y + 0.7f * gradientNoise(p, {3, 2}, own);
        const float closed = step(-0.1f, 0.5f, gradientNoise(p, {6, 5}, own + 2u));
        away = glm::min(away, 2.0f * std::abs(x - std::floor(x) - 0.5f) + 0.8f * closed);
    }
    const float fibres = fractalNoise(at, {26, 5}, 3, seed + 41u),
                wide = gradientNoise(p, {7, 5}, seed + 43u);
    const float ridge = step(0.0f, 0.62f + 0.22f * wide, away + 0.2f * fibres);
    // Ridges are rough: cracks along them and, seldom, across; scales that have come off.
    const float along = step(0.11f, 0.0f, std::abs(gradientNoise(at, {15, 4}, seed + 45u))) *
                        step(-0.3f, 0.3f, gradientNoise(p, {9, 8}, seed + 47u));
    const float across = step(0.13f, 0.0f, std::abs(fractalNoise(at, {7, 15}, 2, seed + 49u))) *
                         step(0.15f, 0.6f, gradientNoise(p, {8, 7}, seed + 53u));
    const float scales = step(-0.08f, 0.08f, fractalNoise(at, {13, 9}, 2, seed + 55u));
    const float top = 0.70f + 0.12f * scales + 0.22f * fibres - 0.26f * along - 0.26f * across;
    return {glm::clamp(ridge * top + (1.0f - ridge) * (0.1f + 0.1f * fibres), 0.0f, 1.0f),
            0.8f * fibres + 0.5f * wide + 0.5f * (scales - 0.5f),
            0.3f * ridge * step(0.1f, 0.6f, fractalNoise(p, {7, 6}, 2, seed + 57u))};
}

RAMURE_WIDE_CLONE BarkSample scalyBark(vec2 p, Seed seed)
{
    // Small scales, longer than wide. The lower rim of each stands off over the next, its upper end grows out
    // of the one above: gaps are seen below a scale and hardly beside it, and many scales still hang
    // together.
    const vec2 at = warped(p, {9, 8}, {0.035f, 0.04f}, 3, seed);
    const Cells scale = cellsAt(at, {13, 9}, 1.0f, seed);
    const float flakes = fractalNoise(at, {30, 22}, 2, seed + 45u);
    const float wide = fractalNoise(p, {8, 7}, 3, seed + 49u);
    const float down =
        glm::clamp(0.5f - 0.9f * scale.from.y + 0.3f * flakes, 0.0f, 1.0f); // 1: at its lower rim
    const float loose = step(-0.35f, 0.35f, 0.7f * wide + share(scale.id * 5u) - 0.5f);
    const float gap = step(0.20f, 0.0f, scale.inside() + 0.14f * flakes) * (0.12f + 0.88f * down * down);
    const float rise = 0.22f + 0.5f * loose * down + 0.16f * share(scale.id * 7u) + 0.16f * flakes;
    return {
        glm::clamp(rise * (1.0f - 0.8f * gap * (0.35f + 0.65f * loose)) + 0.12f * wide + 0.1f, 0.0f, 1.0f),
        0.45f * tintOf(scale.id) + 0.6f * flakes + 0.5f * wide,
        0.7f * step(0.1f, 0.7f, wide + 0.5f * flakes)};
}

RAMURE_WIDE_CLONE BarkSample peelingBark(vec2 p, Seed seed)
{
    // Ribbons of old bark hang over pale wood; their edges roll up.
    const vec2 at = warped(p, {4, 3}, {0.03f, 0.1f}, 3, seed);
    const float ribbon = fractalNoise(at, {8, 2}, 4, seed) + 0.06f;
    const float old = step(0.0f, 0.02f, ribbon), rolled = old * step(0.12f, 0.02f, ribbon);
    const float grain = fractalNoise(at, {30, 4}, 3, seed + 51u);
    const float wide = fractalNoise(p, {3, 5}, 2, seed + 55u);
    return {0.2f + old * (0.38f + 0.32f * rolled) + 0.1f * grain, 0.6f * grain + 0.7f * wide,
            (1.0f - old) * (0.8f + 0.2f * wide)};
}

/// Short dashes across. \param lengths from the shortest, of which there are most, to the longest, \param
/// width in cells. \param missing share of the cells that have none.
float lenticels(const Cells& cell, vec2 lengths, float width, float missing)
{
    const float chance = share(cell.id * 3u), own = share(cell.id * 5u);
    const float length = glm::mix(lengths.x, lengths.y, chance * chance * chance);
    return step(1.0f, 0.6f, glm::length(cell.from / vec2(length, width * (0.6f + 0.7f * own)))) *
           step(missing, missing + 0.1f, share(cell.id * 11u));
}

RAMURE_WIDE_CLONE BarkSample ringedBark(vec2 p, Seed seed)
{
    const vec2 at = warped(p, {5, 7}, {0.02f, 0.014f}, 2, seed);
    const float film = fractalNoise(at, {3, 26}, 3, seed), cloud = fractalNoise(p, {5, 9}, 4, seed + 63u);
    // Thin sheets of it have come off in bands and curl at their edges; what they bared is fresh.
    const float sheet = fractalNoise(at, {2, 9}, 4, seed + 67u) - 0.12f;
    const float curl = step(0.035f, 0.0f, std::abs(sheet)), fresh = step(0.0f, 0.03f, sheet);
    // Here lenticels stand close, there are hardly any: in bands of a year and by the side of the trunk.
    const float bare = 0.55f + 0.5f * fractalNoise(p, {3, 7}, 2, seed + 65u);
    const float dashes = lenticels(cellsAt(at, {8, 31}, 1.0f, seed + 61u), {0.1f, 1.0f}, 0.15f, bare);
    // Where limbs were, and where the trunk has burst, are black and rough diamonds, grey around.
    const Cells scar = cellsAt(at, {3, 4}, 1.0f, seed + 71u);
    const float large =
        share(scar.id * 13u) * share(scar.id * 17u); // most of them are small, two thirds are not there
    const float size = large > 0.27f ? 0.95f * large - 0.16f : -1.0f;
    float near = std::abs(scar.from.x) * 0.8f + std::abs(scar.from.y) * 1.5f - size;
    float torn = 0.0f;
    if (near < 0.3f) {
        torn = fractalNoise(p, {16, 22}, 4, seed + 81u);
        near += 0.2f * torn;
    }
    const float black = step(0.02f, -0.07f, near), smoke = step(0.3f, -0.1f, near);
    return {
        0.66f + 0.1f * film + 0.06f * cloud + 0.16f * curl - 0.06f * fresh - 0.15f * dashes +
            black * (0.34f * torn - 0.25f),
        0.8f * film + 1.1f * cloud + 0.9f * fresh - 0.7f * curl - 1.6f * smoke,
        glm::max(glm::max(0.5f * dashes * (0.8f + 0.4f * cloud), 0.16f * step(-0.1f, 0.5f, cloud - fresh)),
                 black * (0.82f + 0.3f * torn))};
}

RAMURE_WIDE_CLONE BarkSample bandedBark(vec2 p, Seed seed)
{
    // Rows of lenticels, rough and corky, on a skin that shines and peels in bands across.
    const vec2 at = warped(p, {4, 6}, {0.03f, 0.014f}, 2, seed);
    const float film = fractalNoise(at, {2, 22}, 2, seed), wide = fractalNoise(p, {3, 4}, 2, seed + 163u);
    const float old = step(0.0f, 0.06f, fractalNoise(at, {2, 7}, 3, seed + 165u)); // not peeled off yet
    const float bare = 0.6f + 0.8f * gradientNoise(p, {2, 6}, seed + 167u);
    const float corky = lenticels(cellsAt(at, {7, 25}, 1.0f, seed + 161u), {0.14f, 1.1f}, 0.22f, bare);
    return {0.42f + 0.2f * film + 0.14f * old + 0.28f * corky, 0.9f * film + 1.1f * wide - 0.15f * old,
            glm::max(0.65f * corky, 0.1f * old)};
}

RAMURE_WIDE_CLONE BarkSample fibrousBark(vec2 p, Seed seed)
{
    const vec2 at = warped(p, {3, 3}, {0.05f, 0.0f}, 2, seed);
    const float strands = ridged(at, {13, 2}, 3, seed);
    const float gaps = step(-0.5f, 0.15f, fractalNoise(at, {9, 2}, 2, seed + 91u));
    return {glm::clamp(1.5f * (strands - 0.35f), 0.0f, 1.0f) * (0.35f + 0.65f * gaps),
            fractalNoise(at, {20, 2}, 2, seed + 95u), 0.0f};
}

RAMURE_WIDE_CLONE BarkSample mosaicBark(vec2 p, Seed seed)
{
    // The oldest bark is what is left on top: two layers have come off in patches.
    const float first = fractalNoise(p, {4, 3}, 4, seed), second = fractalNoise(p, {3, 4}, 4, seed + 115u);
    const float old = step(0.02f, 0.05f, first), middle = step(-0.04f, -0.01f, second);
    const float grain = fractalNoise(p, {10, 10}, 3, seed + 111u);
    const float height = 0.3f + 0.22f * middle + 0.3f * old;
    return {height + 0.05f * grain, 0.8f * (middle - old) + 0.4f * grain,
            0.9f * (1.0f - glm::max(old, middle))};
}

RAMURE_WIDE_CLONE BarkSample palmBark(vec2 p, Seed seed)
{
    // The scar of a frond goes all around; above it the skin of the trunk has split upright as it aged.
    constexpr int rings = 6; // a tile
    const float y = float(rings) * (p.y + 0.03f * fractalNoise(p, {2, 5}, 4, seed));
    const float in = y - std::floor(y);
    const Seed own = latticeHash(0, wrapped(floorOf(y), rings), seed + 127u);
    const float scar = step(0.04f, 0.10f, in) * step(0.36f + 0.2f * share(own), 0.28f, in);
    const float groove = step(0.07f, 0.02f, in) + step(0.985f, 1.0f, in);
    const float fibres = fractalNoise(p, {34, 5}, 3, seed + 121u);
    const float cracks = step(0.16f, 0.02f, std::abs(gradientNoise(p, {19, 7}, seed + 123u))) *
                         step(-0.2f, 0.4f, gradientNoise(p, {9, 11}, seed + 125u));
    return {0.48f + 0.34f * scar + (0.12f - 0.08f * scar) * fibres - 0.3f * cracks * (1.0f - scar) -
                0.5f * groove,
            0.6f * fibres + 0.5f * tintOf(own), 0.75f * groove};
}

RAMURE_WIDE_CLONE BarkSample bootedBark(vec2 p, Seed seed)
{
    // Feet of fronds, sawn off, each in the gap between two of the row below.
    constexpr int columns = 4, rows = 5; // a tile
    const vec2 at = warped(p, {5, 5}, {0.03f, 0.026f}, 3, seed) * vec2(columns, rows);
    const float a = at.x + at.y, b = at.x - at.y;
    const int i = floorOf(a), j = floorOf(b);
    const Seed own = latticeHash(wrapped(i + j + 1, 2 * columns), wrapped(i - j, 2 * rows), seed + 171u);
    const float fa = a - float(i), fb = b - float(j);
    const float inside = glm::min(glm::min(fa, 1.0f - fa), glm::min(fb, 1.0f - fb));
    const float up = 0.5f * (fa - fb) + 0.5f; // 0 the lower corner, 1 the upper
    const float cut = 0.62f + 0.16f * share(own);
    const float gap = step(0.09f, 0.01f, inside);
    const float fibres = fractalNoise(at / vec2(columns, rows), {40, 8}, 3, seed + 173u);
    const float face = step(cut - 0.02f, cut + 0.03f, up) * (1.0f - gap);
    return {(1.0f - 0.8f * gap) * (0.34f + 0.72f * glm::min(up, cut) - 0.22f * face) + 0.10f * fibres,
            0.6f * fibres + 0.6f * tintOf(own), 0.6f * face};
}

RAMURE_WIDE_CLONE BarkSample thornyBark(vec2 p, Seed seed)
{
    const BarkSample skin = smoothBark(p, seed);
    const Cells thorn = cellsAt(p, {4, 4}, 0.7f, seed + 131u);
    const float size = 0.16f + 0.14f * share(thorn.id * 3u);
    const float cone = glm::max(0.0f, 1.0f - thorn.nearest / size);
    return {0.4f * skin.height + 0.6f * cone, skin.tint, glm::max(0.4f * skin.mark, step(0.05f, 0.5f, cone))};
}

RAMURE_WIDE_CLONE BarkSample corkyBark(vec2 p, Seed seed)
{
    const vec2 at = warped(p, {4, 3}, {0.07f, 0.1f}, 3, seed);
    const float ridges = 1.0f - ridged(at, {5, 2}, 3, seed); // cracks where the noise passes zero
    const float pores = fractalNoise(p, {24, 24}, 2, seed + 141u);
    return {glm::clamp(2.2f * ridges, 0.0f, 1.0f) * 0.85f + 0.1f + 0.08f * pores, pores, 0.0f};
}

RAMURE_WIDE_CLONE BarkSample bambooBark(vec2 p, Seed seed)
{
    const float away = std::abs(p.y - std::floor(p.y) - 0.5f);
    const float ring = step(0.03f, 0.008f, away), groove = step(0.012f, 0.0f, std::abs(away - 0.035f));
    const float streaks = fractalNoise(p, {36, 1}, 2, seed);
    const float wax = p.y - std::floor(p.y) < 0.5f ? step(0.13f, 0.03f, away) : 0.0f;
    return {0.55f + 0.4f * ring - 0.3f * groove + 0.05f * streaks, streaks, 0.6f * wax * (1.0f - ring)};
}

RAMURE_WIDE_CLONE BarkSample ribbedBark(vec2 p, Seed seed)
{
    constexpr int ribs = 5, spines = 8; // a tile
    const float x = float(ribs) * p.x, side = x - std::floor(x) - 0.5f;
    const float y = float(spines) * p.y + share(latticeHash(wrapped(floorOf(x), ribs), 0, seed + 151u));
    const vec2 from(side / float(ribs), (y - std::floor(y) - 0.5f) / float(spines));
    const float skin = fractalNoise(p, {12, 12}, 3, seed);
    const float rise = 1.0f - 4.0f * side * side;
    const float cushion = step(0.016f, 0.008f, glm::length(from));
    return {0.1f + 0.8f * rise + 0.1f * cushion, skin, cushion};
}

constexpr glm::vec3 rgb(int r, int g, int b)
{
    return glm::vec3(float(r), float(g), float(b)) / 255.0f;
}

const std::array<BarkLook, 16> looks{{
    {nullptr, {}, {}, {}},
    {smoothBark,
     rgb(98, 96, 90),
     rgb(146, 143, 134),
     rgb(172, 180, 160),
     0.008f,
     0.10f,
     0.75f,
     {rgb(116, 100, 86), 0.003f, 0.02f}},
    {platedBark,
     rgb(58, 46, 40),
     rgb(128, 104, 88),
     rgb(146, 138, 126),
     0.045f,
     0.16f,
     0.90f,
     {rgb(136, 112, 84), 0.010f, 0.05f},
     {rgb(142, 92, 62), 0.07f, 0.28f}},
    {furrowedBark,
     rgb(64, 53, 43),
     rgb(148, 134, 115),
     rgb(142, 142, 122),
     0.055f,
     0.17f,
     0.95f,
     {rgb(112, 102, 82), 0.012f, 0.10f},
     {rgb(118, 110, 96), 0.08f, 0.25f}},
    {scalyBark,
     rgb(64, 50, 42),
     rgb(140, 116, 98),
     rgb(140, 116, 98),
     0.022f,
     0.18f,
     0.90f,
     {rgb(128, 104, 82), 0.010f, 0.06f}},
    {peelingBark,
     rgb(74, 56, 44),
     rgb(150, 120, 96),
     rgb(214, 202, 176),
     0.025f,
     0.14f,
     0.70f,
     {rgb(158, 146, 118), 0.010f, 0.05f}},
    {ringedBark,
     rgb(164, 152, 138),
     rgb(222, 214, 200),
     rgb(52, 46, 42),
     0.012f,
     0.09f,
     0.60f,
     {rgb(78, 54, 48), 0.008f, 0.03f}},
    {fibrousBark,
     rgb(62, 46, 38),
     rgb(150, 120, 100),
     rgb(150, 120, 100),
     0.040f,
     0.16f,
     0.95f,
     {rgb(132, 98, 74), 0.010f, 0.06f}},
    {mosaicBark,
     rgb(112, 108, 88),
     rgb(134, 126, 104),
     rgb(204, 198, 166),
     0.010f,
     0.18f,
     0.70f,
     {rgb(128, 118, 92), 0.012f, 0.06f}},
    {palmBark,
     rgb(82, 72, 62),
     rgb(160, 148, 130),
     rgb(70, 58, 48),
     0.030f,
     0.12f,
     0.95f,
     {rgb(118, 142, 70), 0.050f, 0.085f}},
    {thornyBark,
     rgb(84, 90, 76),
     rgb(128, 130, 112),
     rgb(96, 76, 58),
     0.070f,
     0.10f,
     0.80f,
     {rgb(110, 116, 96), 0.012f, 0.06f}},
    {corkyBark,
     rgb(52, 44, 38),
     rgb(164, 146, 122),
     rgb(164, 146, 122),
     0.070f,
     0.12f,
     1.00f,
     {rgb(128, 114, 94), 0.012f, 0.08f}},
    {bambooBark,
     rgb(82, 92, 48),
     rgb(132, 142, 82),
     rgb(196, 200, 172),
     0.030f,
     0.08f,
     0.45f,
     {rgb(122, 140, 76), 0.002f, 0.008f}},
    {ribbedBark,
     rgb(46, 66, 40),
     rgb(112, 134, 84),
     rgb(198, 188, 160),
     0.080f,
     0.14f,
     0.80f,
     {rgb(112, 134, 84), 0.0005f, 0.001f}},
    {bandedBark,
     rgb(68, 50, 44),
     rgb(112, 86, 76),
     rgb(150, 122, 102),
     0.016f,
     0.10f,
     0.50f,
     {rgb(100, 76, 66), 0.006f, 0.03f}},
    {bootedBark,
     rgb(74, 60, 48),
     rgb(160, 138, 110),
     rgb(182, 164, 136),
     0.050f,
     0.16f,
     1.00f,
     {rgb(128, 140, 76), 0.050f, 0.085f}},
}};

} // namespace

const BarkLook& barkLook(BarkFamily family)
{
    return looks.at(static_cast<std::size_t>(family));
}

} // namespace ramure
