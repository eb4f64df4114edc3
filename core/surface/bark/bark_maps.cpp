#include "core/surface/bark/bark_maps.h"

#include "core/base/wide_clone.h"
#include "core/math/reproducible.h"
#include "core/surface/bark/bark_pattern.h"
#include "core/surface/bark/tiled_noise.h"
#include <algorithm>

namespace ramure {
namespace {

using Heights = std::vector<float>;

constexpr float mostShade = 0.75f;                  ///< of the light of the sky: what the deepest crack loses
constexpr float leastTone = 0.25f, mostTone = 3.0f; ///< of what a picture's colour is multiplied by

std::uint8_t byteOf(float value)
{
    return static_cast<std::uint8_t>(255.0f * glm::clamp(value, 0.0f, 1.0f) + 0.5f);
}
glm::u8vec3 bytesOf(const glm::vec3& colour)
{
    return {byteOf(colour.x), byteOf(colour.y), byteOf(colour.z)};
}

/// Means over squares of (2 radius + 1) pixels, around the edges.
Heights blurred(const Heights& from, int size, int radius)
{
    const auto n = static_cast<std::size_t>(size);
    const float share = 1.0f / float(2 * radius + 1);
    Heights along(from.size()), both(from.size()), sums(n);
    for (std::size_t row = 0; row < from.size(); row += n) {
        const auto at = [&](int x) { return from[row + std::size_t(wrapped(x, size))]; };
        float sum = 0.0f;
        for (int x = -radius; x <= radius; ++x)
            sum += at(x);
        for (int x = 0; x < size; ++x) {
            along[row + std::size_t(x)] = sum * share;
            sum += at(x + radius + 1) - at(x - radius);
        }
    }
    // All columns side by side, as they lie in memory.
    const auto rowAt = [&](int y) { return &along[std::size_t(wrapped(y, size)) * n]; };
    for (int y = -radius; y <= radius; ++y)
        for (std::size_t x = 0; x < n; ++x)
            sums[x] += rowAt(y)[x];
    for (int y = 0; y < size; ++y) {
        const float *const comes = rowAt(y + radius + 1), *const goes = rowAt(y - radius);
        float* const to = &both[std::size_t(y) * n];
        for (std::size_t x = 0; x < n; ++x) {
            to[x] = sums[x] * share;
            sums[x] += comes[x] - goes[x];
        }
    }
    return both;
}

glm::vec3 mossed(glm::vec3 colour, const BarkParams& params, glm::vec2 at, float height, std::uint32_t seed)
{
    if (params.moss <= 0.0)
        return colour;
    // It begins in the cracks.
    const float grows = 0.5f + 0.6f * fractalNoise(at, {3, 3}, 4, seed + 301u) + 0.4f * (0.5f - height);
    const float bare = 1.15f - 1.3f * float(params.moss);
    const glm::vec3 moss = glm::vec3(0.29f, 0.36f, 0.13f) * (0.85f + 0.3f * height);
    return glm::mix(colour, moss, glm::smoothstep(bare, bare + 0.15f, grows));
}

/// A place of a bark as it is drawn.
struct BarkPixel
{
    float height = 0.0f;
    glm::vec3 colour{0.0f}; ///< sRGB, 0 .. 1 and beyond
};

class Bark
{
public:
    explicit Bark(const BarkParams& params)
        : m_params(params)
        , m_look(barkLook(params.family))
        , m_seed(latticeHash(int(params.seed & 0xFFFF), int((params.seed >> 16) & 0xFFFF), 17u))
    {
    }
    [[nodiscard]] RAMURE_WIDE_CLONE BarkPixel at(glm::vec2 place) const
    {
        const BarkSample sample = m_look.at(place, m_seed);
        const float grain = gradientNoise(place, {64, 64}, m_seed + 401u);
        const float height = glm::clamp(sample.height + 0.012f * grain, 0.0f, 1.0f);
        // Cracks are dark for want of light, which the map of occlusion takes away, more than by their
        // colour.
        const glm::vec3 crack = glm::mix(m_look.crack, m_look.ridge, 0.3f);
        glm::vec3 colour = glm::mix(crack, m_look.ridge, glm::smoothstep(0.0f, 1.0f, height));
        // Nothing wider than a few plates: the tile would show. What is wider is of the tree (barkWeather).
        const float wide = fractalNoise(place, {7, 9}, 3, m_seed + 421u);
        colour *= 1.0f + m_look.variety * (sample.tint + 0.5f * wide) + 0.09f * grain;
        colour +=
            glm::vec3(0.030f, 0.004f, -0.030f) * (0.7f * wide + 0.5f * sample.tint); // fresh brown, grey
        colour = mossed(glm::mix(colour, m_look.mark, sample.mark), m_params, place, height, m_seed);
        return {height, colour * float(1.0 + m_params.light)};
    }

private:
    const BarkParams& m_params;
    const BarkLook& m_look;
    std::uint32_t m_seed;
};

void addNormals(BarkMaps& maps, const Heights& heights)
{
    const int size = maps.size;
    const float slope = 0.5f * maps.relief * float(size);
    const auto at = [&](int x, int y) {
        return heights[std::size_t(wrapped(y, size)) * std::size_t(size) + std::size_t(wrapped(x, size))];
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 normal = glm::normalize(glm::vec3(slope * (at(x - 1, y) - at(x + 1, y)),
                                                              slope * (at(x, y - 1) - at(x, y + 1)), 1.0f));
            maps.normal.push_back(bytesOf(0.5f + 0.5f * normal));
        }
}

/// What lies under its neighbourhood gets less light from the sky.
void addOcclusion(BarkMaps& maps, const Heights& heights)
{
    const Heights close = blurred(heights, maps.size, std::max(1, maps.size / 128));
    const Heights far = blurred(heights, maps.size, std::max(1, maps.size / 32));
    const float depth = 24.0f * maps.relief;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const float under = std::max(0.0f, close[i] - heights[i]) + std::max(0.0f, far[i] - heights[i]);
        maps.occlusion.push_back(byteOf(1.0f - mostShade * depth * under / (mostShade + depth * under)));
    }
}

} // namespace

Expected<BarkMaps> barkMaps(const BarkParams& params, int size, const Progress& progress)
{
    if (size < leastBarkSize || size > mostBarkSize)
        return fail(ErrorCode::Limit, RAMURE_NOOP("A map of bark has %1 to %2 pixels a side"),
                    {std::to_string(leastBarkSize), std::to_string(mostBarkSize)});
    const BarkLook& look = barkLook(params.family);
    if (!look.at)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("Plain bark has no maps"));
    const Bark bark(params);
    BarkMaps maps;
    maps.size = size;
    maps.relief = look.relief * float(params.depth);
    maps.young = youngColour(params);
    maps.youngRadius = look.youth.from;
    maps.oldRadius = look.youth.until;
    maps.limb = glm::clamp(glm::vec3(limbColour(params)) / glm::max(glm::vec3(meanColour(params)), 1.0f),
                           leastTone, mostTone);
    maps.limbRadius = look.limbs.from;
    maps.ripeRadius = look.limbs.until;
    const auto count = std::size_t(size) * std::size_t(size);
    Heights heights;
    heights.reserve(count);
    maps.colour.reserve(count);
    maps.roughness.reserve(count);
    for (int y = 0; y < size; ++y) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        for (int x = 0; x < size; ++x) {
            const glm::vec2 at = (glm::vec2(float(x), float(y)) + 0.5f) / float(size);
            const auto [height, colour] = bark.at(at);
            heights.push_back(height);
            maps.colour.push_back(bytesOf(colour));
            maps.height.push_back(byteOf(height));
            maps.roughness.push_back(byteOf(glm::mix(1.0f, look.roughness, height)));
        }
        progress.report(double(y + 1) / double(size));
    }
    maps.normal.reserve(count);
    maps.occlusion.reserve(count);
    addNormals(maps, heights);
    addOcclusion(maps, heights);
    double grey = 0.0;
    for (const glm::u8vec3& colour : maps.colour)
        grey += double(colour.x) + double(colour.y) + double(colour.z);
    maps.grey = float(grey / (3.0 * 255.0 * double(count)));
    return maps;
}

namespace {

float ageShare(double radius, float from, float until)
{
    const double first = maths::log(double(from)), last = maths::log(double(until));
    return glm::smoothstep(0.0F, 1.0F, float((maths::log(std::max(radius, 1e-6)) - first) / (last - first)));
}

/// Noise between the corners of a lattice of cubes, 0 .. 1.
float latticeNoise(const glm::vec3& at, std::uint32_t seed)
{
    const glm::ivec3 base(floorOf(at.x), floorOf(at.y), floorOf(at.z));
    const glm::vec3 in = at - glm::vec3(base), s = in * in * (3.0f - 2.0f * in);
    const auto edge = [&](int y, int z) {
        const std::uint32_t own = seed + std::uint32_t(base.z + z) * 0x27D4EB2Fu;
        return glm::mix(share(latticeHash(base.x, base.y + y, own)),
                        share(latticeHash(base.x + 1, base.y + y, own)), s.x);
    };
    return glm::mix(glm::mix(edge(0, 0), edge(1, 0), s.y), glm::mix(edge(0, 1), edge(1, 1), s.y), s.z);
}

} // namespace

float barkWeather(const glm::vec3& place)
{
    // Longer along the trunk, as rain runs down; coordinates that no float tells apart are left alone.
    const glm::vec3 at = glm::clamp(place, -1e4f, 1e4f) * glm::vec3(1.7f, 0.8f, 1.7f);
    const float noise = 0.65f * latticeNoise(at, 1u) + 0.35f * latticeNoise(2.7f * at, 2u);
    return glm::smoothstep(0.35f, 0.8f, noise);
}

float barkAge(BarkFamily family, double radius)
{
    const BarkYouth& youth = barkLook(family).youth;
    return ageShare(radius, youth.from, youth.until);
}

float barkRipeness(BarkFamily family, double radius)
{
    const BarkOfLimbs& limbs = barkLook(family).limbs;
    return limbs.colour.r < 0.0f ? 1.0f : ageShare(radius, limbs.from, limbs.until);
}

glm::u8vec3 limbColour(const BarkParams& params)
{
    const BarkOfLimbs& limbs = barkLook(params.family).limbs;
    return limbs.colour.r < 0.0f ? meanColour(params) : bytesOf(limbs.colour * float(1.0 + params.light));
}

glm::u8vec3 youngColour(const BarkParams& params)
{
    return bytesOf(barkLook(params.family).youth.colour * float(1.0 + params.light));
}

glm::u8vec3 meanColour(const BarkParams& params)
{
    constexpr int places = 16; // each way
    const Bark bark(params);
    glm::vec3 sum(0.0f);
    for (int y = 0; y < places; ++y)
        for (int x = 0; x < places; ++x)
            sum += bark.at((glm::vec2(float(x), float(y)) + 0.5f) / float(places)).colour;
    return bytesOf(sum / float(places * places));
}

} // namespace ramure
