#include "core/lod/spray_picture.h"

#include "core/lod/card_painter.h"
#include "core/lod/mip_coverage.h"
#include "core/math/srgb.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <tuple>

namespace ramure {
namespace {

constexpr int fine = 2; ///< samples a pixel, each way

/// The place of a card in the picture, in pixels.
struct Place
{
    int left, low, width, height;
};

Place placeOf(const ShownCard& card, int size)
{
    const auto pixel = [size](float x) { return int(std::lround(double(x) * size)); };
    const int left = pixel(card.low.x), low = pixel(card.low.y);
    return {left, low, std::max(pixel(card.high.x) - left, 1), std::max(pixel(card.high.y) - low, 1)};
}

/// The part of the picture that is the card's.
void take(const PaintedSamples& samples, const Place& place, SprayMaps& maps)
{
    constexpr auto all = float(fine * fine);
    for (int y = 0; y < place.height; ++y)
        for (int x = 0; x < place.width; ++x) {
            glm::vec3 colour(0.0F), normal(0.0F);
            float covered = 0.0F;
            for (int s = 0; s < fine * fine; ++s) {
                const std::size_t at = std::size_t(fine * y + s / fine) * std::size_t(samples.width) +
                                       std::size_t(fine * x + s % fine);
                if (!samples.isCovered(at))
                    continue;
                covered += 1.0F;
                colour += samples.colour[at];
                normal += samples.normal[at];
            }
            if (covered == 0.0F)
                continue;
            const std::size_t to =
                std::size_t(place.low + y) * std::size_t(maps.size) + std::size_t(place.left + x);
            maps.colour[to] = {srgbOf(colour / covered), std::uint8_t(255.0F * covered / all + 0.5F)};
            normal = glm::length(normal) > 1e-6F ? glm::normalize(normal) : glm::vec3(0.0F, 0.0F, 1.0F);
            maps.normal[to] = glm::u8vec3(128.0F + 127.0F * normal);
        }
}

/// Colours beside the leaves go on as those of their neighbours, so that no edge is dark from afar: of what
/// is not covered each pixel takes the mean of the smallest square around it that has some.
void fillBeside(SprayMaps& maps)
{
    struct Sum
    {
        glm::vec3 colour{0.0F};
        float weight = 0.0F;
    };
    std::vector<std::vector<Sum>> pyramid;
    const int size = maps.size;
    std::vector<Sum> level(maps.colour.size());
    for (std::size_t i = 0; i < level.size(); ++i)
        if (maps.colour[i].a > 0)
            level[i] = {float(maps.colour[i].a) * glm::vec3(maps.colour[i]), float(maps.colour[i].a)};
    for (int side = size; side > 1; side /= 2) {
        pyramid.push_back(level);
        std::vector<Sum> next(std::size_t(side / 2) * std::size_t(side / 2));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Sum& from = pyramid.back()[std::size_t(y) * std::size_t(side) + std::size_t(x)];
                Sum& to = next[std::size_t(y / 2) * std::size_t(side / 2) + std::size_t(x / 2)];
                to.colour += from.colour;
                to.weight += from.weight;
            }
        level = std::move(next);
    }
    pyramid.push_back(level);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            glm::u8vec4& pixel = maps.colour[std::size_t(y) * std::size_t(size) + std::size_t(x)];
            for (std::size_t k = 1; pixel.a == 0 && k < pyramid.size(); ++k) {
                const std::size_t side = std::size_t(size) >> k;
                const Sum& sum = pyramid[k][(std::size_t(y) >> k) * side + (std::size_t(x) >> k)];
                if (sum.weight == 0.0F)
                    continue;
                pixel = {glm::u8vec3(sum.colour / sum.weight + 0.5F), 0};
                break;
            }
        }
}

void keepOpacity(SprayMaps& maps)
{
    std::vector<float> alpha(maps.colour.size());
    std::ranges::transform(maps.colour, alpha.begin(),
                           [](const glm::u8vec4& p) { return float(p.a) / 255.0F; });
    keepCoverage(alpha, maps.size);
    for (std::size_t i = 0; i < alpha.size(); ++i)
        maps.colour[i].a = std::uint8_t(255.0F * alpha[i] + 0.5F);
}

} // namespace

Expected<SprayMaps> sprayMaps(const CardAtlas& atlas, int size, const Progress& progress)
{
    if (size < leastSpraySize || size > mostSpraySize || (size & (size - 1)) != 0)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("the picture of cards has %1 to %2 pixels a side, a power of two, not %3"),
                    {std::to_string(leastSpraySize), std::to_string(mostSpraySize), std::to_string(size)});
    std::vector<std::shared_ptr<const SurfaceLook>> looks; // each once
    for (const ShownSurface& surface : atlas.surfaces) {
        const auto known = std::ranges::find_if(atlas.surfaces, [&](const ShownSurface& other) {
            return &other == &surface || std::tie(other.leaf, other.bark, other.colour) ==
                                             std::tie(surface.leaf, surface.bark, surface.colour);
        });
        if (&*known != &surface) {
            looks.push_back(looks[std::size_t(known - atlas.surfaces.begin())]);
            continue;
        }
        auto look = lookOf(surface, progress.part(0.0, 0.1));
        RAMURE_TRY(look);
        looks.push_back(std::make_shared<const SurfaceLook>(std::move(*look)));
    }
    SprayMaps out;
    out.size = size;
    out.colour.assign(std::size_t(size) * std::size_t(size), glm::u8vec4(0));
    out.normal.assign(out.colour.size(), glm::u8vec3(128, 128, 255));
    for (std::size_t k = 0; k < atlas.cards.size(); ++k) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const ShownCard& card = atlas.cards[k];
        const Place place = placeOf(card, size);
        PaintedSamples samples(fine * place.width, fine * place.height);
        for (std::size_t s = card.from; s < card.to; ++s) {
            paint(samples, {card.frame, card.middle, card.half}, atlas.surfaces[s], *looks[s]);
            // A card shows a part of the leaves, which hide as much wood as all of them do.
            if (atlas.surfaces[s].copies.empty())
                samples.moveBack();
        }
        take(samples, place, out);
        progress.report(0.1 + 0.9 * double(k + 1) / double(atlas.cards.size()));
    }
    fillBeside(out);
    keepOpacity(out);
    return out;
}

} // namespace ramure
