#include "core/lod/billboard_picture.h"

#include "core/math/srgb.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace ramure {
namespace {

glm::dvec3 normalOf(const glm::u8vec4& bytes)
{
    return glm::dvec3(bytes.r, bytes.g, bytes.b) / 127.5 - 1.0;
}

glm::u8vec3 bytesOf(const glm::dvec3& normal)
{
    const double length = glm::length(normal);
    const glm::dvec3 unit = length > 1e-9 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
    const auto byte = [](double x) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(127.5 * (x + 1.0), 0.0, 255.0)));
    };
    return {byte(unit.x), byte(unit.y), byte(unit.z)};
}

/// What is averaged: light, direction and depth, and how much there is of them.
struct Mean
{
    glm::dvec3 light{0.0}, normal{0.0};
    double depth = 0.0, weight = 0.0;

    void add(const Mean& other)
    {
        light += other.light;
        normal += other.normal;
        depth += other.depth;
        weight += other.weight;
    }
    void scale(double factor)
    {
        light *= factor;
        normal *= factor;
        depth *= factor;
        weight *= factor;
    }
};

struct Level
{
    int width = 0, height = 0;
    std::vector<Mean> means;
    [[nodiscard]] Mean& at(int x, int y)
    {
        return means[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

Level levelOf(const BillboardPicture& picture, const PixelRect& within)
{
    Level out{within.width, within.height, {}};
    out.means.resize(std::size_t(within.width) * std::size_t(within.height));
    for (int y = 0; y < within.height; ++y)
        for (int x = 0; x < within.width; ++x) {
            const std::size_t i = picture.at(within.x + x, within.y + y);
            const glm::u8vec4 &colour = picture.colour[i], &normal = picture.normal[i];
            const double weight = colour.a / 255.0;
            out.at(x, y) = {weight * glm::dvec3(linearOf(colour.r), linearOf(colour.g), linearOf(colour.b)),
                            weight * normalOf(normal), weight * normal.a, weight};
        }
    return out;
}

Level halved(Level& fine)
{
    Level out{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    out.means.resize(std::size_t(out.width) * std::size_t(out.height));
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
            out.at(x / 2, y / 2).add(fine.at(x, y));
    for (Mean& mean : out.means) // one that is covered counts as much as four
        if (mean.weight > 1.0)
            mean.scale(1.0 / mean.weight);
    return out;
}

} // namespace

BillboardPicture shrunk(const BillboardPicture& large, int each)
{
    BillboardPicture out(large.width / each, large.height / each);
    std::vector<std::uint8_t> depths;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            glm::dvec3 light(0.0), normal(0.0);
            double covered = 0.0;
            depths.clear();
            for (int v = 0; v < each; ++v)
                for (int u = 0; u < each; ++u) {
                    const std::size_t i = large.at(each * x + u, each * y + v);
                    const glm::u8vec4& c = large.colour[i];
                    if (c.a == 0)
                        continue;
                    const double weight = c.a / 255.0;
                    light += weight * glm::dvec3(linearOf(c.r), linearOf(c.g), linearOf(c.b));
                    normal += weight * normalOf(large.normal[i]);
                    depths.push_back(large.normal[i].a);
                    covered += weight;
                }
            if (covered == 0.0)
                continue;
            light /= covered;
            const auto middle = depths.begin() + std::ptrdiff_t(depths.size() / 2);
            std::ranges::nth_element(depths, middle);
            const std::size_t i = out.at(x, y);
            out.colour[i] = {
                srgbOf(light.r), srgbOf(light.g), srgbOf(light.b),
                static_cast<std::uint8_t>(std::max(std::lround(255.0 * covered / (each * each)), 1L))};
            out.normal[i] = {bytesOf(normal), *middle};
        }
    return out;
}

void paste(BillboardPicture& onto, const BillboardPicture& what, int x, int y)
{
    for (int row = 0; row < what.height; ++row) {
        const auto from = std::ptrdiff_t(what.at(0, row)), to = std::ptrdiff_t(onto.at(x, y + row));
        std::copy_n(what.colour.begin() + from, what.width, onto.colour.begin() + to);
        std::copy_n(what.normal.begin() + from, what.width, onto.normal.begin() + to);
    }
}

void bleed(BillboardPicture& picture, const PixelRect& within)
{
    if (within.width < 1 || within.height < 1)
        return;
    std::vector<Level> levels{levelOf(picture, within)};
    while (levels.back().means.size() > 1)
        levels.push_back(halved(levels.back()));
    if (levels.back().means[0].weight <= 0.0)
        return;
    for (std::size_t i = levels.size() - 1; i-- > 0;)
        for (int y = 0; y < levels[i].height; ++y)
            for (int x = 0; x < levels[i].width; ++x)
                if (Mean& mean = levels[i].at(x, y); mean.weight <= 0.0)
                    mean = levels[i + 1].at(x / 2, y / 2);
    for (int y = 0; y < within.height; ++y)
        for (int x = 0; x < within.width; ++x) {
            const std::size_t i = picture.at(within.x + x, within.y + y);
            if (picture.colour[i].a > 0)
                continue;
            Mean mean = levels[0].at(x, y);
            mean.scale(1.0 / mean.weight);
            picture.colour[i] = {srgbOf(mean.light.r), srgbOf(mean.light.g), srgbOf(mean.light.b), 0};
            picture.normal[i] = {bytesOf(mean.normal),
                                 static_cast<std::uint8_t>(std::clamp(std::lround(mean.depth), 1L, 255L))};
        }
}

void turnNormals(BillboardPicture& picture, const PixelRect& within, const ViewFrame& axes)
{
    for (int y = within.y; y < within.y + within.height; ++y)
        for (int x = within.x; x < within.x + within.width; ++x) {
            glm::u8vec4& bytes = picture.normal[picture.at(x, y)];
            const glm::dvec3 n = normalOf(bytes);
            bytes = {bytesOf({glm::dot(n, axes.right), glm::dot(n, axes.up), glm::dot(n, axes.backward)}),
                     bytes.a};
        }
}

PixelRect coveredRect(const BillboardPicture& picture)
{
    int left = picture.width, right = -1, top = picture.height, bottom = -1;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (picture.colour[picture.at(x, y)].a > 0) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    if (right < left)
        return {};
    return {left, top, right - left + 1, bottom - top + 1};
}

} // namespace ramure
