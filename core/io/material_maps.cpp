#include "core/io/material_maps.h"

#include "core/base/file_writer.h"
#include "core/io/kept_maps.h"
#include "core/io/picture_file.h"
#include "core/lod/spray_picture.h"
#include "core/math/stage_hash.h"
#include "core/params/param_def.h"
#include "core/pipeline/stage_hashes.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/leaf_maps.h"
#include "core/surface/foliage/leaf_season.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

namespace ramure {
namespace {

std::span<const std::uint8_t> bytesOf(const std::vector<std::uint8_t>& values)
{
    return values;
}
std::span<const std::uint8_t> bytesOf(const std::vector<glm::u8vec3>& values)
{
    static_assert(sizeof(glm::u8vec3) == 3);
    return {values.empty() ? nullptr : &values.front().x, 3 * values.size()};
}

PictureBytes pictureOf(const BarkMaps& maps, MaterialMap map)
{
    const int size = maps.size;
    switch (map) {
    case MaterialMap::Colour:
        return {size, size, 3, true, bytesOf(maps.colour)};
    case MaterialMap::Normal:
        return {size, size, 3, false, bytesOf(maps.normal)};
    case MaterialMap::Height:
        return {size, size, 1, false, bytesOf(maps.height)};
    case MaterialMap::Occlusion:
        return {size, size, 1, false, bytesOf(maps.occlusion)};
    case MaterialMap::Roughness:
        return {size, size, 1, false, bytesOf(maps.roughness)};
    }
    return {};
}

PictureBytes pictureOf(const LeafMaps& maps, MaterialMap map)
{
    const int side = maps.size;
    return map == MaterialMap::Colour   ? PictureBytes{side, side, 3, true, bytesOf(maps.colour)}
           : map == MaterialMap::Normal ? PictureBytes{side, side, 3, false, bytesOf(maps.normal)}
                                        : PictureBytes{side, side, 1, false, bytesOf(maps.height)};
}

/// \param make gives all pictures; called where they are not kept from before.
template <class Make>
Expected<std::vector<MadeMap>> encoded(const MapsKey& key, std::span<const MaterialMap> kinds,
                                       const Make& make)
{
    if (auto kept = findKeptMaps(key))
        return std::move(*kept);
    const auto maps = make();
    RAMURE_TRY(maps);
    std::vector<MadeMap> out;
    for (const MaterialMap map : kinds) {
        auto png = pngOf(pictureOf(*maps, map));
        RAMURE_TRY(png);
        out.push_back({map, std::move(*png)});
    }
    keepMaps(key, out);
    return out;
}

} // namespace

Expected<std::vector<MadeMap>> makeMaps(const BarkParams& bark, int size, std::span<const MaterialMap> kinds,
                                        const Progress& progress)
{
    return encoded(MapsKey(bark, size, kinds), kinds, [&] { return barkMaps(bark, size, progress); });
}

Expected<std::vector<MadeMap>> makeMaps(LeafShape leaf, int size, std::span<const MaterialMap> kinds)
{
    return encoded(MapsKey(leaf, 0, size, kinds), kinds, [&] { return leafMaps(leaf, size); });
}

/// Of a hash, in hex.
static std::string eightDigits(std::uint64_t hash)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string number;
    for (int shift = 28; shift >= 0; shift -= 4)
        number += digits[(hash >> shift) & 15u];
    return number;
}

std::string pictureFileName(const std::string& picture)
{
    const std::filesystem::path path(picture);
    std::error_code problem; // then the path as it is tells files apart
    std::filesystem::path whole = std::filesystem::absolute(path, problem);
    std::string stem = path.stem().string();
    for (char& c : stem) // material files have no quotes
        if (c == ' ' || c == '\t' || c == '#' || c == '\\' || c == '\n' || c == '\r')
            c = '_';
    const std::string from = (problem ? path : whole.lexically_normal()).string();
    return stem.append("_")
        .append(eightDigits(StageHash(0).add(std::string_view(from)).value()))
        .append(path.extension().string());
}

Expected<std::string> pictureBytes(const std::string& path)
{
    std::error_code problem;
    std::ifstream file;
    if (std::filesystem::is_regular_file(path, problem)) // nobody waits for a pipe
        file.open(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (file.is_open() && !file.bad())
        return bytes;
    auto error = fail(ErrorCode::Io, RAMURE_NOOP("the picture is missing or cannot be read"));
    error.value().file = path;
    return error;
}

Expected<void> copyPictures(const std::string& folder, const PictureParams& pictures)
{
    for (const auto member : pictureFiles) {
        const std::string& path = pictures.*member;
        if (path.empty())
            continue;
        const auto bytes = pictureBytes(path);
        RAMURE_TRY(bytes);
        const std::string to = (std::filesystem::path(folder) / pictureFileName(path)).string();
        if (auto done = writeFile(to, *bytes); !done)
            return done;
    }
    return {};
}

std::string mapFileName(const BarkParams& bark, int size, MaterialMap map)
{
    const char* family = findParam("bark.family")->items[static_cast<std::size_t>(bark.family)].name;
    return std::string("bark_")
        .append(family)
        .append("_")
        .append(eightDigits(barkHash(bark, barkVersion)))
        .append("_")
        .append(std::to_string(size))
        .append("_")
        .append(mapNames[static_cast<std::size_t>(map)])
        .append(".png");
}

/// Hundredths; 0 where the leaf still has, or always keeps, its colour of summer.
static int seasonNumber(LeafShape leaf, double season)
{
    if (leaf == LeafShape::Faithful)
        return 0;
    const int number = static_cast<int>(std::lround(100.0 * season));
    return seasonColour(leaf, 0.01 * number) == glm::vec3(leafRow(leaf).colour) ? 0 : number;
}

std::string mapFileName(LeafShape leaf, int size, MaterialMap map, double season)
{
    const int number = map == MaterialMap::Colour ? seasonNumber(leaf, season) : 0;
    return std::string("leaf_")
        .append(findParam("foliage.leaf")->items[static_cast<std::size_t>(leaf)].name)
        .append("_")
        .append(std::to_string(leafMapsVersion))
        .append(number > 0 ? "_season" + std::to_string(number) : std::string())
        .append("_")
        .append(std::to_string(size))
        .append("_")
        .append(mapNames[static_cast<std::size_t>(map)])
        .append(".png");
}

namespace {

/// Those that are not there yet. \param make gives the files of some kinds.
template <class Name, class Make>
Expected<std::vector<std::string>> writeMissing(const std::string& folder, std::span<const MaterialMap> kinds,
                                                const Name& nameOf, const Make& make)
{
    std::vector<MaterialMap> missing;
    for (const MaterialMap map : kinds) {
        std::error_code problem; // what cannot be looked at is told by whoever writes it
        if (!std::filesystem::exists(std::filesystem::path(folder) / nameOf(map), problem))
            missing.push_back(map);
    }
    std::vector<std::string> written;
    if (missing.empty())
        return written;
    const Expected<std::vector<MadeMap>> maps = make(std::span<const MaterialMap>(missing));
    RAMURE_TRY(maps);
    for (const auto& [map, png] : *maps) {
        RAMURE_TRY(writeFile((std::filesystem::path(folder) / nameOf(map)).string(), png));
        written.push_back(nameOf(map));
    }
    return written;
}

} // namespace

Expected<std::vector<std::string>> writeMaps(const std::string& folder, const BarkParams& bark, int size,
                                             const Progress& progress)
{
    constexpr std::array kinds{MaterialMap::Colour, MaterialMap::Normal, MaterialMap::Height,
                               MaterialMap::Occlusion, MaterialMap::Roughness};
    return writeMissing(
        folder, kinds, [&](MaterialMap map) { return mapFileName(bark, size, map); },
        [&](auto missing) { return makeMaps(bark, size, missing, progress.part(0.0, 0.8)); });
}

/// Every pixel goes as far as the blade does. \param season in hundredths
static Expected<LeafMaps> seasonMaps(LeafShape leaf, int size, int season)
{
    auto maps = leafMaps(leaf, size);
    if (!maps || season == 0)
        return maps;
    const glm::vec3 tint = seasonColour(leaf, 0.01 * season) / glm::max(glm::vec3(maps->blade), 1.0F);
    for (glm::u8vec3& colour : maps->colour)
        colour = glm::u8vec3(glm::min(glm::vec3(colour) * tint + 0.5F, 255.0F));
    return maps;
}

Expected<std::vector<std::string>> writeMaps(const std::string& folder, LeafShape leaf, int size,
                                             double season)
{
    const int number = seasonNumber(leaf, season);
    return writeMissing(
        folder, leafMapKinds, [&](MaterialMap map) { return mapFileName(leaf, size, map, season); },
        [&](auto missing) {
            return encoded(MapsKey(leaf, number, size, missing), missing,
                           [&] { return seasonMaps(leaf, size, number); });
        });
}

static int sizeOfSprays(int size)
{
    return static_cast<int>(
        std::bit_floor(static_cast<unsigned>(std::clamp(size, leastSpraySize, mostSpraySize))));
}

Expected<MadeSprays> makeMaps(const CardAtlas& sprays, int size, const Progress& progress)
{
    const auto maps = sprayMaps(sprays, sizeOfSprays(size), progress);
    RAMURE_TRY(maps);
    std::vector<glm::u8vec3> colour;
    std::vector<std::uint8_t> opacity;
    for (const glm::u8vec4& pixel : maps->colour) {
        colour.emplace_back(pixel);
        opacity.push_back(pixel.a);
    }
    MadeSprays out;
    const int side = maps->size;
    const std::span<const std::uint8_t> cut{&maps->colour.front().x, 4 * maps->colour.size()};
    const std::tuple<std::string*, PictureBytes> files[] = {
        {&out.cut, {side, side, 4, true, cut}},
        {&out.colour, {side, side, 3, true, bytesOf(colour)}},
        {&out.opacity, {side, side, 1, false, bytesOf(opacity)}},
        {&out.normal, {side, side, 3, false, bytesOf(maps->normal)}}};
    for (const auto& [to, picture] : files) {
        auto png = pngOf(picture);
        RAMURE_TRY(png);
        *to = std::move(*png);
    }
    return out;
}

std::string sprayFileName(const CardAtlas& sprays, int size, const char* map)
{
    return std::string(sprays.name)
        .append("_")
        .append(eightDigits(sprays.hash))
        .append("_")
        .append(std::to_string(sizeOfSprays(size)))
        .append("_")
        .append(map)
        .append(".png");
}

Expected<std::vector<std::string>> writeMaps(const std::string& folder, const CardAtlas& sprays, int size,
                                             const Progress& progress)
{
    const auto maps = makeMaps(sprays, size, progress);
    RAMURE_TRY(maps);
    std::vector<std::string> written;
    for (const auto& [map, png] : {std::pair("colour", &maps->colour), std::pair("opacity", &maps->opacity),
                                   std::pair("normal", &maps->normal)}) {
        const std::string name = sprayFileName(sprays, size, map);
        RAMURE_TRY(writeFile((std::filesystem::path(folder) / name).string(), *png));
        written.push_back(name);
    }
    return written;
}

} // namespace ramure
