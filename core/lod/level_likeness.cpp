#include "core/lod/level_likeness.h"

#include "core/lod/card_painter.h"
#include "core/lod/spray_picture.h"
#include "core/math/box.h"
#include "core/math/reproducible.h"
#include "core/math/srgb.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/mesh/plain_colours.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

constexpr int finer = 4;           ///< samples a pixel, each way
constexpr int mostSamples = 2'600; ///< a side
constexpr std::array yaws{0.3, 2.4, -1.8};
constexpr double pitch = 0.1;

struct Surface
{
    ShownSurface shown;
    SurfaceLook look;
};

Expected<SurfaceLook> lookOf(const CardAtlas& atlas, int size, const Progress& progress)
{
    const auto maps = sprayMaps(atlas, size, progress);
    RAMURE_TRY(maps);
    SurfaceLook look;
    look.size = maps->size;
    for (const glm::u8vec4& pixel : maps->colour)
        look.pixels.emplace_back(linearOf(glm::u8vec3(pixel)), float(pixel.a) / 255.0F);
    for (const glm::u8vec3& normal : maps->normal)
        look.normals.push_back((glm::vec3(normal) - 128.0F) / 127.0F);
    return look;
}

Expected<std::vector<Surface>> surfacesOf(const TreeLevel& level, const NodeParams& params, int mapSize,
                                          const Progress& progress)
{
    std::vector<Surface> out;
    const auto add = [&](ShownSurface shown, const CardAtlas* atlas) -> Expected<void> {
        if (!shown.mesh || shown.mesh->empty())
            return {};
        auto look = atlas ? lookOf(*atlas, mapSize, progress) : ramure::lookOf(shown, progress);
        RAMURE_TRY(look);
        out.push_back({std::move(shown), std::move(*look)});
        return {};
    };
    const LeafForm form = level.foliage ? level.foliage->form : LeafForm();
    const glm::u8vec3 leaf = form.shape == LeafShape::Faithful ? plainLeaf
                             : form.onDay                      ? glm::u8vec3(255)
                                                               : leafColour(form.shape, form.turns);
    const bool hasKind = level.foliage && level.foliage->fruit.kind != FruitKind::Faithful;
    RAMURE_TRY(add({level.bark, {}, {}, params.bark, plainBark}, nullptr));
    RAMURE_TRY(add({level.leaves, {}, form, {}, leaf}, level.sprays.get()));
    RAMURE_TRY(add({level.apples, {}, {}, {}, hasKind ? glm::u8vec3(255) : plainFruit}, nullptr));
    RAMURE_TRY(add({level.billboard}, level.billboardAtlas.get()));
    return out;
}

struct Shot
{
    std::vector<float> cover; ///< per pixel
    glm::dvec3 light{0.0};    ///< sum over all samples
    double samples = 0.0;     ///< that are covered
};

/// In a light that shows what normals do: a sky above, a sun behind the viewer.
glm::dvec3 lit(const glm::vec3& colour, const glm::dvec3& normal, const ViewFrame& frame)
{
    const double up = normal.x * frame.right.y + normal.y * frame.up.y + normal.z * frame.backward.y;
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.4, 0.7, 0.6)); // in the axes of the view
    return glm::dvec3(colour) * (0.3 + 0.15 * up + 0.6 * std::max(0.0, glm::dot(normal, sun)));
}

Shot shotOf(const std::vector<Surface>& surfaces, const PaintedView& view, const glm::ivec2& size, int each)
{
    PaintedSamples samples(each * size.x, each * size.y);
    for (const Surface& surface : surfaces)
        paint(samples, view, surface.shown, surface.look);
    Shot out;
    out.cover.assign(std::size_t(size.x) * std::size_t(size.y), 0.0F);
    const float part = 1.0F / float(each * each);
    for (int y = 0; y < samples.height; ++y)
        for (int x = 0; x < samples.width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(samples.width) + std::size_t(x);
            if (!samples.isCovered(at))
                continue;
            out.cover[std::size_t(y / each) * std::size_t(size.x) + std::size_t(x / each)] += part;
            out.light += lit(samples.colour[at], glm::dvec3(samples.normal[at]), view.frame);
            out.samples += 1.0;
        }
    return out;
}

/// CIELAB of linear sRGB, white D65.
glm::dvec3 labOf(const glm::dvec3& c)
{
    const glm::dvec3 xyz((0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b) / 0.95047,
                         0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b,
                         (0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b) / 1.08883);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? maths::pow(t, 1.0 / 3.0) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    return {116.0 * f(xyz.y) - 16.0, 500.0 * (f(xyz.x) - f(xyz.y)), 200.0 * (f(xyz.y) - f(xyz.z))};
}

void compare(const Shot& before, const Shot& after, LevelLikeness& out)
{
    double lesser = 0.0, greater = 0.0, both = 0.0, either = 0.0;
    for (std::size_t i = 0; i < before.cover.size(); ++i) {
        const float a = before.cover[i], b = after.cover[i];
        lesser += double(std::min(a, b));
        greater += double(std::max(a, b));
        both += a >= 0.5F && b >= 0.5F ? 1.0 : 0.0;
        either += a >= 0.5F || b >= 0.5F ? 1.0 : 0.0;
    }
    if (greater > 0.0)
        out.overlap = std::min(out.overlap, lesser / greater);
    if (either > 0.0)
        out.outline = std::min(out.outline, both / either);
}

Box boxOf(const TreeLevel& level)
{
    Box box;
    for (const auto& mesh : {level.bark, level.leaves, level.apples})
        for (std::size_t v = 0; mesh && v < mesh->positions.size(); ++v)
            box.add(glm::dvec3(mesh->positions[v]));
    return box;
}

constexpr int leastPixels = 4;

} // namespace

std::vector<int> switchPixels(const LevelSwitches& switches)
{
    std::vector<int> out;
    for (std::size_t i = 1; i < switches.shares.size(); ++i)
        out.push_back(std::max(leastPixels, int(std::lround(switches.shares[i] * levelScreenHeight))));
    return out;
}

std::vector<int> detailPixels(const std::vector<TreeLevel>& levels)
{
    const double height = boxOf(levels.front()).size().y;
    std::vector<int> out;
    for (std::size_t i = 1; i < levels.size(); ++i)
        out.push_back(std::max(
            leastPixels,
            int(std::lround(std::min(height / std::max(levels[i].detail, 1e-9), levelScreenHeight)))));
    return out;
}

Expected<std::vector<LevelLikeness>> likenessOf(const std::vector<TreeLevel>& levels,
                                                const NodeParams& params, std::span<const int> pixels,
                                                int mapSize, const Progress& progress)
{
    const Box box = boxOf(levels.front());
    std::vector<LevelLikeness> out;
    auto before = surfacesOf(levels.front(), params, mapSize, progress);
    RAMURE_TRY(before);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        auto after = surfacesOf(levels[i], params, mapSize, progress);
        RAMURE_TRY(after);
        LevelLikeness& own = out.emplace_back();
        own.pixels = pixels[i - 1];
        const double metres = box.size().y / own.pixels; // of a pixel
        const double radius = box.radius() + metres;
        const int side = int(std::ceil(2.0 * radius / metres));
        const int each = std::clamp(mostSamples / side, 1, finer);
        Shot all[2];
        for (const double yaw : yaws) {
            const glm::dvec3 back(maths::sin(yaw) * maths::cos(pitch), maths::sin(pitch),
                                  maths::cos(yaw) * maths::cos(pitch));
            const PaintedView view{viewFrame(back), box.centre(), glm::dvec2(0.5 * side * metres)};
            const Shot one = shotOf(*before, view, glm::ivec2(side), each),
                       other = shotOf(*after, view, glm::ivec2(side), each);
            compare(one, other, own);
            for (const auto& [sum, shot] : {std::pair(&all[0], &one), std::pair(&all[1], &other)}) {
                sum->light += shot->light;
                sum->samples += shot->samples;
            }
        }
        if (all[0].samples > 0.0 && all[1].samples > 0.0) {
            own.cover = all[1].samples / all[0].samples;
            own.colourDistance =
                glm::length(labOf(all[0].light / all[0].samples) - labOf(all[1].light / all[1].samples));
        }
        before = std::move(after);
        progress.report(double(i) / double(levels.size() - 1));
    }
    return out;
}

} // namespace ramure
