#include "core/io/material_maps.h"

#include "core/io/picture_file.h"
#include "core/math/stage_hash.h"
#include "core/params/param_def.h"
#include "core/surface/bark/bark_maps.h"
#include <filesystem>

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

} // namespace

std::string mapFileName(const BarkParams& bark, int size, MaterialMap map)
{
    const char* family = findParam("bark.family")->items[static_cast<std::size_t>(bark.family)].name;
    StageHash hash(barkVersion);
    hash.add(std::string_view(family)).add(bark.depth).add(bark.light).add(bark.moss).add(bark.seed);
    constexpr const char* digits = "0123456789abcdef";
    std::string number;
    for (int shift = 28; shift >= 0; shift -= 4)
        number += digits[(hash.value() >> shift) & 15u];
    return std::string("bark_")
        .append(family)
        .append("_")
        .append(number)
        .append("_")
        .append(std::to_string(size))
        .append("_")
        .append(mapNames[static_cast<std::size_t>(map)])
        .append(".png");
}

Expected<std::vector<std::string>> writeMaps(const std::string& folder, const BarkParams& bark, int size,
                                             const Progress& progress)
{
    const auto nameOf = [&](std::size_t map) {
        return mapFileName(bark, size, static_cast<MaterialMap>(map));
    };
    std::vector<std::size_t> missing;
    for (std::size_t map = 0; map < mapNames.size(); ++map) {
        std::error_code problem; // what cannot be looked at is told by whoever writes it
        if (!std::filesystem::exists(std::filesystem::path(folder) / nameOf(map), problem))
            missing.push_back(map);
    }
    std::vector<std::string> written;
    if (missing.empty())
        return written;
    const auto maps = barkMaps(bark, size, progress.part(0.0, 0.8));
    if (!maps)
        return fail(maps.error());
    for (const std::size_t map : missing) {
        const std::string path = (std::filesystem::path(folder) / nameOf(map)).string();
        if (const auto done = writePng(path, pictureOf(*maps, static_cast<MaterialMap>(map))); !done)
            return fail(done.error());
        written.push_back(nameOf(map));
    }
    return written;
}

} // namespace ramure
